"""The triangles and spheres of a GLB file's scene, in loading order, with their flags."""
import math
from array import array

from reference import animation, deform
from reference.nodes import Hierarchy, is_mirrored, place
from reference.reader import Document

POINTS, TRIANGLES, STRIP, FAN = 0, 4, 5, 6


class Scene:
    """Flat lists: three coordinates for each vertex, three vertices and one byte of flags for each triangle."""

    def __init__(self):
        self.coordinates, self.corners, self.flags = array("d"), array("I"), bytearray()
        self.spheres = []  # (center, radius, flags)


def load(path, scene=None, time=None, name_of_animation="", radius=None):
    document = Document(path)
    hierarchy = Hierarchy(document, animation.pose(document, name_of_animation, time))
    loader = Loader(document, hierarchy, radius)
    for root in hierarchy.roots(scene):
        loader.visit(root)
    return loader.scene


class Loader:
    def __init__(self, document, hierarchy, radius):
        self.document, self.hierarchy, self.radius, self.scene = document, hierarchy, radius, Scene()

    def visit(self, index):
        node = self.hierarchy.nodes[index]
        if "mesh" in node:
            self.add_mesh(index, node)
        for child in node.get("children", []):
            self.visit(child)

    def add_mesh(self, index, node):
        weights, joints = self.hierarchy.weights(index), None
        if "skin" in node:
            joints = deform.joint_matrices(self.document, self.hierarchy, self.document.json["skins"][node["skin"]])
        for world in self.hierarchy.placements(index):
            mirrored = is_mirrored(world)
            for primitive in self.document.json["meshes"][node["mesh"]]["primitives"]:
                if "POSITION" in primitive["attributes"]:
                    self.add_primitive(primitive, weights, joints, world, mirrored)

    def add_primitive(self, primitive, weights, joints, world, mirrored):
        mode = primitive.get("mode", TRIANGLES)
        is_sphere = mode == POINTS and ("_RADIUS" in primitive["attributes"] or self.radius is not None)
        if not is_sphere and mode not in (TRIANGLES, STRIP, FAN):
            return
        positions = self.document.accessor(primitive["attributes"]["POSITION"])
        positions = deform.morphed(self.document, primitive, positions, weights)
        matrices = [world] * len(positions)
        if joints is not None:
            matrices = deform.vertex_matrices(self.document, primitive, joints)
        placed = [place(matrix, position) for matrix, position in zip(matrices, positions)]
        corners = range(len(positions))
        if "indices" in primitive:
            corners = [i for (i,) in self.document.accessor(primitive["indices"])]
        if is_sphere:
            self.add_spheres(primitive, corners, placed, matrices)
        else:
            self.add_triangles(primitive, corner_triples(mode, corners), placed, mirrored)

    def add_triangles(self, primitive, triples, placed, mirrored):
        scene, first = self.scene, len(self.scene.coordinates) // 3
        for a, b, c in triples:
            scene.corners.extend((first + a, first + c, first + b) if mirrored else (first + a, first + b, first + c))
        scene.flags += bytes([self.flags_of(primitive)]) * len(triples)
        for point in placed:
            scene.coordinates.extend(point)

    def add_spheres(self, primitive, corners, placed, matrices):
        flags = self.flags_of(primitive)
        for corner in corners:
            radius = self.radius
            if "_RADIUS" in primitive["attributes"]:
                (own,) = self.document.accessor(primitive["attributes"]["_RADIUS"])[corner]
                m = matrices[corner]
                radius = own * math.sqrt((m[0][0] * m[0][0] + m[1][0] * m[1][0]) + m[2][0] * m[2][0])
            self.scene.spheres.append((placed[corner], radius, flags))

    def flags_of(self, primitive):
        return material_flags(self.document.json["materials"][primitive["material"]] if "material" in primitive else {})


def corner_triples(mode, v):
    if mode == TRIANGLES:
        return [v[i:i + 3] for i in range(0, len(v), 3)]
    if mode == STRIP:
        return [(v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]) for i in range(len(v) - 2)]
    return [(v[i + 1], v[i + 2], v[0]) for i in range(len(v) - 2)]


def material_flags(material):
    transmission = material.get("extensions", {}).get("KHR_materials_transmission", {})
    opaque = material.get("alphaMode", "OPAQUE") == "OPAQUE" and transmission.get("transmissionFactor", 0) == 0
    return (0 if material.get("doubleSided", False) else 1) | (0 if opaque else 2)
