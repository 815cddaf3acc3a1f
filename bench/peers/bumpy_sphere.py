"""The mesh of scene E: a sphere of 2 n (n - 1) triangles around (0, 0, -4), its radius modulated by products of sines.
It is written three times: for Penumbra (PLY), POV-Ray (mesh2) and Blender (arrays)."""

import os

import numpy as np

ROWS = 188  # 70 312 triangles


def points(n):
    """n + 1 circles of latitude with n points each, from the pole on the y axis down; each pole occurs n times."""
    polar, around = np.meshgrid(np.pi * np.arange(n + 1) / n, 2 * np.pi * np.arange(n) / n, indexing="ij")
    x, y, z = np.sin(polar) * np.cos(around), np.cos(polar), np.sin(polar) * np.sin(around)
    coarse = np.sin(9 * x + 2) * np.sin(11 * y) * np.sin(10 * z + 1)
    fine = np.sin(31 * x) * np.sin(29 * y + 1) * np.sin(33 * z)
    radius = 0.95 * (1 + 0.08 * (coarse + 0.4 * fine))
    return np.stack([radius * x, radius * y, radius * z - 4], -1).reshape(-1, 3).astype("<f4")


def triangles(n):
    corners = []
    for row in range(n):
        for column in range(n):
            here, right = row * n + column, row * n + (column + 1) % n
            if row > 0:
                corners.append((here, right, here + n))
            if row < n - 1:
                corners.append((right, right + n, here + n))
    return np.array(corners, "<i4")


def write_ply(path, vertices, faces):
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    records = np.zeros(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    records["count"] = 3
    records["corners"] = faces
    with open(path, "wb") as file:
        file.write(header.encode() + vertices.tobytes() + records.tobytes())


def write_mesh2(path, vertices, faces):
    def rows(values, form):
        return ",\n".join("<" + ",".join(form % v for v in row) + ">" for row in values)

    with open(path, "w") as file:
        file.write(f"mesh2 {{\nvertex_vectors {{ {len(vertices)},\n{rows(vertices, '%.9g')} }}\n"
                   f"face_indices {{ {len(faces)},\n{rows(faces, '%d')} }}\ntexture {{ Ball }} }}\n")


def write(folder):
    """Writes bumpy_sphere.ply, .inc and .npz into the folder."""
    vertices, faces = points(ROWS), triangles(ROWS)
    path = os.path.join(folder, "bumpy_sphere")
    write_ply(path + ".ply", vertices, faces)
    write_mesh2(path + ".inc", vertices, faces)
    np.savez(path + ".npz", vertices=vertices, faces=faces)
