# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons that are not convex, in every format that has polygons: the inside by even and odd
crossings is drawn, measured and shadowed, whatever corner comes first."""

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYGON,
    vtkCellArray,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from cli import CliTest, main, read_png

SIDE = 200
# Seen from above, at one pixel for each hundredth.
LOOK = ["--camera", "0.0013,0.0017,9,0.0013,0.0017,0,0,1,0", "--clip", "1,20",
        "--parallel-scale", "1", "--size", f"{SIDE}x{SIDE}"]  # fmt: skip
L = numpy.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]) * 0.8 - 0.75
ANGLES = 2 * numpy.pi * numpy.arange(12) / 12
PINWHEEL = numpy.stack([numpy.cos(ANGLES), numpy.sin(ANGLES)], axis=1) * 0.9
PINWHEEL[::2] *= 0.3  # no corner sees all others
U = numpy.array([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]) * 0.5 - 0.75


def centres():
    steps = (numpy.arange(SIDE) + 0.5) / (SIDE / 2) - 1
    x, y = numpy.meshgrid(steps + 0.0013, -steps + 0.0017)
    return x, y


def is_inside(polygon):
    x, y = centres()
    inside = numpy.zeros(x.shape, dtype=bool)
    for (ax, ay), (bx, by) in zip(polygon, numpy.roll(polygon, -1, axis=0)):
        if ay != by:
            crosses = (ay > y) != (by > y)
            inside ^= crosses & (x < ax + (y - ay) / (by - ay) * (bx - ax))
    return inside


def make_obj(points, polygons):
    faces = [" ".join(str(i + 1) for i in polygon) for polygon in polygons]
    places = "".join("v {} {} {}\n".format(*point) for point in points)
    return places + "".join(f"f {face}\n" for face in faces)


def make_off(points, polygons):
    places = "".join("{} {} {}\n".format(*point) for point in points)
    faces = "".join(f"{len(each)} {' '.join(map(str, each))}\n" for each in polygons)
    return f"OFF\n{len(points)} {len(polygons)} 0\n{places}{faces}"


def make_ply(points, polygons):
    head = (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\n"
            f"property double y\nproperty double z\nelement face {len(polygons)}\n"
            "property list uchar int vertex_indices\nend_header\n")  # fmt: skip
    return head + make_off(points, polygons).split("\n", 2)[2]


def make_polydata(points, polygons):
    mesh, corners, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    corners.SetDataTypeToDouble()
    for point in points:
        corners.InsertNextPoint(*point)
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    mesh.SetPoints(corners)
    mesh.SetPolys(cells)
    return mesh


class Polygons(CliTest):
    def write(self, name, points, polygons):
        path, ending = self.folder / name, name.rsplit(".")[-1]
        makers = {"obj": make_obj, "off": make_off, "ply": make_ply}
        if ending in makers:
            path.write_text(makers[ending](points, polygons))
            return
        data = make_polydata(points, polygons)
        if ending == "vtu":
            grid = vtkUnstructuredGrid()
            grid.SetPoints(data.GetPoints())
            for polygon in polygons:
                grid.InsertNextCell(VTK_POLYGON, len(polygon), polygon)
            data = grid
        elif ending == "vtm":
            blocks = vtkMultiBlockDataSet()
            blocks.SetBlock(0, data)
            data = blocks
        writer = {
            "vtk": vtkPolyDataWriter,
            "vtp": vtkXMLPolyDataWriter,
            "vtu": vtkXMLUnstructuredGridWriter,
            "vtm": vtkXMLMultiBlockDataWriter,
        }[ending]()
        writer.SetFileName(str(path))
        writer.SetInputData(data)
        if ending != "vtk":
            writer.SetDataModeToAscii()
        writer.Write()

    def check_picture(self, name, outline):
        self.relievo("render", name, *LOOK, "--png", "a.png", "--exr", "a.exr",
                     "--layers", "depth,cell")  # fmt: skip
        inside, seen = is_inside(outline), self.exr("a.exr")[1]
        numpy.testing.assert_array_equal(read_png(self.folder / "a.png").max(axis=2) > 0, inside)
        numpy.testing.assert_array_equal(numpy.isfinite(seen["depth.Z"]), inside)
        numpy.testing.assert_array_equal(seen["cell.id"] == 0, inside)

    def test_formats(self):
        for outline in (L, PINWHEEL):
            points = numpy.column_stack([outline, numpy.zeros(len(outline))])
            ids = numpy.roll(range(len(outline)), -1)
            for ending in ("obj", "off", "ply", "vtk", "vtp", "vtu", "vtm"):
                with self.subTest(ending=ending, corners=len(outline)):
                    self.write("a." + ending, points, [ids])
                    self.check_picture("a." + ending, outline)

    def test_corners(self):
        """Every corner first, both windings."""
        for outline in (L, U):
            points = numpy.column_stack([outline, numpy.zeros(len(outline))])
            for start in range(len(outline)):
                for winding in (1, -1):
                    ids = numpy.roll(range(len(outline)), -start)[::winding]
                    self.write("a.off", points, [ids])
                    self.check_picture("a.off", outline)

    def test_numbers(self):
        """Cells keep the numbers and the data of their polygons, beside others and by material."""
        outlines = [PINWHEEL * 0.4371 + (x, y) for y in (-0.4983, 0.5041) for x in (-0.5, 0.5)]
        points = numpy.column_stack([numpy.concatenate(outlines), numpy.zeros(48)])
        polygons = [range(12 * i, 12 * i + 12) for i in range(4)]
        self.write("a.off", points, polygons)
        self.relievo("render", "a.off", *LOOK, "--exr", "a.exr", "--layers", "cell")
        cells = self.exr("a.exr")[1]["cell.id"]
        for i, outline in enumerate(outlines):
            numpy.testing.assert_array_equal(cells == i, is_inside(outline))
        faces = make_obj(points, polygons).replace("f ", "usemtl a\nf ").split("usemtl a\n")
        for i in (2, 4):
            faces[i] = "usemtl b\n" + faces[i]
        faces[1], faces[3] = "usemtl a\n" + faces[1], "usemtl a\n" + faces[3]
        (self.folder / "a.mtl").write_text("newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 1\n")
        (self.folder / "b.obj").write_text("mtllib a.mtl\n" + "".join(faces))
        self.relievo("render", "b.obj", *LOOK, "--exr", "a.exr",
                     "--layers", "actor,cell,vtkOriginalCellIds,albedo")  # fmt: skip
        seen = self.exr("a.exr")[1]
        for i, outline in enumerate(outlines):
            inside = is_inside(outline)
            for name, value in (("vtkOriginalCellIds.V", i), ("actor.id", i % 2),
                                ("cell.id", i // 2), ("albedo.R", 1 - i % 2),
                                ("albedo.B", i % 2)):  # fmt: skip
                self.assertEqual(set(seen[name][inside]), {value}, name)

    def test_shadows(self):
        """From straight above: the floor is lit exactly where it is not covered."""
        for outline in (L, PINWHEEL):
            corners = numpy.column_stack([outline, numpy.ones(len(outline))])
            floor = [(-3, -3, 0), (3, -3, 0), (3, 3, 0), (-3, 3, 0)]
            self.write("a.off", [*floor, *corners],
                       [range(4), 4 + numpy.roll(range(len(outline)), -1)])  # fmt: skip
            inside = is_inside(outline)
            for method in ("map", "exact"):
                # A slanted sun moves the shadow by a half.
                self.relievo("render", "a.off", *LOOK, "--light", "sun:0.5,0,1",
                             "--shading", "flat", "--shadows", method, "--exr", "a.exr",
                             "--layers", "cell,shadow_0")  # fmt: skip
                seen = self.exr("a.exr")[1]
                numpy.testing.assert_array_equal(seen["cell.id"] == 1, inside)
                dark = (seen["shadow_0.V"] < 0.5) & (seen["cell.id"] == 0)
                truth = is_inside(outline - (0.5, 0)) & ~inside
                mismatches = (dark != truth) & ~inside
                most = 0 if method == "exact" else 0.02 * truth.sum()
                self.assertGreater(truth.sum(), 2000)
                self.assertLessEqual(mismatches.sum(), most, method)


if __name__ == "__main__":
    main()
