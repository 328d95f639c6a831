#!/usr/bin/env python3
"""check_writers.py SMOOTH FOLDER: VTK, Gmsh, OpenCASCADE and meshio read what smooth writes, and
have the same surface, fields, groups and numbers.

The surface is that of the control points in a VTU of type 76, read and evaluated here. Needs
python3-vtk9, python3-meshio and python3-gmsh, which has OpenCASCADE in it."""

import itertools
import math
import os
import select
import signal
import subprocess
import sys
import time

import gmsh
import meshio
import numpy
import vtk
from patches import FOLDER, SMOOTH, bernstein, patch_points, patches_of, path, smooth, sphere, torus
from patches import write_obj
from vtk.util.numpy_support import vtk_to_numpy

LATTICE = [(i / 6, j / 6) for i in range(7) for j in range(7 - i)]
SINGLE = 1e-6
ROUNDING = 1e-13  # of coordinates up to 3, after some dozens of operations on them
counts = {"passed": 0, "failed": 0}


def judge(name, good):
    counts["passed" if good else "failed"] += 1
    if not good:
        print("FAIL", name)


def agree(name, got, want, tolerance=ROUNDING):
    got, want = numpy.asarray(got, float), numpy.asarray(want, float)
    good = got.shape == want.shape and numpy.allclose(got, want, 0, tolerance)
    if not good and got.shape == want.shape:
        print(f"    off by {numpy.abs(got - want).max():.3g}")
    judge(name, good)


# ---- Meshes, and their measures ----


def measure(patches):
    """Volume and area, by Gauss's rule on the triangle as a collapsed square. The volume's
    integrand has the degree 7, which 8 points integrate exactly."""
    abscissas, weights = numpy.polynomial.legendre.leggauss(24)
    step = 1e-3
    volume = area = 0.0
    for (s, a), (t, b) in itertools.product(zip(abscissas, weights), repeat=2):
        u, v = (1 + s) / 2, (1 + t) / 2
        v *= 1 - u
        # Differences over four points are exact for a cubic.
        du = [bernstein(u + k * step, v) * w for k, w in ((1, 8), (-1, -8), (2, -1), (-2, 1))]
        dv = [bernstein(u, v + k * step) * w for k, w in ((1, 8), (-1, -8), (2, -1), (-2, 1))]
        x = numpy.einsum("k,pkc->pc", bernstein(u, v), patches)
        xu = numpy.einsum("k,pkc->pc", sum(du) / (12 * step), patches)
        xv = numpy.einsum("k,pkc->pc", sum(dv) / (12 * step), patches)
        normal = numpy.cross(xu, xv)
        weight = a * b * (1 - u) / 4
        volume += weight * numpy.einsum("pc,pc", x, normal) / 3
        area += weight * numpy.linalg.norm(normal, axis=1).sum()
    return volume, area


def fields_of(points, faces):
    """Fields of points: linear ones, numbers of things; of cells; the groups and numbers."""
    point_fields = {"height": points[:, 2], "flow": points[:, ::-1] - 1}
    cell_fields = {"stress": numpy.arange(len(faces)) / 8, "material": numpy.arange(len(faces)) % 5}
    return point_fields, cell_fields


def write_msh(name, points, faces):
    """MSH 2.2: nodes from 1001 down in twos, elements from 501 up in threes, two groups."""
    point_fields, cell_fields = fields_of(points, faces)
    with open(path(name), "w", encoding="ascii") as file:
        say = lambda *what: print(*what, file=file)
        say("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2")
        say('2 7 "left side"\n2 9 "right"\n$EndPhysicalNames\n$Nodes')
        say(len(points))
        for i, row in enumerate(points):
            say(node_tag(i), *(repr(float(x)) for x in row))
        say("$EndNodes\n$Elements")
        say(len(faces))
        for i, face in enumerate(faces):
            say(cell_tag(i), 2, 2, group(i), 3 + group(i), *(node_tag(k) for k in face))
        say("$EndElements")
        for section, fields, tag in (("Node", point_fields, node_tag),
                                     ("Element", cell_fields, cell_tag)):
            for field, values in fields.items():
                rows = values.reshape(len(values), -1)
                say(f'${section}Data\n1\n"{field}"\n1\n0\n3\n0\n{rows.shape[1]}\n{len(rows)}')
                for i, row in enumerate(rows):
                    say(tag(i), *(repr(float(x)) for x in row))
                say(f"$End{section}Data")


def node_tag(i):
    return 1001 - 2 * i


def cell_tag(i):
    return 501 + 3 * i


def group(i):
    return 7 if i % 2 else 9


# ---- What a file should hold ----

THIRDS = [(0, 0), (3, 0), (0, 3), (1, 0), (2, 0), (2, 1), (1, 2), (0, 2), (0, 1), (1, 1)]
HALVES = [(0, 0), (2, 0), (0, 2), (1, 0), (1, 1), (0, 1)]
NODES = {"-n 1": [(0, 0), (1, 0), (0, 1)], "--order 2": [(u / 2, v / 2) for u, v in HALVES],
         "--order 3": [(u / 3, v / 3) for u, v in THIRDS]}
NODES["--bezier"] = NODES["--order 3"]


class Grid:
    """Elements of one kind, as some program has read them."""

    def __init__(self, points, cells, point_fields, cell_fields):
        self.points, self.cells = numpy.asarray(points), numpy.asarray(cells)
        self.point_fields, self.cell_fields = point_fields, cell_fields


def linear(values, lattice):
    """Of the corners of each element, between them."""
    u, v = numpy.array(lattice).T
    return numpy.einsum("lk,pk...->pl...", numpy.stack([1 - u - v, u, v], 1), values)


class Wanted:
    """The mesh with its fields, and its patches."""

    def __init__(self, source, points, faces):
        write_msh(source, points, faces)
        self.patches, self.corners = patches_of(source)
        self.point_fields, self.cell_fields = fields_of(points, faces)
        self.cell_fields["gmsh:physical"] = [group(i) for i in range(len(faces))]
        self.cell_fields["id"] = [cell_tag(i) for i in range(len(faces))]
        self.corners = faces

    def places(self, option):
        return self.patches if option == "--bezier" else patch_points(self.patches, NODES[option])

    def compare(self, name, grid, option, lost=()):
        """The fields that the format cannot hold, or the program not read, are lost."""
        agree(f"nodes of {name}", grid.points[grid.cells], self.places(option))
        for field, values in self.point_fields.items():
            if field not in lost:
                got = numpy.asarray(grid.point_fields.get(field, []))
                want = linear(values[self.corners], NODES[option])
                agree(f"{field} of {name}", got[grid.cells] if len(got) else got, want)
        for field, values in self.cell_fields.items():
            if field not in lost:
                agree(f"{field} of {name}", grid.cell_fields.get(field, []), values, 0)


# ---- VTK ----

TYPES = {"-n 1": 5, "--order 2": 22, "--order 3": 69, "--bezier": 76}


def vtk_read(name):
    legacy = name.endswith(".vtk")
    reader = (vtk.vtkUnstructuredGridReader if legacy else vtk.vtkXMLUnstructuredGridReader)()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.SetFileName(path(name))
    reader.Update()
    judge(f"VTK reads {name}", not errors)
    return reader.GetOutput()


def vtk_arrays(data):
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())}


def vtk_grid(data):
    cells = vtk_to_numpy(data.GetCells().GetConnectivityArray())
    return Grid(vtk_to_numpy(data.GetPoints().GetData()),
                cells.reshape(data.GetNumberOfCells(), -1),
                vtk_arrays(data.GetPointData()), vtk_arrays(data.GetCellData()))


def vtk_evaluate(data):
    """VTK's points of each cell at the lattice, and its weights of the nodes there."""
    points, weights = [], []
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        for u, v in LATTICE:
            x, w = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
            cell.EvaluateLocation(vtk.reference(0), [u, v, 0.0], x, w)
            points.append(x)
            weights.append(w)
    rows = data.GetNumberOfCells(), len(LATTICE), -1
    return numpy.reshape(points, rows), numpy.reshape(weights, rows)


def check_vtk(source, wanted):
    for extension, (option, cell_type), coding in itertools.product(
            ("vtu", "vtk"), TYPES.items(), ("--text", "--binary")):
        name = f"vtk{cell_type}{coding}.{extension}"
        smooth(source, name, *option.split(), coding)
        data = vtk_read(name)
        judge(f"types of {name}", {data.GetCellType(i) for i in range(data.GetNumberOfCells())}
              == {cell_type})
        grid = vtk_grid(data)
        wanted.compare(name, grid, option)
        judge(f"normals of {name}", "Normals" in grid.point_fields)
        if extension == "vtu":
            judge(f"{name} is shaded by them", data.GetPointData().GetNormals() is not None)
        points, weights = vtk_evaluate(data)
        if cell_type in (69, 76):
            agree(f"surface of {name}", points, patch_points(wanted.patches, LATTICE))
        height = numpy.einsum("plk,pk->pl", weights, grid.point_fields["height"][grid.cells])
        corners = wanted.point_fields["height"][wanted.corners]
        agree(f"height between the nodes of {name}", height, linear(corners, LATTICE))


def check_facets(source, wanted):
    """VTK's own points are in single precision."""
    for name, reader, coding in (
            ("facets.obj", vtk.vtkOBJReader(), ()), ("facets.stl", vtk.vtkSTLReader(), ()),
            ("text.ply", vtk.vtkPLYReader(), ("--text",)),
            ("bytes.ply", vtk.vtkPLYReader(), ("--binary",))):
        smooth(source, name, "-n", "1", *coding)
        reader.SetFileName(path(name))
        reader.Update()
        data = reader.GetOutput()
        corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        points = vtk_to_numpy(data.GetPoints().GetData())
        agree(f"points of {name}", points[corners], wanted.places("-n 1"), SINGLE)


# ---- Gmsh ----


def gmsh_read(name, number):
    """The grid, and the points of each element at the lattice."""
    gmsh.clear()
    gmsh.open(path(name))
    tags, points, _ = gmsh.model.mesh.getNodes()
    row = {int(tag): i for i, tag in enumerate(tags)}
    cells, nodes = gmsh.model.mesh.getElementsByType(number)
    order = numpy.argsort(cells)
    nodes = numpy.array([row[int(tag)] for tag in nodes]).reshape(len(cells), -1)[order]
    lattice = [x for u, v in LATTICE for x in (u, v, 0)]
    surface = gmsh.model.mesh.getJacobians(number, lattice)[2]
    surface = numpy.reshape(surface, (len(cells), len(LATTICE), 3))[order]
    point_fields, cell_fields = gmsh_fields(row, cells[order])
    cell_fields["id"] = cells[order]
    return Grid(points.reshape(-1, 3), nodes, point_fields, cell_fields), surface


def gmsh_fields(row, cells):
    point_fields, cell_fields = {}, {}
    for view in gmsh.view.getTags():
        field = gmsh.option.getString(f"View[{gmsh.view.getIndex(view)}].Name")
        kind, tags, values, _, _ = gmsh.view.getModelData(view, 0)
        values = numpy.array(values).squeeze()
        index = numpy.argsort([row[int(k)] for k in tags] if kind == "NodeData" else tags)
        (point_fields if kind == "NodeData" else cell_fields)[field] = values[index]
    groups = {}
    for dimension, number in gmsh.model.getPhysicalGroups(2):
        for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, number):
            for tags in gmsh.model.mesh.getElements(2, entity)[1]:
                groups.update((int(tag), number) for tag in tags)
    cell_fields["gmsh:physical"] = [groups.get(int(tag)) for tag in cells]
    return point_fields, cell_fields


def check_gmsh(source, wanted):
    for (option, number), coding in itertools.product(
            (("-n 1", 2), ("--order 2", 9), ("--order 3", 21)), ("--text", "--binary")):
        name = f"gmsh{number}{coding}.msh"
        smooth(source, name, *option.split(), coding)
        grid, surface = gmsh_read(name, number)
        wanted.compare(name, grid, option)
        names = [gmsh.model.getPhysicalName(2, k) for k in (7, 9)]
        judge(f"names in {name}", names == ["left side", "right"])
        tags = set(gmsh.model.mesh.getNodes()[0].tolist())
        judge(f"numbers of nodes in {name}",
              {node_tag(i) for i in range(wanted.corners.max() + 1)} <= tags)
        if number == 21:
            agree(f"surface of {name}", surface, patch_points(wanted.patches, LATTICE))


# ---- meshio ----


def meshio_grid(name):
    mesh = meshio.read(path(name))
    fields = {key: values[0] for key, values in mesh.cell_data.items()}
    return Grid(mesh.points, mesh.cells[0].data, mesh.point_data, fields)


def check_meshio(source, wanted):
    """PLY has a column for each component. Of MSH in bytes meshio takes no nodes but 1, 2, 3 and so
    on, of PLY in bytes no fields of faces, and of MSH no numbers of elements."""
    columns, tags = {"flow"}, {"id"}
    for name, option, lost in (
            ("meshio1.vtu", "-n 1", ()), ("meshio1.vtk", "-n 1", ()), ("meshio1.msh", "-n 1", tags),
            ("meshio2.vtu", "--order 2", ()), ("meshio2.vtk", "--order 2", ()),
            ("meshio2.msh", "--order 2", tags), ("meshio3.vtu", "--order 3", ()),
            ("meshio3.msh", "--order 3", tags)):
        for coding in ("--text",) if name.endswith("msh") else ("--text", "--binary"):
            smooth(source, coding + name, *option.split(), coding)
            wanted.compare(coding + name, meshio_grid(coding + name), option, lost)
    smooth(source, "meshio1.ply", "-n", "1", "--text")
    wanted.compare("meshio1.ply", meshio_grid("meshio1.ply"), "-n 1", columns)
    smooth(source, "meshio.stl", "-n", "1")
    grid = meshio_grid("meshio.stl")
    agree("nodes of meshio.stl", grid.points[grid.cells], wanted.places("-n 1"), SINGLE)


# ---- OpenCASCADE ----


def occ_measure(source, *options):
    """Of each solid its volume; of all faces the area and the number; of edges, the numbers of those
    with one face and with two."""
    smooth(source, "occ.step", *options)
    gmsh.clear()
    gmsh.model.occ.importShapes(path("occ.step"))
    gmsh.model.occ.synchronize()
    volumes = sorted(gmsh.model.occ.getMass(3, tag) for _, tag in gmsh.model.getEntities(3))
    area = sum(gmsh.model.occ.getMass(2, tag) for _, tag in gmsh.model.getEntities(2))
    edges = [len(gmsh.model.getAdjacencies(1, tag)[0]) for _, tag in gmsh.model.getEntities(1)]
    return volumes, area, len(gmsh.model.getEntities(2)), (edges.count(1), edges.count(2))


def check_step(name, mesh, solids, *options):
    """The faces close around the solids, which have the volumes; the area is that of all. Each face
    has a side without length, where its surface degenerates, which is no other face's."""
    write_obj("step.obj", *mesh)
    patches, _ = patches_of("step.obj", *options)
    volume, area = measure(patches)
    volumes, got_area, faces, edges = occ_measure("step.obj", *options)
    judge(f"solids of {name}", len(volumes) == solids)
    judge(f"faces of {name}", faces == len(patches))
    agree(f"area of {name}", got_area / area, 1, 1e-5)
    if solids:
        agree(f"volume of {name}", sum(volumes) / abs(volume), 1, 1e-5)
        judge(f"{name} is closed", edges == (faces, 3 * faces // 2))
    else:
        judge(f"{name} is one sheet", edges[0] > faces and edges[1] > faces)


def united(*meshes):
    """The meshes side by side, in one file."""
    before = numpy.cumsum([0] + [len(mesh[0]) for mesh in meshes[:-1]])
    points, normals, faces = zip(*meshes)
    return (numpy.concatenate(points), numpy.concatenate(normals),
            numpy.concatenate([f + n for f, n in zip(faces, before)]))


def turned(mesh):
    return mesh[0], -mesh[1], mesh[2][:, ::-1]


def scaled(mesh, factor, by=0.0):
    return factor * mesh[0] + by, mesh[1], mesh[2]


def check_occ():
    ball, ring = sphere(2), torus(16, 10)
    for rule in ("paper", "arc"):
        check_step(f"the sphere by {rule}", ball, 1, "--rule", rule)
        check_step(f"the torus by {rule}", ring, 1, "--rule", rule)
    check_step("the sphere turned inside out", turned(ball), 1)
    check_step("the sphere with a cavity", united(ball, turned(scaled(ball, 0.5))), 1)
    check_step("two spheres", united(ball, scaled(ball, 0.5, 3.0)), 2)
    half = numpy.concatenate([ring[2][:60], ring[2][160:220]])
    check_step("a part of the torus", (ring[0], ring[1], half), 0)
    check_cut(sphere(1))


def check_cut(mesh):
    """A solid that is valid can be cut."""
    write_obj("step.obj", *mesh)
    volumes = occ_measure("step.obj")[0]
    box = gmsh.model.occ.addBox(0.01, -9, -9, 18, 18, 18)
    parts = gmsh.model.occ.fragment([(3, tag) for _, tag in gmsh.model.getEntities(3)],
                                    [(3, box)])[1][0]
    judge("the sphere falls in two", len(parts) == 2)
    got = sum(gmsh.model.occ.getMass(*part) for part in parts)
    agree("volume of the parts", got / volumes[0], 1, 1e-5)


# ---- The program on a terminal ----


def check_terminal(source):
    """It tells how far it is to a terminal alone; interrupted, it leaves nothing."""
    command = [SMOOTH, path(source), "-n", "150", "--text", "-o"]
    terminal, its_stderr = os.openpty()
    with subprocess.Popen(command + [path("pipe.msh")], stderr=subprocess.PIPE) as silent:
        with subprocess.Popen(command + [path("terminal.msh")], stderr=its_stderr) as telling:
            said, end = b"", time.monotonic() + 60
            while b"writing" not in said and time.monotonic() < end:
                if select.select([terminal], [], [], 1)[0]:
                    said += os.read(terminal, 1000)
            judge("progress is told to a terminal", b"smooth: writing" in said and b"\n" not in said)
            judge("a file on its way has another name", os.path.exists(path("terminal.msh.part0")))
            for process in (silent, telling):
                process.send_signal(signal.SIGINT)
                process.wait()
                judge("an interrupt ends it", process.returncode == -signal.SIGINT)
        judge("nothing is told to a pipe", silent.stderr.read() == b"")
    judge("nothing is left", not [f for f in os.listdir(FOLDER) if f.startswith(("pipe", "term"))])


os.makedirs(FOLDER, exist_ok=True)
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
_points, _, _faces = torus(14, 9)
_wanted = Wanted("mesh.msh", _points, _faces)
check_vtk("mesh.msh", _wanted)
check_facets("mesh.msh", _wanted)
check_gmsh("mesh.msh", _wanted)
check_meshio("mesh.msh", _wanted)
check_occ()
check_terminal("mesh.msh")
print("{passed} passed, {failed} failed".format(**counts))
sys.exit(counts["failed"] > 0)
