#!/usr/bin/env python3
"""check_distance.py SMOOTH FOLDER MESH...: facets within a distance are within it, and are few.

The distance of the surface from the facets is VTK's, over points in each patch that are on no
facet's edge. Besides the meshes a sphere and a torus are made. Needs python3-vtk9."""

import os
import shutil
import sys

import numpy
import vtk
from patches import patch_points, patches_of, path, smooth, sphere, torus, write_obj

SAMPLES = 200000  # points at most
PERCENT = (1, 0.1, 0.02)  # of the bounding box's diagonal
TIMES = 1.5  # what equal parts of the edges take, at most, where curvature is even
TOGETHER = 0.6  # the same, for all meshes that were made elsewhere
counts = {"passed": 0, "failed": 0}


def judge(name, good):
    counts["passed" if good else "failed"] += 1
    if not good:
        print("FAIL", name)


def samples_of(patches):
    """Points of the patches, in the middle of the triangles of a lattice."""
    n = int(min(12, max(2, (2 * SAMPLES / len(patches)) ** 0.5)))
    lattice = [((3 * i + 1) / (3 * n), (3 * j + 1) / (3 * n)) for i in range(n)
               for j in range(n - i)]
    return patch_points(patches, lattice).reshape(-1, 3)


def facets(source, *options):
    """VTK's locator of facets, and their number."""
    smooth(source, "facets.vtu", "--binary", *options)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path("facets.vtu"))
    reader.Update()
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet(reader.GetOutput())
    locator.BuildLocator()
    return locator, reader.GetOutput().GetNumberOfCells()


def distance(locator, points):
    cell, number = vtk.vtkGenericCell(), vtk.reference(0)
    part, square, most = vtk.reference(0), vtk.reference(0.0), 0.0
    for x in points:
        locator.FindClosestPoint(x, [0.0] * 3, cell, number, part, square)
        most = max(most, float(square))
    return most**0.5


def least_level(source, points, limit):
    """Of equal parts of each edge, the fewest that are within the limit; the triangles then."""
    level = 1
    while True:
        locator, count = facets(source, "-n", str(level))
        if distance(locator, points) <= limit:
            return count
        level += 1


def check(source):
    """The numbers of triangles within the percentages, and what equal parts take."""
    found_counts, equal_counts = 0, 0
    patches, _ = patches_of(source)
    points, corners = samples_of(patches), patches[:, :3].reshape(-1, 3)
    size = numpy.linalg.norm(corners.max(0) - corners.min(0))
    for percent in PERCENT:
        locator, count = facets(source, "--tol", f"{percent}%")
        found = distance(locator, points) / size * 100
        judge(f"{source} is within {percent} %: {found:.6g} %", found <= percent * (1 + 1e-9))
        if percent > 0.05 and len(patches) < 1000:
            equal = least_level(source, points, percent / 100 * size)
            print(f"{source} within {percent} %: {count} triangles, {equal} in equal parts")
            judge(f"{source} has few", count <= TIMES * equal)
            found_counts, equal_counts = found_counts + count, equal_counts + equal
    return found_counts, equal_counts


os.makedirs(path(""), exist_ok=True)
write_obj("sphere.obj", *sphere(1))
check("sphere.obj")
write_obj("torus.obj", *torus(12, 6))
check("torus.obj")
_totals = numpy.zeros(2)
for mesh in sys.argv[3:]:
    copy = os.path.basename(mesh)
    shutil.copy(mesh, path(copy))
    _totals += check(copy)
if len(sys.argv) > 3:
    judge("all together have few", _totals[0] <= TOGETHER * _totals[1])
print("{passed} passed, {failed} failed".format(**counts))
sys.exit(counts["failed"] > 0)
