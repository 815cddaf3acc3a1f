#!/usr/bin/env python3
"""Write the meshes of scene 9: scenes/meshes/knot.ply and scenes/meshes/gem.obj.

knot.ply  a tube around a (2, 3) torus knot, the trefoil; binary PLY, closed, outward triangles
gem.obj   a cut stone, convex and closed: table, crown, girdle and pavilion; OBJ, outward polygons

Needs only Python 3 and its standard library, and writes the same files every time:

    python3 scripts/make_mesh.py            # into scenes/meshes
    python3 scripts/make_mesh.py FOLDER
"""

import math
import pathlib
import struct
import sys


def add(a, b, scale=1.0):
    return tuple(x + scale * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def knot_point(turn):
    """The trefoil's centre line, turn in [0, 1); it lies around the z axis and fits in a ball of radius 1.36."""
    angle = 2 * math.pi * turn
    radius = 1 + 0.36 * math.cos(3 * angle)
    return (radius * math.cos(2 * angle), radius * math.sin(2 * angle), 0.42 * math.sin(3 * angle))


def knot(around, along, thickness):
    """Vertices and outward triangles of a tube around the knot: `along` rings of `around` vertices."""
    vertices = []
    for i in range(along):
        centre = knot_point(i / along)
        forward = unit(add(knot_point((i + 0.5) / along), knot_point((i - 0.5) / along), -1))
        # The direction away from the axis never runs along the tube: a frame without a seam.
        outward = (centre[0], centre[1], 0.0)
        across = unit(cross(outward, forward))
        over = cross(forward, across)
        for j in range(around):
            angle = 2 * math.pi * j / around
            point = add(centre, over, thickness * math.cos(angle))
            vertices.append(add(point, across, thickness * math.sin(angle)))
    triangles = []
    for i in range(along):
        here, there = i * around, (i + 1) % along * around
        for j in range(around):
            k = (j + 1) % around
            triangles.append((here + j, there + j, there + k))
            triangles.append((here + j, there + k, here + k))
    return vertices, triangles


def volume(vertices, triangles):
    """Signed volume: positive if the triangles face outward."""
    total = 0.0
    for a, b, c in triangles:
        normal = cross(vertices[b], vertices[c])
        total += sum(x * y for x, y in zip(vertices[a], normal)) / 6
    return total


def write_ply(path, vertices, triangles):
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        "comment trefoil knot, written by scripts/make_mesh.py\n"
        f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    with open(path, "wb") as out:
        out.write(header.encode("ascii"))
        for vertex in vertices:
            out.write(struct.pack("<3f", *vertex))
        for triangle in triangles:
            out.write(struct.pack("<B3i", 3, *triangle))


def gem(sides):
    """A stone with its table up (+y) and its point down: polygons counter-clockwise seen from outside."""

    def ring(radius, height, shift):
        step = 2 * math.pi / sides
        # z is minus the sine, so that the ring runs counter-clockwise seen from above.
        return [(radius * math.cos(step * (i + shift)), height, -radius * math.sin(step * (i + shift))) for i in range(sides)]

    table, top, bottom = ring(0.56, 0.34, 0.0), ring(1.0, 0.05, 0.5), ring(1.0, -0.03, 0.5)
    vertices = table + top + bottom + [(0.0, -0.86, 0.0)]
    point = len(vertices) - 1
    polygons = [tuple(range(sides))]
    for i in range(sides):
        k = (i + 1) % sides
        polygons.append((i, sides + i, k))
        polygons.append((sides + i, sides + k, k))
        polygons.append((sides + i, 2 * sides + i, 2 * sides + k, sides + k))
        polygons.append((2 * sides + i, point, 2 * sides + k))
    return vertices, polygons


def write_obj(path, vertices, polygons):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("# cut stone, written by scripts/make_mesh.py\n")
        for vertex in vertices:
            out.write("v {:.6f} {:.6f} {:.6f}\n".format(*vertex))
        for polygon in polygons:
            out.write("f " + " ".join(str(i + 1) for i in polygon) + "\n")


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "meshes"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    folder.mkdir(parents=True, exist_ok=True)
    vertices, triangles = knot(around=32, along=225, thickness=0.27)
    assert volume(vertices, triangles) > 0
    write_ply(folder / "knot.ply", vertices, triangles)
    vertices, polygons = gem(sides=9)
    fan = [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]
    assert volume(vertices, fan) > 0
    write_obj(folder / "gem.obj", vertices, polygons)


if __name__ == "__main__":
    main()
