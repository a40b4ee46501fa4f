# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""capture(): layers against truth in double, sizes, windows, restored state, errors."""

import json
import os
import subprocess
import sys
import unittest
from unittest import mock

import numpy
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkGlyph3DMapper,
    vtkLight,
    vtkMapper,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkRenderStepsPass

try:
    from vtkmodules.vtkRenderingCore import vtkDistanceToCamera
except ImportError:  # PyPI's cvista does without
    vtkDistanceToCamera = None

import relievo
from relievo.vtkRelievoPasses import vtkRelievoLayerSource

SIZE = (210, 140)


def picture(window):
    """The window's pixels now, without drawing anew, as bytes."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    return relievo.layer(grab.GetOutput(), "ImageScalars").tobytes()


class Truth(unittest.TestCase):
    """A tilted plane and a sphere of flat triangles, each pixel's ray intersected in double."""

    def check(self, renderer, position_limit):
        image = relievo.capture(
            renderer,
            ["depth", "range", "normal", "geometric_normal", "position", "actor"],
            size=SIZE,
        )
        depth = relievo.layer(image, "depth")
        true_depth, true_normal, inner = scenes.truth(renderer, *SIZE)
        self.assertGreater(inner.sum(), 0.8 * inner.size)
        hit = numpy.isfinite(true_depth)
        self.assertTrue(hit.all(), "the plane fills the view")

        error = numpy.abs(depth - true_depth)[inner] / true_depth[inner]
        self.assertLessEqual(error.max(), 1e-6)

        origins, directions = scenes.rays(renderer.GetActiveCamera(), *SIZE)
        length = numpy.linalg.norm(directions, axis=2)
        distance = relievo.layer(image, "range")
        if renderer.GetActiveCamera().GetParallelProjection():
            eye = numpy.array(renderer.GetActiveCamera().GetPosition())
            length = numpy.linalg.norm(origins + true_depth[..., None] * directions - eye, axis=2)
            length /= true_depth
        error = numpy.abs(distance - true_depth * length)[inner] / distance[inner]
        self.assertLessEqual(error.max(), 1e-6)

        normal = relievo.layer(image, "geometric_normal").astype(float)
        cross = numpy.linalg.norm(numpy.cross(normal, true_normal), axis=2)
        angle = numpy.degrees(numpy.arctan2(cross, (normal * true_normal).sum(axis=2)))
        self.assertLessEqual(angle[inner].max(), 0.1)
        lengths = numpy.linalg.norm(relievo.layer(image, "normal").astype(float), axis=2)
        numpy.testing.assert_allclose(lengths, 1, atol=1e-3)

        position = relievo.layer(image, "position")
        self.assertEqual(position.dtype, numpy.float64)
        true_position = origins + true_depth[..., None] * directions
        error = numpy.linalg.norm(position - true_position, axis=2)[inner]
        self.assertLessEqual(error.max(), position_limit)

        actor = relievo.layer(image, "actor")
        self.assertEqual(set(actor[inner]), {0, 1})

    def test_perspective(self):
        self.check(scenes.plane_and_sphere(), 2e-5)

    def test_parallel(self):
        self.check(scenes.plane_and_sphere(parallel=True), 2e-5)

    def test_far_from_the_origin(self):
        self.check(scenes.plane_and_sphere(far_from_origin=(5e5, 5e6, 0)), 2e-4)


class Layers(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        scenes.add(self.renderer, vtkSphereSource())
        self.renderer.ResetCamera()

    def test_origin_is_the_focal_point_in_float(self):
        self.renderer.GetActiveCamera().SetFocalPoint(0.1, 0.2, 0.3)
        image = relievo.capture(self.renderer, ["depth"], size=(64, 48))
        origin = image.GetFieldData().GetArray("relievo:origin")
        self.assertEqual(
            [origin.GetValue(i) for i in range(3)],
            [float(numpy.float32(v)) for v in (0.1, 0.2, 0.3)],
        )

    def test_lights_follow_the_camera(self):
        """Each capture tells where the lights at the eye are, whatever it draws."""
        camera = self.renderer.GetActiveCamera()
        for layers in ["depth"], ["color"], ["normal", "light"]:
            for kind in "headlight", "camera":
                self.renderer.RemoveAllLights()
                light = vtkLight()
                light.SetLightTypeToHeadlight()
                if kind == "camera":
                    light.SetLightTypeToCameraLight()
                    light.SetPosition(0.3, 0.2, 1)
                self.renderer.AddLight(light)
                for x in (1, 2, 3):
                    camera.SetPosition(x, 2, 4)
                    image = relievo.capture(self.renderer, layers, size=(20, 10))
                    (told,) = map(json.loads, relievo.attributes(image)["lights"])
                    eye = numpy.array((x, 2, 4), float)
                    place = told["position"], told["focal_point"]
                    if kind == "camera":  # its position is in units of the distance to the focus
                        rotation, _ = relievo.extrinsics(camera)
                        right, down, ahead = rotation
                        off = 0.3 * right - 0.2 * down
                        eye = eye + camera.GetDistance() * off
                    with self.subTest(layers=layers, kind=kind, x=x):
                        self.assertEqual(told["frame"], kind)
                        numpy.testing.assert_allclose(place, (eye, camera.GetFocalPoint()),
                                                      atol=1e-9)

    def test_background_and_types(self):
        names = ["depth", "range", "normal", "geometric_normal", "position", "albedo", "color",
                 "actor", "block", "cell", "Normals"]  # fmt: skip
        image = relievo.capture(self.renderer, names, size=(64, 48))
        self.assertEqual(relievo.layer_names(image), names)
        expected = {
            "depth": ((48, 64), numpy.float32, numpy.inf),
            "range": ((48, 64), numpy.float32, numpy.inf),
            "normal": ((48, 64, 3), numpy.float32, 0),
            "geometric_normal": ((48, 64, 3), numpy.float32, 0),
            "position": ((48, 64, 3), numpy.float64, 0),
            "albedo": ((48, 64, 4), numpy.uint8, 0),
            "color": ((48, 64, 4), numpy.float32, 0),
            "actor": ((48, 64), numpy.int32, -1),
            "block": ((48, 64), numpy.int32, -1),
            "cell": ((48, 64), numpy.int32, -1),
        }
        for name, (shape, kind, background) in expected.items():
            values = relievo.layer(image, name)
            self.assertEqual((values.shape, values.dtype), (shape, kind), name)
            self.assertTrue((values[0, 0] == background).all(), name)
            self.assertFalse((values[24, 32] == background).all(), name)
        array, normal = relievo.layer(image, "Normals"), relievo.layer(image, "normal")
        numpy.testing.assert_allclose(array[24, 32], normal[24, 32], atol=1e-2)

    def test_one_name_and_repeated_names(self):
        image = relievo.capture(self.renderer, "depth", size=(8, 8))
        self.assertEqual(relievo.layer_names(image), ["depth"])
        image = relievo.capture(self.renderer, ["cell", "depth", "cell"], size=(8, 8))
        self.assertEqual(relievo.layer_names(image), ["cell", "depth"])

    def test_default_is_depth(self):
        image = relievo.capture(self.renderer, size=(8, 8))
        self.assertEqual(relievo.layer_names(image), ["depth"])

    def test_matrices_take_a_position_to_its_pixel(self):
        image = relievo.capture(self.renderer, ["position", "depth"], size=(64, 48))
        known = relievo.attributes(image)
        rows, columns = numpy.nonzero(numpy.isfinite(relievo.layer(image, "depth")))
        points = numpy.c_[relievo.layer(image, "position")[rows, columns], numpy.ones(len(rows))]
        clip = points @ known["worldToNDC"].T
        ndc = clip[:, :2] / clip[:, 3:]
        numpy.testing.assert_allclose((ndc[:, 0] + 1) / 2 * 64, columns + 0.5, atol=1e-3)
        numpy.testing.assert_allclose((1 - ndc[:, 1]) / 2 * 48, rows + 0.5, atol=1e-3)
        eye = points @ known["worldToCamera"].T
        numpy.testing.assert_allclose(
            -eye[:, 2], relievo.layer(image, "depth")[rows, columns], rtol=1e-5
        )
        near, far = self.renderer.GetActiveCamera().GetClippingRange()
        self.assertEqual((known["near"], known["far"]), (near, far))


class Windows(unittest.TestCase):
    def test_size_of_the_window_and_another(self):
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer, 120, 80)
        window.Render()
        before = picture(window)
        whole = relievo.layer(relievo.capture(renderer, "depth"), "depth")
        self.assertEqual(whole.shape, (80, 120))
        large = relievo.layer(relievo.capture(renderer, "depth", size=(240, 160)), "depth")
        self.assertEqual(large.shape, (160, 240))
        self.assertEqual(window.GetSize(), (120, 80))
        self.assertEqual(window.GetMultiSamples(), 0)
        self.assertTrue(window.GetOffScreenRendering())
        again = relievo.layer(relievo.capture(renderer, "depth"), "depth")
        numpy.testing.assert_array_equal(again, whole)
        window.Render()
        self.assertEqual(picture(window), before)

    def test_a_viewport_of_a_window(self):
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer, 400, 200)
        renderer.SetViewport(0.25, 0.5, 0.75, 1.0)
        part = relievo.layer(relievo.capture(renderer, "depth"), "depth")
        self.assertEqual(part.shape, (100, 200))
        del window
        true_depth, _, inner = scenes.truth(renderer, 200, 100)
        self.assertLessEqual((numpy.abs(part - true_depth) / true_depth)[inner].max(), 1e-6)

    def test_size_of_an_odd_viewport(self):
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer, 400, 200)
        renderer.SetViewport(0.1, 0.0, 0.43, 0.7)
        for size in ((33, 71), (1, 1), (250, 3)):
            image = relievo.capture(renderer, "depth", size=size)
            self.assertEqual(image.GetDimensions()[:2], size)
        self.assertEqual(window.GetSize(), (400, 200))

    def test_alpha_of_screenshots(self):
        """Straight, for panes over the background, over opaque surfaces, and everything that a
        sphere hides."""
        renderer = vtkRenderer()
        renderer.SetBackground(0.2, 0.4, 0.6)
        renderer.GetActiveCamera().ParallelProjectionOn()
        renderer.GetActiveCamera().SetParallelScale(2)
        renderer.GetActiveCamera().SetPosition(0, 0, 10)
        plane, sphere = vtkPlaneSource(), vtkSphereSource()

        def add(source, place, opacity, color):
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(source.GetOutputPort())
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.SetPosition(*place)
            actor.GetProperty().SetColor(*color)
            actor.GetProperty().SetOpacity(opacity)
            actor.GetProperty().LightingOff()
            renderer.AddActor(actor)

        blue = (0, 0.2, 1)
        add(plane, (-1, 1, 0), 0.5, blue)
        add(plane, (-1, 1, 1), 0.5, blue)
        add(plane, (1, 1, 0), 1, blue)
        add(plane, (1, 1, 1), 0.5, blue)
        add(plane, (-1, -1, 0), 0.2, blue)
        add(sphere, (1, -1, 0), 0.99, blue)
        lens = relievo.Fisheye([[2000, 0, 39.5], [0, 2000, 39.5], [0, 0, 1]], (80, 80))
        lens = lens.look_at((0, 0, 100), (0, 0, 0))
        for peeling, smooth in ((False, False), (False, True), (True, False)):
            renderer.SetUseDepthPeeling(peeling)
            renderer.SetUseFXAA(smooth)
            shot = relievo.screenshot(renderer, size=(80, 80), transparent=True).astype(int)
            colors = [
                relievo.layer(relievo.capture(renderer, "color", hdr=hdr, **of), "color")
                for of in ({"size": (80, 80)}, {"camera": lens}) for hdr in (False, True)
            ]  # fmt: skip
            self.assertEqual(renderer.GetUseFXAA(), smooth)
            for place, alpha in (((20, 20), 0.75), ((20, 60), 1), ((60, 20), 0.2), ((60, 60), 1),
                                 ((40, 40), 0)):  # fmt: skip
                pixel = shot[place]
                how = (place, peeling, smooth)
                self.assertAlmostEqual(pixel[3], 255 * alpha, delta=1.5, msg=how)
                for color in colors:
                    self.assertAlmostEqual(color[place][3], alpha, delta=0.006, msg=how)
                expected = numpy.array(blue) * 255 * (alpha > 0)
                numpy.testing.assert_allclose(pixel[:3], expected, atol=6, err_msg=str(place))
        # Letters over nothing are opaque.
        text = vtkTextActor()
        text.SetInput("H")
        text.GetTextProperty().SetFontSize(24)
        text.SetPosition(32, 32)
        renderer.AddViewProp(text)
        renderer.SetUseDepthPeeling(False)
        color = relievo.layer(relievo.capture(renderer, "color", size=(80, 80)), "color")
        letters = color[:, :, :3].min(axis=-1) > 0.95
        self.assertGreater(letters.sum(), 20)
        numpy.testing.assert_allclose(color[letters][:, 3], 1, atol=0.06)
        self.assertEqual(renderer.GetBackground(), (0.2, 0.4, 0.6))

    def test_without_a_window(self):
        renderer = scenes.plane_and_sphere()
        image = relievo.capture(renderer, "depth", size=(30, 20))
        self.assertEqual(image.GetDimensions(), (30, 20, 1))
        self.assertIsNone(renderer.GetRenderWindow())
        self.assertIsNone(renderer.GetPass())

    def test_the_users_pass_stays(self):
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer)
        own = vtkOpenGLFXAAPass()
        own.SetDelegatePass(vtkRenderStepsPass())
        renderer.SetPass(own)
        window.Render()
        before = picture(window)
        relievo.capture(renderer, ["depth", "normal"])
        self.assertIs(renderer.GetPass(), own)
        window.Render()
        self.assertEqual(picture(window), before)

    def test_an_attached_frame_stays(self):
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer)
        frame = relievo.attach(renderer)
        relievo.capture(renderer, "depth")
        self.assertIs(renderer.GetPass(), frame)
        self.assertFalse(frame.IsLayerRequested("depth"))
        del window


class NothingToSee(unittest.TestCase):
    """A renderer that nothing has drawn yet, or with nothing in it, gives the background."""

    def empty(self, renderer, **more):
        image = relievo.capture(renderer, ["depth", "normal", "actor"], **more)
        self.assertTrue((relievo.layer(image, "depth") == numpy.inf).all())
        self.assertTrue((relievo.layer(image, "normal") == 0).all())
        self.assertTrue((relievo.layer(image, "actor") == -1).all())
        return image.GetDimensions()[:2]

    def test_no_actor(self):
        self.assertEqual(self.empty(vtkRenderer(), size=(9, 9)), (9, 9))

    def test_what_has_no_layers_is_left_out_and_named(self):
        """Emissive points, as splats; the rest is as it is without them."""
        renderer = scenes.plane_and_sphere()
        expected = relievo.capture(renderer, ["depth", "actor", "normal"], size=SIZE)
        mapper = vtkPointGaussianMapper()
        mapper.SetInputData(scenes.points_at([(0, 0, 2), (0.4, 0.2, 2)]))
        mapper.SetScaleFactor(0.5)
        mapper.EmissiveOn()
        splats = vtkActor()
        splats.SetMapper(mapper)
        renderer.AddActor(splats)
        with self.assertWarnsRegex(RuntimeWarning, "No layers of geometry .*PointGaussian"):
            got = relievo.capture(renderer, ["depth", "actor", "normal"], size=SIZE)
        for name in ("depth", "actor", "normal"):
            numpy.testing.assert_array_equal(
                relievo.layer(got, name), relievo.layer(expected, name))  # fmt: skip

    def test_an_invisible_actor(self):
        renderer = vtkRenderer()
        scenes.add(renderer, vtkSphereSource()).VisibilityOff()
        self.assertEqual(self.empty(renderer, size=(9, 9)), (9, 9))

    def test_a_window_that_was_never_rendered(self):
        renderer = vtkRenderer()
        window = scenes.window_of(renderer, 12, 8)
        self.assertEqual(self.empty(renderer), (12, 8))
        scenes.add(renderer, vtkSphereSource())
        del window

    def test_the_camera_is_fitted_as_windows_do(self):
        renderer = vtkRenderer()
        scenes.add(renderer, vtkSphereSource())
        first = relievo.layer(relievo.capture(renderer, "depth", size=(30, 20)), "depth")
        self.assertGreater(numpy.isfinite(first).sum(), 50)
        other = vtkRenderer()
        scenes.add(other, vtkSphereSource())
        window = scenes.window_of(other, 30, 20)
        window.Render()
        numpy.testing.assert_array_equal(
            relievo.layer(relievo.capture(other, "depth"), "depth"), first
        )

    def test_a_renderer_that_is_switched_off(self):
        renderer = scenes.plane_and_sphere()
        renderer.DrawOff()
        with self.assertRaises(RuntimeError) as caught:
            relievo.capture(renderer, "depth", size=(9, 9))
        self.assertIn("DrawOn", str(caught.exception))


class NoDisplay(unittest.TestCase):
    """Before VTK 9.4 each function explains what to do; from then on VTK draws."""

    DRAWS = """
import relievo
from vtkmodules.vtkRenderingCore import vtkRenderer

print("drew", relievo.capture(vtkRenderer(), "depth", size=(9, 7)).GetDimensions())
"""
    SCRIPT = """
import relievo
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderer

def fails(kind, call):
    try:
        call()
    except kind as error:
        assert "DISPLAY" in str(error) and "xvfb-run" in str(error), error
    else:
        raise AssertionError(call)

fails(RuntimeError, lambda: relievo.capture(vtkRenderer(), "depth", size=(9, 9)))
renderer = vtkRenderer()
window = vtkRenderWindow()
window.AddRenderer(renderer)
fails(RuntimeError, lambda: relievo.capture(renderer, "depth"))
fails(RuntimeError, lambda: relievo.capture(renderer, ["color", "depth"]))
fails(RuntimeError, lambda: relievo.capture(renderer, "depth", size=(9, 9)))
source = relievo.vtkRelievoLayerSource()
source.SetRenderer(renderer)
source.AddLayer("depth")
said = []
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

@calldata_type(VTK_STRING)
def keep(_source, _event, text):
    said.append(text)

source.AddObserver("ErrorEvent", keep)
source.GetExecutive().AddObserver("ErrorEvent", keep)
source.Update()
assert "xvfb-run" in said[0], said
print("went on")
"""

    def test_every_way_in(self):
        if not os.path.exists(sys.executable):
            self.skipTest("pvpython does not say where it is")
        version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
        # VTK may warn of the display before it goes without.
        script, says = self.SCRIPT, "went on"
        if version >= (9, 4):
            script, says = self.DRAWS, "drew (9, 7, 1)"
        for display in ("", ":54321", "nowhere.invalid:0"):
            with self.subTest(display=display):
                done = subprocess.run(
                    [sys.executable, "-c", script], env={**os.environ, "DISPLAY": display},
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600,
                    check=False,
                )  # fmt: skip
                self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, says))


class Errors(unittest.TestCase):
    def setUp(self):
        self.renderer = scenes.plane_and_sphere()

    def test_arguments(self):
        for arguments, says in (
            ((None,), "renderer: got None"),
            (("renderer",), "renderer: got 'renderer'"),
            ((self.renderer, []), "layers: got []"),
            ((self.renderer, None), "layers: got None"),
            ((self.renderer, [3]), "layers: got [3]"),
            ((self.renderer, ["depth", ""]), "layers: got ['depth', '']"),
            ((self.renderer, "depth"), "size: the renderer has no window"),
            ((self.renderer, "depth", (0, 5)), "size: got (0, 5)"),
            ((self.renderer, "depth", (10,)), "size: got (10,)"),
            ((self.renderer, "depth", 10), "size: got 10"),
            ((self.renderer, "depth", (1.5, 2)), "size: got (1.5, 2)"),
            ((self.renderer, "depth", (70000, 2)), "from 1 to 16384"),
        ):
            with self.subTest(says=says), self.assertRaises(ValueError) as caught:
                relievo.capture(*arguments)
            self.assertIn(says, str(caught.exception))

    def test_many_cameras(self):
        before = self.renderer.GetActiveCamera()
        cameras = []
        for azimuth in range(5):
            camera = vtkCamera()
            camera.DeepCopy(before)
            camera.Azimuth(50 * azimuth)
            camera.SetParallelProjection(azimuth == 2)
            cameras.append(camera)
        layers = ["depth", "normal", "color", "position", "cell"]
        seen = relievo.capture_many(self.renderer, iter(cameras), layers, size=(30, 20))
        self.assertIs(self.renderer.GetActiveCamera(), before)
        self.assertIsNone(self.renderer.GetPass())
        self.assertIsNone(self.renderer.GetRenderWindow())
        self.assertEqual(list(seen), layers)
        for i, camera in enumerate(cameras):
            self.renderer.SetActiveCamera(camera)
            image = relievo.capture(self.renderer, layers, size=(30, 20))
            for name in layers:
                numpy.testing.assert_array_equal(seen[name][i], relievo.layer(image, name), name)
        self.assertEqual((seen["cell"].shape, seen["color"].shape), ((5, 20, 30), (5, 20, 30, 4)))
        self.assertGreater(len({view.tobytes() for view in seen["depth"]}), 3)
        with self.assertRaisesRegex(ValueError, "'detph'"):
            relievo.capture_many(self.renderer, cameras, "detph", size=(8, 8))
        self.assertIs(self.renderer.GetActiveCamera(), cameras[-1])
        sensors = [relievo.lens("fisheye", (24, 16)), relievo.lens("fisheye", (16, 16))]
        with mock.patch("relievo._captures.capture.rays", wraps=relievo.rays) as made:
            pictures = relievo.capture_many(self.renderer, sensors[:1] * 2, ["color", "depth"],
                                            size=(24, 16))  # fmt: skip
        made.assert_called_once()
        image = relievo.capture(self.renderer, ["color", "depth"], camera=sensors[0])
        for name, views in pictures.items():
            numpy.testing.assert_array_equal(views[1], relievo.layer(image, name), name)
        # The tree stays for the next capture, and follows the scene.
        self.renderer.GetActors().GetLastActor().SetScale(1.5)
        with mock.patch("relievo._captures.capture.rays", wraps=relievo.rays) as made:
            kept = relievo.layer(relievo.capture(self.renderer, "depth", camera=sensors[0]),
                                 "depth")  # fmt: skip
        made.assert_not_called()
        new = relievo.capture(relievo.rays(self.renderer), "depth", camera=sensors[0])
        numpy.testing.assert_array_equal(kept, relievo.layer(new, "depth"))
        self.assertTrue((kept != pictures["depth"][0]).any())
        other = vtkRenderer()
        scenes.add(other, vtkSphereSource())
        with mock.patch("relievo._captures.capture.rays", wraps=relievo.rays) as made:
            relievo.capture(other, "depth", camera=sensors[0])
        made.assert_called_once()
        for says, *invalid in (
            ("cameras: got \\[\\]", []),
            ("cameras: got None", None),
            ("cameras: got", [cameras[0], sensors[0]]),
            ("expected models of one size", sensors),
            ("expected models of one size", sensors[:1], "depth", (24, 17)),
        ):
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                relievo.capture_many(self.renderer, *invalid)

    def test_many_cameras_together(self):
        """Views of one frame equal single captures of props that VTK's cullers leave out, of lines
        and points wider than a pixel, of glyphs and blocks, and beyond one batch of views."""
        renderer = self.renderer

        def ball(*center):
            source = vtkSphereSource()
            source.SetCenter(center)
            return scenes.add(renderer, source)

        for place in ((3, 0, 0), (0, 3, 0), (0, 0, -40)):
            ball(*place)
        wires = ball(1, 1, 0)
        wires.GetProperty().SetRepresentationToWireframe()
        wires.GetProperty().SetLineWidth(5)
        shared = vtkActor()  # mappers of VTK 9.7 keep the shader of wide lines
        shared.SetMapper(wires.GetMapper())
        shared.SetPosition(-3, 0, 1)
        renderer.AddActor(shared)
        dots = ball(-1, 1, 0)
        dots.GetProperty().SetRepresentationToPoints()
        dots.GetProperty().SetPointSize(7)
        glyphs = vtkGlyph3DMapper()
        corners, small = vtkPlaneSource(), vtkSphereSource()
        glyphs.SetInputConnection(corners.GetOutputPort())
        glyphs.SetSourceConnection(small.GetOutputPort())
        glyphs.SetScaleFactor(0.2)
        instances = vtkActor()
        instances.SetMapper(glyphs)
        instances.SetPosition(0, -2, 0)
        renderer.AddActor(instances)
        light = vtkLight()
        light.SetLightTypeToHeadlight()
        renderer.AddLight(light)
        lots = numpy.random.default_rng(4)
        cameras = []
        for i in range(130):  # 128 views of 64 x 64 pixels and two words fill a batch
            camera = vtkCamera()
            camera.SetPosition(2 * lots.normal(size=3))
            camera.SetFocalPoint(lots.normal(size=3))
            camera.SetViewUp(lots.normal(size=3))
            camera.SetClippingRange(0.01, 60 if i % 3 else 900)  # beyond 1e4: another shader
            camera.SetParallelProjection(i % 7 == 5)
            cameras.append(camera)
        moved = []
        light.AddObserver("ModifiedEvent", lambda *_: moved.append(1))
        for layers, apart in ((["depth"], False), (["normal", "cell", "actor", "Normals"], False),
                              (["depth", "color"], False), (["depth"], True)):
            with self.subTest(layers, apart=apart):
                views = cameras[:130 if layers == ["depth"] else 12]
                renderer.SetActiveCamera(cameras[-1])
                renderer.RemoveAllObservers()
                if apart:
                    renderer.AddObserver("StartEvent", lambda *_: None)
                moved.clear()
                seen = relievo.capture_many(renderer, views, layers, size=(64, 64))
                frames = len(moved)
                self.assertEqual(frames > len(views) / 2, apart or "color" in layers)
                for i, camera in enumerate(views):
                    renderer.SetActiveCamera(camera)
                    image = relievo.capture(renderer, layers, size=(64, 64))
                    for name in layers:
                        numpy.testing.assert_array_equal(
                            seen[name][i], relievo.layer(image, name), f"{name} of view {i}")
        self.assertGreater(numpy.isfinite(seen["depth"]).mean(), 0.05)
        self.assertLess(numpy.isfinite(seen["depth"]).mean(), 0.9)

    def alone(self, renderer, camera, layers):
        """The layers of a single capture, of a pipeline that knows of the change of cameras."""
        camera.Modified()
        renderer.SetActiveCamera(camera)
        image = relievo.capture(renderer, layers, size=(24, 16))
        return {name: relievo.layer(image, name) for name in layers}

    def test_views_of_different_data(self):
        """Types and components of a data array differ between the meshes that views show."""
        renderer = vtkRenderer()
        cameras = []
        for x, values in ((0, numpy.float32([[3]])), (100, numpy.float64([[0.1, 7]])), (200, None)):
            camera = vtkCamera()
            camera.SetPosition(x, 0, 4)
            camera.SetFocalPoint(x, 0, 0)
            camera.SetClippingRange(1, 9)
            cameras.append(camera)
            if values is not None:
                ball = vtkSphereSource()
                ball.SetCenter(x, 0, 0)
                ball.Update()
                array = numpy_to_vtk(values.repeat(ball.GetOutput().GetNumberOfPoints(), 0), 1)
                array.SetName("heat")
                ball.GetOutput().GetPointData().AddArray(array)
                mapper = vtkPolyDataMapper()
                mapper.SetInputData(ball.GetOutput())
                actor = vtkActor()
                actor.SetMapper(mapper)
                renderer.AddActor(actor)
        narrow, wide, away = cameras
        for order in ([away, wide, narrow], [narrow, wide, away], [away, narrow], [narrow, away],
                      [wide, away]):  # fmt: skip
            seen = relievo.capture_many(renderer, order, ["heat", "Normals"], size=(24, 16))
            most = 2 if wide in order else 1
            self.assertEqual(seen["heat"].dtype, numpy.float64 if most == 2 else numpy.float32)
            heat = seen["heat"].reshape(len(order), 16, 24, most)
            self.assertEqual(seen["Normals"].shape, (len(order), 16, 24, 3))
            for i, camera in enumerate(order):
                one = self.alone(renderer, camera, ["heat", "Normals"])
                values = one["heat"].reshape(16, 24, -1)
                there = values.shape[-1]
                numpy.testing.assert_array_equal(heat[i, ..., :there], values)
                self.assertTrue(numpy.isnan(heat[i, ..., there:]).all())
                self.assertEqual(numpy.isfinite(values).any(), camera is not away)
                numpy.testing.assert_array_equal(seen["Normals"][i],
                                                 one["Normals"].reshape(16, 24, -1) * [1, 1, 1])
        source = vtkRelievoLayerSource()
        renderer.SetActiveCamera(narrow)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetSize(24, 16)
        window.AddRenderer(renderer)
        source.SetRenderer(renderer)
        for name in ("depth", "heat", "depth"):
            source.AddLayer(name)
        for camera in (narrow, wide):
            source.AddView(camera)
        source.Update()
        values = source.GetOutput().GetPointData()
        self.assertEqual((values.GetNumberOfArrays(), values.GetArrayName(0)), (2, "depth"))
        self.assertEqual(values.GetArray("depth").GetNumberOfTuples(), 2 * 24 * 16)

    @unittest.skipUnless(vtkDistanceToCamera, "no vtkDistanceToCamera")
    def test_views_of_pipelines_that_follow_the_camera(self):
        """Data of points and of glyphs by their distance to the camera."""
        renderer = vtkRenderer()
        for right, glyphs in ((-0.6, False), (0.6, True)):
            plane = vtkPlaneSource()
            plane.SetResolution(4, 4)
            plane.SetCenter(right, 0, 0)
            distance = vtkDistanceToCamera()
            distance.SetInputConnection(plane.GetOutputPort())
            distance.SetRenderer(renderer)
            mapper = vtkGlyph3DMapper() if glyphs else vtkPolyDataMapper()
            mapper.SetInputConnection(distance.GetOutputPort())
            if glyphs:
                ball = vtkSphereSource()
                mapper.SetSourceConnection(ball.GetOutputPort())
                mapper.SetScaleFactor(0.3)
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)
        cameras = []
        for away in (3, 5, 4):
            camera = vtkCamera()
            camera.SetPosition(0, 0, away)
            camera.SetClippingRange(1, 9)
            cameras.append(camera)
        layers = ["DistanceToCamera", "depth"]
        seen = relievo.capture_many(renderer, cameras, layers, size=(24, 16))
        for i, camera in enumerate(cameras):
            for name, values in self.alone(renderer, camera, layers).items():
                numpy.testing.assert_array_equal(seen[name][i], values, f"{name} of view {i}")
        left, right = seen["DistanceToCamera"][..., :12], seen["DistanceToCamera"][..., 12:]
        for half in (left, right):
            means = numpy.nanmean(half, (1, 2))
            self.assertEqual(list(numpy.argsort(means)), [0, 2, 1])

    def test_views_of_spheres_beside_offsets(self):
        """VTK's shaders of spheres read the depth before they write it, if surfaces are shifted."""
        renderer = vtkRenderer()
        dots = scenes.add(renderer, vtkSphereSource())
        dots.GetProperty().SetRepresentationToPoints()
        dots.GetProperty().SetPointSize(9)
        dots.GetProperty().RenderPointsAsSpheresOn()
        cameras = []
        for x in (0, 1, 2):
            camera = vtkCamera()
            camera.SetPosition(x, 0, 3)
            camera.SetClippingRange(1, 9)
            cameras.append(camera)
        before = vtkMapper.GetResolveCoincidentTopology()
        self.addCleanup(vtkMapper.SetResolveCoincidentTopology, before)
        vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
        seen = relievo.capture_many(renderer, cameras, "depth", size=(24, 16))["depth"]
        for i, camera in enumerate(cameras):
            self.assertTrue(numpy.isfinite(seen[i]).any())
            numpy.testing.assert_array_equal(seen[i],
                                             self.alone(renderer, camera, ["depth"])["depth"])

    def test_views_beyond_the_memory(self):
        before = self.renderer.GetActiveCamera()
        with self.assertRaisesRegex(MemoryError, "300000 views .* would take"):
            relievo.capture_many(self.renderer, [vtkCamera()] * 300000, "position", size=(500, 500))
        self.assertIs(self.renderer.GetActiveCamera(), before)

    def test_unknown_layer(self):
        with self.assertRaises(ValueError) as caught:
            relievo.capture(self.renderer, ["depth", "detph"], size=(8, 8))
        self.assertIn("'detph'", str(caught.exception))
        self.assertIsNone(self.renderer.GetPass())
        self.assertIsNone(self.renderer.GetRenderWindow())

    def test_above_the_limit_of_opengl(self):
        with self.assertRaises(ValueError) as caught:
            relievo.capture(self.renderer, "depth", size=(65536, 4))
        self.assertIn("65536", str(caught.exception))
        # An OpenGL whose limit is lower than ours.
        with mock.patch("relievo._captures.capture.vtkTextureObject") as textures:
            textures.GetMaximumTextureSize.return_value = 4096
            with self.assertRaisesRegex(ValueError, r"got \(4, 4097\), expected at most 4096"):
                relievo.capture(self.renderer, "depth", size=(4, 4097))
            relievo.capture(self.renderer, "depth", size=(4, 4096))


if __name__ == "__main__":
    unittest.main(verbosity=2)
