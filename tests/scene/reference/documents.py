"""Random GLB documents that use everything the evaluator knows, for comparing it with the library. Valid, but that
positions' bounds are left out."""
import json
import math
import random
import struct

from reference.binary import INTEGERS, Binary
from reference.nodes import from_trs

EXTENSIONS = ["KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "EXT_meshopt_compression"]


class GeneratedDocument:
    """A file, and a query to it. Where it is conformal there are only similarities, so that spheres stay spheres."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.conformal = self.rng.random() < 0.3
        self.binary = Binary(self.rng)
        self.targets = [self.rng.choice((0, 0, 1, 3)) for _ in range(3)]  # of each mesh; the last is skinned
        self.json = {"asset": {"version": "2.0"}, "extensionsUsed": EXTENSIONS, "extensionsRequired": EXTENSIONS}
        self.json["materials"] = [{"doubleSided": True}, {"alphaMode": "BLEND"}]
        self.json["meshes"] = [self.mesh(k, skinned=k == 2) for k in range(3)]
        self.make_nodes(self.rng.randint(3, 9))
        self.key_times = []
        self.json["animations"] = [self.animation(name) for name in ("first", "second")]

    def number(self):
        kind = self.rng.random()
        if kind < 0.2:
            return float(self.rng.randint(-3, 3))
        return self.rng.uniform(-2, 2) * (10.0 ** self.rng.randint(-12, 9) if kind > 0.95 else 1)

    def vector(self, size=3):
        return [self.number() for _ in range(size)]

    def rotation(self):
        q = [self.rng.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(x * x for x in q))
        if not self.conformal and self.rng.random() < 0.2:
            length *= self.rng.uniform(0.5, 2)
        return [x / length for x in q]

    def scale(self):
        return [self.rng.choice((-2.5, -1, 0.3, 1, 7))] * 3 if self.conformal else self.vector()

    def affine(self):
        """By columns, for files."""
        columns = [self.vector() for _ in range(4)]
        if self.conformal:
            columns = zip(*from_trs(self.vector(), self.rotation(), self.scale()))
        return [x for k, column in enumerate(columns) for x in (*column, float(k == 3))]

    def vectors(self, count):
        """Positions or displacements."""
        if self.rng.random() < 0.6:
            return self.binary.floats("VEC3", [self.vector() for _ in range(count)], may_be_padded=True)
        component, normalized = self.rng.choice(list(INTEGERS)), self.rng.random() < 0.5
        return self.binary.integers("VEC3", component, count, normalized, may_be_padded=True)

    def mesh(self, number, skinned):
        mesh = {"primitives": [self.primitive(self.targets[number], skinned) for _ in range(self.rng.randint(1, 3))]}
        if self.targets[number] and self.rng.random() < 0.5:
            mesh["weights"] = self.vector(self.targets[number])
        return mesh

    def primitive(self, targets, skinned):
        rng, count = self.rng, 3 * self.rng.randint(1, 6)
        attributes = {"POSITION": self.vectors(count)}
        primitive = {"attributes": attributes, "mode": rng.choice((0, 0, 1, 3, 4, 4, 4, 5, 6))}
        if self.conformal and rng.random() < 0.7:
            attributes["_RADIUS"] = self.binary.floats("SCALAR", [(rng.uniform(0, 3),) for _ in range(count)])
        if rng.random() < 0.5:
            component = rng.choice((5121, 5123, 5125))
            corners = [(rng.randrange(count),) for _ in range(3 * rng.randint(1, 9))]
            primitive["indices"] = self.binary.accessor("SCALAR", component, corners, indices=True)
        if rng.random() < 0.5:
            primitive["material"] = rng.randrange(2)
        if targets:
            primitive["targets"] = [{"POSITION": self.vectors(count)} if rng.random() < 0.8 else {}
                                    for _ in range(targets)]
        for k in range(rng.randint(1, 1 if self.conformal else 2) if skinned else 0):
            joints = [[rng.randrange(2) for _ in range(4)] for _ in range(count)]
            component = rng.choice((5121, 5123))
            attributes["JOINTS_%d" % k] = self.binary.accessor("VEC4", component, joints, may_be_padded=True)
            attributes["WEIGHTS_%d" % k] = self.weights(count)
        return primitive

    def weights(self, count):
        if self.conformal:  # a sum of two similarities is none
            return self.binary.floats("VEC4", [(0, self.rng.choice((0.5, 1)), 0, 0) for _ in range(count)])
        if self.rng.random() < 0.5:
            return self.binary.integers("VEC4", self.rng.choice((5121, 5123)), count, True, may_be_padded=True)
        rows = [[self.rng.choice((0, 1, self.rng.random())) for _ in range(4)] for _ in range(count)]
        return self.binary.floats("VEC4", rows, may_be_padded=True)

    def make_nodes(self, count):
        rng, nodes = self.rng, [self.node() for _ in range(count)]
        order = rng.sample(range(count), count)
        roots = [order[0]]
        for k in range(1, count):
            if rng.random() < 0.7:
                nodes[order[rng.randrange(k)]].setdefault("children", []).append(order[k])
            else:
                roots.append(order[k])
        self.json["nodes"] = nodes
        self.json["skins"] = [{"joints": rng.sample(range(count), 2)} for _ in range(2)]
        for skin in self.json["skins"]:
            if rng.random() < 0.8:
                skin["inverseBindMatrices"] = self.binary.floats("MAT4", [self.affine() for _ in range(2)])
        if rng.random() < 0.8:
            self.json["scenes"] = [{"nodes": rng.sample(roots, rng.randint(1, len(roots)))} for _ in range(2)]
            if rng.random() < 0.5:
                self.json["scene"] = rng.randrange(2)

    def node(self):
        rng, node = self.rng, {}
        if rng.random() < 0.3:
            node["matrix"] = self.affine()
        else:
            parts = {"translation": self.vector(), "rotation": self.rotation(), "scale": self.scale()}
            node.update((name, part) for name, part in parts.items() if rng.random() < 0.6)
        if rng.random() < 0.7:
            node["mesh"] = rng.randrange(3)
            targets = self.targets[node["mesh"]]
            if targets and rng.random() < 0.5:
                node["weights"] = [rng.choice((0, self.number())) for _ in range(targets)]
            if node["mesh"] == 2 and rng.random() < 0.8:
                node["skin"] = rng.randrange(2)
            elif rng.random() < 0.3:
                node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": self.instances(rng.randint(1, 4))}}
        return node

    def instances(self, count):
        attributes = {"TRANSLATION": lambda: self.binary.floats("VEC3", [self.vector() for _ in range(count)]),
                      "ROTATION": lambda: self.rotations(count),
                      "SCALE": lambda: self.binary.floats("VEC3", [self.scale() for _ in range(count)])}
        names = self.rng.sample(sorted(attributes), self.rng.randint(1, 3))
        return {name: attributes[name]() for name in names}

    def rotations(self, count):
        if not self.conformal and self.rng.random() < 0.4:
            return self.binary.integers("VEC4", self.rng.choice((5120, 5122)), count, True)
        rows = [self.rotation() for _ in range(count)]
        for k in range(1, count):  # some turn by nothing, or next to nothing, or by the longer way
            if not self.conformal and self.rng.random() < 0.4:
                away, side = self.rng.choice((0, 1e-6, 1e-3)), self.rng.choice((-1, 1))
                rows[k] = [side * (x + self.rng.gauss(0, away)) for x in rows[k - 1]]
        return self.binary.floats("VEC4", rows)

    def animation(self, name):
        rng, animation = self.rng, {"name": name, "samplers": [], "channels": []}
        for index, node in enumerate(self.json["nodes"]):
            paths = ["translation", "scale"] + ([] if self.conformal else ["rotation"])
            paths += ["weights"] if "mesh" in node and self.targets[node["mesh"]] else []
            for path in paths:
                if "matrix" not in node and rng.random() < 0.7:
                    target = {"node": index, "path": path}
                    animation["channels"].append({"sampler": len(animation["samplers"]), "target": target})
                    animation["samplers"].append(self.sampler(path, self.targets[node.get("mesh", 0)]))
        if not animation["channels"]:
            animation["samplers"].append(self.sampler("translation", 0))
            animation["channels"].append({"sampler": 0, "target": {"path": "translation"}})
        return animation

    def sampler(self, path, targets):
        rng = self.rng
        kind = rng.choice(("STEP", "CUBICSPLINE", "LINEAR", "LINEAR", *["LINEAR"] * (6 if path == "rotation" else 0)))
        times = sorted({rng.choice((rng.randint(0, 8) / 4, rng.uniform(0, 2))) for _ in range(rng.randint(1, 6))})
        if kind == "CUBICSPLINE" and len(times) < 2:
            times.append(3.0)
        count = len(times) * (3 if kind == "CUBICSPLINE" else 1)
        if path == "rotation":
            output = self.rotations(count)
        elif path == "weights":
            output = self.target_weights(count * targets)
        else:
            value = self.scale if path == "scale" else self.vector
            output = self.binary.floats("VEC3", [value() for _ in range(count)])
        times = [struct.unpack("<f", struct.pack("<f", t))[0] for t in times]
        self.key_times += times
        keys = self.binary.floats("SCALAR", [(t,) for t in times])
        self.binary.accessors[keys].update(min=[times[0]], max=[times[-1]])
        return {"input": keys, "output": output,
                **({} if kind == "LINEAR" and rng.random() < 0.5 else {"interpolation": kind})}

    def target_weights(self, count):
        if self.rng.random() < 0.5:
            return self.binary.integers("SCALAR", self.rng.choice(list(INTEGERS)), count, True)
        return self.binary.floats("SCALAR", [(self.number(),) for _ in range(count)])

    def glb(self):
        content = bytes(self.binary.bytes) + bytes(-len(self.binary.bytes) % 4)
        buffers = [{"byteLength": len(content)}]
        if self.binary.fallback:
            extensions = {"EXT_meshopt_compression": {"fallback": True}}
            buffers.append({"byteLength": self.binary.fallback, "extensions": extensions})
        self.json.update(buffers=buffers, bufferViews=self.binary.views, accessors=self.binary.accessors)
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(content), len(text), 0x4E4F534A) + text
                + struct.pack("<II", len(content), 0x004E4942) + content)

    def query(self):
        """Options of loading: {scene, time, animation, radius}, some of them absent."""
        rng, query = self.rng, {}
        if "scenes" in self.json and rng.random() < 0.5:
            query["scene"] = rng.randrange(2)
        if rng.random() < 0.8:
            key = rng.choice(self.key_times)
            query["time"] = rng.choice((rng.uniform(-0.5, 2.5), key, math.nextafter(key, 9), math.nextafter(key, -9)))
            if rng.random() < 0.7:
                query["animation"] = rng.choice(("0", "1", "first", "second"))
        if rng.random() < 0.4:
            query["radius"] = rng.uniform(0.1, 2)
        return query
