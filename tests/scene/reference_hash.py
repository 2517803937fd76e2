#!/usr/bin/env python3
"""The scene hash of semantics.md, written down a second time, for one fixed scene.

Shares no code with the library: struct packs the bytes, hashlib digests them. The scene is the one of
fixed_scene.hpp, and the digest stands in fixed_scene.sha256, against which the C++ test compares too.

    reference_hash.py           prints the digest
    reference_hash.py FILE      compares it with the file's content; exit status 1 if they differ
"""
import hashlib
import struct
import sys
from array import array

VERTICES = [(0.0, 0.0, 0.0), (1.0, -0.0, 0.0), (0.1, 1e300, -2.5), (5e-324, -1e-310, 3.0)]
TRIANGLES = [((0, 1, 2), 0), ((1, 3, 2), 1), ((3, 3, 0), 3)]
SPHERES = [((1.5, -0.0, 0.3), 0.25, 1), ((-7.0, 2.0, 1.0), 0.0, 2)]


def plus_zero(x):
    return 0.0 if x == 0 else x


def little_endian(letter, numbers):
    packed = array(letter, numbers)
    if sys.byteorder == "big":
        packed.byteswap()
    return packed.tobytes()


def digest(coordinates, corners, flags, spheres):
    """Three coordinates for each vertex, three corners and one flag for each triangle; spheres as in SPHERES."""
    h = hashlib.sha256(b"provis-scene-1\0")
    h.update(struct.pack("<QQQ", len(coordinates) // 3, len(flags), len(spheres)))
    h.update(little_endian("d", map(plus_zero, coordinates)))
    h.update(little_endian("I", corners))
    h.update(bytes(flags))
    for center, radius, sphere_flags in spheres:
        h.update(struct.pack("<4dB", *map(plus_zero, (*center, radius)), sphere_flags))
    return h.hexdigest()


def main():
    actual = digest([x for vertex in VERTICES for x in vertex], [i for corners, _ in TRIANGLES for i in corners],
                    [flags for _, flags in TRIANGLES], SPHERES)
    print(actual)
    if len(sys.argv) > 1:
        with open(sys.argv[1], encoding="ascii") as file:
            sys.exit(file.read().strip() != actual)


if __name__ == "__main__":
    main()
