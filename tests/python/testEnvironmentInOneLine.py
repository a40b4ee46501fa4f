# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo.environment(): sky, mirror and light of pictures whose light is known."""

import pathlib
import tempfile
import unittest

import numpy
import relievo
import scenes
import srgb
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkCubeAxesActor
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkSkybox

SIZE = (90, 60)
COLORS = {"+x": (0.9, 0.1, 0.1), "-x": (0.1, 0.8, 0.1), "+z": (0.2, 0.2, 0.9), "-z": (0.7, 0.6, 0)}


def four_sides(rows=16):
    """A picture of all directions, row 0 at the top: each horizontal direction has a colour."""
    columns = 2 * rows
    side = ((numpy.arange(columns) + 0.5) / columns * 4 + 0.5).astype(int) % 4
    # From the left edge, which is -x: -z, +x, +z.
    order = numpy.array([COLORS["-x"], COLORS["-z"], COLORS["+x"], COLORS["+z"]])
    return numpy.broadcast_to(order[side], (rows, columns, 3)).astype(numpy.float32)


def encoded(light):
    return numpy.array(light) ** (1 / 2.2) * 255


class Environment(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.renderer = vtkRenderer()
        ball = vtkSphereSource()
        ball.SetThetaResolution(60)
        ball.SetPhiResolution(60)
        self.actor = scenes.add(self.renderer, ball)
        self.window = scenes.window_of(self.renderer, *SIZE)

    def look(self, towards, up=(0, 1, 0)):
        """The picture's bytes, (rows, columns, 3), row 0 at the top, seen from far outside."""
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(*(-4 * numpy.array(towards, float)))
        camera.SetViewUp(*up)
        self.renderer.ResetCameraClippingRange()
        color = relievo.layer(relievo.capture(self.renderer, ["color"]), "color")[..., :3]
        return 255 * srgb.encoded(color)

    def test_sky_lies_as_it_should(self):
        """In each direction its colour, at the right side of the picture; up stays up."""
        path = self.folder / "sides.exr"
        picture = four_sides()
        picture[: len(picture) // 3] = (0.05, 0.05, 0.4)  # the upper third is blue
        relievo.write_exr(path, relievo.to_image({"color": picture}))
        relievo.environment(self.renderer, path, roughness=0)
        for towards, name in (((1, 0, 0), "+x"), ((-1, 0, 0), "-x"), ((0, 0, 1), "+z"),
                              ((0, 0, -1), "-z")):  # fmt: skip
            numpy.testing.assert_allclose(self.look(towards)[30, 3], encoded(COLORS[name]), atol=2)
        up = self.look((0.3, 1, 0))
        numpy.testing.assert_allclose(up[3, 45], encoded((0.05, 0.05, 0.4)), atol=2)
        relievo.environment(self.renderer, path, up="z", roughness=0)
        numpy.testing.assert_allclose(
            self.look((0.3, 0, 1), (0, 0, 1))[3, 45], encoded((0.05, 0.05, 0.4)), atol=2)
        relievo.environment(self.renderer, path, rotation=90, roughness=0)
        numpy.testing.assert_allclose(self.look((1, 0, 0))[30, 3], encoded(COLORS["+z"]), atol=2)

    def test_tone(self):
        """An environment and a headlight burn a white ball out, but not with tone; None ends it."""
        self.actor.GetProperty().SetColor(1, 1, 1)
        before = self.look((0, 0, -1))
        light = numpy.ones((16, 32, 3), numpy.float32)
        relievo.environment(self.renderer, light, sky=False)
        self.assertGreater(self.look((0, 0, -1))[30, 45].min(), 254)
        relievo.environment(self.renderer, light, sky=False, tone=True)
        ball = relievo.screenshot(self.renderer)[20:40, 35:55]
        self.assertTrue((ball < 240).all() and (ball > 150).all())
        relievo.environment(self.renderer, None)
        numpy.testing.assert_array_equal(self.look((0, 0, -1)), before)
        # Tone that was on stays.
        tone = relievo.stage(self.renderer, "tone")
        relievo.environment(self.renderer, light, tone=True)
        relievo.environment(self.renderer, None)
        self.assertTrue(tone.GetEnabled())

    def test_constant_light(self):
        """In a furnace a white ball and a perfect mirror are as bright as the sky."""
        self.actor.GetProperty().SetColor(1, 1, 1)
        self.actor.GetProperty().SetAmbient(0)
        none = vtkLight()  # VTK has normals only with lights
        none.SetIntensity(0)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(none)
        for share in (0, 1):
            made = relievo.environment(
                self.renderer, relievo.to_image(numpy.full((16, 32, 3), 0.25, numpy.float32)),
                reflectivity=share, roughness=0.3 * share, intensity=2)
            self.assertEqual(made.GetIntensity(), 2)
            numpy.testing.assert_allclose(self.look((0, 0, -1)), encoded(0.5), atol=3)

    def test_without_lights(self):
        """Where no light is on, the environment's is all there is; others count as ever."""
        self.actor.GetProperty().SetColor(1, 1, 1)
        light = numpy.full((16, 32, 3), 0.25, numpy.float32)
        self.renderer.AutomaticLightCreationOff()
        relievo.environment(self.renderer, light, reflectivity=0, roughness=0)

        def ball():
            lights = list(self.renderer.GetLights())
            seen = self.look((0, 0, -1))[25:35, 40:50]
            self.assertEqual(list(self.renderer.GetLights()), lights)
            told = relievo.attributes(relievo.capture(self.renderer))["lights"]
            self.assertEqual(len(told), sum(each.GetSwitch() for each in lights))
            return seen

        numpy.testing.assert_allclose(ball(), numpy.full((10, 10, 3), encoded(0.25)), atol=3)
        for interpolation in ("Flat", "PBR"):
            with self.subTest(interpolation):
                getattr(self.actor.GetProperty(), f"SetInterpolationTo{interpolation}")()
                numpy.testing.assert_allclose(
                    ball(), numpy.full((10, 10, 3), encoded(0.25)), atol=12)
        self.actor.GetProperty().SetInterpolationToGouraud()
        sun = vtkLight()
        sun.SetLightTypeToHeadlight()
        sun.SetIntensity(0.2)
        sun.SwitchOff()
        self.renderer.AddLight(sun)
        numpy.testing.assert_allclose(ball(), numpy.full((10, 10, 3), encoded(0.25)), atol=3)
        sun.SwitchOn()
        numpy.testing.assert_allclose(ball()[5, 5], encoded(0.25 + 0.2**2.2), atol=3)
        # VTK makes its own light where it may, and draws as before when the environment is gone.
        self.renderer.RemoveAllLights()
        relievo.environment(self.renderer, None)
        numpy.testing.assert_allclose(ball()[5, 5], (255, 255, 255), atol=1e-3)
        self.renderer.AutomaticLightCreationOn()
        relievo.environment(self.renderer, light, reflectivity=0, roughness=0)
        self.look((0, 0, -1))
        self.assertEqual(self.renderer.GetLights().GetNumberOfItems(), 1)
        # Frames that gather samples come to an end.
        self.renderer.RemoveAllLights()
        self.renderer.AutomaticLightCreationOff()
        relievo.stage(self.renderer, "antialias", samples=4)
        frame = relievo.attach(self.renderer)
        left = []
        for _ in range(4):
            self.window.Render()
            left.append(frame.GetSamplesLeft())
        self.assertEqual(left, [3, 2, 1, 0])

    def test_bytes_are_srgb(self):
        path = self.folder / "grey.png"
        writer = vtkPNGWriter()
        writer.SetInputData(relievo.to_image(numpy.full((16, 32, 3), 128, numpy.uint8)))
        writer.SetFileName(str(path))
        writer.Write()
        relievo.environment(self.renderer, path, roughness=0)
        light = srgb.decoded(128 / 255)
        numpy.testing.assert_allclose(self.look((0, 0, -1))[3, 3], encoded(light), atol=1)

    def test_taken_away(self):
        """None restores the picture bit for bit; a material of one's own stays."""
        before = self.look((0, 0, -1))
        image = relievo.to_image(four_sides())
        for _ in range(3):
            relievo.environment(self.renderer, image, roughness=0)
        self.assertEqual(self.renderer.GetViewProps().GetNumberOfItems(), 2)
        self.assertIsNone(relievo.environment(self.renderer, None))
        self.assertEqual(self.renderer.GetViewProps().GetNumberOfItems(), 1)
        self.assertIsNone(relievo.vtkRelievoMaterial.Get(self.actor))
        numpy.testing.assert_array_equal(self.look((0, 0, -1)), before)

        own = relievo.vtkRelievoMaterial()
        own.SetReflectivity(0.7)
        own.Attach(self.actor)
        made = relievo.environment(self.renderer, image, roughness=0, sky=False)
        self.assertIs(own.GetEnvironment(), made)
        self.assertEqual(own.GetReflectivity(), 0.7)
        relievo.environment(self.renderer, None)
        self.assertIs(relievo.vtkRelievoMaterial.Get(self.actor), own)
        self.assertIsNone(own.GetEnvironment())

    def test_taken_from_materials(self):
        """A material's former environment is back, however often ours was replaced."""
        image = relievo.to_image(four_sides())
        former = relievo.vtkRelievoEnvironment()
        former.SetImage(image)
        own = relievo.vtkRelievoMaterial()
        own.SetEnvironment(former)
        own.Attach(self.actor)
        for _ in range(2):
            made = relievo.environment(self.renderer, image, roughness=0)
            self.assertIs(own.GetEnvironment(), made)
        relievo.environment(self.renderer, None)
        self.assertIs(own.GetEnvironment(), former)
        # Later settings of the user are not replaced.
        relievo.environment(self.renderer, image, roughness=0)
        other = relievo.vtkRelievoEnvironment()
        own.SetEnvironment(other)
        relievo.environment(self.renderer, None)
        self.assertIs(own.GetEnvironment(), other)

    def test_taken_from_removed_actors(self):
        image = relievo.to_image(four_sides())
        with_own = scenes.add(self.renderer, vtkSphereSource())
        own = relievo.vtkRelievoMaterial()
        own.Attach(with_own)
        for last in (None, image):
            for actor in (self.actor, with_own):
                self.renderer.AddActor(actor)
            relievo.environment(self.renderer, image, roughness=0)
            for actor in (self.actor, with_own):
                self.renderer.RemoveActor(actor)
            relievo.environment(self.renderer, last, roughness=0)
            self.assertIsNone(relievo.vtkRelievoMaterial.Get(self.actor))
            self.assertIs(relievo.vtkRelievoMaterial.Get(with_own), own)
            self.assertIsNone(own.GetEnvironment())

    def test_shared_by_renderers(self):
        """An actor in two renderers shows the last environment; each None removes one."""
        image = relievo.to_image(four_sides())
        beside = vtkRenderer()
        beside.AddActor(self.actor)
        alone = scenes.add(self.renderer, vtkSphereSource())
        first = relievo.environment(self.renderer, image, roughness=0)
        second = relievo.environment(beside, image, roughness=0)
        material = relievo.vtkRelievoMaterial.Get
        self.assertIs(material(alone).GetEnvironment(), first)
        self.assertIs(material(self.actor).GetEnvironment(), second)
        relievo.environment(self.renderer, None)
        self.assertIsNone(material(alone))
        self.assertIs(material(self.actor).GetEnvironment(), second)
        relievo.environment(beside, None)
        self.assertIsNone(material(self.actor))

    def test_only_lit_surfaces(self):
        image = relievo.to_image(four_sides())
        line = scenes.add(self.renderer, vtkLineSource())
        flat = scenes.add(self.renderer, vtkSphereSource())
        flat.GetProperty().LightingOff()
        tube = scenes.add(self.renderer, vtkLineSource())
        tube.GetProperty().RenderLinesAsTubesOn()
        own = relievo.vtkRelievoMaterial()
        own.Attach(flat)
        wires = scenes.add(self.renderer, vtkSphereSource())
        wires.GetProperty().SetRepresentationToWireframe()
        axes, sky = vtkCubeAxesActor(), vtkSkybox()
        for each in (axes, sky):
            self.renderer.AddActor(each)
        for each in (line, tube):
            each.GetMapper().Update()
        made = relievo.environment(self.renderer, image, roughness=0)
        material = relievo.vtkRelievoMaterial.Get
        for each in (self.actor, tube, wires, flat):
            self.assertIs(material(each).GetEnvironment(), made)
        for each in (line, axes, sky):
            self.assertIsNone(material(each))

    def test_leaves_the_camera_to_the_first_frame(self):
        """VTK fits a camera that has not been requested before, also with a sky."""
        def first_frame(path):
            renderer = vtkRenderer()
            scenes.add(renderer, vtkSphereSource()).SetPosition(50, 0, 0)
            if path:
                relievo.environment(renderer, path, roughness=0)
            window = scenes.window_of(renderer, *SIZE)
            window.Render()
            camera = renderer.GetActiveCamera()
            return camera.GetPosition(), camera.GetFocalPoint()

        self.assertEqual(first_frame(relievo.to_image(four_sides())), first_frame(None))

    def test_renderers_with_attributes(self):
        self.renderer.renderer = "what somebody keeps there"
        self.assertIsNotNone(
            relievo.environment(self.renderer, relievo.to_image(four_sides()), roughness=0))

    def test_refusals(self):
        image = relievo.to_image(four_sides())
        (self.folder / "no.png").write_bytes(b"no picture")
        for invalid, kind, says in (
            ((self.renderer, self.folder / "none.exr"), FileNotFoundError, "none.exr"),
            ((self.renderer, self.folder / "no.png"), ValueError, "expected an image"),
            ((self.renderer, self.folder), IsADirectoryError, ""),
            ((self.renderer, relievo.to_image(four_sides()[:, :18])), ValueError, "18 x 16"),
            ((self.actor, image), ValueError, "vtkRenderer"),
            ((self.renderer, image, "east"), ValueError, "rotation: got 'east'"),
        ):
            with self.assertRaisesRegex(kind, says):
                relievo.environment(*invalid)
        for name, value in (("up", "w"), ("intensity", -1), ("reflectivity", 1.5),
                            ("roughness", float("nan"))):  # fmt: skip
            with self.assertRaisesRegex(ValueError, name):
                relievo.environment(self.renderer, image, **{name: value})
        self.assertEqual(self.renderer.GetViewProps().GetNumberOfItems(), 1)


if __name__ == "__main__":
    unittest.main()
