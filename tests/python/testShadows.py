# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers shadow_N against rays in double, shadows in the picture, who casts and receives."""

import json
import pathlib
import tempfile
import unittest

import numpy
import scenes
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkWindowToImageFilter

import relievo

# A plate of half width 1/2 hangs at y = 1 over a floor of half width 3 at y = 0.
LIGHTS = {  # name: place (of the sun: the direction to it), positional, cone angle
    "sun": ((1, 2, 0.5), False, 30),
    "spot": ((-1.5, 3, 0.4), True, 40),
    "point": ((0.3, 2.5, -1), True, 180),
}


def plate(half, height):
    source = vtkPlaneSource()
    source.SetOrigin(-half, height, -half)
    source.SetPoint1(-half, height, half)
    source.SetPoint2(half, height, -half)
    return source


def make_light(place, positional, cone):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPositional(positional)
    light.SetConeAngle(cone)
    light.SetIntensity(0.3)  # three of them stay below white
    light.SetPosition(*place)
    light.SetFocalPoint(0, 0, 0)
    return light


def edge_distance(position, light):
    """How far the ray from each point of the floor to the light misses the plate's edge: its place
    in the plate's plane, negative inside."""
    place, positional, _ = LIGHTS[light]
    towards = numpy.array(place, float) - (position if positional else 0)
    at = position + towards * ((1 - position[..., 1:2]) / towards[..., 1:2])
    return numpy.maximum(abs(at[..., 0]), abs(at[..., 2])) - 0.5


class Shadows(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.floor = scenes.add(self.renderer, plate(3, 0))
        self.plate = scenes.add(self.renderer, plate(0.5, 1))
        self.renderer.AutomaticLightCreationOff()
        self.lights = [make_light(*LIGHTS[name]) for name in LIGHTS]
        for light in self.lights:
            self.renderer.AddLight(light)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(2.5, 3, 6)
        camera.SetFocalPoint(0, 0.3, 0)
        camera.SetClippingRange(2, 14)
        self.window = scenes.window_of(self.renderer)
        self.layers = [f"shadow_{i}" for i in range(len(LIGHTS))]

    def capture(self):
        image = relievo.capture(self.renderer, ["actor", "position", *self.layers])
        self.floor_seen = relievo.layer(image, "actor") == 0
        self.position = relievo.layer(image, "position").copy()
        return image, [relievo.layer(image, name).copy() for name in self.layers]

    def dark(self, light):
        """Pixels of the floor that the plate hides from the light, two texels and more inside."""
        return self.floor_seen & (edge_distance(self.position, light) < -0.02)

    def picture(self):
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        return relievo.layer(grab.GetOutput(), "ImageScalars").astype(int)

    def test_layers_against_rays(self):
        image, shadows = self.capture()
        self.assertIsNone(self.renderer.GetPass(), "capture left its frame")
        nothing = relievo.layer(image, "actor") < 0
        self.assertTrue(nothing.any())
        for name, values in zip(LIGHTS, shadows):
            with self.subTest(light=name):
                self.assertEqual((values.dtype, values.shape), (numpy.float32, (200, 300)))
                distance = edge_distance(self.position, name)
                sure = self.floor_seen & (abs(distance) > 0.02)
                self.assertGreater(self.dark(name).sum(), 300)
                self.assertGreater(sure.sum(), 0.9 * self.floor_seen.sum())
                numpy.testing.assert_array_equal(values[sure], (distance > 0)[sure])
                self.assertEqual(set(values[nothing]), {1.0})

    def test_a_lens(self):
        """A vertex shader that modifies VTK's gl_Position, like that of PyVista's camera
        distortion, bends the camera's picture, but not the lights' maps."""
        for thing in (self.floor, self.plate):
            source = thing.GetMapper().GetInputAlgorithm()
            source.SetResolution(40, 40)
            source.Update()
            mesh = vtkPolyData()
            mesh.DeepCopy(source.GetOutput())
            places = vtkDoubleArray()
            places.DeepCopy(mesh.GetPoints().GetData())
            places.SetName("place")
            mesh.GetPointData().AddArray(places)
            thing.GetMapper().SetInputDataObject(mesh)
            thing.GetShaderProperty().AddVertexShaderReplacement(
                "//VTK::PositionVC::Impl", True,
                "//VTK::PositionVC::Impl\n  vec2 seen = gl_Position.xy / gl_Position.w;\n"
                "  gl_Position.xy *= 1.0 + 0.2 * dot(seen, seen);\n", False)  # fmt: skip
        self.layers.append("place")
        image, (*shadows, places) = self.capture()
        # Places are where the lens bends them to their pixels.
        numpy.testing.assert_allclose(
            places[self.floor_seen], self.position[self.floor_seen], atol=1e-3)
        points = numpy.concatenate([self.position, numpy.ones((200, 300, 1))], axis=-1)
        clip = points @ relievo.attributes(image)["worldToNDC"].T
        ndc = clip[..., :2] / clip[..., 3:]
        bent = ndc * (1 + 0.2 * (ndc**2).sum(axis=-1, keepdims=True))
        rows, columns = numpy.mgrid[:200, :300]
        x, y = 150 * (1 + bent[..., 0]), 100 * (1 - bent[..., 1])
        off = numpy.hypot(x - columns - 0.5, y - rows - 0.5)[self.floor_seen]
        self.assertLess(off.max(), 0.3)  # between corners triangles are straight
        self.assertGreater(numpy.abs(150 * (bent - ndc))[self.floor_seen].max(), 3)
        for name, values in zip(LIGHTS, shadows):
            with self.subTest(light=name):
                distance = edge_distance(places, name)
                sure = self.floor_seen & (abs(distance) > 0.1)  # nearer some pixels are in between
                self.assertGreater((sure & (distance < 0)).sum(), 300)
                numpy.testing.assert_array_equal(values[sure], (distance > 0)[sure])

    def test_the_picture(self):
        off = self.picture()
        self.capture()
        frame = relievo.attach(self.renderer)
        frame.ShadowsOn()
        on = self.picture()
        for name in LIGHTS:
            self.assertTrue((on < off).any(axis=2)[self.dark(name)].all(), name)
        self.assertTrue((on <= off).all())
        lit = self.floor_seen & numpy.all(
            [edge_distance(self.position, name) > 0.02 for name in LIGHTS], axis=0
        )
        self.assertGreater(lit.sum(), 1000)
        numpy.testing.assert_array_equal(on[lit], off[lit])
        stage = {stage["name"]: stage for stage in relievo.report(frame)["stages"]}["shadows"]
        self.assertIn("3 lights cast", stage["reason"])
        self.assertEqual(stage["bytes"], frame.GetBytesHeld())
        frame.ShadowsOff()
        numpy.testing.assert_array_equal(self.picture(), off)
        self.assertEqual(frame.GetBytesHeld(), 0)

    def test_maps_drawn_anew_leave_the_light_as_it_is(self):
        # VTK's own shaders draw such a caster into the map, and the light's uniforms with it.
        self.plate.GetShaderProperty().AddVertexShaderReplacement(
            "//VTK::PositionVC::Impl", True, "//VTK::PositionVC::Impl\n", False
        )
        frame = relievo.attach(self.renderer)
        frame.GetShadowStage().SetMapSize(512)
        for x in (1, -1, 0.5):
            frame.ShadowsOn()
            self.picture()
            self.lights[0].SetPosition(x + 0.1, 2, 0.5)  # only the sun's map is drawn anew
            on = self.picture()
            self.assertEqual(frame.GetShadowStage().GetNumberOfMapsDrawn(), 1)
            frame.ShadowsOff()
            off = self.picture()
            self.assertTrue((on <= off).all(), "brighter than without shadows")
            self.assertGreater((on == off).all(axis=2).mean(), 0.7)

    def test_a_projective_matrix(self):
        """Casters are where they are drawn, by every method; problems are reported."""
        rows = numpy.eye(4)
        rows[3] = 0.25, 0.2, 0.15, 1
        matrix = vtkMatrix4x4()
        matrix.DeepCopy(rows.ravel())
        self.plate.SetUserMatrix(matrix)
        corners = [rows @ (x, 1, z, 1) for x, z in ((-.5, -.5), (-.5, .5), (.5, .5), (.5, -.5))]
        corners = [corner[:3] / corner[3] for corner in corners]
        normal = numpy.cross(corners[1] - corners[0], corners[2] - corners[0])
        for method in ("map", "warped", "forward", "exact"):
            stage = relievo.stage(self.renderer, "shadows", method=method,
                                  map_size=1024)  # fmt: skip
            said = []
            stage.AddObserver("WarningEvent", lambda *_, said=said: said.append(1))
            image, _ = self.capture()
            position, floor = self.position, self.floor_seen
            self.assertLessEqual(len(said), 1)
            for i, name in enumerate(LIGHTS):
                place, positional, _ = LIGHTS[name]
                towards = numpy.array(place, float) - (position if positional else 0)
                along = (corners[0] - position) @ normal / (towards @ normal)
                at = position + towards * along[..., None]
                sides = [numpy.cross(b - a, at - a) @ normal
                         for a, b in zip(corners, corners[1:] + corners[:1])]
                dark = numpy.all(numpy.array(sides) > 0, axis=0)
                mismatches = floor & (dark != (relievo.layer(image, f"shadow_{i}") < 0.5))
                self.assertGreater(numpy.count_nonzero(floor & dark), 300)
                with self.subTest(method=method, light=name):
                    most = 6 if method == "exact" else 60
                    self.assertLessEqual(numpy.count_nonzero(mismatches), most)

    def test_who_casts_and_receives(self):
        _, shadows = self.capture()
        dark = [self.dark(name) for name in LIGHTS]
        for values, place in zip(shadows, dark):
            self.assertEqual(values[place].max(), 0)
        choices = relievo.attach(self.renderer).GetShadowStage()

        choices.SetLightCasts(self.lights[1], False)
        self.assertFalse(choices.GetLightCasts(self.lights[1]))
        _, shadows = self.capture()
        self.assertEqual([values[place].max() for values, place in zip(shadows, dark)], [0, 1, 0])
        self.assertEqual(shadows[1].min(), 1)
        choices.SetLightCasts(self.lights[1], True)

        choices.SetPropCasts(self.plate, choices.CASTS_NEVER)
        _, shadows = self.capture()
        self.assertEqual([values[place].min() for values, place in zip(shadows, dark)], [1, 1, 1])
        choices.SetPropCasts(self.plate, choices.CASTS_IF_OPAQUE)
        choices.SetPropReceives(self.floor, False)
        _, shadows = self.capture()
        self.assertEqual([values[place].min() for values, place in zip(shadows, dark)], [1, 1, 1])
        choices.SetPropReceives(self.floor, True)
        _, shadows = self.capture()
        self.assertEqual([values[place].max() for values, place in zip(shadows, dark)], [0, 0, 0])

        choices.SetStrength(0.5)  # for the picture: layers show the blocked share
        _, shadows = self.capture()
        self.assertEqual([values[place].max() for values, place in zip(shadows, dark)], [0, 0, 0])

    def test_a_light_that_is_off_keeps_its_number(self):
        _, before = self.capture()
        self.lights[0].SwitchOff()
        _, shadows = self.capture()
        self.assertEqual(shadows[0].min(), 1)
        numpy.testing.assert_array_equal(shadows[1][self.floor_seen], before[1][self.floor_seen])

    def test_exr(self):
        image, shadows = self.capture()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.exr"
            relievo.write_exr(path, image)
            self.assertIn(b"shadow_2.V\0", path.read_bytes())
            back = relievo.read_exr(path)
        for name, values in zip(self.layers, shadows):
            numpy.testing.assert_array_equal(relievo.layer(back, name), values)

    def test_layers_by_name(self):
        shadows = relievo.attach(self.renderer).GetShadowStage()
        names = [("Key Light", "shadow_key_light"), ("Späti-2", "shadow_sp__ti_2")]
        names.append(("7", "shadow_light_7"))
        for number, (light, (name, layer)) in enumerate(zip(self.lights, names)):
            self.assertEqual(shadows.GetLightName(self.renderer, light), f"light {number}")
            shadows.SetLightName(light, name)
            self.assertEqual(shadows.GetLightLayer(self.renderer, light), layer)
        layers = [layer for _, layer in names]
        image = relievo.capture(self.renderer, [*layers, *self.layers])
        for named, numbered in zip(layers, self.layers):
            values = relievo.layer(image, numbered)
            numpy.testing.assert_array_equal(relievo.layer(image, named), values)
            self.assertTrue(0.005 < (values < 0.5).mean() < 0.9, numbered)
        self.assertFalse((relievo.layer(image, layers[0]) == relievo.layer(image, layers[1])).all())
        told = [json.loads(text) for text in relievo.attributes(image)["lights"]]
        self.assertEqual([(each["name"], each["layer"]) for each in told], names)
        # One alone, shown as the picture: grey from 0 to 1, whatever range its values have.
        alone = relievo.capture(self.renderer, ["shadow_key_light"])
        numpy.testing.assert_array_equal(
            relievo.layer(alone, "shadow_key_light"), relievo.layer(image, self.layers[0]))
        # Two of one name; one that is off, one that does not cast, and one at the eye.
        shadows.SetLightName(self.lights[1], "Key Light")
        self.assertEqual(list(shadows.GetShadowLayers(self.renderer)),
                         ["shadow_key_light", "shadow_key_light_2", "shadow_light_7"])
        shadows.SetLightCasts(self.lights[0], False)
        self.lights[1].SwitchOff()
        self.lights[2].SetLightTypeToHeadlight()
        self.assertEqual(list(shadows.GetShadowLayers(self.renderer)), [])
        self.assertEqual(shadows.GetLightLayer(self.renderer, vtkLight()), "")
        with self.assertRaisesRegex(ValueError, "shadow_lamp.*no light has this name"):
            relievo.capture(self.renderer, ["shadow_lamp"])

    def test_errors(self):
        for name, says in (("shadow_3", "3 lights"), ("shadow_x", "neither a layer nor")):
            with self.assertRaises(ValueError) as caught:
                relievo.capture(self.renderer, ["depth", name])
            self.assertIn(name, str(caught.exception))
            self.assertIn(says, str(caught.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
