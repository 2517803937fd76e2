#!/usr/bin/env python3
"""Writes data/demo/courtyard.ply, the scene of tools/demo: a small cloister around a courtyard.

Usage: make_demo_scene.py [OUT.ply]      (without a name: standard output)

Metres, y up. Every coordinate is rounded to a multiple of 1/1024, so that the file is the same bit for
bit on every machine and each number in it is exact. The scene holds on purpose what is hard for a
visibility program: boxes that stand on the floor with coincident faces, a mosaic in the plane of the
pavement, columns sunk into their plinths, two corner columns that stand there twice, crates that cut
through each other, arches whose crown just touches the ceiling and leaves triangles of zero area,
T-junctions wherever two parts meet, and rooms full of things that hardly any viewpoint sees.
"""
import math
import sys

GRID = 1024


def snap(value):
    return round(value * GRID) / GRID


class Mesh:
    """Parts with vertices of their own: nothing is shared between two parts."""

    def __init__(self):
        self.vertices = []
        self.triangles = []

    def vertex(self, x, y, z):
        self.vertices.append((snap(x), snap(y), snap(z)))
        return len(self.vertices) - 1

    def face(self, *corners):
        """A convex polygon of vertex indices, counter-clockwise seen from its front."""
        for k in range(1, len(corners) - 1):
            self.triangles.append((corners[0], corners[k], corners[k + 1]))

    def polygon(self, *points):
        self.face(*[self.vertex(*p) for p in points])

    def box(self, x0, x1, y0, y1, z0, z1, turn=0.0):
        """An upright box, turned about its own vertical axis by an angle in degrees."""
        cx, cz = (x0 + x1) / 2, (z0 + z1) / 2
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        v = [self.vertex(cx + c * (x - cx) + s * (z - cz), y, cz - s * (x - cx) + c * (z - cz))
             for y in (y0, y1) for z in (z0, z1) for x in (x0, x1)]
        for corners in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
            self.face(*(v[k] for k in corners))

    def ring(self, x, y, z, radius, sides):
        return [self.vertex(x + radius * math.sin(2 * math.pi * (k + 0.5) / sides), y,
                            z + radius * math.cos(2 * math.pi * (k + 0.5) / sides)) for k in range(sides)]

    def band(self, lower, upper):
        """The side between two rings, its front outside."""
        n = len(lower)
        for k in range(n):
            self.face(lower[k], lower[(k + 1) % n], upper[(k + 1) % n], upper[k])

    def lathe(self, x, z, profile, sides, lid=True):
        """A turned body: rings of (radius, height) from bottom to top."""
        rings = [self.ring(x, y, z, r, sides) for r, y in profile]
        for lower, upper in zip(rings, rings[1:]):
            self.band(lower, upper)
        if lid:
            self.face(*rings[-1])

    def cone(self, x, z, radius, y0, y1, sides):
        base, tip = self.ring(x, y0, z, radius, sides), self.vertex(x, y1, z)
        for k in range(sides):
            self.face(base[k], base[(k + 1) % sides], tip)
        self.face(*reversed(base))


class Side:
    """A place to build along: u runs along a side of the court, w points away from the court."""

    def __init__(self, mesh, origin, along, outward):
        self.mesh, self.origin, self.along, self.outward = mesh, origin, along, outward
        # Polygons are written as seen from the court with u to the right; elsewhere u runs to the left.
        self.u_to_the_right = along[0] * outward[1] - along[1] * outward[0] < 0

    def at(self, u, y, w):
        return (self.origin[0] + u * self.along[0] + w * self.outward[0], y,
                self.origin[1] + u * self.along[1] + w * self.outward[1])

    def box(self, u0, u1, y0, y1, w0, w1):
        a, b = self.at(u0, y0, w0), self.at(u1, y1, w1)
        self.mesh.box(min(a[0], b[0]), max(a[0], b[0]), y0, y1, min(a[2], b[2]), max(a[2], b[2]))

    def polygon(self, *points):
        points = [self.at(*p) for p in points]
        self.mesh.polygon(*(points if self.u_to_the_right else reversed(points)))

    def lathe(self, u, w, profile, sides, lid=True):
        x, _, z = self.at(u, 0, w)
        self.mesh.lathe(x, z, profile, sides, lid)


def wall(side, length, y0, y1, w0, w1, openings):
    """A wall with rectangular openings (u0, u1, sill, lintel), put together from boxes that touch."""
    u = 0.0
    for u0, u1, sill, lintel in openings:
        side.box(u, u0, y0, y1, w0, w1)
        if sill > y0:
            side.box(u0, u1, y0, sill, w0, w1)
        side.box(u0, u1, lintel, y1, w0, w1)
        u = u1
    side.box(u, length, y0, y1, w0, w1)


def arch(side, u0, u1, spring, top, w0, w1, segments=6):
    """The wall above a round arch between two columns."""
    middle, radius = (u0 + u1) / 2, (u1 - u0) / 2
    curve = [(middle - radius * math.cos(math.pi * k / segments),
              spring + radius * math.sin(math.pi * k / segments)) for k in range(segments + 1)]
    for (a, ya), (b, yb) in zip(curve, curve[1:]):
        side.polygon((a, ya, w0), (b, yb, w0), (b, top, w0), (a, top, w0))
        side.polygon((a, ya, w1), (a, top, w1), (b, top, w1), (b, yb, w1))
        side.polygon((a, ya, w0), (a, ya, w1), (b, yb, w1), (b, yb, w0))


def column(side, u, w):
    side.box(u - 0.3, u + 0.3, 0.0, 0.25, w - 0.3, w + 0.3)
    # The shaft starts inside its plinth and ends inside its capital.
    side.lathe(u, w, [(0.22, 0.125), (0.17, 2.3)], 8, lid=False)
    side.box(u - 0.25, u + 0.25, 2.25, 2.5, w - 0.25, w + 0.25)


def arcade(side, length, bays):
    """Columns and arches, the gallery behind them, an upper floor with windows, a roof."""
    step = length / bays
    for k in range(bays + 1):
        column(side, k * step, 0.0)
        if k < bays:
            arch(side, k * step + 0.25, (k + 1) * step - 0.25, 2.5, 4.0, -0.2, 0.2)
        side.box(k * step - 0.25, k * step + 0.25, 2.5, 4.0, -0.2, 0.2)
    side.box(-3.0, length + 3.0, 4.0, 4.25, -0.4, 3.0)  # the ceiling of the gallery, and a ledge
    doors = [(step * (k + 0.5) - 0.5, step * (k + 0.5) + 0.5, 0.0, 2.25) for k in range(0, bays, 2)]
    wall(side, length, 0.0, 4.0, 2.75, 3.0, doors)
    windows = [(step * (k + 0.5) - 0.45, step * (k + 0.5) + 0.45, 5.0, 6.25) for k in range(bays)]
    wall(side, length, 4.25, 7.0, -0.15, 0.15, windows)
    side.box(0.0, length, 0.0, 7.0, 5.75, 6.0)
    side.polygon((-0.5, 6.9, -0.6), (length + 0.5, 6.9, -0.6), (length + 0.5, 8.5, 3.0), (-0.5, 8.5, 3.0))
    side.polygon((-0.5, 8.5, 3.0), (length + 0.5, 8.5, 3.0), (length + 0.5, 6.9, 6.6), (-0.5, 6.9, 6.6))
    rooms(side, length, bays)


def rooms(side, length, bays):
    """Behind the gallery and upstairs: what most viewpoints never see."""
    step = length / bays
    for k in range(bays):
        u = step * k
        side.box(u, u + 0.125, 0.0, 4.0, 3.0, 5.75)
        side.box(u + 0.8, u + 2.2, 0.75, 0.85, 4.0, 5.0)  # a table on one leg, a vase on it
        side.lathe(u + 1.5, 4.5, [(0.2, 0.0), (0.2, 0.75)], 6, lid=False)
        side.lathe(u + 1.5, 4.5, [(0.14, 0.85), (0.05, 1.15), (0.09, 1.25)], 6, lid=False)
        side.box(u + 0.5, u + 1.6, 4.25, 4.75, 3.0, 5.0)  # a bed upstairs


def fountain(mesh, x, z):
    mesh.lathe(x, z, [(1.7, 0.0), (1.7, 0.15), (1.5, 0.15), (1.4, 0.7), (1.5, 0.75)], 12, lid=False)
    outer, inner = mesh.ring(x, 0.75, z, 1.5, 12), mesh.ring(x, 0.75, z, 1.25, 12)
    mesh.band(outer, inner)
    mesh.face(*mesh.ring(x, 0.6, z, 1.25, 12))  # the water
    mesh.band(inner, mesh.ring(x, 0.6, z, 1.25, 12))
    mesh.lathe(x, z, [(0.3, 0.5), (0.15, 0.9), (0.15, 1.4), (0.6, 1.7), (0.65, 1.75)], 8)
    mesh.cone(x, z, 0.2, 1.75, 2.25, 8)


def stairs(mesh, x0, x1, z0, steps, tread, rise):
    """Up the east wall, towards the north, to a landing."""
    for k in range(steps):
        mesh.box(x0, x1, 0.0, rise * (k + 1), z0 - tread * (k + 1), z0 - tread * k)
    end = z0 - tread * steps
    mesh.box(x0, x1, rise * steps - 0.2, rise * steps, end - 1.5, end)
    for k in range(0, steps, 2):
        mesh.box(x0, x0 + 0.08, rise * (k + 1), rise * (k + 1) + 0.9, z0 - tread * (k + 1), z0 - tread * k)


def cypress(mesh, x, z, height):
    mesh.lathe(x, z, [(0.12, -0.1), (0.1, 0.8)], 6, lid=False)
    for k, radius in enumerate((0.75, 0.65, 0.45)):
        mesh.cone(x, z, radius, 0.5 + 0.22 * height * k, 0.5 + height * (0.55 + 0.2 * k), 8)


def courtyard():
    mesh = Mesh()
    for i in range(8):  # the pavement, and a mosaic that lies in its plane
        for j in range(7):
            x, z = -8 + 2 * i, -6 + 2 * j
            mesh.polygon((x, 0, z), (x, 0, z + 2), (x + 2, 0, z + 2), (x + 2, 0, z))
    for k in range(6):
        a, b = k * math.pi / 3, (k + 1) * math.pi / 3
        mesh.polygon((0, 0, -0.5), (3 * math.sin(a), 0, -0.5 + 3 * math.cos(a)),
                     (3 * math.sin(b), 0, -0.5 + 3 * math.cos(b)))
    for x0, x1, z0, z1 in ((-14, 14, -12, -6), (-14, -8, -6, 8), (8, 14, -6, 8)):
        mesh.polygon((x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0))

    arcade(Side(mesh, (-8, -6), (1, 0), (0, -1)), 16.0, 5)   # north
    arcade(Side(mesh, (-8, 8), (0, -1), (-1, 0)), 14.0, 4)   # west
    arcade(Side(mesh, (8, -6), (0, 1), (1, 0)), 14.0, 4)     # east
    wall(Side(mesh, (8, 8), (-1, 0), (0, 1)), 16.0, 0.0, 5.0, 0.0, 0.5, [(6.5, 9.5, 0.0, 3.5)])  # the gate

    fountain(mesh, 0, -0.5)
    stairs(mesh, 5.6, 7.4, 3.5, 8, 0.35, 0.2)
    for x, z, height in ((-5.5, -4.0, 4.5), (4.4, -4.2, 5.5), (-6.4, 1.6, 4.0), (3.9, 5.6, 5.0)):
        cypress(mesh, x, z, height)

    mesh.box(-3.9, -2.9, 0.0, 1.0, -3.2, -2.2, turn=20)
    mesh.box(-3.3, -2.5, 0.0, 0.8, -2.7, -1.9, turn=-35)  # cuts into the crate before it
    mesh.box(-3.7, -3.1, 1.0, 1.6, -3.0, -2.4, turn=50)   # stands on it: coincident faces
    mesh.box(2.4, 3.3, 0.0, 0.9, 1.6, 2.5)
    mesh.box(2.4, 3.0, 0.9, 1.5, 1.6, 2.2)                # flush with two faces of the one below
    mesh.lathe(1.9, 2.6, [(0.2, 0.0), (0.35, 0.35), (0.3, 0.7), (0.15, 0.85), (0.22, 1.0)], 10, lid=False)
    mesh.lathe(-2.2, 3.4, [(0.2, 0.0), (0.3, 0.3), (0.25, 0.6), (0.12, 0.72), (0.18, 0.85)], 10, lid=False)
    return mesh


def write_ply(mesh, out, comment="a courtyard, metres, y up; made by tools/scenes/make_demo_scene.py"):
    out.write("ply\nformat ascii 1.0\n")
    out.write(f"comment {comment}\n")
    out.write(f"element vertex {len(mesh.vertices)}\n")
    out.write("property double x\nproperty double y\nproperty double z\n")
    out.write(f"element face {len(mesh.triangles)}\n")
    out.write("property list uchar uint vertex_indices\nend_header\n")
    for vertex in mesh.vertices:
        out.write(" ".join(f"{c:.10f}".rstrip("0").rstrip(".") for c in vertex).replace("-0 ", "0 ") + "\n")
    for triangle in mesh.triangles:
        out.write("3 %d %d %d\n" % triangle)


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and sys.argv[1].startswith("-")):
        sys.exit(__doc__.strip())
    mesh = courtyard()
    if len(sys.argv) == 2:
        with open(sys.argv[1], "w", newline="\n", encoding="ascii") as out:
            write_ply(mesh, out)
    else:
        write_ply(mesh, sys.stdout)


if __name__ == "__main__":
    main()
