#!/usr/bin/python3
"""check_vtu.py LAGRANGE.vtu BEZIER.vtu: VTK reads both files, and they hold the same surface.

LAGRANGE has 10-node triangles of type 69, BEZIER of type 76. Every triangle is evaluated by VTK
on a lattice and compared with the cubic through, or controlled by, its ten nodes as computed here;
then the two files with each other. VTK keeps points in float or double, its shape functions in
double; coordinates are compared to 1e-6 of the size of the mesh.
"""

import math
import sys

import vtk

LATTICE = 6
EXPONENTS = [(3, 0, 0), (0, 3, 0), (0, 0, 3), (2, 1, 0), (1, 2, 0), (0, 2, 1), (0, 1, 2),
             (1, 0, 2), (2, 0, 1), (1, 1, 1)]
LAGRANGE, BEZIER = 69, 76


def bernstein(exponents, weights):
    value = 6.0
    for k, w in zip(exponents, weights):
        value *= w**k / math.factorial(k)
    return value


def lagrange(exponents, weights):
    value = 1.0
    for k, w in zip(exponents, weights):
        for m in range(k):
            value *= (3 * w - m) / (m + 1)
    return value


def points_of(name, cell_type, basis, tolerance):
    """VTK's points of every triangle at the lattice; they agree with the basis."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    size = grid.GetLength()
    if errors or grid.GetNumberOfCells() == 0:
        sys.exit(f"{name}: VTK does not read it")
    places = [(i / LATTICE, j / LATTICE) for i in range(LATTICE + 1) for j in range(LATTICE + 1 - i)]
    all_points = []
    for index in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(index)
        if cell.GetCellType() != cell_type or cell.GetNumberOfPoints() != 10:
            sys.exit(f"{name}: cell {index} is not a 10-node triangle of type {cell_type}")
        nodes = [cell.GetPoints().GetPoint(k) for k in range(10)]
        for u, v in places:
            point, shapes = [0.0] * 3, [0.0] * 10
            cell.EvaluateLocation(vtk.reference(0), [u, v, 0.0], point, shapes)
            weights = [basis(e, (1 - u - v, u, v)) for e in EXPONENTS]
            want = [sum(w * n[c] for w, n in zip(weights, nodes)) for c in range(3)]
            if not math.dist(point, want) <= tolerance * size:
                sys.exit(f"{name}: cell {index} at {u:g} {v:g}: VTK has {point}, not {want}")
            all_points.append(point)
    return all_points, size


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: check_vtu.py LAGRANGE.vtu BEZIER.vtu")
    one, size = points_of(sys.argv[1], LAGRANGE, lagrange, 1e-6)
    two, _ = points_of(sys.argv[2], BEZIER, bernstein, 1e-6)
    if len(one) != len(two):
        sys.exit(f"the files have {len(one)} and {len(two)} points")
    worst = max(math.dist(p, q) for p, q in zip(one, two))
    print(f"{len(one)} points agree, the worst by {worst / size:.3g} of the size")
    if not worst <= 1e-6 * size:
        sys.exit("the files are not the same surface")


main()
