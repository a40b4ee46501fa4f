# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkRelievoConvexPolygons: the fans that VTK draws cover a polygon once, and nothing else. The
inside is defined by the number of edges that a ray crosses (even or odd).
vtkRelievoPointNormals: the normals of such meshes."""

import time
import unittest

import numpy
import relievo
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
FRAMES = {
    "z": numpy.eye(3),
    "-z": numpy.array([(0, 1, 0), (1, 0, 0), (0, 0, -1)]),
    "x": numpy.array([(0, 1, 0), (0, 0, 1), (1, 0, 0)]),
    "slanted": numpy.linalg.qr(numpy.random.default_rng(1).normal(size=(3, 3)))[0],
}


def mesh_of(points, polygons, kind=VTK_DOUBLE):
    mesh, corners, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    corners.SetDataType(kind)
    for point in points:
        corners.InsertNextPoint(*point)
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    mesh.SetPoints(corners)
    mesh.SetPolys(cells)
    return mesh


def cut(mesh):
    step = relievo.vtkRelievoConvexPolygons()
    step.SetInputData(mesh)
    step.Update()
    return step.GetOutput(), step


def polygons_of(mesh):
    starts = vtk_to_numpy(mesh.GetPolys().GetOffsetsArray())
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    return [corners[a:b] for a, b in zip(starts, starts[1:])]


def is_inside(polygon, places):
    """Even or odd."""
    polygon = numpy.asarray(polygon, dtype=float)
    inside = numpy.zeros(len(places), dtype=bool)
    for (ax, ay), (bx, by) in zip(polygon, numpy.roll(polygon, -1, axis=0)):
        if ay != by:
            crosses = (ay > places[:, 1]) != (by > places[:, 1])
            inside ^= crosses & (places[:, 0] < ax + (places[:, 1] - ay) / (by - ay) * (bx - ax))
    return inside


def count_fans(polygons, points, places):
    """How many triangles of the fans cover each place: once forwards, minus once backwards, which
    OpenGL draws as well."""
    forwards = numpy.zeros(len(places), dtype=int)
    backwards = forwards.copy()
    for polygon in polygons:
        corners = points[polygon]
        for b, c in zip(corners[1:], corners[2:]):
            sides = []
            for p, q in ((corners[0], b), (b, c), (c, corners[0])):
                sides.append((q[0] - p[0]) * (places[:, 1] - p[1])
                             - (q[1] - p[1]) * (places[:, 0] - p[0]))  # fmt: skip
            forwards += (numpy.array(sides) > 0).all(axis=0)
            backwards += (numpy.array(sides) < 0).all(axis=0)
    return forwards, backwards


def star(numbers, count):
    """An outline around its middle, all of it seen from there, but hardly from any corner."""
    angles = 2 * numpy.pi * (numpy.arange(count) + 0.8 * numbers.random(count)) / count
    radii = numbers.uniform(0.15, 1, count)
    return numpy.stack([radii * numpy.cos(angles), radii * numpy.sin(angles)], axis=1)


class ConvexPolygons(unittest.TestCase):
    def check(self, outline, exact=True, kind=VTK_DOUBLE, samples=2000):
        """Every first corner, both windings, several planes."""
        outline = numpy.asarray(outline, dtype=float)
        numbers = numpy.random.default_rng(7)
        low, high = outline.min(axis=0), outline.max(axis=0)
        places = numbers.uniform(low - 0.1, high + 0.1, (samples, 2))
        inside = is_inside(outline, places)
        self.assertGreater(inside.sum(), 20)
        starts = range(len(outline)) if len(outline) < 30 else (0, len(outline) // 2)
        for frame in FRAMES.values():
            points = outline @ frame[:2]
            for start in starts:
                for winding in (1, -1):
                    ids = numpy.roll(numpy.arange(len(outline)), -start)[::winding]
                    mesh, _ = cut(mesh_of(points, [ids], kind))
                    self.assertEqual(mesh.GetNumberOfPoints(), len(outline))
                    forwards, backwards = count_fans(polygons_of(mesh), outline, places)
                    if winding < 0:
                        forwards, backwards = backwards, forwards
                    numpy.testing.assert_array_equal(forwards, inside)
                    self.assertEqual(backwards.sum(), 0)

    def test_l(self):
        self.check(L)
        self.check(L, kind=VTK_FLOAT)

    def test_fan_of_vtk_folds(self):
        """The test's own measure: VTK's fan of the same L covers too much."""
        places = numpy.random.default_rng(7).uniform(0, 2, (2000, 2))
        inside = is_inside(L, places)
        forwards, backwards = count_fans([numpy.roll(range(6), -1)], numpy.array(L), places)
        self.assertGreater((forwards + backwards > inside).sum(), 100)

    def test_shapes(self):
        for outline in (
            [(0, 0), (1, 0.2), (2, 0), (1, 2)],  # a dart
            [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)],  # a U
            [(0, 0), (5, 0), (5, 4), (0, 4), (0, 1), (4, 1), (4, 3), (2, 3), (2, 2), (3, 2.5),
             (3, 1.5), (1, 1.5), (1, 3.5), (4.5, 3.5), (4.5, 0.5), (0, 0.5)],  # a maze
            [(0, 0), (0.5, 0), (1, 0), (2, 0), (2, 1), (1.5, 1), (1, 1), (1, 1.5), (1, 2), (0, 2),
             (0, 1)],  # corners on lines
            [(0, 0), (2, 0), (2, 0), (2, 1), (1, 1), (1, 1), (1, 1), (1, 2), (0, 2),
             (0, 0)],  # corners twice
            [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 3), (3, 3), (3, 1),
             (1, 1)],  # a hole
            [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0), (1, 1), (1, 2), (2, 2), (2, 1), (6, 1), (6, 3),
             (8, 3), (8, 1), (6, 1), (2, 1), (1, 1)],  # two holes, one behind the other
            [(0, 0), (4, 0), (4, 4), (2, 2), (0, 4)],  # M
            [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],  # M that touches the edge
            [(0, 0), (1, 0), (1, -1), (2, -1), (2, 0), (3, 0), (3, 1), (0, 1)],  # T
            [(0, 0), (2, 0), (2, 1), (5, 1), (2, 1), (2, 2), (0, 2)],  # with a spike
        ):  # fmt: skip
            with self.subTest(outline=outline):
                self.check(outline)

    def test_stars(self):
        numbers = numpy.random.default_rng(3)
        for count in (5, 6, 7, 9, 12, 17, 29, 60, 200):
            for _ in range(4):
                self.check(star(numbers, count), samples=1500)

    def test_normals(self):
        """VTK's normal of the output points to the side around which the outline runs."""
        numbers = numpy.random.default_rng(12)
        zigzag = [(0.1 * i, 8 - 0.3 * (i % 2)) for i in range(20)]  # all seen from the first corner
        sides = []
        for outline in (L, star(numbers, 12), star(numbers, 40), [(1, -9), *zigzag[::-1]]):
            mesh = mesh_of(numpy.asarray(outline) @ FRAMES["z"][:2], [range(len(outline))])
            for data in (mesh, cut(mesh)[0]):
                normals = vtkPolyDataNormals()
                normals.SetInputData(data)
                normals.ConsistencyOff()
                normals.Update()
                found = vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals())[:, 2]
                sides.append(found.min())
        self.assertGreater(min(sides[1::2]), 0.99)
        self.assertLess(min(sides[::2]), -0.99)  # as VTK has it of whole polygons

    def test_holes_in_stars(self):
        """A small star within a large one, joined by a bridge."""
        numbers = numpy.random.default_rng(4)
        for count in (5, 8, 20):
            outer, inner = star(numbers, count), star(numbers, count) * 0.1
            joined = numpy.concatenate([outer, outer[:1], inner[::-1], inner[-1:]])
            if numpy.hypot(*outer.T).min() > 0.12:
                joined = numpy.roll(joined, 1, axis=0)
                self.check(joined, samples=1500)

    def test_large(self):
        """Tens of thousands of corners, in less than a second or so."""
        numbers, times = numpy.random.default_rng(9), []
        x = numpy.arange(4000)
        comb = numpy.stack([x, numpy.where(x % 2, 1.0, 20.0)], axis=1)
        comb = numpy.concatenate([comb, [(3999, 0), (0, 0)]])
        for outline in (star(numbers, 3000), star(numbers, 30000), comb):
            mesh = mesh_of(outline @ FRAMES["z"][:2], [range(len(outline))])
            begin = time.process_time()
            output, step = cut(mesh)
            times.append(time.process_time() - begin)
            self.assertEqual(step.GetNumberOfCutPolygons(), 1)
            self.assertEqual(output.GetNumberOfPolys(), len(outline) - 2)
            corners = outline[numpy.array(polygons_of(output))]
            sides = corners[:, 1:] - corners[:, :1]
            areas = sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]
            edges = numpy.roll(outline, -1, axis=0)
            whole = outline[:, 0] * edges[:, 1] - outline[:, 1] * edges[:, 0]
            self.assertAlmostEqual(abs(areas).sum() / abs(whole.sum()), 1, places=9)
        self.assertLess(max(times), 3)

    # ------------------------------------------------------------------------
    def test_untouched(self):
        """Triangles, convex polygons and polygons without area pass unchanged, without a copy."""
        square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, numpy.nan), (0.5, 0, 0)]
        for polygons in ([(0, 1, 2)], [(0, 1, 2, 3)], [(0, 5, 1, 2, 3), (0, 1, 2)], [(0, 1, 1, 0)],
                         [(0, 2, 1, 3)], [(0, 0, 0, 0)], [(0, 1, 4, 3)], []):  # fmt: skip
            mesh = mesh_of(square, polygons)
            output, step = cut(mesh)
            self.assertIs(output.GetPolys(), mesh.GetPolys())
            self.assertIs(output.GetPoints(), mesh.GetPoints())
            self.assertFalse(output.GetCellData().HasArray("vtkRelievoPolygonIds"))
            self.assertEqual(step.GetNumberOfTurnedPolygons() + step.GetNumberOfCutPolygons(), 0)
        self.assertEqual(cut(vtkPolyData())[0].GetNumberOfCells(), 0)

    def test_bent(self):
        """Four corners that are not in a plane are cut where the fan does not fold."""
        for points, folds in (
            ([(0, 0, 0), (1, 0, 0.3), (1, 1, 0), (0, 1, 0.3)], False),
            ([(0, 0, 0), (1, 0, 0), (0.4, 0.4, 2), (0, 1, 0)], False),
            ([(0, 0, 0), (1, 0, 0), (0.2, 0.2, 0.1), (0, 1, 0)], True),
        ):
            for start in range(4):
                ids = numpy.roll(range(4), -start)
                output, step = cut(mesh_of(points, [ids]))
                self.assertEqual(output.GetNumberOfPolys(), 1)
                turned = folds and start in (1, 3)
                self.assertEqual(step.GetNumberOfTurnedPolygons(), turned)
                self.assertEqual(polygons_of(output)[0][0], (ids[1] if turned else ids[0]))

    def test_arrays(self):
        """Cells of all kinds keep their data, their order and the numbers of their polygons."""
        angles = numpy.arange(12) * numpy.pi / 6
        outline = numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=1)
        outline[::2] *= 0.2
        points = numpy.concatenate([outline, outline + (3, 0)]) @ FRAMES["z"][:2]
        mesh = mesh_of(points, [(0, 1, 2), range(12), (13, 14, 15), range(23, 11, -1)])
        for ids, take in (((0, 5), mesh.SetVerts), ((1, 2, 3), mesh.SetLines),
                          ((4, 5, 6, 7), mesh.SetStrips)):  # fmt: skip
            cells = vtkCellArray()
            cells.InsertNextCell(len(ids), ids)
            take(cells)
        for name in ("value", "vtkOriginalCellIds"):
            values = numpy_to_vtk(10 + numpy.arange(7), deep=True)
            values.SetName(name)
            mesh.GetCellData().AddArray(values)
        mesh.GetCellData().SetActiveScalars("value")
        mesh.GetCellData().SetGlobalIds(numpy_to_vtk(numpy.arange(7), deep=True))
        output, step = cut(mesh)
        self.assertEqual(step.GetNumberOfCutPolygons(), 2)
        self.assertEqual(output.GetNumberOfPolys(), 1 + 10 + 1 + 10)
        of = [0, 1, 2] + 10 * [3] + [4] + 10 * [5] + [6]
        data = output.GetCellData()
        self.assertEqual(list(vtk_to_numpy(data.GetArray("vtkRelievoPolygonIds"))), of)
        for array in (data.GetScalars(), data.GetArray("vtkOriginalCellIds")):
            self.assertEqual(list(vtk_to_numpy(array)), [10 + each for each in of])
        self.assertEqual(list(vtk_to_numpy(data.GetGlobalIds())), of)
        self.assertIs(output.GetPoints(), mesh.GetPoints())
        self.assertEqual(mesh.GetNumberOfPolys(), 4)


def smooth(mesh, angle=30):
    step = relievo.vtkRelievoPointNormals()
    step.SetFeatureAngle(angle)
    step.SetInputData(mesh)
    step.Update()
    direct = vtkPolyData()
    step.MakeNormals(mesh, direct)
    if mesh.GetNumberOfCells() > 0:
        for one, other in zip(arrays_of(direct), arrays_of(step.GetOutput())):
            numpy.testing.assert_array_equal(one, other)
    return step.GetOutput()


def arrays_of(mesh):
    return (vtk_to_numpy(mesh.GetPoints().GetData()),
            vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()),
            vtk_to_numpy(mesh.GetPointData().GetNormals()))  # fmt: skip


class PointNormals(unittest.TestCase):
    def test_cube(self):
        """Each corner becomes three, with the normals of its three faces."""
        points = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        mesh = mesh_of(points, quads)
        values = numpy_to_vtk(numpy.arange(8), deep=True)
        values.SetName("value")
        mesh.GetPointData().SetScalars(values)
        places, corners, normals = arrays_of(smooth(mesh))
        self.assertEqual(len(places), 24)
        for quad, made in zip(quads, corners.reshape(6, 4)):
            numpy.testing.assert_array_equal(places[made], numpy.array(points)[list(quad)])
            axis = numpy.mean([points[i] for i in quad], axis=0)
            numpy.testing.assert_array_equal(normals[made], [axis] * 4)
        copied = vtk_to_numpy(smooth(mesh).GetPointData().GetScalars())
        numpy.testing.assert_array_equal(copied[corners], numpy.ravel(quads))
        self.assertEqual(mesh.GetNumberOfPoints(), 8)
        whole = smooth(mesh, 180)
        self.assertIs(whole.GetPoints(), mesh.GetPoints())
        self.assertIs(whole.GetPolys(), mesh.GetPolys())
        outwards = numpy.array(points) / 3**0.5
        numpy.testing.assert_allclose(arrays_of(whole)[2], outwards, atol=1e-7)

    def test_angle(self):
        for bend, count in ((29.9, 4), (30.1, 6)):
            up = numpy.radians(bend)
            points = [(0, 0, 0), (0, 1, 0), (-1, 0, 0), (numpy.cos(up), 0, numpy.sin(up))]
            found = smooth(mesh_of(points, [(0, 1, 2), (1, 0, 3)]))
            self.assertEqual(found.GetNumberOfPoints(), count)

    def test_as_vtk(self):
        """The points, their order, the corners and the normals are those of vtkPolyDataNormals."""
        numbers = numpy.random.default_rng(8)
        turn = 2 * numpy.pi * numpy.arange(400) / 400
        tip = numpy.stack([numpy.cos(turn), numpy.sin(turn), 0 * turn], 1)
        n = 20
        grid = numpy.array([(i, j, 3 * numbers.random() * (i > 9))
                            for i in range(n) for j in range(n)])  # fmt: skip
        squares = [(i * n + j, i * n + j + n, i * n + j + n + 1, i * n + j + 1)
                   for i in range(n - 1) for j in range(n - 1)]  # fmt: skip
        tangle = [numbers.permutation(60)[: 3 + i % 3] for i in range(200)]
        for points, polygons in (
            (grid, squares),
            (grid, [part for a, b, c, d in squares for part in ((a, b, c), (a, c, d))]),
            (numpy.concatenate([[(0, 0, 0.2)], tip]), [(0, 1 + i, 1 + (i + 1) % 400)
                                                       for i in range(400)]),
            (numbers.normal(size=(60, 3)), tangle),
        ):  # fmt: skip
            for kind in (VTK_FLOAT, VTK_DOUBLE):
                mesh = mesh_of(points, polygons, kind)
                step = vtkPolyDataNormals()
                step.ConsistencyOff()
                step.SetInputData(mesh)
                step.Update()
                expected = arrays_of(step.GetOutput())
                for _ in range(2):
                    places, corners, normals = arrays_of(smooth(mesh))
                    numpy.testing.assert_array_equal(places, expected[0])
                    numpy.testing.assert_array_equal(corners, expected[1])
                    numpy.testing.assert_allclose(normals, expected[2], atol=2e-6)
                    mesh.GetPolys().ConvertTo32BitStorage()

    def test_other_cells(self):
        mesh = mesh_of([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2), (0, 0, 0)])
        lines = vtkCellArray()
        lines.InsertNextCell(2, (0, 3))
        mesh.SetLines(lines)
        found = smooth(mesh)
        self.assertIs(found.GetLines(), mesh.GetLines())
        normals = arrays_of(found)[2]
        numpy.testing.assert_array_equal(normals[1:4], [(0, 0, 1), (0, 0, 1), (0, 0, 0)])
        self.assertEqual(smooth(vtkPolyData()).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
