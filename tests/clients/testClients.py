# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista, pyvista-render-passes and vedo themselves, with an installed wheel."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
import relievo  # noqa: F401  (first: PyVista then takes its VTK)

import pyvista

pyvista.OFF_SCREEN = True
SUN = (2.0, 1.0, 6.0)
FLOOR, RADIUS = -0.6, 0.5

VEDO = f"""
import numpy
import relievo
relievo.provide_vtkmodules()
import vedo
ball, floor = vedo.Sphere(r={RADIUS}, res=60), vedo.Plane(pos=(0, 0, {FLOOR}), s=(4, 4))
plotter = vedo.Plotter(offscreen=True, size=(400, 300))
plotter.show(ball, floor.lighting("default"), axes=1, viewup="z")
light = vedo.vtkclasses.vtkLight()
light.SetLightTypeToSceneLight()
light.SetPosition({SUN})
plotter.renderer.RemoveAllLights()
plotter.renderer.AddLight(light)
relievo.stage(plotter.renderer, "shadows")
plotter.render()
image = relievo.capture(plotter, ["position", "shadow_0", "color"])
names = relievo.layer_names(image)
# vedo's objects themselves, and its points
assert numpy.isfinite(relievo.layer(relievo.capture(ball, "depth"), "depth")).mean() > 0.15
assert relievo.rays(ball).any([(0, 0, 5), (0.6, 0, 5)], (0, 0, -1)).tolist() == [True, False]
lamps = relievo.lamps(plotter, vedo.Points([(0, 0, 2)]), radius=4, color="tomato")
assert relievo.layer(relievo.capture(plotter, "light"), "light").max() > 0.1
relievo.attach(plotter).GetStage("lamps").RemovePoints(lamps)
numpy.savez("vedo.npz", **{{name: relievo.layer(image, name) for name in names}})
plotter.close()
"""


def scene(size=(400, 300)):
    """A ball over a floor, in sunlight."""
    plotter = pyvista.Plotter(window_size=size)
    ball = pyvista.Sphere(radius=RADIUS, theta_resolution=60, phi_resolution=60)
    plotter.add_mesh(ball, color="tomato")
    floor = pyvista.Plane(center=(0, 0, FLOOR), i_size=4, j_size=4, i_resolution=40,
                          j_resolution=40)  # fmt: skip
    floor["place"] = floor.points
    plotter.add_mesh(floor, scalars=None, color="white")
    plotter.remove_all_lights()
    plotter.add_light(pyvista.Light(position=SUN, light_type="scene light"))
    plotter.camera_position = [(4, -3, 3), (0, 0, 0), (0, 0, 1)]
    return plotter


def drawn(plotter):
    plotter.render()
    return plotter.screenshot(return_img=True).astype(int)


def in_the_shade(place):
    """Of places on the floor: 1 well within the ball's shadow, -1 well outside, 0 near its edge."""
    sun = numpy.array(SUN) / numpy.linalg.norm(SUN)
    distance = numpy.linalg.norm(numpy.cross(place, sun), axis=-1)
    return (distance < 0.95 * RADIUS) * 1 - (distance > 1.05 * RADIUS) * 1


class Clients(unittest.TestCase):
    def check_shadow(self, place, on_floor, visibility, picture):
        """The floor is dark where the ball is between it and the sun, and lit elsewhere."""
        shade = numpy.where(on_floor, in_the_shade(place), 0)
        self.assertGreater((shade > 0).sum(), 300)
        self.assertTrue((visibility[shade > 0] == 0).all())
        self.assertTrue((visibility[shade < 0] == 1).all())
        self.assertLess(picture[shade > 0].mean(), 0.1 * picture[shade < 0].mean())


    def check(self, plotter, place="position"):
        layers = {name: plotter.relievo.layer(name) for name in ("actor", "shadow_0", place)}
        picture = drawn(plotter).mean(axis=-1)
        self.check_shadow(layers[place], layers["actor"] == 1, layers["shadow_0"], picture)


class PyVista(Clients):
    def test_shadows_and_back(self):
        plotter = scene()
        plain = drawn(plotter)
        plotter.relievo.frame  # noqa: B018  (attached, and idle)
        numpy.testing.assert_array_equal(drawn(plotter), plain)
        plotter.relievo.shadows()
        self.check(plotter)
        plotter.relievo.shadows(False)
        numpy.testing.assert_array_equal(drawn(plotter), plain)
        plotter.close()

    def test_volume(self):
        """add_volume() casts on the floor, and pick() answers it."""
        side = 41
        place = numpy.mgrid[0:side, 0:side, 0:side] / (side - 1) - 0.5
        inside = numpy.sqrt((place**2).sum(axis=0)) < RADIUS - 0.03
        grid = pyvista.ImageData(dimensions=(side,) * 3, spacing=(1 / (side - 1),) * 3,
                                 origin=(-0.5,) * 3)  # fmt: skip
        grid["inside"] = inside.astype(numpy.uint8).ravel() * 255
        plotter = scene()
        plotter.remove_actor(plotter.actors[next(iter(plotter.actors))])
        plotter.add_volume(grid, opacity="linear", opacity_unit_distance=0.01, shade=True)
        plotter.relievo.shadows()
        place = plotter.relievo.layer("position")
        floor = numpy.isfinite(plotter.relievo.layer("depth"))
        sun = numpy.array(SUN) / numpy.linalg.norm(SUN)
        away = numpy.linalg.norm(numpy.cross(place, sun), axis=-1)
        seen = plotter.relievo.layer("shadow_0")
        self.assertLess(seen[floor & (away < 0.8 * RADIUS)].max(), 0.1)
        self.assertGreater(seen[floor & (away > 1.2 * RADIUS)].min(), 0.99)
        found = plotter.relievo.pick(200, 150)
        self.assertEqual(found.kind, "volume")
        self.assertLess(numpy.linalg.norm(found.position), RADIUS + 0.03)
        plotter.close()

    def test_passes_in_any_order(self):
        for switch in ("enable_ssao", "enable_eye_dome_lighting"):
            before, after = scene(), scene()
            getattr(before, switch)()
            plain = drawn(before)
            before.relievo.shadows()
            after.relievo.shadows()
            drawn(after)
            getattr(after, switch)()
            numpy.testing.assert_array_equal(drawn(before), drawn(after))
            after.relievo.shadows(False)
            numpy.testing.assert_array_equal(drawn(after), plain)
            before.close()
            after.close()

    def test_screenshot(self):
        """All samples of soft shadows, at once, and alpha in the background."""
        plotter = scene()
        plotter.relievo.shadows(soft_samples=16, sun_angle=5)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.png")
            whole = plotter.relievo.screenshot(path)
            numpy.testing.assert_array_equal(pyvista.read_texture(path).to_array()[..., :3], whole)
        self.assertEqual(plotter.relievo.frame.GetSamplesLeft(), 0)
        numpy.testing.assert_array_equal(whole, drawn(plotter))
        seen = numpy.isfinite(plotter.relievo.layer("depth"))
        alpha = plotter.relievo.screenshot(transparent=True)[..., 3]
        self.assertTrue((alpha[seen] > 0).all() and (alpha[~seen] < 255).all())
        self.assertGreater((alpha == 255 * seen).mean(), 0.99)  # but for the window's multisamples
        plotter.close()

    def test_baselines(self):
        """The example of docs/compare.md writes a baseline, passes, then fails after a change."""
        page = (pathlib.Path(__file__).parents[2] / "docs" / "compare.md").read_text("utf-8")
        example = re.search(r"^```python\n(import relievo .*?)^```$", page, re.M | re.S)[1]
        with tempfile.TemporaryDirectory() as folder:
            for text, option, says in (
                (example, "--relievo-update", "1 skipped"), (example, "-v", "1 passed"),
                (example.replace("off_screen", "window_size=(400, 300), off_screen"), "-v",
                 "E +picture +size: "),
            ):  # fmt: skip
                pathlib.Path(folder, "test_page.py").write_text(text, "utf-8")
                done = subprocess.run(
                    [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", option],
                    cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                    check=False)  # fmt: skip
                self.assertRegex(done.stdout, says)

    def test_subplots(self):
        plotter = pyvista.Plotter(shape=(1, 2), window_size=(400, 200))
        for column in range(2):
            plotter.subplot(0, column)
            plotter.add_mesh(pyvista.Sphere())
            plotter.add_text(str(column))
        plain = drawn(plotter)
        plotter.relievo.show("normal")
        left, right = numpy.array_split(drawn(plotter), 2, axis=1)
        numpy.testing.assert_array_equal(left, plain[:, :200])
        self.assertTrue((right != plain[:, 200:]).any())
        plotter.relievo.off()
        numpy.testing.assert_array_equal(drawn(plotter), plain)
        plotter.close()

    def test_camera_distortion(self):
        plotter = scene()
        plotter.enable_camera_distortion((0.6, 0.1, 0.02, 0.01))
        plotter.relievo.shadows()
        self.check(plotter, "place")
        plotter.close()

    def test_files(self):
        plotter = scene()
        image = plotter.relievo.capture(["depth", "normal"])
        with tempfile.TemporaryDirectory() as folder:
            image.save(pathlib.Path(folder, "a.exr"), compression="piz")
            again = pyvista.read(pathlib.Path(folder, "a.exr"))
        for name in ("depth", "normal"):
            numpy.testing.assert_array_equal(image[name], again[name])
        plotter.close()


@unittest.skipUnless(importlib.util.find_spec("pyvista_render_passes"), "it needs Python 3.12")
class RenderPasses(Clients):
    def test_composed(self):
        for switches in (["enable_anti_aliasing"], ["enable_ssao"], ["enable_edl"],
                         ["enable_anti_aliasing", "enable_ssao", "enable_edl"]):  # fmt: skip
            plotter = scene()
            for each in switches:
                getattr(plotter.render_passes, each)()
            plain = drawn(plotter)
            plotter.relievo.shadows()
            self.check(plotter)
            self.assertTrue(plotter.render_passes.is_active)
            self.assertFalse(plotter.render_passes.provider_errors)
            plotter.relievo.off()
            numpy.testing.assert_array_equal(drawn(plotter), plain)
            plotter.close()

    def test_refused(self):
        plotter = scene()
        plotter.relievo.fog(pyvista.PolyData([[0.0, 0.0, 0.0]]), radius=0.5)
        with self.assertRaisesRegex(ValueError, "'relievo' refused .*fog beside SSAO"):
            plotter.render_passes.enable_ssao()
        plotter.relievo.off()
        plotter.render_passes.enable_shadows()
        with self.assertRaisesRegex(ValueError, "shadows beside those of plotter.render_passes"):
            plotter.relievo.shadows()
        plotter.close()


ALONE = """
import numpy, pyvista
assert pyvista.vtk_backend() == "vtk"
image = pyvista.ImageData(dimensions=(5, 4, 1))
image["depth"] = numpy.linspace(0, 1, 20, dtype="f4")
image["id of it"] = numpy.arange(20, dtype="i4")
image["normal"] = numpy.full((20, 3), numpy.nan, "f4")
image.save("a.exr", compression="piz")
again = pyvista.read("a.exr")
assert type(again) is pyvista.ImageData
for name in image.array_names:
    numpy.testing.assert_array_equal(again[name], image[name])
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(pyvista.Sphere())
plotter.screenshot("a.png")
plotter.relievo.shadows()
"""


class Alone(unittest.TestCase):
    def test_usual_vtk(self):
        """Beside the wheel PyVista has its usual VTK where relievo is not imported. Files work."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", ALONE], cwd=folder, check=False,
                                  capture_output=True, text=True, env=os.environ)  # fmt: skip
            self.assertTrue(pathlib.Path(folder, "a.png").is_file(), done.stderr)
        refusal = ("^RuntimeError: plotter.relievo: got a vtkOpenGLRenderer of vtkmodules, .* "
                   "import relievo before pyvista")  # fmt: skip
        self.assertRegex(done.stderr.splitlines()[-1], refusal)


class Vedo(Clients):
    def test_of_another_vtk(self):
        code = "import vedo, relievo; relievo.capture(vedo.Sphere())"
        done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True,
                              text=True, env=os.environ)  # fmt: skip
        self.assertIn("Sphere with a vtkPolyData of vtkmodules, another VTK", done.stderr)

    def test_shadows(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", VEDO], cwd=folder, check=False,
                                  capture_output=True, text=True, env=os.environ)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            got = numpy.load(pathlib.Path(folder, "vedo.npz"))
            place = got["position"]
            on_floor = abs(place[..., 2] - FLOOR) < 1e-5
            self.check_shadow(place, on_floor & (abs(place).max(axis=-1) < 1.99), got["shadow_0"],
                              got["color"][..., :3].mean(axis=-1))  # fmt: skip


if __name__ == "__main__":
    unittest.main(verbosity=2)
