#!/usr/bin/env python3
"""check_readers.py DUMP FOLDER: files that VTK, meshio and Gmsh write are read as they have them.

DUMP prints what the readers make of a file. Needs python3-vtk9, python3-meshio, python3-gmsh."""

import os
import subprocess
import sys

import gmsh
import meshio
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

DUMP, FOLDER = sys.argv[1:]
SIDE = 7  # points along the edge of the mesh
TEXT = 1e-5  # relative; VTK and meshio write no more digits as text
counts = {"passed": 0, "failed": 0}


def read(path, *options):
    """Points, and by cell the triangles; fields by name; a message for a file that is refused."""
    out = subprocess.run([DUMP, *options, path], capture_output=True, text=True, check=False)
    points, cells, fields = [], {}, {}
    for line in out.stdout.splitlines():
        if line.startswith("points"):
            points = [float(x) for x in line[6:].replace("(", "").replace(")", "").split()]
        elif " field '" in line:
            head, values = line.rsplit(":", 1)
            fields[head.split("'")[1]] = numpy.array([float(x) for x in values.split()])
        elif " of " in line and line[0].isdigit():
            corners, cell = line.split(" (")[0].split(" of ")
            cells.setdefault(int(cell), []).append([int(x) for x in corners.split()])
    return numpy.array(points).reshape(-1, 3), cells, fields, out.stderr


def judge(name, good):
    counts["passed" if good else "failed"] += 1
    if not good:
        print("FAIL", name)


def compare(name, points, faces, fields, tolerance=0.0, options=()):
    """The file has the points, the faces, split in some way, and the fields."""
    path = os.path.join(FOLDER, name)
    got_points, cells, got_fields, message = read(path, *options)
    if message:
        print(message)
    good = got_points.shape == points.shape and numpy.allclose(got_points, points, tolerance, 0)
    judge(f"points of {name}", good)
    judge(f"number of cells of {name}", len(cells) == len(faces))
    for i, face in enumerate(faces[: len(cells)]):
        split = cells[i]
        if len(split) != len(face) - 2 or {k for t in split for k in t} != set(face):
            judge(f"cell {i} of {name}", False)
    for field, values in fields.items():
        flat = numpy.asarray(values, float).ravel()
        got = got_fields.get(field, numpy.zeros(0))
        good = got.shape == flat.shape and numpy.allclose(got, flat, tolerance, 0, equal_nan=True)
        judge(f"field {field} of {name}", good)


def sheet():
    """A sheet of triangles and quadrilaterals, as points and faces."""
    random = numpy.random.default_rng(1)
    x, y = numpy.meshgrid(numpy.arange(SIDE), numpy.arange(SIDE))
    points = numpy.stack([x.ravel(), y.ravel(), random.random(SIDE * SIDE)], 1).astype(float)
    faces = []
    for i in range(SIDE - 1):
        for j in range(SIDE - 1):
            a, b = SIDE * i + j, SIDE * i + j + 1
            square = [a, b, b + SIDE, a + SIDE]
            faces += [square] if (i + j) % 2 else [square[:3], [a, b + SIDE, a + SIDE]]
    faces.sort(key=len)  # meshio writes the cells of a type together
    return points, faces


def sheet_fields(rows):
    random = numpy.random.default_rng(2)
    fields = {"real": random.random(rows), "vector": random.random((rows, 3)) - 0.5}
    for kind in ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"):
        fields[kind] = random.integers(0, 100, rows).astype(kind)
    fields["real"][3] = numpy.nan
    fields["single"] = random.random(rows).astype("float32")
    return fields


def vtk_sheet(dataset):
    points, faces = sheet()
    array = vtk.vtkPoints()
    array.SetData(numpy_to_vtk(points, deep=1))
    dataset.SetPoints(array)
    cells = vtk.vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    if dataset.IsA("vtkPolyData"):
        dataset.SetPolys(cells)
    else:
        dataset.SetCells([5 if len(face) == 3 else 9 for face in faces], cells)
    data = (dataset.GetPointData(), len(points)), (dataset.GetCellData(), len(faces))
    for attributes, rows in data:
        for name, values in sheet_fields(rows).items():
            one = numpy_to_vtk(values, deep=1)
            one.SetName(("cell " if rows == len(faces) else "") + name)
            attributes.AddArray(one)
    fields = sheet_fields(len(points))
    fields.update({"cell " + name: values for name, values in sheet_fields(len(faces)).items()})
    return dataset, points, faces, fields


def write_vtk(writer, dataset, name):
    writer.SetFileName(os.path.join(FOLDER, name))
    writer.SetInputData(dataset)
    judge(f"writing {name}", writer.Write() == 1)


def check_vtu():
    dataset, *want = vtk_sheet(vtk.vtkUnstructuredGrid())
    for i in range(24):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetDataMode(i % 3)
        writer.SetEncodeAppendedData(i // 3 % 2)
        writer.SetByteOrder(i // 6 % 2)
        writer.SetHeaderType(32 * (i // 12 + 1))
        writer.SetCompressorTypeToNone()
        write_vtk(writer, dataset, f"vtk{i}.vtu")
        compare(f"vtk{i}.vtu", *want, TEXT if i % 3 == 0 else 0.0)
    writer.SetCompressorTypeToZLib()
    write_vtk(writer, dataset, "zlib.vtu")
    judge("refusal of zlib", "vtkZLib" in read(os.path.join(FOLDER, "zlib.vtu"))[3])


def check_legacy():
    for i in range(8):
        kind = vtk.vtkPolyData if i % 2 else vtk.vtkUnstructuredGrid
        dataset, *want = vtk_sheet(kind())
        writer = (vtk.vtkPolyDataWriter if i % 2 else vtk.vtkUnstructuredGridWriter)()
        writer.SetFileType(1 + i // 2 % 2)
        writer.SetFileVersion(51 if i // 4 else 42)
        write_vtk(writer, dataset, f"legacy{i}.vtk")
        compare(f"legacy{i}.vtk", *want, 0.0 if i // 2 % 2 else TEXT)


def check_ply():
    dataset, points, faces, _ = vtk_sheet(vtk.vtkPolyData())
    for i in range(3):
        writer = vtk.vtkPLYWriter()
        writer.SetFileType(1 if i else 0)
        writer.SetDataByteOrder(i % 2)
        write_vtk(writer, dataset, f"vtk{i}.ply")
        compare(f"vtk{i}.ply", points, faces, {}, 1e-5)


def check_meshio():
    points, faces = sheet()
    triangles = [face for face in faces if len(face) == 3]
    blocks = [("triangle", triangles), ("quad", faces[len(triangles):])]
    numbers = {"real": numpy.arange(len(faces)) / 8, "whole": numpy.arange(len(faces))}
    cell_data = {name: [x[: len(triangles)], x[len(triangles):]] for name, x in numbers.items()}
    point_data = {"height": points[:, 2], "three": points}
    mesh = meshio.Mesh(points, blocks, point_data, cell_data)
    fields = {**numbers, **point_data}
    for name, file_format, options in (
        ("text.vtu", "vtu", {"binary": False}),
        ("binary.vtu", "vtu", {"binary": True, "compression": None}),
        ("text.vtk", "vtk42", {"binary": False}), ("binary.vtk", "vtk42", {"binary": True}),
        ("text5.vtk", "vtk51", {"binary": False}), ("binary5.vtk", "vtk51", {"binary": True}),
        ("text2.msh", "gmsh22", {"binary": False}), ("binary2.msh", "gmsh22", {"binary": True}),
    ):
        mesh.write(os.path.join(FOLDER, "meshio-" + name), file_format, **options)
        compare("meshio-" + name, points, faces, fields, TEXT)
    for name, options in (("text.ply", {"binary": False}), ("binary.ply", {}), ("mesh.obj", {})):
        meshio.Mesh(points, blocks).write(os.path.join(FOLDER, "meshio-" + name), **options)
        compare("meshio-" + name, points, faces, {}, TEXT)
    for name in ("text4.msh", "binary4.msh"):
        mesh = meshio.Mesh(points, blocks[:1], point_data)
        mesh.write(os.path.join(FOLDER, name), "gmsh", binary=name[0] == "b")
        compare(name, points, triangles, point_data, TEXT)


def gmsh_model():
    """A ball in a cube, of tetrahedra; its faces and their groups as Gmsh has them."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.4)
    box, ball = gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1), gmsh.model.occ.addSphere(3, 0, 0, 0.6)
    gmsh.model.occ.synchronize()
    surfaces = [tag for _, tag in gmsh.model.getEntities(2)]
    gmsh.model.addPhysicalGroup(2, surfaces[:2], 7)
    gmsh.model.setPhysicalName(2, 7, "two sides")
    gmsh.model.addPhysicalGroup(2, surfaces[2:], 8)
    gmsh.model.addPhysicalGroup(3, [box, ball], 9)
    gmsh.model.mesh.generate(3)
    return surfaces


def check_gmsh():
    surfaces = gmsh_model()
    for order in (1, 2, 3):
        gmsh.model.mesh.setOrder(order)
        kind = gmsh.model.mesh.getElementType("triangle", order)
        tags, points, _ = gmsh.model.mesh.getNodes()
        row = {int(tag): i for i, tag in enumerate(tags)}
        faces, groups = [], []
        for surface in surfaces:
            elements, nodes = gmsh.model.mesh.getElementsByType(kind, surface)
            corners = nodes.reshape(len(elements), -1)[:, :3]
            faces += [[row[int(k)] for k in face] for face in corners]
            groups += [7 if surface in surfaces[:2] else 8] * len(elements)
        for i in range(4):
            gmsh.option.setNumber("Mesh.MshFileVersion", 4.1 if i % 2 else 2.2)
            gmsh.option.setNumber("Mesh.Binary", i // 2)
            name = f"gmsh{order}-{i}.msh"
            gmsh.write(os.path.join(FOLDER, name))
            compare(name, points.reshape(-1, 3), faces, {"gmsh:physical": groups}, 1e-15)
            check_boundary(name, points.reshape(-1, 3), faces)


def check_boundary(name, points, faces):
    """The boundary of the tetrahedra is the mesh of the surfaces, which looks outwards."""
    _, cells, _, _ = read(os.path.join(FOLDER, name), "--boundary")
    turned = [min(t[i:] + t[:i] for i in range(3)) for split in cells.values() for t in split]
    want = [min(t[i:] + t[:i] for i in range(3)) for t in faces]
    judge(f"boundary of {name}", sorted(turned) == sorted(want))


os.makedirs(FOLDER, exist_ok=True)
check_vtu()
check_legacy()
check_ply()
check_meshio()
check_gmsh()
print("{passed} passed, {failed} failed".format(**counts))
sys.exit(counts["failed"] > 0)
