# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""capture() of what else than a renderer people have in hand: data, filters, plotters."""

import types
import unittest

import numpy
import scenes
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkTable
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

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

    def test_plotter(self):
        renderer = scenes.plane_and_sphere()
        plotter = types.SimpleNamespace(renderer=renderer)
        same = [relievo.layer(relievo.capture(each, size=SIZE), "depth")
                for each in (renderer, plotter)]  # fmt: skip
        numpy.testing.assert_array_equal(*same)

    def test_refused(self):
        for wrong in (None, 7, "mesh.vtp", types.SimpleNamespace(renderer=3), vtkTable()):
            with self.assertRaisesRegex(ValueError, "expected a vtkRenderer, something with"):
                relievo.capture(wrong)
        with self.assertRaisesRegex(ValueError, "no cells"):
            relievo.capture(vtkPolyData())


if __name__ == "__main__":
    unittest.main()
