# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every numbered example and every notebook runs as it is; examples write the documented files."""

import datetime
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import relievo

EXAMPLES = pathlib.Path(os.environ["RELIEVO_EXAMPLES"])
sys.path.insert(0, str(EXAMPLES))
import sun  # noqa: E402

# file name: the files that the example writes
WRITES = {
    "01_capture_depth.py": [],
    "02_write_exr.py": ["layers.exr"],
    "03_debug_views.py": [
        "view_Elevation.png", "view_actor.png", "view_albedo.png", "view_cell.png",
        "view_depth.png", "view_depth_4_to_9.png", "view_geometric_normal.png",
        "view_linear_depth.png", "view_normal.png",
    ],
    "04_point_cloud.py": ["points.vtp"],
    "05_frame_report.py": [],
    "06_sun_study.py": [
        "frame_00.png", "frame_01.png", "frame_02.png", "frame_03.png", "frame_04.png",
        "frame_05.png", "sun_hours.png",
    ],
    "07_three_spots.py": ["three_spots.png", "three_spots_layers.png"],
    "09_environment.py": ["environment.png", "environment_balls.png"],
    "10_relief_terrain.py": ["relief_terrain.png"],
    "12_town_at_night.py": ["town.png", "town_lamps.png"],
    "13_fog_valley.py": ["fog.png", "fog_layer.png"],
    "14_markers.py": ["markers.png", "markers_layer.png"],
    "15_blocks.py": ["blocks.png"],
    "16_caves.py": ["caves.png"],
    "18_voxel_cubes.py": ["voxels.png"],
    "19_surface_particles.py": ["particles.png"],
    "20_moving_cubes.py": ["cubes.png"],
    "21_soft_shadows.py": ["soft_shadows.png"],
    "22_animation.py": ["animation.png"],
    "23_animation_series.py": [
        "animation.vtp.series", "frame_0000.vtp", "frame_0001.vtp", "frame_0002.vtp",
    ],
    "24_soft_borders.py": ["soft_borders.png"],
    "25_certified_shadows.py": ["certified_shadows.png"],
    "26_wall_thickness.py": ["thickness.png", "thickness.vtp"],
    "27_sunlight_of_a_year.py": ["sunlight.png", "sunlight.vtp"],
    "28_training_pictures.py": ["train", "train.png"],
    "29_technical_drawing.py": ["drawing.png"],
    "30_skull.py": ["skull.png", "skull_depth.png"],
    "31_smoke.py": ["smoke.png"],
    "32_labels.py": ["labels.png", "labels_depth.png"],
    "33_work_in_parts.py": ["hours.png", "hours.vtp", "hours.vtp.parts"],
    "34_viewshed.py": ["viewshed.png", "viewshed.tif", "viewshed.vtp"],
    "35_ambient_occlusion.py": ["ambient.png"],
}  # fmt: skip

# ParaView's own interpreter runs these: tests/paraview.
BY_PARAVIEW = ["08_paraview_tour.py", "11_paraview_materials.py", "17_paraview_hall.py"]

# file name: words after the folder, for examples that take long otherwise
WORDS = {"06_sun_study.py": ["--every", "120"], "10_relief_terrain.py": ["257"],
    "21_soft_shadows.py": ["8"], "23_animation_series.py": ["--rate", "3"]}

# file name: constants that the copy which is run has instead, for the same reason
SMALLER = {
    "06_sun_study.py": {"SIZE": (320, 180)},
    "07_three_spots.py": {"SIZE": (720, 360)},
    "09_environment.py": {"SIZE": (400, 225)},
    "12_town_at_night.py": {"SIZE": (640, 360)},
    "13_fog_valley.py": {"SIZE": (600, 300)},
    "14_markers.py": {"SIZE": (600, 300)},
    "15_blocks.py": {"SIZE": (640, 360)},
    "16_caves.py": {"SIZE": (320, 180), "BLOCKS": (96, 96, 48)},
    "27_sunlight_of_a_year.py": {"GROUND": 40, "DAYS": 183, "MINUTES": 240},
    "28_training_pictures.py": {"VIEWS": 2},
    "30_skull.py": {"SIZE": (160, 120)},
    "31_smoke.py": {"SIZE": (240, 136), "POINTS": 32},
    "32_labels.py": {"SIZE": (160, 120), "POINTS": 24},
    "33_work_in_parts.py": {"PARTS": 2, "MINUTES": 240, "SIZE": (160, 100)},
    "34_viewshed.py": {"SIZE": (160, 100)},
    "35_ambient_occlusion.py": {"SIZE": (60, 50)},
}


def write_smaller(name, folder):
    """The example, or a copy of it with the constants of SMALLER."""
    text = (EXAMPLES / name).read_text()
    for constant, value in SMALLER[name].items():
        text, found = re.subn(rf"(?m)^{constant} = [^#\n]+", f"{constant} = {value}  ", text)
        assert found == 1, f"{name} has no {constant}"
    (folder / name).write_text(text)
    return folder / name


def paths_of(*folders):
    """PYTHONPATH without the wheel tests' folder that makes `vtkmodules` the wheel's VTK."""
    given = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    kept = [path for path in given if not path.endswith("tests/wheel/vtk")]
    return os.pathsep.join([*map(str, folders), *kept])


def cells_of(notebook):
    """The code of a notebook, with most pictures at a third of their size."""
    cells = json.loads(notebook.read_text("utf-8"))["cells"]
    text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    return re.sub(r"\((960|480), (\d+)\)",
                  lambda found: f"({int(found[1]) // 3}, {int(found[2]) // 3})", text)


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return relievo.layer(reader.GetOutput(), reader.GetOutput().GetPointData().GetArrayName(0))


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.kept.cleanup)
        cls.copies = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.copies.cleanup)
        cls.ran = {}
        cls.runner = subprocess.Popen(
            [sys.executable, pathlib.Path(__file__).with_name("runForked.py")],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": paths_of(EXAMPLES)},
        )  # fmt: skip
        cls.addClassCleanup(cls.runner.__exit__, None, None, None)

    def run_example(self, name):
        """The example's output; its files are in self.folder / "out". It runs once for all."""
        if name not in self.ran:
            folder = pathlib.Path(self.kept.name) / name
            folder.mkdir()
            script = EXAMPLES / name
            if name in SMALLER:
                script = write_smaller(name, pathlib.Path(self.copies.name))
            words = [str(folder / "out"), *WORDS.get(name, [])]
            print(json.dumps([str(script), str(folder), words]), file=self.runner.stdin, flush=True)
            self.ran[name] = folder, json.loads(self.runner.stdout.readline())
        self.folder, (status, output, errors) = self.ran[name]
        self.assertEqual((status, errors), (0, ""))
        return output

    def test_all_are_known(self):
        there = sorted(path.name for path in EXAMPLES.glob("[0-9]*.py"))
        self.assertEqual(sorted([*WRITES, *BY_PARAVIEW]), there)

    def test_they_run(self):
        for name, files in WRITES.items():
            with self.subTest(example=name):
                said = self.run_example(name)
                for file in files:
                    self.assertGreater((self.folder / "out" / file).stat().st_size, 100, file)
                    self.assertIn(file, said)
                for path in (self.folder / "out").glob("*"):
                    self.assertIn(path.name, files)
                for path in self.folder.glob("*"):
                    self.assertEqual(path.name, "out")

    def test_notebooks(self):
        notebooks = sorted(EXAMPLES.parent.glob("docs/notebooks/*.ipynb"))
        self.assertGreater(len(notebooks), 4)
        script = pathlib.Path(self.copies.name, "notebooks.py")
        script.write_text("".join(f"print({each.stem!r})\nexec({cells_of(each)!r}, {{}})\n"
                                  for each in notebooks), "utf-8")  # fmt: skip
        done = subprocess.run([sys.executable, script], cwd=self.copies.name, check=False,
                              capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": paths_of()})  # fmt: skip
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        for each in notebooks:
            self.assertIn(f"{each.stem}\n", done.stdout)

    def test_values(self):
        # A sphere of radius 1/2 around the origin: the nearest depth is the camera's distance less
        # the radius, but for the flat triangles.
        said = self.run_example("01_capture_depth.py")
        nearest = float(said.split("nearest ")[1].split(",")[0])
        self.assertAlmostEqual(nearest, 3.2903743 - 0.5, delta=2e-3)
        self.assertIn("corner inf", said)

        self.run_example("02_write_exr.py")
        image = relievo.read_exr(self.folder / "out" / "layers.exr")
        floor = relievo.layer(image, "actor") == 0
        height = relievo.layer(image, "position")[..., 1]
        numpy.testing.assert_allclose(height[floor], 0, atol=5e-6)
        numpy.testing.assert_allclose(relievo.layer(image, "Elevation")[floor], 0, atol=5e-6)

        self.assertTrue(self.run_example("05_frame_report.py").strip().endswith("True"))

    def test_sun_study(self):
        said = self.run_example("06_sun_study.py")
        # The sun is lowest first and last, and 90 - latitude high at noon of the equinox.
        heights = [float(line.split("the sun ")[1].split()[0]) for line in said.splitlines()[:6]]
        numpy.testing.assert_allclose(heights, heights[::-1], atol=0.11)
        self.assertEqual(heights[:3], sorted(heights[:3]))
        self.assertAlmostEqual(max(heights), 40.2, delta=0.5)  # at 11 h and 13 h
        # Long shadows make the first frame the darker one, but not black.
        early, noon = (read_png(self.folder / "out" / f"frame_0{i}.png") for i in (0, 2))
        self.assertEqual(early.shape, (180, 320, 3))
        self.assertLess(early.mean(), 0.8 * noon.mean())
        self.assertGreater(early[50:].std(), 10)

    def test_certified_shadows(self):
        # Three methods, each with its plan and its bound; exact shadows have no error.
        said = self.run_example("25_certified_shadows.py")
        ways = {}
        for line in said.splitlines():
            if not line.startswith(" "):
                ways[line.split(":")[0]] = found = []
            found.append(line)
        bounds = {}
        for name in ("map of 512", "tolerance", "exact"):
            bounds[name] = float(ways[name][3].split("at most ")[1].split(" %")[0])
        self.assertIn("was chosen for a tolerance of", ways["tolerance"][0])
        self.assertLess(bounds["tolerance"], 0.15)
        self.assertLess(bounds["exact"], 0.03)
        self.assertGreater(bounds["map of 512"], bounds["tolerance"])
        self.assertIn("found: 0 of", ways["exact"][2])

    def test_three_spots(self):
        self.run_example("07_three_spots.py")
        picture = read_png(self.folder / "out" / "three_spots.png").astype(float)
        # Surfaces without the light of one spot have the colour of the two others: yellow without
        # blue, cyan without red; magenta, without green, is behind the bike.
        red, green, blue = picture[..., 0], picture[..., 1], picture[..., 2]
        self.assertGreater((numpy.minimum(red, green) > 1.5 * blue + 30).mean(), 0.03)
        self.assertGreater((numpy.minimum(green, blue) > 1.5 * red + 30).mean(), 0.03)
        self.assertGreater((picture.min(axis=2) > 150).mean(), 0.3, "hardly anything is white")

    def test_town_at_night(self):
        said = self.run_example("12_town_at_night.py")
        reaching, computed = (float(line.split(": ")[1].split()[0])
                              for line in said.splitlines()[:2])  # fmt: skip
        self.assertGreater(reaching, 1)
        self.assertGreaterEqual(computed, reaching)
        self.assertLess(computed, 2 * reaching)
        picture = read_png(self.folder / "out" / "town.png").astype(float)
        # Most lamps are warm, and the sky above them is dark.
        self.assertGreater((picture[..., 0] > 1.2 * picture[..., 2] + 20).mean(), 0.1)
        self.assertLess(picture[:20].mean(), 30)

    def test_relief_terrain(self):
        said = self.run_example("10_relief_terrain.py")
        median = float(said.split("depths are ")[1].split()[0])
        self.assertLess(median, 0.5, "the relief is not the geometry")
        picture = read_png(self.folder / "out" / "relief_terrain.png").astype(float)
        left, right = picture[:, :600], picture[:, 600:]
        self.assertLess(abs(left - right).mean(), 12)
        self.assertGreater(left.std(), 30)

    def test_environment(self):
        self.run_example("09_environment.py")
        picture = read_png(self.folder / "out" / "environment.png").astype(float)
        red, green, blue = picture[..., 0], picture[..., 1], picture[..., 2]
        self.assertGreater((red > 1.5 * numpy.maximum(green, blue) + 30).mean(), 0.02, "the paint")
        self.assertGreater(picture[:50].std(), 3, "the sky is even")
        balls = read_png(self.folder / "out" / "environment_balls.png").astype(float)
        # The third ball is rough: its reflection changes less from pixel to pixel.
        columns = numpy.linspace(0, balls.shape[1], 7).astype(int)
        steps = []
        for left, right in zip(columns[:-1], columns[1:]):
            middle = (left + right) // 2
            ball = balls[100:200, middle - 50 : middle + 50]
            steps.append(numpy.abs(numpy.diff(ball, axis=0)).max())
        self.assertGreater(steps[0], 3 * steps[2])


class Sun(unittest.TestCase):
    def test_declination(self):
        # For 2026, at noon UT: 2.8 hours before an equinox, 11.9 after the other, at the solstices.
        truths = {(3, 20): -0.046, (9, 23): -0.193, (6, 21): 23.44, (12, 21): -23.44}
        for day, truth in truths.items():
            found = math.degrees(sun.declination(datetime.date(2026, *day)))
            self.assertAlmostEqual(found, truth, delta=0.012)
        # The whole year against the series of J. W. Spencer (Search 2, 1971, page 172), which knows
        # the day's number but not the leap years: a day of drift.
        for day in range(365):
            g = 2 * math.pi * day / 365
            series = math.degrees(
                0.006918 - 0.399912 * math.cos(g) + 0.070257 * math.sin(g)
                - 0.006758 * math.cos(2 * g) + 0.000907 * math.sin(2 * g)
                - 0.002697 * math.cos(3 * g) + 0.001480 * math.sin(3 * g)
            )  # fmt: skip
            date = datetime.date(2026, 1, 1) + datetime.timedelta(day)
            self.assertAlmostEqual(math.degrees(sun.declination(date)), series, delta=0.45)

    def test_direction(self):
        date = datetime.date(2026, 6, 21)
        tilt = sun.declination(date)
        self.assertAlmostEqual(math.degrees(tilt), 23.44, delta=0.02)
        for latitude in (-35.0, 0.0, 10.0, 48.0, 89.0):
            for hour in (0, 5.5, 12, 18):
                self.assertAlmostEqual(math.hypot(*sun.direction(latitude, date, hour)), 1)
            east, north, up = sun.direction(latitude, date, 12)
            self.assertAlmostEqual(east, 0)
            self.assertAlmostEqual(math.atan2(north, up), tilt - math.radians(latitude))
            self.assertGreater(sun.direction(latitude, date, 9)[0], 0, "the morning sun is east")
            half = sun.day_length(latitude, date) / 2
            if 0 < half < 12:
                # From its rise until noon the sun moves on among the stars: its declination
                # changes, and its day is not quite 24 hours long, as its noons tell.
                rising = sun.position(latitude, date, 12 - half)
                then = math.radians(rising.GetDeclination())
                before, after = (
                    sun.position(latitude, date + datetime.timedelta(days), 12).GetNoon()
                    for days in (-1, 1)
                )
                angle = 2 * math.pi * half / (24 + (after - before) / 2)
                at = math.radians(latitude)
                height = math.sin(at) * math.sin(then)
                height += math.cos(at) * math.cos(then) * math.cos(angle)
                rise = sun.direction(latitude, date, 12 - half)[2]
                self.assertAlmostEqual(rise, height, delta=1e-6)
                moved = abs(then - tilt) + abs(angle - 2 * math.pi * half / 24)
                self.assertLess(abs(height), moved + 1e-12)
        self.assertEqual(sun.day_length(80, date), 24)
        self.assertEqual(sun.day_length(-80, date), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
