# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture without options, in studio: lit on all sides, on a ground, in view, upright, with
smooth edges; and the parts replaced by other options and the file itself."""

import json
import os

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

from cli import CliTest, main, oklab, read_png

STUDIO = {"RELIEVO_PRESET": ""}
SIZE = ["--size", "240x180"]
# Where it shows as well: each picture has 24 samples, each with shadows of its own.
SMALL = ["--size", "120x90"]
COARSE = ["--shadow-size", "256"]
# From all sides, and as the file's y or z is up.
SIDES = [(1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1), (0.6, 0.8, 0), (-0.6, 0.8, 0), (0, 0.8, 0.6)]


def shrunk(mask):
    """The mask without its rim, where pixels mix with the background."""
    turned = [numpy.roll(mask, step, axis) for axis in (0, 1) for step in (-2, 2)]
    return numpy.logical_and.reduce([mask, *turned])


class Studio(CliTest):
    def relievo(self, *words, environment=None, **more):
        return super().relievo(*words, environment={**STUDIO, **(environment or {})}, **more)

    def write(self, name, source, writer=vtkOBJWriter):
        output = writer()
        output.SetFileName(str(self.folder / name))
        source.Update()
        source.GetOutput().GetPointData().SetTCoords(None)  # which VTK 9.2's writer counts wrongly
        output.SetInputData(source.GetOutput())
        output.Write()

    def box(self, name, low, high, writer=vtkOBJWriter):
        cube = vtkCubeSource()
        cube.SetBounds(*(x for pair in zip(low, high) for x in pair))
        self.write(name, cube, writer)

    def sphere(self, name):
        ball = vtkSphereSource()
        ball.SetRadius(2)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(64)
        self.write(name, ball)

    def picture(self, *words, size=SIZE, **more):
        done = self.relievo("render", *words, *size, "--png", "a.png", **more)
        self.assertEqual(done.stderr, "")
        return read_png(self.folder / "a.png")[..., :3].astype(int)

    def seen(self, *words, size=SIZE):
        """Where the model is in the picture, and the EXR's layers."""
        done = self.relievo("render", *words, *size, "--exr", "a.exr", "--layers", "depth,actor")
        self.assertEqual(done.stderr, "")
        layers = self.exr("a.exr")[1]
        return numpy.isfinite(layers["depth.Z"]), layers

    def both(self, *words, size=SIZE):
        """Where the model is, and the picture, by one run."""
        model, _ = self.seen(*words, "--png", "a.png", size=size)
        return model, read_png(self.folder / "a.png")[..., :3].astype(int)

    def test_names(self):
        self.sphere("ball.obj")
        plain = self.picture("ball.obj", *COARSE, size=SMALL)
        for words, environment in (
            (["--preset", "studio"], {"RELIEVO_PRESET": "print"}),
            ([], {"RELIEVO_PRESET": "studio"}),
        ):
            numpy.testing.assert_array_equal(
                self.picture("ball.obj", *words, *COARSE, environment=environment, size=SMALL),
                plain)  # fmt: skip
        bare = self.picture("ball.obj", "--preset", "none", size=SMALL)
        self.assertEqual(tuple(bare[0, 0]), (0, 0, 0))
        numpy.testing.assert_array_equal(
            self.picture("ball.obj", environment={"RELIEVO_PRESET": "none"}, size=SMALL),
            bare)  # fmt: skip
        done = self.relievo("render", "ball.obj", "--png", "b.png", status=2,
                            environment={"RELIEVO_PRESET": "desert"})  # fmt: skip
        for word in ("RELIEVO_PRESET", "desert", "none", "studio", "town", "print"):
            self.assertIn(word, done.stderr)

    def test_no_side_is_black_or_burnt(self):
        """The darkest side has at least 0.35 of the lightest one's light, and none is white."""
        self.sphere("ball.obj")
        for preset in ("studio", "town", "print"):
            lights = []
            for x, y, z in SIDES:
                words = ["ball.obj", "--camera", f"{9 * x},{9 * y},{9 * z},0,0,0,0,1,0",
                         "--preset", preset, "--up", "y", "--ground", "off",
                         *([] if preset == "print" else COARSE)]  # fmt: skip
                model, picture = self.both(*words, size=SMALL)
                inner = shrunk(model)
                light = picture.max(axis=-1)[inner]
                with self.subTest(preset=preset, side=(x, y, z)):
                    self.assertGreater(inner.sum(), 700)
                    self.assertLess(light.max(), 255)
                shares = ((picture[inner] / 255 + 0.055) / 1.055) ** 2.4
                lights.append(shares @ (0.2126, 0.7152, 0.0722))
            lights = numpy.concatenate(lights)
            self.assertGreater(lights.min(), 0.35 * lights.max(), preset)

    def test_ground_beyond_the_casters(self):
        """Soft shadows of all samples at once leave ground lit that is beyond the sun's map."""
        self.box("pole.obj", (-0.5, 0, -0.5), (0.5, 5, 0.5))
        pictures = []
        for words in ([], ["--stage", "antialias:samples=1"]):  # samples one by one
            self.relievo("render", "pole.obj", "--preset", "studio", "--size", "160x120",
                         "--camera", "20,20,20,2,0,0,0,1,0", *words, "--png", "a.png")
            pictures.append(read_png(self.folder / "a.png")[:, 100:, :3].astype(int))
        self.assertLessEqual(numpy.abs(pictures[0] - pictures[1]).max(), 3)

    def test_contact(self):
        """The foot of a pole is darker than its top, on the side that the first light misses; not
        where the fill's occlusion is off."""
        self.box("pole.obj", (-0.5, 0, -0.5), (0.5, 5, 0.5))
        shades = []
        for words in (["--stage", "fill:occlusion=1"], ["--stage", "fill:occlusion=0"]):
            picture = self.picture(
                "pole.obj", "--camera", "20,2.5,0,0,2.5,0,0,1,0", "--parallel-scale", 3,
                "--up", "y", "--light", "sun:-1,0.5,0", "--fill", 1, "--shadows", "off",
                *words)  # fmt: skip
            column = picture[:, 120].mean(axis=-1)  # 30 pixels a unit, the top at row 15
            shades.append((column[158:163].mean(), column[30:60].mean()))
        (foot, top), (foot_off, top_off) = shades
        self.assertLess(foot, top - 3)
        self.assertLess(abs(foot_off - top_off), 2)
        # Rays that darken nothing do not switch it off.
        self.box("slab.obj", (-2, -0.2, -2), (2, 0, 2))
        pictures = []
        for stage in ("fill", "ambient:enabled=on,strength=0", "fill:occlusion=0"):
            self.relievo("render", "pole.obj", "slab.obj", "--shadows", "off", "--ground", "off",
                         "--stage", stage, *SMALL, "--png", "a.png")  # fmt: skip
            pictures.append(read_png(self.folder / "a.png"))
        numpy.testing.assert_array_equal(pictures[0], pictures[1])
        self.assertGreater(abs(pictures[0].astype(int) - pictures[2]).max(), 3)
        # The ground keeps its own shade while that stage serves a layer.
        pictures = []
        for words in ([], ["--stage", "ambient:radius=2"]):
            self.relievo("render", "pole.obj", "--preset", "studio", *words, *SMALL,
                         "--png", "a.png")  # fmt: skip
            pictures.append(read_png(self.folder / "a.png"))
        numpy.testing.assert_array_equal(*pictures)

    def test_values_are_readable(self):
        """Light leaves the hue of values' colours and 0.7 of their lightness, from all sides."""
        ball = vtkSphereSource()
        ball.SetRadius(2)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(64)
        ball.Update()
        data = ball.GetOutput()
        heights = vtk_to_numpy(data.GetPoints().GetData())[:, 1].copy()
        array = numpy_to_vtk(heights, deep=True)
        array.SetName("height")
        data.GetPointData().AddArray(array)
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        writer.SetFileName(str(self.folder / "ball.vtp"))
        writer.SetInputData(data)
        writer.Write()
        for preset, colormap, (x, y, z) in (
            ("studio", "viridis", SIDES[0]), ("studio", "rainbow", SIDES[3]),
            ("town", "cool-warm", SIDES[1]), ("print", "viridis", SIDES[4]),
        ):  # fmt: skip
            self.relievo(
                "render", "ball.vtp", "--camera", f"{9 * x},{9 * y},{9 * z},0,0,0,0,1,0", "--up",
                "y", "--color-by", "height", "--colormap", colormap, "--preset", preset, *SMALL,
                "--ground", "off", "--layers", "albedo,depth", "--exr", "a.exr", "--png", "a.png",
                "--stage", "antialias:samples=1")  # fmt: skip
            layers = self.exr("a.exr")[1]
            inner = shrunk(numpy.isfinite(layers["depth.Z"]))
            bar = oklab(numpy.stack([layers[f"albedo.{c}"] for c in "RGB"], axis=-1)[inner])
            shown = oklab(read_png(self.folder / "a.png")[inner] / 255.0)
            with self.subTest(preset=preset, colormap=colormap):
                self.assertGreater(inner.sum(), 700)
                kept = shown[:, 0] / bar[:, 0]
                self.assertGreater(kept.min(), 0.7)
                self.assertLess(kept.max(), 1.06)
                self.assertGreater(numpy.ptp(kept), 0.05)  # the shape still shows
                hues = [numpy.arctan2(each[:, 2], each[:, 1]) for each in (bar, shown)]
                turn = abs((hues[1] - hues[0] + numpy.pi) % (2 * numpy.pi) - numpy.pi)
                colorful = numpy.hypot(bar[:, 1], bar[:, 2]) > 0.05
                self.assertLess(numpy.degrees(turn[colorful]).max(), 8)

    def test_light_that_is_added(self):
        """Is filled, casts its shadow on the ground, and burns little."""
        self.sphere("ball.obj")
        for light in ("sun:1,2,2", "spot:4,8,8,0,0,0,30", "point:4,8,8"):
            words = ["ball.obj", "--light", light, "--camera", "0,3,12,0,0,0,0,1,0"]
            model, lit = self.both(*words, *COARSE, size=SMALL)
            with self.subTest(light=light):
                inner = shrunk(model)
                self.assertLess((lit.max(axis=-1)[inner] == 255).mean(), 0.02)
                self.assertGreater(lit.max(axis=-1)[inner].min(), 15)
                without = self.picture(*words, "--shadows", "off", size=SMALL)
                darker = (without - lit).max(axis=-1)[~model] > 40
                self.assertGreater(darker.sum(), 25, "no shadow on the ground")

    def test_fill(self):
        """Its share of the light where no other light reaches; the default's description."""
        self.sphere("ball.obj")
        words = ["ball.obj", "--camera", "0,3,12,0,0,0,0,1,0", "--ground", "off", *COARSE]
        for light in ([], ["--light", "sun:-1,0.2,-1"]):
            lit = {f: self.picture(*words, *light, "--fill", f, size=SMALL)
                   for f in ("0", "0.4", "0.5", "1")}  # fmt: skip
            shade = self.seen(*words, size=SMALL)[0] & (lit["0"].max(axis=-1) == 0)
            self.assertGreater(shade.sum(), 250)
            self.assertGreater(lit["1"][shade].min(), 20)
            for share in ("0.4", "0.5"):
                numpy.testing.assert_allclose(
                    lit[share][shade], float(share) * lit["1"][shade], atol=1)  # fmt: skip
            numpy.testing.assert_array_equal(
                self.picture(*words, *light, size=SMALL), lit["0.4" if light else "1"])  # fmt: skip

    def test_ground(self):
        """Below the model, in the picture alone, and not to be told from the background but for
        the shadow: it has no edge."""
        self.sphere("ball.obj")
        without = self.picture("ball.obj", *COARSE, "--ground", "off")
        model, ground = self.both("ball.obj", *COARSE)
        unlit = self.picture("ball.obj", "--shadows", "off")
        free = shrunk(~model) & (abs(unlit - ground).max(axis=-1) == 0)
        self.assertGreater(abs(ground - without).max(), 50)
        steps = abs(numpy.diff(unlit, axis=0)).max(axis=-1)
        self.assertLess(steps[free[1:] & free[:-1]].max(), 8)
        layers = [self.seen("ball.obj", *COARSE, "--ground", word)[1] for word in ("on", "off")]
        for name in ("depth.Z", "actor.id"):
            numpy.testing.assert_array_equal(layers[0][name], layers[1][name])
        below = ["ball.obj", *COARSE, "--camera", "0,-9,3,0,0,0,0,1,0"]
        self.assertLess(
            abs(self.picture(*below) - self.picture(*below, "--ground", "off")).max(), 5)
        self.box("flat.obj", (0, 0, 0), (2, 1, 0))
        numpy.testing.assert_array_equal(
            self.picture("flat.obj", *COARSE),
            self.picture("flat.obj", *COARSE, "--ground", "off"))  # fmt: skip

    def test_contact_of_a_pole(self):
        """Around a thin round pole the ground is equally dark in all directions."""
        pole = vtkCylinderSource()
        pole.SetRadius(0.25)
        pole.SetHeight(4)
        pole.SetResolution(64)
        self.write("pole.obj", pole)
        picture = self.picture(
            "pole.obj", "--camera", "0,20,0,0,0,0,0,0,-1", "--parallel-scale", 2.25, "--shadows",
            "off", "--up", "y", "--background", "white").mean(axis=-1)  # fmt: skip
        right, down = numpy.meshgrid(
            (numpy.arange(240) - 119.5) / 40, (numpy.arange(180) - 89.5) / 40)  # fmt: skip
        away = numpy.hypot(right, down)
        rings = [picture[abs(away - radius) < 0.02] for radius in numpy.arange(0.6, 2.2, 0.1)]
        self.assertLess(rings[0].mean(), picture[away > 2.2].mean() - 8)
        self.assertLess(max(ring.std() for ring in rings), 1.2)

    def test_ground_over_a_gradient(self):
        """Far from the model the ground has the background's colour behind it: it has no edge."""
        self.sphere("ball.obj")
        camera = ["--camera", "0,6,20,0,2,0,0,1,0"]
        for preset in ("studio", "town"):
            seen, without = (self.picture("ball.obj", *COARSE, *camera, "--preset", preset,
                                          "--ground", word) for word in ("on", "off"))  # fmt: skip
            # A ball's share of the sky at its radius' fivefold is 1 / 125, half of which counts.
            far = abs(seen - without)[:60, :40]
            self.assertLessEqual(far.max(), 2, preset)
            self.assertGreater(abs(seen - without).max(), 20, preset)
        # Its rim is no ring: VTK's translucent pass darkens surfaces of less than 1 % opacity.
        done = self.relievo("render", "ball.obj", *COARSE, *camera, "--hdr", "--layers", "color",
                            "--exr", "a.exr", "--size", "160x120")  # fmt: skip
        self.assertEqual(done.stderr, "")
        shown = 255 * self.exr("a.exr")[1]["G"][:, :20].astype(float) ** (1 / 2.2)
        dip = (shown[:-4] + shown[4:]) / 2 - shown[2:-2]
        self.assertLess(dip.max(), 0.2)

    def test_night(self):
        """The sky becomes dark as the sun sets, by its elevation alone; paper stays white. On the
        equator, at an equinox, the sun sinks by 15 degrees an hour, from 18:07 on below the
        horizon."""
        self.sphere("ball.obj")

        def sky(preset, time, *more):
            sun = f"sun:2026-03-20T{time}Z,0,0"
            done = self.relievo("render", "ball.obj", "--ground", "off", "--preset", preset,
                                "--light", sun, *SMALL, "--stage", "antialias:samples=1",
                                *([] if preset == "print" else COARSE), "--png", "a.png",
                                *more)  # fmt: skip
            self.assertEqual("night" in done.stderr, time > "18:07")
            return read_png(self.folder / "a.png")[..., :3].astype(int)

        for preset in ("studio", "town"):
            pictures = [sky(preset, time) for time in ("14:00", "18:05", "18:32", "19:30")]
            corners = [picture[[0, -1], 0].mean() for picture in pictures]
            for lighter, darker in zip(corners, corners[1:]):
                self.assertGreater(lighter, 1.2 * darker)
            self.assertLess(corners[-1], 32)
            numpy.testing.assert_array_equal(pictures[-1], sky(preset, "23:00"))
            self.assertGreater(pictures[-1].max(), 40)  # the fill lights show the ball
        numpy.testing.assert_array_equal(sky("print", "19:30")[0, 0], 255)
        white = sky("town", "19:30", "--background", "white")
        numpy.testing.assert_array_equal(white[0, 0], 255)

    def test_ground_in_all_light(self):
        """Its brightness is the share of the unobstructed light that arrives; lamps add to it. A
        ball stands on it, and is seen from above."""
        self.sphere("ball.obj")
        paint = numpy.array([204, 209, 217])  # of studio
        right, down = numpy.meshgrid(
            (numpy.arange(120) - 59.5) / 10, (numpy.arange(90) - 44.5) / 10)  # fmt: skip
        ground = numpy.stack([right, numpy.full_like(right, -2), down], axis=-1)
        away = numpy.hypot(right, down)
        place = (away > 2.1) & (away < 3.9)  # farther out it fades, from 1.2 times the box's radius
        # The sky that a ball hides from the ground that it stands on: r^3 / d^3, by its solid
        # angle's form factor (M. Modest, Radiative Heat Transfer, 2013, configuration 11).
        far = numpy.sqrt(away**2 + 4)
        sky = 1.0 - (2 / far) ** 3

        def darkened(share, direct):
            """The displayed share where a part of the sky is hidden: in linear light, that part of
            all light but the casting lights' is missing."""
            return (share**2.2 - (1 - sky) * (share**2.2 - direct**2.2)) ** (1 / 2.2)

        def picture(*words):
            return self.picture(
                "ball.obj", "--camera", "0,20,0,0,0,0,0,0,-1", "--parallel-scale", 4.5, *words,
                "--preset", "studio", "--background", "#ccd1d9", size=SMALL)  # fmt: skip

        def compare(share, *words, others=0.0, where=place, step=6.0):
            """The share of the light: 0.6 of it can be blocked, and the rest is in shadows, too;
            and the share of lights that cast none."""
            expected = paint * darkened(0.4 + 0.6 * share, 0.6 * (share - others))[..., None]
            off = picture(*words) - expected
            self.assertLess(abs(off[where]).max(), step, words)
            self.assertLess(abs(off[where & (away < 2.6)].mean()), 2.0, words)

        def lit(position, intensity):
            """The light of a lamp at each place, and whether the ball is safely in its way."""
            to = numpy.array(position) - ground
            length = numpy.linalg.norm(to, axis=-1)
            past = numpy.linalg.norm(numpy.cross(ground, to), axis=-1) / length
            return intensity * to[..., 1] / length, past < 1.9, past > 2.1

        # A spot at the sky changes nothing, however bright; nor does one from below.
        for intensity in (0.01, 1, 4):
            compare(numpy.ones_like(away), "--light",
                    f"spot:0,3,0,0,9,0,30,intensity={intensity}", others=1.0)
        compare(numpy.ones_like(away), "--light", "sun:0.3,-1,0.2", others=1.0)
        # Of the fill lights two are above the ground; rays through the triangles darken it alike.
        # No shadow is seen of a sun straight behind the camera, but it is no fill light.
        fill = 0.4 * 2 / numpy.sqrt(3) * 0.54
        for sun, words, step in (("0.001,1,0", [], 6), ("0,1,0", [], 6),
                                 ("0,1,0", ["--soft-shadows", "0"], 6),
                                 ("0,1,0", ["--soft-shadows", "0", "--ambient", "1"],
                                  14)):  # rays are noisy
            compare(numpy.ones_like(away), "--light", f"sun:{sun}", *words,
                    others=fill / (fill + 0.78), step=step)
        # Two points of which the ball hides one, here and there.
        first, dark, bright = lit((4, 3, 0), 1.0)
        second, other, unhidden = lit((-6, 9, 1), 0.5)
        words = ["--light", "point:4,3,0", "--light", "point:-6,9,1,intensity=0.5", "--fill", 0]
        share = numpy.where(dark, 0.0, first) + numpy.where(other, 0.0, second)
        sure = place & (dark | bright) & (other | unhidden)
        self.assertGreater(min((sure & dark).sum(), (sure & other).sum()), 100)
        compare(share / (first + second), *words, where=sure)
        # Out of a spot's cone all light is the other's.
        words[1] = "spot:4,3,0,0,0,0,20"
        axis, ray = -numpy.array([4, 3, 0]) / 5, ground - (4, 3, 0)
        within = numpy.degrees(numpy.arccos(ray @ axis / numpy.linalg.norm(ray, axis=-1)))
        out = sure & (within > 21) & ~other
        self.assertGreater((out & dark).sum(), 50)
        compare(numpy.ones_like(away), *words, where=out)

        def linear(levels):
            return ((levels / 255 + 0.055) / 1.055) ** 2.4

        even = numpy.full((4, 8, 3), 90, numpy.uint8)
        image = vtkImageData()
        image.SetDimensions(8, 4, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(even.reshape(-1, 3), deep=True))
        writer = vtkPNGWriter()
        writer.SetFileName(str(self.folder / "even.png"))
        writer.SetInputData(image)
        writer.Write()
        dim = ["--shadows", "off", "--ambient"]
        environment = ["--environment", "even.png", "--fill", 0, "--shadows", "off"]
        for words, left in ([*dim, 0.5], 0.5 + 0.5 * sky), (environment, sky):
            found = linear(picture(*words)) / linear(paint)
            rms = numpy.sqrt(((found.mean(axis=-1) - left)[place] ** 2).mean())
            self.assertLess(rms, 1 / 32, words)

        # A lamp's light is added to that.
        (self.folder / "lamp.vtk").write_text(
            "# vtk DataFile Version 3.0\nlamp\nASCII\nDATASET POLYDATA\n"
            "POINTS 1 double\n-3 0 0\n")  # fmt: skip
        to = numpy.array([-3, 0, 0]) - ground
        length = numpy.linalg.norm(to, axis=-1)
        added = numpy.clip(1 - length / 5, 0, None) * to[..., 1] / length
        plain = paint * darkened(1.0, 0.5)[..., None]
        for words, left, paint_ in ([], 1.0, plain), (["--ambient", "1"], sky, paint):
            lamp = ["--shadows", "off", "--lamps", "lamp.vtk,radius=5,intensity=0.3"]
            found = picture(*lamp, *words)
            expected = linear(paint_) * numpy.clip(left + 0.3 * added, 0, None)[..., None]
            shown = numpy.clip(1.055 * expected ** (1 / 2.4) - 0.055, 0, 1) * 255
            off = abs(found - shown)[place]
            self.assertLess(numpy.sqrt((off**2).mean()), 3 if not words else 6, words)

    def test_speckle(self):
        """The default picture has no pixel that stands out from one whose shadows are exact."""
        data = os.environ.get("RELIEVO_DATA", "")
        mesh = os.path.join(data, "bunny.off")
        if not os.path.exists(mesh):
            self.skipTest("no bunny.off in RELIEVO_DATA")
        pictures = []
        for words in ([], ["--shadows", "exact", "--soft-shadows", "24"]):
            self.relievo("render", mesh, *words, "--size", "320x240", "--png", "a.png")
            pictures.append(read_png(self.folder / "a.png")[..., :3].astype(int))
        different = abs(pictures[0] - pictures[1]).max(axis=-1)
        self.assertGreater((different > 0).sum(), 25)  # they are two methods
        # Both are up to 0.08 from the picture of 256 samples, where their own lie otherwise.
        self.assertEqual((different > 0.12 * 255).sum(), 0)

    def test_grid(self):
        """Behind the model and beside it, in black or white, whatever the size; layers, camera and
        ground stay as they are."""
        self.sphere("ball.obj")
        camera = ["--camera", "5,4,12,0,0,0,0,1,0"]
        for words in (COARSE, ["--preset", "none"],
                      ["--preset", "print", "--parallel-scale", "4"],
                      [*camera, "--shadows", "exact", "--colored-shadows"]):  # fmt: skip
            with self.subTest(words=words):
                without, grid = (self.picture("ball.obj", *words, *more)
                                 for more in ([], ["--grid"]))  # fmt: skip
                apart = grid - without
                model, _ = self.seen("ball.obj", *words)
                # Where lines are drawn, samples lie elsewhere in pixels and on the sun.
                self.assertLessEqual(abs(apart)[shrunk(model)].max(), 3)
                apart = numpy.where((shrunk(model) | shrunk(~model))[..., None], apart, 0)
                seen = abs(apart).max(axis=-1) > 12  # which soft shadows do not differ by
                self.assertGreater(seen.mean(), 0.04)
                self.assertGreater(abs(apart).max(), 120)
                self.assertEqual((apart > 24).any(), "none" in words)  # white, and only there
                self.assertEqual((apart < -24).any(), "none" not in words)
                rows, columns = numpy.nonzero(seen)
                self.assertGreater(min(rows.min(), 179 - rows.max()), 0)  # numbers are whole
                self.assertGreater(min(columns.min(), 239 - columns.max()), 0)
                layers = []
                for more in ([], ["--grid"]):
                    self.relievo("render", "ball.obj", *words, *more, *SIZE, "--exr", "a.exr",
                                 "--layers", "depth,actor,normal,shadow_0")  # fmt: skip
                    layers.append(self.exr("a.exr")[1])
                self.assertIn("shadow_0.V", layers[0])
                for name in sorted(set(layers[0]) - set("RGBA")):
                    numpy.testing.assert_array_equal(layers[0][name], layers[1][name], name)

    def test_grid_numbers(self):
        """Lines through round coordinates: those of a plane where its corners say they are."""
        self.box("flat.obj", (0, 0, -1), (40, 30, 0))
        words = ["flat.obj", "--preset", "none", "--parallel-scale", "18",
                 "--camera", "20,15,-50,20,15,0,0,1,0"]  # fmt: skip
        self.box("low.obj", (0, 0, -1), (40, 0.001, 0))
        words[0] = "low.obj"
        self.box("high.obj", (0, 30, -1), (40, 29.999, 0))
        picture = self.picture(*words, "high.obj", "--grid").max(axis=-1)
        inside = picture[40:140, :]
        columns = numpy.flatnonzero((inside > 20).mean(axis=0) > 0.9)
        expected = 120 - (numpy.arange(0, 41, 5) - 20) * 90 / 18  # x grows to the left
        self.assertEqual(len({int(numpy.argmin(abs(expected - c))) for c in columns}), 9)
        self.assertLess(max(abs(expected - c).min() for c in columns), 1.5)

    def test_scale_bar(self):
        """As long as 2 of the 8 units of the height, at the lower right alone, and in no layer."""
        self.sphere("ball.obj")
        for words, ink in (["--preset", "print"], 0), (["--preset", "none"], 255):
            words = ["ball.obj", *words, "--parallel-scale", "4"]
            without, bar = (self.picture(*words, *more) for more in ([], ["--scale-bar", "mm"]))
            apart = (without != bar).any(axis=2)
            self.assertFalse(apart[:150].any() or apart[:, :180].any())
            inked = (bar[150:] == ink).all(axis=2) & apart[150:]
            self.assertLessEqual(abs(inked.sum(axis=1).max() - 2 * 180 / 8), 1)
            # 1 of the 8 units of the height.
            short = self.picture(*words, "--scale-bar", "mm,length=1")
            inked = (short[150:] == ink).all(axis=2) & (without != short).any(axis=2)[150:]
            self.assertLessEqual(abs(inked.sum(axis=1).max() - 180 / 8), 1)
            number = self.picture(*words, "--scale-bar=none")
            self.assertTrue((number != bar).any())
            layers = []
            for more in ([], ["--scale-bar", "mm"]):
                self.relievo("render", *words, *more, *SIZE, "--exr", "a.exr",
                             "--layers", "depth,actor,normal")  # fmt: skip
                layers.append(self.exr("a.exr")[1])
            for name in sorted(set(layers[0]) - set("RGBA")):
                numpy.testing.assert_array_equal(layers[0][name], layers[1][name], name)

    def test_fits(self):
        """The model fills the picture in one direction, and keeps off its edges, whatever its shape
        and the projection."""
        shapes = ((1, 1, 1), (5, 1, 1), (1, 6, 1), (1, 1, 9), (4, 0.3, 4), (3, 8, 0.5))
        for shape in shapes:
            self.box("a.obj", (0.5, 0.5, 0.5), numpy.add(shape, 0.5))
            for words in ([], ["--view-angle", "80"], ["--up", "x"]):
                model, _ = self.seen("a.obj", *words)
                rows, columns = numpy.nonzero(model)
                filled = max(numpy.ptp(rows) / 180, numpy.ptp(columns) / 240)
                with self.subTest(shape=shape, words=words):
                    # The camera stays outside of it, also where it would be seen larger within.
                    self.assertGreater(filled, 0.5 if "80" in words else 0.7)
                    self.assertLess(filled, 0.9)
                    self.assertGreater(min(rows.min(), 179 - rows.max()), 8)
                    self.assertGreater(min(columns.min(), 239 - columns.max()), 8)

    def test_three_sides_of_a_box(self):
        self.box("a.obj", (-1, -1, -1), (1, 1, 1))
        self.relievo("render", "a.obj", *SIZE, "--exr", "a.exr", "--layers", "geometric_normal")
        layers = self.exr("a.exr")[1]
        normal = numpy.stack([layers[f"geometric_normal.{c}"] for c in "XYZ"], axis=-1).round()
        for side in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
            self.assertGreater((normal == side).all(axis=-1).sum(), 1000)

    def test_up(self):
        """A pole stands upright if it stands on z = 0, in STL, and in a grid; else y is up."""
        def upright(name, *words):
            rows, columns = numpy.nonzero(self.seen(name, *words)[0])
            return numpy.ptp(rows) > 1.5 * numpy.ptp(columns)

        self.box("z.obj", (2, 3, 0), (3, 4, 6))
        self.box("y.obj", (2, 0, 3), (3, 6, 4))
        self.box("middle.obj", (-0.5, -3, -0.5), (0.5, 3, 0.5))
        self.box("middle.stl", (-0.5, -0.5, -3), (0.5, 0.5, 3), vtkSTLWriter)
        self.box("y.stl", (-0.5, 0, -0.5), (0.5, 6, 0.5), vtkSTLWriter)
        image = vtkImageData()
        image.SetDimensions(2, 2, 7)
        image.SetOrigin(1, 1, 1)
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(self.folder / "grid.vti"))
        writer.SetInputData(image)
        writer.Write()
        for name in ("z.obj", "y.obj", "middle.obj", "middle.stl", "y.stl", "grid.vti"):
            with self.subTest(name):
                self.assertTrue(upright(name))
        # A terrain with its corner at the origin lies; a relief that stands over the origin stands.
        def lies(name):
            rows, columns = numpy.nonzero(self.seen(name)[0])
            return numpy.ptp(rows) < 0.6 * numpy.ptp(columns)

        self.box("corner.stl", (0, 0, 100), (2000, 2000, 340), vtkSTLWriter)
        self.box("aside.stl", (10, 10, 100), (2010, 2010, 340), vtkSTLWriter)
        self.box("relief.stl", (-1000, 0, 100), (1000, 2000, 340), vtkSTLWriter)
        self.assertTrue(lies("corner.stl") and lies("aside.stl") and not lies("relief.stl"))
        self.assertFalse(upright("z.obj", "--up", "y"))
        self.assertFalse(upright("z.obj", "--preset", "none"))

    def test_lights_of_the_file(self):
        """Are in the place of the usual preset's, not of one that is asked for."""
        data = numpy.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0)], "<f4").tobytes()
        (self.folder / "a.bin").write_bytes(data)
        (self.folder / "a.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [
                {"type": "directional", "color": [0, 1, 0], "intensity": 1}]}},
            "scenes": [{"nodes": [0, 1]}], "scene": 0,
            "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "buffers": [{"uri": "a.bin", "byteLength": 36}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [-1, -1, 0], "max": [1, 1, 0]}],
        }))  # fmt: skip
        model, _ = self.seen("a.gltf")
        inner = shrunk(model)
        own, asked = (self.picture("a.gltf", *COARSE, *words)[inner]
                      for words in ([], ["--preset", "studio"]))  # fmt: skip
        self.assertEqual(own[:, [0, 2]].max(), 0)
        self.assertGreater(own[:, 1].min(), 60)
        self.assertGreater(asked.min(), 40)
        # In daylight the exposure is that of a sun that makes white of white, pi lux.
        text = (self.folder / "a.gltf").read_text()
        pictures = []
        shown = (2e4 / numpy.pi) ** (1 / 2.2)  # by VTK's PBR, which the frame takes as sRGB
        stops = -numpy.log2(((shown + 0.055) / 1.055) ** 2.4)
        for lux in (numpy.pi, 2e4):
            lit = text.replace('"intensity": 1', f'"intensity": {lux}')
            (self.folder / "a.gltf").write_text(lit)
            done = self.relievo("render", "a.gltf", *COARSE, *SIZE, "--png", "a.png")
            self.assertEqual(f"with --exposure {stops:.3g}," in done.stderr, lux > 4, done.stderr)
            pictures.append(read_png(self.folder / "a.png")[inner].astype(int))
        self.assertLess(pictures[0].min(axis=0)[1], 230)
        # Darker places by the power 2.4 / 2.2 of VTK's code and sRGB's.
        self.assertLess(numpy.abs(pictures[0] - pictures[1]).max(), 10)
        done = self.relievo("render", "a.gltf", *COARSE, *SIZE, "--exposure", 0, "--png", "a.png")
        self.assertEqual(done.stderr, "")
        self.assertEqual(read_png(self.folder / "a.png")[inner][:, 1].min(), 255)

    def test_edges(self):
        """Are smooth: around a ball there are many shades between it and the background."""
        self.sphere("ball.obj")
        shades = []
        for words in ([], ["--stage", "antialias:samples=1"]):
            done = self.relievo("render", "ball.obj", "--background", "black", "--ground", "off",
                                *COARSE, *SIZE, "--png", "a.png", *words)  # fmt: skip
            del done  # which notes that one sample smooths nothing
            shades.append(len(numpy.unique(read_png(self.folder / "a.png")[..., 0])))
        self.assertLess(shades[1] + 20, shades[0])


if __name__ == "__main__":
    main()
