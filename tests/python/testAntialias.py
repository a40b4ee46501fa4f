# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stage antialias: edges against the area of each pixel covered by a polygon, and the
unchanged camera, layers, and pictures without it."""

import unittest

import numpy
from frames import picture
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import relievo

# In pixels; its edges are steep, flat, and in between.
CORNERS = numpy.array([(5.3, 3.1), (57.2, 9.7), (49.9, 41.3), (7.4, 44.2)])
COLUMNS, ROWS = 64, 48


def clip(polygon, axis, limit, sign):
    """The part of the polygon on one side of a line: Sutherland and Hodgman, 1974."""
    inside = []
    for a, b in zip(polygon, numpy.roll(polygon, -1, axis=0)):
        ahead, behind = sign * (a[axis] - limit), sign * (b[axis] - limit)
        if ahead >= 0:
            inside.append(a)
        if ahead * behind < 0:
            inside.append(a + (b - a) * (ahead / (ahead - behind)))
    return numpy.array(inside).reshape(-1, 2)


def covered(polygon):
    """The share of each pixel that the polygon covers, the bottom row first."""
    shares = numpy.zeros((ROWS, COLUMNS))
    for row, column in numpy.ndindex(shares.shape):
        part = polygon
        for axis, low in ((0, column), (1, row)):
            for limit, sign in ((low, 1), (low + 1, -1)):
                part = clip(part, axis, limit, sign) if len(part) else part
        if len(part) > 2:
            x, y = part.T
            shares[row, column] = 0.5 * abs(x @ numpy.roll(y, -1) - y @ numpy.roll(x, -1))
    return shares


def linear(bytes_of):
    value = bytes_of / 255.0
    return numpy.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


class Antialias(unittest.TestCase):
    def setUp(self):
        points, faces = vtkPoints(), vtkCellArray()
        points.SetDataTypeToDouble()
        for x, y in CORNERS:
            points.InsertNextPoint(x, y, 0)
        faces.InsertNextCell(len(CORNERS), range(len(CORNERS)))
        surface = vtkPolyData()
        surface.SetPoints(points)
        surface.SetPolys(faces)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(COLUMNS, ROWS)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(COLUMNS / 2, ROWS / 2, 100)
        camera.SetFocalPoint(COLUMNS / 2, ROWS / 2, 0)
        camera.SetClippingRange(50, 150)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(ROWS / 2)
        self.camera = camera
        self.plain = picture(self.window)
        self.frame = relievo.attach(self.renderer)
        self.frame.WaitForSamplesOn()

    def show_edges(self, shown=True):
        self.renderer.GetActors().GetLastActor().GetProperty().SetEdgeVisibility(shown)

    def smooth(self, samples):
        relievo.stage(self.renderer, "antialias", samples=samples)
        return picture(self.window)

    def error(self, samples, shares):
        difference = linear(self.smooth(samples)[..., 0].astype(float)) - shares
        return numpy.sqrt((difference[(shares > 0) & (shares < 1)] ** 2).mean())

    def test_area(self):
        """The error falls as that of points that are spread evenly, and nothing is moved."""
        shares = covered(CORNERS)
        errors = {samples: self.error(samples, shares) for samples in (1, 4, 16, 64, 256)}
        self.assertGreater(errors[1], 0.25)
        for samples, limit in ((4, 0.15), (16, 0.05), (64, 0.02), (256, 0.008)):
            self.assertLess(errors[samples], limit, errors)
        # An offset of all by a tenth of a pixel would show in the mean over an edge's slope.
        light = linear(self.smooth(64)[..., 0].astype(float))
        down, across = numpy.mgrid[0:ROWS, 0:COLUMNS] + 0.5
        for axis in down, across:
            self.assertAlmostEqual(
                (light * axis).sum() / light.sum(), (shares * axis).sum() / shares.sum(),
                delta=0.01)  # fmt: skip

    def test_translucent(self):
        """A translucent surface has smooth edges, too, and is drawn as often as an opaque one."""
        actor = self.renderer.GetActors().GetLastActor()
        draws = []
        actor.GetMapper().AddObserver("StartEvent", lambda *_: draws.append(opacity))
        for opacity in 1.0, 0.5:
            actor.GetProperty().SetOpacity(opacity)
            light = linear(self.smooth(8)[..., 0].astype(float))
            self.assertIn("drawn at once", self.frame.GetFrameReport())
            shares, whole = covered(CORNERS), linear(255 * opacity)
            self.assertLess(numpy.sqrt(((light - whole * shares) ** 2).mean()), 0.02)
            numpy.testing.assert_allclose(light[shares == 1], whole, atol=0.005)
        self.assertEqual(draws.count(0.5), draws.count(1.0), draws)

    def test_moving(self):
        """A picture of the first sample alone is filtered, an accumulated one is not, whether or
        not the window has samples of its own."""
        shares = covered(CORNERS)
        edges = (shares > 0) & (shares < 1)
        single = self.error(1, shares)
        resting = set()
        # 0 last: after a failure, FXAA shows its earlier picture.
        for multi in vtkRenderWindow().GetMultiSamples(), 4, 0:
            with self.subTest(multisamples=multi):
                self.window.SetMultiSamples(multi)
                self.frame.WaitForSamplesOn()
                gathered = self.smooth(16)
                difference = linear(gathered[..., 0].astype(float)) - shares
                self.assertLess(numpy.sqrt((difference[edges] ** 2).mean()), 0.05)
                self.frame.WaitForSamplesOff()
                for angle in 1, -1:  # a polygon that is 0.02 % narrower, and itself again
                    self.camera.Azimuth(angle)
                    shown = picture(self.window)
                    self.assertEqual(self.frame.GetSamplesLeft(), 15)
                    difference = linear(shown[..., 0].astype(float)) - shares
                    self.assertLess(numpy.sqrt((difference[edges] ** 2).mean()), 0.8 * single)
                    numpy.testing.assert_array_equal(
                        shown[15:35, 20:45], gathered[15:35, 20:45])  # inside
                for _ in range(14):
                    self.window.Render()
                numpy.testing.assert_array_equal(picture(self.window), gathered)
                resting.add(gathered.tobytes())
        self.assertEqual(len(resting), 1)

    def test_projections(self):
        """In every kind of projection the sum of the light is that of the exact areas."""
        def perspective():
            self.camera.ParallelProjectionOff()
            self.camera.SetViewAngle(2 * numpy.degrees(numpy.arctan(ROWS / 2 / 100)))

        def shifted():
            self.camera.SetWindowCenter(0.2, -0.1)

        def explicit():
            matrix = vtkMatrix4x4()
            matrix.DeepCopy(self.camera.GetProjectionTransformMatrix(COLUMNS / ROWS, -1, 1))
            self.camera.SetWindowCenter(0, 0)
            self.camera.SetExplicitProjectionTransformMatrix(matrix)
            self.camera.UseExplicitProjectionTransformMatrixOn()

        moved = CORNERS - numpy.array([0.2 * COLUMNS / 2, -0.1 * ROWS / 2])
        for change, corners in ((perspective, CORNERS), (shifted, moved), (explicit, moved)):
            with self.subTest(change.__name__):
                change()
                self.assertLess(self.error(64, covered(corners)), 0.02)

    def test_camera(self):
        """A moving camera sends no events, and is restored afterwards."""
        told = []
        self.camera.AddObserver("ModifiedEvent", lambda *_: told.append(1))
        before = self.camera.GetMTime()
        matrix = vtkMatrix4x4()
        matrix.DeepCopy(self.camera.GetProjectionTransformMatrix(COLUMNS / ROWS, -1, 1))
        self.smooth(16)
        self.assertEqual((self.camera.GetMTime(), told), (before, []))
        self.assertFalse(self.camera.GetUseExplicitProjectionTransformMatrix())
        after = self.camera.GetProjectionTransformMatrix(COLUMNS / ROWS, -1, 1)
        self.assertEqual(
            [matrix.GetElement(i, j) for i in range(4) for j in range(4)],
            [after.GetElement(i, j) for i in range(4) for j in range(4)])  # fmt: skip
        self.frame.GetStage("antialias").EnabledOff()
        numpy.testing.assert_array_equal(picture(self.window), self.plain)

    def test_gathering(self):
        """A resting picture becomes the one that waits for all: plain surfaces in the second frame,
        lines by one sample in each."""
        for edges, expected in (False, [7, 0]), (True, list(range(7, -1, -1))):
            with self.subTest(edges=edges):
                self.show_edges(edges)
                self.frame.WaitForSamplesOn()
                whole = self.smooth(8)
                self.frame.WaitForSamplesOff()
                self.camera.Azimuth(1)
                self.window.Render()
                self.camera.Azimuth(-1)
                left = []
                while not left or left[-1] > 0:
                    last = picture(self.window)
                    left.append(self.frame.GetSamplesLeft())
                self.assertEqual(left, expected)
                numpy.testing.assert_array_equal(last, whole)
                numpy.testing.assert_array_equal(picture(self.window), whole)

    def test_shaders_that_know_the_pixel(self):
        """Stripes a pixel wide, by a user's own code, are as wide when edges are smooth."""
        own = self.renderer.GetActors().GetLastActor().GetShaderProperty()
        own.AddFragmentShaderReplacement(
            "//VTK::Light::Impl", True,
            "//VTK::Light::Impl\n  if (mod(floor(gl_FragCoord.x), 2.0) > 0.5)\n"
            "    gl_FragData[0].rgb = vec3(0.0);\n", False)  # fmt: skip
        stripes = self.smooth(8)[15:35, 20:45, 0]
        self.assertIn("8 of 8 samples, one by one: an actor's own shaders depend on the pixel",
                      self.frame.GetFrameReport())  # fmt: skip
        numpy.testing.assert_array_equal(stripes[:, 1::2], 0)
        numpy.testing.assert_array_equal(stripes[:, ::2], 255)

    def test_parts(self):
        """A raster that is too large for one drawing is drawn in parts, without a seam."""
        self.window.SetSize(1280, 960)
        scale = 1280 / COLUMNS
        smooth = linear(self.smooth(24)[..., 0].astype(float))
        self.assertIn("drawn at once", self.frame.GetFrameReport())
        down, across = numpy.mgrid[0:960, 0:1280] + 0.5
        area = 0.5 * abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in
                             zip(CORNERS, numpy.roll(CORNERS, -1, axis=0))))  # fmt: skip
        self.assertAlmostEqual(smooth.sum() / (area * scale**2), 1, delta=2e-4)
        # Pixels whose centre is a pixel and more inside or outside are whole.
        distance = numpy.full(down.shape, numpy.inf)
        for a, b in zip(scale * CORNERS, scale * numpy.roll(CORNERS, -1, axis=0)):
            along = (b - a) / numpy.linalg.norm(b - a)
            distance = numpy.minimum(
                distance, along[0] * (down - a[1]) - along[1] * (across - a[0]))  # fmt: skip
        numpy.testing.assert_array_equal(smooth[distance > 1], 1)
        numpy.testing.assert_array_equal(smooth[distance < -1], 0)

    def test_triangles_that_are_left_out(self):
        """In pixels that get all samples, only their triangles are drawn: the picture is that of
        all triangles, which an actor's own shader asks for, near and behind the eye and far from
        the origin."""
        numbers = numpy.random.default_rng(5)
        centers = numbers.uniform((-20, -20, -60), (84, 68, 120), (300, 3))
        corners = centers[:, None] + numbers.normal(0, (4, 4, 30), (300, 3, 3))
        self.camera.ParallelProjectionOff()
        self.camera.SetClippingRange(1, 200)
        actor = self.renderer.GetActors().GetLastActor()
        for origin in (0, 1e4):
            points, faces = vtkPoints(), vtkCellArray()
            points.SetDataTypeToDouble()
            for i, corner in enumerate(corners.reshape(-1, 3)):
                points.InsertNextPoint(*(corner + origin))
                if i % 3 == 2:
                    faces.InsertNextCell(3, (i - 2, i - 1, i))
            soup = vtkPolyData()
            soup.SetPoints(points)
            soup.SetPolys(faces)
            actor.GetMapper().SetInputData(soup)
            actor.SetPosition(-origin, -origin, -origin)
            actor.GetProperty().LightingOn()
            fewer = self.smooth(24)
            self.assertRegex(self.frame.GetFrameReport(), r"41 samples in [1-9][0-9.]* % of")
            actor.GetShaderProperty().AddFragmentShaderReplacement(
                "//VTK::Light::Impl", True, "// own\n//VTK::Light::Impl", False)  # fmt: skip
            numpy.testing.assert_array_equal(fewer, self.smooth(24))
            self.assertIn("drawn at once", self.frame.GetFrameReport())
            actor.GetShaderProperty().ClearAllFragmentShaderReplacements()
            self.assertGreater(numpy.ptp(fewer), 100)

    def test_parts_of_marked_pixels(self):
        """Pixels that get all samples are drawn in parts, each with its own triangles: the picture
        is that of one part with all triangles, which actors' own shaders ask for, but for
        rounding in a few pixels. An actor without triangles changes nothing."""
        self.window.SetSize(400, 320)  # parts are drawn in the memory of the few samples
        numbers = numpy.random.default_rng(7)
        actors, draws = [], []
        for i in range(2):
            points, faces = vtkPoints(), vtkCellArray()
            centers = numbers.uniform((-32, -24, -20), (32, 24, 20), (300, 3))
            for corner in (centers[:, None] + numbers.normal(0, 3, (300, 3, 3))).reshape(-1, 3):
                points.InsertNextPoint(*corner)
            for corner in range(0, 900, 3):
                faces.InsertNextCell(3, range(corner, corner + 3))
            soup = vtkPolyData()
            soup.SetPoints(points)
            soup.SetPolys(faces)
            actors.append(vtkActor())
            actors[i].SetMapper(vtkPolyDataMapper())
            actors[i].GetMapper().SetInputData(soup)
            actors[i].GetProperty().SetColor(*numbers.uniform(0.3, 1, 3))
        actors[0].GetMapper().AddObserver("StartEvent", lambda *_: draws.append(1))
        actors[0].RotateWXYZ(40, 1, 2, 3)
        actors.append(vtkActor())  # another one of the second's mapper
        actors[2].SetMapper(actors[1].GetMapper())
        actors[2].SetProperty(actors[1].GetProperty())
        actors[2].SetPosition(8, 5, 6)
        for actor in actors:
            actor.AddPosition(32, 24, 0)
            actor.GetProperty().LightingOff()
            self.renderer.AddActor(actor)
        empty = vtkActor()
        empty.SetMapper(vtkPolyDataMapper())
        empty.GetMapper().SetInputData(vtkPolyData())
        drawn = {}
        for case in "parts", "with an empty one", "whole":
            if case == "with an empty one":
                self.renderer.AddActor(empty)
            elif case == "whole":
                for actor in actors:
                    actor.GetShaderProperty().AddFragmentShaderReplacement(
                        "//VTK::Light::Impl", True, "// own\n//VTK::Light::Impl", False)
            draws.clear()
            shown = self.smooth(24)
            drawn[case] = shown, len(draws)
        shown, count = drawn["parts"]
        numpy.testing.assert_array_equal(drawn["with an empty one"][0], shown)
        self.assertEqual(drawn["with an empty one"][1], count)
        whole, fewer = drawn["whole"]
        self.assertGreater(count, fewer)
        differing = (whole != shown).any(axis=-1).sum()
        self.assertLess(differing, 40)

    def test_one_by_one(self):
        """A program that must answer meanwhile gets a sample a frame; a picture that waits is that
        which is drawn at once."""
        whole = self.smooth(8)
        self.assertIn("drawn at once", self.frame.GetFrameReport())
        self.frame.WaitForSamplesOff()
        for one_by_one, left in ((False, [7, 0, 0]), (True, [7, 6, 5, 4, 3, 2, 1, 0, 0])):
            self.frame.SetSamplesOneByOne(one_by_one)
            self.camera.Azimuth(1)
            self.window.Render()
            self.camera.Azimuth(-1)
            found = []
            for _ in left:
                last = picture(self.window)
                found.append(self.frame.GetSamplesLeft())
            self.assertEqual(found, left)
            self.assertEqual(one_by_one, (last != whole).any())
        self.frame.WaitForSamplesOn()
        numpy.testing.assert_array_equal(picture(self.window), whole)
        self.frame.WaitForSamplesOff()
        # It stays, until something changes.
        numpy.testing.assert_array_equal(picture(self.window), whole)
        self.assertEqual(self.frame.GetSamplesLeft(), 0)

    def test_captures_and_screenshots_let_it_gather(self):
        """A capture of layers draws none of its samples, a vtkWindowToImageFilter's is one."""
        self.show_edges()  # so that samples are drawn one by one
        whole = self.smooth(8)
        relievo.capture(self.renderer)  # the first one gives actors their keys, which counts
        self.frame.WaitForSamplesOff()
        self.camera.Azimuth(1)
        self.window.Render()
        self.camera.Azimuth(-1)
        self.window.Render()
        self.assertEqual(self.frame.GetSamplesLeft(), 7)
        relievo.capture(self.renderer, ["depth", "cell"])
        self.assertEqual(self.frame.GetSamplesLeft(), 7)
        self.window.Render()
        self.assertEqual(self.frame.GetSamplesLeft(), 6)
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.Update()
        self.assertEqual(self.frame.GetSamplesLeft(), 5)
        while self.frame.GetSamplesLeft() > 0:
            last = picture(self.window)
        numpy.testing.assert_array_equal(last, whole)
        # Changes of the renderer restart accumulation.
        self.renderer.SetTwoSidedLighting(False)
        self.window.Render()
        self.assertEqual(self.frame.GetSamplesLeft(), 7)

    def test_layers(self):
        """Layers are those of the pixels' centres, captured or made with the picture."""
        names = ["depth", "normal", "cell"]
        expected = relievo.capture(self.renderer, names)
        self.smooth(16)
        captured = relievo.capture(self.renderer, names)
        for name in names:
            self.frame.RequestLayer(name)
        self.window.Render()
        self.assertEqual(self.frame.GetStage("antialias").GetReasonCode(), "idle")
        for name in names:
            numpy.testing.assert_array_equal(
                relievo.layer(captured, name), relievo.layer(expected, name))  # fmt: skip
        self.frame.ReleaseLayers()
        self.window.Render()
        self.assertEqual(self.frame.GetStage("antialias").GetReasonCode(), "ran")

    def test_hard_shadows_stay_hard(self):
        """Samples of edges are none of lights: a sun is a point, and its map stays as it was drawn
        for the first of them."""
        self.show_edges()  # so that samples are drawn one by one
        sun = vtkLight()
        sun.SetLightTypeToSceneLight()
        sun.SetPosition(1, 2, 3)
        self.renderer.AddLight(sun)
        self.frame.GetShadowStage().SetLightSize(sun, 10)
        relievo.stage(self.renderer, "shadows")
        for samples, drawn in ((0, 0), (4, 1)):
            relievo.stage(self.renderer, "shadows", soft_samples=samples)
            self.smooth(16)
            stage = self.frame.GetShadowStage()
            self.assertEqual(stage.GetReasonCode(), "ran")
            self.assertEqual(stage.GetNumberOfMapsDrawn(), drawn, "for the last sample")


if __name__ == "__main__":
    unittest.main()
