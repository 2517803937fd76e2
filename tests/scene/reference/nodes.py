"""Affine maps as three rows of four float64, and the hierarchy of nodes in a pose."""
from fractions import Fraction

IDENTITY = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]


def from_columns(numbers):
    """Of a 4x4 matrix by columns, whose last row is 0 0 0 1."""
    return [[float(numbers[4 * column + row]) for column in range(4)] for row in range(3)]


def from_trs(translation, rotation, scale):
    x, y, z, w = map(float, rotation)
    turned = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
              [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
              [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[turned[r][c] * scale[c] for c in range(3)] + [float(translation[r])] for r in range(3)]


def product(p, m):
    return [[((p[r][0] * m[0][c] + p[r][1] * m[1][c]) + p[r][2] * m[2][c]) + (p[r][3] if c == 3 else 0.0)
             for c in range(4)] for r in range(3)]


def place(m, point):
    x, y, z = point
    return tuple(((row[0] * x + row[1] * y) + row[2] * z) + row[3] for row in m)


def is_mirrored(m):
    a, b, c = ([Fraction(x) for x in row[:3]] for row in m)
    cross = (b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0])
    return sum(x * y for x, y in zip(a, cross)) < 0


class Hierarchy:
    def __init__(self, document, pose):
        self.document, self.nodes, self.pose = document, document.list("nodes"), pose
        self.parents = {child: index for index, node in enumerate(self.nodes) for child in node.get("children", [])}
        self.worlds = {}

    def roots(self, scene):
        """Of the scene asked for, else of the file's default, else of the first; without scenes, of the file."""
        scenes = self.document.list("scenes")
        if not scenes:
            return [index for index in range(len(self.nodes)) if index not in self.parents]
        return scenes[self.document.json.get("scene", 0) if scene is None else scene].get("nodes", [])

    def local(self, index):
        node, animated = self.nodes[index], self.pose.get(index, {})
        if "matrix" in node:
            return from_columns(node["matrix"])
        defaults = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}
        return from_trs(*(animated.get(part, node.get(part, default)) for part, default in defaults.items()))

    def world(self, index):
        if index not in self.worlds:
            above = self.world(self.parents[index]) if index in self.parents else IDENTITY
            self.worlds[index] = product(above, self.local(index))
        return self.worlds[index]

    def placements(self, index):
        """The global matrices under which the node's mesh appears: its own, or one for each instance."""
        instancing = self.nodes[index].get("extensions", {}).get("EXT_mesh_gpu_instancing")
        if instancing is None:
            return [self.world(index)]
        attributes = {name: self.document.accessor(a) for name, a in instancing["attributes"].items()}
        count = max(map(len, attributes.values()))
        trs = [attributes.get(name, [default] * count) for name, default in
               (("TRANSLATION", (0, 0, 0)), ("ROTATION", (0, 0, 0, 1)), ("SCALE", (1, 1, 1)))]
        return [product(self.world(index), from_trs(*one)) for one in zip(*trs)]

    def weights(self, index):
        """Of the morph targets of the node's mesh."""
        node = self.nodes[index]
        mesh = self.document.json["meshes"][node["mesh"]]
        return self.pose.get(index, {}).get("weights", node.get("weights", mesh.get("weights", [])))
