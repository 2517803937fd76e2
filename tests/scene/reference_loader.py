#!/usr/bin/env python3
"""Hashes of GLB files' scenes by a second evaluator, which is the package `reference` beside this file.

    reference_loader.py [options] FILE.glb...     prints "name triangles hash" for each
      --scene N           scene of the file (default: the file's default)
      --time SECONDS      pose at a time; prints "name animation time triangles hash"
      --animation A       index or name (default: the first)
      --radius R          of points that have none of their own
Where there are spheres, their number stands behind the hash.
"""
import argparse
import pathlib
import sys

from reference import loader
from reference_hash import digest


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--scene", type=int)
    parser.add_argument("--time", type=float)
    parser.add_argument("--animation", default="")
    parser.add_argument("--radius", type=float)
    parser.add_argument("files", nargs="+", metavar="FILE.glb")
    return parser.parse_args()


def main():
    sys.setrecursionlimit(100000)  # the hierarchy may be deep
    options = arguments()
    pose = [] if options.time is None else [options.animation or "0", repr(options.time)]
    for path in options.files:
        scene = loader.load(path, options.scene, options.time, options.animation, options.radius)
        words = [pathlib.Path(path).stem, *pose, str(len(scene.flags)),
                 digest(scene.coordinates, scene.corners, scene.flags, scene.spheres)]
        print(*words, *([len(scene.spheres), "spheres"] if scene.spheres else []), flush=True)


if __name__ == "__main__":
    main()
