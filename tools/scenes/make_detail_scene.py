#!/usr/bin/env python3
"""Writes data/detail, an example of a level of detail: a street of houses with gardens behind them.

Usage: make_detail_scene.py FOLDER

street.ply   the scene: houses with bays, sills and roofs, and cypresses of cones
inner.ply    occluders: a box inside of each house
outer.ply    shells: a box around each house and each cypress
objects.json which triangles of the three are one object; the ground is no object's

Metres, y up; coordinates are multiples of 1/1024, as in make_demo_scene.py.
"""
import json
import pathlib
import sys

from make_demo_scene import Mesh, cypress, write_ply

HOUSES, WIDTH, DEPTH, HEIGHT = 8, 7.0, 9.0, 6.0
STREET = 4.0  # from its middle to a front


def house(mesh, x, side):
    """A body, bays with sills that stand out of its front, and a roof; each part is closed."""
    def box(x0, x1, y0, y1, w0, w1):
        z = sorted((side * (STREET + w0), side * (STREET + w1)))
        mesh.box(x0, x1, y0, y1, z[0], z[1])

    box(x, x + WIDTH, 0, HEIGHT, 0, DEPTH)
    for floor in (0.9, 3.7):
        for bay in range(3):
            u = x + 0.75 + 2 * bay
            box(u, u + 1.5, floor, floor + 1.6, -0.4, 0.1)
            box(u - 0.1, u + 1.6, floor - 0.1, floor, -0.5, 0)
    eaves, ridge = HEIGHT, HEIGHT + 2.5
    z0, z1 = sorted((side * (STREET - 0.3), side * (STREET + DEPTH + 0.3)))
    near = [mesh.vertex(x, y, z) for y, z in ((eaves, z0), (eaves, z1), (ridge, (z0 + z1) / 2))]
    far = [mesh.vertex(x + WIDTH, y, z) for y, z in ((eaves, z0), (eaves, z1), (ridge, (z0 + z1) / 2))]
    mesh.face(*near)
    mesh.face(*reversed(far))
    for a, b in ((0, 1), (1, 2), (2, 0)):
        mesh.face(near[b], near[a], far[a], far[b])


def around(mesh, vertices):
    """The box around some vertices."""
    lower, upper = [min(c) for c in zip(*vertices)], [max(c) for c in zip(*vertices)]
    mesh.box(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2])


def street():
    full, inner, outer, objects = Mesh(), Mesh(), Mesh(), []

    def add(name, build, occluder=None):
        first = {m: len(m.triangles) for m in (full, inner, outer)}
        begin = len(full.vertices)
        build()
        around(outer, full.vertices[begin:])
        entry = {"name": name, "full": [[first[full], len(full.triangles) - 1]],
                 "shell": [[first[outer], len(outer.triangles) - 1]]}
        if occluder:
            inner.box(*occluder)
            entry["occluders"] = [[first[inner], len(inner.triangles) - 1]]
        objects.append(entry)

    for side, name in ((-1, "north"), (1, "south")):
        for k in range(HOUSES):
            x = (k - HOUSES / 2) * (WIDTH + 0.5)  # half a metre between neighbours
            z = sorted((side * STREET, side * (STREET + DEPTH)))
            add(f"{name} house {k}", lambda: house(full, x, side), (x, x + WIDTH, 0, HEIGHT, *z))
            for j in range(4):
                u, w = x + 1 + 1.75 * j, side * (STREET + DEPTH + 3 + 2 * ((k + j) % 3))
                add(f"{name} cypress {k}.{j}", lambda: cypress(full, u, w, 3.0 + 0.5 * ((3 * k + j) % 4)))
    full.polygon((-40, 0, -25), (-40, 0, 25), (40, 0, 25), (40, 0, -25))
    return full, inner, outer, objects


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.strip())
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    full, inner, outer, objects = street()
    for mesh, name in ((full, "street"), (inner, "inner"), (outer, "outer")):
        with open(folder / f"{name}.ply", "w", newline="\n", encoding="ascii") as out:
            write_ply(mesh, out, f"{name}, metres, y up; made by tools/scenes/make_detail_scene.py")
    lines = ",\n  ".join(json.dumps(entry) for entry in objects)
    with open(folder / "objects.json", "w", newline="\n", encoding="ascii") as out:
        out.write(f'{{"format": "provis.objects", "version": 1, "objects": [\n  {lines}\n]}}\n')


if __name__ == "__main__":
    main()
