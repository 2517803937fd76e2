#!/usr/bin/env python3
"""Compares the hash that the program prints of generated documents with the one that the second evaluator computes.

    reference_agreement.py PROVIS     exit status 1 where one differs; its file is kept

4 percent of PROVIS_CASES (5000 where it is not set) documents; PROVIS_SEED replays one of them.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from reference import loader
from reference.documents import GeneratedDocument
from reference_hash import digest


def hash_by_program(provis, file, query):
    options = ["--%s=%s" % (name, value if isinstance(value, str) else repr(value)) for name, value in query.items()]
    done = subprocess.run([provis, "info", str(file), "--json", *options], capture_output=True, text=True, timeout=60)
    return json.loads(done.stdout)["scene"]["hash"] if done.returncode == 0 else done.stderr.strip()


def hash_by_evaluator(file, query):
    scene = loader.load(file, query.get("scene"), query.get("time"), query.get("animation", ""), query.get("radius"))
    return digest(scene.coordinates, scene.corners, scene.flags, scene.spheres), scene


def seeds():
    if "PROVIS_SEED" in os.environ:
        return [int(os.environ["PROVIS_SEED"])]
    return range(max(1, int(os.environ.get("PROVIS_CASES", 5000)) * 4 // 100))


def main():
    provis = sys.argv[1]
    folder = pathlib.Path(tempfile.mkdtemp(prefix="provis-agreement-"))
    seen, differing = {"triangles": 0, "spheres": 0, "empty": 0}, 0
    for seed in seeds():
        file = folder / ("%d.glb" % seed)
        document = GeneratedDocument(seed)
        file.write_bytes(document.glb())
        query = document.query()
        expected, scene = hash_by_evaluator(file, query)
        actual = hash_by_program(provis, file, query)
        seen["triangles"] += len(scene.flags)
        seen["spheres"] += len(scene.spheres)
        seen["empty"] += not scene.flags and not scene.spheres
        if actual == expected:
            file.unlink()
        else:
            differing += 1
            print("seed %d: %s: %s\n  evaluator %s\n  program   %s" % (seed, file, query, expected, actual))
    print("%d documents, %s; %d differ" % (len(seeds()), seen, differing))
    if not differing:
        shutil.rmtree(folder)
    sys.exit(differing != 0)


if __name__ == "__main__":
    main()
