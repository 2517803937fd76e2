"""What is measured: scenes, their views, and configurations."""
import fnmatch
import json
import os
import pathlib
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIEWS = ROOT / "data" / "bench-views.json"
SIZES = {"20k": 20_000, "1M": 1_000_000, "5M": 5_000_000, "50M": 50_000_000}


@dataclass(frozen=True)
class Configuration:
    """One measured program with its options; point holds those that `provis point` has, too."""
    name: str
    program: str
    threads: int = 1
    point: tuple = ()
    most_triangles: float = float("inf")

    def label(self):
        return f"{self.name} x{self.threads}"


@dataclass
class Subject:
    """A scene seen by one view."""
    scene: str
    view: str
    path: pathlib.Path = None
    triangles: int = 0  # as soon as something was measured


REFERENCE = Configuration("exact", "bench_point", 2)


def configurations():
    """REFERENCE, the exact set that the others are held against, comes first."""
    point = {"exact": (), "exact doubles": ("--arithmetic", "doubles"),
             "aggressive": ("--method", "aggressive"),
             "aggressive doubles": ("--method", "aggressive", "--arithmetic", "doubles"),
             "paper": ("--method", "exact", "--engine", "paper"),
             "paper doubles": ("--method", "exact", "--engine", "paper", "--arithmetic", "doubles")}
    found = [REFERENCE, Configuration("z-buffer", "bench_zbuffer")]
    for name, options in point.items():
        found += [Configuration(name, "bench_point", threads, options) for threads in (1, 2)]
    found.append(Configuration("Embree", "bench_embree", 1))
    found.append(Configuration("Envelope_3", "envelope_child", 1, most_triangles=50_000))
    return list(dict.fromkeys(found))


def generated_name(scene):
    """make_scene's arguments for a scene called KIND-SIZE[-rotated].ply, or None for any other."""
    words = scene.removesuffix(".ply").split("-")
    if not scene.endswith(".ply") or len(words) < 2 or words[1] not in SIZES:
        return None
    return [words[0], "--triangles", str(SIZES[words[1]])] + (["--rotate"] if words[2:] == ["rotated"] else [])


def fits(names, patterns):
    return any(fnmatch.fnmatch(name, pattern) for pattern in patterns.split(",") for name in names)


def subjects(scene_patterns, view_patterns):
    """Of data/bench-views.json, in its order; a pattern is the file's name with or without its ending."""
    entries = json.loads(VIEWS.read_text())["views"]
    return [Subject(e["scene"], e["name"]) for e in entries
            if fits((e["scene"], pathlib.Path(e["scene"]).stem), scene_patterns) and fits((e["name"],), view_patterns)]


def shared_folder():
    return pathlib.Path(os.environ.get("PROVIS_SHARED", ROOT.parent / "shared"))
