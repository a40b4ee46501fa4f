# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras by their calibration: pictures against projections by hand, lenses against OpenCV."""

import gzip
import json
import os
import tempfile
import unittest

import numpy
import scenes
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderWindow

import relievo
from relievo.vtkRelievoCameras import vtkRelievoCalibration

# cv2.projectPoints and cv2.fisheye.projectPoints of OpenCV 5.0.0 of these points, pose and lenses.
POINTS = numpy.array([[0, 0, 0], [1, 0.5, -0.3], [-0.8, 0.7, 0.4], [0.5, -0.9, 1.2],
                      [1.4, 1.1, 0.2], [-1.2, -0.6, -0.9]])
K = numpy.array([[820.5, 0, 333.25], [0, 790.25, 210.75], [0, 0, 1]])
SIZE = (640, 480)
VECTOR = (0.3, -0.2, 0.15)
SHIFT = (0.1, -0.2, 3.0)
FISHEYE = (0.02, -0.013, 0.006, -0.0011)
BROWN = (-0.25, 0.07, 0.001, -0.0007, -0.01)
RATIONAL = (0.4, -0.1, 0.0006, 0.0011, 0.03, 0.65, -0.05, 0.02)
SKEWED = K + [[0, 0.01 * 820.5, 0], [0, 0, 0], [0, 0, 0]]
LENSES = {
    "pinhole": relievo.Pinhole(K, SIZE, VECTOR, SHIFT),
    "brown": relievo.Pinhole(K, SIZE, VECTOR, SHIFT, BROWN),
    "rational": relievo.Pinhole(K, SIZE, VECTOR, SHIFT, RATIONAL),
    "fisheye": relievo.Fisheye(K, SIZE, FISHEYE, VECTOR, SHIFT),
    "skewed": relievo.Fisheye(SKEWED, SIZE, FISHEYE, VECTOR, SHIFT),
}
OPENCV = {
    "pinhole": [
        [360.6, 158.06666666666666], [608.8764579490243, 334.35346074399615],
        [123.58954891561052, 267.7676712299355], [443.6068575299222, -59.250318288696974],
        [598.8196371972922, 406.5527591180188], [-46.995513600751394, -76.96536042396565]],
    "brown": [
        [360.5539590981653, 158.1535975090592], [599.6492624688537, 330.3594412203599],
        [127.0668654104353, 266.86670747835933], [439.8512408385585, -50.14469656210133],
        [588.2052249741535, 398.9284840778239], [-17.199341097852994, -53.994468441671756]],
    "rational": [
        [360.56694033439675, 158.14264110378133], [600.3302309659812, 330.5304732705025],
        [127.33619472019359, 266.7994937664782], [440.2034488775879, -50.56185517299326],
        [588.949822884461, 399.24402545881674], [-17.32906442931511, -54.59055043623346]],
    "fisheye": [
        [360.5525312600903, 158.1581040139272], [597.8217125906324, 329.3960092928238],
        [128.05376912717497, 266.5536156510006], [439.25550371608426, -48.60424752318596],
        [586.110310609485, 397.1822556271551], [-11.984699123623557, -50.47418894205833]],
    "skewed": [
        [360.0064806348885, 158.1581040139272], [599.0535892198606, 329.3960092928238],
        [128.63316636401962, 266.5536156510006], [436.56268296198397, -48.60424752318596],
        [588.045997616661, 397.1822556271551], [-14.696935087267434, -50.47418894205833]],
}


def projected(matrix, R, t, points):
    """Pixels by hand: K (R p + t), divided by its last coordinate."""
    places = (points @ R.T + t) @ matrix.T
    return places[..., :2] / places[..., 2:]


def places_of(size):
    """(rows, columns, 2): u, v of all pixels."""
    return numpy.stack(numpy.meshgrid(numpy.arange(size[0]), numpy.arange(size[1])), axis=-1)


class Pictures(unittest.TestCase):
    """A vtkCamera set by K, R, t: each pixel's position lies on it."""

    def check(self, matrix, size, renderer=None, viewport=(0, 0, 1, 1), window=None):
        renderer = renderer or scenes.plane_and_sphere()
        renderer.SetViewport(*viewport)
        given = relievo.extrinsics(renderer)
        relievo.camera(renderer, K=matrix, size=size, R=given[0], t=given[1])
        image = relievo.capture(renderer, ["position", "depth"], size=window or size)
        seen = numpy.isfinite(relievo.layer(image, "depth"))
        self.assertGreater(seen.mean(), 0.3)
        attributes = relievo.attributes(image)
        position = relievo.layer(image, "position")
        matrix = matrix if window is None else attributes["K"]
        off = projected(matrix, given[0], given[1], position) - places_of(window or size)
        self.assertLess(numpy.abs(off[seen]).max(), 1e-3)
        numpy.testing.assert_allclose(attributes["K"], matrix, atol=1e-9)
        numpy.testing.assert_allclose(attributes["R"], given[0], atol=1e-12)
        numpy.testing.assert_allclose(attributes["t"], given[1], atol=1e-12)
        depth = (position @ given[0].T + given[1])[..., 2]
        numpy.testing.assert_allclose(relievo.layer(image, "depth")[seen], depth[seen], rtol=1e-6)
        return image

    def test_sizes_and_intrinsics(self):
        for matrix, size in (
            ([[300, 0, 159.5], [0, 300, 119.5], [0, 0, 1]], (320, 240)),
            ([[310.5, 0, 101.25], [0, 275.75, 130.5], [0, 0, 1]], (321, 239)),
            ([[310.5, 12.5, 190.0], [0, 275.75, 88.0], [0, 0, 1]], (320, 241)),
            ([[200, -8, -20.0], [0, 190, 250.0], [0, 0, 1]], (199, 201)),
        ):
            with self.subTest(size=size, K=matrix):
                self.check(numpy.array(matrix, float), size)

    def test_viewports(self):
        self.check(numpy.array([[250, 3, 90.0], [0, 260, 80.0], [0, 0, 1]]), (180, 140),
                   viewport=(0.5, 0.25, 1, 0.95))

    def test_window_of_another_shape(self):
        # Its height is that of the picture, and so is fy; K of the attributes is the picture's own.
        matrix = numpy.array([[310.5, 7.0, 150.0], [0, 275.75, 130.5], [0, 0, 1]])
        image = self.check(matrix, (320, 240), window=(500, 240))
        found = relievo.attributes(image)["K"]
        numpy.testing.assert_allclose(numpy.diag(found), numpy.diag(matrix), rtol=1e-12)
        self.assertAlmostEqual(found[1, 2], matrix[1, 2], 9)

    def test_far_from_the_origin(self):
        renderer = scenes.plane_and_sphere(far_from_origin=(5e5, -2e5, 1e5))
        self.check(numpy.array([[300, 0, 150.0], [0, 280, 120.0], [0, 0, 1]]), (320, 240), renderer)

    def test_files_carry_it(self):
        image = self.check(K * [[0.4], [0.4], [1]], (256, 192))
        before = relievo.attributes(image)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.exr")
            relievo.write_exr(path, image)
            after = relievo.attributes(relievo.read_exr(path))
        for name in ("K", "R", "t"):
            numpy.testing.assert_array_equal(before[name], after[name])

    def test_files_carry_lenses(self):
        """The model, its numbers and the pose, as they are; the size is the file's."""
        pose = {"R": VECTOR, "t": SHIFT}
        for name, sensor, expected in (
            *((name, LENSES[name], {"K": LENSES[name].K}) for name in LENSES),
            ("equirectangular", relievo.Equirectangular((64, 32), (120, 50), **pose),
             {"field_of_view": (120, 50)}),
            ("cube", relievo.Cube(16, **pose), {}),
            ("lidar", relievo.Lidar([5.5, 1, 0, -1, -5], steps=8, **pose),
             {"elevations": (5.5, 1, 0, -1, -5)}),
        ):
            expected = {**expected, "R": sensor.R, "t": sensor.t}
            lens = {"brown": "Brown-Conrady", "rational": "Brown-Conrady", "skewed": "fisheye"}
            if name != "pinhole":
                expected["lens"] = [lens.get(name, name)]
            if name in LENSES and name != "pinhole":
                values = {"brown": BROWN, "rational": RATIONAL}.get(name, FISHEYE)
                full = numpy.zeros(4 if "fisheye" in expected["lens"] else 8)
                full[:len(values)] = values
                expected["distortion"] = full
            with self.subTest(sensor=name), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "a.exr")
                image = relievo.capture(scenes.plane_and_sphere(), "depth", camera=sensor)
                relievo.write_exr(path, image)
                read = relievo.read_exr(path)
                after = relievo.attributes(read)
                self.assertEqual(read.GetDimensions()[:2], sensor.size)
                for key, value in expected.items():
                    numpy.testing.assert_array_equal(after.get(key), value, err_msg=key)

    def test_parallel_has_no_intrinsics(self):
        renderer = scenes.plane_and_sphere(parallel=True)
        image = relievo.capture(renderer, "depth", size=(64, 64))
        self.assertNotIn("K", relievo.attributes(image))
        with self.assertRaisesRegex(ValueError, "parallel"):
            relievo.intrinsics(renderer, (64, 64))


class Setting(unittest.TestCase):
    """Values that camera() accepts, keeps and refuses."""

    def test_round_trip(self):
        found = relievo.camera(K=SKEWED, size=SIZE, R=VECTOR, t=SHIFT, near=0.5, far=80)
        self.assertEqual(found.GetClippingRange(), (0.5, 80))
        numpy.testing.assert_allclose(relievo.intrinsics(found, SIZE), SKEWED, rtol=1e-12)
        R, t = relievo.extrinsics(found)
        numpy.testing.assert_allclose(t, SHIFT, atol=1e-12)
        numpy.testing.assert_allclose(R @ R.T, numpy.eye(3), atol=1e-12)
        numpy.testing.assert_allclose(projected(SKEWED, R, t, POINTS),
                                      projected(SKEWED, LENSES["pinhole"].R, t, POINTS))

    def test_intrinsics_of_any_camera(self):
        found = vtkCamera()
        found.SetViewAngle(40)
        matrix = relievo.intrinsics(found, (200, 100))
        focal = 50 / numpy.tan(numpy.radians(20))
        numpy.testing.assert_allclose(matrix, [[focal, 0, 99.5], [0, focal, 49.5], [0, 0, 1]])
        found.SetWindowCenter(0.25, 0)  # a quarter of half of the picture
        self.assertAlmostEqual(relievo.intrinsics(found, (200, 100))[0, 2], 99.5 - 25)
        found.UseHorizontalViewAngleOn()
        self.assertAlmostEqual(relievo.intrinsics(found, (200, 100))[0, 0], 2 * focal)

    def test_refused_changes_nothing(self):
        found = relievo.camera(K=K, size=SIZE, t=(0, 0, 5))
        with self.assertRaises(ValueError):
            relievo.camera(found, K=K, size=SIZE, near=3, far=2)
        self.assertEqual(found.GetPosition(), (0, 0, -5))

    def test_an_earlier_skew_is_gone(self):
        found = relievo.camera(K=SKEWED, size=SIZE)
        relievo.camera(found, K=K * [[790.25 / 820.5], [1], [1]], size=SIZE)
        self.assertIsNone(found.GetUserTransform())

    def test_windows_keep_theirs(self):
        renderer = scenes.plane_and_sphere()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetSize(*SIZE)
        window.AddRenderer(renderer)
        self.assertIs(relievo.camera(renderer, K=K, size=SIZE), renderer.GetActiveCamera())

    def test_refused(self):
        mirror = numpy.diag([1.0, 1.0, -1.0])
        for words, change in (
            ("R is not a rotation", {"R": numpy.eye(3) * 1.1}),
            ("mirrors", {"R": mirror}),
            ("K: got", {"K": numpy.ones((3, 3))}),
            ("K: .*above 0", {"K": numpy.diag([-1.0, 1, 1])}),
            ("size: got", {"size": (640.5, 480)}),
            ("size: .*at least 1", {"size": (0, 480)}),
            ("t: got", {"t": (0, numpy.nan, 0)}),
            ("near < far", {"near": 3, "far": 2}),
            ("far: got", {"far": "wide"}),
            ("size: .*at most", {"size": (2**31, 480)}),
            ("target: got", {"target": "renderer"}),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                relievo.camera(**{"K": K, "size": SIZE, **change})


class Lenses(unittest.TestCase):
    """Rays and places: OpenCV's, and each the inverse of the other."""

    def test_places_are_those_of_opencv(self):
        for name, lens in LENSES.items():
            with self.subTest(lens=name):
                numpy.testing.assert_allclose(lens.project(POINTS), OPENCV[name], atol=1e-9)

    def check_inverse(self, sensor, share, tolerance=1e-9):
        """Points along the rays are seen where the rays begin."""
        origins, directions = sensor.rays()
        places = places_of(sensor.size)
        seen = numpy.isfinite(directions).all(axis=-1)
        self.assertGreaterEqual(seen.mean(), share)
        numpy.testing.assert_allclose(numpy.linalg.norm(directions[seen], axis=-1), 1, atol=1e-12)
        for far in (0.5, 70.0):
            found = sensor.project((origins + far * directions)[seen])
            self.assertLess(numpy.abs(found - places[seen]).max(), tolerance)
        return seen

    def test_rays_are_inverse(self):
        wide = numpy.array([[100, 1.5, 158.0], [0, 98, 121.0], [0, 0, 1]])
        size = (320, 240)
        pose = {"R": VECTOR, "t": SHIFT}
        for name, sensor, share in (
            *((name, lens, 0.99) for name, lens in LENSES.items()),
            ("barrel", relievo.Pinhole(wide, size, **pose, distortion=(-0.12, 0.004)), 0.5),
            ("pincushion", relievo.Pinhole(wide, size, **pose, distortion=(0.3, 0.1)), 1),
            ("wide fisheye", relievo.Fisheye(wide, size, (-0.02, 0.001), **pose), 0.9),
            ("division", relievo.Division(wide, size, -0.3, **pose), 1),
            ("equirectangular", relievo.Equirectangular((64, 32), **pose), 1),
            ("part of one", relievo.Equirectangular((64, 32), (120, 50), **pose), 1),
            ("cube", relievo.Cube(17, **pose), 1),
            ("orthographic", relievo.Orthographic(37.5, size, **pose), 1),
            ("push-broom", relievo.Pushbroom(300, (0.01, 0.02, -0.001), size, **pose), 1),
        ):
            with self.subTest(sensor=name):
                self.check_inverse(sensor, share)

    def test_nothing_is_seen_twice(self):
        # r - 0.2 r^3 grows up to r = sqrt(5 / 3), where it is 2 / 3 of that.
        sensor = relievo.Pinhole([[100, 0, 150], [0, 100, 150], [0, 0, 1]], (301, 301),
                                 distortion=(-0.2, 0))
        seen = self.check_inverse(sensor, 0.25, 1e-6)
        radius = numpy.linalg.norm(places_of((301, 301)) - 150.0, axis=-1)
        edge = 100 * 2 / 3 * numpy.sqrt(5 / 3)
        self.assertTrue(seen[radius < edge - 1e-6].all())
        self.assertFalse(seen[radius > edge + 1e-6].any())
        beyond = numpy.sqrt(5 / 3) + 0.01
        self.assertTrue(numpy.isnan(sensor.project([[beyond, 0, 1]])).all())

    def test_behind(self):
        for sensor in (LENSES["pinhole"], LENSES["brown"]):
            behind = (numpy.array([0, 0, -1.0]) - sensor.t) @ sensor.R
            self.assertTrue(numpy.isnan(sensor.project([behind])).all())
        wide = relievo.Fisheye(numpy.diag([40.0, 40, 1]), (9, 9))
        angle = numpy.radians(100)
        found = wide.project([[numpy.sin(angle), 0, numpy.cos(angle)]])
        numpy.testing.assert_allclose(found, [[40 * angle, 0]], atol=1e-9)

    def test_panoramas(self):
        sensor = relievo.Equirectangular((360, 180))
        for point, place in (
            ((0, 0, 1), (179.5, 89.5)), ((1, 0, 0), (269.5, 89.5)), ((-1, 0, 0), (89.5, 89.5)),
            ((0, -1, 1), (179.5, 44.5)), ((0, 1, 1), (179.5, 134.5)),
        ):
            numpy.testing.assert_allclose(sensor.project([point]), [place], atol=1e-9)
        faces = [relievo.Cube(10).rays([(10 * i + 4.5, 4.5)])[1][0] for i in range(6)]
        numpy.testing.assert_allclose(faces, [(0, 0, 1), (1, 0, 0), (0, 0, -1), (-1, 0, 0),
                                              (0, -1, 0), (0, 1, 0)], atol=1e-12)
        # Faces are upright: the first row looks up, and each column's neighbour is the next face.
        directions = relievo.Cube(10).rays()[1]
        self.assertTrue((directions[0, :40, 1] < 0).all())
        for edge in (10, 20, 30):
            step = directions[:, edge - 1] - directions[:, edge]
            self.assertLess(numpy.linalg.norm(step, axis=-1).max(), 0.2)
        self.assertGreater(directions[9, 44, 2], 0)  # up: its lower edge is in front
        self.assertGreater(directions[0, 54, 2], 0)  # down: its upper edge is

    def test_lidars(self):
        sensor = relievo.Lidar([10, 0, -10], steps=4, offsets=[0, 1, 0])
        self.assertEqual(sensor.size, (4, 3))
        origins, directions = sensor.rays()
        self.assertTrue((origins == 0).all())
        azimuth = numpy.degrees(numpy.arctan2(directions[..., 1], directions[..., 0])) % 360
        expected = numpy.array([180, 90, 0, 270]) + [[0], [1], [0]]
        numpy.testing.assert_allclose(azimuth, expected, atol=1e-9)
        elevation = numpy.degrees(numpy.arcsin(directions[..., 2]))
        numpy.testing.assert_allclose(elevation, [[10] * 4, [0] * 4, [-10] * 4], atol=1e-9)
        beams = relievo.Lidar([0, 90], azimuths=[90, 0]).rays()[1]
        numpy.testing.assert_allclose(beams, [[(0, 1, 0), (0, 0, 1)]], atol=1e-12)
        sensor.look_at((1, 2, 3), (1, 7, 3), (0, 0, 1))
        origins, directions = sensor.rays([(2, 1)])
        numpy.testing.assert_allclose(origins, [(1, 2, 3)], atol=1e-12)
        turned = numpy.radians(91)
        numpy.testing.assert_allclose(directions, [(numpy.cos(turned), numpy.sin(turned), 0)],
                                      atol=1e-12)

    def test_moving_lidars(self):
        """Rays of a turn in motion, in closed form; points are found where the rays pass."""
        angles = numpy.array([25, 10, 4, 0, -7, -20.5])
        sensor = relievo.Lidar(angles, steps=720, way=(2, -1, 0.5), rotation=(0, 0, 12))
        origins, directions = sensor.rays([(0, 3), (360, 3), (180, 3)])
        numpy.testing.assert_allclose(
            origins, numpy.outer([0, 0.5, 0.25], (2, -1, 0.5)), atol=1e-12)
        azimuth = numpy.degrees(numpy.arctan2(directions[:, 1], directions[:, 0]))
        numpy.testing.assert_allclose(numpy.abs(azimuth[0]), 180, atol=1e-9)
        numpy.testing.assert_allclose(azimuth[1:], [6, 93], atol=1e-9)
        tilted = relievo.Lidar([0, 1], steps=4, rotation=(0, 40, 0)).rays([(2, 0)])[1]
        dip = numpy.radians(20)  # half of the rotation about y, which lowers the x axis
        numpy.testing.assert_allclose(tilted, [(numpy.cos(dip), 0, -numpy.sin(dip))], atol=1e-12)

        random = numpy.random.default_rng(5)
        for words in ({}, {"offsets": [0, 1, 0.5, -1, 0, 2]}, {"turn": (-180, 180)},
                      {"turn": (60, -50)}, {"way": (1, 2, 0.3)},
                      {"way": (-2, 1, 0), "rotation": (3, -5, 25), "offsets": [1, 0, 0, 2, 0, 0]}):
            for each in (angles, angles[::-1]):
                sensor = relievo.Lidar(each, steps=720, **words)
                sensor.pose((0.2, -0.4, 1.1), (3, 1, -2))
                places = random.uniform((0, 0), (719, 5), (500, 2))
                origins, directions = sensor.rays(places)
                points = origins + random.uniform(9, 30, (500, 1)) * directions
                found = sensor.project(points)
                if "way" not in words:  # a sensor that moves may pass a point twice in a turn
                    numpy.testing.assert_allclose(found, places, atol=1e-6)
                origins, directions = sensor.rays(found)
                along = ((points - origins) * directions).sum(axis=-1, keepdims=True)
                off = numpy.linalg.norm(points - origins - along * directions, axis=-1)
                self.assertLess(off.max(), 1e-8)
        for sensor in (relievo.Lidar([0], steps=9), relievo.Lidar([0, 2, 1], steps=9),
                       relievo.Lidar([0, 2], azimuths=[1, 2])):
            self.assertTrue(numpy.isnan(sensor.project([(1, 0, 0)])).all())

    def test_look_at(self):
        sensor = relievo.Pinhole(K, SIZE).look_at((1, 2, 3), (1, 2, -5), (0, 1, 0))
        numpy.testing.assert_allclose(sensor.project([(1, 2, 0)]), [K[:2, 2]], atol=1e-9)
        self.assertLess(sensor.project([(1, 2.1, 0)])[0, 1], K[1, 2])
        self.assertGreater(sensor.project([(1.1, 2, 0)])[0, 0], K[0, 2])
        with self.assertRaisesRegex(ValueError, "not a view"):
            sensor.look_at((1, 2, 3), (1, 2, 9), (0, 0, 1))
        calibration, view, said = vtkRelievoCalibration(), vtkCamera(), []
        calibration.AddObserver("ErrorEvent", lambda *_: said.append("error"))
        view.SetViewUp(0, 0, 1)
        self.assertIsNone(calibration.MakeCamera(view, 64, 48))
        self.assertIn("not a view", calibration.GetFailureText())
        self.assertEqual(said, ["error"])

    def test_refused(self):
        for words, make in (
            *((f"given {n} coefficients, expected 0, 2, 4, 5 or 8",
               lambda n=n: relievo.Pinhole(K, SIZE, distortion=[0.1] * n))
              for n in (1, 3, 6, 7, 12)),
            ("expected 0, 1, 2, 3 or 4", lambda: relievo.Fisheye(K, SIZE, [0.1] * 5)),
            ("field", lambda: relievo.Equirectangular((8, 4), (400, 180))),
            ("pixels_per_unit", lambda: relievo.Orthographic(0, SIZE)),
            ("pixels_per_unit", lambda: relievo.Orthographic("a", SIZE)),
            ("center: got", lambda: relievo.Pushbroom(9, (0, 1, 0), SIZE, center=numpy.nan)),
            ("steps: got", lambda: relievo.Lidar([0, 1], steps=2.7)),
            ("distortion: got", lambda: relievo.Pinhole(K, SIZE, distortion="k1")),
            ("either steps", lambda: relievo.Lidar([0, 1])),
            ("azimuths: got", lambda: relievo.Lidar([0, 1], azimuths=[0])),
            ("0 <= minimum", lambda: relievo.Lidar([0, 1], 9, min_range=3, max_range=2)),
            ("0 to 90 degrees", lambda: relievo.Lidar([0, 1], 9, divergence=-1)),
            ("1 to 4096 rays", lambda: relievo.Lidar([0, 1], 9, divergence=1, samples=0)),
            ("returns: got", lambda: relievo.Lidar([0, 1], 9, returns="strongest")),
            ("noise of", lambda: relievo.Lidar([0, 1], 9, noise=-1)),
            ("noise: got", lambda: relievo.Lidar([0, 1], 9, noise="a")),
            ("seed: got", lambda: relievo.Lidar([0, 1], 9, seed=1 << 31)),
            ("seed: got", lambda: relievo.Lidar([0, 1], 9, samples=1.5)),
            ("way: got", lambda: relievo.Lidar([0, 1], 9, way=(1, 2))),
            ("places: got", lambda: relievo.Pinhole(K, SIZE).rays([[1, 2, 3]])),
            ("points: got", lambda: relievo.Pinhole(K, SIZE).project([[1, 2]])),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                make()


# Written as by cv2.FileStorage of OpenCV 5.0.0.
OPENCV_YAML = """%YAML 1.2
---
calibration_time: "Thu Nov 26 20:00:00 2026"
image_width: 640
image_height: 480
# flags: +fix_aspectRatio +fix_principal_point
flags: 6
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 820.5, 0., 333.25, 0., 790.25, 210.75, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -0.25, 0.070000000000000007, 0.001, -0.00069999999999999999,
       -0.01 ]
per_view_reprojection_errors: !!opencv-matrix
   rows: 2
   cols: 1
   dt: f
   data: [ 0.100000001, 0.200000003 ]
grid_points:
   - 1.5
   - 2
"""
OPENCV_JSON = """{
    "image_width": 640,
    "image_height": 480
    // flags: +fix_aspectRatio +fix_principal_point
    ,
    "fisheye_model": 1,
    "camera_matrix": {
        "type_id": "opencv-matrix",
        "rows": 3,
        "cols": 3,
        "dt": "d",
        "data": [ 820.5, 0.0, 333.25, 0.0, 790.25, 210.75, 0.0, 0.0, 1.0 ]
    },
    "distortion_coefficients": {
        "type_id": "opencv-matrix",
        "rows": 4,
        "cols": 1,
        "dt": "d",
        "data": [ 0.02, -0.012999999999999999, 0.0060000000000000001,
            -0.0011000000000000001 ]
    }
}
"""
ROS_YAML = """image_width: 640
image_height: 480
camera_name: narrow # a stereo pair's left one
camera_matrix:
  rows: 3
  cols: 3
  data: [820.5, 0, 333.25,
         0, 790.25, 210.75, 0, 0, 1]
distortion_model: rational_polynomial
distortion_coefficients:
  rows: 1
  cols: 8
  data: [0.4, -0.1, 0.0006, 0.0011, 0.03, 0.65, -0.05, 2e-2]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]
"""
# Output of `rostopic echo -n 1` and `ros2 topic echo --once` for a CameraInfo.
ROS_MESSAGE = """header:
  seq: 12
  stamp:
    secs: 1700000000
    nsecs: 100000000
  frame_id: "narrow"
height: 480
width: 640
distortion_model: "plumb_bob"
D: [-0.25, 0.07, 0.001, -0.0007, -0.01]
K: [820.5, 0.0, 333.25, 0.0, 790.25, 210.75, 0.0, 0.0, 1.0]
R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
P: [800.0, 0.0, 330.0, 0.0, 0.0, 780.0, 210.0, 0.0, 0.0, 0.0, 1.0, 0.0]
binning_x: 0
binning_y: 0
roi:
  x_offset: 0
  y_offset: 0
  height: 0
  width: 0
  do_rectify: False
---
"""
ROS2_MESSAGE = """header:
  stamp:
    sec: 1700000000
    nanosec: 100000000
  frame_id: narrow
height: 480
width: 640
distortion_model: equidistant
d:
- 0.02
- -0.013
- 0.006
- -0.0011
k:
- 820.5
- 0.0
- 333.25
- 0.0
- 790.25
- 210.75
- 0.0
- 0.0
- 1.0
r:
- 1.0
p:
- 800.0
binning_x: 0
roi:
  height: 0
  width: 0
---
"""
# Calibrations in the form of Kalibr's and EuRoC's data sets.
KALIBR_YAML = """cam0:
  cam_overlaps: []
  camera_model: pinhole
  distortion_coeffs: [0.02, -0.013, 0.006, -0.0011]
  distortion_model: equidistant
  intrinsics: [820.5, 790.25, 333.25, 210.75]
  T_cam_imu:
  - [1.0, 0.0, 0.0, 0.0]
  - [0.0, 1.0, 0.0, 0.0]
  resolution: [640, 480]
  rostopic: /cam0/image_raw
"""
EUROC_YAML = """# General sensor definitions.
sensor_type: camera
comment: VI-Sensor cam0 (MT9M034)

T_BS:
  cols: 4
  rows: 4
  data: [0.0148655429818, -0.999880929698, 0.00414029679422, -0.0216401454975,
         0.0, 0.0, 0.0, 1.0]

# Camera specific definitions.
rate_hz: 20
resolution: [640, 480]
camera_model: pinhole
intrinsics: [820.5, 790.25, 333.25, 210.75] #fu, fv, cu, cv
distortion_model: radial-tangential
distortion_coefficients: [-0.25, 0.07, 0.001, -0.0007]
"""
OPENCV_XML = """<?xml version="1.0"?>
<opencv_storage>
<calibration_time>"Thu Nov 26 20:00:00 2026"</calibration_time>
<image_width>640</image_width>
<image_height>480</image_height>
<!-- flags: +fix_aspectRatio > +fix_principal_point -->
<flags>6</flags>
<camera_matrix type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    820.5 0. 333.25 0. 790.25 210.75 0. 0. 1.</data></camera_matrix>
<distortion_coefficients type_id="opencv-matrix">
  <rows>5</rows>
  <cols>1</cols>
  <dt>d</dt>
  <data>
    -0.25 0.070000000000000007 0.001 -0.00069999999999999999
    -0.01</data></distortion_coefficients>
<grid_points>
  1.5 2.</grid_points>
<views><_><name>"a.png"</name></_></views>
</opencv_storage>
"""


def bent(k=(), fisheye=False):
    """Where a lens of K, VECTOR and SHIFT sees POINTS by OpenCV's formulas for k1, k2, p1, p2 or a
    fisheye's k1, k2."""
    x, y = projected(numpy.eye(3), LENSES["pinhole"].R, SHIFT, POINTS).T
    k1, k2, p1, p2 = (*k, 0, 0, 0, 0)[:4]
    r2 = x * x + y * y
    if fisheye:
        angle = numpy.arctan(numpy.sqrt(r2))
        scale = angle * (1 + k1 * angle**2 + k2 * angle**4) / numpy.sqrt(r2)
        a, b = scale * x, scale * y
    else:
        scale = 1 + k1 * r2 + k2 * r2 * r2
        a = x * scale + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        b = y * scale + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    return numpy.stack([K[0, 0] * a + K[0, 2], K[1, 1] * b + K[1, 2]], axis=-1)


class Words(unittest.TestCase):
    """Sensors by their words and by calibrations' files, against those made of numbers."""

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return path

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = held.name

    def same(self, one, other):
        self.assertIs(type(one), type(other))
        self.assertEqual(one.size, other.size)
        numpy.testing.assert_allclose(one.rays()[1], other.rays()[1], atol=1e-12)

    def test_files_of_others(self):
        for name, text, lens in (
            ("a.yml", OPENCV_YAML, "brown"), ("b.JSON", OPENCV_JSON, "fisheye"),
            ("c.yaml", ROS_YAML, "rational"), ("d.yaml", ROS_MESSAGE, "brown"),
            ("e.yml", ROS2_MESSAGE, "fisheye"),
            ("f.json", json.dumps({"width": 640, "height": 480, "K": K.ravel().tolist(),
                                   "distortion_model": "rational_polynomial", "D": RATIONAL}),
             "rational"),
            # OpenCV's model of 14 numbers, the last six of them 0, and its first 5.
            ("g.yml", ROS_YAML.replace("cols: 8", "cols: 14")
             .replace("2e-2]", "2e-2, 0, 0, 0, 0, 0, 0]"), "rational"),
            ("h.yml", ROS_YAML.replace("cols: 8", "cols: 4").replace("rational_polynomial", '""')
             .replace("0.4, -0.1, 0.0006, 0.0011, 0.03, 0.65, -0.05, 2e-2", "0, 0, 0, 0"),
             "pinhole"),
            # Several messages of one topic: the first; a comment in a string, and keys in braces.
            ("n.yaml", ROS_MESSAGE + ROS_MESSAGE.replace("640", "320"), "brown"),
            ("o.yaml", "frame: 'a # b: c'\n" + ROS_MESSAGE, "brown"),
            ("p.yaml", "{width: 640, height: 480, distortion_model: plumb_bob,\n"
             f" K: {K.ravel().tolist()}, D: [-0.25, 0.07, 0.001, -0.0007, -0.01]}}\n", "brown"),
            ("i.yaml", KALIBR_YAML, "fisheye"), ("j.XML", OPENCV_XML, "brown"),
            ("k.xml.gz", gzip.compress(OPENCV_XML.encode()), "brown"),
            ("l.yml.gz", gzip.compress(OPENCV_YAML.encode()), "brown"),
            ("m.json.gz", gzip.compress(OPENCV_JSON.encode()), "fisheye"),
        ):
            with self.subTest(file=name):
                path = self.file(name, text)
                made = relievo.lens(path, R=VECTOR, t=SHIFT)
                self.assertEqual(made.size, SIZE)
                numpy.testing.assert_allclose(made.project(POINTS), OPENCV[lens], atol=1e-9)
                # Twice as large, each pixel is four.
                large = relievo.lens(path, (1280, 960), R=VECTOR, t=SHIFT)
                numpy.testing.assert_allclose(
                    (large.project(POINTS) + 0.5) / 2 - 0.5, OPENCV[lens], atol=1e-9)

    def test_models_of_others(self):
        """COLMAP's models, whose first pixel has its centre at (0.5, 0.5), Kalibr's and EuRoC's."""
        def square(places):
            """Of one focal length."""
            return (places - K[:2, 2]) * (1, K[0, 0] / K[1, 1]) + K[:2, 2]

        def colmap(model, *k):
            focal = "820.5" if one_focal(model) else "820.5 790.25"
            return ("# Camera list with one line of data per camera:\n# Number of cameras: 1\n"
                    f"1 {model} 640 480 {focal} 333.75 211.25 {' '.join(map(str, k))}\n")

        def one_focal(model):
            return "SIMPLE" in model or "RADIAL" in model

        for model, k, places in (
            ("SIMPLE_PINHOLE", (), bent()), ("PINHOLE", (), bent()),
            ("SIMPLE_RADIAL", BROWN[:1], bent(BROWN[:1])), ("RADIAL", BROWN[:2], bent(BROWN[:2])),
            ("OPENCV", BROWN[:4], bent(BROWN[:4])), ("FULL_OPENCV", RATIONAL, OPENCV["rational"]),
            ("OPENCV_FISHEYE", FISHEYE, OPENCV["fisheye"]),
            ("SIMPLE_RADIAL_FISHEYE", FISHEYE[:1], bent(FISHEYE[:1], True)),
            ("RADIAL_FISHEYE", FISHEYE[:2], bent(FISHEYE[:2], True)),
        ):
            with self.subTest(model=model):
                made = relievo.lens(self.file("cameras.txt", colmap(model, *k)), None, 30, VECTOR,
                                    SHIFT)  # fmt: skip
                self.assertEqual(made.size, SIZE)
                expected = square(places) if one_focal(model) else places
                numpy.testing.assert_allclose(made.project(POINTS), expected, atol=1e-9)
        for name, text, places in (
            ("EuRoC", EUROC_YAML, bent(BROWN[:4])),
            ("Kalibr", KALIBR_YAML.replace("equidistant", "radtan")
             .replace(str(list(FISHEYE)), str(list(BROWN[:4]))), bent(BROWN[:4])),
            ("none", KALIBR_YAML.replace("equidistant", "none")
             .replace(str(list(FISHEYE)), "[]"), bent()),
            ("k1 alone", ROS_MESSAGE.replace(", 0.07, 0.001, -0.0007, -0.01", ""),
             bent(BROWN[:1])),
        ):
            with self.subTest(name=name):
                made = relievo.lens(self.file("a.yaml", text), R=VECTOR, t=SHIFT)
                self.assertEqual(made.size, SIZE)
                numpy.testing.assert_allclose(made.project(POINTS), places, atol=1e-9)

    def test_words(self):
        size = (64, 48)
        middle = [31.5, 23.5]
        tangent = 24 / numpy.tan(numpy.radians(20))
        straight = [[tangent, 0, 31.5], [0, tangent, 23.5], [0, 0, 1]]
        given = [[50, 0, 30], [0, 60, 20], [0, 0, 1]]
        turned = {"size": size, "R": VECTOR, "t": SHIFT}
        for words, other in (
            ("pinhole", relievo.Pinhole(straight, **turned)),
            ("brown:0.1,0.2,0,0,K=50/60/30/20",
             relievo.Pinhole(given, distortion=(0.1, 0.2), **turned)),
            ("fisheye:0.1,K=50/60/30/20",
             relievo.Fisheye(given, D=(0.1,), **turned)),
            ("equirectangular:120,90", relievo.Equirectangular(field=(120, 90), **turned)),
            ("equirectangular", relievo.Equirectangular(**turned)),
            ("orthographic:7.5", relievo.Orthographic(7.5, center=middle, **turned)),
        ):
            with self.subTest(words=words):
                self.same(relievo.lens(words, size, 40, VECTOR, SHIFT), other)
        self.same(relievo.lens("cube", (96, 16)), relievo.Cube(16))

    def test_part_of_the_sensor(self):
        """A CameraInfo of a part of the sensor's picture, or with several of its pixels in one."""
        part = {"x_offset: 0": "x_offset: 40", "y_offset: 0": "y_offset: 100",
                "  height: 0": "  height: 302", "  width: 0": "  width: 404"}
        whole = relievo.lens(self.file("whole.yml", ROS_MESSAGE), R=VECTOR, t=SHIFT)
        for name, changes, size, offset, bins in (
            ("part", part, (404, 302), (40, 100), (1, 1)),
            ("bins", {"binning_x: 0": "binning_x: 2", "binning_y: 0": "binning_y: 4"},
             (320, 120), (0, 0), (2, 4)),
            ("both", {**part, "binning_x: 0": "binning_x: 3"}, (134, 302), (40, 100), (3, 1)),
            ("rest", {"x_offset: 0": "x_offset: 600"}, (40, 480), (600, 0), (1, 1)),
        ):
            with self.subTest(name=name):
                text = ROS_MESSAGE
                for old, new in changes.items():
                    self.assertEqual(text.count(old), 1)
                    text = text.replace(old, new)
                made = relievo.lens(self.file(f"{name}.yml", text), R=VECTOR, t=SHIFT)
                self.assertEqual(made.size, size)
                # A pixel's edges are those of the pixels that it is made of.
                places = (whole.project(POINTS) + 0.5 - offset) / bins - 0.5
                numpy.testing.assert_allclose(made.project(POINTS), places, atol=1e-9)

    def test_view_angle(self):
        """Without K the picture's height spans the angle, through the lens."""
        for words, angle in (("pinhole", 50), ("brown:-0.1,0.01,0.001,0.002", 50), ("fisheye", 200),
                             ("fisheye:0.02,-0.013,0.006,-0.0011", 170), ("division:-0.2", 120)):
            with self.subTest(words=words):
                made = relievo.lens(words, (65, 48), angle)
                edges = made.rays([(32, -0.5), (32, 47.5)])[1]
                between = numpy.arctan2(edges[:, 1], edges[:, 2])
                self.assertAlmostEqual(numpy.degrees(between[1] - between[0]), angle,
                                       delta=0.2 if words.startswith("brown") else 1e-9)
                for mark in ",:" if ":" not in words else ",":
                    self.same(relievo.lens(f"{words}{mark}angle={angle}", (65, 48), 20), made)

    def test_refused(self):
        for part, words in (
            ("got 'fishy', expected pinhole, brown:K1", "fishy"),
            ("brown:K1,K2.*finite", "brown:0.1"), ("finite", "fisheye:0.1,nan"),
            ("finite", "fisheye:"), ("fisheye", "fisheye:1,2,3,4,5"),
            ("angle=DEG", "fisheye:angle=0"), ("angle=DEG", "fisheye:angle=90,0.1"),
            ("angle=DEG", "pinhole:angle=9,K=1/1/1/1"), ("K=FX", "fisheye:K=1/2/3"),
            ("FX and FY above 0", "fisheye:K=0/1/0/0"),
            ("DEG above 0 and at most 360", "pinhole:angle=400"),
            ("six times.*288x48", "cube"), ("expected cube alone", "cube:3"),
            ("cannot span 200 degrees", "pinhole"),
            ("degrees above 0, H at most 360 and V at most 180", "equirectangular:400,20"),
            ("PIXELS.: a finite number above 0", "orthographic:-1"),
            ("JSON object", self.file("a.json", "[1, 2")),
            ("image_width: it is missing", self.file("b.yml", "camera_matrix: 1\n")),
            ("camera_matrix: expected 9",
             self.file("c.yml", OPENCV_YAML.replace("0., 0., 1.", "0."))),
            ("line 13: expected YAML, got end of sequence flow not found",
             self.file("d.yml", OPENCV_YAML.replace("1. ]", "1."))),
            ("distortion_model: got \"bent\"",
             self.file("e.yml", ROS_YAML.replace("rational_polynomial", "bent"))),
            # One number is lost: those behind it would each be taken for the one before.
            ("distortion_coefficients: its rows and cols give 5 numbers, but its data has 4",
             self.file("f.yml", OPENCV_YAML.replace("-0.25, ", ""))),
            ("distortion_coefficients: its rows and cols give 8 numbers, but its data has 9",
             self.file("h.yml", ROS_YAML.replace("2e-2]", "2e-2, 0.1]"))),
            ("D: got 3 numbers, expected 0, 2, 4, 5 or 8 finite numbers for the lens brown",
             self.file("i.yml", ROS_MESSAGE.replace("-0.0007, -0.01", ""))),
            ("third is p1 in OpenCV's order, k3 comes after p1 and p2",
             self.file("i3.yml", ROS_MESSAGE.replace(", -0.0007, -0.01", ""))),
            ("D: got 12 numbers, .*thin prisms", self.file("i12.yml", ROS_MESSAGE.replace(
                "-0.01]", "-0.01, 0, 0, 0, 0, 0.1, 0, 0]"))),
            ("no lens supports the model 'FOV', expected one of SIMPLE_PINHOLE, PINHOLE",
             self.file("a.txt", "1 FOV 640 480 800 800 320 240 0.9\n")),
            ("no lens supports the model 'THIN_PRISM_FISHEYE'",
             self.file("b.txt", "1 THIN_PRISM_FISHEYE 640 480 8 8 3 2 1 1 1 1 1 1 1 1\n")),
            ("it has 2 lines, expected COLMAP's cameras.txt of one camera",
             self.file("c.txt", "1 PINHOLE 640 480 8 8 3 2\n" * 2)),
            ("it has no camera, expected COLMAP's", self.file("d.txt", "a text\n")),
            ("got 5 parameters of PINHOLE, expected 4 finite numbers",
             self.file("e.txt", "1 PINHOLE 640 480 8 8 3 2 1\n")),
            ("got 4 parameters of PINHOLE, expected 4 finite numbers",
             self.file("f.txt", "1 PINHOLE 640 480 8 8 3 nan\n")),
            ("camera_model: got \"omni\", expected pinhole",
             self.file("s.yaml", KALIBR_YAML.replace("pinhole", "omni"))),
            ("distortion_model: got \"fov\"",
             self.file("t.yaml", KALIBR_YAML.replace("equidistant", "fov"))),
            ("it has 2 cameras, cam0 to cam1, expected one",
             self.file("u.yaml", KALIBR_YAML + KALIBR_YAML.replace("cam0:", "cam1:"))),
            ("intrinsics: expected 4 numbers",
             self.file("v.yaml", EUROC_YAML.replace("820.5, ", ""))),
            ("resolution: expected 2 numbers",
             self.file("w.yaml", EUROC_YAML.replace("resolution", "size"))),
            ("expected 0 finite numbers for the lens pinhole",
             self.file("x.yaml", KALIBR_YAML.replace("equidistant", "none"))),
            ("it is no opencv_storage of XML", self.file("a.xml", OPENCV_XML[:-20])),
            ("it is no opencv_storage of XML", self.file("b.xml", "<svg></svg>")),
            ("it is no opencv_storage of XML",
             self.file("c.xml", "<opencv_storage>" + "<a>" * 40000)),
            ("it is no opencv_storage of XML",
             self.file("d.xml", OPENCV_XML.replace("</rows>", "</cols>"))),
            ("expected complete gzip data", self.file("a.yml.gz", OPENCV_YAML)),
            ("expected complete gzip data",
             self.file("b.yml.gz", gzip.compress(OPENCV_YAML.encode())[:-9])),
            ("no larger than a calibration",
             self.file("c.yml.gz", gzip.compress(bytes(70 << 20), 1))),
            ("d: got 5 numbers, expected 0, 1, 2, 3 or 4 finite",
             self.file("j.yml", ROS2_MESSAGE.replace("d:\n", "d:\n- 0.1\n"))),
            ("distortion_coefficients: expected 0, 2, 4, 5 or 8 finite",
             self.file("k.yml", OPENCV_YAML.replace("-0.25", ".nan"))),
            ("k: expected 9 numbers", self.file("l.yml", ROS2_MESSAGE.replace("- 790.25\n", ""))),
            ("pictures of 640x480.*shape", self.file("g.yml", OPENCV_YAML)),
            ("brown:K1,K2", "brown,0.1,0.2"), ("equirectangular", "equirectangular,angle=90"),
            ("roi: got .*expected x_offset",
             self.file("m.yml", ROS_MESSAGE.replace("x_offset: 0", "x_offset: 640"))),
            ("roi: got ", self.file("n.yml", ROS_MESSAGE.replace("  width: 0", "  width: 641"))),
            ("binning_y: got 0.5, expected a whole number",
             self.file("o.yml", ROS_MESSAGE.replace("binning_y: 0", "binning_y: 0.5"))),
            # Lists in lists, more than a stack has room for.
            ("expected YAML, got ", self.file("p.yml", OPENCV_YAML.replace(
                "camera_matrix: !!opencv-matrix", "camera_matrix: " + "[" * 40000))),
            # A billion values by ten aliases; a list that is no matrix at all.
            ("expected YAML, got an alias", self.file("y1.yml", "a: &a [1, 1]\nk: [*a, *a]\n")),
            ("more values than a calibration has", self.file("y2.yml", "k: [" + "1," * 200000)),
            ("line 2: expected YAML, got width is there twice",
             self.file("y3.yml", "width: 640\nwidth: 641\n")),
            ("expected YAML, got ", self.file("y4.yml", "? " * 40000)),
            ("expected YAML, got ", self.file("y5.yml", "{" * 40000)),
            ("expected YAML, got ", self.file("y6.yml", "- " * 40000)),
            ("it is no YAML map", self.file("y7.yml", "")),
            ("it is no YAML map", self.file("y8.yml", "- 1\n")),
            # Bytes that are no UTF-8 ended the process.
            ("distortion_model: got \"", self.file("z.yml", ROS_YAML.encode().replace(
                b"rational_polynomial", b"\xff\xfe"))),
            ("distortion_model: got \"", self.file("z.xml", OPENCV_XML.encode().replace(
                b"<flags>6</flags>", b"<distortion_model>\xff\xfe</distortion_model>"))),
            ("camera_matrix: expected 9", self.file("q.json", json.dumps(
                {"image_width": 64, "image_height": 49, "camera_matrix": "@"}).replace(
                    '"@"', "[" * 40000 + "]" * 40000))),
            ("distortion_model: got", self.file("r.json", json.dumps(
                {"width": 64, "height": 49, "K": K.ravel().tolist(), "distortion_model": "@"})
                .replace('"@"', "[" * 40000 + "]" * 40000))),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, f"lens: .*{part}"):
                relievo.lens(words, (64, 49) if "shape" in part else (64, 48), 200)
        with self.assertRaisesRegex(ValueError, "size: got None"):
            relievo.lens("fisheye")
        with self.assertRaisesRegex(FileNotFoundError, "/nowhere/a.yml"):
            relievo.lens("/nowhere/a.yml")


if __name__ == "__main__":
    unittest.main(verbosity=2)
