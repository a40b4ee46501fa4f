# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrains of rasters: viewsheds compared with brute force in double, closed forms and
gdal_viewshed; GeoTIFF with GDAL."""

import math
import os
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import relievo

try:
    from osgeo import gdal, osr

    gdal.UseExceptions()
except ImportError:
    gdal = None

needs_gdal = unittest.skipUnless(gdal, "no GDAL: packages.txt, [tests]")
UTM = (30.0, 0.0, 689300.0, 0.0, -30.0, 5337200.0)


def hills(rows, columns, seed=1, height=300.0, finest=5.0):
    """Heights of waves with random phases, whose amplitude falls with their frequency."""
    lots = numpy.random.default_rng(seed)
    v, u = numpy.mgrid[:rows, :columns] / max(rows, columns)
    heights = numpy.zeros((rows, columns))
    for _ in range(60):
        frequency = 2 ** lots.uniform(0, finest)
        turn, phase = lots.uniform(0, 2 * math.pi, 2)
        along = u * math.cos(turn) + v * math.sin(turn)
        heights += numpy.sin(2 * math.pi * frequency * along + phase) / frequency
    return 500 + height * heights / numpy.abs(heights).max()


def places(transform, rows, columns):
    """The centres of the cells, (rows, columns, 2)."""
    a, b, c, d, e, f = transform
    v, u = numpy.mgrid[:rows, :columns] + 0.5
    return numpy.stack([a * u + b * v + c, d * u + e * v + f], axis=-1)


def triangles_of(heights, transform):
    """The corners of the terrain's triangles, (n, 3, 3), as the documentation defines them."""
    rows, columns = heights.shape
    points = numpy.concatenate([places(transform, rows, columns), heights[..., None]], axis=-1)
    found = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            first, down, last, right = (points[row, column], points[row + 1, column],
                                        points[row + 1, column + 1], points[row, column + 1])
            ring = [each for each in (first, down, last, right) if numpy.isfinite(each[2])]
            if len(ring) == 4:
                found += [(first, down, last), (first, last, right)]
            elif len(ring) == 3:
                found.append(tuple(ring))
    return numpy.array(found)


def are_free(eye, targets, corners):
    """Whether no triangle meets the lines from the eye to targets: by Cramer's rule for each
    pair (T. Möller, B. Trumbore 1997)."""
    a, b, c = (corners[:, k] - eye for k in range(3))
    across = numpy.cross(b - a, c - a)
    free = []
    for target in targets:
        line = target - eye
        with numpy.errstate(divide="ignore", invalid="ignore"):
            down = across @ line
            t = (across * a).sum(axis=1) / down
            hit = t[:, None] * line - a
            u = (numpy.cross(hit, c - a) * across).sum(axis=1) / (across**2).sum(axis=1)
            v = (numpy.cross(b - a, hit) * across).sum(axis=1) / (across**2).sum(axis=1)
            met = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)
        free.append(not met.any())
    return numpy.array(free)


def ground(corners, x, y):
    """The height of the triangles at a place."""
    def cross(p, q):
        return p[0] * q[1] - p[1] * q[0]

    for a, b, c in corners:
        area = cross(b - a, c - a)
        u = cross([x, y] - a[:2], c - a) / area
        v = cross(b - a, [x, y] - a[:2]) / area
        if u >= 0 and v >= 0 and u + v <= 1:
            return a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
    raise AssertionError("outside")


def seen(terrain, observers, **settings):
    return terrain.rasters(relievo.viewshed(terrain, observers, **settings))["seen"]


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, values, transform=UTM, kind=None, nodata=None, epsg=32632, options=()):
        """A GeoTIFF by GDAL, of floats by default."""
        kind = kind or gdal.GDT_Float32
        values = numpy.atleast_3d(values)
        path = str(self.folder / name)
        file = gdal.GetDriverByName("GTiff").Create(
            path, values.shape[1], values.shape[0], values.shape[2], kind, list(options))
        if transform is not None:
            a, b, c, d, e, f = transform
            file.SetGeoTransform((c, a, b, f, d, e))
        if epsg:
            system = osr.SpatialReference()
            system.ImportFromEPSG(epsg)
            file.SetProjection(system.ExportToWkt())
        for band in range(values.shape[2]):
            file.GetRasterBand(band + 1).WriteArray(values[..., band])
            if nodata is not None:
                file.GetRasterBand(band + 1).SetNoDataValue(nodata)
        del file
        return path


class Viewshed(Folder):
    def test_brute_force(self):
        """Grids that are north-up, turned and sheared, or mirrored, with and without holes, far
        from the origin."""
        lots = numpy.random.default_rng(4)
        turned = (24.0, 11.0, 689300.0, -13.0, 20.0, 5337200.0)
        south_up = (30.0, 0.0, 689300.0, 0.0, 30.0, 5337200.0)
        differ = 0
        for transform, holes in ((UTM, 0), (UTM, 40), (turned, 25), (south_up, 25)):
            heights = hills(23, 31, seed=holes, finest=2.5)
            heights.ravel()[lots.choice(heights.size, holes, replace=False)] = numpy.nan
            corners = triangles_of(heights, transform)
            terrain = relievo.terrain(heights, transform)
            numpy.testing.assert_array_equal(terrain.heights, heights)
            self.assertEqual(terrain.dataset.GetNumberOfCells(), len(corners))
            for target_height in (0.0, 7.5):
                few = lots.permutation(corners)[:9].mean(axis=1)
                x, y = few[few[:, 2].argmax(), :2] + (0.7, -0.4)
                found = seen(terrain, (x, y, 1.7), target_height=target_height)
                eye = numpy.array([x, y, ground(corners, x, y) + 1.7])
                # Just above the ground: through a hole, its underside may be seen.
                above = heights[..., None] + target_height + 1e-5
                targets = numpy.concatenate([places(transform, *heights.shape), above], axis=-1)
                there = numpy.isfinite(heights)
                expected = are_free(eye, targets[there], corners)
                self.assertTrue(0.02 < expected.mean() < 0.98, expected.mean())
                differ += (found[there] != expected).sum()
                self.assertTrue((found[~there] == terrain.nodata).all())
        self.assertEqual(differ, 0)

    def test_far_from_the_origin(self):
        """Coordinates of 4e6 m change no verdict: shifts by powers of two keep all coordinates."""
        heights = numpy.round(hills(60, 80), 1)
        here = relievo.terrain(heights, (32, 0, 0, 0, -32, 0))
        far = relievo.terrain(heights, (32, 0, 2**20, 0, -32, 2**22))
        x, y = 1000.25, -777.5
        numpy.testing.assert_array_equal(seen(here, (x, y, 2)),
                                         seen(far, (2**20 + x, 2**22 + y, 2)))  # fmt: skip

    def test_ridge(self):
        """From a height h, a ridge of height H at a distance x hides level ground to x h/(h - H);
        two observers, and a largest distance."""
        heights = numpy.zeros((3, 200))
        heights[:, 60] = 8
        terrain = relievo.terrain(heights, (1, 0, -0.5, 0, -1, 2.5))
        along = numpy.arange(200)
        for h in (10.0, 12.0, 30.0):
            found = seen(terrain, (0, 1, h))[1]
            hidden = (along > 60) & (along < 60 * h / (h - 8) - 1e-6)
            self.assertTrue(hidden.any())
            numpy.testing.assert_array_equal(found, ~hidden)
        both = seen(terrain, [(0, 1, 10), (199, 1, 10)], farthest_distance=150)[1]
        from_end = ~((along < 60) & (along > 199 - 139 * 10 / 2 + 1e-6)) & (199 - along <= 150)
        from_start = ~((along > 60) & (along < 300)) & (along <= 150)
        numpy.testing.assert_array_equal(both, from_start.astype(int) + from_end)

    def test_cone(self):
        """From the top all of a cone is seen; from its foot, only the side between its tangents."""
        v, u = numpy.mgrid[-40:41, -40:41].astype(float)
        radius = numpy.hypot(u, v)
        terrain = relievo.terrain(40 - radius, (1, 0, -40.5, 0, -1, 40.5))
        self.assertTrue((seen(terrain, (0, 0, 1)) == 1).all())
        # An eye at the distance d, h above the cone, is above the tangent plane at (x, y), which is
        # at the distance r, if x d > (d - h) r.
        d, h = 30.0, 2.0
        found = seen(terrain, (d, 0, h)) == 1
        margin = u * d - (d - h) * radius
        clear = numpy.abs(margin) > 0.02 * d * radius + 2 * d  # the triangles are not round
        self.assertGreater(clear.mean(), 0.6)
        numpy.testing.assert_array_equal(found[clear], (margin > 0)[clear])

    def test_curvature(self):
        """Level ground ends at the horizon, sqrt(2 R h / k); targets of a height beyond it."""
        terrain = relievo.terrain(numpy.zeros((3, 400)), (50, 0, -25, 0, -50, 75))
        along = numpy.arange(400) * 50
        for k in (1.0, 0.857):
            reach = math.sqrt(2 * 6371e3 * 2 / k)
            beyond = math.sqrt(2 * 6371e3 * 3 / k)
            found = seen(terrain, (0, 0, 2), curvature=k)[1]
            self.assertLessEqual(abs(along[found == 1].max() - reach), 50)
            self.assertTrue((found[: found.sum()] == 1).all())
            found = seen(terrain, (0, 0, 2), curvature=k, target_height=3)[1]
            self.assertLessEqual(abs(along[found == 1].max() - reach - beyond), 50)
        self.assertTrue((seen(terrain, (0, 0, 2)) == 1).all())

    @needs_gdal
    def test_gdal(self):
        """gdal_viewshed interpolates lines of sight between cells: its verdicts differ where a line
        nearly touches the ground."""
        heights = hills(150, 180, seed=7).astype(numpy.float32)
        path = self.write("dem.tif", heights)
        terrain = relievo.terrain(path)
        row, column = 70, 90
        x, y = places(UTM, *heights.shape)[row, column]
        other = str(self.folder / "gdal.tif")

        def theirs(target_height):
            subprocess.run(["gdal_viewshed", "-q", "-ox", str(x), "-oy", str(y), "-oz", "10", "-tz",
                            str(target_height), "-cc", "0", "-md", "0", path, other],
                           check=True)  # fmt: skip
            return gdal.Open(other).ReadAsArray() == 255

        def ours(target_height):
            return seen(terrain, (x, y, 10), target_height=target_height) == 1

        self.assertTrue(0.1 < ours(0).mean() < 0.9)
        self.assertGreater((theirs(0) == ours(0)).mean(), 0.99)
        # Places that one of them sees, the other sees 20 m higher; the heights span 480 m.
        self.assertTrue((ours(20) | ~theirs(0)).all())
        self.assertTrue((theirs(20) | ~ours(0)).all())
        bent = seen(terrain, (x, y, 10), curvature=0.857) == 1
        self.assertLess((bent & ~ours(0)).sum(), 0.002 * bent.size)

    def test_occluders_and_rays(self):
        """A wall on level ground, as other data; trees from a file."""
        terrain = relievo.terrain(numpy.zeros((5, 60)), (1, 0, -0.5, 0, -1, 4.5))
        wall = vtkPlaneSource()
        wall.SetOrigin(20.5, -9, -1)
        wall.SetPoint1(20.5, 9, -1)
        wall.SetPoint2(20.5, -9, 1)
        found = seen(terrain, (0, 2, 2), occluders=wall)[2]
        along = numpy.arange(60)
        numpy.testing.assert_array_equal(found, ~((along > 20.5) & (along < 41 - 1e-6)))
        wall.Update()
        scene = relievo.rays(terrain.dataset, wall.GetOutput())
        path = str(self.folder / "wall.rays")
        scene.write(path)
        again = relievo.viewshed(relievo.rays(path, terrain.dataset, wall.GetOutput()), (0, 2, 2))
        numpy.testing.assert_array_equal(terrain.rasters(again)["seen"][2], found)
        with self.assertRaisesRegex(ValueError, "[Cc]urvature: got 1"):
            relievo.viewshed(terrain, (0, 2, 2), occluders=wall, curvature=1)


class SparseFiles(Folder):
    def cut(self, shape, block):
        """The blocks as slices of rows and columns."""
        (rows, columns), (height, width) = shape, block
        return [(slice(y, y + height), slice(x, x + width))
                for y in range(0, rows, height) for x in range(0, columns, width)]  # fmt: skip

    def write_sparse(self, values, block, missing, nodata=None, size_of_missing=0):
        """A GeoTIFF by hand, of blocks of (rows, columns), in strips if they are as wide as the
        raster; without the blocks `missing`, slices of the values."""
        kind = values.dtype.newbyteorder("<")
        height, width = block
        tiled = width < values.shape[1]
        data, offsets, sizes = b"", [], []
        for part in self.cut(values.shape, block):
            stored = b""
            if part not in missing:
                cells = values[part]
                if tiled:
                    cells = numpy.pad(cells, [(0, height - cells.shape[0]),
                                              (0, width - cells.shape[1])])  # fmt: skip
                stored = cells.astype(kind).tobytes()
            offsets.append(8 + len(data) if stored else 0)
            sizes.append(len(stored) or size_of_missing)
            data += stored
        rows, columns = values.shape
        bits, form = 8 * kind.itemsize, {"u": 1, "i": 2, "f": 3}[kind.kind]
        tags = {256: ("I", [columns]), 257: ("I", [rows]), 258: ("H", [bits]), 259: ("H", [1]),
                262: ("H", [1]), 277: ("H", [1]), 339: ("H", [form]),
                33550: ("d", [30, 30, 0]), 33922: ("d", [0, 0, 0, 689300, 5337200, 0])}  # fmt: skip
        if tiled:
            tags |= {322: ("I", [width]), 323: ("I", [height])}
            tags |= {324: ("I", offsets), 325: ("I", sizes)}
        else:
            tags |= {273: ("I", offsets), 278: ("I", [height]), 279: ("I", sizes)}
        if nodata is not None:
            tags[42113] = ("s", nodata.encode() + b"\0")
        numbers = {"s": 2, "H": 3, "I": 4, "d": 12}
        begin = 8 + len(data)
        more = begin + 2 + 12 * len(tags) + 4
        entries, tail = struct.pack("<H", len(tags)), b""
        for tag, (letter, held) in sorted(tags.items()):
            content = held if letter == "s" else struct.pack(f"<{len(held)}{letter}", *held)
            place = content.ljust(4, b"\0")
            if len(content) > 4:
                place = struct.pack("<I", more + len(tail))
                tail += content
            entries += struct.pack("<HHI", tag, numbers[letter], len(held)) + place
        path = self.folder / "sparse.tif"
        path.write_bytes(struct.pack("<2sHI", b"II", 42, begin) + data + entries + bytes(4) + tail)
        return path

    def test_missing_blocks(self):
        """Cells of missing blocks have the value of no data, as a sample, or 0 without one."""
        numbers = numpy.round(hills(41, 50) % 100)
        for kind, nodata, filling in (
            ("u1", None, 0), ("i2", "-32768", numpy.nan), ("f4", "-9999.9", numpy.nan),
            ("f8", "nan", numpy.nan), ("f4", "-inf", numpy.nan), ("f4", None, 0),
            ("u1", "-9999", 0), ("u1", "300", 255), ("i2", "nan", 0), ("u2", "7.6", 8),
            ("f8", "-1.79769313486232e+308", numpy.nan),
        ):  # fmt: skip
            for block in ((16, 32), (7, 50)):
                values = numbers.astype(kind)
                missing = self.cut(values.shape, block)[1::2]
                expected = values.astype(float)
                for part in missing:
                    expected[part] = filling
                with self.subTest(kind, nodata=nodata, block=block):
                    path = self.write_sparse(values, block, missing, nodata)
                    numpy.testing.assert_array_equal(relievo.terrain(path).heights, expected)
                    if gdal:
                        file = gdal.Open(str(path))
                        theirs = file.ReadAsArray().astype(float)
                        theirs[theirs == file.GetRasterBand(1).GetNoDataValue()] = numpy.nan
                        numpy.testing.assert_array_equal(theirs, expected)
        damaged = self.write_sparse(values, block, missing, size_of_missing=9)
        with self.assertRaisesRegex(ValueError, "it is damaged"):
            relievo.terrain(damaged)


@needs_gdal
class Files(Folder):
    def test_reads_files_of_gdal(self):
        heights = numpy.round(hills(70, 90, seed=3))
        kinds = ((gdal.GDT_Byte, numpy.uint8), (gdal.GDT_Int16, numpy.int16),
                 (gdal.GDT_UInt16, numpy.uint16), (gdal.GDT_Int32, numpy.int32),
                 (gdal.GDT_Float32, numpy.float32), (gdal.GDT_Float64, numpy.float64))  # fmt: skip
        forms = ((), ("TILED=YES", "BLOCKXSIZE=32", "BLOCKYSIZE=16", "COMPRESS=DEFLATE"),
                 ("COMPRESS=LZW", "BIGTIFF=YES"), ("COMPRESS=DEFLATE", "PREDICTOR=2"),
                 ("INTERLEAVE=PIXEL",), ("ENDIANNESS=BIG",))  # fmt: skip
        turned = (24.5, 11.0, 689300.25, -13.0, -20.0, 5337200.125)
        for i, (kind, numbers) in enumerate(kinds):
            for form in forms:
                if "PREDICTOR=2" in form and kind in (gdal.GDT_Float32, gdal.GDT_Float64):
                    form = ("COMPRESS=DEFLATE", "PREDICTOR=3")
                values = (heights % 200 + 0.37 * (i > 3)).astype(numbers)
                values[3, 4] = values[50, 89] = 7
                transform = turned if form == forms[1] else UTM
                bands = numpy.stack([values, 0 * values], -1) if form == forms[4] else values
                path = self.write("a.tif", bands, transform, kind, 7, options=form)
                terrain = relievo.terrain(path)
                expected = values.astype(float)
                expected[values == 7] = numpy.nan
                numpy.testing.assert_array_equal(terrain.heights, expected)
                numpy.testing.assert_allclose(terrain.transform, transform, rtol=1e-15)
                points = vtk_to_numpy(terrain.dataset.GetPoints().GetData())[:, :2]
                numpy.testing.assert_allclose(
                    points, places(transform, 70, 90)[values != 7], rtol=1e-15)

    def test_centres_of_pixels(self):
        """Files that place the centres of their cells, and values that stand for no data."""
        heights = hills(20, 30).astype(numpy.float32)
        path = self.write("a.tif", heights, options=("GEOTIFF_VERSION=1.1",))
        gdal.Translate(str(self.folder / "b.tif"), path, metadataOptions=["AREA_OR_POINT=Point"])
        b = relievo.terrain(self.folder / "b.tif")
        a, b_, c, d, e, f = b.transform
        at = gdal.Open(str(self.folder / "b.tif")).GetGeoTransform()
        numpy.testing.assert_allclose((c, a, b_, f, d, e), at, rtol=1e-15)
        heights[2, 3], heights[4, 5], heights[6, 7] = -9999.9, numpy.nan, -3.4028e38
        path = self.write("c.tif", heights, nodata=-9999.9)
        for terrain in (relievo.terrain(path), relievo.terrain(heights, UTM, -9999.9)):
            self.assertEqual(numpy.isnan(terrain.heights).sum(), 3)
        masked = numpy.ma.masked_less(heights.astype("f8"), 0)
        self.assertEqual(numpy.isnan(relievo.terrain(masked, UTM).heights).sum(), 3)

    def test_gdal_reads_our_files(self):
        heights = hills(40, 50, seed=5)
        heights[10:14, 20:22] = -32768
        path = self.write("a.tif", heights, kind=gdal.GDT_Int16, nodata=-32768)
        terrain = relievo.terrain(path)
        lots = numpy.random.default_rng(2)
        turned = (24.5, 11.0, 689300.25, -13.0, -20.0, 5337200.125)
        sheared = relievo.terrain(heights, turned, -32768)
        whole = lots.integers(-5, 9, heights.shape)
        single = lots.random(heights.shape, numpy.float32)
        double = lots.random(heights.shape)
        out = str(self.folder / "out.tif")
        there = heights != -32768
        for of, rasters, kind in ((terrain, {"seen": whole}, gdal.GDT_Int32),
                                  (terrain, {"a": single, "b<&": whole}, gdal.GDT_Float32),
                                  (sheared, {"a": double, "b": single}, gdal.GDT_Float64)):
            of.write(out, rasters)
            file = gdal.Open(out)
            c, a, b, f, d, e = file.GetGeoTransform()
            self.assertEqual((a, b, c, d, e, f), of.transform)
            self.assertEqual(file.RasterCount, len(rasters))
            for i, (name, values) in enumerate(rasters.items()):
                band = file.GetRasterBand(i + 1)
                self.assertEqual((band.GetDescription(), band.GetNoDataValue(), band.DataType),
                                 (name, -9999, kind))
                numpy.testing.assert_array_equal(band.ReadAsArray(),
                                                 numpy.where(there, values, -9999))  # fmt: skip
            if of is terrain:
                self.assertTrue(file.GetSpatialRef().IsSame(gdal.Open(path).GetSpatialRef()))
            again = relievo.terrain(out)
            self.assertEqual(again.transform, of.transform)
            numpy.testing.assert_array_equal(numpy.isnan(again.heights), ~there)

    def test_kinds_of_numbers(self):
        """Integers of all kinds, large ones, masked arrays, and arrays of the caller's."""
        heights = hills(6, 7)
        heights[2, 3] = numpy.nan
        terrain = relievo.terrain(heights, UTM)
        there = numpy.isfinite(heights)
        values = numpy.arange(42).reshape(6, 7)
        out = str(self.folder / "out.tif")
        terrain.dataset.GetPointData().AddArray(numpy_to_vtk(values[there].astype(float), deep=1))
        terrain.dataset.GetPointData().GetArray(1).SetName("mine")

        def write(raster):
            terrain.write(out, {"a": raster})
            file = gdal.Open(out)
            self.assertEqual(file.RasterCount, 1)
            return file.GetRasterBand(1).DataType, file.ReadAsArray()

        for kind in ("?", "i1", "u1", "u2", "i4", ">i4", "u4", "i8"):
            with self.subTest(kind):
                raster = values.astype(kind)
                of, found = write(raster)
                self.assertEqual(of, gdal.GDT_Int32)
                numpy.testing.assert_array_equal(found, numpy.where(there, raster, -9999.0))
                masked = numpy.ma.masked_array(raster, values % 5 == 0)
                numpy.testing.assert_array_equal(
                    write(masked)[1], numpy.where(there & (values % 5 != 0), raster, -9999.0))
        for kind, most in (("u4", 2**32 - 1), ("i8", 2**40), ("u8", 2**40)):
            raster = values.astype(kind)
            raster[0, 0] = most
            of, found = write(raster)
            self.assertEqual((of, found[0, 0], found[2, 3]), (gdal.GDT_Float64, most, -9999))
        for most, kind in ((2**24 - 1, gdal.GDT_Float32), (2**24 + 1, gdal.GDT_Float64)):
            large = numpy.full(values.shape, most, "i4")
            terrain.write(out, {"a": large, "b": values.astype("f4")})
            file = gdal.Open(out)
            self.assertEqual((file.GetRasterBand(1).DataType, file.ReadAsArray()[0, 0, 0]),
                             (kind, most))  # fmt: skip
        mesh = vtkPolyData()
        mesh.ShallowCopy(terrain.dataset)
        for kind in ("u1", "i1", "u2"):
            array = numpy_to_vtk(values[there].astype(kind), deep=1)
            array.SetName("a")
            mesh.GetPointData().AddArray(array)
            numpy.testing.assert_array_equal(terrain.rasters(mesh)["a"],
                                             numpy.where(there, values, -9999))  # fmt: skip

    def test_refused(self):
        heights = hills(9, 9).astype(numpy.float32)
        bare = self.write("bare.tif", heights, transform=None, epsg=None)
        degrees = self.write("degrees.tif", heights, (0.01, 0, 11, 0, -0.01, 48), epsg=4326)
        row = self.write("row.tif", heights[:1])
        holes = self.write("holes.tif", heights * 0 + 3, nodata=3)
        colors = self.write("colors.tif", numpy.zeros((9, 9, 3)), kind=gdal.GDT_Byte,
                            options=("PHOTOMETRIC=RGB",))
        scaled = self.write("scaled.tif", heights)
        file = gdal.Open(scaled, gdal.GA_Update)
        file.GetRasterBand(1).SetScale(0.1)
        del file
        second = self.write("second.tif", numpy.stack([heights, heights], axis=-1))
        file = gdal.Open(second, gdal.GA_Update)
        file.GetRasterBand(2).SetOffset(7)
        del file
        numpy.testing.assert_array_equal(relievo.terrain(second).heights, heights)
        (self.folder / "text.tif").write_text("no TIFF")
        terrain = relievo.terrain(heights, UTM)
        level = relievo.terrain(numpy.zeros((4, 4)), (1, 0, 0, 0, -1, 4))
        for text, call in (
            ("does not say where its cells are", lambda: relievo.terrain(bare)),
            ("are degrees", lambda: relievo.terrain(degrees)),
            ("has 1 rows and 9 columns", lambda: relievo.terrain(row)),
            ("no three neighbouring cells", lambda: relievo.terrain(holes)),
            ("a picture", lambda: relievo.terrain(colors)),
            ("scale or an offset", lambda: relievo.terrain(scaled)),
            ("expected a GeoTIFF", lambda: relievo.terrain(self.folder / "text.tif")),
            ("transform: got None", lambda: relievo.terrain(heights)),
            ("transform: got", lambda: relievo.terrain(heights, (1, 2, 3))),
            ("its cells an area", lambda: relievo.terrain(heights, (1, 2, 3, 2, 4, 5))),
            ("heights: got an array of shape", lambda: relievo.terrain(heights[0], UTM)),
            ("beside a file", lambda: relievo.terrain(row, UTM)),
            ("transform: got 10", lambda: relievo.terrain(heights, 10)),
            ("transform: got 'abcdef'", lambda: relievo.terrain(heights, "abcdef")),
            ("observers: got \\[{'x': 1}]", lambda: relievo.viewshed(terrain, [{"x": 1}])),
            ("observers: got 'a'", lambda: relievo.viewshed(terrain, "a")),
            ("observers: got", lambda: relievo.viewshed(terrain, (1, 2))),
            ("observers: got", lambda: relievo.viewshed(terrain, (1, 2, -1))),
            ("is not above the mesh", lambda: relievo.viewshed(level, (0.2, 2, 1))),
            ("target_height: got", lambda: relievo.viewshed(level, (2, 2, 1), target_height=-1)),
            ("has no points", lambda: relievo.viewshed(vtkPolyData(), (2, 2, 1))),
            ("has no points", lambda: relievo.viewshed(vtkPolyData(), (2, 2, 1), curvature=1)),
            ("mesh: got 16 values", lambda: terrain.rasters(level)),
            ("rasters: got an array of shape", lambda: terrain.write("a.tif", {"a": heights[1:]})),
            ("rasters: got none", lambda: terrain.write("a.tif", {})),
            ("rasters: got the name 'raster_cell'",
             lambda: terrain.write("a.tif", {"raster_cell": heights})),
        ):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaises(FileNotFoundError):
            relievo.terrain(self.folder / "missing.tif")
        with self.assertRaises(OSError):
            terrain.write(self.folder / "missing" / "a.tif", {"a": heights})

    @unittest.skipUnless(sys.platform == "linux", "RLIMIT_AS")
    def test_lack_of_memory(self):
        """A mesh, and its tree, are refused before they are made where they do not fit."""
        level = numpy.zeros((600, 600))
        terrain = relievo.terrain(level, UTM)
        before = resource.getrlimit(resource.RLIMIT_AS)
        for mebibytes, call in (
            (24, lambda: relievo.terrain(level, UTM)),  # 80 bytes for each cell
            (30, lambda: relievo.viewshed(terrain, (UTM[2] + 15, UTM[5] - 15, 1))),  # 114
        ):
            pages = int(pathlib.Path("/proc/self/statm").read_text().split()[0])
            taken = pages * resource.getpagesize()
            resource.setrlimit(resource.RLIMIT_AS, (taken + (mebibytes << 20), before[1]))
            try:
                with self.assertRaisesRegex(MemoryError, r"would take \d+ bytes .* has \d+ bytes"):
                    call()
            finally:
                resource.setrlimit(resource.RLIMIT_AS, before)

    @unittest.skipUnless(sys.platform == "linux", "RLIMIT_AS")
    def test_lack_of_memory_for_file(self):
        """A file that does not fit is refused with its size."""
        path = self.write("large.tif", hills(30, 40).astype(numpy.float32))
        os.truncate(path, 400 << 20)  # a hole
        before = resource.getrlimit(resource.RLIMIT_AS)
        pages = int(pathlib.Path("/proc/self/statm").read_text().split()[0])
        taken = pages * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (taken + (100 << 20), before[1]))
        try:
            with self.assertRaisesRegex(MemoryError, "take at least 419430400 bytes, and memory"):
                relievo.terrain(path)
        finally:
            resource.setrlimit(resource.RLIMIT_AS, before)

    def test_damaged(self):
        """Cut files, and files with changed bytes, are read or refused."""
        heights = hills(30, 40).astype(numpy.float32)
        path = self.write("a.tif", heights, options=("COMPRESS=DEFLATE",))
        good = pathlib.Path(path).read_bytes()
        draw = random.Random(8)
        refused = 0
        for i in range(200):
            damaged = bytearray(good)
            if i % 2:
                del damaged[draw.randrange(len(damaged)):]
            else:
                for _ in range(3):
                    # Tags are at the start and the end of the file.
                    at = draw.randrange(600) if i % 4 else draw.randrange(len(damaged))
                    damaged[at] = draw.randrange(256)
            pathlib.Path(path).write_bytes(damaged)
            try:
                relievo.terrain(path)
            except ValueError:
                refused += 1
        self.assertGreater(refused, 100)


class Sun(Folder):
    def test_rasters(self):
        """Level ground has all the hours of the day, and a cell without a height none; a wall along
        the east hides the sun below its angle."""
        heights = numpy.zeros((41, 41))
        heights[5, 6] = numpy.nan
        terrain = relievo.terrain(heights, (10, 0, 500000, 0, -10, 5300000))
        mesh = relievo.sun_exposure(terrain, 48, 11, "2026-03-20", points=True, up="z", step=5)
        possible = mesh.GetFieldData().GetArray("possible_hours").GetValue(0)
        hours = terrain.rasters(mesh)["sun_hours"]
        self.assertEqual(hours[5, 6], terrain.nodata)
        numpy.testing.assert_allclose(hours[numpy.isfinite(heights)], possible, atol=1e-3)
        # The default of `up` is z.
        summer = [relievo.sun_exposure(thing, 48, 11, "2026-06-21", points=True, step=15, **up)
                  for thing, up in ((terrain, {"up": "z"}), (terrain, {"up": "y"}), (terrain, {}),
                                    (relievo.rays(terrain.dataset), {}))]  # fmt: skip
        along_z, along_y, *defaults = (terrain.rasters(each)["sun_hours"] for each in summer)
        self.assertGreater(along_z[0, 0], along_y[0, 0] + 2)
        for found in defaults:
            numpy.testing.assert_array_equal(found, along_z)
        # At an equinox the sun rises in the east, along the ground's parallel.
        heights[:, 40] = 400
        walled = relievo.terrain(heights, terrain.transform)
        hours = walled.rasters(relievo.sun_exposure(
            walled, 0, 0, "2026-03-20", points=True, up="z", step=5))["sun_hours"][20]
        # At the equator it climbs vertically, 15 degrees an hour.
        along = 10.0 * (39 - numpy.arange(40))
        foot = along[:-1] + 10
        hidden = numpy.degrees(numpy.arctan2(400, foot)) / 15
        numpy.testing.assert_allclose(hours[:39], 12.1 - hidden, atol=0.25)


if __name__ == "__main__":
    unittest.main()
