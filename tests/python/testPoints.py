# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points from depth; errors as exceptions."""

import unittest

import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData


class Points(unittest.TestCase):
    def check(self, renderer, limit):
        image = relievo.capture(renderer, ["depth", "actor"], size=(90, 60))
        cloud = relievo.depth_to_points(image)
        finite = numpy.isfinite(relievo.layer(image, "depth"))
        self.assertEqual(cloud.GetNumberOfPoints(), finite.sum())
        self.assertEqual(cloud.GetNumberOfVerts(), finite.sum())
        points = vtk_to_numpy(cloud.GetPoints().GetData())
        self.assertEqual(points.dtype, numpy.float64)
        # The points of actor 0 lie in its plane, whose corners are known in double.
        plane = vtk_to_numpy(
            renderer.GetActors().GetItemAsObject(0).GetMapper().GetInput().GetPoints().GetData()
        )
        normal = numpy.cross(plane[1] - plane[0], plane[2] - plane[0])
        normal /= numpy.linalg.norm(normal)
        on_plane = vtk_to_numpy(cloud.GetPointData().GetArray("actor")) == 0
        self.assertGreater(on_plane.sum(), 1000)
        off = numpy.abs((points[on_plane] - plane[0]) @ normal)
        self.assertLessEqual(off.max(), limit)

    def test_perspective(self):
        self.check(scenes.plane_and_sphere(), 2e-5)

    def test_parallel(self):
        self.check(scenes.plane_and_sphere(parallel=True), 2e-5)

    def test_far_from_the_origin(self):
        self.check(scenes.plane_and_sphere(far_from_origin=(5e5, 5e6, 0)), 2e-4)

    def test_errors(self):
        with self.assertRaises(ValueError) as caught:
            relievo.depth_to_points(relievo.to_image(numpy.zeros((2, 2), numpy.float32)))
        self.assertIn("depth", str(caught.exception))
        with self.assertRaises(ValueError):
            relievo.depth_to_points("image")
        with self.assertRaises(ValueError) as caught:
            relievo.depth_to_points(vtkImageData())
        self.assertIn("'depth'", str(caught.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
