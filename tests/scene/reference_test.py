#!/usr/bin/env python3
"""Tests of the second evaluator by numbers that were worked out by hand."""
import json
import math
import pathlib
import random
import struct
import tempfile
import unittest
from fractions import Fraction

from reference import deform, loader, meshopt, meshopt_encoder, nodes
from reference.animation import interpolate
from reference.slerp import factors, slerp

ROOT_OF_HALF = math.sqrt(0.5)


class SlerpTest(unittest.TestCase):
    def test_factors_that_are_algebraic_numbers(self):
        # Halfway both factors are 1 / (2 cos(a/2)), and 4 cos(a/2)^2 = 2 + 2c.
        self.assertEqual(factors(0.125, 0.5), (2 / 3, 2 / 3))
        self.assertEqual(factors(17 / 32, 0.5), (4 / 7, 4 / 7))
        self.assertEqual(factors(0.0, 0.5), (ROOT_OF_HALF, ROOT_OF_HALF))
        for c in (0.1, 0.3, 0.5, 0.75, 0.999):
            self.assertEqual(factors(c, 0.5)[0], nearest_root(1 / (2 + 2 * Fraction(c))))
        # A quarter of the right angle: 4 sin(22.5 degrees)^2 = 2 - sqrt 2.
        self.assertEqual(factors(0.0, 0.25)[1], nearest_root((2 - root(Fraction(2))) / 4))

    def test_small_angles_follow_the_series(self):
        # sin(ta)/sin(a) = t (1 + (1 - t^2) a^2/6 + ...), a^2 = 2(1 - c) + ...: the rest is far below half an ulp.
        for steps in (1, 2, 5, 100):
            c = 1 - steps * 2.0**-53
            for u in (0.1, 0.3, 0.77):
                expected = [float(t + t * (1 - t * t) * (1 - Fraction(c)) / 3) for t in (1 - Fraction(u), Fraction(u))]
                self.assertEqual(factors(c, u), tuple(expected))

    def test_shorter_way(self):
        q0, q1 = (0.0, 0.0, 0.0, 1.0), (1.0, 0.0, 0.0, 0.0)
        self.assertEqual(slerp(q0, q1, 0.5), (ROOT_OF_HALF, 0, 0, ROOT_OF_HALF))
        close = (0.6, 0.0, 0.0, 0.8)
        opposite = tuple(-x for x in close)
        self.assertEqual(slerp(q0, close, 0.3), slerp(q0, opposite, 0.3))
        self.assertEqual(slerp(q0, tuple(-x for x in q0), 0.3), q0)  # |c| = 1: linear

    def test_long_quaternions_are_linear(self):
        self.assertEqual(slerp((0.0, 0.0, 0.0, 2.0), (2.0, 0.0, 0.0, 2.0), 0.25), (0.5, 0.0, 0.0, 2.0))


def root(square):
    """The square root, rounded down to a multiple of 2^-300."""
    return Fraction(math.isqrt(int(square * 2**600)), 2**300)


def nearest_root(square):
    return float(root(square))


class SamplerTest(unittest.TestCase):
    times = [1.0, 2.0, 4.0]

    def test_ends_and_keys(self):
        values = [(5.0,) * 3, (7.0,) * 3, (9.0,) * 3]
        for kind in ("STEP", "LINEAR"):
            at = [interpolate(kind, "scale", self.times, values, t)[0] for t in (-8.0, 1.0, 2.0, 4.0, 5.0)]
            self.assertEqual(at, [5, 5, 7, 9, 9])
        self.assertEqual(interpolate("STEP", "scale", self.times, values, 3.9), (7.0,) * 3)
        self.assertEqual(interpolate("LINEAR", "scale", self.times, values, 3.5), (8.5,) * 3)

    def test_cubic_spline(self):
        a, v, b = (100.0,) * 3, [(1.0,) * 3, (3.0,) * 3, (10.0,) * 3], (8.0,) * 3
        values = [x for value in v for x in (a, value, b)]
        for t, value in zip(self.times, v):
            self.assertEqual(interpolate("CUBICSPLINE", "translation", self.times, values, t), value)
        # u = 1/2, d = 2: v0/2 + d/8 b0 + v1/2 - d/8 a1
        self.assertEqual(interpolate("CUBICSPLINE", "translation", self.times, values, 3.0), (6.5 + 2 - 25,) * 3)

    def test_rotations_have_length_one_between_keys_only(self):
        zero, q0, q1 = (0.0,) * 4, (0.0, 0.0, 0.0, 4.0), (3.0, 0.0, 0.0, 4.0)
        values = [zero, q0, zero, zero, q1, zero]
        self.assertEqual(interpolate("CUBICSPLINE", "rotation", [0.0, 1.0], values, 0.0), q0)
        x, _, _, w = interpolate("CUBICSPLINE", "rotation", [0.0, 1.0], values, 0.5)
        self.assertEqual((x, w), (1.5 / math.sqrt(18.25), 4 / math.sqrt(18.25)))

    def test_weights_of_several_targets(self):
        linear = [(x,) for x in (0.0, 1.0, 1.0, 3.0)]
        self.assertEqual(interpolate("LINEAR", "weights", [0.0, 1.0], linear, 0.5), (0.5, 2.0))
        spline = [(x,) for x in (9.0, 9.0, 0.0, 1.0, 8.0, 0.0, 0.0, -8.0, 1.0, 3.0, 9.0, 9.0)]
        self.assertEqual(interpolate("CUBICSPLINE", "weights", [0.0, 1.0], spline, 0.5), (0.5 + 1, 2.0 + 1))


class MatrixTest(unittest.TestCase):
    def test_quarter_turn(self):
        m = nodes.from_trs((1, 2, 3), (0, 0, 0.5, 0.5), (2, 1, 1))  # as stored: half of a unit quaternion
        self.assertEqual(m, [[1.0, -0.5, 0, 1], [1.0, 0.5, 0, 2], [0, 0, 1, 3]])

    def test_sign_of_a_tiny_determinant(self):
        m = [[1.0, 1.0, 0, 0], [1.0, 1 - 2.0**-53, 0, 0], [0, 0, 1e-300, 0]]
        self.assertTrue(nodes.is_mirrored(m))
        self.assertFalse(nodes.is_mirrored([m[1], m[0], m[2]]))
        self.assertFalse(nodes.is_mirrored([m[0], m[0], m[2]]))

    def test_corners_of_strips_and_fans(self):
        self.assertEqual(loader.corner_triples(loader.STRIP, [5, 6, 7, 8]), [(5, 6, 7), (6, 8, 7)])
        self.assertEqual(loader.corner_triples(loader.FAN, [5, 6, 7, 8]), [(6, 7, 5), (7, 8, 5)])

    def test_sum_of_influences(self):
        unit, moved = nodes.IDENTITY, nodes.from_trs((4, 0, 0), (0, 0, 0, 1), (3, 3, 3))
        between = nodes.from_trs((1, 0, 0), (0, 0, 0, 1), (1.5, 1.5, 1.5))
        self.assertEqual(deform.weighted_sum([(0.75, unit), (0.25, moved)]), between)


class DocumentTest(unittest.TestCase):
    """Whole files, put together here."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "x.glb"
        self.views, self.accessors, self.binary = [], [], b""

    def add(self, kind, component, layout, rows, **more):
        content = b"".join(struct.pack("<" + layout, *row) for row in rows)
        self.views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(content)})
        self.binary += content
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "type": kind,
                               "count": len(rows), **more})
        return len(self.accessors) - 1

    def load(self, document, **options):
        text = json.dumps({**document, "bufferViews": self.views, "accessors": self.accessors}).encode()
        text += b" " * (-len(text) % 4)
        size = 28 + len(text) + len(self.binary)
        self.path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, size, len(text), 0x4E4F534A) + text
                              + struct.pack("<II", len(self.binary), 0x004E4942) + self.binary)
        return loader.load(self.path, **options)

    def test_skin_morph_animation(self):
        positions = self.add("VEC3", 5126, "3f", [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
        up = self.add("VEC3", 5120, "3b", [(0, 0, 127), (0, 0, 0), (0, 0, -128)], normalized=True)
        joints = self.add("VEC4", 5121, "4B", [(0, 1, 0, 0)] * 3)
        weights = self.add("VEC4", 5123, "4H", [(65535, 0, 0, 0), (0, 65535, 0, 0), (13107, 52428, 0, 0)],
                           normalized=True)
        inverse = self.add("MAT4", 5126, "16f", [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
                                                 (2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, 0, 0, 1)])
        times = self.add("SCALAR", 5126, "f", [(0,), (2,)])
        moves = self.add("VEC3", 5126, "3f", [(0, 0, 0), (0, 16, 0)])
        document = {
            "scenes": [{}, {"nodes": [0, 2]}],
            "nodes": [{"mesh": 0, "skin": 0, "scale": [1, 1, -1], "weights": [3]}, {"translation": [9, 9, 9]},
                      {"children": [1]}],
            "meshes": [{"weights": [5], "primitives": [
                {"attributes": {"POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights},
                 "targets": [{"POSITION": up}], "material": 0}]}],
            "materials": [{"doubleSided": True, "alphaMode": "MASK"}],
            "skins": [{"joints": [2, 1], "inverseBindMatrices": inverse}],
            "animations": [{"name": "a", "channels": []},
                           {"name": "rise", "samplers": [{"input": times, "output": moves}],
                            "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}]}
        self.assertEqual(len(self.load(document).flags), 0)
        rest, posed = (self.load(document, scene=1, time=t, name_of_animation="rise") for t in (None, 0.5))
        # Joint 0 stands still; joint 1 doubles, moves by -1 in x and by its node's translation.
        self.assertEqual(list(rest.coordinates[:6]), [0, 0, 3, 1 * 2 - 1 + 9, 9, 9])
        self.assertEqual(list(posed.coordinates[3:6]), [1, 4, 0])
        # A fifth of joint 0, four fifths of joint 1; the third weight and coordinate are rounded as the rules say.
        fifth, rest_of_it = 13107 / 65535, 52428 / 65535
        scale = fifth + rest_of_it * 2.0
        self.assertEqual(list(posed.coordinates[6:]), [rest_of_it * -1.0, scale + rest_of_it * 4.0, scale * -3.0])
        self.assertEqual((list(rest.corners), list(rest.flags)), ([0, 2, 1], [2]))

    def test_spheres_and_instances(self):
        positions = self.add("VEC3", 5123, "3H2x", [(0, 0, 0), (1, 2, 3)], byteOffset=0)
        self.views[0]["byteStride"] = 8
        radii = self.add("SCALAR", 5126, "f", [(1,), (0.5,)])
        indices = self.add("SCALAR", 5121, "B", [(1,), (0,), (1,)])
        moves = self.add("VEC3", 5126, "3f", [(0, 0, 0), (10, 0, 0)])
        scales = self.add("VEC3", 5126, "3f", [(1, 1, 1), (4, 4, 4)])
        instancing = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": moves, "SCALE": scales}}}
        document = {
            "nodes": [{"mesh": 0, "extensions": instancing}],
            "meshes": [{"primitives": [
                {"mode": 0, "attributes": {"POSITION": positions}},
                {"mode": 0, "attributes": {"POSITION": positions, "_RADIUS": radii}, "indices": indices},
                {"mode": 1, "attributes": {"POSITION": positions}}]}]}
        own = [((1, 2, 3), 0.5, 1), ((0, 0, 0), 1.0, 1), ((1, 2, 3), 0.5, 1)]
        enlarged = [((14, 8, 12), 2.0, 1), ((10, 0, 0), 4.0, 1), ((14, 8, 12), 2.0, 1)]
        scene = self.load(document)
        self.assertEqual((scene.spheres, len(scene.coordinates)), (own + enlarged, 0))
        scene = self.load(document, radius=0.25)
        given = [[((0, 0, 0), 0.25, 1), ((1, 2, 3), 0.25, 1)], [((10, 0, 0), 0.25, 1), ((14, 8, 12), 0.25, 1)]]
        self.assertEqual(scene.spheres, given[0] + own + given[1] + enlarged)


class MeshoptTest(unittest.TestCase):
    def test_attributes(self):
        # 17 elements of 4 bytes: two groups for each byte, the first of 2, 4, 8 and 0 bits, the second of 0.
        tail = bytes(28) + bytes([10, 20, 30, 40])
        two_bits = bytes([1, 0b01100011, 0, 0, 0, 7])  # +0, -1, +1, 0, then 7 = -4 in place of the fourth
        four_bits = bytes([2, 0x2F, 0, 0, 0, 0, 0, 0, 0, 0x80])  # +1, then 128 = +64
        raw = bytes([3, 255] + [0] * 15)  # -128
        data = bytes([0xA0]) + two_bits + four_bits + raw + bytes([0]) + tail
        out = meshopt.decode(data, "ATTRIBUTES", "NONE", 17, 4)
        self.assertEqual(out[:8], bytes([9, 21, 158, 40, 10, 85, 158, 40]))
        self.assertEqual(out[12:], bytes([6, 85, 158, 40]) * 14)

    def test_triangles(self):
        table = bytes([0x00, 0x12] + [0] * 14)
        codes = bytes([0xF0,   # new, new, new: 0 1 2; edges, latest first: (0,2) (2,1) (1,0)
                       0x10,   # edge (2,1) and a new one: 2 1 3; edges (2,3) (3,1) (0,2) ...
                       0x02,   # edge (2,3) and the vertex of rank 2: the latest are 3 2 1 0
                       0xF1,   # new 4, the latest (3), the one before it (2)
                       0x0F,   # edge (4,2), free: 0 + 9
                       0x0D,   # edge (4,9): 9 - 1
                       0xFF,   # free 8 - 2, then new 5 and the latest but one (9)
                       0xFE])  # begin again: 0 1 2
        extra = bytes([18, 0x02, 3, 0x00])
        out = meshopt.decode(bytes([0xE1]) + codes + extra + table, "TRIANGLES", "NONE", 24, 2)
        triangles = [(0, 1, 2), (2, 1, 3), (2, 3, 1), (4, 3, 2), (4, 2, 9), (4, 9, 8), (6, 5, 9), (0, 1, 2)]
        self.assertEqual(list(struct.iter_unpack("<3H", out)), triangles)

    def test_index_sequence(self):
        # +100 to the first, +1 to the second, -1 to the first, +200 to the second.
        data = bytes([0xD1, 0x90, 0x03, 0x05, 0x02, 0xA1, 0x06]) + bytes(4)
        self.assertEqual(struct.unpack("<4I", meshopt.decode(data, "INDICES", "NONE", 4, 4)), (100, 1, 99, 201))

    def some_mesh(self, rng, count):
        """Triangles that often share an edge with the one before, and whose third corners are often new."""
        indices, new = [0, 1, 2], 3
        while len(indices) < count:
            a, b, c = indices[-3:]
            old, any_one = rng.randrange(new), rng.randrange(65536)
            edge = rng.choice(((c, b), (a, c), (b, a), (new, old), (old, any_one)))
            new = max(new, edge[0] + 1)
            third = rng.choice((new, new, rng.randrange(new), c + 1, max(c - 1, 0), rng.randrange(65536)))
            new += third == new
            indices += [min(i, 65535) for i in (*edge, third)]
        return indices

    def test_what_the_encoder_writes(self):
        for seed in range(40):
            rng = random.Random(seed)
            count, stride = 3 * rng.randint(1, 300), 4 * rng.randint(1, 9)
            data = bytes(rng.choice((0, 0, 1, 2, rng.randrange(256))) for _ in range(count * stride))
            stream = meshopt_encoder.attributes(rng, data, stride)
            self.assertEqual(meshopt.decode(stream, "ATTRIBUTES", "NONE", count, stride), data)
            indices = self.some_mesh(rng, count)
            data = struct.pack("<%dH" % count, *indices)
            stream = meshopt_encoder.Triangles(rng).encode(indices)
            self.assertEqual(meshopt.decode(stream, "TRIANGLES", "NONE", count, 2), data)
            stream = meshopt_encoder.index_sequence(rng, indices)
            self.assertEqual(meshopt.decode(stream, "INDICES", "NONE", count, 2), data)

    def test_filters(self):
        exponential = struct.pack("<3I", 0xFF000003, 0x02FFFFFF, 0)
        self.assertEqual(struct.unpack("<3f", meshopt.exponential(exponential, 12)), (1.5, -4.0, 0.0))
        quaternions = struct.pack("<8h", 0, 0, 0, 32765, 32767, 0, 0, 32764)
        self.assertEqual(struct.unpack("<8h", meshopt.quaternion(quaternions, 8)), (0, 32767, 0, 0, 23170, 23170, 0, 0))
        normals = struct.pack("<12b", 32, 0, 64, 5, 0, -64, 64, 6, -64, 64, 64, 7)
        unpacked = [(90, 0, 90, 5), (0, -127, 0, 6), (0, 0, -127, 7)]
        self.assertEqual(list(struct.iter_unpack("<4b", meshopt.octahedral(normals, 4))), unpacked)


if __name__ == "__main__":
    unittest.main()
