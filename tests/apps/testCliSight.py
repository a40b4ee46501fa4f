# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo visible and relievo sun: scenes whose answer is known, their options, words refused."""

import csv
import json
import math
import random
import shutil
import unittest

import numpy
from cli import CliTest, main
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
)

try:
    from osgeo import gdal, osr
except ImportError:
    gdal = None

# Level ground of two cells in y = 0, seen from y > 0, and a roof over the one with x < 0.
GROUND = "OFF\n6 2 0\n-2 0 -1\n-2 0 1\n0 0 1\n0 0 -1\n2 0 1\n2 0 -1\n4 0 1 2 3\n4 3 2 4 5\n"
ROOF = "OFF\n4 1 0\n-99 0.01 -99\n-99 0.01 99\n0 0.01 99\n0 0.01 -99\n4 0 1 2 3\n"
SUN = ["--place", "40,10", "--dates", "2026-03-20"]


class Sight(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "ground.off").write_text(GROUND)
        (self.folder / "roof.off").write_text(ROOF)
        above = {"position": [0, 10, 0.001], "target": [0, 0, 0]}
        (self.folder / "above.json").write_text(json.dumps([above]))
        self.before = self.names()

    def read(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def cells(self, name, array):
        return vtk_to_numpy(self.read(name).GetCellData().GetArray(array))

    def sun(self, *words):
        return self.relievo("sun", "ground.off", *words, "-o", "sun.vtp")

    def test_sun(self):
        done = self.sun(*SUN, "roof.off", "--step", "10", "--up", "y")
        self.assertEqual(done.stderr, "")
        open_ground = self.cells("sun.vtp", "sun_hours")[1]
        self.assertAlmostEqual(open_ground, 12, delta=0.2)  # of an equinox
        # Below the roof, but for a sun below 0.57 degrees, which rises by 11.5 degrees an hour.
        self.assertLess(self.cells("sun.vtp", "sun_hours")[0], 0.06)
        self.assertIn(f"{open_ground / 2:.1f} hours of sun in the mean of 2 cells", done.stdout)
        # The mean over the day of the sine of the height, by its closed form at an equinox.
        self.assertAlmostEqual(self.cells("sun.vtp", "insolation")[1],
                               24 / math.pi * math.cos(math.radians(40)), delta=0.1)  # fmt: skip
        self.assertEqual(self.names(), sorted([*self.before, "sun.vtp"]))
        # Readable beside every expat, by any VTK.
        self.assertNotIn(b"<AppendedData", (self.folder / "sun.vtp").read_bytes())

    def test_rays(self):
        """A file of trees is written by the first run, and used by others, of these meshes."""
        self.sun(*SUN, "roof.off", "--up", "y", "--step", "60")
        plain = (self.folder / "sun.vtp").read_bytes()
        for _ in range(2):
            self.sun(*SUN, "roof.off", "--up", "y", "--step", "60", "--rays", "town.rays")
            self.assertEqual((self.folder / "sun.vtp").read_bytes(), plain)
        done = self.relievo("sun", "ground.off", *SUN, "--rays", "town.rays", "-o", "a.vtp",
                            status=1)  # fmt: skip
        self.assertIn("--rays: ", done.stderr)

    def test_parts(self):
        """Joined parts are the file of one process, for a drawn number of parts in drawn orders."""
        draw = random.Random(45)
        grid = 9
        points = [f"{i % grid} {i * 7 % 4 / 4} {i // grid}" for i in range(grid * grid)]
        quads = [f"4 {i} {i + grid} {i + grid + 1} {i + 1}" for i in range(grid * (grid - 1))
                 if i % grid < grid - 1]  # fmt: skip
        (self.folder / "hills.off").write_text(
            "\n".join(["OFF", f"{len(points)} {len(quads)} 0", *points, *quads, ""]))
        works = (
            ["sun", "hills.off", *SUN, "--up", "y", "--step", "60", "--sky", "4"],
            ["sun", "hills.off", *SUN, "--up", "y", "--step", "60", "--irradiance", "perez"],
            ["sun", "hills.off", *SUN, "--up", "y", "--step", "60", "--points"],
            ["visible", "hills.off", "--poses", "random:3", "--size", "12x9"],
        )
        for work, count in zip(works, (draw.randint(2, 5), 3, draw.randint(2, 17), 3)):
            with self.subTest(work, count=count):
                self.relievo(*work, "-o", "whole.vtp")
                folder = self.folder / "shared.vtp.parts"
                parts = draw.sample(range(1, count + 1), count)
                self.kill(folder.exists, draw.uniform(0, 0.02), *work, "-o", "shared.vtp", "--part",
                          f"{parts[0]}/{count}")  # fmt: skip
                for part in parts:  # every other without the units that libraries choose
                    units = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F"}
                    self.relievo(*work, "-o", "shared.vtp", "--part", f"{part}/{count}",
                                 environment=units if part % 2 else {})  # fmt: skip
                self.assertIn("shared.vtp is missing", self.verify(folder.name))
                damaged = folder / f"part-{draw.randint(1, count):06d}.bin"
                values = damaged.read_bytes()
                damaged.write_bytes(values[:-1] + bytes([values[-1] ^ 1]))
                self.assertIn(f"1 damaged: {int(damaged.stem[5:])} ({damaged.name})",
                              self.verify(folder.name))  # fmt: skip
                self.relievo("merge", folder.name, status=1)
                self.assertFalse((self.folder / "shared.vtp").exists())
                again = ["-o", "shared.vtp", "--part", f"{int(damaged.stem[5:])}/{count}"]
                self.assertIn("written", self.relievo(*work, *again).stdout)
                self.assertIn("is complete", self.relievo(*work, *again).stdout)
                self.relievo("merge", f"{folder.name}/")
                self.assertEqual((self.folder / "shared.vtp").read_bytes(),
                                 (self.folder / "whole.vtp").read_bytes())  # fmt: skip
                self.relievo("verify", folder.name)
                other = self.relievo(*work, "-o", "shared.vtp", "--part", f"1/{count + 1}",
                                     status=2)  # fmt: skip
                self.assertIn(f"was begun with parts {count}", other.stderr)
                other = self.relievo(*work, "roof.off", "-o", "shared.vtp", "--part", f"1/{count}",
                                     status=2)  # fmt: skip
                self.assertIn("was begun with meshes", other.stderr)
                shutil.rmtree(folder)
                (self.folder / "shared.vtp").unlink()

    @unittest.skipUnless(gdal, "no GDAL: packages.txt, [tests]")
    def test_terrain(self):
        """A level terrain with a wall of three rows in the west and a hole: rasters on its grid,
        whole and in parts; refusals."""
        gdal.UseExceptions()
        file = gdal.GetDriverByName("GTiff").Create(
            str(self.folder / "dem.tif"), 50, 30, 1, gdal.GDT_Int16)
        file.SetGeoTransform((689000, 10, 0, 5337000, 0, -10))
        system = osr.SpatialReference()
        system.ImportFromEPSG(32632)
        file.SetProjection(system.ExportToWkt())
        heights = numpy.zeros((30, 50))
        heights[:, 20] = 8
        heights[3, 30] = -32768
        file.GetRasterBand(1).WriteArray(heights)
        file.GetRasterBand(1).SetNoDataValue(-32768)
        del file
        view = ["viewshed", "dem.tif", "--observer", "689005,5336845,10"]
        expected = numpy.ones((30, 50), int)
        # Behind a ridge of 8 at a distance of 200, an eye at 10 sees ground from 1000.
        expected[:, 21:] = 0
        expected[3, 30] = -9999
        done = self.relievo(*view, "-o", "seen.tif")
        self.assertEqual(done.stderr, "")
        self.assertIn("630 of 1499 points are seen by 1 observer", done.stdout)
        seen = gdal.Open(str(self.folder / "seen.tif"))
        numpy.testing.assert_array_equal(seen.ReadAsArray(), expected)
        self.assertEqual(seen.GetGeoTransform(), (689000, 10, 0, 5337000, 0, -10))
        self.assertTrue(seen.GetSpatialRef().IsSame(system))
        self.assertEqual(seen.GetRasterBand(1).GetDescription(), "seen")
        self.relievo(*view, "-o", "seen.vtp")
        values = vtk_to_numpy(self.read("seen.vtp").GetPointData().GetArray("seen"))
        numpy.testing.assert_array_equal(values, expected[expected >= 0])
        sun = ["sun", "dem.tif", *SUN, "--step", "60"]
        self.relievo(*sun, "-o", "sun.tif")
        hours = gdal.Open(str(self.folder / "sun.tif"))
        names = [hours.GetRasterBand(1 + i).GetDescription() for i in range(hours.RasterCount)]
        self.assertEqual(names, ["sun_hours", "insolation"])
        self.assertAlmostEqual(hours.GetRasterBand(1).ReadAsArray()[15, 45], 12, delta=0.2)
        self.assertLess(hours.GetRasterBand(1).ReadAsArray()[15, 21], 11)
        for work, name in ((view, "seen.tif"), (sun, "sun.tif")):
            for part in (2, 1, 3):
                self.relievo(*work, "-o", "shared.tif", "--part", f"{part}/3")
            self.relievo("merge", "shared.tif.parts")
            self.assertEqual((self.folder / "shared.tif").read_bytes(),
                             (self.folder / name).read_bytes())  # fmt: skip
            shutil.rmtree(self.folder / "shared.tif.parts")
        # Level ground has z up, too.
        file = gdal.GetDriverByName("GTiff").CreateCopy(
            str(self.folder / "level.tif"), gdal.Open(str(self.folder / "dem.tif")))
        file.GetRasterBand(1).Fill(0)
        del file
        for words, name in (([], "a.tif"), (["--up", "z"], "b.tif")):
            self.relievo("sun", "level.tif", *SUN, "--step", "60", *words, "-o", name)
        self.assertEqual((self.folder / "a.tif").read_bytes(),
                         (self.folder / "b.tif").read_bytes())  # fmt: skip
        self.assertAlmostEqual(gdal.Open(str(self.folder / "a.tif")).ReadAsArray()[0, 0, 0], 12,
                               delta=0.2)  # fmt: skip
        (self.folder / "a.tif").unlink()
        # A mesh that has only a part of a raster's arrays.
        mesh = self.read("seen.vtp")
        mesh.GetPointData().RemoveArray("raster_cell")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.folder / "half.vtp"))
        writer.SetInputData(mesh)
        writer.Write()
        here = ["--observer", "0,0,2", "-o", "a.tif"]
        for words, status, text in (
            (["ground.off", *here], 2, "the mesh is no raster; expected a GeoTIFF"),
            (["half.vtp", *here], 2, "the mesh is no raster; expected a GeoTIFF"),
            (["dem.tif", *here], 1, "is not above the mesh"),
            (["dem.tif", "--observer", "0,0", "-o", "a.tif"], 2, "X,Y,HEIGHT"),
            (["dem.tif", "--observer", "0,0,-1", "-o", "a.tif"], 2, "a height above the ground"),
            (["dem.tif", *here[:2], "-o", "a.png"], 2, "ends in .tif or .vtp"),
        ):
            with self.subTest(words):
                self.assertIn(text, self.relievo("viewshed", *words, status=status).stderr)
        self.assertFalse((self.folder / "a.tif").exists())

    def verify(self, folder):
        return self.relievo("verify", folder, status=3).stdout

    def test_a_job_array(self):
        for task in (10, 14, 12):  # parts 1, 3, 2
            self.relievo("sun", "ground.off", *SUN, "-o", "sun.vtp", "--part", "slurm",
                         environment=self.array(task, 3))  # fmt: skip
        done = self.relievo("sun", "ground.off", *SUN, "-o", "sun.vtp", "--part", "slurm",
                            environment=self.array(14, 2), status=2)  # fmt: skip
        self.assertIn("the array has gaps", done.stderr)
        said = self.relievo("status", "sun.vtp.parts").stdout
        self.assertIn("part 3 of 3: 100 of 100 %, done", said)
        self.relievo("merge", "sun.vtp.parts")
        self.assertFalse((self.folder / "sun.vtp.parts" / "progress").exists())

    def array(self, task, count):
        """The variables of a job array of the tasks 10, 12 and 14, of which `count` are there."""
        array = {"ID": task, "MIN": 10, "MAX": 14, "STEP": 2, "COUNT": count}
        return {f"SLURM_ARRAY_TASK_{name}": str(value) for name, value in array.items()}

    def test_folders_of_parts(self):
        """Names of folders that are no FILE.parts; parts of a folder that was begun anew."""
        day = ["sun", "ground.off", *SUN[:3]]
        self.relievo(*day, "2026-03-20", "-o", "sun.vtp", "--part", "1/1")
        folder = self.folder / "sun.vtp.parts"
        self.relievo("merge", "sun.vtp.parts/.")
        before = (self.folder / "sun.vtp").read_bytes()
        shutil.copytree(folder, self.folder / "sun.vtp.copies")
        done = self.relievo("merge", "sun.vtp.copies", status=2)
        self.assertIn("expected a folder FILE.parts", done.stderr)
        self.assertEqual((self.folder / "sun.vtp").read_bytes(), before)
        record = (folder / "part-000001.json").read_bytes()
        for path in folder.iterdir():
            if path.name != "parts.json":
                path.unlink()
        self.relievo(*day, "2026-06-21", "-o", "sun.vtp", "--part", "1/1")
        (folder / "part-000001.json").write_bytes(record)  # of the other day
        said = self.relievo("status", "sun.vtp.parts").stdout
        self.assertIn("1 of another version or other settings: 1", said)

    def test_candidates_of_blocks(self):
        """The points of all blocks are candidates."""
        blocks = vtkMultiBlockDataSet()
        for number, x in enumerate((-1, 1)):
            points = vtkPoints()
            points.InsertNextPoint(x, 1, 0)
            data = vtkPolyData()
            data.SetPoints(points)
            data.SetVerts(vtkCellArray())
            data.GetVerts().InsertNextCell(1, [0])
            blocks.SetBlock(number, data)
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetFileName(str(self.folder / "masts.vtm"))
        writer.SetInputData(blocks)
        writer.SetDataModeToAscii()
        writer.Write()
        self.relievo("cover", "ground.off", "--candidates", "masts.vtm", "--places", "2",
                     "--largest-angle", "50", "-o", "covered.vtp",
                     "--chosen", "chosen.vtp")  # fmt: skip
        self.assertEqual(self.cells("covered.vtp", "covered").tolist(), [1, 1])
        self.assertEqual(self.read("chosen.vtp").GetNumberOfPoints(), 2)

    def test_view_factors(self):
        """Parallel squares as two files, as parts of one and by an array; a screen; files."""
        low = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"
        high = "OFF\n4 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 3 2 1 0\n"  # faces down
        # Two triangles that share places, not points, and the lower square.
        both = ("OFF\n10 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 1 1\n1 0 1\n0 0 1\n"
                "0 1 1\n1 1 1\n4 0 1 2 3\n3 4 5 6\n3 7 8 9\n")
        screen = "OFF\n4 1 0\n-9 -9 0.5\n9 -9 0.5\n9 9 0.5\n-9 9 0.5\n4 0 1 2 3\n"
        for name, text in (("low,1.off", low), ("high.off", high), ("both.off", both),
                           ("screen.off", screen)):  # fmt: skip
            (self.folder / name).write_text(text)
        # Blocks, one of which has no points.
        (self.folder / "empty.vtp").write_text(
            '<VTKFile type="PolyData" version="1.0"><PolyData><Piece NumberOfPoints="0"><Points>'
            '<DataArray type="Float32" NumberOfComponents="3" format="ascii"/></Points></Piece>'
            "</PolyData></VTKFile>")  # fmt: skip
        (self.folder / "blocks.vtm").write_text(
            '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
            '<DataSet index="0" file="empty.vtp"/><DataSet index="1" file="zones.vtp"/>'
            "</vtkMultiBlockDataSet></VTKFile>")
        root = math.sqrt(2)
        truth = 2 / math.pi * (
            math.log(2 / math.sqrt(3)) + 2 * root * math.atan(1 / root) - math.pi / 2)

        def factors(*words):
            done = self.relievo("view-factors", *words, "-o", "f.csv", "--json", "f.json",
                                "--mesh", "f.vtp")  # fmt: skip
            self.assertIn("2 groups", done.stdout)
            with open(self.folder / "f.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            found = json.loads((self.folder / "f.json").read_text())
            names = [group["name"] for group in found["groups"]]
            self.assertEqual([group["area"] for group in found["groups"]], [1, 1])
            for row in rows:
                i, to = names.index(row["from"]), row["to"]
                matrix = found["factors"][i][names.index(to)] if to in names else found[to][i]
                self.assertAlmostEqual(float(row["factor"]), matrix, places=8)
            for i in (0, 1):
                whole = sum(found["factors"][i]) + found["nothing"][i] + found["others"][i]
                self.assertAlmostEqual(whole, 1)
            # The mesh: a component for each group.
            group = self.cells("f.vtp", "group").astype(int)
            self.assertEqual(set(group[group >= 0]), {0, 1})
            for name in ("factors", "bounds"):
                rows = numpy.array([*found[name], [0, 0]])[group]  # the last: no group
                numpy.testing.assert_array_equal(self.cells("f.vtp", name), rows)
            shutil.copy(self.folder / "f.vtp", self.folder / "zones.vtp")
            return names, found

        for words, expected in (
            (["low,1.off", "high.off"], ["low,1.off", "high.off"]),
            (["both.off", "--groups", "parts"], ["0", "1"]),
            (["zones.vtp", "--groups", "array:group"], ["0", "1"]),
            (["blocks.vtm", "--groups", "parts"], ["0", "1"]),
        ):
            names, found = factors(*words, "--tolerance", "0.01")
            self.assertEqual(names, expected)
            for factor, bound in ((found["factors"][i][1 - i], found["bounds"][i][1 - i])
                                  for i in (0, 1)):  # fmt: skip
                self.assertLess(abs(factor - truth), bound)
                self.assertLessEqual(bound, 0.01)
        _, found = factors("low,1.off", "high.off", "--occluder", "screen.off")
        self.assertGreater(min(found["others"]), 0.98)
        # A file without the array has no group.
        _, found = factors("zones.vtp", "screen.off", "--groups", "array:group")
        self.assertGreater(min(found["others"]), 0.98)

    def test_view_factors_refused(self):
        writes = ("-o", "f.csv")
        for words, status, said in (
            (["ground.off", *writes, "--groups", "zone"], 2, "expected files, parts or array:NAME"),
            (["ground.off", *writes, "--groups", "array:zone"], 1, "no file has such a cell array"),
            (["ground.off", "-o", "f.vtp"], 2, "a name that ends in .csv"),
            (["ground.off", *writes, "--tolerance", "0"], 2, "--tolerance: got '0'"),
            (["ground.off", *writes, "--occluder", "none.off"], 1, "none.off"),
        ):
            self.refused("view-factors", *words, status=status, says=said)
        self.assertEqual(self.names(), self.before)

    def test_sun_options(self):
        self.sun(*SUN, "--up=y")
        day = self.cells("sun.vtp", "sun_hours")
        self.sun("--place", "40,10", "--dates", "2026-03-20:2026-03-22", "--up", "y")
        numpy.testing.assert_allclose(self.cells("sun.vtp", "sun_hours"), 3 * day, rtol=0.03)
        # Each computed day counts for three.
        self.sun("--place", "40,10", "--dates", "2026-03-20:2026-03-22:3", "--up", "y")
        numpy.testing.assert_allclose(self.cells("sun.vtp", "sun_hours"), 3 * day, rtol=0.03)
        # Beyond the polar circle at midsummer, and midwinter.
        self.sun("--place", "80,10", "--dates", "2026-06-21", "--up", "y")
        numpy.testing.assert_allclose(self.cells("sun.vtp", "sun_hours"), 24, rtol=1e-6)
        self.sun("--place", "80,10", "--dates", "2026-12-21", "--up", "y")
        numpy.testing.assert_array_equal(self.cells("sun.vtp", "sun_hours"), 0)
        # With z up the ground is a wall that faces north, where the sun never is.
        self.sun("--place", "40,10", "--dates", "2026-12-21", "--up", "z")
        numpy.testing.assert_array_equal(self.cells("sun.vtp", "sun_hours"), 0)
        self.sun(*SUN, "--points", "--sky", "64", "--up", "y")
        points = self.read("sun.vtp").GetPointData()
        numpy.testing.assert_allclose(vtk_to_numpy(points.GetArray("sky_view")), 1, atol=1e-6)
        self.assertEqual(points.GetArray("sun_hours").GetNumberOfTuples(), 6)

    def test_disk_full(self):
        """One line says so, and nothing is left; a limit on the size of files does so too."""
        full = ["/bin/bash", "-c", 'ulimit -f 1 && exec "$0" "$@"']
        for words in (["visible", "ground.off", "--poses", "above.json"],
                      ["sun", "ground.off", *SUN]):
            with self.subTest(words=words):
                self.refused(*words, "-o", "a.vtp", status=1, says=["-o a.vtp", "too large"],
                             wrapper=full)  # fmt: skip

    @unittest.skipUnless(gdal, "no GDAL: packages.txt, [tests]")
    def test_disk_full_raster(self):
        file = gdal.GetDriverByName("GTiff").Create(
            str(self.folder / "dem.tif"), 60, 60, 1, gdal.GDT_Float64)
        file.SetGeoTransform((0, 10, 0, 0, 0, -10))
        file.GetRasterBand(1).WriteArray(numpy.random.default_rng(1).random((60, 60)))
        del file
        self.before = self.names()
        view = ["viewshed", "dem.tif", "--observer", "300,-300,1", "-o", "a.tif"]
        full = ["/bin/bash", "-c", 'ulimit -f 0 && exec "$0" "$@"']
        done = self.refused(*view, status=1, says=["-o a.tif: a.tif: ", "too large"], wrapper=full)
        self.assertNotIn(".relievo-", done.stderr)

    def test_visible(self):
        look = ["--poses", "above.json", "--size", "200x100", "--view-angle", "20"]
        done = self.relievo("visible", "ground.off", *look, "-o", "seen.vtp")
        self.assertEqual(done.stderr, "")
        self.assertIn("2 of 2 cells are seen by 1 camera\n", done.stdout)
        # The height of 100 spans 20 degrees 10 away: 2 by 2 units by hand.
        a_unit = 50 / (10 * math.tan(math.radians(10)))
        numpy.testing.assert_allclose(
            self.cells("seen.vtp", "pixels"), (2 * a_unit) ** 2, rtol=0.05)
        numpy.testing.assert_array_equal(self.cells("seen.vtp", "seen"), 1)
        # A rectangle right below, 2 by 2 and to one side: its solid angle in closed form.
        expected = 2 * math.atan(2 * 1 / (10 * math.sqrt(10**2 + 2**2 + 1**2)))
        numpy.testing.assert_allclose(
            self.cells("seen.vtp", "solid_angle"), expected, rtol=0.02)  # of pixels
        done = self.relievo("visible", "ground.off", "roof.off", *look, "-o", "seen.vtp",
                            "--cloud", "cloud.vtp")  # fmt: skip
        self.assertIn("1 of 2 cells are seen by 1 camera\n", done.stdout)
        numpy.testing.assert_array_equal(self.cells("seen.vtp", "seen"), [0, 1])
        cloud = vtk_to_numpy(self.read("cloud.vtp").GetPoints().GetData())
        self.assertEqual(len(cloud), self.cells("seen.vtp", "pixels").sum())
        self.assertTrue((cloud[:, 0] >= -1e-6).all() and (abs(cloud[:, 1]) < 1e-6).all())
        # All around, through a panorama, from above and from below.
        done = self.relievo("visible", "ground.off", "--poses", "random:6", "--seed", "4",
                            "--lens", "equirectangular", "--size", "64x32", "--up", "y",
                            "-o", "seen.vtp")  # fmt: skip
        numpy.testing.assert_array_equal(self.cells("seen.vtp", "seen"), 6)

    def test_seed(self):
        def angles(*words):
            look = ["--poses", "random:3", "--lens", "equirectangular", "--size", "64x32"]
            self.relievo("visible", "ground.off", *look, *words, "--up", "y", "-o", "seen.vtp")
            return self.cells("seen.vtp", "solid_angle").tolist()

        self.assertEqual(angles("--seed", "4"), angles("--seed", "4"))
        self.assertNotEqual(angles("--seed", "4"), angles("--seed", "5"))
        self.assertEqual(angles("--seed", "0"), angles())

    def test_lens_of_a_file(self):
        """Its size counts unless another of its shape is said; a unit is 20 pixels 10 away."""
        (self.folder / "camera.yml").write_text(
            "%YAML:1.0\nimage_width: 200\nimage_height: 100\n"
            "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
            "   data: [ 200., 0., 99.5, 0., 200., 49.5, 0., 0., 1. ]\n"
        )
        for words, unit in (([], 20), (["--size", "400x200"], 40)):
            self.relievo("visible", "ground.off", "--poses", "above.json", "--lens", "camera.yml",
                         *words, "-o", "seen.vtp")  # fmt: skip
            numpy.testing.assert_allclose(
                self.cells("seen.vtp", "pixels"), (2 * unit) ** 2, rtol=0.06)

    def test_refused(self):
        look = ["--poses", "orbit:2"]
        out = ["-o", "a.vtp"]
        for words, says in (
            (["sun", *SUN, *out], "sun: no FILE given"),
            (["sun", "ground.off", *SUN], "no file to write; give -o FILE.vtp"),
            (["sun", "ground.off", *SUN, "-o", "a.vtu"], ["-o", "'a.vtu'", ".vtp"]),
            (["sun", "ground.off", *SUN[:2], *out], "--dates FIRST"),
            (["sun", "ground.off", *SUN[2:], *out], "--place LATITUDE,LONGITUDE"),
            (["sun", "ground.off", *out, "--place", "91,0"], ["--place", "'91,0'"]),
            (["sun", "ground.off", *out, "--dates", "today"], ["--dates", "'today'"]),
            (["sun", "ground.off", *out, *SUN[:2], "--dates", "2026-02-30"], "2026-2-30, expected"),
            (["sun", "nothing.off", *out, *SUN[:2], "--dates", "2026-02-29"],
             "2026-2-29, expected"),
            (["sun", "ground.off", *out, *SUN, "--sky=1", "--sky=2"], "--sky: given twice"),
            (["sun", "ground.off", *out, "--place", "40,181"], ["--place", "-180 to 180"]),
            (["sun", "ground.off", *out, *SUN[:2], "--dates", "2026-02-02:2026-02-01"],
             ["--dates", "expected"]),
            (["sun", "ground.off", *out, *SUN, "--step", "0"], ["'0'", "from 0.1 to 240"]),
            (["sun", "ground.off", *out, *SUN, "--step", "0.05"], ["'0.05'", "from 0.1 to 240"]),
            (["sun", "ground.off", *out, *SUN, "--sky", "-1"], ["--sky", "'-1'"]),
            (["sun", "ground.off", *out, *SUN, "--rays", "a.vtp"], ["--rays", "'a.vtp'", ".rays"]),
            (["sun", "ground.off", *out, *SUN, "--weather", "a.epw"], "--irradiance isotropic"),
            (["sun", "town.gltf", *out, *SUN], ["town.gltf", "expected data"]),
            (["sun", "ground.png", *out, *SUN], "ground.png"),
            (["visible", "ground.off", *out], "give --poses"),
            (["visible", "nothing.off", *out, "--poses", "lots"], ["--poses", "'lots'"]),
            (["visible", "nothing.off", *out, "--poses", "orbit:2,elevation=x"],
             ["elevation", "'x'", "a number from -90 to 90"]),
            (["visible", "ground.off", *out, *look, "--size", "5"], ["--size", "'5'", "WxH"]),
            (["visible", "ground.off", *out, *look, "--lens", "wide"], ["--lens", "'wide'"]),
            (["visible", "ground.off", *out, *look, "--lens", "cube"], "six times as wide"),
            (["visible", "ground.off", *out, *look, "--lens", "orthographic"], "orthographic:100"),
            (["visible", "ground.off", *out, *look, "--cloud", "c.png"], ["--cloud", "'c.png'"]),
            (["visible", "ground.off", *out, *look, "--fog", "1"], "--fog"),
            (["visible", "ground.off", *out, *look, "--cloud", "c.vtp", "--part", "1/2"],
             "--cloud"),
            *((["sun", "ground.off", *out, *SUN, "--part", part], ["--part", expected])
              for part, expected in (("3", "K/N"), ("0/2", "from 1 to 2"), ("3/2", "from 1 to 2"),
                                     ("slurm", "SLURM_ARRAY_TASK_ID"))),
            (["merge", "nothing"], "nothing: has neither dataset.json, frames.json nor parts.json"),
            (["verify"], "verify: got 0 folders, expected one"),
        ):  # fmt: skip
            with self.subTest(words=words):
                self.refused(*words, status=2, says=says)
        self.refused("sun", "nothing.off", *out, *SUN, status=1, says="nothing.off")
        self.refused("sun", "ground.off", *out, *SUN, "--irradiance=perez", "--weather", "no.epw",
                     "--rays", "town.rays", status=1, says="--weather no.epw: cannot be read")
        (self.folder / "points.off").write_text("OFF\n1 0 0\n0 0 0\n")
        nowhere = [{"position": [0, 5, 0], "target": [0, 5, 0]}]
        (self.folder / "nowhere.json").write_text(json.dumps(nowhere))
        self.before = self.names()
        self.refused("visible", "ground.off", *out, "--poses", "nowhere.json", status=2,
                     says=["nowhere.json", "(0, 5, 0)", "is not a view, expected"])  # fmt: skip
        self.refused("sun", "points.off", *out, *SUN, status=1, says="points.off")


if __name__ == "__main__":
    main()
