# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points from depth; rays as arrays, compared with captures; errors as exceptions."""

import pathlib
import tempfile
import unittest

import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer


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
        lens = relievo.lens("fisheye", (40, 30))
        image = relievo.capture(vtkSphereSource(), "depth", camera=lens)
        with self.assertRaisesRegex(ValueError, "of a sensor.*capture the layer position"):
            relievo.depth_to_points(image)


class Rays(unittest.TestCase):
    def check_captured(self, **scene):
        """Hits of rays through the centres of pixels equal the pixels' layers."""
        renderer = scenes.plane_and_sphere(**scene)
        renderer.GetActors().GetItemAsObject(1).SetScale(1, 1.25, 1)
        names = ["range", "normal", "geometric_normal", "position", "actor", "block", "cell"]
        image = relievo.capture(renderer, names, size=(360, 240))
        layers = {name: relievo.layer(image, name) for name in names}
        origins, directions = scenes.rays(renderer.GetActiveCamera(), 360, 240)
        rays = relievo.rays(renderer)
        origins, directions = origins.reshape(-1, 3), directions.reshape(-1, 3)
        hits = rays.nearest(origins, directions)
        cells = hits.cell.reshape(240, 360)
        # Not beside an edge, where OpenGL may draw either triangle.
        inner = numpy.zeros(cells.shape, bool)
        inner[1:-1, 1:-1] = True
        for move in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            inner &= numpy.roll(cells, move, (0, 1)) == cells
        self.assertGreater((inner & (hits.prop.reshape(240, 360) == 1)).sum(), 300)
        for name, of in (("actor", hits.prop), ("block", hits.block), ("cell", hits.cell)):
            self.assertTrue((layers[name][inner] == of.reshape(240, 360)[inner]).all(), name)
        # Normals are kept in 32 bits; geometric ones come from floats of the GPU.
        for name, limit in (("normal", 7e-5), ("geometric_normal", 2e-4), ("position", 2e-5)):
            off = numpy.abs(layers[name][inner] - getattr(hits, name).reshape(240, 360, 3)[inner])
            self.assertLessEqual(off.max(), limit, name)
        # From the eye; parallel rays start in its plane, and range is from the eye itself.
        if not scene.get("parallel"):
            off = numpy.abs(layers["range"][inner] - hits.distance.reshape(240, 360)[inner])
            self.assertLessEqual(off.max(), 2e-5)
        places = origins + hits.distance[:, None] * (
            directions / numpy.linalg.norm(directions, axis=1)[:, None])
        self.assertLessEqual(numpy.abs(places - hits.position)[hits.hit].max(), 1e-8)
        self.assertTrue((rays.any(origins, directions) == hits.hit).all())
        every = rays.all(origins, directions)
        first = numpy.searchsorted(every.ray, numpy.flatnonzero(hits.hit))
        self.assertTrue((every.distance[first] == hits.distance[hits.hit]).all())
        self.assertGreater(len(every.ray), hits.hit.sum())
        self.assertTrue((every.opacity == 1).all())
        self.assertEqual(rays.props, list(renderer.GetActors()))

    def test_captured(self):
        self.check_captured()

    def test_captured_in_parallel(self):
        self.check_captured(parallel=True)

    def test_data(self):
        """Data by matrices, which are moved; shapes and kinds of arrays."""
        source = vtkSphereSource()
        source.SetRadius(1)
        source.SetThetaResolution(4)  # an octahedron
        source.SetPhiResolution(3)
        moved = vtkMatrix4x4()
        placed = numpy.diag([2.0, 2, 2, 1])
        placed[0, 3] = 10
        rays = relievo.rays([source, (source.GetOutput(), placed)], (source, moved))
        moved.SetElement(1, 3, 10)
        self.assertEqual(rays.props, 3 * [source.GetOutput()])
        origins = numpy.array([[0, 0, -9], [10, 0, -9], [0, 10, -9], [5, 5, -9]], numpy.float32)
        hits = rays.nearest(origins[:, ::1], [0, 0, 3])
        self.assertTrue((hits.prop == [0, 1, 2, -1]).all())
        self.assertTrue((hits.ray == numpy.arange(4)).all() and hits.opacity is None)
        self.assertTrue((hits.distance == [8, 7, 8, numpy.inf]).all(), hits.distance)
        self.assertTrue((rays.any([0, 0, -9], origins + [0, 0, 9.5]) == [1, 0, 0, 0]).all())
        self.assertTrue((rays.nearest(origins, [0, 0, 1], maximum=7.5).hit == [0, 1, 0, 0]).all())
        self.assertTrue((rays.nearest(origins, [0, 0, 1], minimum=8.5).prop == [0, 1, 2, -1]).all())
        self.assertEqual(len(rays.nearest(numpy.zeros((0, 3)), numpy.zeros((0, 3))).cell), 0)

    def test_progress(self):
        rays = relievo.rays(vtkSphereSource())
        many = numpy.ones((150000, 3))
        shares = []
        rays.any(many, -many, progress=shares.append)
        self.assertEqual([round(each, 3) for each in shares], [0.437, 0.874, 1.0])
        with self.assertRaisesRegex(RuntimeError, "ended by progress at 44%"):
            rays.nearest(many, -many, progress=lambda share: share < 0.4)
        with self.assertRaises(ZeroDivisionError):
            rays.all(many, -many, progress=lambda share: 1 / 0)

    def test_files_of_rays(self):
        source = vtkSphereSource()
        renderer = vtkRenderer()
        scenes.add(renderer, source)
        origins = numpy.random.default_rng(5).uniform(-1, 1, (500, 3))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "scene.rays")
            rays = relievo.rays(renderer)
            rays.write(path)
            hits = rays.nearest(origins, -origins)
            for found in (relievo.rays(path), relievo.rays(path, renderer)):
                for name, values in found.nearest(origins, -origins)._asdict().items():
                    numpy.testing.assert_array_equal(values, getattr(hits, name), name)
            self.assertEqual(relievo.rays(str(path)).props, [None])
            sensor = relievo.Pinhole([[90, 0, 31.5], [0, 90, 23.5], [0, 0, 1]], (64, 48),
                                     t=(0, 0, 2))  # fmt: skip
            layers = ["depth", "cell"]
            drawn = relievo.capture(renderer, layers, camera=sensor)
            read = relievo.rays(path)
            self.assertFalse(read.nearest(2 * origins, origins, maximum=0.01).hit.all())
            seen = relievo.capture_many(read, [sensor] * 2, layers)  # of any distance
            for name in layers:
                numpy.testing.assert_array_equal(seen[name][1], relievo.layer(drawn, name))
            with self.assertRaisesRegex(ValueError, "of another scene"):
                relievo.rays(path, source)  # data, not the renderer
            source.SetRadius(2)
            with self.assertRaisesRegex(ValueError, "of another scene"):
                relievo.rays(path, renderer)
            path.write_bytes(path.read_bytes()[:-1])
            with self.assertRaisesRegex(ValueError, "is damaged"):
                relievo.rays(path)
            with self.assertRaisesRegex(OSError, "No such file or directory"):
                rays.write(pathlib.Path(folder, "none", "scene.rays"))

    def test_refusals(self):
        rays = relievo.rays(vtkSphereSource())
        for words, invalid in (
            ("origins: got an array of shape \\(2,\\)", ([1, 2], [0, 0, 1])),
            ("directions: got an array of <U1", ([1, 2, 3], ["a", "b", "c"])),
            ("got 2 and 3, expected as many", (numpy.ones((2, 3)), numpy.ones((3, 3)))),
            ("got 2 and 1, expected 0 or more", ([0, 0, 0], [0, 0, 1], 2, 1)),
            ("got 0.0 and \\[1, 9\\], expected a number each", ([0, 0, 0], [0, 0, 1], 0.0, [1, 9])),
        ):
            with self.assertRaisesRegex(ValueError, words):
                rays.nearest(*invalid)
        for words, things in (
            ("got nothing", ()),
            ("got 3", (3,)),
            ("got 2 files", ("a.rays", "b.rays")),
            ("got 2 renderers", (vtkRenderer(), vtkRenderer())),
            ("shape \\(3, 3\\), expected \\(4, 4\\)", ((vtkPolyData(), numpy.eye(3)),)),
        ):
            with self.assertRaisesRegex(ValueError, words):
                relievo.rays(*things)
        with self.assertRaises(FileNotFoundError):
            relievo.rays("none.rays")
        nowhere = relievo.rays((vtkSphereSource(), numpy.diag([1.0, 1, 1, 0])))
        with self.assertRaisesRegex(ValueError, "got a matrix that is not finite"):
            nowhere.write("none.rays")
        with self.assertRaisesRegex(ValueError, "^rays: (?!Rays).*got a matrix that is not finite"):
            nowhere.any([0, 0, 0], [0, 0, 1])


if __name__ == "__main__":
    unittest.main(verbosity=2)
