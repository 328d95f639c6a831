"""Patches as smooth has them, for the checks with other programs; and meshes to begin with."""

import math
import os
import subprocess
import sys
import xml.etree.ElementTree

import numpy

SMOOTH, FOLDER = sys.argv[1:3]
EXPONENTS = numpy.array([(3, 0, 0), (0, 3, 0), (0, 0, 3), (2, 1, 0), (1, 2, 0), (0, 2, 1),
                         (0, 1, 2), (1, 0, 2), (2, 0, 1), (1, 1, 1)])


def path(name):
    return os.path.join(FOLDER, name)


def smooth(source, result, *options):
    subprocess.run([SMOOTH, "--quiet", path(source), "-o", path(result), *options], check=True)


def bernstein(u, v):
    factors = [6 / math.prod(math.factorial(k) for k in e) for e in EXPONENTS.tolist()]
    return numpy.prod(numpy.array([1 - u - v, u, v]) ** EXPONENTS, 1) * factors


def patch_points(patches, lattice):
    basis = numpy.array([bernstein(u, v) for u, v in lattice])
    return numpy.einsum("lk,pkc->plc", basis, patches)


def patches_of(source, *options):
    """Those of the mesh, ten control points each; and the corners of each."""
    smooth(source, "net.vtu", "--bezier", "--text", *options)
    arrays = xml.etree.ElementTree.parse(path("net.vtu")).getroot().iter("DataArray")
    text = {a.get("Name"): a.text.split() for a in arrays}
    points = numpy.array(text["points"], float).reshape(-1, 3)
    nodes = numpy.array(text["connectivity"], int).reshape(-1, 10)
    return points[nodes], nodes[:, :3]


def torus(n, m):
    """Points with their exact normals, and triangles."""
    u, v = [a.ravel() for a in numpy.meshgrid(numpy.arange(n), numpy.arange(m), indexing="ij")]
    p, q = 2 * math.pi * u / n, 2 * math.pi * v / m
    normals = numpy.stack([numpy.cos(q) * numpy.cos(p), numpy.cos(q) * numpy.sin(p), numpy.sin(q)], 1)
    points = normals + 2 * numpy.stack([numpy.cos(p), numpy.sin(p), 0 * p], 1)
    right, up = (u + 1) % n, (v + 1) % m
    a, b, c, d = u * m + v, right * m + v, right * m + up, u * m + up
    return points, normals, numpy.concatenate([numpy.stack([a, b, c], 1), numpy.stack([a, c, d], 1)])


def sphere(levels):
    """An octahedron, each face cut in four so many times."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(x, y, z) if (x + y + z) % 2 == 0 else (y, x, z)
             for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for _ in range(levels):
        middle, finer = {}, []
        for face in faces:
            new = []
            for a, b in zip(face, face[1:] + face[:1]):
                key = (min(a, b), max(a, b))
                if key not in middle:
                    x = numpy.add(points[a], points[b])
                    middle[key] = len(points)
                    points.append(tuple(x / numpy.linalg.norm(x)))
                new.append(middle[key])
            (a, b, c), (d, e, f) = face, new
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    points = numpy.array(points, float)
    return points, points, numpy.array(faces)


def write_obj(name, points, normals, faces):
    with open(path(name), "w", encoding="ascii") as file:
        for word, rows in (("v", points), ("vn", normals)):
            for row in rows:
                print(word, *(repr(float(x)) for x in row), file=file)
        for face in faces:
            print("f", *(f"{k + 1}//{k + 1}" for k in face), file=file)
