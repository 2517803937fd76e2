#!/usr/bin/env python3
"""Writes small files to begin fuzzing with: one for each thing that a format can say.

    make_seeds.py FOLDER        fills FOLDER/scene and FOLDER/result
"""
import base64
import json
import pathlib
import struct
import sys

PREDICATES = ["facing", "front", "turn", "turn_constructed", "nearer", "nearer_constructed", "coplanar"]
TIERS = ["structure", "filter", "interval", "mpfr", "exact"]
COMPONENT = {"b": 5120, "B": 5121, "h": 5122, "H": 5123, "I": 5125, "f": 5126}
SIZE = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}
CORNERS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]
FACES = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class Gltf:
    """A document with one tetrahedron, and a buffer that grows."""

    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                     "bufferViews": [], "accessors": []}
        attributes = {"POSITION": self.accessor("VEC3", "f", CORNERS)}
        self.primitive = {"attributes": attributes, "indices": self.accessor("SCALAR", "B", FACES)}
        self.json["meshes"] = [{"primitives": [self.primitive]}]

    def view(self, letter, values, **more):
        self.binary += b"\0" * (-len(self.binary) % 4)
        data = struct.pack(f"<{len(values)}{letter}", *values)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), **more})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, kind, letter, values, **more):
        self.json["accessors"].append({"bufferView": self.view(letter, values), "componentType": COMPONENT[letter],
                                       "count": len(values) // SIZE[kind], "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def animate(self, *channels):
        """channels: (path, interpolation, key times, kind, values)"""
        animation = {"name": "walk", "channels": [], "samplers": []}
        for path, interpolation, times, kind, values in channels:
            animation["channels"].append({"sampler": len(animation["samplers"]), "target": {"node": 0, "path": path}})
            animation["samplers"].append({"input": self.accessor("SCALAR", "f", times),
                                          "output": self.accessor(kind, "f", values), "interpolation": interpolation})
        self.json.setdefault("animations", []).append(animation)

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        return json.dumps({**self.json, "buffers": [{"byteLength": len(self.binary), "uri": uri}]}).encode()

    def glb(self):
        binary = self.binary + b"\0" * (-len(self.binary) % 4)
        text = json.dumps({**self.json, "buffers": [{"byteLength": len(self.binary)}]}).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)) + struct.pack("<I4s", len(text), b"JSON") +
                text + struct.pack("<I4s", len(binary), b"BIN\0") + binary)


def gltf_files():
    plain = Gltf()
    yield "plain.gltf", plain.text()
    yield "plain.glb", plain.glb()

    g = Gltf()
    g.primitive["mode"] = 5
    g.json["meshes"][0]["primitives"] += [{**g.primitive, "mode": 6}, {**g.primitive, "mode": 1}]
    yield "modes.glb", g.glb()

    g = Gltf()
    g.json["nodes"] = [{"children": [1], "rotation": [0, 0.6, 0, 0.8], "scale": [1, 2, -1]},
                       {"mesh": 0, "matrix": IDENTITY, "name": "leaf"}]
    g.json["materials"] = [{"doubleSided": True, "alphaMode": "BLEND",
                            "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}}}]
    g.primitive["material"] = 0
    yield "nodes.glb", g.glb()

    g = Gltf()
    g.json["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": g.view("H", [0, 3]), "componentType": 5123},
                                        "values": {"bufferView": g.view("f", [5, 5, 5, 6, 6, 6])}}
    yield "sparse.glb", g.glb()

    g = Gltf()
    g.primitive["attributes"]["POSITION"] = g.accessor("VEC3", "h", [327 * x for x in CORNERS], normalized=True)
    g.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    yield "quantised.glb", g.glb()

    g = Gltf()
    g.primitive["targets"] = [{"POSITION": g.accessor("VEC3", "f", [0.5] * 12)}]
    g.json["meshes"][0]["weights"] = [0.25]
    g.animate(("weights", "LINEAR", [0, 1], "SCALAR", [0, 1]))
    yield "morph.glb", g.glb()

    g = Gltf()
    g.json["nodes"] = [{"mesh": 0, "skin": 0}, {"translation": [1, 0, 0], "children": [2]}, {"scale": [2, 2, 2]}]
    g.json["scenes"] = [{"nodes": [0, 1]}]
    g.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": g.accessor("MAT4", "f", IDENTITY * 2)}]
    g.primitive["attributes"]["JOINTS_0"] = g.accessor("VEC4", "B", [0, 1, 0, 0] * 4)
    g.primitive["attributes"]["WEIGHTS_0"] = g.accessor("VEC4", "f", [0.25, 0.75, 0, 0] * 4)
    yield "skin.glb", g.glb()

    g = Gltf()
    g.animate(("translation", "STEP", [0, 1, 2], "VEC3", list(range(9))),
              ("rotation", "LINEAR", [0, 1], "VEC4", [0, 0, 0, 1, 0, 0.6, 0, 0.8]),
              ("scale", "CUBICSPLINE", [0, 2], "VEC3", [1] * 18))
    yield "animation.glb", g.glb()

    g = Gltf()
    g.json["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {
        "TRANSLATION": g.accessor("VEC3", "f", [0, 0, 0, 3, 0, 0]),
        "ROTATION": g.accessor("VEC4", "b", [0, 0, 0, 127, 0, 127, 0, 0], normalized=True),
        "SCALE": g.accessor("VEC3", "f", [1, 1, 1, -2, 2, 2])}}}
    g.json["extensionsUsed"] = g.json["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
    yield "instances.glb", g.glb()

    g = Gltf()
    g.primitive = g.json["meshes"][0]["primitives"][0] = {
        "mode": 0, "attributes": {"POSITION": 0, "_RADIUS": g.accessor("SCALAR", "f", [0.5, 1, 0, 2])}}
    yield "points.glb", g.glb()


PLY_TEXT = b"""ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
property uchar flags
element sphere 1
property double x
property double y
property double z
property double radius
property float vx
property float vy
property float vz
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2 1
4 0 1 2 3 0
1 2 3 0.5 1 0 0
"""


def ply_files():
    yield "text.ply", PLY_TEXT
    for name, order in (("little", "<"), ("big", ">")):
        header = PLY_TEXT[:PLY_TEXT.index(b"end_header\n") + 11].replace(b"ascii", f"binary_{name}_endian".encode())
        body = struct.pack(order + "12f", *CORNERS) + struct.pack(order + "B3iB", 3, 0, 1, 2, 0)
        body += struct.pack(order + "B4iB", 4, 0, 1, 2, 3, 1) + struct.pack(order + "4d3f", 1, 2, 3, 0.5, 1, 0, 0)
        yield f"{name}.ply", header + body
    yield "points.ply", (b"ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                         b"property double z\nproperty float radius\nend_header\n0 0 0 1\n1 1 1 0.5\n")


def result_files():
    frame = {"right": [1, 0, 0], "up": [0, 1, 0], "forward": [0, 0, -1], "window": [-1, 1, -0.5, 0.5]}
    query = {"kind": "point", "projection": "pinhole", "eye": [0.1, 2, -3e-5], **frame, "arithmetic": "chain",
             "method": "exact", "opacity": "material", "perturb": "0", "seed": "0", "sides": "material"}
    result = {"format": "provis.visible-set", "version": 1, "program": {"name": "provis", "version": "0.1.0"},
              "scene": {"file": "a.glb", "hash": "0" * 64, "triangles": 4, "spheres": 0}, "query": query,
              "answers": "R7", "guarantee": "exact", "counts": {"visible": 2, "hidden": 2, "undecided": 0},
              "eye_on_primitive": False, "visible": [0, 3], "undecided": [],
              "stats": {"seconds": 0.5, "cpu_seconds": 0.75, "threads": 2, "nodes": 3, "leaves": 2, "samples": 1,
                        "subtractions": 0, "signs": {p: dict.fromkeys(TIERS, 1) for p in PREDICATES}}}
    yield "plain.json", json.dumps(result).encode()
    witness = {"id": 0, "origin": [["1", 0], ["-3", -2], ["5", 1]], "direction": [["0", 0], ["1", -60], ["-1", 0]]}
    cell = {"frame": 0, "corners": [[0, 0], [1, 0], [0, 0.5]], "area": "1/4", "area_rounded": 0.25, "visible": [0, 3]}
    yield "full.json", json.dumps({**result, "witnesses": [witness, {**witness, "id": 3}], "subdivision": [cell]}).encode()
    omni = {**query, "projection": "omni", "frames": [frame] * 6}
    for member in frame:
        del omni[member]
    yield "omni.json", json.dumps({**result, "query": omni}).encode()


def main():
    target = pathlib.Path(sys.argv[1])
    for folder, files in (("scene", [*gltf_files(), *ply_files()]), ("result", result_files())):
        (target / folder).mkdir(parents=True, exist_ok=True)
        for name, data in files:
            (target / folder / name).write_bytes(data)


main()
