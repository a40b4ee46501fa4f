# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sensors by rays: compared with frames, closed forms and separate projections."""

import concurrent.futures
import itertools
import pathlib
import pickle
import shlex
import tempfile
import unittest

import numpy
import scenes
from testDatasets import vtkCompositeMapper
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkLineSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCompositeDataDisplayAttributes,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

import relievo
from relievo.vtkRelievoFilters import vtkRelievoRayLayers

SIZE = (160, 121)
K = numpy.array([[180.5, 2, 77.0], [0, 175.25, 63.5], [0, 0, 1]])


def mesh_of(points, cells):
    """Polygons of these corners."""
    mesh = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.array(points, float), deep=True))
    mesh.SetPoints(places)
    polygons = vtkCellArray()
    for cell in cells:
        polygons.InsertNextCell(len(cell))
        for corner in cell:
            polygons.InsertCellPoint(corner)
    mesh.SetPolys(polygons)
    return mesh


def add_field(mesh, name, values):
    """A point array of the mesh."""
    array = numpy_to_vtk(numpy.array(values, float), deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def grid(x, y, z, columns, rows):
    """A rectangle of quads from three corners: the first, along its columns, along its rows."""
    first, across, along = (numpy.array(each, float) for each in (x, y, z))
    points = [
        first + (across - first) * i / columns + (along - first) * j / rows
        for j in range(rows + 1) for i in range(columns + 1)
    ]
    cells = [
        (a, a + 1, a + columns + 2, a + columns + 1)
        for j in range(rows) for i in range(columns)
        for a in [j * (columns + 1) + i]
    ]
    return mesh_of(points, cells)


def box(center, half):
    """The six faces of a cube, normals outwards."""
    corners = [
        [center[axis] + half * (1 if i >> axis & 1 else -1) for axis in range(3)]
        for i in range(8)
    ]
    return mesh_of(corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2),
                             (1, 3, 7, 5)])


def array(data, name):
    """An array of the cells or of the points."""
    found = data.GetCellData().GetArray(name) or data.GetPointData().GetArray(name)
    return vtk_to_numpy(found)


def first_hits(origin, directions, corners):
    """The triangles that rays from a place meet first, -1: none, and at which share of their
    directions, by Cramer's rule (T. Moeller, B. Trumbore 1997)."""
    a, b, c = corners.transpose(1, 0, 2)
    from_a = origin - a
    normals = numpy.cross(b - a, c - a)
    sides = numpy.cross(from_a, directions[:, None])
    with numpy.errstate(divide="ignore", invalid="ignore"):
        scale = -1 / numpy.einsum("rk,tk->rt", directions, normals)
        u = numpy.einsum("rtk,tk->rt", sides, c - a) * scale
        v = -numpy.einsum("rtk,tk->rt", sides, b - a) * scale
        share = numpy.einsum("tk,tk->t", from_a, normals) * scale
    met = (u >= 0) & (v >= 0) & (u + v <= 1) & (share >= 0)
    share = numpy.where(met, share, numpy.inf)
    first = share.argmin(axis=1)
    nearest = share[numpy.arange(len(first)), first]
    return numpy.where(numpy.isfinite(nearest), first, -1), nearest


class Layers(unittest.TestCase):
    """capture(camera=) equals the frame's picture if the camera is a pinhole."""

    NAMES = ["depth", "range", "position", "normal", "geometric_normal", "actor", "block", "cell"]

    def test_pinhole_is_the_frame(self):
        renderer = scenes.plane_and_sphere()
        R, t = relievo.extrinsics(renderer)
        relievo.camera(renderer, K=K, size=SIZE, R=R, t=t)
        names = [*self.NAMES, "Normals"]
        drawn = relievo.capture(renderer, names, size=SIZE)
        sensor = relievo.Pinhole(K, SIZE, R, t)
        traced = relievo.capture(renderer, names, camera=sensor)
        for name in ("K", "R", "t"):
            numpy.testing.assert_allclose(relievo.attributes(traced)[name],
                                          relievo.attributes(drawn)[name], atol=1e-9)
        same = numpy.all([relievo.layer(drawn, name) == relievo.layer(traced, name)
                          for name in ("actor", "block", "cell")], axis=0)
        self.assertGreater(same.mean(), 0.998)  # edges through a pixel's centre
        for name, tolerance in (("depth", 1e-6), ("range", 1e-6), ("position", 1e-4),
                                ("normal", 1e-3), ("geometric_normal", 1e-3), ("Normals", 1e-3)):
            one, other = relievo.layer(drawn, name), relievo.layer(traced, name)
            self.assertEqual(one.dtype, other.dtype, name)
            numpy.testing.assert_allclose(other[same], one[same], rtol=tolerance, atol=tolerance,
                                          err_msg=name)

    def test_ambient_before_a_wall(self):
        renderer = vtkRenderer()
        for mesh in (grid((0, -80, 0), (80, -80, 0), (0, 80, 0), 1, 1),
                     grid((0, -80, 0), (0, 80, 0), (0, -80, 1), 1, 1)):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(mesh)
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)
        lens = numpy.array([[30, 0, 32], [0, 30, 32], [0, 0, 1.0]])
        sensor = relievo.Fisheye(lens, (64, 64)).look_at((2, 0, 1.5), (1, 0, 0), (0, 0, 1))
        errors = {}
        for settings, truth in (
            ({}, lambda x: 0.5 + 0.5 / numpy.sqrt(1 + 1 / x**2)),
            ({"samples": 256}, lambda x: 0.5 + 0.5 / numpy.sqrt(1 + 1 / x**2)),
            ({"weighting": "uniform", "seed": 3}, lambda x: 1 - numpy.arctan(1 / x) / numpy.pi),
        ):
            image = relievo.capture(renderer, ["ambient", "position", "actor"], camera=sensor,
                                    ambient=settings)
            x = relievo.layer(image, "position")[..., 0]
            floor = (relievo.layer(image, "actor") == 0) & (x > 1e-3)
            off = relievo.layer(image, "ambient")[floor] - truth(x[floor])
            errors[str(settings)] = numpy.sqrt((off**2).mean())
            self.assertGreater(floor.sum(), 1000)
        one, many, uniform = errors.values()
        print("rms before a wall by rays:", errors)
        self.assertLess(max(one, uniform), 1 / 64)
        self.assertLess(many, 1 / 160)
        self.assertTrue((relievo.layer(image, "ambient")[relievo.layer(image, "actor") < 0]
                         == 1).all())
        near = relievo.capture(renderer, ["ambient"], camera=sensor, ambient={"radius": 0.25})
        self.assertTrue((relievo.layer(near, "ambient")[floor & (x > 0.25)] == 1).all())
        self.assertLess(relievo.layer(near, "ambient")[floor & (x < 0.1)].mean(), 0.8)
        for bad in ({"sample": 3}, {"samples": 0}, {"weighting": "even"}, {"radius": -1}):
            with self.assertRaises(ValueError):
                relievo.capture(renderer, ["ambient"], camera=sensor, ambient=bad)
        with self.assertRaises(ValueError):
            relievo.capture(renderer, ["ambient"], size=SIZE, ambient={"samples": 3})

    def test_whole_numbers_come_as_they_are(self):
        mesh = box((0, 0, 0), 0.5)
        ids = numpy_to_vtk(numpy.arange(6, dtype=numpy.int32) + 2**24, deep=True)
        ids.SetName("id")
        mesh.GetCellData().AddArray(ids)
        sensor = relievo.Pinhole(K, SIZE).look_at((3, 2, 4), (0, 0, 0))
        image = relievo.capture(mesh, ["id", "cell"], camera=sensor)
        cell = relievo.layer(image, "cell")
        numpy.testing.assert_array_equal(relievo.layer(image, "id")[cell >= 0],
                                         cell[cell >= 0] + 2.0**24)
        self.assertTrue(numpy.isnan(relievo.layer(image, "id")[cell < 0]).all())

    def test_lenses_see_along_their_rays(self):
        ball = vtkSphereSource()
        ball.SetThetaResolution(400)
        ball.SetPhiResolution(400)
        ball.Update()
        mesh = ball.GetOutput()
        for sensor in (
            relievo.Fisheye(numpy.array([[40.0, 0, 50], [0, 40, 50], [0, 0, 1]]), (101, 101)),
            relievo.Pinhole(K, SIZE, distortion=(-0.2, 0.02)),
            relievo.Equirectangular((120, 60)),
            relievo.Cube(31),
            relievo.Orthographic(60, (90, 90)),
            relievo.Pushbroom(100, (0, 0.02, 0), (80, 80)),
            relievo.Lidar(numpy.linspace(20, -20, 21), steps=360),
        ):
            with self.subTest(sensor=type(sensor).__name__):
                sensor.look_at((0.2, 0.1, 1.4), (0, 0, 0))
                image = relievo.capture(mesh, ["range", "position", "depth"], camera=sensor)
                # The first root of |o + s d| = 1/2.
                origins, directions = sensor.rays()
                b = (origins * directions).sum(axis=-1)
                under = b**2 - (origins**2).sum(axis=-1) + 0.25
                with numpy.errstate(invalid="ignore"):
                    root = -b - numpy.sqrt(under)
                inside = numpy.nan_to_num(under, nan=-1) > 0.01
                inside &= numpy.nan_to_num(root, nan=-1) > 0
                self.assertGreater(inside.sum(), 50)
                seen = relievo.layer(image, "range")
                self.assertLess(numpy.abs(seen - root)[inside].max(), 3e-4)
                off = sensor.project(relievo.layer(image, "position")[inside])
                v, u = numpy.nonzero(inside)
                self.assertLess(numpy.abs(off - numpy.stack([u, v], axis=-1)).max(), 1e-6)

    def test_refused(self):
        sensor = relievo.Cube(4)
        with self.assertRaisesRegex(ValueError, "no layer 'albedo'"):
            relievo.capture(box((0, 0, 0), 1), "albedo", camera=sensor)
        with self.assertRaisesRegex(ValueError, "no layer 'missing'"):
            relievo.capture(box((0, 0, 0), 1), "missing", camera=sensor)
        with self.assertRaisesRegex(ValueError, "size: got"):
            relievo.capture(box((0, 0, 0), 1), "depth", camera=sensor, size=(3, 3))
        with self.assertRaisesRegex(ValueError, "CameraModel"):
            relievo.capture(box((0, 0, 0), 1), "depth", camera=3)


class Seen(unittest.TestCase):
    """visible(): cells behind others, cells smaller than pixels, solid angles."""

    def test_cube(self):
        sensor = relievo.Pinhole(K, SIZE).look_at((3, 2, 4), (0, 0, 0))
        seen, cloud = relievo.visible(box((0, 0, 0), 0.5), sensor, cloud=True)
        numpy.testing.assert_array_equal(vtk_to_numpy(seen.GetCellData().GetArray("seen")),
                                         [0, 1, 0, 1, 0, 1])
        numpy.testing.assert_array_equal(vtk_to_numpy(seen.GetPointData().GetArray("seen")),
                                         [0, 1, 1, 1, 1, 1, 1, 1])
        self.assertEqual(cloud.GetNumberOfPoints(), array(seen, "pixels").sum())
        points = vtk_to_numpy(cloud.GetPoints().GetData())
        self.assertLess(numpy.abs(numpy.abs(points).max(axis=-1) - 0.5).max(), 1e-12)

    def test_solid_angles(self):
        # A square of side 2 a from the height a over its middle: a sixth of the sphere.
        sensor = relievo.Equirectangular((400, 200)).look_at((0, 0.5, 0), (1, 0.5, 0))
        seen = relievo.visible(box((0, 0.5, 0), 0.5), sensor)
        angles = array(seen, "solid_angle")
        numpy.testing.assert_allclose(angles, 4 * numpy.pi / 6, rtol=0.01)
        self.assertAlmostEqual(angles.sum(), 4 * numpy.pi, 3)

    def test_solid_angles_of_small_cells(self):
        """Cells of any number of pixels sum to the square's closed form, whole or half hidden."""
        half, away = 1.0, 3.0
        truth = 4 * numpy.arcsin(half**2 / (half**2 + away**2))
        half_wall = grid((0, -1, 1), (1, -1, 1), (0, 1, 1), 1, 1)
        for pixels in (100, 20, 8, 3, 1, 0.4, 0.2, 0.03):
            count = round(64 / pixels**0.5)  # the square is 64 pixels wide
            square = grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), count, count)
            sensor = relievo.Pinhole([[96, 0, 47.3], [0, 96, 48.1], [0, 0, 1]], (96, 96))
            sensor.look_at((0, 0, away), (0, 0, 0), (0, 1, 0))
            whole = array(relievo.visible(square, sensor), "solid_angle").sum()
            self.assertAlmostEqual(whole / truth, 1, delta=0.005, msg=f"{pixels} pixels a cell")
            seen = relievo.visible(square, [sensor, sensor], occluders=half_wall)
            left = array(seen, "solid_angle").sum() / 2
            self.assertAlmostEqual(left / truth, 0.5, delta=0.02, msg=f"{pixels} pixels a cell")

    def test_lidars(self):
        """Within a box a scanner sees the band between its outer beams, as far as it reaches."""
        mesh = box((0, 0, 0), 4)
        sensor = relievo.Lidar(numpy.arange(20, -20.5, -1), steps=360)
        seen = relievo.visible(mesh, sensor)
        band = 4 * numpy.pi * numpy.sin(numpy.radians(20.5))
        self.assertAlmostEqual(array(seen, "solid_angle").sum() / band, 1, delta=0.01)
        self.assertEqual(array(seen, "pixels").sum(), 41 * 360)
        # Walls are 4 away; a beam reaches those within acos(4 / 4.5) of a wall's normal.
        near = relievo.Lidar(numpy.arange(20, -20.5, -1), steps=360, max_range=4.5)
        origins, directions = near.rays()
        expected = (4 / numpy.abs(directions).max(axis=-1) <= 4.5).sum()
        self.assertEqual(array(relievo.visible(mesh, near), "pixels").sum(), expected)
        self.assertEqual(array(relievo.visible(
            mesh, relievo.Lidar([5, 0], steps=90, min_range=4.2, max_range=5)), "seen").max(), 1)
        far = relievo.Lidar([5, 0], steps=90, min_range=7)
        self.assertEqual(array(relievo.visible(mesh, far), "seen").max(), 0)
        self.assertEqual(vtk_to_numpy(relievo.visible(mesh, far).GetPointData().GetArray("seen"))
                         .max(), 0)
        depth = relievo.layer(relievo.capture(mesh, "depth", camera=near), "depth")
        self.assertEqual(numpy.isfinite(depth).sum(), expected)

    def test_beams_that_diverge(self):
        """A beam over an edge returns from the plate before it first, and from the wall last."""
        plate = grid((5, -9, -9), (5, 0, -9), (5, -9, 9), 1, 1)
        wall = grid((10, -50, -50), (10, 50, -50), (10, -50, 50), 1, 1)
        scene = vtkAppendPolyData()
        for each in (plate, wall):
            scene.AddInputData(each)
        scene.Update()
        azimuths = [-1.6, -0.5, 0.5, 1.6]  # degrees; the edge is at 0, beams are 2 wide
        for returns, expected in (("first", [5, 5, 5, 10]), ("last", [5, 10, 10, 10])):
            sensor = relievo.Lidar([0] * 4, azimuths=azimuths, divergence=2, samples=64,
                                   returns=returns)
            image = relievo.capture(scene.GetOutput(), ["position", "range"], camera=sensor)
            position = relievo.layer(image, "position")
            numpy.testing.assert_allclose(position[0, :, 0], expected, rtol=1e-6)
            numpy.testing.assert_allclose(  # of the ray that returned
                relievo.layer(image, "range")[0], numpy.linalg.norm(position[0], axis=-1),
                rtol=1e-6)
            away = numpy.degrees(numpy.arccos((sensor.rays()[1][0] * position[0]).sum(axis=-1)
                                              / numpy.linalg.norm(position[0], axis=-1)))
            self.assertLessEqual(away.max(), 1 + 1e-6)
            self.assertGreater(away.max(), 0.5)
            noisy = relievo.Lidar([0] * 4, azimuths=azimuths, divergence=2, samples=64, noise=0.1,
                                  returns=returns)
            image = relievo.capture(scene.GetOutput(), ["position", "range"], camera=noisy)
            moved = relievo.layer(image, "position")[0]
            lengths = numpy.linalg.norm(moved, axis=-1)
            numpy.testing.assert_allclose(lengths, relievo.layer(image, "range")[0], rtol=1e-6)
            self.assertTrue((lengths != numpy.linalg.norm(position[0], axis=-1)).all())
            numpy.testing.assert_allclose(
                moved / lengths[:, None],
                position[0] / numpy.linalg.norm(position[0], axis=-1, keepdims=True), atol=1e-6)

    def test_range_noise(self):
        """Errors are normally distributed, along the beam, and the seed repeats them."""
        wall = box((0, 0, 0), 4)

        def capture(**words):
            sensor = relievo.Lidar(numpy.arange(20, -20.5, -1), steps=360, **words)
            image = relievo.capture(wall, ["range", "position"], camera=sensor)
            return sensor.rays()[1], *(relievo.layer(image, name) for name in ("range", "position"))

        _, exact, _ = capture()
        directions, noisy, position = capture(noise=0.02, seed=7)
        error = (noisy - exact).astype(float) / 0.02
        count = error.size
        self.assertLess(abs(error.mean()), 4 / count**0.5)
        self.assertLess(abs(error.std() - 1), 4 / (2 * count) ** 0.5)
        for within, share in ((1, 0.682689), (2, 0.954500), (3, 0.997300)):
            deviation = (share * (1 - share) / count) ** 0.5
            self.assertLess(abs((numpy.abs(error) < within).mean() - share), 4 * deviation)
        self.assertLess(abs((error[:, 1:] * error[:, :-1]).mean()), 4 / count**0.5)
        numpy.testing.assert_allclose(position, noisy[..., None] * directions, atol=1e-5)
        numpy.testing.assert_array_equal(capture(noise=0.02, seed=7)[1], noisy)
        other = (capture(noise=0.02, seed=8)[1] - exact).astype(float) / 0.02
        self.assertLess(abs((error * other).mean()), 4 / count**0.5)

    def test_concave_cells_are_seen_whole(self):
        # An L from above, whatever its first corner: by pixels whose rays end within it.
        outline = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
        camera = relievo.Pinhole(K, SIZE).look_at((1.03, 1.04, 4), (1.03, 1.04, 0), up=(0, 1, 0))
        plane = grid((-9, -9, 0), (9, -9, 0), (-9, 9, 0), 1, 1)
        there = relievo.layer(relievo.capture(plane, ["position"], camera=camera), "position")
        x, y = there[..., 0], there[..., 1]
        inside = (x > 0) & (y > 0) & (x < 2) & (y < 2) & ((x < 1) | (y < 1))
        for first in range(6):
            turned = outline[first:] + outline[:first]
            ell = mesh_of([(x, y, 0) for x, y in turned], [range(6)])
            self.assertEqual(array(relievo.visible(ell, camera), "pixels")[0], inside.sum())
            cell = relievo.layer(relievo.capture(ell, ["cell"], camera=camera), "cell")
            numpy.testing.assert_array_equal(cell >= 0, inside)
            # Drawn, fitted to the picture: three quarters of a square.
            drawn = relievo.layer(relievo.capture(ell, ["cell"], size=(200, 200)), "cell")
            rows, columns = numpy.nonzero(drawn >= 0)
            square = (numpy.ptp(rows) + 1) * (numpy.ptp(columns) + 1)
            self.assertAlmostEqual((drawn >= 0).sum() / square, 0.75, delta=0.02)
            self.assertEqual(drawn.max(), 0)

    def test_each_point_of_cells_by_hand(self):
        # Spheres in each other, one of them inside out, loose triangles, some of them twice, and a
        # ground that reaches behind the cameras: by all rays and triangles, in numpy.
        random = numpy.random.default_rng(3)
        points, cells = [], []
        for center, radius, turned in (((0, 0, 0), 1, False), ((0.3, 0.1, 0.2), 0.85, True)):
            ball = vtkSphereSource()
            ball.SetThetaResolution(16)
            ball.SetPhiResolution(10)
            ball.Update()
            first = len(points)
            corners = vtk_to_numpy(ball.GetOutput().GetPoints().GetData()).astype(float)
            points += list(2 * radius * corners + center)
            around = vtk_to_numpy(ball.GetOutput().GetPolys().GetConnectivityArray())
            cells += list((around.reshape(-1, 3) + first)[:, ::-1 if turned else 1])
        for place in random.uniform(-1.5, 1.5, (120, 3)):
            cells.append(len(points) + numpy.arange(3))
            points += list(place + random.normal(scale=0.15, size=(3, 3)))
        cells += cells[-30:]
        cells.append(len(points) + numpy.arange(3))
        points += [(-40, -41, -1.2), (60, -40, -1.25), (0, 70, -1.3)]
        self.compare_with_rays(numpy.array(points), numpy.array(cells))
        # Two plates wider than the pictures, one behind the other.
        points = numpy.stack(numpy.meshgrid(*[numpy.linspace(-30, 30, 15)] * 2), -1).reshape(-1, 2)
        points = [[0.1 * each, *place] for each in (-3, -7) for place in points]
        first = numpy.array([15 * j + i for j in range(14) for i in range(14)])[:, None]
        cells = numpy.concatenate([first + [0, 1, 16], first + [0, 16, 15]])
        self.compare_with_rays(numpy.array(points), numpy.concatenate([cells, cells + 225]))

    def test_far_sides_beside_silhouettes(self):
        # Some of a bumpy ring's far side is in the layers of its near side.
        turn, tilt = numpy.meshgrid(numpy.arange(46), numpy.arange(23), indexing="ij")
        u, v = 2 * numpy.pi * turn / 46, 2 * numpy.pi * tilt / 23
        thick = 0.4 + 0.02 * numpy.sin(12 * u) * numpy.sin(6 * v)
        far = 1 + thick * numpy.cos(v)
        points = numpy.stack([far * numpy.cos(u), far * numpy.sin(u), thick * numpy.sin(v)], -1)
        points = points.reshape(-1, 3)
        at = [((turn + i) % 46 * 23 + (tilt + j) % 23).ravel() for i, j in
              ((0, 0), (1, 0), (1, 1), (0, 1))]  # fmt: skip
        cells = numpy.concatenate([numpy.stack([at[0], at[k], at[k + 1]], -1) for k in (1, 2)])
        rays = relievo.rays(mesh_of(points, cells))

        def nearest(eye, directions, _):
            hits = rays.nearest(eye, directions)
            return hits.cell, hits.distance / numpy.linalg.norm(directions, axis=1)

        turns = 2.4 * numpy.arange(8)
        eyes = numpy.stack([numpy.cos(turns), numpy.sin(turns), numpy.linspace(-1, 1, 8)], -1)
        self.compare_with_rays(points, cells, nearest, 4 * eyes)

    def compare_with_rays(self, points, cells, first_hits=first_hits,
                          eyes=((3.5, 1, 0.4), (-1.1, -1.5, 1.2))):  # fmt: skip
        corners = points[cells]
        beside = numpy.array([(1 / 3,) * 3, *(numpy.eye(3) * 0.9 + 0.1 / 3)])
        samples = numpy.einsum("sk,cki->csi", beside, corners).reshape(-1, 3)
        mesh = mesh_of(points, cells)
        lens = numpy.array([[30, 0, 19.5], [0, 30, 14.5], [0, 0, 1.0]])
        for sensor in (relievo.Pinhole(lens, (40, 30)), relievo.Equirectangular((48, 24))):
            for eye in eyes:
                sensor.look_at(eye, (0.1, 0, 0), (0, 0, 1))
                seen = relievo.visible(mesh, sensor)
                directions = sensor.rays()[1].reshape(-1, 3)
                cell, _ = first_hits(eye, directions, corners)
                expected = numpy.bincount(cell[cell >= 0], minlength=len(cells))
                numpy.testing.assert_array_equal(array(seen, "pixels"), expected)
                cell, _ = first_hits(eye, samples - eye, corners)
                own = cell == numpy.repeat(numpy.arange(len(cells)), 4)
                own &= self.in_picture(sensor, samples)
                numpy.testing.assert_array_equal(
                    vtk_to_numpy(seen.GetCellData().GetArray("seen")),
                    (expected > 0) | own.reshape(-1, 4).any(axis=1))
                _, share = first_hits(eye, points - eye, corners)
                free = (share > 1 - 1e-9) & self.in_picture(sensor, points)
                numpy.testing.assert_array_equal(
                    vtk_to_numpy(seen.GetPointData().GetArray("seen")), free)

    @staticmethod
    def in_picture(sensor, points):
        columns, rows = sensor.size
        u, v = sensor.project(points).T
        return (u >= -0.5) & (v >= -0.5) & (u <= columns - 0.5) & (v <= rows - 0.5)

    def test_nothing_is_too_small(self):
        # Each cell of 100 x 100 in a picture of 20 x 20 pixels; half are behind a wall.
        floor = grid((-1, 0, 1), (1, 0, 1), (-1, 0, -1), 100, 100)
        wall = grid((0, -1, 0.5), (2, -1, 0.5), (0, 1, 0.5), 1, 1)
        sensor = relievo.Pinhole([[20, 0, 9.5], [0, 20, 9.5], [0, 0, 1]], (20, 20))
        sensor.look_at((0, 0, 3), (0, 0, 0), (0, 1, 0))
        floor_up = grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), 100, 100)
        seen = relievo.visible(floor_up, sensor, occluders=wall)
        counts = vtk_to_numpy(seen.GetCellData().GetArray("seen")).reshape(100, 100)
        # The wall's edge x = 0 is seen at x = 0: the camera is over it.
        self.assertTrue((counts[:, :50] == 1).all())
        self.assertTrue((counts[:, 51:] == 0).all())
        self.assertLess((array(seen, "pixels") > 0).mean(), 0.05)
        # Their solid angles sum to that of the half plate.
        whole = array(seen, "solid_angle").reshape(100, 100)
        small = array(seen, "pixels").reshape(100, 100) == 0
        x, y = numpy.meshgrid((numpy.arange(100) - 49.5) / 50, (numpy.arange(100) - 49.5) / 50)
        expected = 0.02**2 * 3 / (x**2 + y**2 + 9) ** 1.5
        numpy.testing.assert_allclose(whole[:, :50][small[:, :50]],
                                      expected[:, :50][small[:, :50]], rtol=1e-3)
        self.assertEqual(relievo.visible(floor, sensor).GetNumberOfCells(), 10000)

    def test_corners_of_edges_beside_hidden_cells(self):
        # Cells behind a wall, and beside it one seen edge-on, whose corners nothing hides.
        wall = grid((-2, -1, 1), (0, -1, 1), (-2, 1, 1), 1, 1)
        points = [(-0.6 + 0.02 * i, y, 0) for i in range(7) for y in (-0.05, 0.05)]
        points += [(-0.4, 0, 0), (0.6, 0, 0), (1.2, 0, 0), (0.9, 0, 0.3)]
        cells = [(2 * i, 14, 2 * i + 1) for i in range(7)] + [(15, 16, 17)]
        sensor = relievo.Pinhole([[20, 0, 9.5], [0, 20, 9.5], [0, 0, 1]], (20, 20))
        sensor.look_at((0, 0, 3), (0, 0, 0), (0, 1, 0))
        seen = relievo.visible(mesh_of(points, cells), sensor, occluders=wall)
        counts = vtk_to_numpy(seen.GetPointData().GetArray("seen"))
        numpy.testing.assert_array_equal(counts, [0] * 15 + [1] * 3)

    def test_lines_before_polygons_and_strips(self):
        # Cells count vertices, lines, polygons, strips; all three surfaces are in one plane.
        mesh = mesh_of([(-1, -1, 0), (0, -1, 0), (0, 1, 0), (-1, 1, 0), (1, -1, 0), (1, 1, 0)],
                       [(0, 1, 2), (0, 2, 3)])
        for cells, corners in ((mesh.SetLines, (0, 1, 2, 3)), (mesh.SetStrips, (1, 4, 2, 5))):
            made = vtkCellArray()
            made.InsertNextCell(4)
            for corner in corners:
                made.InsertCellPoint(corner)
            cells(made)
        sensor = relievo.Pinhole([[50, 0, 50], [0, 50, 50], [0, 0, 1]], (101, 101))
        sensor.look_at((0.1, 0, 3), (0.1, 0, 0))
        seen = relievo.visible(mesh, sensor)
        numpy.testing.assert_array_equal(vtk_to_numpy(seen.GetCellData().GetArray("seen")),
                                         [0, 1, 1, 1])
        lit = relievo.sun_exposure(mesh, 0, 0, "2026-03-21", up="z")
        hours = array(lit, "sun_hours")
        self.assertEqual((hours > 11.5).tolist(), [False, True, True, True])

    def test_cameras_count(self):
        mesh = box((0, 0, 0), 0.5)
        cameras = [relievo.Pinhole(K, SIZE).look_at(place, (0, 0, 0), (0.1, 1, 0.2))
                   for place in ((3, 0.1, 0), (-3, 0, 0.1), (3, 0.2, 0.1))]
        seen = relievo.visible(mesh, cameras)
        numpy.testing.assert_array_equal(vtk_to_numpy(seen.GetCellData().GetArray("seen"))[4:],
                                         [1, 2])
        with self.assertRaisesRegex(ValueError, "no cameras"):
            relievo.visible(mesh, [])


class SeenScene(unittest.TestCase):
    """visible() of a renderer: props that hide each other, in the world."""

    def scene(self):
        """A plate of 10 x 10 cells, and one of 4 x 4 that an actor moves before its left half."""
        renderer = vtkRenderer()
        for mesh in (grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), 10, 10),
                     grid((-5, -1, 0), (-4, -1, 0), (-5, 1, 0), 4, 4)):  # fmt: skip
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(mesh)
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)
        actor.SetPosition(8, 0, 2)
        actor.SetScale(2, 1, 1)  # x from -2 to 0
        return renderer

    def test_props(self):
        renderer = self.scene()
        sensor = relievo.Pinhole([[90, 0, 60.3], [0, 90, 60.2], [0, 0, 1]], (121, 121))
        sensor.look_at((0, 0, 4), (0, 0, 0))
        found, cloud = relievo.visible(renderer, sensor, cloud=True)
        self.assertEqual(len(found), 2)
        far, near = (vtk_to_numpy(each.GetCellData().GetArray("seen")) for each in found)
        expected = numpy.arange(10) >= 5  # the edge is on the axis
        numpy.testing.assert_array_equal(far.reshape(10, 10), numpy.tile(expected, (10, 1)))
        # The near one reaches out of the picture, by tan(33.8 degrees) times 2 = 1.34.
        self.assertEqual((near.reshape(4, 4) == 1).any(axis=0).tolist(), [False, True, True, True])
        bounds = found[1].GetBounds()
        numpy.testing.assert_allclose(bounds, (-2, 0, -1, 1, 2, 2), atol=1e-12)
        # Pixels by prop and cell are those of the frame, drawn by OpenGL.
        image = relievo.capture(renderer, ["actor", "cell"], camera=sensor)
        relievo.camera(renderer, K=sensor.K, R=sensor.R, t=sensor.t, size=sensor.size)
        drawn = relievo.capture(renderer, ["actor", "cell"], size=sensor.size)
        numpy.testing.assert_array_equal(relievo.layer(drawn, "actor"),
                                         relievo.layer(image, "actor"))
        for number, mesh in enumerate(found):
            cells = relievo.layer(drawn, "cell")[relievo.layer(drawn, "actor") == number]
            count = numpy.bincount(cells, minlength=mesh.GetNumberOfCells())
            errors = numpy.abs(array(mesh, "pixels") - count)
            self.assertLessEqual(errors.sum(), 0.01 * count.sum())
            mine = vtk_to_numpy(cloud.GetPointData().GetArray("actor")) == number
            self.assertEqual(mine.sum(), array(mesh, "pixels").sum())
            own = vtk_to_numpy(cloud.GetPointData().GetArray("cell"))[mine]
            numpy.testing.assert_array_equal(
                numpy.bincount(own, minlength=mesh.GetNumberOfCells()), array(mesh, "pixels"))
        # Points: of the far one the right half, and the edge under the axis.
        points = vtk_to_numpy(found[0].GetPointData().GetArray("seen")).reshape(11, 11)
        self.assertTrue((points[:, 6:] == 1).all() and (points[:, :5] == 0).all())

    def test_what_has_no_mesh(self):
        renderer = self.scene()
        far, near = renderer.GetActors()
        near.VisibilityOff()
        sensor = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        found = relievo.visible(renderer, sensor)
        self.assertIsNone(found[1])
        self.assertTrue((array(found[0], "seen") == 1).all())

    def test_translucent(self):
        """Translucent surfaces are transparent to rays, as in the layers of a frame."""
        renderer = self.scene()
        _, near = renderer.GetActors()
        near.GetProperty().SetOpacity(0.5)
        sensor = relievo.Pinhole([[90, 0, 60.3], [0, 90, 60.2], [0, 0, 1]], (121, 121))
        sensor.look_at((0, 0, 4), (0, 0, 0))
        found, cloud = relievo.visible(renderer, sensor, cloud=True)
        self.assertIsNone(found[1])
        relievo.camera(renderer, K=sensor.K, R=sensor.R, t=sensor.t, size=sensor.size)
        drawn = relievo.capture(renderer, ["actor", "cell"], size=sensor.size)
        self.assertEqual(set(relievo.layer(drawn, "actor").ravel()), {-1, 0})
        cells = relievo.layer(drawn, "cell")[relievo.layer(drawn, "actor") == 0]
        errors = numpy.abs(array(found[0], "pixels") - numpy.bincount(cells, minlength=100))
        self.assertLessEqual(errors.sum(), 0.01 * len(cells))
        self.assertEqual(set(vtk_to_numpy(cloud.GetPointData().GetArray("actor"))), {0})

    def test_what_is_left_out_is_told(self):
        """Of lines and wireframes, once each, as a warning of Python's."""
        renderer = self.scene()
        far, near = renderer.GetActors()
        source, lines = vtkLineSource(), vtkPolyDataMapper()
        lines.SetInputConnection(source.GetOutputPort())
        sensor = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        shown = near.GetProperty()
        for _ in range(2):  # the rays are kept, and tell of an actor that is left out again
            shown.SetRepresentationToWireframe()
            with self.assertWarnsRegex(RuntimeWarning, "Rays do not hit vtk.*Actor: "):
                relievo.capture(renderer, ["depth"], camera=sensor)
            shown.SetRepresentationToSurface()
            relievo.capture(renderer, ["depth"], camera=sensor)
        for mapper, representation in (
                (near.GetMapper(), shown.SetRepresentationToWireframe),
                (lines, shown.SetRepresentationToSurface)):  # fmt: skip
            near.SetMapper(mapper)
            representation()
            with self.assertWarnsRegex(RuntimeWarning, "Rays do not hit vtk.*Actor: ") as told:
                found = relievo.visible(renderer, sensor)
            self.assertEqual(told.filename, __file__)
            self.assertIsNone(found[1])
            self.assertTrue((array(found[0], "seen") == 1).all())
            with self.assertWarnsRegex(RuntimeWarning, "Rays do not hit vtk.*Actor: "):
                relievo.moment(renderer, sensor)

    def test_lists_and_blocks(self):
        """Data and actors in a list; of blocks each cell says whose it is."""
        near, far = box((0, 0, 1), 0.2), box((0, 0, -1), 0.2)
        sensor = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        found = relievo.visible([near, far], sensor)
        alone = relievo.visible(near, sensor)
        numpy.testing.assert_array_equal(array(found[0], "pixels"), array(alone, "pixels"))
        self.assertEqual(array(found[1], "seen").sum(), 0)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, near)
        blocks.SetBlock(1, far)
        (whole,) = relievo.visible([blocks], sensor)
        self.assertEqual(array(whole, "block").tolist(), [1] * 6 + [2] * 6)
        self.assertEqual(array(whole, "cell").tolist(), [*range(6)] * 2)
        numpy.testing.assert_array_equal(array(whole, "pixels")[:6], array(alone, "pixels"))
        self.assertEqual(array(whole, "pixels")[6:].sum(), 0)
        (actor, _) = self.scene().GetActors()
        self.assertTrue((array(relievo.visible(actor, sensor)[0], "seen") == 1).all())

    def test_nothing(self):
        sensor = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        found, cloud = relievo.visible(vtkRenderer(), sensor, cloud=True)
        self.assertEqual((found, cloud.GetNumberOfPoints()), ([], 0))
        self.assertEqual(cloud.GetPointData().GetArray("actor").GetNumberOfTuples(), 0)
        away = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 8))
        _, cloud = relievo.visible(self.scene(), away, cloud=True)
        self.assertEqual(cloud.GetPointData().GetArray("actor").GetNumberOfTuples(), 0)


class FromRays(unittest.TestCase):
    """sun_exposure(), visible() and cover() of a file of trees: those of the mesh, bit for bit."""

    def test_equal(self):
        draw = numpy.random.default_rng(45)
        hills = [(i % 12, draw.uniform(0, 2), i // 12) for i in range(144)]
        quads = [(i, i + 12, i + 13, i + 1) for i in range(132) if i % 12 < 11]
        mesh, roof = mesh_of(hills, quads), box((6, 4, 6), 1.5)
        camera = relievo.Pinhole(K, SIZE).look_at((3, 9, 2), (6, 0, 6), (0, 0, 1))
        works = {
            "sun_hours": lambda thing, others: relievo.sun_exposure(
                thing, 40, 10, "2026-03-20", step=60, occluders=others),
            "irradiation": lambda thing, others: relievo.sun_exposure(
                thing, 40, 10, "2026-03-20", irradiance="perez", occluders=others),
            "solid_angle": lambda thing, others: relievo.visible(thing, camera, occluders=others),
            "candidates": lambda thing, others: relievo.cover(
                thing, [(3, 5, 3), (9, 6, 9), (1, 4, 9)], 2, occluders=others)[0],
            "covered": lambda thing, others: relievo.cover(
                thing, [(3, 5, 3), (9, 6, 9), (1, 4, 9)], 1, occluders=others,
                weights=numpy.arange(len(quads)))[0],
        }  # fmt: skip
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "hills.rays"
            relievo.rays(mesh, roof).write(file)
            scene = relievo.rays(file, mesh, roof)
            # Rays of another range are not those of the work.
            scene.nearest((0, 9, 0), (0, -1, 0), minimum=1, maximum=2)
            for name, work in works.items():
                with self.subTest(name):
                    values = [array(work(*each), name) for each in ((mesh, roof), (scene, ()))]
                    numpy.testing.assert_array_equal(*values)
                    self.assertGreater(len(set(values[0].tolist())), 1)
            self.assertEqual(scene.scene.GetNumberOfMeshesBuilt(), 0)
            blocks = vtkMultiBlockDataSet()
            blocks.SetBlock(0, roof)
            for thing, others, message in ((relievo.rays(file), (), "of a file alone"),
                                         (relievo.rays(mesh, blocks), (), "without blocks"),
                                         (scene, roof, "beside Rays"),
                                         (relievo.rays((mesh, numpy.eye(4))), (), "matrices")):
                with self.assertRaisesRegex(ValueError, message):
                    works["sun_hours"](thing, others)
        unfit = relievo.vtkRelievoRayScene()
        matrix = vtkMatrix4x4()
        matrix.SetElement(0, 0, numpy.nan)
        unfit.AddData(roof, matrix)
        for given, message in ((scene.scene, "other data"), (unfit, "not finite")):
            for filter_ in (relievo.vtkRelievoSunExposure(), relievo.vtkRelievoCover()):
                filter_.SetInputDataObject(0, roof)
                if filter_.IsA("vtkRelievoCover"):
                    filter_.SetInputDataObject(2, mesh)
                else:
                    filter_.SetIrradiance(1)
                filter_.SetScene(given)
                with relievo._arguments.errors.Watch(filter_) as watch:
                    filter_.Update()
                with self.assertRaisesRegex(ValueError, message):
                    watch.raise_as(ValueError, "rays")


def solid(points, cells, scale=1.0):
    """An actor of a mesh of its own."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh_of(points, cells))
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetScale(scale)
    return actor


def brick(x, y, z, lean=0.0):
    """A box of these half sizes whose upper face is moved along x."""
    corners = vtk_to_numpy(box((0, 0, 0), 1).GetPoints().GetData()) * (x, y, z)
    corners[:, 0] += lean * (corners[:, 2] > 0)
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2),
                     (1, 3, 7, 5)]


def are_apart(a, axes_a, b, axes_b):
    """Whether a plane separates the corners of two boxes: the theorem of separating axes."""
    lines = [*axes_a, *axes_b, *(numpy.cross(p, q) for p in axes_a for q in axes_b)]
    spans = [(a @ line, b @ line) for line in lines if numpy.linalg.norm(line) > 1e-9]
    return any(p.max() < q.min() or q.max() < p.min() for p, q in spans)


class Scatter(unittest.TestCase):
    """scatter(): bodies rest, within the area, and apart."""

    @staticmethod
    def placed(actor, points):
        matrix = actor.GetMatrix()
        matrix = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        return points @ matrix[:3, :3].T + matrix[:3, 3]

    def test_bodies_rest(self):
        half = (0.3, 0.35, 0.4)
        tetrahedron = numpy.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]) / 4
        leaning = brick(0.1, 0.1, 0.4, lean=0.9)
        for up, axis in (("y", 1), ("z", 2), ("x", 0)):
            heights = []
            for seed in range(20):
                body = solid(*brick(*half), scale=2)
                relievo.scatter([body], seed, ((-4, 4), (-4, 4)), up=up, height=1.5)
                z = self.placed(body, brick(*half)[0])[:, axis]
                self.assertAlmostEqual(z.min(), 1.5, 12)
                heights.append(z.mean() - 1.5)
                self.assertLess(numpy.abs(2 * numpy.array(half) - heights[-1]).min(), 1e-9)
            self.assertEqual(len({round(each, 6) for each in heights}), 3, heights)
        for seed in range(20):
            body = solid(tetrahedron, [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])
            relievo.scatter([body], seed, ((-4, 4), (-4, 4)))
            z = self.placed(body, tetrahedron)[:, 1]
            self.assertAlmostEqual(z.mean(), 1 / (4 * 3**0.5), 9)
            # It never stands on a narrow face, because its centre is not over that.
            body = solid(*leaning)
            relievo.scatter([body], seed, ((-4, 4), (-4, 4)))
            z = self.placed(body, leaning[0])[:, 1]
            low = z < z.min() + 1e-9
            self.assertEqual(low.sum(), 4)
            self.assertNotIn(set(numpy.flatnonzero(low)), ({0, 1, 2, 3}, {4, 5, 6, 7}))

    def test_bodies_are_apart(self):
        random = numpy.random.default_rng(11)
        bricks = [brick(*random.uniform(0.05, 0.3, 3)) for _ in range(12)]
        actors = [solid(*each) for each in bricks]
        area = ((-1, 1.2), (2, 3.4))
        places = relievo.scatter(actors, 4, area, tries=2000)
        corners = [self.placed(*each) for each in zip(actors, (points for points, _ in bricks))]
        axes = [place[:3, :3].T for place in places]
        for i in range(12):
            for k, (low, high) in zip((0, 2), area):
                self.assertGreaterEqual(corners[i][:, k].min(), low - 1e-12)
                self.assertLessEqual(corners[i][:, k].max(), high + 1e-12)
            for j in range(i):
                self.assertTrue(are_apart(corners[i], axes[i], corners[j], axes[j]), (i, j))
        numpy.testing.assert_array_equal(relievo.scatter(actors, 4, area, tries=2000), places)
        # A body within another one, and a plane across the area, leave no place.
        large = solid(*brick(9, 9, 9))
        wall = solid([(-9, 0.1, -9), (9, 0.1, -9), (9, 0.1, 9), (-9, 0.1, 9)], [(0, 1, 2, 3)])
        small = solid(*brick(0.1, 0.2, 0.3))
        for fixed in (large, wall):
            with self.assertRaisesRegex(RuntimeError, "0 of 1 bodies found a place in 9 tries"):
                relievo.scatter([small], 1, area, fixed=[fixed], tries=9)
        self.assertIsNone(small.GetUserMatrix())
        # A table at the bodies' height is no obstacle, and keeps its transform.
        table = solid([(-9, 0, -9), (9, 0, -9), (9, 0, 9), (-9, 0, 9)], [(0, 1, 2, 3)])
        transform = vtkTransform()
        transform.Translate(0, 0.1, 0)
        table.SetUserTransform(transform)
        for seed in range(5):
            relievo.scatter([small], seed, area, height=0.1, fixed=[table], tries=1)
        self.assertIs(table.GetUserTransform(), transform)

    def test_refused(self):
        body = solid(*brick(1, 1, 1))
        for words, call in (
            ("up: got", lambda: relievo.scatter([body], 1, ((0, 9), (0, 9)), up="w")),
            ("area: got", lambda: relievo.scatter([body], 1, ((0, 9), (9, 0)))),
            ("area, random: got", lambda: relievo.scatter([body], "a", ((0, 9), (0, 9)))),
            ("actors: got", lambda: relievo.scatter([3], 1, ((0, 9), (0, 9)))),
            ("actors: got", lambda: relievo.scatter([vtkActor()], 1, ((0, 9), (0, 9)))),
            ("fixed: got", lambda: relievo.scatter([body], 1, ((0, 9), (0, 9)), fixed=[3])),
            ("tries: got", lambda: relievo.scatter([body], 1, ((0, 9), (0, 9)), tries="a")),
        ):
            with self.assertRaisesRegex(ValueError, words):
                call()
        with self.assertRaisesRegex(RuntimeError, "larger area"):
            relievo.scatter([body], 1, ((0, 1), (0, 1)))


class ViewFactors(unittest.TestCase):
    """view_factors(): closed forms (J. R. Howell, A Catalog of Radiation Heat Transfer
    Configuration Factors), sums and reciprocity."""

    def check(self, found, factors):
        """Each factor within its bound; rows that add up; areas times factors symmetric."""
        numpy.testing.assert_array_less(numpy.abs(found.factors - factors), found.bounds)
        numpy.testing.assert_allclose(found.factors.sum(axis=1) + found.nothing + found.others, 1,
                                      atol=1e-12)
        flows, errors = (found.areas[:, None] * each for each in (found.factors, found.bounds))
        numpy.testing.assert_array_less(numpy.abs(flows - flows.T), errors + errors.T)

    def test_squares(self):
        low = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        high = [(0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1)]  # faces down
        side = [(0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1)]
        root = numpy.sqrt(2)
        parallel = 2 / numpy.pi * (numpy.log(2 / numpy.sqrt(3))
                                   + 2 * root * numpy.arctan(1 / root) - numpy.pi / 2)
        across = (numpy.pi / 2 - root * numpy.arctan(1 / root) + numpy.log(0.75) / 4) / numpy.pi
        for other, expected in ((high, parallel), (side, across)):
            mesh = mesh_of(low + other, [range(4), range(4, 8)])
            for tolerance in (0.02, 0.004):
                found = relievo.view_factors(mesh, [3, 5], tolerance=tolerance)
                self.assertEqual(found.groups.tolist(), [3, 5])
                numpy.testing.assert_allclose(found.areas, 1)
                self.check(found, [[0, expected], [expected, 0]])
                self.assertLessEqual(found.bounds.max(), tolerance)
        again = relievo.view_factors(mesh, [3, 5], tolerance=0.004)
        numpy.testing.assert_array_equal(again.factors, found.factors)
        # A screen between them, and a back that radiates to nothing.
        screen = mesh_of([(-9, -9, 0.5), (9, -9, 0.5), (9, 9, 0.5), (-9, 9, 0.5)], [range(4)])
        mesh = mesh_of(low + high[::-1], [range(4), range(4, 8)])
        for occluders, others in (([], [parallel, 0]), ([screen], [1, 0])):
            found = relievo.view_factors(mesh, [0, 1], occluders=occluders)
            numpy.testing.assert_allclose(found.others, others, atol=0.02)
            numpy.testing.assert_array_equal(found.factors, 0)

    def test_spheres(self):
        ball = vtkSphereSource()
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(13)
        ball.Update()
        points = vtk_to_numpy(ball.GetOutput().GetPoints().GetData()) * 2
        cells = vtk_to_numpy(ball.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
        outer = cells[:, ::-1] + len(points)  # faces inwards
        mesh = mesh_of(numpy.concatenate([points, 2 * points]), numpy.concatenate([cells, outer]))
        group = numpy.repeat([0, 1], len(cells))
        found = relievo.view_factors(mesh, group, tolerance=0.005)
        self.check(found, [[0, 1], [0.25, 0.75]])
        self.assertEqual((found.factors[0, 1], found.nothing.max()), (1, 0))

    def test_refused(self):
        mesh = box((0, 0, 0), 1)
        for given, message in (({"groups": [1]}, "expected one number for each of 6 cells"),
                             ({"groups": "none"}, "got none"), ({"groups": [-1] * 6}, "no polygon"),
                             ({"groups": [0.5] * 6}, "got 0.5 for cell 0"),
                             ({"groups": [0] * 6, "tolerance": 0}, "tolerance: got 0")):
            with self.assertRaisesRegex(ValueError, message):
                relievo.view_factors(mesh, **given)


class Sun(unittest.TestCase):
    """sun_exposure(): shadows of a wall and a courtyard by hand, from the sun's own angles."""

    PLACE = {"latitude": 48.0, "longitude": 11.0}

    def suns(self, day, step):
        """Towards the sun (east, up, south) in the middle of the day's steps."""
        sun = relievo.vtkRelievoSolarPosition()
        sun.SetLatitude(self.PLACE["latitude"])
        sun.SetLongitude(self.PLACE["longitude"])
        sun.SetTimeZone(self.PLACE["longitude"] / 15)
        sun.SetDate(*day)
        found = []
        for i in range(round(24 * 60 / step)):
            sun.SetHour((i + 0.5) * step / 60)
            azimuth, elevation = numpy.radians([sun.GetAzimuth(), sun.GetElevation()])
            if elevation > 0:
                level = numpy.cos(elevation)
                found.append((level * numpy.sin(azimuth), numpy.sin(elevation),
                              -level * numpy.cos(azimuth)))
        return numpy.array(found)

    def test_wall(self):
        # A long wall of height 1 along x, on the north side of which lies the floor.
        floor = grid((-1, 0, 0), (1, 0, 0), (-1, 0, -4), 2, 40)
        wall = grid((-500, 0, 0.001), (500, 0, 0.001), (-500, 1, 0.001), 1, 1)
        done = relievo.sun_exposure(floor, **self.PLACE, first="2026-03-01", step=10,
                                    occluders=wall)
        suns = self.suns((2026, 3, 1), 10)
        distance = 0.05 + 0.1 * numpy.arange(40) + 0.001
        # In shadow where the sun, to the south, is lower than the wall's top.
        south = suns[:, 2] > 0
        dark = south & (suns[:, 1] * distance[:, None] < suns[:, 2])
        hours = (~dark).sum(axis=1) / 6
        numpy.testing.assert_allclose(array(done, "sun_hours").reshape(40, 2),
                                      numpy.stack([hours, hours], axis=-1), atol=1e-5)
        cosines = (~dark * suns[:, 1]).sum(axis=1) / 6
        numpy.testing.assert_allclose(array(done, "insolation").reshape(40, 2)[:, 0], cosines,
                                      rtol=1e-5)
        possible = done.GetFieldData().GetArray("possible_hours").GetValue(0)
        # From sunrise to sunset, by the sun of every ten seconds.
        self.assertAlmostEqual(possible, len(self.suns((2026, 3, 1), 1 / 6)) / 360, delta=0.006)
        self.assertGreater(hours.max() - hours.min(), 5)

    def test_concave_cells_are_judged_at_their_middles(self):
        # An L of legs of 2 and 1 wide, whose triangles at the first corner overlap: its middle is
        # (5/6, 5/6). A small plate right above that hides the sun at noon on the equator.
        corner = [(2, 0), (2, 1), (1, 1), (1, 2), (0, 2), (0, 0)]
        ell = mesh_of([(x, y, 0) for x, y in corner], [range(6)])
        for place, dark in ((5 / 6, True), (0.7, False), (1.0, False)):
            plate = box((place, place, 1), 0.01)
            lit = relievo.sun_exposure(ell, 0, 0, "2026-03-20", step=1, up="z", occluders=plate)
            possible = lit.GetFieldData().GetArray("possible_hours").GetValue(0)
            missing = possible - array(lit, "sun_hours")[0]
            self.assertEqual(missing > 0.03, dark, place)

    def test_cells_are_judged_within(self):
        # A U of legs of 1 by 2 on a foot of 3 by 1: its middle, (3/2, 17/14), is between the legs,
        # where a box is all around it.
        outline = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        hood = box((1.5, 1.5, 0), 0.45)
        for first in range(8):
            floor = mesh_of([(x, y, 0) for x, y in outline[first:] + outline[:first]], [range(8)])
            lit = relievo.sun_exposure(floor, 0, 0, "2026-03-20", step=60, up="z", occluders=hood)
            self.assertGreater(array(lit, "sun_hours")[0], 8.0, first)

    def test_left_handed_images_have_their_outside_outside(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        hours = []
        for z in (1, -1):  # no cell of the top looks down, and none of the bottom up
            image.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, z)
            lit = relievo.sun_exposure(image, 0, 0, "2026-03-20", step=60, up="z")
            hours.append(array(lit, "sun_hours").max())
            height = [numpy.mean(lit.GetCell(i).GetBounds()[4:]) for i in range(24)]
            top = array(lit, "sun_hours")[numpy.isclose(height, max(height))]
            self.assertEqual((len(top), len(set(top)), top[0]), (4, 1, hours[0]))

    def test_from_behind_and_points(self):
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        below = grid((0, 0, 0), (0, 0, -1), (1, 0, 0), 1, 1)
        for points in (False, True):
            up = relievo.sun_exposure(roof, **self.PLACE, first="2026-06-21", points=points)
            down = relievo.sun_exposure(below, **self.PLACE, first="2026-06-21", points=points)
            self.assertAlmostEqual(array(up, "sun_hours").min(),
                                   up.GetFieldData().GetArray("possible_hours").GetValue(0), 5)
            self.assertEqual(array(down, "sun_hours").max(), 0)

    def test_axes(self):
        # One roof, tilted to the south, by each axis that may point up.
        tilted = {"y": grid((0, 0, 0), (1, 0, 0), (0, 1, -1), 1, 1),
                  "z": grid((0, 0, 0), (1, 0, 0), (0, 1, 1), 1, 1),
                  "x": grid((0, 0, 0), (0, 1, 0), (1, 0, 1), 1, 1)}
        found = [array(relievo.sun_exposure(mesh, **self.PLACE, first="2026-02-03", up=up),
                       "insolation")[0] for up, mesh in tilted.items()]
        numpy.testing.assert_allclose(found, found[0], rtol=1e-6)

    def test_steps_of_any_length(self):
        """A day is as long whatever the step, and an east wall gets as much."""
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        wall = grid((0, 0, 0), (0, 0, -1), (0, 1, 0), 1, 1)  # faces east
        day = {**self.PLACE, "first": "2026-03-05"}
        truth = [array(relievo.sun_exposure(mesh, **day, step=0.1), name)[0]
                 for mesh, name in ((roof, "sun_hours"), (wall, "insolation"))]
        for step in (5, 20, 37, 60, 61, 100):
            with self.subTest(step=step):
                hours = array(relievo.sun_exposure(roof, **day, step=step), "sun_hours")[0]
                self.assertAlmostEqual(hours, truth[0], 4)
                east = array(relievo.sun_exposure(wall, **day, step=step), "insolation")[0]
                self.assertAlmostEqual(east / truth[1], 1, delta=0.002 * step / 20)

    def test_normals_of_points(self):
        """A face counts alike however it is cut: a cube's corners face along its diagonals."""
        corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        cut = [triangle for a, b, c, d in faces for triangle in ((a, b, c), (a, c, d))]
        skies = [array(relievo.sun_exposure(mesh_of(corners, cells), **self.PLACE, points=True,
                                            first="2026-06-21", sky=4096), "sky_view")
                 for cells in (faces, cut)]
        numpy.testing.assert_allclose(skies[0], skies[1], atol=1e-6)
        # Half of the sky lies before a surface that faces the diagonal up: (1 + cos a) / 2.
        numpy.testing.assert_allclose(skies[1].reshape(2, 2, 2)[:, 1].ravel(),
                                      0.5 * (1 + 3**-0.5), atol=0.01)

    def test_year_by_steps_of_days(self):
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        whole = relievo.sun_exposure(roof, **self.PLACE, first="2026-01-01", last="2026-12-31")
        steps = relievo.sun_exposure(roof, **self.PLACE, first="2026-01-01", last="2026-12-31",
                                     every=7)
        hours = array(whole, "sun_hours")[0]
        # Half of all hours of a year, and some: an orbit that is no circle.
        self.assertLess(abs(hours - 4380), 40)
        self.assertAlmostEqual(array(steps, "sun_hours")[0] / hours, 1, 2)

    def test_sky(self):
        # At the foot of a long wall of height h in the distance d: (1 + cos a) / 2 with the
        # wall's elevation a; on an open wall 1/2; in a court that is open above its 4 walls.
        floor = grid((-0.01, 0, -1), (0.01, 0, -1), (-0.01, 0, -1.02), 1, 1)
        wall = grid((-500, 0, 0), (500, 0, 0), (-500, 2, 0), 1, 1)
        done = relievo.sun_exposure(floor, **self.PLACE, first="2026-06-21", occluders=wall,
                                    sky=4096)
        elevation = numpy.arctan2(2, 1.01)
        self.assertAlmostEqual(array(done, "sky_view")[0], 0.5 * (1 + numpy.cos(elevation)), 2)
        upright = grid((0, 0, 0), (1, 0, 0), (0, 1, 0), 1, 1)
        done = relievo.sun_exposure(upright, **self.PLACE, first="2026-06-21", sky=4096)
        self.assertAlmostEqual(array(done, "sky_view")[0], 0.5, 2)
        court = [grid((-1, 0, 1), (1, 0, 1), (-1, 1, 1), 1, 1),
                 grid((-1, 0, -1), (1, 0, -1), (-1, 1, -1), 1, 1),
                 grid((1, 0, -1), (1, 0, 1), (1, 1, -1), 1, 1),
                 grid((-1, 0, -1), (-1, 0, 1), (-1, 1, -1), 1, 1)]
        middle = grid((-0.01, 0, 0.01), (0.01, 0, 0.01), (-0.01, 0, -0.01), 1, 1)
        done = relievo.sun_exposure(middle, **self.PLACE, first="2026-06-21", occluders=court,
                                    sky=4096)
        # The form factor of a square of side 2 seen from 1 below its middle.
        a = 1 / numpy.sqrt(2)
        expected = 4 / numpy.pi * a * numpy.arctan(a)
        self.assertAlmostEqual(array(done, "sky_view")[0], expected, 2)

    def test_times_of_day_elevation_and_north(self):
        # At an equinox the equator's sun rises at about 6, by 15 degrees an hour.
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        for given, hours in (({"begin_hour": 9, "end_hour": 15}, 6), ({"end_hour": 10}, 4),
                             ({"end_hour": 10, "time_zone": 2}, 2), ({"minimum_elevation": 30}, 8),
                             ({"begin_hour": 12, "minimum_elevation": 30}, 4)):
            with self.subTest(given):
                lit = relievo.sun_exposure(roof, 0, 0, "2026-03-20", **given)
                possible = lit.GetFieldData().GetArray("possible_hours").GetValue(0)
                self.assertAlmostEqual(possible, hours, delta=0.15)  # the equation of time
                self.assertAlmostEqual(array(lit, "sun_hours")[0], possible, 5)
        south = grid((0, 0, 0), (1, 0, 0), (0, 1, 0), 1, 1)
        west = grid((0, 0, -1), (0, 0, 0), (0, 1, -1), 1, 1)
        plain, turned = (array(relievo.sun_exposure(wall, **self.PLACE, first="2026-10-01",
                                                    north=north), "insolation")[0]
                         for wall, north in ((south, 0), (west, 90)))
        self.assertAlmostEqual(plain / turned, 1, 6)
        self.assertGreater(plain, 4)

    def test_irradiation_of_planes(self):
        """A year at Vienna without clouds, and by arrays: direct, diffuse and reflected kWh/m2 by
        pvlib 0.16.1, in steps of five minutes (solarposition, clearsky.ineichen with a solar
        constant of 1361 W/m2 by Spencer and airmass by Kasten and Young, irradiance.perez and
        isotropic)."""
        sine, cosine = numpy.sin(numpy.radians(35)), numpy.cos(numpy.radians(35))
        up = {"level": ((1, 0, 0), (0, 1, 0)), "tilted": ((1, 0, 0), (0, cosine, sine)),
              "south": ((1, 0, 0), (0, 0, 1)), "east": ((0, 1, 0), (0, 0, 1)),
              "north": ((-1, 0, 0), (0, 0, 1))}
        corners, cells = [], []
        for i, (a, b) in enumerate(numpy.array(list(up.values()))):
            first = numpy.array((1e5 * i, 0, 0))  # too far to shade each other
            cells.append(range(4 * i, 4 * i + 4))
            corners += [first, first + a, first + a + b, first + b]
        planes = mesh_of(corners, cells)
        hour, day = numpy.arange(8760) % 24, numpy.arange(8760) // 24
        by_day = (hour >= 8) & (hour < 14)
        weather = {"dni": by_day * (300 + 200 * numpy.sin(0.1 * day)),
                   "dhi": by_day * (80 + 40 * numpy.cos(0.3 * hour + day))}
        truth = [
            ({"irradiance": "isotropic"}, [
                (1470.00, 275.82, 0), (1915.16, 250.88, 31.57), (1285.60, 137.91, 174.58),
                (762.59, 137.91, 174.58), (56.40, 137.91, 174.58)]),
            ({"irradiance": "perez", "altitude": 1500, "turbidity": 2.5}, [
                (1742.80, 201.86, 0), (2297.55, 249.19, 35.17), (1581.91, 188.95, 194.47),
                (979.26, 159.67, 194.47), (86.52, 117.99, 194.47)]),
            ({"irradiance": "perez", "weather": weather, "time_zone": 0}, [
                (382.95, 175.08, 0), (558.55, 227.27, 10.09), (426.90, 176.64, 55.80),
                (112.11, 101.62, 55.80), (0, 75.20, 55.80)]),
        ]  # fmt: skip
        for given, rows in truth:
            lit = relievo.sun_exposure(planes, 48.2, 16.4, "2026-01-01", "2026-12-31", up="z",
                                       **given)
            parts = [array(lit, f"{part}_irradiation")
                     for part in ("direct", "diffuse", "reflected")]
            total = array(lit, "irradiation")
            numpy.testing.assert_allclose(total, numpy.sum(parts, axis=0), rtol=1e-6)
            for i, plane in enumerate(up):
                with self.subTest(list(given), plane=plane):
                    for part, expected in zip(parts, rows[i]):
                        self.assertAlmostEqual(part[i], expected, delta=0.003 * sum(rows[i]))
                    self.assertLessEqual(array(lit, "irradiation_bound")[i], 0.01 * total[i])
            whole = lit.GetFieldData().GetArray("open_irradiation").GetValue(0)
            self.assertAlmostEqual(whole / total[0], 1, 5)
        # Diffuse light alone, also in an hour of which two minutes are by day.
        dull = {"dhi": numpy.full(24, 100.0), "dni": numpy.zeros(24)}
        lit = relievo.sun_exposure(planes, 48.2, 16.4, "2026-03-25", up="z", irradiance="perez",
                                   weather=dull)
        diffuse = array(lit, "diffuse_irradiation")
        self.assertLess(diffuse[2:].max(), diffuse[0])
        # The air adds no light to that outside of the atmosphere, by its integral over the day.
        high = relievo.sun_exposure(planes, 0, 0, "2026-03-20", up="z", irradiance="isotropic",
                                    altitude=9000, turbidity=1)
        whole = high.GetFieldData().GetArray("open_irradiation").GetValue(0)
        self.assertLess(whole, 1.361 * 1.035 * 24 / numpy.pi)

    def test_irradiation_in_a_canyon(self):
        """Closed forms of a uniform sky, and steps of sun by rays, within the bounds."""
        floor = grid((-0.01, 0, 0.01), (0.01, 0, 0.01), (-0.01, 0, -0.01), 1, 1)
        left = grid((-1, 0, 500), (-1, 0, -500), (-1, 1, 500), 1, 1)  # faces the other
        right = grid((1, 0, -500), (1, 0, 500), (1, 1, -500), 999, 29)  # small quads
        day = {**self.PLACE, "first": "2026-06-01", "step": 5}
        sky = {"dhi": numpy.full(24, 100.0), "dni": numpy.zeros(24)}
        sun = {"dhi": numpy.zeros(24), "dni": numpy.full(24, 500.0)}
        slope = numpy.arctan2(0.5, 2)
        for mesh, others, expected in ((floor, [left, right], numpy.sqrt(0.5)),
                                       (left, [right], 0.5 * (1 - numpy.sin(slope)))):
            for tolerance in (4, 1):
                lit = relievo.sun_exposure(mesh, **day, occluders=others, irradiance="isotropic",
                                           weather=sky, tolerance=tolerance, albedo=0)
                open_ = lit.GetFieldData().GetArray("open_irradiation").GetValue(0)
                found, bound = (array(lit, name)[0] / open_
                                for name in ("irradiation", "irradiation_bound"))
                self.assertLessEqual(abs(found - expected), 0.6 * bound)
                self.assertLessEqual(bound, 0.01 * tolerance * found)
            lit = relievo.sun_exposure(mesh, **day, occluders=others, irradiance="isotropic",
                                       weather=sun, tolerance=0.3)
            rays = relievo.sun_exposure(mesh, **day, occluders=others)
            direct = array(lit, "direct_irradiation")[0]
            self.assertLessEqual(abs(direct - 0.5 * array(rays, "insolation")[0]),
                                 array(lit, "irradiation_bound")[0] + 0.002 * direct)
            self.assertLessEqual(abs(array(lit, "sun_hours")[0] - array(rays, "sun_hours")[0]),
                                 array(lit, "sun_hours_bound")[0] + 5 / 60)
            self.assertLess(array(lit, "sun_hours")[0], 14)

    def test_irradiation_among_poles(self):
        """Narrow poles and narrow slits between closed bodies: a closed form, and rays, within the
        bounds."""
        height, radius, count = 50, 10, 24
        floor = grid((-0.001, 0, 0.001), (0.001, 0, 0.001), (-0.001, 0, -0.001), 1, 1)
        sky = {"dhi": numpy.full(24, 100.0), "dni": numpy.zeros(24)}
        for wide, behind in ((2 * radius * numpy.tan(numpy.radians(7.2)), 1.5), (0.3, None)):
            poles = []
            for turn in 2 * numpy.pi * (numpy.arange(count) + 0.37) / count:
                ahead = numpy.array((numpy.sin(turn), 0, -numpy.cos(turn)))
                side = 0.5 * wide * numpy.array((numpy.cos(turn), 0, numpy.sin(turn)))
                low, high = radius * ahead - side, radius * ahead + side
                poles.append(grid(low, high, low + (0, height, 0), 1, 3))
                if behind:  # the back is hidden by the front
                    front = [low, high, high + (0, height, 0), low + (0, height, 0)]
                    back = [corner + behind * ahead for corner in front]
                    poles[-1] = mesh_of(front + back, [(0, 1, 2, 3), (5, 4, 7, 6), (4, 0, 3, 7),
                                                       (1, 5, 6, 2), (3, 2, 6, 7), (4, 5, 1, 0)])
            day = {**self.PLACE, "first": "2026-06-01", "occluders": poles}
            half = numpy.arctan(0.5 * wide / radius)
            across = half * (2 * (numpy.arange(100) + 0.5) / 100 - 1)
            slope = (height * numpy.cos(across) / radius) ** 2
            expected = 1 - count * half / numpy.pi * numpy.mean(slope / (1 + slope))
            for tolerance in (20, 5, 1):
                lit = relievo.sun_exposure(floor, **day, irradiance="isotropic", weather=sky,
                                           tolerance=tolerance, albedo=0)
                open_ = lit.GetFieldData().GetArray("open_irradiation").GetValue(0)
                found, bound = (array(lit, name)[0] / open_
                                for name in ("irradiation", "irradiation_bound"))
                self.assertLessEqual(abs(found - expected), bound)
                # The finest patches beside the edges, of which slits have more.
                self.assertLess(bound, 0.05 if behind else max(0.01 * tolerance, 0.06) * found)
        site = grid((-9, 0, 9), (9, 0, 9), (-9, 0, -9), 6, 6)
        lit = relievo.sun_exposure(site, **day, irradiance="perez", tolerance=20)
        rays = relievo.sun_exposure(site, **day)
        missed = abs(array(lit, "sun_hours") - array(rays, "sun_hours"))
        numpy.testing.assert_array_less(missed, array(lit, "sun_hours_bound") + 1e-4)
        self.assertGreater(missed.max(), 0.05)  # so the bounds are needed

    def test_weather(self):
        """Energy of an open level roof: the sum of all hours with sun, from a file or arrays."""
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        draw = numpy.random.default_rng(45)
        dni, dhi = draw.uniform(50, 400, 8760), draw.uniform(20, 200, 8760)
        hours = numpy.arange("2025-01-01", "2026-01-01", dtype="datetime64[h]").astype(object)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "place.epw"
            head = ["LOCATION,Place,-,-,-,0,48,11,1.0,500"] + ["DATA PERIODS,1,1,Data"] * 7
            rows = [f"2001,{each.month},{each.day},{each.hour + 1},60,?,20,9,50,95000,0,0,300,"
                    f"999,{sun!r},{sky!r},0" for each, sun, sky
                    in zip(hours, dni.tolist(), dhi.tolist())]  # fmt: skip
            file.write_text("\ufeff" + "\n".join(head + rows) + "\n", "utf-8")
            of_file, in_utc = (
                relievo.sun_exposure(roof, **self.PLACE, first="2026-05-03", last="2026-05-04",
                                     irradiance="perez", weather=file, time_zone=zone)
                for zone in (None, 0))  # fmt: skip
            for lines, message in ((head + rows[:-1], "has no hour 24 of day 365"),
                                 (head + rows + rows[:1], "line 8769: has an hour again"),
                                 (["", *head, *rows], "is not a weather file")):
                file.write_text("\n".join(lines) + "\n")
                with self.assertRaisesRegex(ValueError, message):
                    relievo.sun_exposure(roof, **self.PLACE, first="2026-05-03",
                                         irradiance="perez", weather=file)
            # Clocks that differ by 28 hours: the weather is that of two days before.
            head[0] = "LOCATION,Place,-,-,-,0,48,11,-14.0,500"
            rows = [f"2001,{each.month},{each.day},{each.hour + 1},60,?,20,9,50,95000,0,0,300,"
                    f"999,0,100,0" for each in hours]  # fmt: skip
            file.write_text("\n".join(head + rows) + "\n")
            far, near = (
                relievo.sun_exposure(roof, **self.PLACE, first="2026-01-02", time_zone=14,
                                     irradiance="isotropic", weather=weather)
                for weather in (file, {"dhi": [100] * 24, "dni": [0] * 24}))  # fmt: skip
            self.assertAlmostEqual(array(far, "diffuse_irradiation")[0],
                                   array(near, "diffuse_irradiation")[0], 6)
        here = slice(24 * 122, 24 * 124)
        given = {"first": "2026-05-03", "last": "2026-05-04", "time_zone": 1}
        of_arrays = relievo.sun_exposure(roof, **self.PLACE, **given, irradiance="perez",
                                         weather={"dni": dni[here], "dhi": dhi[here]})
        for name in ("direct_irradiation", "diffuse_irradiation", "sun_hours"):
            values = [array(each, name)[0] for each in (of_file, of_arrays, in_utc)]
            self.assertEqual(values[0], values[1])
            # By another clock other hours of the night are joined at midnight.
            self.assertAlmostEqual(values[2] / values[0], 1, 5)
        sun = relievo.vtkRelievoSolarPosition()
        sun.SetLatitude(self.PLACE["latitude"])
        sun.SetLongitude(self.PLACE["longitude"])
        sun.SetTimeZone(1)
        sun.SetDate(2026, 5, 3)

        def is_up(hour):
            sun.SetHour(hour)
            return sun.GetElevation() > 0

        lit = sorted({i // 60 for i in range(48 * 60) if is_up((i + 0.5) / 60)})
        ghi = dhi + dni / 4
        level = relievo.sun_exposure(roof, **self.PLACE, **given, irradiance="isotropic",
                                     weather={"ghi": ghi[here], "dhi": dhi[here]})
        self.assertAlmostEqual(array(level, "diffuse_irradiation")[0],
                               dhi[here][lit].sum() / 1000, delta=0.001)
        self.assertAlmostEqual(array(level, "direct_irradiation")[0],
                               dni[here][lit].sum() / 4000, delta=0.15)
        for weather, message in (({"dni": [1, 2]}, "expected the array dhi"), (7, "got 7"),
                               ({"dni": [1], "dhi": [1, 2]}, "equal"),
                               ({"dni": [1, 1], "dhi": [1, -1]}, "got -1 W/m2 in row 1"),
                               ({"dni": [1] * 3, "dhi": [1] * 3}, "got 3 values for 2 days"),
                               ("none.epw", "none.epw: cannot be read"),
                               ("/dev/zero", "/dev/zero: expected a file .* a device")):
            with self.assertRaisesRegex(ValueError, message):
                relievo.sun_exposure(roof, **self.PLACE, **given, irradiance="perez",
                                     weather=weather)

    def test_refused(self):
        roof = grid((0, 0, 0), (1, 0, 0), (0, 0, -1), 1, 1)
        with self.assertRaisesRegex(ValueError, "hours 9 to 8"):
            relievo.sun_exposure(roof, **self.PLACE, first="2026-06-21", begin_hour=9, end_hour=8)
        with self.assertRaisesRegex(ValueError, "time zone '15'"):
            relievo.sun_exposure(roof, **self.PLACE, first="2026-06-21", time_zone=15)
        with self.assertRaisesRegex(ValueError, "weather: got no irradiance"):
            relievo.sun_exposure(roof, **self.PLACE, first="2026-06-21", weather="place.epw")
        for words, change in (("first", {"first": "June"}), ("latitude", {"latitude": 91}),
                              ("up", {"up": "w"}), ("step", {"step": 0}),
                              ("longitude", {"longitude": numpy.nan}),
                              ("longitude", {"longitude": 181}), ("every", {"every": 1.5}),
                              ("step", {"step": None}), ("last day", {"last": "2026-06-20"})):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                relievo.sun_exposure(roof, **{**self.PLACE, "first": "2026-06-21", **change})


class Flow(unittest.TestCase):
    """flow(): the projections of the moved points, by hand."""

    def renderer(self):
        renderer = scenes.plane_and_sphere()
        R, t = relievo.extrinsics(renderer)
        relievo.camera(renderer, K=K, size=SIZE, R=R, t=t)
        return renderer

    def expected(self, before, image, position, moved, after):
        """Flow of positions that moved to others, where the image has any."""
        seen = numpy.isfinite(relievo.layer(image, "flow")).all(axis=-1)
        v, u = numpy.nonzero(seen)
        places = after.project(moved[seen])
        off = relievo.layer(image, "flow")[seen] - (places - numpy.stack([u, v], axis=-1))
        self.assertLess(numpy.abs(off).max(), 0.01)
        motion = relievo.layer(image, "motion")[seen]
        numpy.testing.assert_allclose(motion, (moved - position)[seen], atol=1e-4)
        self.assertGreater(seen.mean(), 0.25)
        return seen

    def test_nothing_moves(self):
        renderer = self.renderer()
        image = relievo.flow(relievo.moment(renderer, size=SIZE), renderer)
        flow = relievo.layer(image, "flow")
        seen = numpy.isfinite(flow).all(axis=-1)
        self.assertLess(numpy.abs(flow[seen]).max(), 1e-6)
        self.assertTrue((relievo.layer(image, "flow_valid")[seen] == 1).mean() > 0.999)
        self.assertTrue((relievo.layer(image, "flow_valid")[~seen] == 0).all())

    def test_camera_and_actors(self):
        renderer = self.renderer()
        names = ["position", "actor"]
        old = relievo.Pinhole.of(renderer, SIZE)
        image = relievo.capture(renderer, names, camera=old)
        position = relievo.layer(image, "position").copy()
        actor = relievo.layer(image, "actor").copy()
        before = relievo.moment(renderer, size=SIZE)
        ball = list(renderer.GetActors())[1]
        ball.SetPosition(0.3, -0.1, 0.2)
        camera = renderer.GetActiveCamera()
        camera.Roll(3)
        camera.Dolly(1.07)
        renderer.ResetCameraClippingRange()
        moved = position + numpy.where(actor[..., None] == 1, (0.3, -0.1, 0.2), 0)
        after = relievo.Pinhole.of(renderer, SIZE)
        done = relievo.flow(before, renderer)
        self.expected(old, done, position, moved, after)
        # Points reported as visible are shown there in the second picture.
        now = relievo.layer(relievo.capture(renderer, ["position"], camera=after), "position")
        valid = relievo.layer(done, "flow_valid") == 1
        v, u = numpy.nonzero(valid)
        target = numpy.rint(numpy.stack([u, v], -1) + relievo.layer(done, "flow")[valid])
        shown = now[target[:, 1].astype(int), target[:, 0].astype(int)]
        near = numpy.linalg.norm(shown - moved[valid], axis=-1)
        self.assertLess(numpy.quantile(near, 0.98), 0.5)

    def test_points_move(self):
        mesh = grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), 10, 10)
        sensor = relievo.Fisheye(numpy.array([[60.0, 0, 50], [0, 60, 50], [0, 0, 1]]), (101, 101))
        sensor.look_at((0, 0, 2), (0, 0, 0))
        image = relievo.capture(mesh, ["position"], camera=sensor)
        position = relievo.layer(image, "position").copy()
        before = relievo.moment(mesh, sensor)
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points[:] = 1.1 * points + (0.05, 0, 0)
        mesh.GetPoints().Modified()
        moved = 1.1 * position + (0.05, 0, 0)
        self.expected(sensor, relievo.flow(before, mesh, sensor), position, moved, sensor)

    def test_nothing_moves_for_any_sensor_and_far_away(self):
        K60 = numpy.array([[60.0, 0, 40], [0, 60, 30], [0, 0, 1]])
        for far in (0, 5e7):
            mesh = box((far, 0, 0), 0.5)
            for sensor in (
                relievo.Pinhole(K60, (81, 61), distortion=(-0.1, 0)),
                relievo.Division(K60, (81, 61), -0.1),
                relievo.Equirectangular((80, 40)), relievo.Cube(17),
                relievo.Orthographic(30, (81, 61)), relievo.Pushbroom(60, (0, 0.03, 0), (81, 61)),
            ):
                with self.subTest(sensor=type(sensor).__name__, far=far):
                    sensor.look_at((far + 2, 1.2, 1.9), (far, 0, 0))
                    image = relievo.flow(relievo.moment(mesh, sensor), mesh, sensor)
                    flow = relievo.layer(image, "flow")
                    seen = numpy.isfinite(flow).all(axis=-1)
                    self.assertGreater(seen.sum(), 10)
                    self.assertLess(numpy.abs(flow[seen]).max(), 1e-9 + 1e-12 * far)
                    self.assertGreater((relievo.layer(image, "flow_valid")[seen] == 1).mean(), 0.98)
        mesh = box((0, 0, 0), 1)
        scanner = {"elevations": numpy.arange(-40, 41, 2), "steps": 360}
        for words in ({}, {"way": (0.3, 0.1, 0), "rotation": (0, 0, 9)}):
            lidar = relievo.Lidar(**scanner, **words).look_at((2, 1.2, 1.9), (0, 0, 0))
            image = relievo.flow(relievo.moment(mesh, lidar), mesh, lidar)
            flow = relievo.layer(image, "flow")
            seen = numpy.isfinite(flow).all(axis=-1)
            self.assertGreater(seen.sum(), 100)
            self.assertLess(numpy.abs(flow[seen]).max(), 1e-7)
        # Three steps of the turn to the right, for all points.
        turned = relievo.Lidar(**scanner).look_at((2, 1.2, 1.9), (0, 0, 0), up=(0, 1, 0))
        before = relievo.moment(mesh, turned)
        angle = numpy.radians(3)
        spin = numpy.array([[numpy.cos(angle), -numpy.sin(angle), 0],
                            [numpy.sin(angle), numpy.cos(angle), 0], [0, 0, 1]])
        after = turned.copy().pose(spin @ turned.R, spin @ turned.t)
        flow = relievo.layer(relievo.flow(before, mesh, after), "flow")
        seen = numpy.isfinite(flow).all(axis=-1)
        self.assertGreater(seen.sum(), 100)
        self.assertLess(numpy.abs(flow[seen] - (-3, 0)).max(), 1e-4)
        lidar = relievo.Lidar([0], steps=8)
        moment = relievo.moment(mesh, lidar)
        with self.assertRaisesRegex(ValueError, "no places"):
            relievo.flow(moment, mesh, lidar)
        with self.assertRaisesRegex(ValueError, "capture flow: A vtkRelievoLidar has no places"):
            relievo.capture(mesh, "flow", camera=sensor, previous=moment)
        with self.assertRaisesRegex(ValueError, "no places"):
            relievo.visible(mesh, lidar)

    def test_the_shorter_way_round(self):
        """In a panorama whose camera turns all directions move by the turn, also at the seam."""
        mesh = box((0, 0, 0), 1)
        for field, degrees in (((360, 180), 10), ((360, 180), -35), ((300, 100), 70)):
            with self.subTest(field=field, degrees=degrees):
                size = (120, 30)
                steps = -degrees * size[0] / field[0]
                before = relievo.moment(mesh, relievo.Equirectangular(size, field))
                after = relievo.Equirectangular(size, field, R=(0, -numpy.radians(degrees), 0))
                image = relievo.flow(before, mesh, after)
                flow = relievo.layer(image, "flow")
                numpy.testing.assert_allclose(flow[..., 0], steps, atol=1e-4)
                numpy.testing.assert_allclose(flow[..., 1], 0, atol=1e-4)
                # The columns of a whole turn, of which a part of a panorama does not show all.
                turn = size[0] * 360 / field[0]
                inside = (numpy.arange(size[0]) + steps) % turn < size[0]
                valid = relievo.layer(image, "flow_valid") == 1
                self.assertGreater((valid == inside).mean(), 0.98)

    def test_cells_that_go(self):
        """A cell is followed if it is still there, of its points; others have no flow."""
        sensor = relievo.Pinhole([[60, 0, 40], [0, 60, 30], [0, 0, 1]], (81, 61))
        sensor.look_at((0, 0, 3), (0, 0, 0), (0, 1, 0))
        corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        whole = mesh_of(corners, [(0, 1, 2), (0, 2, 3)])
        which = relievo.layer(relievo.capture(whole, "cell", camera=sensor), "cell")
        five = [*corners, (0, 0, 0)]
        for name, other, kept in (
            ("one has gone", mesh_of(corners, [(0, 2, 3)]), [False, True]),
            ("in another order", mesh_of(corners, [(3, 0, 2), (0, 1, 2)]), [True, True]),
            ("cut otherwise", mesh_of(corners, [(0, 1, 3), (1, 2, 3)]), [False, False]),
            ("one of them cut", mesh_of(corners, [(0, 1, 2), (0, 3, 2)]), [True, True]),
            ("of five points", mesh_of(five, [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]),
             [False, False]),
            ("of points that may be others", mesh_of(five, [(0, 1, 2), (0, 2, 3)]),
             [False, False]),
        ):  # fmt: skip
            with self.subTest(name=name):
                before = relievo.moment(whole, sensor)
                image = relievo.flow(before, other, sensor)
                flow = relievo.layer(image, "flow")
                valid = relievo.layer(image, "flow_valid")
                for cell in (0, 1):
                    seen = which == cell
                    self.assertGreater(seen.sum(), 500)
                    self.assertTrue((numpy.isfinite(flow[seen]) == kept[cell]).all())
                    self.assertTrue((valid[seen] == kept[cell]).mean() > 0.99)

    def test_cells_by_ids(self):
        """Points with ids are followed to other places in the arrays, and cells by their points."""
        sensor = relievo.Pinhole([[60, 0, 40], [0, 60, 30], [0, 0, 1]], (81, 61))
        sensor.look_at((0, 0, 3), (0, 0, 0), (0, 1, 0))
        corners = numpy.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])

        def with_ids(points, cells, ids):
            mesh = mesh_of(points, cells)
            array = numpy_to_vtk(numpy.array(ids), deep=True)
            array.SetName("id")
            mesh.GetPointData().AddArray(array)
            return mesh

        whole = with_ids(corners, [(0, 1, 2), (0, 2, 3)], [10, 11, 12, 13])
        which = relievo.layer(relievo.capture(whole, "cell", camera=sensor), "cell")
        step = numpy.array([0.1, 0.05, 0])
        # Another point stands first; the corners are in reverse; the second triangle is of others.
        anew = with_ids([(5, 5, 5), *(corners + step)[::-1]],
                        [(0, 1, 2), (4, 3, 2), (1, 3, 2)], [99, 13, 12, 11, 10])  # fmt: skip
        before = relievo.moment(whole, sensor, point_ids="id")
        for name, image in (
            ("flow", relievo.flow(before, anew, sensor)),
            ("between moments",
             relievo.flow(before, relievo.moment(anew, sensor, point_ids="id"))),
            ("capture", relievo.capture(whole, ["motion"], camera=sensor, previous=relievo.moment(
                anew, sensor, point_ids="id"))),
        ):  # fmt: skip
            with self.subTest(name=name):
                motion = relievo.layer(image, "motion")
                self.assertLess(numpy.abs(motion[which == 0] - step).max(), 1e-6)
                self.assertTrue(numpy.isnan(motion[which == 1]).all())
        # Points that share an id are followed by their index if the mesh is the same.
        cells = [(0, 1, 2), (0, 2, 3)]
        shared = relievo.moment(with_ids(corners, cells, [7] * 4), sensor, point_ids="id")
        image = relievo.flow(shared, with_ids(corners + step, cells, [7] * 4), sensor)
        motion = relievo.layer(image, "motion")
        self.assertLess(numpy.abs(motion[which >= 0] - step).max(), 1e-6)
        image = relievo.flow(shared, with_ids(corners + step, cells[::-1], [7] * 4), sensor)
        self.assertTrue(numpy.isnan(relievo.layer(image, "motion")).all())
        with self.assertRaisesRegex(ValueError, "No mesh has an array 'number'"):
            relievo.flow(relievo.moment(whole, sensor, point_ids="number"), anew, sensor)
        with self.assertRaisesRegex(ValueError, "point_ids: got 3"):
            relievo.moment(whole, sensor, point_ids=3)

    def test_actors_that_go(self):
        renderer = vtkRenderer()
        actors = []
        for x in (-1, 1):
            source = vtkCubeSource()
            source.SetCenter(x, 0, 0)
            actors.append(scenes.add(renderer, source))
        sensor = relievo.Pinhole([[60, 0, 40], [0, 60, 30], [0, 0, 1]], (81, 61))
        sensor.look_at((0, 1, 5), (0, 0, 0))
        which = relievo.layer(relievo.capture(renderer, "actor", camera=sensor), "actor").copy()
        before = relievo.moment(renderer, sensor)
        renderer.RemoveActor(actors[0])
        image = relievo.flow(before, renderer, sensor)
        motion = relievo.layer(image, "motion")
        self.assertTrue(numpy.isnan(motion[which == 0]).all())
        self.assertLess(numpy.abs(motion[which == 1]).max(), 1e-12)
        self.assertTrue((relievo.layer(image, "flow_valid")[which == 0] == 0).all())

    def test_glyphs_move_with_their_points(self):
        points = scenes.points_at([(-1, 0, 0), (1, 0, 0), (0, 1, 0)], kind=[0, 1, 0])
        mapper = vtkGlyph3DMapper()
        mapper.SetInputData(points)
        for i, source in enumerate((vtkCubeSource(), vtkSphereSource())):
            mapper.SetSourceConnection(i, source.GetOutputPort())
        mapper.SetSourceIndexing(True)
        mapper.SetSourceIndexArray("kind")
        mapper.SetRange(0, 2)
        mapper.ScalingOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        sensor = relievo.Pinhole([[60, 0, 40], [0, 60, 30], [0, 0, 1]], (81, 61))
        sensor.look_at((0, 1, 5), (0, 0.3, 0))
        image = relievo.capture(renderer, ["cell", "kind"], camera=sensor)
        glyph = relievo.layer(image, "cell").copy()
        numpy.testing.assert_array_equal(relievo.layer(image, "kind")[glyph >= 0],
                                         numpy.array([0, 1, 0])[glyph[glyph >= 0]])
        before = relievo.moment(renderer, sensor)
        places = vtk_to_numpy(points.GetPoints().GetData())
        ways = numpy.array([(0.1, 0, 0), (0, -0.2, 0), (0, 0, 0.3)])
        places += ways
        points.GetPoints().Modified()
        motion = relievo.layer(relievo.flow(before, renderer, sensor), "motion")
        self.assertEqual(set(numpy.unique(glyph)), {-1, 0, 1, 2})
        for i, way in enumerate(ways):
            numpy.testing.assert_allclose(motion[glyph == i] - way, 0, atol=1e-6)

    def wall(self, angle=0.0, focal=100.0):
        """A sensor before a wall that fills its picture, turned about its axis."""
        turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle), 0],
                            [numpy.sin(angle), numpy.cos(angle), 0], [0, 0, 1]])  # fmt: skip
        center = numpy.array([61.4, 40.2])
        K = [[focal, 0, center[0]], [0, focal, center[1]], [0, 0, 1]]
        return {"K": K, "R": turn @ numpy.diag([1.0, -1, -1]), "t": (0, 0, 5), "size": (120, 90)}

    def test_layers_of_a_turned_and_a_zoomed_camera(self):
        """In captures flow to the moment before turns, or zooms, about the principal point."""
        v, u = numpy.mgrid[:90, :120]
        about = numpy.stack([u, v], -1) - (61.4, 40.2)
        turn = numpy.radians(7.0)
        back = numpy.array([[numpy.cos(turn), numpy.sin(turn)],
                            [-numpy.sin(turn), numpy.cos(turn)]])  # fmt: skip
        for now, expected in ((self.wall(angle=turn), about @ back.T - about),
                              (self.wall(focal=110.0), about / 1.1 - about)):  # fmt: skip
            renderer = vtkRenderer()
            source = vtkPlaneSource()
            source.SetOrigin(-9, -9, 0.5)
            source.SetPoint1(9, -9, -1)
            source.SetPoint2(-9, 9, 0.2)
            scenes.add(renderer, source)
            relievo.camera(renderer, **self.wall())
            before = relievo.moment(renderer, size=(120, 90))
            relievo.camera(renderer, **now)
            names = ["flow", "depth", "flow_valid", "motion"]
            image = relievo.capture(renderer, names, size=(120, 90), previous=before)
            found = [image.GetPointData().GetArrayName(i) for i in range(4)]
            self.assertEqual(found, names)
            self.assertLess(numpy.abs(relievo.layer(image, "flow") - expected).max(), 0.01)
            self.assertLess(numpy.abs(relievo.layer(image, "motion")).max(), 1e-6)
            self.assertTrue(numpy.isfinite(relievo.layer(image, "depth")).all())
            target = numpy.stack([u, v], -1) + expected
            inside = ((target > -0.5) & (target < (119.5, 89.5))).all(axis=-1)
            numpy.testing.assert_array_equal(relievo.layer(image, "flow_valid"), inside)
            sensor = relievo.Pinhole(now["K"], (120, 90), now["R"], now["t"])
            traced = relievo.capture(renderer, ["color", "flow"], camera=sensor, previous=before)
            numpy.testing.assert_allclose(relievo.layer(traced, "flow"),
                                          relievo.layer(image, "flow"), atol=1e-4)
            alone = relievo.capture(renderer, "flow", size=(120, 90), previous=before)
            self.assertEqual(alone.GetPointData().GetNumberOfArrays(), 1)

    def test_layers_of_a_parallel_camera(self):
        """A map's view moves by its shift, and from its principal point as it zooms."""
        renderer = scenes.plane_and_sphere(parallel=True)
        camera = renderer.GetActiveCamera()
        camera.SetParallelScale(2.0)
        camera.SetWindowCenter(0.2, -0.1)
        before = relievo.moment(renderer, size=SIZE)
        # Rays of the map are those of the frame.
        traced = relievo.capture(renderer, ["depth", "actor"], camera=before.sensor)
        drawn = relievo.capture(renderer, ["depth", "actor"], size=SIZE)
        same = relievo.layer(traced, "actor") == relievo.layer(drawn, "actor")
        self.assertGreater(same.mean(), 0.999)
        depths = (relievo.layer(each, "depth")[same] for each in (traced, drawn))
        numpy.testing.assert_allclose(*depths, rtol=1e-5)
        axis = numpy.array([0.8 * SIZE[0] / 2 - 0.5, 0.9 * SIZE[1] / 2 - 0.5])
        v, u = numpy.mgrid[: SIZE[1], : SIZE[0]]
        camera.SetParallelScale(2.5)
        image = relievo.capture(renderer, ["flow", "depth"], size=SIZE, previous=before)
        expected = 0.25 * (numpy.stack([u, v], -1) - axis)
        flow = relievo.layer(image, "flow")
        seen = numpy.isfinite(flow).all(axis=-1)
        self.assertGreater(seen.mean(), 0.9)
        self.assertLess(numpy.abs(flow - expected)[seen].max(), 0.01)
        # Matrices that others have made say more than scale and centre.
        explicit = vtkMatrix4x4()
        explicit.DeepCopy(camera.GetProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1))
        for row in (0, 1):
            explicit.SetElement(row, row, 1.3 * explicit.GetElement(row, row))
        explicit.SetElement(0, 3, 0.1)
        camera.SetExplicitProjectionTransformMatrix(explicit)
        camera.SetUseExplicitProjectionTransformMatrix(True)
        sensor = relievo.Orthographic.of(renderer, SIZE)
        places = numpy.array([[0.2, -0.3, 0.4], [-0.5, 0.1, 0.0]])
        view = camera.GetModelViewTransformMatrix()
        expected = []
        for place in places:
            x, y, _, _ = explicit.MultiplyPoint(view.MultiplyPoint((*place, 1)))
            expected.append(((1 + x) * SIZE[0] / 2 - 0.5, (1 - y) * SIZE[1] / 2 - 0.5))
        numpy.testing.assert_allclose(sensor.project(places), expected, atol=1e-9)
        explicit.SetElement(0, 0, 1.1 * explicit.GetElement(0, 0))  # of pixels that are not square
        camera.SetExplicitProjectionTransformMatrix(explicit)
        refused = self.assertRaisesRegex(ValueError, "camera: expected .* without shear")
        with refused:
            relievo.capture(renderer, ["flow"], size=SIZE, previous=before)
        camera.SetUseExplicitProjectionTransformMatrix(False)
        camera.SetParallelScale(0)
        with refused:
            relievo.Orthographic.of(camera, SIZE)
        camera.SetParallelScale(2.5)
        camera.SetViewShear(0.1, 0, 1)
        with refused:
            relievo.capture(renderer, ["flow"], size=SIZE, previous=before)

    def test_layers_of_a_turned_actor(self):
        renderer = vtkRenderer()
        source = vtkPlaneSource()
        source.SetOrigin(-1, -1, 0)
        source.SetPoint1(1, -1, 0)
        source.SetPoint2(-1, 1, 0)
        actor = scenes.add(renderer, source)
        relievo.camera(renderer, **self.wall())
        before = relievo.moment(renderer, size=(120, 90))
        actor.RotateZ(9)
        image = relievo.capture(renderer, ["flow", "motion", "position"], size=(120, 90),
                                previous=before)  # fmt: skip
        flow, motion, position = (relievo.layer(image, name)
                                  for name in ("flow", "motion", "position"))  # fmt: skip
        seen = numpy.isfinite(flow).all(axis=-1)
        self.assertGreater(seen.sum(), 1000)
        # y is down in the picture: back by 9 degrees is clockwise in the world, y up.
        angle = numpy.radians(9)
        back = numpy.array([[numpy.cos(angle), -numpy.sin(angle)],
                            [numpy.sin(angle), numpy.cos(angle)]])  # fmt: skip
        v, u = numpy.nonzero(seen)
        about = numpy.stack([u, v], -1) - (61.4, 40.2)
        self.assertLess(numpy.abs(flow[seen] - (about @ back.T - about)).max(), 0.01)
        place = position[seen]  # back in the world turns the other way
        place[:, :2] = place[:, :2] @ back
        self.assertLess(numpy.abs(motion[seen] - (place - position[seen])).max(), 1e-6)

    def test_layers_of_what_is_opaque(self):
        """A pane and a block, translucent, that move are in no layer of a frame and hide none."""
        corners = numpy.array([(-1, -1, 0), (1, -1, 0), (-1, 1, 0)])
        blocks = vtkMultiBlockDataSet()
        for i, z in enumerate((0.5, 0)):
            blocks.SetBlock(i, grid(*corners + (0, 0, z), 2, 2))
        mapper = vtkCompositeMapper()
        mapper.SetInputDataObject(blocks)
        attributes = vtkCompositeDataDisplayAttributes()
        attributes.SetBlockOpacity(blocks.GetBlock(0), 0.3)
        mapper.SetCompositeDataDisplayAttributes(attributes)
        plate = vtkActor()
        plate.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(plate)
        source = vtkPlaneSource()
        pane = scenes.add(renderer, source)
        pane.SetPosition(0, 0, 1)
        pane.GetProperty().SetOpacity(0.3)
        relievo.camera(renderer, **self.wall())
        names = ["depth", "actor", "block", "motion", "flow_valid"]
        before = relievo.moment(renderer, size=(120, 90))
        pane.SetPosition(0.5, 0, 1)
        vtk_to_numpy(blocks.GetBlock(0).GetPoints().GetData())[:, 0] += 0.5
        blocks.GetBlock(0).GetPoints().Modified()
        blocks.GetBlock(0).Modified()
        image = relievo.capture(renderer, names, size=(120, 90), previous=before)
        at = 40, 66  # both panes are before it, then and now
        self.assertEqual([relievo.layer(image, name)[at] for name in names[1:3]], [0, 2])
        seen = numpy.isfinite(relievo.layer(image, "depth"))
        self.assertGreater(seen.sum(), 1000)
        motion = relievo.layer(image, "motion")
        numpy.testing.assert_array_equal(numpy.isfinite(motion).all(axis=-1), seen)
        self.assertLess(numpy.abs(motion[seen]).max(), 1e-6)
        self.assertTrue((relievo.layer(image, "flow_valid")[seen] == 1).all())
        # By rays all surfaces are seen, also in the moment that was asked.
        sensor = relievo.Pinhole.of(renderer, (120, 90))
        image = relievo.capture(renderer, names, camera=sensor, previous=before)
        self.assertEqual(relievo.layer(image, "actor")[at], 1)
        numpy.testing.assert_allclose(relievo.layer(image, "motion")[at], (-0.5, 0, 0), atol=1e-6)

    def test_flow_alone_is_not_drawn(self):
        renderer = self.renderer()
        before = relievo.moment(renderer, size=SIZE)
        renderer.GetActiveCamera().Azimuth(2)
        beside = relievo.capture(renderer, ["depth", "flow"], size=SIZE, previous=before)
        drawn = []
        renderer.AddObserver("StartEvent", lambda *_: drawn.append(1))
        image = relievo.capture(renderer, "flow", size=SIZE, previous=before)
        self.assertEqual(drawn, [])
        numpy.testing.assert_array_equal(relievo.layer(image, "flow"),
                                         relievo.layer(beside, "flow"))  # fmt: skip
        self.assertGreater(numpy.isfinite(relievo.layer(image, "flow")).sum(), 1000)
        with self.assertRaisesRegex(ValueError, "size: the renderer has no window"):
            relievo.capture(renderer, "flow", previous=before)

    def test_progress_and_end_of_flow(self):
        """Each comes from a share of the rows; who ends it gets nothing."""
        renderer = self.renderer()
        moment = relievo.moment(renderer, size=(1024, 1024))  # two lots of rays
        source = vtkRelievoRayLayers()
        source.SetScene(moment.scene)
        source.SetCamera(moment.sensor.model)
        source.SetOther(moment.scene, moment.sensor.model)
        for name in ("flow", "depth"):
            source.AddLayer(name)
        shares = []
        source.AddObserver("ProgressEvent", lambda *_: shares.append(source.GetProgress()))
        source.Update()
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 1024 * 1024)
        self.assertEqual(sorted(shares), shares)
        self.assertTrue({0.25, 0.5, 0.75, 1.0} <= set(shares), shares)
        shares.clear()
        source.AddObserver("ProgressEvent", lambda *_: source.SetAbortExecute(1))
        source.Update()
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)
        self.assertNotIn(0.75, shares)
        self.assertLessEqual(shares.count(0.5), 1)  # VTK says where the flow ends

    def test_layers_are_refused_without_a_moment(self):
        renderer = self.renderer()
        before = relievo.moment(renderer, size=SIZE)
        sensor = relievo.Pinhole.of(renderer, SIZE)
        for words, says in (
            ({"layers": ["flow"]}, "flow.*needs previous=, from moment"),
            ({"layers": ["motion"], "camera": sensor, "size": None},
             "another state.*needs previous=, from moment"),
            ({"layers": ["depth"], "previous": before}, "previous: got a moment, expected one of"),
            ({"layers": ["flow"], "previous": sensor}, "previous: got .*expected what moment"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, says):
                relievo.capture(renderer, **{"size": SIZE, **words})
        # An array of the name is one, without a moment and by its kind.
        mesh = grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), 2, 2)
        add_field(mesh, "flow", numpy.full(9, 3.0))
        image = relievo.capture(mesh, ["flow"], camera=sensor)
        self.assertAlmostEqual(numpy.nanmax(relievo.layer(image, "flow")), 3, 12)
        moment = relievo.moment(mesh, sensor)
        image = relievo.capture(mesh, ["flow", "point:flow"], camera=sensor, previous=moment)
        self.assertAlmostEqual(numpy.nanmax(relievo.layer(image, "point:flow")), 3, 12)
        self.assertLess(numpy.nanmax(numpy.abs(relievo.layer(image, "flow"))), 1e-6)

    def test_hidden_is_not_valid(self):
        plate = grid((-1, -1, 0), (1, -1, 0), (-1, 1, 0), 1, 1)
        cover = grid((5, -1, 1), (6, -1, 1), (5, 1, 1), 1, 1)
        sensor = relievo.Pinhole([[50, 0, 50], [0, 50, 50], [0, 0, 1]], (101, 101))
        sensor.look_at((0, 0, 3), (0, 0, 0))
        before = relievo.moment([plate, cover], sensor)
        points = vtk_to_numpy(cover.GetPoints().GetData())
        points[:, 0] -= 5  # over the right half of the plate
        cover.GetPoints().Modified()
        valid = relievo.layer(relievo.flow(before, [plate, cover], sensor), "flow_valid")
        self.assertTrue((valid[40:61, 35:50] == 1).all())
        self.assertTrue((valid[40:61, 51:66] == 0).all())


def linear_of(shown):
    """Linear light of values for display, by the sRGB standard."""
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def shown_of(light):
    """The inverse of linear_of()."""
    light = numpy.clip(light, 0, 1)
    return numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def pixels_of(window):
    """The window's picture, bytes."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())


def unlit(renderer, mesh, color=(1, 1, 1)):
    """An actor that shows its colours as they are."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(mesh)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*color)
    renderer.AddActor(actor)
    return actor


def ball(center, radius, resolution=200):
    source = vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


class Colour(unittest.TestCase):
    """capture("color", camera=) against pictures whose colour is known at every place."""

    WIDE = relievo.Fisheye([[60.0, 0, 80], [0, 60, 60], [0, 0, 1]], (161, 121), (0.02, -0.01))
    SENSORS = (
        WIDE, relievo.Pinhole(K, SIZE, distortion=(-0.2, 0.02)),
        relievo.Pinhole(K, SIZE, distortion=(0.1, 0.02, 0.01, -0.02)),
        relievo.Division(K, SIZE, -0.1), relievo.Pinhole(K, SIZE),
        relievo.Equirectangular((200, 100)), relievo.Cube(40),
    )

    def room(self, center=(0, 0, 0)):
        """Around a place: the red, green and blue that are shown are x, y, z from 0 to 1."""
        mesh = box(center, 1)
        corners = vtk_to_numpy(mesh.GetPoints().GetData()) - center
        colors = numpy_to_vtk(numpy.uint8(255 * (corners > 0)), deep=True)
        colors.SetName("color")
        mesh.GetPointData().SetScalars(colors)
        renderer = vtkRenderer()
        unlit(renderer, mesh)
        return renderer

    def test_places_of_colours(self):
        """The colour where a ray hits the walls, within 1 of 255, mean 0.3 (with HDR 0.1); in
        the corners, where it turns, within half of its change in a pixel."""
        eye = numpy.array((0.2, -0.1, 0.15))
        for far in (0.0, 5e5):
            center = numpy.array((far, -far, far))
            renderer = self.room(center)
            for sensor in self.SENSORS:
                with self.subTest(sensor=type(sensor).__name__, far=far):
                    sensor.look_at(eye + center, center + (0.3, 0.5, 0.9), (0.1, 1, 0))
                    image = relievo.capture(renderer, "color", camera=sensor, hdr=far > 0)
                    color = relievo.layer(image, "color")
                    _, directions = sensor.rays()
                    seen = numpy.isfinite(directions).all(axis=-1)
                    self.assertGreater(seen.mean(), 0.6)
                    with numpy.errstate(divide="ignore"):
                        away = ((numpy.sign(directions) - eye) / directions).min(axis=-1)
                    expected = (1 + eye + away[..., None] * directions) / 2
                    off = numpy.abs(shown_of(color[..., :3]) - expected)[seen] * 255
                    self.assertLess(off.mean(), 0.1 if far else 0.3)
                    walls = numpy.sort(numpy.abs(eye + away[..., None] * directions)[seen])
                    self.assertLess(off[walls[:, 1] < 0.9].max(), 1)
                    self.assertLess(off.max(), 255 / 40 / 2)
                    self.assertTrue((color[seen][:, 3] > 0.999).all())
                    self.assertTrue((color[~seen] == 0).all())

    def test_edges_are_those_of_actors(self):
        """Beside edges of `actor` the colour is that of the actor, or of the background."""
        renderer = vtkRenderer()
        renderer.SetBackground(0.1, 0.2, 0.6)
        colors = [(0.1, 0.2, 0.6)]  # of no actor, -1
        rng = numpy.random.default_rng(3)
        for _ in range(40):
            colors.append(tuple(rng.integers(0, 256, 3) / 255))
            away = rng.normal(size=3)
            away *= rng.uniform(2, 6) / numpy.linalg.norm(away)
            unlit(renderer, ball(away, rng.uniform(0.2, 1), 60), colors[-1])
        colors = linear_of(numpy.array(colors))
        maps = (relievo.Orthographic(20, SIZE, center=(60, 75)),)
        for sensor in self.SENSORS + maps:
            with self.subTest(sensor=type(sensor).__name__):
                sensor.look_at((0.2, 0.1, 0.3), (2, 1, 0), (0, 1, 0))
                image = relievo.capture(renderer, ["color", "actor"], camera=sensor)
                actor = relievo.layer(image, "actor")
                color = relievo.layer(image, "color")[..., :3]
                self.assertGreater(len(numpy.unique(actor)), 3)
                inner = numpy.isfinite(sensor.rays()[1]).all(axis=-1)
                for i, j in ((0, 1), (1, 0), (1, 1), (1, -1)):
                    for sign in (1, -1):
                        moved = numpy.roll(actor, (sign * i, sign * j), (0, 1))
                        inner &= moved == actor
                if isinstance(sensor, relievo.Cube):  # neighbours are in other faces
                    inner &= numpy.isin(numpy.arange(sensor.size[0]) % 40, (0, 39), invert=True)
                if isinstance(sensor, relievo.Equirectangular):  # its columns meet at the poles
                    inner[:17] = inner[83:] = False
                self.assertGreater(inner.mean(), 0.4)
                off = numpy.abs(color - colors[actor + 1])[inner]
                self.assertLess(off.max(), 2e-3)  # of half floats

    def test_light_is_one_for_all_faces(self):
        """A headlight is that of the sensor: Lambert's law by the normals of rays, all around."""
        renderer = vtkRenderer()
        for away in numpy.array(((3, 3, 0), (-3, 0, 3), (0, 3, 3), (0, -4, 0), (3, -1, -4))):
            unlit(renderer, ball(away, 1.4)).GetProperty().LightingOn()
        sensor = relievo.Equirectangular((300, 150)).look_at((0, 0, 0), (1, 1, 2), (0, 1, 0))
        image = relievo.capture(renderer, ["color", "normal", "actor"], camera=sensor)
        light = renderer.GetLights().GetItemAsObject(0)
        self.assertTrue(light.LightTypeIsHeadlight())
        inner = (relievo.layer(image, "normal") ** 2).sum(axis=-1) > 0.5
        for axis in (0, 1):
            for step in (1, -1):
                inner &= numpy.roll(inner, step, axis)
        lambert = numpy.clip(-relievo.layer(image, "normal") @ sensor.R[2], 0, 1)
        shown = shown_of(relievo.layer(image, "color")[..., 0])
        self.assertGreater(inner.sum(), 2000)
        self.assertLess(numpy.abs(shown - lambert)[inner].max(), 0.03)
        self.assertLess(numpy.abs(shown - lambert)[inner].mean(), 0.002)

    def test_all_is_as_before(self):
        renderer = self.room()
        renderer.RemoveAllViewProps()
        unlit(renderer, ball((0, 0, 0), 1), (1, 0.5, 0)).GetProperty().LightingOn()
        renderer.SetViewport(0.25, 0, 1, 0.5)
        renderer.SetBackground(0.5, 0, 0)
        renderer.SetBackground2(0, 0, 0.5)
        renderer.GradientBackgroundOn()
        window = scenes.window_of(renderer, 203, 105)
        spot = vtkLight()
        spot.SetLightTypeToCameraLight()
        spot.SetPosition(0.3, 0.4, 1)
        renderer.AddLight(spot)
        renderer.ResetCamera()

        def state():
            window.Render()
            camera = renderer.GetActiveCamera()
            return (camera, camera.GetPosition(), camera.GetViewAngle(), window.GetSize(),
                    window.GetUseOffScreenBuffers(), renderer.GetViewport(), renderer.GetPass(),
                    renderer.GetBackground(), renderer.GetGradientBackground(),
                    renderer.GetBackgroundAlpha(), spot.GetLightType(), spot.GetPosition(),
                    pixels_of(window).tobytes())

        before = state()
        sensor = self.WIDE.look_at((0, 0, 2), (0, 0, 0))
        image = relievo.capture(renderer, ["color", "actor"], camera=sensor)
        self.assertEqual(state(), before)
        # The gradient goes over the sensor's picture.
        color = relievo.layer(image, "color")
        rows = numpy.arange(121)
        behind = relievo.layer(image, "actor") < 0
        for axis in (0, 1):
            behind &= numpy.roll(behind, 1, axis) & numpy.roll(behind, -1, axis)
        behind &= numpy.isfinite(sensor.rays()[1]).all(axis=-1)
        self.assertGreater(behind.mean(), 0.2)
        share = (120.5 - rows) / 121
        expected = linear_of(numpy.stack([0.5 - 0.5 * share, 0 * share, 0.5 * share], axis=-1))
        off = numpy.abs(color[..., :3] - expected[:, None])[behind]
        self.assertLess(off.max(), 4e-3)  # a step of 8 bits

    def test_tones(self):
        """The picture after `tone`: one automatic exposure for all faces."""
        renderer = self.room()
        tone = relievo.stage(renderer, "tone", operator="clamp", auto_exposure=True, exposure=-1)
        sensor = relievo.Equirectangular((200, 100)).look_at((0.2, -0.1, 0.3), (1, 0, 0))
        window = scenes.window_of(renderer)
        source = relievo.vtkRelievoLensPicture()
        source.SetRenderer(renderer)
        source.SetCamera(sensor.model)
        source.HDROn()
        source.PictureOn()
        source.Update()
        self.assertEqual(source.GetNumberOfViews(), 6)
        color = relievo.layer(source.GetOutput(), "color")[..., :3].astype(float)
        bright = color @ (0.2126, 0.7152, 0.0722)
        least = (1 / 255) / 12.92
        factor = 0.5 * 0.18 / 2 ** numpy.log2(numpy.maximum(bright, least)).mean()
        expected = numpy.round(255 * shown_of(factor * color))
        picture = relievo.layer(source.GetOutput(), "picture")
        self.assertLess(numpy.abs(picture - expected).max(), 2.01)
        self.assertGreater((numpy.abs(picture - expected) < 1.01).mean(), 0.99)
        self.assertTrue(tone.GetAutoExposure())
        self.assertEqual(tone.GetExposure(), -1)
        window.Finalize()

    def test_drawn_pixels_are_no_wider(self):
        """A pinhole's pixel is at most as wide as any of the fisheye's that it is drawn for."""
        renderer = self.room()
        window = scenes.window_of(renderer)
        source = relievo.vtkRelievoLensPicture()
        source.SetRenderer(renderer)
        # Equal steps of the angle: 1 / 300 radians; over the plane at distance 1 as much in the
        # middle, and more beside it.
        sensor = relievo.Fisheye([[300.0, 0, 80], [0, 300, 60], [0, 0, 1]], (161, 121))
        source.SetCamera(sensor.model)
        for factor in (1, 2):
            source.SetOversampling(factor)
            source.Update()
            self.assertEqual(source.GetNumberOfViews(), 1)
            least = numpy.prod([2 * factor * 300 * numpy.tan(half / 300) for half in (80, 60)])
            self.assertGreater(source.GetNumberOfDrawnPixels(), least)
            self.assertLess(source.GetNumberOfDrawnPixels(), 1.2 * least)
        window.Finalize()

    def test_window_in_tiles(self):
        """A window that draws a picture in tiles has its size and its tile again."""
        window = scenes.window_of(self.room())
        window.SetTileScale(2, 3)
        window.SetTileViewport(0.5, 0, 1, 0.5)
        before = tuple(window.GetActualSize())
        source = relievo.vtkRelievoLensPicture()
        source.SetRenderer(window.GetRenderers().GetFirstRenderer())
        source.SetCamera(relievo.Equirectangular((40, 20)).model)
        source.Update()
        self.assertEqual(source.GetNumberOfViews(), 6)
        self.assertEqual(tuple(window.GetActualSize()), before)
        self.assertEqual(tuple(window.GetTileScale()), (2, 3))
        self.assertEqual(tuple(window.GetTileViewport()), (0.5, 0, 1, 0.5))
        window.Finalize()

    def test_odd_ones(self):
        empty = vtkRenderer()
        empty.SetBackground(0.2, 0.4, 0.6)
        color = relievo.layer(relievo.capture(empty, "color", camera=self.WIDE), "color")
        middle = linear_of(numpy.array((0.2, 0.4, 0.6)))
        self.assertLess(numpy.abs(color[40:80, 40:120, :3] - middle).max(), 1e-3)
        room = self.room()
        one = relievo.Fisheye(numpy.eye(3), (1, 1)).look_at((0, 0, 0), (0, 0, 1))
        color = relievo.layer(relievo.capture(room, "color", camera=one), "color")
        self.assertLess(numpy.abs(shown_of(color[0, 0, :3]) - (0.5, 0.5, 1)).max(), 1 / 255)
        strip = relievo.Equirectangular((16384, 3), (360, 0.066)).look_at((0, 0, 0), (0, 0, 1))
        color = relievo.layer(relievo.capture(room, "color", camera=strip), "color")
        away = strip.rays()[1]
        away = away / numpy.abs(away).max(axis=-1, keepdims=True)
        self.assertLess(numpy.abs(shown_of(color[..., :3]) - (1 + away) / 2).max(), 1 / 255)
        for sensor in (relievo.Lidar([0, 1], steps=9), relievo.Pushbroom(9, (0, 1, 0), (8, 8))):
            with self.assertRaisesRegex(ValueError, "color: colour is drawn from one place"):
                relievo.capture(room, "color", camera=sensor)
        with self.assertRaisesRegex(ValueError, "size: got"):
            relievo.capture(room, "color", camera=self.WIDE, size=(3, 4))
        window = scenes.window_of(room)
        relievo.attach(room).SetDisplayLayer("depth")
        with self.assertRaisesRegex(ValueError, "'depth' is shown as the picture"):
            relievo.capture(room, "color", camera=self.WIDE)
        window.Finalize()


class OwnShaders(unittest.TestCase):
    """Vertex shader code of the user's own, which bends the picture as a lens does."""

    def test_places_follow_the_picture(self):
        mesh = grid((-3, -2, -1), (3, -2, 1), (-3, 2, 0.5), 160, 120)
        add_field(mesh, "place", vtk_to_numpy(mesh.GetPoints().GetData()))
        for parallel in (False, True):
            renderer = vtkRenderer()
            actor = unlit(renderer, mesh)
            straight = unlit(renderer, ball((0.2, 0.1, 1), 0.3))
            actor.GetShaderProperty().AddVertexShaderReplacement(
                "//VTK::PositionVC::Impl", True,
                "//VTK::PositionVC::Impl\n"
                "  vec2 bent = gl_Position.xy / gl_Position.w;\n"
                "  gl_Position.xy *= 1.0 - 0.2 * dot(bent, bent);\n", False)
            renderer.ResetCamera()
            renderer.GetActiveCamera().SetParallelProjection(parallel)
            renderer.GetActiveCamera().Zoom(1.3)
            names = ["position", "range", "actor", "cell", "place", "depth"]
            image = relievo.capture(renderer, names, size=(200, 150))
            layers = {name: relievo.layer(image, name) for name in names}
            to_clip = relievo.attributes(image)["worldToNDC"]
            points = numpy.concatenate(
                [layers["position"], numpy.ones((150, 200, 1))], axis=-1) @ to_clip.T
            places = points[..., :2] / points[..., 3:]
            seen = layers["actor"] == 0
            self.assertGreater(seen.mean(), 0.3)
            self.assertTrue((layers["actor"] == 1).any())
            places[seen] *= (1 - 0.2 * (places[seen]**2).sum(axis=-1))[:, None]
            v, u = numpy.mgrid[:150, :200]
            centres = numpy.stack([(u + 0.5) / 100 - 1, 1 - (v + 0.5) / 75], axis=-1)
            # Corners are distorted, interpolation between them is linear: 1/50 pixel here.
            off = numpy.abs(places - centres) * (100, 75)
            self.assertLess(off[layers["actor"] >= 0].max(), 0.02)
            # The array of places is the position, which lies in the cell that the layer says.
            self.assertLess(numpy.abs(layers["place"] - layers["position"])[seen].max(), 5e-4)
            corner = numpy.array([-3.0, -2, -1])
            column = (layers["position"] - corner)[seen] @ numpy.linalg.pinv(
                numpy.array([(6 / 160, 0, 2 / 160), (0, 4 / 120, 1.5 / 120)]))
            column, row = column[:, 0], column[:, 1]
            cell = layers["cell"][seen]
            self.assertLess(numpy.abs(column - cell % 160 - 0.5).max(), 0.5 + 1e-2)
            self.assertLess(numpy.abs(row - cell // 160 - 0.5).max(), 0.5 + 1e-2)
            if not parallel:
                eye = renderer.GetActiveCamera().GetPosition()
                away = numpy.linalg.norm(layers["position"] - eye, axis=-1)
                self.assertLess(numpy.abs(layers["range"] - away)[seen].max(), 1e-5)
            actor.GetShaderProperty().ClearAllVertexShaderReplacements()
            straight.VisibilityOff()


class Cover(unittest.TestCase):
    def scene(self, draw):
        """Level tiles in z = 0 and walls between them, as quads of a mesh; candidates."""
        walls = []
        for _ in range(3):
            x, y = draw.uniform(0.5, 3.5, 2)
            along = draw.uniform(-1, 1, 2)
            walls.append([(x, y, 0.01), (x + along[0], y + along[1], 0.01),
                          (x + along[0], y + along[1], 1), (x, y, 1)])  # fmt: skip
        tiles = [[(i + a, j + b, 0) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                 for i in range(4) for j in range(4)]  # fmt: skip
        corners = numpy.array(tiles + walls, float)
        mesh = vtkPolyData()
        mesh.SetPoints(vtkPoints())
        mesh.GetPoints().SetData(numpy_to_vtk(corners.reshape(-1, 3), deep=True))
        cells = vtkCellArray()
        for i in range(len(corners)):
            cells.InsertNextCell(4, range(4 * i, 4 * i + 4))
        mesh.SetPolys(cells)
        places = numpy.column_stack([draw.uniform(0, 4, (12, 2)), draw.uniform(0.2, 2, 12)])
        return mesh, corners, places

    def free(self, corners, place, at, own):
        """Whether no wall lies between a candidate and a point of quad `own`, by planes."""
        for quad in range(16, len(corners)):
            if quad == own:
                continue
            a, b, _, d = corners[quad]
            normal = numpy.cross(b - a, d - a)
            down = (place - at) @ normal
            share = (a - at) @ normal / down if down else -1
            u, v = ((at + share * (place - at) - a) @ side / (side @ side)
                    for side in (b - a, d - a))  # fmt: skip
            if 0 < share < 1 and 0 < u < 1 and 0 < v < 1:
                return False
        return place[2] > 0

    def test_brute_force(self):
        """All choices of places, with visibility by planes: the guarantee, the bound, counts."""
        draw = numpy.random.default_rng(4)
        best_of_all = []
        for number in range(30):
            mesh, corners, places = self.scene(draw)
            times, k = 1 + number % 2, 1 + number % 3
            weights = draw.uniform(0, 1, len(corners))
            covered, chosen = relievo.cover(mesh, places, k, times=times, weights=weights)
            middles = corners.mean(1)
            seen = numpy.array([
                [self.free(corners, place, at, own) for own, at in enumerate(middles)]
                for place in places
            ])
            found = vtk_to_numpy(covered.GetCellData().GetArray("candidates"))
            numpy.testing.assert_array_equal(found, seen.sum(0))
            edges = corners[:, [1, 3]] - corners[:, :1]
            area = numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1)
            area *= weights
            total = area.sum() * times

            def share(some):
                return (area * numpy.minimum(seen[list(some)].sum(0), times)).sum() / total

            best = max(share(some) for some in itertools.combinations(range(12), k))
            picked = vtk_to_numpy(chosen.GetPointData().GetArray("candidate"))
            got, bound, reach = (covered.GetFieldData().GetArray(name).GetValue(0)
                                 for name in ("share", "bound", "reachable"))  # fmt: skip
            self.assertAlmostEqual(got, share(picked), delta=1e-12)
            self.assertAlmostEqual(reach, share(range(12)), delta=1e-12)
            self.assertGreaterEqual(got, (1 - 1 / numpy.e) * best)
            self.assertGreaterEqual(bound, best - 1e-12)
            self.assertLessEqual(bound, reach + 1e-12)
            if k == 1:
                self.assertAlmostEqual(got, best, delta=1e-12)
            best_of_all.append(got / best)
        self.assertGreater(numpy.mean(best_of_all), 0.98)

    def test_limits(self):
        """Distances, angles, cones and resolution of which the closed form is known."""
        plane = vtkPlaneSource()
        plane.SetOrigin(-50, -50, 0)
        plane.SetPoint1(50, -50, 0)
        plane.SetPoint2(-50, 50, 0)
        plane.SetResolution(200, 200)
        middle = (numpy.arange(200) + 0.5) / 2 - 50
        x, y = numpy.meshgrid(middle, middle)
        height = 10
        away = numpy.sqrt(x**2 + y**2 + height**2)
        cosine = height / away
        aside = numpy.array([1, 0, -1]) / numpy.sqrt(2)
        to = numpy.stack([x, y, -height * numpy.ones_like(x)], -1) / away[..., None]
        for given, expected in (
            ({"farthest_distance": 20}, away <= 20),
            ({"largest_angle": 30}, cosine >= numpy.cos(numpy.radians(30))),
            ({"view_angle": 50, "directions": [aside]}, to @ aside >= numpy.cos(numpy.radians(25))),
            ({"resolution": 40, "focal_length": 500}, 500 * cosine / away >= 40),
        ):
            for z in (height, -height):  # from either side
                if z < 0 and "directions" in given:
                    continue
                with self.subTest(given, z=z):
                    covered, _ = relievo.cover(plane, [(0, 0, z)], 1, **given)
                    found = vtk_to_numpy(covered.GetCellData().GetArray("covered"))
                    numpy.testing.assert_array_equal(found.reshape(200, 200) > 0, expected)
        for given in ({"k": 0}, {"view_angle": 90}, {"candidates": [(0, 0)]}, {"weights": [1]},
                      {"candidates": numpy.empty((0, 3))}, {"directions": numpy.ones((2, 3))},
                      {"weights": -numpy.ones(40000)}):  # fmt: skip
            with self.subTest(given), self.assertRaises(ValueError):
                relievo.cover(**{"mesh": plane, "candidates": [(0, 0, 1)], "k": 1, **given})


class Parts(unittest.TestCase):
    def test_parts(self):
        """Pickled parts, in threads, make the file of one process; wrong arguments are refused."""
        with tempfile.TemporaryDirectory() as folder:
            ground = pathlib.Path(folder, "a ground.off")
            ground.write_text("OFF\n6 2 0\n-2 0 -1\n-2 0 1\n0 0 1\n0 0 -1\n2 0 1\n2 0 -1\n"
                              "4 0 1 2 3\n4 3 2 4 5\n")  # fmt: skip
            job = ["sun", ground, "--place", "40,10", "--dates", "2026-03-20", "-o"]
            whole, shared = (pathlib.Path(folder, name) for name in ("whole.vtp", "shared.vtp"))
            relievo.parts([*job, whole], 1)[0]()
            self.assertEqual(relievo.merge(f"{whole}.parts"), str(whole))
            parts = relievo.parts(shlex.join(map(str, [*job, shared])), 3)
            first = pickle.loads(pickle.dumps(parts[0]))
            self.assertEqual(sorted(pathlib.Path(path).name for path in first()),
                             ["mesh.vtp", "part-000001.bin", "part-000001.json"])  # fmt: skip
            self.assertIn("2 missing: 2, 3", relievo.verify(parts))
            (state,) = relievo.status(parts)
            self.assertEqual((state.number, state.count), (1, 3))
            self.assertEqual((state.done, state.all, state.seconds_left), (100, 100, 0))
            second = pathlib.Path(parts[0].directory, "progress", "part-000002.json")
            second.write_text('{"part": 2, "of": 3, "items": "%", "done": 40, "all": 100, '
                              '"before": 10, "seconds": 6}')  # fmt: skip
            state = relievo.status(parts[0].directory)[1]
            self.assertEqual((state.number, state.rate, state.seconds_left), (2, 5, 12))
            damaged = pathlib.Path(parts[0].directory, "progress", "part-000003.json")
            invalid = second.read_text().replace("40", '""')
            for text in ("[]", "null", '{"part": 3, "of": 3}', invalid):
                damaged.write_text(text)
                self.assertEqual([each.number for each in relievo.status(parts)], [1, 2])
            damaged.unlink()
            damaged.mkdir()
            self.assertEqual([each.number for each in relievo.status(parts)], [1, 2])
            damaged.rmdir()
            with self.assertRaisesRegex(ValueError, "has begun"):
                relievo.status(folder)
            with self.assertRaisesRegex(RuntimeError, "1 of 3 parts complete"):
                relievo.merge(parts)
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                list(pool.map(relievo.Part.__call__, parts))
            self.assertEqual(relievo.merge(parts), str(shared))
            self.assertEqual((relievo.verify(parts), relievo.status(parts)), ("", []))
            self.assertEqual(shared.read_bytes(), whole.read_bytes())
            with self.assertRaisesRegex(ValueError, "--place"):
                relievo.parts(["sun", str(ground), "-o", "none.vtp"], 2)[0]()
            for given in (("bench sun", 2), ("render a.off", 2), ("sun a.off", 2),
                          ([*job, shared], 0)):  # fmt: skip
                with self.assertRaises(ValueError):
                    relievo.parts(*given)
            odd = relievo.parts(["sun", "-o", "odd.vtp", "--", "-odd.off"], 2)[0]
            with self.assertRaisesRegex(ValueError, "--place"):  # not a file --part=1/2
                odd()
            self.assertEqual(odd.files(), [])
            for given in ([1], None, [], [*parts, odd]):
                with self.subTest(given), self.assertRaises(ValueError):
                    relievo.merge(given)
            for given in ((None, 2), (["sun", 3], 2), (job, 1.5), (job, True)):
                with self.subTest(given), self.assertRaises(ValueError):
                    relievo.parts(*given)

    def test_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            ground = pathlib.Path(folder, "ground.off")
            ground.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            job = ["render", ground, "--preset=none", "--size=16x12", "--turntable=3"]
            parts = relievo.parts([*job, f"--png={folder}/f_%02d.png"], 2)
            parts[1]()
            self.assertEqual([pathlib.Path(path).name for path in parts[1].files()],
                             ["f_02.png", "frame-000002.json"])  # fmt: skip
            self.assertEqual(relievo.status(parts)[0].all, 1)
            self.assertIn("2 missing: 0, 1", relievo.verify(parts))
            self.assertEqual(len(parts[0]()), 4)
            self.assertEqual(relievo.merge(parts), str(pathlib.Path(folder, "f_.png.parts")))
            self.assertEqual(relievo.verify(parts), "")
            film = relievo.parts([*job, "--png=f%d.png", "--video=a%d.mkv"], 1)[0]
            self.assertEqual(pathlib.Path(film.directory).name, "a%d.mkv.parts")


if __name__ == "__main__":
    unittest.main(verbosity=2)
