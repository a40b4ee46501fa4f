# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data that few files have: nonlinear cells, lines beside polygons, bits, very small scenes."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkBitArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    vtkCellArray,
    vtkPolyData,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOXML import (
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)

from cli import CliTest, main, read_png

FRONT = ["--camera", "0,0,10,0,0,0,0,1,0", "--size", "120x120"]
CORNERS = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))


class Data(CliTest):
    def write(self, writer, name, data):
        writer.SetFileName(str(self.folder / name))
        writer.SetInputData(data)
        writer.SetDataModeToBinary()  # newer expats make Python's VTK refuse appended data
        writer.Write()

    def write_grid(self):
        """A tetrahedron, one with nodes on its edges, and a cube, side by side; `kind` counts."""
        grid, points = vtkUnstructuredGrid(), vtkPoints()
        middles = [(CORNERS[a] + CORNERS[b]) / 2 for a, b in EDGES]
        cube = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        for i, (kind, corners) in enumerate((
            (VTK_TETRA, CORNERS),
            (VTK_QUADRATIC_TETRA, [*CORNERS, *middles]),
            (VTK_HEXAHEDRON, cube),
        )):  # fmt: skip
            ids = [points.InsertNextPoint(numpy.add(p, (1.5 * i - 2, -0.5, 0))) for p in corners]
            grid.InsertNextCell(kind, len(ids), ids)
        grid.SetPoints(points)
        kinds = numpy_to_vtk(numpy.arange(3, dtype=float), deep=True)
        kinds.SetName("kind")
        grid.GetCellData().AddArray(kinds)
        self.write(vtkXMLUnstructuredGridWriter(), "grid.vtu", grid)

    def write_mesh(self, lines=True, name="mesh.vtp"):
        """A square and, above it, a line and a vertex; bits at the points."""
        mesh, points = vtkPolyData(), vtkPoints()
        for place in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, 1.5), (1, 1.5), (0, 1.8)):
            points.InsertNextPoint(*place, 0)
        mesh.SetPoints(points)
        for cells, take in (([0, 1, 2, 3], mesh.SetPolys), ([4, 5], mesh.SetLines),
                            ([6], mesh.SetVerts)):  # fmt: skip
            array = vtkCellArray()
            array.InsertNextCell(len(cells), cells)
            if lines or take == mesh.SetPolys:
                take(array)
        bits = vtkBitArray()
        bits.SetName("bits")
        for i in range(points.GetNumberOfPoints()):
            bits.InsertNextValue(i % 2)
        mesh.GetPointData().SetScalars(bits)
        self.write(vtkXMLPolyDataWriter(), name, mesh)

    def test_numbers_of_nonlinear_cells(self):
        self.write_grid()
        self.relievo("render", "grid.vtu", "--size", "200x100", "--exr", "a.exr",
                     "--layers", "vtkOriginalCellIds,kind")  # fmt: skip
        channels = self.exr("a.exr")[1]
        ids, kinds = channels["vtkOriginalCellIds.V"], channels["kind.V"]
        seen = numpy.isfinite(kinds)
        self.assertEqual(set(kinds[seen]), {0, 1, 2})
        numpy.testing.assert_array_equal(ids[seen], kinds[seen])

    def test_lines_beside_polygons(self):
        """Lines and vertices are lit; a mesh of polygons alone is smoothed as before."""
        self.write_mesh()
        done = self.relievo("render", "mesh.vtp", *FRONT, "--exr", "a.exr", "--layers", "cell",
                            "--background", "blue")  # fmt: skip
        self.assertIn("mesh.vtp: drawn without smooth normals", done.stderr)
        channels = self.exr("a.exr")[1]
        for cell in (0, 1, 2):  # the vertex, the line, the square
            shown = channels["cell.id"] == cell
            self.assertGreater(shown.sum(), 0, cell)
            self.assertGreater(channels["R"][shown].min(), 0.9, cell)
        self.write_mesh(lines=False, name="square.vtp")
        done = self.relievo("render", "square.vtp", *FRONT, "--png", "a.png")
        self.assertEqual(done.stderr, "")

    def test_bits(self):
        """VTK has no colours for them: the mesh is drawn without."""
        self.write_mesh()
        self.relievo("render", "mesh.vtp", *FRONT, "--png", "a.png")
        self.assertGreater(read_png(self.folder / "a.png")[60, 60].min(), 250)
        self.before = self.names()
        self.refused("render", "mesh.vtp", "--color-by", "bits", "--png", "b.png", status=2,
                     says=["--color-by", "'bits'"])  # fmt: skip

    def test_large_whole_numbers(self):
        """Numbers that floats round are written all the same, with a warning."""
        self.write_mesh(lines=False)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "mesh.vtp"))
        reader.Update()
        for number, warned in ((2**24 + 1, True), (2**24, False)):
            ids = numpy_to_vtk(numpy.array([number]), deep=True)
            ids.SetName("id")
            reader.GetOutput().GetCellData().AddArray(ids)
            self.write(vtkXMLPolyDataWriter(), "ids.vtp", reader.GetOutput())
            done = self.relievo("render", "ids.vtp", *FRONT, "--layers", "id", "--exr", "a.exr")
            self.assertEqual("warning: " in done.stderr, warned, done.stderr)
            self.assertEqual("16777217" in done.stderr and "'a.exr'" in done.stderr, warned)
            self.assertEqual(self.exr("a.exr")[1]["id.V"][60, 60], 2**24)

    def test_hidden_cells(self):
        """Cells hidden by vtkGhostType are not drawn, and the surfaces behind them are; others
        keep their numbers."""
        def hide(data, hidden):
            flags = numpy_to_vtk(numpy.array([32 * (i == hidden) for i in range(2)], numpy.uint8),
                                 deep=True)  # fmt: skip
            flags.SetName("vtkGhostType")
            data.GetCellData().AddArray(flags)
            return data

        points = vtkPoints()
        for z in (-1, 0, 1):
            for y in (-1, 1):
                for x in (-1, 1):
                    points.InsertNextPoint(x, y, z)
        mesh = vtkPolyData()
        mesh.SetPoints(points)
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        faces = vtkCellArray()
        for low in (0, 4):
            faces.InsertNextCell(4, [low + i for i in (4, 5, 7, 6)])
            ids = vtkIdList()
            for i in (0, 1, 3, 2, 4, 5, 7, 6):
                ids.InsertNextId(low + i)
            grid.InsertNextCell(12, ids)
        mesh.SetPolys(faces)
        blocks = vtkStructuredGrid()
        blocks.SetDimensions(2, 2, 3)
        blocks.SetPoints(points)
        for name, data, writer in (("a.vtp", mesh, vtkXMLPolyDataWriter),
                                   ("a.vtu", grid, vtkXMLUnstructuredGridWriter),
                                   ("a.vts", blocks, vtkXMLStructuredGridWriter)):  # fmt: skip
            for hidden, depth in ((1, 5), (0, 4), (2, 4)):
                self.write(writer(), name, hide(data, hidden))
                done = self.relievo("render", name, "--camera", "0,0,5,0,0,0,0,1,0", "--exr",
                                    "a.exr", "--layers", "depth,vtkOriginalCellIds,vtkGhostType"
                                    if hidden < 2 else "depth")  # fmt: skip
                with self.subTest(name=name, hidden=hidden):
                    self.assertEqual(done.stderr, "")
                    seen = self.exr("a.exr")[1]
                    middle = tuple(n // 2 for n in seen["depth.Z"].shape)
                    self.assertAlmostEqual(seen["depth.Z"][middle], depth, places=5)
                    if hidden < 2:
                        self.assertEqual(seen["vtkOriginalCellIds.V"][middle], 1 - hidden)

    def test_infinite_points(self):
        """As VTK's own writer has them, with ranges that its reader does not know."""
        self.write_mesh(lines=False)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "mesh.vtp"))
        reader.Update()
        reader.GetOutput().GetPoints().SetPoint(4, numpy.inf, 0, 0)
        reader.GetOutput().GetPoints().Modified()
        self.write(vtkXMLPolyDataWriter(), "infinite.vtp", reader.GetOutput())
        text = (self.folder / "infinite.vtp").read_text()
        self.assertRegex(text, r"(?s)L2_NORM_RANGE.*inf\b")
        done = self.relievo("render", "infinite.vtp", *FRONT, "--png", "a.png")
        self.assertIn("infinite.vtp: left out 0 cells", done.stderr)
        self.assertGreater(read_png(self.folder / "a.png")[60, 60].min(), 250)

    def test_small_parallel(self):
        """The clipping range is that of the scale that is drawn with."""
        for size in (7e-6, 1e-3):
            (self.folder / "small.off").write_text(
                f"OFF\n3 1 0\n{-size} {-size} 0\n{size} {-size} 0\n{-size} {size} 0\n3 0 1 2\n"
            )
            for camera in ([], ["--camera", f"0,0,{5 * size},0,0,0,0,1,0"]):
                self.relievo("render", "small.off", *camera, "--parallel-scale", 1.5 * size,
                             "--size", "60x60", "--exr", "a.exr")  # fmt: skip
                covered = numpy.isfinite(self.exr("a.exr")[1]["depth.Z"]).mean()
                self.assertAlmostEqual(covered, 2 / 9, delta=0.02, msg=f"{size}, {camera}")


if __name__ == "__main__":
    main()
