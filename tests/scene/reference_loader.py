#!/usr/bin/env python3
"""A second GLB loader, slow and plain, for the hashes in real_scenes.txt.

Shares no code with the library: Python's floats are float64, and its products and sums are rounded one by
one, in the order that src/scene/README.md states. It trusts its input, and knows neither skins, morph
targets, instancing nor compression.

    reference_loader.py FILE.glb...     prints "name triangles hash" for each
"""
import json
import pathlib
import struct
import sys
from fractions import Fraction

from reference_hash import digest

COMPONENTS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535),
              5125: ("I", 2**32 - 1), 5126: ("f", None)}
COUNTS = {"SCALAR": 1, "VEC3": 3}
IDENTITY = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]


class Glb:
    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + size])
        self.binary = data[28 + size:]

    def elements(self, view, offset, count, layout, tight):
        view = self.json["bufferViews"][view]
        start = view.get("byteOffset", 0) + offset
        stride = struct.calcsize(layout) if tight else view.get("byteStride", struct.calcsize(layout))
        return [struct.unpack_from(layout, self.binary, start + i * stride) for i in range(count)]

    def accessor(self, index):
        a = self.json["accessors"][index]
        letter, largest = COMPONENTS[a["componentType"]]
        layout = "<" + letter * COUNTS[a["type"]]
        if "bufferView" in a:
            values = self.elements(a["bufferView"], a.get("byteOffset", 0), a["count"], layout, False)
        else:
            values = [(0,) * COUNTS[a["type"]]] * a["count"]
        if "sparse" in a:
            s, at = a["sparse"], a["sparse"]["indices"]
            targets = self.elements(at["bufferView"], at.get("byteOffset", 0), s["count"],
                                    "<" + COMPONENTS[at["componentType"]][0], True)
            new = self.elements(s["values"]["bufferView"], s["values"].get("byteOffset", 0), s["count"], layout, True)
            for (target,), value in zip(targets, new):
                values[target] = value
        if a.get("normalized") and largest:
            values = [tuple(max(x / largest, -1.0) for x in value) for value in values]
        return values


def local_matrix(node):
    if "matrix" in node:
        return [[float(node["matrix"][4 * column + row]) for column in range(4)] for row in range(3)]
    x, y, z, w = map(float, node.get("rotation", (0, 0, 0, 1)))
    rotation = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    scale, move = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    return [[rotation[r][c] * scale[c] for c in range(3)] + [float(move[r])] for r in range(3)]


def product(p, m):
    return [[((p[r][0] * m[0][c] + p[r][1] * m[1][c]) + p[r][2] * m[2][c]) + (p[r][3] if c == 3 else 0.0)
             for c in range(4)] for r in range(3)]


def is_mirrored(m):
    a, b, c = ([Fraction(x) for x in row[:3]] for row in m)
    cross = (b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0])
    return sum(x * y for x, y in zip(a, cross)) < 0


def corner_triples(mode, v):
    if mode == 4:
        return [v[i:i + 3] for i in range(0, len(v), 3)]
    if mode == 5:
        return [(v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]) for i in range(len(v) - 2)]
    return [(v[i + 1], v[i + 2], v[0]) for i in range(len(v) - 2)]


def material_flags(material):
    transmission = material.get("extensions", {}).get("KHR_materials_transmission", {})
    lets_light_through = material.get("alphaMode", "OPAQUE") != "OPAQUE" or transmission.get("transmissionFactor", 0) != 0
    return (0 if material.get("doubleSided", False) else 1) | (2 if lets_light_through else 0)


def load(path):
    glb = Glb(path)
    vertices, triangles = [], []

    def add_primitive(primitive, world):
        mode = primitive.get("mode", 4)
        if mode < 4:
            return
        positions = glb.accessor(primitive["attributes"]["POSITION"])
        corners = list(range(len(positions)))
        if "indices" in primitive:
            corners = [i for (i,) in glb.accessor(primitive["indices"])]
        flags = material_flags(glb.json["materials"][primitive["material"]] if "material" in primitive else {})
        first, mirrored = len(vertices), is_mirrored(world)
        for a, b, c in corner_triples(mode, corners):
            triangles.append(((first + a, first + c, first + b) if mirrored else (first + a, first + b, first + c), flags))
        for x, y, z in positions:
            vertices.append(tuple(((row[0] * x + row[1] * y) + row[2] * z) + row[3] for row in world))

    def visit(index, parent):
        node = glb.json["nodes"][index]
        world = product(parent, local_matrix(node))
        if "mesh" in node:
            for primitive in glb.json["meshes"][node["mesh"]]["primitives"]:
                add_primitive(primitive, world)
        for child in node.get("children", []):
            visit(child, world)

    for root in glb.json["scenes"][glb.json.get("scene", 0)]["nodes"]:
        visit(root, IDENTITY)
    return vertices, triangles


def main():
    for path in sys.argv[1:]:
        vertices, triangles = load(path)
        print(pathlib.Path(path).stem, len(triangles), digest(vertices, triangles, []))


if __name__ == "__main__":
    main()
