# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""attach(), detach() and report(): the first picture bit for bit, the user's pass, the words."""

import gc
import importlib
import inspect
import os
import pathlib
import re
import types
import unittest

import numpy
import scenes
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMutableUndirectedGraph
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkRenderer,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkOpenGLFXAAPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkSSAAPass,
)

import relievo

LACKS = os.environ.get("RELIEVO_VTK_LACKS", "").split()  # tests/wheel/CMakeLists.txt
DOCS = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]).parent / "docs"


def picture(window):
    """The window's current picture, as bytes."""
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferTypeToRGBA()
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    return relievo.layer(grab.GetOutput(), "ImageScalars").tobytes()


class Stages(unittest.TestCase):
    def setUp(self):
        self.renderer = scenes.plane_and_sphere()
        lamp = vtkLight()
        lamp.SetPosition(3, 4, 5)
        self.renderer.AddLight(lamp)
        self.window = scenes.window_of(self.renderer)
        self.first = picture(self.window)

    def test_the_example_makes_shadows(self):
        shadows = relievo.stage(self.renderer, "shadows", method="warped", bias=2)
        self.assertNotEqual(picture(self.window), self.first)
        self.assertEqual(shadows.GetParameter("method"), "warped")
        self.assertEqual(float(shadows.GetParameter("bias")), 2)
        relievo.stage(self.renderer, "shadows", on=numpy.False_, strength=numpy.float32(0.5))
        self.assertEqual(picture(self.window), self.first)

    def test_wrong_values_change_nothing(self):
        biases = (None, {}, object(), 1j, [[1]], float("nan"), [1, 2, 3])
        for invalid in [*({"bias": each} for each in biases), {"method": "magic"}, {"nosuch": 1}]:
            with self.assertRaisesRegex(ValueError, f"stage: .*{next(iter(invalid))}"):
                relievo.stage(self.renderer, "shadows", **invalid)
            self.assertIsNone(self.renderer.GetPass(), "nothing was attached")
        for name in ("bogus", "", None, 3):
            with self.assertRaisesRegex(ValueError, "expected one of .*shadows"):
                relievo.stage(self.renderer, name)
            self.assertIsNone(self.renderer.GetPass(), "nothing was attached")
        shadows = relievo.stage(self.renderer, "shadows", bias=3, strength=0.5)
        display = relievo.stage(self.renderer, "display")
        for invalid in (None, "x", 200):
            with self.assertRaises(ValueError):
                relievo.stage(self.renderer, "shadows", on=False, strength=0.25, bias=invalid)
            self.assertEqual([shadows.GetParameter(each) for each in ("strength", "bias")],
                             ["0.5", "3"])
            self.assertTrue(shadows.GetEnabled())
        self.assertEqual(display.GetParameter("layer"), "")
        with self.assertRaises(ValueError):
            relievo.stage(self.renderer, "display", layer="depth", grey="perhaps")
        self.assertEqual(display.GetParameter("layer"), "", "an empty text comes back")


class Attach(unittest.TestCase):
    def setUp(self):
        self.renderer = scenes.plane_and_sphere()
        self.window = scenes.window_of(self.renderer)
        self.first = picture(self.window)

    def test_pictures_are_the_same(self):
        frame = relievo.attach(self.renderer)
        self.assertEqual(picture(self.window), self.first)
        frame.RequestLayer("depth")
        frame.RequestLayer("normal")
        frame.RequestLayer("cell")
        self.assertEqual(picture(self.window), self.first)
        self.assertGreater(frame.GetBytesHeld(), 0)
        self.assertTrue(relievo.detach(self.renderer))
        self.assertEqual(picture(self.window), self.first)
        self.assertIsNone(self.renderer.GetPass())

    def test_the_users_pass_comes_back(self):
        own = vtkOpenGLFXAAPass()
        own.SetDelegatePass(vtkRenderStepsPass())
        self.renderer.SetPass(own)
        smoothed = picture(self.window)
        self.assertNotEqual(smoothed, self.first, "the user's pass does nothing")
        frame = relievo.attach(self.renderer)
        self.assertIs(frame.GetDelegatePass(), own)
        self.assertEqual(picture(self.window), smoothed)
        self.assertTrue(relievo.detach(self.renderer))
        self.assertIs(self.renderer.GetPass(), own)
        self.assertEqual(picture(self.window), smoothed)
        self.renderer.SetPass(None)
        self.assertEqual(picture(self.window), self.first)

    def test_a_pass_that_is_set_later(self):
        """It is within the frame from the next picture on, until detach()."""
        frame = relievo.attach(types.SimpleNamespace(renderer=self.renderer))
        own = vtkOpenGLFXAAPass()
        own.SetDelegatePass(vtkRenderStepsPass())
        self.renderer.SetPass(own)
        smoothed = picture(self.window)
        self.assertNotEqual(smoothed, self.first)
        self.assertIs(self.renderer.GetPass(), frame)
        self.assertIs(frame.GetDelegatePass(), own)
        frame.SetDisplayLayer("normal")
        self.assertNotEqual(picture(self.window), smoothed)
        frame.SetDisplayLayer(None)
        gc.collect()  # no other references keep its owner alive
        self.renderer.SetPass(None)
        self.assertEqual(picture(self.window), self.first)
        self.assertIs(self.renderer.GetPass(), frame)
        self.assertTrue(relievo.detach(self.renderer))
        self.renderer.SetPass(own)
        self.assertEqual(picture(self.window), smoothed)
        self.assertIs(self.renderer.GetPass(), own)

    def test_a_pass_around_the_frame(self):
        """Other code may wrap the renderer's pass: it stays in its place, and nothing recurs."""
        frame = relievo.attach(self.renderer)
        self.window.Render()
        passes = vtkRenderPassCollection()
        passes.AddItem(frame)
        sequence, camera = vtkSequencePass(), vtkCameraPass()
        sequence.SetPasses(passes)
        camera.SetDelegatePass(sequence)
        around = vtkSSAAPass()
        around.SetDelegatePass(frame)
        for own in (around, camera):
            self.renderer.SetPass(own)
            self.window.Render()
            self.assertIs(self.renderer.GetPass(), own)
            self.assertIs(relievo.attach(self.renderer), frame)
        self.renderer.SetPass(None)
        self.assertEqual(picture(self.window), self.first)
        self.assertIs(self.renderer.GetPass(), frame)

    def test_detached_behind_another_pass(self):
        """Whatever has been set since the last picture."""
        frame = relievo.attach(self.renderer)
        own = vtkOpenGLFXAAPass()
        own.SetDelegatePass(vtkRenderStepsPass())
        self.renderer.SetPass(own)
        self.assertTrue(relievo.detach(self.renderer))
        self.assertTrue(frame.is_detached())
        self.window.Render()
        self.assertIs(self.renderer.GetPass(), own)
        self.assertFalse(relievo.detach(self.renderer))

    def test_a_frame_of_two_renderers(self):
        """The one that it was attached to keeps it when the other lets it go."""
        frame = relievo.attach(self.renderer)
        other = scenes.plane_and_sphere()
        other.SetPass(frame)
        self.assertTrue(relievo.detach(other))
        self.assertFalse(frame.is_detached())
        other.SetPass(frame)
        self.renderer.SetPass(None)
        self.assertTrue(relievo.detach(self.renderer))
        self.assertIs(relievo.attach(other), frame)
        with self.assertRaises(ValueError):
            frame.SetDisplayLayer("nonsense")

    def test_twice(self):
        frame = relievo.attach(self.renderer)
        self.assertIs(relievo.attach(self.renderer), frame)
        self.assertTrue(relievo.detach(self.renderer))
        self.assertFalse(relievo.detach(self.renderer))

    def test_a_layer_as_the_picture(self):
        frame = relievo.attach(self.renderer)
        frame.SetDisplayLayer("normal")
        self.assertNotEqual(picture(self.window), self.first)
        frame.SetDisplayLayer(None)
        self.assertEqual(picture(self.window), self.first)

    def test_a_name_that_is_no_layer(self):
        frame = relievo.attach(self.renderer)
        for give in (frame.RequestLayer, frame.SetDisplayLayer):
            for invalid in ("bogus", "point:bogus", "bogus:Normals", "cell:Normals", "shadow_", "",
                          3):  # fmt: skip
                with self.assertRaises(ValueError) as caught:
                    give(invalid)
                self.assertIn(f"got {invalid!r}", str(caught.exception))
        for array in ("Normals", "point:Normals"):  # of the sphere
            frame.RequestLayer(array)
            frame.SetDisplayLayer(array)
        frame.SetDisplayLayer(None)
        self.assertEqual(picture(self.window), self.first)

    def test_the_name_of_a_light(self):
        frame = relievo.attach(self.renderer)
        shadows = frame.GetShadowStage()
        lamp = vtkLight()
        lamp.SetPosition(3, 4, 5)
        self.renderer.AddLight(lamp)
        shadows.SetLightName(lamp, "key light")
        frame.RequestLayer("shadow_key_light")
        frame.SetDisplayLayer("shadow_key_light")
        self.assertNotEqual(picture(self.window), self.first)
        image = vtkImageData()
        self.assertTrue(frame.ReadLayer("shadow_key_light", image))
        self.assertLess(relievo.layer(image, "shadow_key_light").min(), 0.5)
        for give in (frame.RequestLayer, frame.SetDisplayLayer):
            with self.assertRaisesRegex(ValueError, "'shadow_sun'.*no light.*shadow_key_light"):
                give("shadow_sun")
        shadows.SetLightName(lamp, "sun")
        frame.SetDisplayLayer("shadow_sun")

    def test_the_name_of_a_light_that_comes_later(self):
        renderer = vtkRenderer()
        scenes.add(renderer, vtkSphereSource())
        frame = relievo.attach(renderer)
        frame.RequestLayer("shadow_sun")  # there are no lights yet
        lamp = vtkLight()
        renderer.AddLight(lamp)
        with self.assertRaises(ValueError):
            frame.RequestLayer("shadow_sun")
        frame.GetShadowStage().SetLightName(lamp, "sun")
        frame.RequestLayer("shadow_sun")

    @unittest.skipIf("vtkGraphMapper" in LACKS, "this VTK has none")
    def test_arrays_of_data_that_others_make_drawable(self):
        from vtkmodules.vtkRenderingCore import vtkGraphMapper

        mapper = vtkGraphMapper()
        mapper.SetInputData(vtkMutableUndirectedGraph())
        renderer = vtkRenderer()
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
        relievo.attach(renderer).RequestLayer("weight")  # cannot be checked yet

    def test_a_name_that_comes_later(self):
        renderer = vtkRenderer()
        window = scenes.window_of(renderer, 30, 20)
        frame = relievo.attach(renderer)
        frame.RequestLayer("Normals")  # nothing is drawn: it cannot be checked yet
        frame.RequestLayer("bogus")
        scenes.add(renderer, vtkSphereSource())
        window.Render()
        image = vtkImageData()
        self.assertTrue(frame.ReadLayer("Normals", image))
        self.assertEqual(relievo.layer_names(image), ["Normals"])
        for names in (["bogus"], ["depth", "bogus"], ["albedo"]):
            with self.assertRaises(ValueError) as caught:
                frame.ReadLayers(names, vtkImageData())
            self.assertIn(f"'{names[-1]}'", str(caught.exception))
        with self.assertRaises(ValueError):
            frame.ReadLayer("depth", None)

    def test_the_frame_is_the_same_when_it_is_asked_for_again(self):
        relievo.attach(self.renderer)
        gc.collect()
        for frame in (self.renderer.GetPass(), relievo.vtkRelievoPass.Attach(self.renderer)):
            with self.assertRaises(ValueError):
                frame.RequestLayer("bogus")

    def test_more_lights_than_shaders_hold(self):
        """One message gives the number of lights, the limit, and a remedy."""
        frame = relievo.attach(self.renderer)
        for _ in range(frame.MOST_LIGHTS + 1):  # beside the headlight
            self.renderer.AddLight(vtkLight())
        said = []
        frame.AddObserver("ErrorEvent", lambda *_: said.append(1))
        self.window.Render()
        self.assertEqual(len(said), 1)
        with self.assertRaisesRegex(RuntimeError, "1002 lights are on.* take at most 1000.*lamps"):
            relievo.capture(self.renderer)
        for light in self.renderer.GetLights():
            light.SetSwitch(False)
        next(iter(self.renderer.GetLights())).SetSwitch(True)
        self.window.Render()
        depth = relievo.layer(relievo.capture(self.renderer), "depth")
        self.assertTrue(numpy.isfinite(depth).any())

    def test_errors(self):
        for invalid in (None, "renderer", self.window):
            for function in (relievo.attach, relievo.detach, relievo.report):
                with self.assertRaises(ValueError) as caught:
                    function(invalid)
                self.assertIn("got", str(caught.exception))

    def test_report(self):
        with self.assertRaises(ValueError) as caught:
            relievo.report(self.renderer)
        self.assertIn("attach()", str(caught.exception))
        frame = relievo.attach(self.renderer)
        self.assertEqual(relievo.report(frame)["stages"], [])  # no frame has been drawn yet
        self.window.Render()
        idle = {stage["name"]: stage for stage in relievo.report(frame)["stages"]}
        self.assertFalse(idle["gbuffer"]["ran"])
        self.assertEqual(idle["gbuffer"]["bytes"], 0)
        frame.RequestLayer("depth")
        for _ in range(4):
            self.window.Render()
        busy = relievo.report(self.renderer)
        stage = {stage["name"]: stage for stage in busy["stages"]}["gbuffer"]
        self.assertTrue(stage["ran"])
        self.assertIn("depth", stage["reason"])
        self.assertGreaterEqual(stage["bytes"], 4 * 300 * 200)
        self.assertEqual(busy["bytes"], frame.GetBytesHeld())
        self.assertEqual(busy["size"], [300, 200])
        frame.ReleaseLayer("depth")
        self.window.Render()
        self.assertEqual(relievo.report(frame)["bytes"], 0)


class Package(unittest.TestCase):
    def test_every_public_function_says_what_it_does(self):
        for name in relievo.__all__:
            function = getattr(relievo, name)
            text = inspect.getdoc(function)
            self.assertTrue(text, name)
            parameters = inspect.signature(function).parameters
            for parameter in parameters:
                self.assertIn(parameter, text, f"{name}: {parameter}")
            if parameters and name not in ("layer_names", "attributes"):
                self.assertIn("Raises", text, name)

    def test_the_page_has_every_function_with_its_arguments(self):
        page = (DOCS / "python.md").read_text(encoding="utf-8")
        headings = "\n".join(line for line in page.splitlines() if line.startswith("###"))
        for name in relievo.__all__:
            function = getattr(relievo, name)
            if inspect.isfunction(function):
                arguments = str(inspect.signature(function)).replace("'", '"').split(" -> ")[0]
                heading = re.search(rf"^### {name}(\(.*\.\.\..*\)) →", headings, re.M)
                if heading:  # values stand in tables of their own
                    wanted = re.escape(heading.group(1)).replace(re.escape("..."), ".*")
                    self.assertRegex(arguments, f"^{wanted}$", name)
                else:
                    self.assertIn(f"{name}{arguments}", headings)
            else:
                self.assertIn(f"relievo.{name}`", page)

    def test_the_wrapped_classes_are_there(self):
        for name in ("vtkRelievoPass", "vtkRelievoLayersStage", "vtkRelievoLayerSource",
                     "vtkRelievoLinearDepthPass", "vtkRelievoEXRWriter", "vtkRelievoEXRReader",
                     "vtkRelievoOFFReader", "vtkRelievoOBJReader", "vtkRelievoPLYReader",
                     "vtkRelievoDepthToPoints", "vtkRelievoConvexPolygons"):  # fmt: skip
            self.assertTrue(getattr(relievo, name)().IsA(name), name)

    def test_import_again(self):
        self.assertIs(importlib.import_module("relievo"), relievo)


if __name__ == "__main__":
    unittest.main(verbosity=2)
