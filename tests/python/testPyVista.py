# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista finds Relievo by its metadata: against a stand-in of the documented protocol."""

import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from importlib.metadata import entry_points, version

sys.path.insert(0, str(pathlib.Path(__file__).parent / "standin"))

import numpy
import pyvista
import pyvista_render_passes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAAPass

# Not imported: relievo. PyVista alone is to find it.


def ball(radius=1.0, at=(0, 0, 0)):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(*at)
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    return source


def floor(height=-1.0):
    source = vtkPlaneSource()
    source.SetOrigin(-4, -4, height)
    source.SetPoint1(4, -4, height)
    source.SetPoint2(-4, 4, height)
    return source


def lit_scene(**size):
    """A ball over a floor, the sun straight above."""
    plotter = pyvista.Plotter(**size)
    plotter.add_mesh(ball())
    plotter.add_mesh(floor())
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(0, 0, 10)
    plotter.renderer.AutomaticLightCreationOff()
    plotter.renderer.AddLight(sun)
    return plotter


def lit_scene_shown():
    plotter = lit_scene()
    plotter.show()
    return plotter


def shown(plotter):
    """The window's picture, RGB, row 0 at the top."""
    window = plotter.render_window
    columns, rows = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, columns - 1, rows - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(rows, columns, 3)[::-1].astype(int)


def drawn(plotter):
    plotter.render()
    return shown(plotter)


def smoothed():
    around = vtkSSAAPass()
    around.SetDelegatePass(vtkRenderStepsPass())
    return around


def hidden_from_the_sun(plotter):
    """Pixels of the floor well within the ball's shadow, which is as wide as the ball."""
    place = plotter.relievo.layer("position")
    on_floor = (numpy.abs(place[..., 2] + 1) < 1e-5) & (plotter.relievo.layer("actor") == 1)
    return on_floor & (numpy.hypot(place[..., 0], place[..., 1]) < 0.9)


class Metadata(unittest.TestCase):
    def test_found_without_import(self):
        groups = {"pyvista.plotter_components": "relievo", "pyvista.readers": ".exr",
                  "pyvista.writers": ".exr",
                  "pyvista_render_passes.providers": "relievo"}  # fmt: skip
        for group, name in groups.items():
            self.assertEqual([each.name for each in entry_points(group=group)], [name])
        self.assertRegex(version("vtk-relievo"), r"^\d+\.\d+\.\d+$")

    def test_older_versions(self):
        code = ("import sys, types; older = types.ModuleType('pyvista'); "
                "older.__version__ = '0.44.1'; sys.modules['pyvista'] = older; "
                "import relievo.pyvista")  # fmt: skip
        done = subprocess.run([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True)
        self.assertIn("ImportError: relievo.pyvista: got PyVista 0.44.1, expected 0.48 or later",
                      done.stderr)  # fmt: skip


class Component(unittest.TestCase):
    def test_shadows(self):
        """The ball's shadow, which is as wide as the ball, loses the sun's light."""
        plotter = lit_scene()
        plotter.show()
        plotter.relievo.shadows()
        self.assertIs(plotter.relievo, plotter.relievo)
        place = plotter.relievo.layer("position")
        lit = plotter.relievo.layer("shadow_0")
        on_floor = numpy.abs(place[..., 2] + 1) < 1e-5
        away = numpy.hypot(place[..., 0], place[..., 1])
        seen = on_floor & (away < 5) & (numpy.isfinite(plotter.relievo.layer("depth")))
        self.assertTrue((lit[seen & (away > 1.05)] == 1).all())
        self.assertTrue((lit[seen & (away < 0.95)] == 0).all())
        self.assertGreater((seen & (away < 0.95)).sum(), 50)
        dark = plotter.relievo.layer("color")[..., :3].sum(axis=-1)
        plotter.relievo.shadows(False)
        bright = plotter.relievo.layer("color")[..., :3].sum(axis=-1)
        hidden = seen & (away < 0.95)
        self.assertTrue((dark[hidden] < 0.01).all() and (bright[hidden] > 0.1).all())

    def test_camera_before_the_first_show(self):
        """A capture before show() has the picture that PyVista would show."""
        early, shown = lit_scene(), lit_scene()
        shown.show()
        numpy.testing.assert_array_equal(
            early.relievo.layer("depth"), shown.relievo.layer("depth"))
        placed = lit_scene()
        placed.renderer.camera_position = [(0, 0, 9), (0, 0, 0), (0, 1, 0)]
        self.assertAlmostEqual(float(placed.relievo.layer("depth")[100, 150]), 8, delta=0.01)

    def test_active_renderer_and_close(self):
        plotter = pyvista.Plotter(shape=2)
        for i in range(2):
            plotter.subplot(i)
            plotter.add_mesh(ball())
        plotter.relievo.shadows()
        left, right = plotter.renderers
        self.assertIsNone(left.GetPass())
        self.assertTrue(right.GetPass().IsA("vtkRelievoPass"))
        plotter.subplot(0)
        plotter.relievo.show("normal")
        self.assertEqual(left.GetPass().GetDisplayLayer(), "normal")
        plotter.relievo.off()
        self.assertIsNone(left.GetPass())
        plotter.close()
        self.assertIsNone(right.GetPass())

    def test_stages_and_data(self):
        plotter = lit_scene()
        plotter.show()
        source = ball()
        plotter.relievo.fog(source, radius=0.1, density=0.1)
        plotter.relievo.lamps(source, radius=0.1)
        plotter.relievo.markers(source, radius=0.1)
        plotter.relievo.stage("shadows", bias=2)
        image = plotter.relievo.capture(["depth", "fog"], size=(60, 40))
        self.assertIn("shadows", [each["name"] for each in plotter.relievo.report()["stages"]])
        self.assertIsInstance(image, pyvista.ImageData)
        self.assertEqual(image.GetDimensions(), (60, 40, 1))
        with self.assertRaisesRegex(ValueError, "got 'shadow'"):
            plotter.relievo.stage("shadow")


class Passes(unittest.TestCase):
    """Other uses of the renderer's pass, before Relievo and after it."""

    def test_in_any_order(self):
        before, after = lit_scene(), lit_scene()
        for plotter in (before, after):
            plotter.show()
        before.renderer.SetPass(smoothed())
        plain = drawn(before)
        before.relievo.shadows()
        after.relievo.shadows()
        after.render()
        after.renderer.SetPass(smoothed())
        pictures = [drawn(before), drawn(after)]
        numpy.testing.assert_array_equal(*pictures)
        dark = hidden_from_the_sun(after)
        self.assertGreater(dark.sum(), 50)
        self.assertGreater(plain[dark].mean(), 100)
        self.assertLess(pictures[1][dark].mean(), 10)
        after.relievo.shadows(False)
        numpy.testing.assert_array_equal(drawn(after), plain)
        after.renderer.SetPass(None)
        self.assertEqual(after.relievo.report()["stages"][0]["name"], "delegate")
        numpy.testing.assert_array_equal(drawn(after), drawn(lit_scene_shown()))
        self.assertTrue(after.renderer.GetPass().IsA("vtkRelievoPass"))

    def test_detached_it_stays_away(self):
        plotter = lit_scene()
        plotter.show()
        plotter.relievo.shadows()
        plotter.render()
        import relievo

        self.assertTrue(relievo.detach(plotter.renderer))
        numpy.testing.assert_array_equal(drawn(plotter), drawn(lit_scene_shown()))
        self.assertIsNone(plotter.renderer.GetPass())
        plotter.relievo.shadows()
        self.assertLess(drawn(plotter)[hidden_from_the_sun(plotter)].mean(), 10)

    def test_among_those_of_another_package(self):
        """pyvista-render-passes: its component is made first, or Relievo's, for one picture."""
        pictures = []
        for relievo_first in (True, False):
            plotter = lit_scene()
            plotter.show()
            if relievo_first:
                plotter.relievo.shadows()
                plotter.render()
            passes = pyvista_render_passes.RenderPassComponent(plotter.renderer)
            passes.set(anti_aliasing=True)
            plotter.render()
            if not relievo_first:
                plain = shown(plotter)
                plotter.relievo.shadows()
            pictures.append(drawn(plotter))
            self.assertIs(plotter.renderer.GetPass(), passes.top)
            dark = hidden_from_the_sun(plotter)
            self.assertGreater(dark.sum(), 50)
            self.assertLess(pictures[-1][dark].mean(), 10)
            self.assertTrue((plotter.relievo.layer("shadow_0")[dark] == 0).all())
            self.assertIs(plotter.renderer.GetPass(), passes.top)
            numpy.testing.assert_array_equal(shown(plotter), pictures[-1])
            import relievo

            around = relievo.layer(relievo.capture(plotter.renderer, "depth"), "depth")
            numpy.testing.assert_array_equal(around, plotter.relievo.layer("depth"))
            self.assertIs(plotter.renderer.GetPass(), passes.top)
            self.assertIs(relievo.attach(plotter.renderer), plotter.relievo.frame)
            plotter.relievo.off()
            without = drawn(plotter)
            passes.set(anti_aliasing=False)
            numpy.testing.assert_array_equal(drawn(plotter), drawn(lit_scene_shown()))
            self.assertIsNone(plotter.renderer.GetPass())
        numpy.testing.assert_array_equal(*pictures)
        numpy.testing.assert_array_equal(without, plain)

    def test_capture_while_others_set_their_pass(self):
        import relievo

        plotter = lit_scene()
        depth = relievo.capture(plotter, "depth", (30, 20))

        def start(renderer, _):
            renderer.SetPass(vtkRenderStepsPass())

        plotter.renderer.AddObserver("StartEvent", start)
        again = relievo.capture(plotter, "depth", (30, 20))
        numpy.testing.assert_array_equal(*[relievo.layer(a, "depth") for a in (depth, again)])
        self.assertTrue(plotter.renderer.GetPass().IsA("vtkRenderStepsPass"))

    def test_refused_pairs(self):
        for name, use in (
            ("fog", lambda plotter: plotter.relievo.fog(ball(), radius=0.1)),
            ("lamps", lambda plotter: plotter.relievo.lamps(ball(), radius=0.1)),
            ("markers", lambda plotter: plotter.relievo.markers(ball(), radius=0.1)),
            ("tone", lambda plotter: plotter.relievo.stage("tone")),
            ("show", lambda plotter: plotter.relievo.show("normal")),
            ("shadows", lambda plotter: plotter.relievo.shadows()),
            ("shadows", lambda plotter: plotter.relievo.stage("shadows")),
        ):
            setting = "shadows" if name == "shadows" else "ssao"
            said = f"{name} beside .*plotter.render_passes.*off"
            plotter = lit_scene()
            passes = pyvista_render_passes.RenderPassComponent(plotter.renderer)
            passes.set(**{setting: True})
            with self.assertRaisesRegex(ValueError, said):
                use(plotter)
            passes.set(**{setting: False})
            use(plotter)
            with self.assertRaisesRegex(ValueError, said):
                passes.set(**{setting: True})
            self.assertFalse(passes.settings[setting])

    def test_capture_leaves_what_is_shown(self):
        plotter = lit_scene()
        plotter.show()
        before = shown(plotter)
        for size in (None, (60, 40)):
            plotter.relievo.capture("depth", size=size)
            numpy.testing.assert_array_equal(shown(plotter), before)


class Files(unittest.TestCase):
    def test_exr_there_and_back(self):
        plotter = lit_scene()
        plotter.show()
        image = plotter.relievo.capture(["depth", "normal"])
        with tempfile.TemporaryDirectory() as folder:
            path = str(pathlib.Path(folder) / "frame.EXR")
            image.save(path, compression="piz")
            again = pyvista.read(path)
            address = "https://somewhere.example/frame.exr"
            pyvista.FETCHED[address] = path
            self.assertEqual(pyvista.read(address).GetDimensions(), image.GetDimensions())
            with self.assertRaises(FileNotFoundError):
                pyvista.read(pathlib.Path(folder) / "other.exr")
            with self.assertRaisesRegex(TypeError, "progress_bar"):
                pyvista.read(path, progress_bar=True)
            with self.assertRaisesRegex(ValueError, "compression"):
                image.save(path, compression="best")
        self.assertIsInstance(again, pyvista.ImageData)
        for name in ("depth", "normal"):
            arrays = [each.GetPointData().GetArray(name) for each in (image, again)]
            numpy.testing.assert_array_equal(*[numpy.array(memoryview(a)) for a in arrays])


# A page's example, and what can go wrong. RADIUS is a change that a programmer makes.
PAGE = (pathlib.Path(__file__).parents[2] / "docs" / "compare.md").read_text(encoding="utf-8")
EXAMPLE = next(each for each in re.findall("^```python\n(.*?)^```$", PAGE, re.M | re.S)
               if "relievo_baseline" in each)  # fmt: skip
LAZY = """
import sys

LOADED = "relievo" in sys.modules  # before the page's example imports it

def test_lazy():
    assert not LOADED
"""
WHEELS = """
import os
import numpy
import pytest
import pyvista

RADIUS = float(os.environ["RADIUS"])

@pytest.mark.parametrize("word", ["a/../b", "ä %", "x" * 300], ids=str)
def test_picture(relievo_baseline, word):
    relievo_baseline(numpy.full((4, 6, 3), len(word) % 100, numpy.uint8))

def test_twice(relievo_baseline):
    plotter = pyvista.Plotter()
    actor = plotter.add_mesh(pyvista.Cylinder(), name="wheel")
    relievo_baseline(plotter.renderer, portable=True)
    actor.SetPosition(RADIUS - 0.5, 0, 0)
    relievo_baseline(plotter)

def test_limits(relievo_baseline):
    picture = numpy.full((4, 6, 3), 100 if RADIUS == 0.5 else 105, numpy.uint8)
    relievo_baseline(picture, name="grey", levels=5)

def test_same_grey(relievo_baseline):
    relievo_baseline(numpy.full((4, 6, 3), 101, numpy.uint8), name="grey")
"""
WRONG = """
import numpy
import pytest

PICTURE = numpy.zeros((4, 6, 3), numpy.uint8)

def test_nothing(relievo_baseline):
    pass

@pytest.mark.parametrize("word", ["a b", "a/b"])
def test_clash(relievo_baseline, word):
    relievo_baseline(PICTURE)

def test_name(relievo_baseline):
    relievo_baseline(PICTURE, name="../a")

def test_damaged(relievo_baseline):
    relievo_baseline(PICTURE)
"""


@unittest.skipUnless(importlib.util.find_spec("pytest"), "needs pytest: packages.txt, [tests]")
class Pytest(unittest.TestCase):
    """The fixture relievo_baseline, which pytest finds by the metadata of the package."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "unit").mkdir()

    def write(self, name, text):
        (self.folder / "unit" / name).write_text(text, encoding="utf-8")

    def pytest(self, *words, counts, radius=0.5):
        """What a run prints; counts is a dict of the outcomes that it expects."""
        paths = [str(pathlib.Path(pyvista.__file__).parent), os.environ.get("PYTHONPATH", "")]
        done = subprocess.run(
            [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *words], cwd=self.folder,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths), "RADIUS": str(radius)},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)  # fmt: skip
        last = done.stdout.splitlines()[-1]
        seen = {word: int(number) for number, word in re.findall(r"(\d+) (\w+)[, ]", last)
                if word != "warnings"}
        self.assertEqual(seen, counts, done.stdout)
        self.assertEqual(done.returncode, 1 if counts.get("failed") else 0, done.stdout)
        return done.stdout

    def baselines(self):
        return {path.name for path in (self.folder / "unit" / "baselines").iterdir()}

    def test_written_then_compared(self):
        self.write("test_lazy.py", LAZY)  # which runs first
        self.write("test_wheels.py", WHEELS)
        self.write("test_page.py", EXAMPLE.replace("Cylinder()", "Cylinder(radius=RADIUS)")
                   + "\nimport os\nRADIUS = float(os.environ['RADIUS'])\n")  # fmt: skip
        said = self.pytest(counts={"passed": 1, "failed": 7})
        self.assertIn("unit/baselines/wheel.exr: there is no such baseline", said)
        self.assertIn("pytest --relievo-update unit/test_page.py::test_wheel", said)
        self.assertFalse((self.folder / "unit" / "baselines").exists())

        said = self.pytest("--relievo-update", counts={"passed": 1, "skipped": 7})
        self.assertRegex(said, "Written; look at them[^\n]*\n(.*\n)*  unit/baselines/wheel.exr")
        names = self.baselines()
        self.assertLessEqual({"wheel.exr", "twice.exr", "twice_1.exr", "grey.exr",
                              "picture_a_.._b.exr"}, names)  # fmt: skip
        self.assertEqual(len(names), 7)
        self.assertLess(max(map(len, names)), 80)
        self.pytest(counts={"passed": 8})
        import relievo
        from relievo.vtkRelievoScene import vtkRelievoBaseline

        twice = relievo.read_exr(self.folder / "unit" / "baselines" / "twice.exr")
        self.assertTrue(vtkRelievoBaseline.IsPortable(twice))

        said = self.pytest("--relievo-report", "report", radius=0.7,
                           counts={"passed": 6, "failed": 2})  # fmt: skip
        self.assertRegex(said, r"unit/baselines/wheel.exr: different: .*\nE +picture +camera ")
        self.assertRegex(said, r"wheel \(actor 0\) +moved by \(0.2, 0, 0\)")
        report = self.folder / "report" / "unit"
        found = json.loads((report / "test_page" / "wheel.json").read_text())
        self.assertFalse(found["alike"])
        self.assertEqual({path.name for path in (report / "test_wheels").iterdir()},
                         {f"twice_1.{end}" for end in ("json", "html", "frame.exr", "frame.png",
                                                       "baseline.exr", "baseline.png")})
        old = (report / "test_page" / "wheel.baseline.exr").read_bytes()
        self.assertEqual(old, (self.folder / "unit" / "baselines" / "wheel.exr").read_bytes())

        said = self.pytest("--relievo-update", radius=0.7, counts={"passed": 6, "skipped": 2})
        self.assertIn("  unit/baselines/wheel.exr\n", said)
        self.assertNotIn("  unit/baselines/twice.exr\n", said)  # it does not differ
        self.pytest(radius=0.7, counts={"passed": 8})
        self.assertEqual(self.baselines(), names)

    def test_refused(self):
        self.write("test_wrong.py", WRONG)
        (self.folder / "pytest.ini").write_text("[pytest]\nrelievo_baselines = expected\n")
        folder = self.folder / "expected"
        folder.mkdir()
        (folder / "damaged.exr").write_bytes(b"v/1\x01 not an image")
        said = self.pytest("--relievo-report", "report", counts={"failed": 5})
        for words in (
            "test_nothing: has the fixture relievo_baseline, but compares nothing",
            "expected/clash_a_b.exr: there is no such baseline",
            "expected/clash_a_b.exr: is the baseline of unit/test_wrong.py::test_clash[a b] and of",
            "name: got '../a', expected a file's name",
            "expected/damaged.exr: the baseline cannot be read:",
        ):
            self.assertIn(words, said)
        self.pytest("--relievo-update", "--relievo-baselines", "other", "-k", "clash or damaged",
                    counts={"failed": 1, "skipped": 2, "deselected": 2})  # fmt: skip
        self.assertEqual({path.name for path in (self.folder / "other").iterdir()},
                         {"clash_a_b.exr", "damaged.exr"})
        self.pytest("--relievo-update", "-k", "damaged", counts={"skipped": 1, "deselected": 4})
        self.pytest("-k", "damaged", counts={"passed": 1, "deselected": 4})


if __name__ == "__main__":
    unittest.main()
