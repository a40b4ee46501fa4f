# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The small files that the scenes of tools/compare-frames draw, made by VTK alone."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkRectilinearGrid,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkElevationFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import (
    vtkConeSource,
    vtkCubeSource,
    vtkPlaneSource,
    vtkSphereSource,
    vtkSuperquadricSource,
)
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOParallelXML import (
    vtkXMLPImageDataWriter,
    vtkXMLPPolyDataWriter,
    vtkXMLPUnstructuredGridWriter,
)
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLRectilinearGridWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
# Files that no reader accepts, or only in part.
BROKEN = {
    "empty.off": "",
    "words.off": "this is no mesh\n",
    "missing.off": "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
    "huge.off": "OFF\n3 1 0\n0 0 0\n1e20 0 0\n0 1 0\n3 0 1 2\n",
    "infinite.off": "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\nnan 1 0\n3 0 1 2\n3 1 3 2\n",
    "cut.stl": "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0",
    "cut.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n",
    "table.vtk": "# vtk DataFile Version 3.0\nt\nASCII\nDATASET TABLE\nROW_DATA 1\nFIELD f 1\n"
    "a 1 1 float\n1\n",
    "lost.obj": "mtllib nowhere.mtl\n" + SQUARE + "usemtl a\nf 1/1 2/2 3/3 4/4\n",
    "lost.gltf": '{"asset": {"version": "2.0"}, "buffers": [{"uri": "nowhere.bin", '
    '"byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": '
    '[{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], '
    '"max": [1, 1, 0]}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], '
    '"nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}',
    "cut.png": "\x89PNG",
    "cut.bvh": "HIERARCHY\nROOT a\n{\n",
}


def write(writer, path, data):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    if hasattr(writer, "SetDataModeToAscii"):
        writer.SetDataModeToAscii()
    writer.Write()


def output(source):
    source.Update()
    return source.GetOutput()


def add(data, name, values, active=False):
    """Adds an array to a dataset's points or cells (GetPointData() or GetCellData())."""
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (data.SetScalars if active else data.AddArray)(array)


def things():
    """Ball, cone and ring over the ground, with arrays of points and of cells."""
    ball = vtkSphereSource()
    ball.SetCenter(-1.1, 0.6, 0.4)
    ball.SetRadius(0.6)
    ball.SetThetaResolution(40)
    ball.SetPhiResolution(40)
    cone = vtkConeSource()
    cone.SetCenter(1.2, 0.6, 0.6)
    cone.SetDirection(0, 1, 0)
    cone.SetHeight(1.2)
    cone.SetRadius(0.5)
    cone.SetResolution(32)
    ring = vtkSuperquadricSource()
    ring.ToroidalOn()
    ring.SetThickness(0.4)
    ring.SetSize(0.8)
    ring.SetCenter(0.1, 0.8, -0.9)
    ring.SetThetaResolution(40)
    ring.SetPhiResolution(40)
    together = vtkAppendPolyData()
    for source in (ball, cone, ring):
        together.AddInputConnection(source.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(together.GetOutputPort())
    mesh = vtkPolyData()
    mesh.ShallowCopy(output(triangles))
    for arrays in (mesh.GetPointData(), mesh.GetCellData()):
        arrays.Initialize()
    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    cells = numpy.arange(mesh.GetNumberOfCells())
    paint = numpy.clip(90 + 40 * places, 0, 255)
    add(mesh.GetPointData(), "paint", numpy.uint8(paint), active=True)
    add(mesh.GetPointData(), "height", places[:, 1])
    add(mesh.GetPointData(), "flow", numpy.float32(places[:, ::-1] * (1, -2, 0.5)))
    add(mesh.GetPointData(), "value", numpy.sin(4 * places[:, 0]))
    add(mesh.GetPointData(), "depth", places[:, 2])
    add(mesh.GetCellData(), "zone", numpy.int32(cells % 7))
    add(mesh.GetCellData(), "value", numpy.float64(cells) / len(cells))
    return mesh


def plane(origin, first, second):
    source = vtkPlaneSource()
    source.SetOrigin(*origin)
    source.SetPoint1(*first)
    source.SetPoint2(*second)
    return output(source)


def glass():
    """Two panes of coloured glass, one behind the other."""
    together = vtkAppendPolyData()
    for z in (1.5, 1.9):
        together.AddInputData(plane((z - 2.2, 0.1, z), (z - 0.6, 0.1, z), (z - 2.2, 1.4, z)))
    mesh = vtkPolyData()
    mesh.ShallowCopy(output(together))
    half = mesh.GetNumberOfPoints() // 2
    colors = numpy.repeat(numpy.uint8([(230, 60, 40, 110), (40, 120, 240, 150)]), half, axis=0)
    add(mesh.GetPointData(), "glass", colors, active=True)
    return mesh


def wires():
    """Lines and single points."""
    mesh = vtkPolyData()
    turn = numpy.linspace(0, 6 * numpy.pi, 120)
    places = vtkPoints()
    for t in turn:
        places.InsertNextPoint(numpy.cos(t), 0.1 * t, numpy.sin(t))
    mesh.SetPoints(places)
    mesh.AllocateEstimate(60, 60)
    for i in range(59):
        mesh.InsertNextCell(3, 2, [i, i + 1])
    for i in range(60, 120):
        mesh.InsertNextCell(1, 1, [i])
    add(mesh.GetPointData(), "turn", turn, active=True)
    return mesh


def points(places, **arrays):
    data = vtkPolyData()
    at = vtkPoints()
    at.SetData(numpy_to_vtk(numpy.array(places, float), deep=True))
    data.SetPoints(at)
    for name, values in arrays.items():
        add(data.GetPointData(), name, numpy.array(values, float))
    return data


def wave():
    """An image of a wave with arrays of points and of cells, as VTK's other grids have them too."""
    image = vtkImageData()
    image.SetDimensions(9, 8, 7)
    image.SetSpacing(0.25, 0.2, 0.3)
    x, y, z = numpy.meshgrid(*map(numpy.arange, (9, 8, 7)), indexing="ij")
    add(image.GetPointData(), "wave", numpy.sin(x + 0.5 * y - z).ravel("F"), active=True)
    add(image.GetCellData(), "cells", numpy.arange(8.0 * 7 * 6))
    return image


def grids(image):
    """Rectilinear, structured and unstructured grids with the arrays of an image."""
    regular = vtkRectilinearGrid()
    regular.SetDimensions(image.GetDimensions())
    curved = vtkStructuredGrid()
    curved.SetDimensions(image.GetDimensions())
    cells = vtkUnstructuredGrid()
    places = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    bent = places + 0.2 * numpy.sin(2 * places[:, ::-1])
    for axis, count in zip("XYZ", image.GetDimensions()):
        step = numpy_to_vtk(numpy.arange(count) ** 1.2 * 0.2, deep=True)
        getattr(regular, f"Set{axis}Coordinates")(step)
    for grid in (curved, cells):
        at = vtkPoints()
        at.SetData(numpy_to_vtk(bent, deep=True))
        grid.SetPoints(at)
    columns, rows, layers = image.GetDimensions()
    cells.Allocate(image.GetNumberOfCells())
    order = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    order += [(i, j, 1) for i, j, _ in order]
    for k in range(layers - 1):
        for j in range(rows - 1):
            for i in range(columns - 1):
                corner = [(i + a) + columns * ((j + b) + rows * (k + c)) for a, b, c in order]
                cells.InsertNextCell(VTK_HEXAHEDRON, 8, corner)
    for grid in (regular, curved, cells):
        grid.GetPointData().ShallowCopy(image.GetPointData())
        grid.GetCellData().ShallowCopy(image.GetCellData())
    return regular, curved, cells


def blocks():
    """A cube, an empty block, and a cube and a ball in a block of their own."""
    cube, other, ball = vtkCubeSource(), vtkCubeSource(), vtkSphereSource()
    other.SetCenter(1.5, 0.3, 0)
    ball.SetCenter(0.7, 1.2, 0)
    inner = vtkMultiBlockDataSet()
    inner.SetBlock(0, output(other))
    inner.SetBlock(1, output(ball))
    outer = vtkMultiBlockDataSet()
    outer.SetBlock(0, output(cube))
    outer.SetBlock(1, None)
    outer.SetBlock(2, inner)
    return outer


def picture(path, values):
    """A PNG of values (rows, columns[, 3]), the first row at the bottom."""
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    flat = numpy.ascontiguousarray(values).reshape(values.shape[0] * values.shape[1], -1)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.uint8(flat), deep=True))
    write(vtkPNGWriter(), path, image)


def pictures(folder):
    y, x = numpy.mgrid[0:64, 0:64] / 64
    heights = 0.5 + 0.25 * numpy.sin(4 * numpy.pi * x) * numpy.sin(6 * numpy.pi * y)
    picture(folder / "heights.png", 255 * heights)
    slopes = numpy.gradient(20 * heights)
    normal = numpy.stack([-slopes[1], -slopes[0], numpy.ones_like(x)], axis=-1)
    normal /= numpy.linalg.norm(normal, axis=-1, keepdims=True)
    picture(folder / "normals.png", 127.5 * (normal + 1))
    checks = (numpy.floor(8 * x) + numpy.floor(8 * y)) % 2
    picture(folder / "checks.png", numpy.stack([255 * checks, 255 * x, 255 * y], axis=-1))
    sky, turn = numpy.mgrid[0:32, 0:64] / 32
    sky = numpy.stack([sky, sky**2, 0.5 + 0.5 * numpy.cos(numpy.pi * turn)], axis=-1)
    picture(folder / "sky.png", 40 + 200 * sky)


def texts(folder):
    """Meshes written by hand, including broken ones."""
    for name, text in BROKEN.items():
        (folder / name).write_text(text, encoding="latin-1")
    (folder / "materials.mtl").write_text(
        "newmtl stone\nKd 0.7 0.6 0.5\nKs 0.4 0.4 0.4\nNs 40\nmap_Kd -s 2 2 -o 0.25 0 checks.png\n"
        "newmtl pane\nKd 0.2 0.5 0.9\nd 0.4\nnewmtl bright\nKd 0.9 0.4 0.1\nKe 0.2 0.1 0\n"
    )
    shifted = "v 2 0 0.5\nv 3 0 0\nv 3 1 0.5\nv 2 1 0\nv 0.3 0.2 1\nv 2.4 0.2 1\nv 1.2 1.3 1\n"
    (folder / "materials.obj").write_text(
        "mtllib materials.mtl\n" + SQUARE + shifted + "usemtl stone\nf 1/1 2/2 3/3 4/4\n"
        "usemtl bright\nf 5 6 7\nf 5 7 8\nusemtl pane\nf 9 10 11\n"
    )


def make(folder):
    """Writes all files into the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    ground = plane((-3, 0, 3), (3, 0, 3), (-3, 0, -3))
    add(ground.GetPointData(), "paint", numpy.full((4, 3), (95, 95, 110), numpy.uint8), active=True)
    mesh = things()
    for name, data in (
        ("ground", ground), ("things", mesh), ("glass", glass()), ("wires", wires()),
        ("lamps", points(
            [(-1.6, 1.2, 1.6), (0.4, 0.5, 1.1), (2, 1.6, -0.6), (-0.4, 2.2, -0.4), (0, 0.3, 2.2)],
            radius=[2.5, 1.6, 3, 2, 1.2], intensity=[1, 1.4, 0.8, 1, 2], casts=[1, 0, 1, 0, 1],
            color=[(1, 0.5, 0.2), (0.2, 1, 0.4), (0.4, 0.5, 1), (1, 1, 0.6), (1, 0.2, 0.7)])),
        ("fog", points(
            [(-1, 0.5, 1), (0.6, 0.3, 0.8), (1.4, 0.8, -0.5)], radius=[1, 0.7, 1.2],
            density=[0.9, 1.4, 0.5], color=[(0.8, 0.8, 0.9), (0.9, 0.7, 0.5), (0.5, 0.9, 0.6)])),
        ("markers", points(
            [(-1.1, 0.6, 0.4), (1.2, 0.2, 1.1), (0.1, 0.9, -0.4)], radius=[0.9, 0.7, 0.5],
            width=[0.3, 0.1, 0.2], reach=[2, 4, 3], opacity=[0.9, 0.6, 0.7],
            color=[(1, 0.4, 0), (0, 1, 0.4), (0.3, 0.4, 1)])),
    ):  # fmt: skip
        write(vtkXMLPolyDataWriter(), folder / f"{name}.vtp", data)
    stray = vtkPolyData()
    stray.DeepCopy(mesh)
    vtk_to_numpy(stray.GetPoints().GetData())[::50] = numpy.nan
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(folder / "infinite.vtp"))
    writer.SetInputData(stray)
    writer.SetDataModeToBinary()  # VTK does not read NaN as text
    writer.Write()
    text = (folder / "things.vtp").read_text()
    (folder / "cut.vtp").write_text(text[: len(text) // 2])
    write(vtkSTLWriter(), folder / "things.stl", mesh)
    write(vtkPLYWriter(), folder / "things.ply", mesh)
    write(vtkXMLPPolyDataWriter(), folder / "things.pvtp", mesh)
    image = wave()
    regular, curved, cells = grids(image)
    for name, writer, data in (
        ("wave.vti", vtkXMLImageDataWriter, image), ("wave.pvti", vtkXMLPImageDataWriter, image),
        ("wave.vtr", vtkXMLRectilinearGridWriter, regular), ("wave.vtk", vtkDataSetWriter, curved),
        ("wave.vts", vtkXMLStructuredGridWriter, curved),
        ("wave.vtu", vtkXMLUnstructuredGridWriter, cells),
        ("wave.pvtu", vtkXMLPUnstructuredGridWriter, cells),
        ("blocks.vtm", vtkXMLMultiBlockDataWriter, blocks()),
    ):  # fmt: skip
        write(writer(), folder / name, data)
    elevation = vtkElevationFilter()
    elevation.SetInputData(output(vtkSphereSource()))
    write(vtkDataSetWriter(), folder / "ball.vtk", output(elevation))
    pictures(folder)
    texts(folder)
