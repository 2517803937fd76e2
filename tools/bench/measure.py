"""Runs one configuration in a process of its own, and makes a row of what it says."""
import json
import os
import pathlib
import resource
import signal
import statistics
import subprocess
import tempfile
import time

import plan


class Unavailable(Exception):
    """Why a configuration has no figures."""


def at_most(seconds):
    """For a process that is started: the system ends it after so many CPU seconds, however busy the machine is."""
    return lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 5))


def ended(status, limit, said=""):
    """Why a process ended."""
    if status == -signal.SIGXCPU:
        return f"over {limit:.0f} s of CPU"
    if status < 0:
        return signal.Signals(-status).name
    return (said.strip().splitlines() or [f"exit status {status}"])[-1]


class Bench:
    """A build folder, and the limits that every child is given."""

    def __init__(self, build, runs, budget, limit, scratch):
        self.build, self.runs, self.budget, self.limit = pathlib.Path(build), runs, budget, limit
        self.scratch = pathlib.Path(scratch)
        self.reference = self.scratch / "reference"  # the ids of the exact set, for the shares
        self.refusals = {}

    def program(self, name):
        for folder in ("bin", "tools/bench", "tools/scenes", "tests/support"):
            if (self.build / folder / name).exists():
                return str(self.build / folder / name)
        raise Unavailable(f"{name} is not built")

    def call(self, *command, limit=None):
        """What it prints; anything but success is Unavailable."""
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=at_most(limit or self.limit))
        if done.returncode:
            raise Unavailable(ended(done.returncode, limit or self.limit, done.stderr))
        return done.stdout

    def scene_file(self, scene, generated):
        """Its path; a generated scene is written if it is not there yet."""
        for folder in (generated, plan.shared_folder() / "scenes", plan.ROOT / "data" / "demo"):
            if (folder / scene).exists():
                return folder / scene
        arguments = plan.generated_name(scene)
        if arguments is None:
            raise Unavailable("the scene is absent")
        generated.mkdir(parents=True, exist_ok=True)
        self.call(self.program("make_scene"), *arguments, str(generated / scene))
        return generated / scene

    def refuse_unknown(self, options):
        """The program is asked on a small scene whether it knows the options: it refuses what it does not have."""
        if options and options not in self.refusals:
            try:
                self.call(self.program("provis"), "point", str(plan.ROOT / "data/demo/courtyard.ply"),
                          "--eye=-5.5,1.7,7.5", "--dir=0.65,0.03,-1", *options, limit=600)
                self.refusals[options] = None
            except Unavailable as reason:
                self.refusals[options] = f"refused: {reason}"
        if self.refusals.get(options):
            raise Unavailable(self.refusals[options])

    def child(self, subject, program, *options):
        return json.loads(self.call(
            self.program(program), str(subject.path), f"{plan.VIEWS}:{subject.view}",
            "--runs", str(self.runs), "--budget", str(self.budget), *options))

    def begin(self, subject):
        """Nothing is known of a subject before plan.REFERENCE was measured on it."""
        self.reference.unlink(missing_ok=True)

    def rows(self, subject, configuration):
        """One row; of Embree one for its tree, and one for each number of rays."""
        head = {"scene": subject.scene, "view": subject.view, "configuration": configuration.name,
                "threads": configuration.threads}
        try:
            self.refuse_unknown(configuration.point)
            if configuration.program == "envelope_child":
                return [{**head, **self.envelope(subject)}]
            options = ["--threads", str(configuration.threads), *configuration.point]
            if configuration.program == "bench_zbuffer":
                options = []
            if configuration == plan.REFERENCE:
                options += ["--write-reference", str(self.reference)]
            elif self.reference.exists():
                options += ["--reference", str(self.reference)]
            said = self.child(subject, configuration.program, *options)
        except Unavailable as reason:
            return [{**head, "unavailable": str(reason)}]
        samples = said.pop("samples", None)
        if samples is None:
            return [{**head, **figures(said)}]
        whole = {key: said[key] for key in ("triangles", "scene_bytes")}
        rows = [{**head, "configuration": f"{configuration.name} build", **figures(said)}]
        return rows + [{**head, "configuration": f"{configuration.name} {s.pop('per_pixel')} rays",
                        **figures({**s, **whole})} for s in samples]

    def envelope(self, subject):
        """CGAL's child reads a text; its processor time is that of the whole process, once."""
        text = self.scratch / "case"
        said = self.child(subject, "bench_case", "--out", str(text))
        with text.open() as given, tempfile.TemporaryFile("w+") as answer:
            began = time.monotonic()
            process = subprocess.Popen([self.program("envelope_child"), str(said["triangles"])], stdin=given,
                                       stdout=answer, stderr=subprocess.DEVNULL, preexec_fn=at_most(self.budget))
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode:
                raise Unavailable(ended(process.returncode, self.budget))
            answer.seek(0)
            words = answer.read().split()
        if not words or words[0] != "answered":
            raise Unavailable(" ".join(words[:8]))
        ids = {int(word) for word in words[1:-1]}
        exact = memoryview(self.reference.read_bytes()).cast("I") if self.reference.exists() else []
        common = len(ids.intersection(exact))
        return figures({**said, "cpu": [used.ru_utime + used.ru_stime], "wall": [time.monotonic() - began],
                        "peak_bytes": used.ru_maxrss * 1024, "extra_bytes": used.ru_maxrss * 1024,
                        "visible": len(ids), "wrong": len(ids) - common,
                        "share": common / len(exact) if len(exact) else 1.0})


def figures(said):
    """Medians beside the single runs."""
    if "unavailable" in said:
        return said
    said["runs"] = {"cpu": said.pop("cpu"), "wall": said.pop("wall")}
    for key, values in said["runs"].items():
        said[key] = statistics.median(values)
    said["extra_bytes_per_triangle"] = said["extra_bytes"] / max(1, said["triangles"])
    return said
