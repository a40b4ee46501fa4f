# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""capture() of other things than a renderer: data, filters, plotters."""

import types
import unittest

import numpy
import scenes
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUADRATIC_TETRA,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkTable,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import relievo

SIZE = (210, 140)


class InHand(unittest.TestCase):
    def test_data(self):
        """A box of 10 x 6 x 2 from the front: its face is at one depth, and seen in its cells."""
        image = vtkImageData()
        image.SetDimensions(6, 4, 2)
        image.SetSpacing(2, 2, 2)
        boxes = vtkMultiBlockDataSet()
        boxes.SetBlock(0, image)
        surface = vtkDataSetSurfaceFilter()
        surface.SetInputData(image)
        surface.Update()
        for data in (image, boxes, surface.GetOutput(), surface):
            seen = relievo.capture(data, ["depth", "normal"])
            self.assertEqual(seen.GetDimensions()[:2], (1024, 768))
            depth = relievo.layer(seen, "depth")
            front = relievo.layer(seen, "normal")[..., 2] > 0.99
            # Fitted: the sphere around the box touches the picture's upper and lower edge.
            away = (10**2 + 6**2 + 2**2) ** 0.5 / 2 / numpy.sin(numpy.radians(15)) - 1
            numpy.testing.assert_allclose(depth[front], away, rtol=1e-5)
            height = front.any(axis=1).sum()
            expected = 6 / (2 * away * numpy.tan(numpy.radians(15))) * 768
            self.assertLess(abs(height - expected), 2)
        ids = relievo.layer(relievo.capture(image, "vtkOriginalCellIds"), "vtkOriginalCellIds")
        self.assertEqual(set(numpy.unique(ids[numpy.isfinite(ids)])), set(range(15)))

    def test_fitted(self):
        """Nothing is cut off, whatever the picture's shape; the smaller side is well used."""
        for size in ((60, 240), (240, 60), (150, 150)):
            image = relievo.capture(vtkSphereSource(), size=size)
            seen = numpy.isfinite(relievo.layer(image, "depth"))
            self.assertFalse((seen[[0, -1]].any() or seen[:, [0, -1]].any()), size)
            self.assertGreater(seen.any(axis=0).sum(), 0.5 * min(size), size)

    def test_numbers_of_nonlinear_cells(self):
        """Those of the grid, not of the filter's copy without nonlinear cells."""
        grid, points = vtkUnstructuredGrid(), vtkPoints()
        corners = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], dtype=float)
        middles = [(corners[a] + corners[b]) / 2
                   for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]  # fmt: skip
        for x in (-3, -1.5, 0):
            ids = [points.InsertNextPoint(*(p + (x, 0, 0))) for p in (*corners, *middles)]
            grid.InsertNextCell(VTK_QUADRATIC_TETRA, len(ids), ids)
        grid.SetPoints(points)
        ids = relievo.layer(relievo.capture(grid, "vtkOriginalCellIds"), "vtkOriginalCellIds")
        self.assertEqual(set(numpy.unique(ids[numpy.isfinite(ids)])), {0, 1, 2})
        self.assertIsNone(grid.GetCellData().GetArray("vtkOriginalCellIds"))

    def test_actors_and_points(self):
        """An actor is drawn as it is placed; points of numpy are seen where they are."""
        ball = vtkSphereSource()
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(ball.GetOutputPort())
        actor.SetMapper(mapper)
        actor.SetScale(1, 3, 1)
        for given in (actor, types.SimpleNamespace(actor=actor)):
            seen = numpy.isfinite(relievo.layer(relievo.capture(given, size=SIZE), "depth"))
            tall, wide = (seen.any(axis=axis).sum() for axis in (1, 0))
            self.assertLess(abs(tall / wide - 3), 0.15)
            self.assertTrue(relievo.rays(given).any((0, 1.4, 5), (0, 0, -1))[0])
            self.assertFalse(relievo.rays(given).any((0, 1.6, 5), (0, 0, -1))[0])
        places = numpy.array([(-1, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0)], "float32")
        seen = relievo.layer(relievo.capture(places, ["position"], size=SIZE), "position")
        found = seen[(seen != 0).any(axis=2)]
        away = numpy.linalg.norm(found[:, None] - places, axis=2)
        self.assertEqual(set(away.argmin(axis=1)), set(range(len(places))))
        self.assertLess(away.min(axis=1).max(), 0.02)  # a pixel
        holder = types.SimpleNamespace(dataset=ball)  # a filter is no dataset
        with self.assertRaisesRegex(ValueError, "expected a vtkRenderer"):
            relievo.capture(holder)

    def test_plotter(self):
        renderer = scenes.plane_and_sphere()
        plotter = types.SimpleNamespace(renderer=renderer)
        same = [relievo.layer(relievo.capture(each, size=SIZE), "depth")
                for each in (renderer, plotter)]  # fmt: skip
        numpy.testing.assert_array_equal(*same)

    def test_refused(self):
        for invalid in (None, 7, "mesh.vtp", types.SimpleNamespace(renderer=3), vtkTable()):
            with self.assertRaisesRegex(ValueError, "expected a vtkRenderer, something with"):
                relievo.capture(invalid)
        with self.assertRaisesRegex(ValueError, "no cells"):
            relievo.capture(vtkPolyData())


if __name__ == "__main__":
    unittest.main()
