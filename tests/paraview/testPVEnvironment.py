# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view's environment: background, reflections and light, compared with the truth."""

import materialScene
import numpy
import pv
import relievo
from materialScene import AXES, LIGHT, lean
from paraview import simple

# The colours seen along the world's +x, -x, +y, -y, +z, -z, by the axis that is up: the picture's
# y is there; z up keeps x and looks along -z to +y, x up keeps z and looks along -x to +y.
RED, CYAN, GREEN, MAGENTA, BLUE, YELLOW = AXES
BY_UP = {
    "X": (GREEN, MAGENTA, CYAN, RED, BLUE, YELLOW),
    "Y": tuple(AXES),
    "Z": (RED, CYAN, YELLOW, BLUE, GREEN, MAGENTA),
}
DIRECTIONS = [sign * axis for axis in numpy.eye(3) for sign in (1.0, -1.0)]


def write_hdr(name, upper, lower):
    """A Radiance file, equirectangular: the light of its upper and its lower half."""

    def code(light):
        exponent = int(numpy.frexp(max(light))[1])
        return bytes([*(int(each * 2.0 ** (8 - exponent)) for each in light), exponent + 128])

    path = pv.OUTPUT / name
    header = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n"
    path.write_bytes(header + code(upper) * 64 + code(lower) * 64)
    return str(path)


class Environment(pv.PluginTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.axes = materialScene.write_axes("axes.png")

    def setUp(self):
        super().setUp()
        self.scene = materialScene.Scene()
        self.view, self.shown = self.scene.view, self.scene.shown
        self.own = pv.picture(self.view)

    def sees(self, color, what, level=1):
        """The colour in the middle of the picture."""
        found = self.scene.middle()[0]
        off = numpy.abs(found - numpy.asarray(color, float)).max()
        self.assertLessEqual(off, level, f"{what}: {found}, expected {color}")

    def look_along(self, direction):
        self.view.CameraPosition = [0.0, 0.0, 0.0]
        self.view.CameraFocalPoint = list(direction)
        self.view.CameraViewUp = [0.0, 1.0, 0.0] if direction[2] else [0.0, 0.0, 1.0]

    def test_sky(self):
        """All six directions, with each axis up, turned; behind everything; and away again."""
        self.view.RelievoEnvironment = self.axes
        self.same(pv.picture(self.view), self.own, "neither shown nor mirrored")
        self.view.RelievoSkybox = 1
        seen = pv.picture(self.view)
        square = self.own.any(axis=2)
        self.same(seen * square[..., None], self.own, "the square in front")
        self.assertTrue((seen[~square] == MAGENTA).all(), "the sky around it")
        self.shown.Visibility = 0
        for up, colors in BY_UP.items():
            self.view.RelievoEnvironmentUp = up
            for direction, color in zip(DIRECTIONS, colors):
                self.look_along(direction)
                self.sees(color, f"{up} up, along {direction}", level=0)
        self.view.RelievoEnvironmentUp, self.view.RelievoEnvironmentRotation = "Z", 90.0
        self.look_along((1.0, 0.0, 0.0))
        self.sees(BLUE, "turned: what was along -y")
        self.view.RelievoEnvironmentRotation, self.view.RelievoSkybox = 0.0, 0
        self.shown.Visibility = 1
        self.scene.look()
        self.same(pv.picture(self.view), self.own, "off")

    def test_mirror(self):
        """A perfect mirror, seen from above, level and leaning by 45 degrees to all sides."""
        self.view.RelievoEnvironment = self.axes
        self.shown.RelievoMaterial = self.shown.RelievoMirror = 1
        self.shown.RelievoReflectivity = 1.0
        self.sees(GREEN, "level", level=0)
        for degrees, color in ((0, RED), (90, YELLOW), (180, CYAN), (270, BLUE)):
            name = materialScene.write_normals(f"lean{degrees}.png", lean(45, degrees))
            self.shown.RelievoNormalMap = name
            self.sees(color, f"leaning to {degrees} degrees", level=0)
        self.shown.RelievoReflectionWeight, self.shown.RelievoIrradianceWeight = 0.0, 0.0
        self.shown.RelievoNormalMap = ""
        self.near(pv.picture(self.view), self.own, "no share", share=0.0)
        self.shown.RelievoMirror = 0
        self.same(pv.picture(self.view), self.own, "off")

    def test_light_of_files(self):
        """Integers are sRGB, floats linear; the upper rows are above; irradiance lights."""
        grey = numpy.full((8, 16, 3), 128)
        pv.write(pv.OUTPUT / "grey.png", grey)
        self.view.RelievoSkybox = 1
        self.shown.Visibility = 0
        self.view.RelievoEnvironment = str(pv.OUTPUT / "grey.png")
        linear = ((128 / 255 + 0.055) / 1.055) ** 2.4
        self.sees([255 * linear ** (1 / 2.2)] * 3, "bytes")
        self.view.RelievoEnvironmentGammaCorrect = 0
        self.sees([255 * linear] * 3, "bytes, shown as light")
        self.view.RelievoEnvironmentIntensity = 2.0
        self.sees([510 * linear] * 3, "twice as bright")
        self.view.RelievoEnvironmentIntensity = 1.0
        self.view.RelievoEnvironment = write_hdr("halves.hdr", (0.5, 0.25, 0.0), (0.0, 0.125, 0.75))
        for direction, color in (((0, 0, 1), (0.5, 0.25, 0.0)), ((0, 0, -1), (0.0, 0.125, 0.75))):
            self.look_along([float(each) for each in direction])
            self.sees(numpy.multiply(color, 255), f"floats, along {direction}")

        self.view.RelievoEnvironment = write_hdr("even.hdr", (0.125, 0.125, 0.125), (0.125,) * 3)
        self.view.RelievoSkybox = 0
        self.scene.look()
        self.shown.Visibility = 1
        self.shown.RelievoMaterial = self.shown.RelievoMirror = 1
        self.shown.RelievoReflectivity = 0.0
        self.sees([255 * (LIGHT + 0.125)] * 3, "irradiance")
        self.shown.RelievoIrradianceWeight = 0.5
        self.sees([255 * (LIGHT + 0.0625)] * 3, "half of it")
        self.scene.lamp.Enable = 0
        self.sees([255 * 0.0625] * 3, "half of it, and no other light")
        self.shown.RelievoMirror = 0
        self.sees([255] * 3, "unlit, as ParaView has it")

    def test_levels_are_made_for_rough_mirrors(self):
        """A sharp mirror does not wait for them."""
        noise = numpy.random.default_rng(1).integers(0, 256, (128, 256, 3))
        pv.write(pv.OUTPUT / "noise.png", noise)
        self.view.RelievoEnvironment = str(pv.OUTPUT / "noise.png")
        self.shown.RelievoMaterial = self.shown.RelievoMirror = 1
        pv.picture(self.view)
        actors = self.view.SMProxy.GetRenderer().GetActors()
        materials = map(relievo.vtkRelievoMaterial.Get, actors)
        used = {material.GetEnvironment() for material in materials if material}
        (environment,) = used - {None}
        self.assertIsNone(environment.GetLevels())
        self.shown.RelievoRoughness = 0.3
        pv.picture(self.view)
        self.assertIsNotNone(environment.GetLevels())

    def test_goes_together(self):
        """With ParaView's own and Relievo's: the same cells selected; off, the first picture."""
        ball = self.scene.show(simple.Sphere(Radius=0.2, Center=[0.0, 0.0, 0.3]))
        self.view.CameraPosition = [1.0, -1.5, 1.2]
        self.view.UseLight = 1
        self.view.RelievoEnvironment = self.axes
        waves = numpy.sin(numpy.linspace(0, 6 * numpy.pi, 64))
        heights = 0.5 + 0.4 * waves[:, None] * waves[None, :]
        self.shown.RelievoHeightMap = materialScene.write_heights("waves.png", heights)
        self.shown.RelievoHeightScale, ball.RelievoReflectivity = 0.05, 0.6
        self.shown.RelievoMirror = ball.RelievoMirror = 1

        def switch(on):
            self.view.RelievoSkybox = self.shown.RelievoMaterial = ball.RelievoMaterial = on

        def cells():
            simple.ClearSelection()
            simple.SelectSurfaceCells(Rectangle=[60, 40, 180, 140], View=self.view)
            found = list(self.scene.square.GetSelectionInput(0).Input[0].IDs)
            simple.ClearSelection()
            return found

        own = cells()
        switch(1)
        pv.picture(self.view)
        self.assertEqual(cells(), own)
        for name, on, off in (
            ("UseFXAA", 1, 0), ("UseAmbientOcclusion", 1, 0), ("UseToneMapping", 1, 0),
            ("MultiSamples", 8, 0), ("HiddenLineRemoval", 1, 0), ("RelievoShadows", 1, 0),
            ("CameraParallelProjection", 1, 0), ("RelievoDisplayLayer", "normal", "None"),
        ):  # fmt: skip
            with self.subTest(name):
                switch(0)
                setattr(self.view, name, on)
                first = pv.picture(self.view)
                switch(1)
                self.differ(pv.picture(self.view), first, f"{name}: styled", share=0.1)
                switch(0)
                self.same(pv.picture(self.view), first, f"{name}: off again")
                setattr(self.view, name, off)

    def test_views_have_their_own(self):
        """Another view, with another file, beside this one; the file changes."""
        other = materialScene.Scene()
        magenta = pv.OUTPUT / "magenta.png"
        pv.write(magenta, numpy.broadcast_to(MAGENTA, (8, 16, 3)))
        for scene, name in ((self.scene, self.axes), (other, str(magenta))):
            scene.view.RelievoEnvironment = name
            scene.shown.RelievoMaterial = scene.shown.RelievoMirror = 1
            scene.shown.RelievoReflectivity = 1.0
        for _ in range(2):
            self.assertEqual(list(self.scene.middle()[0]), list(GREEN))
            self.assertEqual(list(other.middle()[0]), list(MAGENTA))
        other.view.RelievoEnvironment = self.axes
        self.assertEqual(list(other.middle()[0]), list(GREEN))
        other.view.RelievoEnvironment = ""
        self.same(other.middle()[1], self.own, "no environment any more")
        # Their windows share textures: none of this view's may be in use when the other is closed,
        # which VTK would tell.
        self.scene.middle()
        simple.Delete(other.view)


if __name__ == "__main__":
    pv.main()
