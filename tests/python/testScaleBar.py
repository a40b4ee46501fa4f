# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scale bar is as long as the measured length: a plane of known width drawn by VTK. The colour
bar's colours are its map's, and its values are round."""

import itertools
import math
import unittest

import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkRenderer,
    vtkWindowToImageFilter,
)


def seen(window, scale=1, border=False):
    """The window's picture, row 0 at the top; in tiles if the scale is above 1."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetScale(scale)
    grab.SetFixBoundary(border)
    grab.ReadFrontBufferOff()
    grab.Update()
    columns, rows, _ = grab.GetOutput().GetDimensions()
    values = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return values.reshape(rows, columns, 3)[::-1].astype(int)


def runs(line):
    """Beginnings and ends of runs of true values in a line."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate([[0], line, [0]]).astype(int)))
    return list(zip(edges[::2], edges[1::2], strict=True))


def longest(mask):
    """The longest run of pixels in a row, as (row, begin, end)."""
    found = [(end - begin, row, begin, end) for row in range(len(mask))
             for begin, end in runs(mask[row])]  # fmt: skip
    return max(found)[1:] if found else (0, 0, 0)


def bar_of(picture, value=255):
    """The row, begin and end of the bar, which is white, or another grey, near the lower edge."""
    rows = len(picture)
    below = (picture == value).all(axis=2)[rows - rows // 8 :]
    row, begin, end = longest(below)
    return rows - rows // 8 + row, begin, end


def length_of(picture, value=255):
    _, begin, end = bar_of(picture, value)
    return end - begin


def placed(parallel, background=(0, 0, 0)):
    """A renderer with an oblique camera."""
    renderer = vtkRenderer()
    renderer.SetBackground(*background)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(3, -4, 12)
    camera.SetFocalPoint(1, 2, -1)
    camera.SetViewUp(0.2, 1, 0.1)
    camera.SetViewAngle(40)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(7)
    camera.SetClippingRange(1, 100)
    return renderer


def add_strip(renderer, length, depth=None):
    """A green strip of a length across the view, in the middle of the camera's axis."""
    camera = renderer.GetActiveCamera()
    eye, along = (numpy.array(each) for each in
                  (camera.GetPosition(), camera.GetDirectionOfProjection()))  # fmt: skip
    right = numpy.cross(along, camera.GetViewUp())
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, along) * length
    middle = eye + (camera.GetDistance() if depth is None else depth) * along
    plane = vtkPlaneSource()
    plane.SetOutputPointsPrecision(1)
    corner = middle - right * length / 2 - up / 40
    plane.SetOrigin(*corner)
    plane.SetPoint1(*(corner + right * length))
    plane.SetPoint2(*(corner + up / 20))
    actor = scenes.add(renderer, plane)
    actor.GetProperty().SetColor(0, 1, 0)
    actor.GetProperty().LightingOff()
    return actor


def strip_of(picture):
    _, begin, end = longest((picture[..., 1] > 100) & (picture[..., 0] < 100))
    return end - begin


class Length(unittest.TestCase):
    def check(self, renderer, window, bar, depth=None, **grab):
        shown = bar.GetShownLength(renderer)
        add_strip(renderer, shown, depth)
        picture = seen(window, **grab)
        self.assertLessEqual(abs(length_of(picture) - strip_of(picture)), 1)
        self.assertGreater(length_of(picture), 15)
        return length_of(picture), shown

    def test_parallel(self):
        """By hand as well: pixels of the height for each of its 14 units."""
        for size, length, label in (((401, 301), None, "2 mm"), ((640, 299), None, "5 mm"),
                                    ((333, 501), 1.75, "1.75 mm")):  # fmt: skip
            with self.subTest(size=size):
                renderer = placed(True)
                window = scenes.window_of(renderer, *size)
                bar = relievo.scale_bar(renderer, "mm", length)
                pixels, shown = self.check(renderer, window, bar)
                self.assertEqual(bar.GetLabel(renderer), label)
                self.assertLessEqual(abs(pixels - float(label[:-3]) * size[1] / 14), 0.5)

    def test_perspective(self):
        """At the focal point, at a depth of its own, and by the angle of the width."""
        for depth, horizontal in itertools.product((None, 5.0, 40.0), (False, True)):
            with self.subTest(depth=depth, horizontal=horizontal):
                renderer = placed(False)
                renderer.GetActiveCamera().SetUseHorizontalViewAngle(horizontal)
                window = scenes.window_of(renderer, 431, 299)
                bar = relievo.scale_bar(renderer)
                bar.SetDepth(depth or 0)
                pixels, shown = self.check(renderer, window, bar, depth)
                at = depth or numpy.sqrt(2**2 + 6**2 + 13**2)
                half = at * numpy.tan(numpy.radians(20)) * (299 / 431 if horizontal else 1)
                self.assertLessEqual(abs(pixels - shown * 299 / (2 * half)), 0.5)

    def test_cameras(self):
        """Off axis, by a calibration's matrix, and in a part of the window."""
        for name in ("center", "matrix", "viewport"):
            for parallel in (False, True):
                with self.subTest(name=name, parallel=parallel):
                    renderer = placed(parallel)
                    camera = renderer.GetActiveCamera()
                    window = scenes.window_of(renderer, 601, 299)
                    if name == "center":
                        camera.SetWindowCenter(0.3, -0.2)
                    elif name == "viewport":
                        renderer.SetViewport(0.25, 0.03, 0.8, 0.9)
                    elif not parallel:
                        matrix = [[700, 0, 320], [0, 700, 140], [0, 0, 1]]
                        relievo.camera(renderer, K=matrix, size=(601, 299))
                    self.check(renderer, window, relievo.scale_bar(renderer, "m"))

    def test_tiles(self):
        """Of a picture in tiles it is that of a window of this size, also across their seams."""
        for parallel, border, share in itertools.product((False, True), (False, True), (0.2, 0.9)):
            with self.subTest(parallel=parallel, border=border, share=share):
                renderer = placed(parallel)
                window = scenes.window_of(renderer, 231, 149)
                bar = relievo.scale_bar(renderer, "mm")
                bar.SetShare(share)
                shown = bar.GetShownLength(renderer)
                pixels, _ = self.check(renderer, window, bar, scale=2, border=border)
                once = length_of(seen(window))
                self.assertLessEqual(abs(pixels - 2 * once), 2)
                if not border:
                    tiled = seen(window, scale=2)
                    window.SetSize(462, 298)
                    below = slice(260, None)
                    numpy.testing.assert_array_equal(tiled[below], seen(window)[below])
                    self.assertEqual(bar.GetShownLength(renderer), shown)

    def test_follows(self):
        """The camera, the size of the window and screenshots of another size, on each frame."""
        renderer = placed(True)
        window = scenes.window_of(renderer, 400, 300)
        bar = relievo.scale_bar(renderer, "mm")
        for half in (7, 8, 70, 0.004):
            renderer.GetActiveCamera().SetParallelScale(half)
            shown = bar.GetShownLength(renderer)
            self.assertLessEqual(abs(length_of(seen(window)) - shown * 150 / half), 1)
            share = shown * 150 / half / 400
            self.assertTrue(0.08 <= share <= 0.2, share)
        before = seen(window)
        window.SetSize(301, 411)
        shown = bar.GetShownLength(renderer)
        self.assertLessEqual(abs(length_of(seen(window)) - shown * 411 / 0.008), 1)
        window.SetSize(400, 300)
        numpy.testing.assert_array_equal(before, seen(window))
        renderer.GetActiveCamera().SetParallelScale(7)
        picture = relievo.screenshot(renderer, size=(800, 600)).astype(int)
        self.assertLessEqual(abs(length_of(picture) - 2 * 600 / 14), 1)


class Label(unittest.TestCase):
    def test_round_lengths(self):
        """The longest 1, 2 or 5 times a power of ten that fits, in decimals."""
        renderer = placed(True)
        window = scenes.window_of(renderer, 500, 500)
        bar = relievo.scale_bar(renderer, "µm")
        for fifth, label in (
            (1, "1 µm"), (1.999, "1 µm"), (2, "2 µm"), (4.99, "2 µm"), (5.01, "5 µm"),
            (9.99, "5 µm"), (10, "10 µm"), (1000, "1000 µm"), (3e6, "2000000 µm"),
            (0.5, "0.5 µm"), (0.0023, "0.002 µm"), (0.0001, "0.0001 µm"), (3e7, "2e+07 µm"),
            (7e-13, "5e-13 µm"), (3e40, "2e+40 µm"),
        ):  # fmt: skip
            renderer.GetActiveCamera().SetParallelScale(2.5 * fifth)
            self.assertEqual(bar.GetLabel(renderer), label)
            self.assertEqual(float(label.split()[0]), bar.GetShownLength(renderer))
        bar.SetUnit("")
        self.assertEqual(bar.GetLabel(renderer), "2e+40")
        window.RemoveRenderer(renderer)
        self.assertEqual(bar.GetLabel(renderer), "")

    def test_shown(self):
        """The text depends only on number and unit, and is completely inside the picture."""
        renderer = placed(True)
        window = scenes.window_of(renderer, 400, 300)
        for unit in (None, "mm", "µm", "light years of some other galaxy"):
            bar = relievo.scale_bar(renderer, unit)
            automatic = seen(window)
            self.assertFalse(automatic[:, :3].any() or automatic[:, -3:].any())
            self.assertFalse(automatic[-3:].any() or automatic[:260].any())
            bar.SetLength(bar.GetShownLength(renderer))
            numpy.testing.assert_array_equal(automatic, seen(window))
            row, begin, end = bar_of(automatic)
            self.assertTrue(3 < 400 - end < 20, end)
            text = (automatic[: row - 1] > 0).any(axis=(0, 2))
            self.assertGreater(text.sum(), 4)
            if unit != "light years of some other galaxy":
                begins, ends = numpy.flatnonzero(text)[[0, -1]]
                self.assertLess(abs(begins + ends - begin - end), 6)  # the middles are one
            bar.SetUnit("other")
            self.assertTrue((automatic != seen(window)).any())


class Picture(unittest.TestCase):
    def test_backgrounds(self):
        """Black or white, with an edge of the other, whatever is behind it."""
        rng = numpy.random.default_rng(1)
        for background in (0, 0.3, 0.7, 1, "gradient", "scene"):
            with self.subTest(background=background):
                renderer = placed(True)
                if background == "gradient":
                    renderer.GradientBackgroundOn()
                    renderer.SetBackground2(1, 1, 1)
                    ink = 255
                elif background == "scene":
                    for _ in range(40):
                        actor = add_strip(renderer, 40)
                        actor.GetProperty().SetColor(*rng.random(3))
                        actor.SetPosition(*rng.normal(size=3) * 5)
                    ink = 255
                else:
                    renderer.SetBackground(background, background, background)
                    ink = 0 if background > 0.5 else 255
                window = scenes.window_of(renderer, 400, 300)
                without = seen(window)
                relievo.scale_bar(renderer, "mm")
                picture = seen(window)
                changed = (without != picture).any(axis=2)
                row, begin, end = bar_of(numpy.where(changed[..., None], picture, 100), ink)
                if background in (0, 1):  # the edge is as the background
                    self.assertLessEqual(abs(end - begin - 2 * 300 / 14), 1)
                    continue
                self.assertLessEqual(abs(end - begin - 2 * 300 / 14), 1)
                edge = changed & (picture == 255 - ink).all(axis=2)
                middle = (begin + end) // 2
                for beside in (edge[row, begin - 1], edge[row, end], edge[row - 2 : row, middle],
                               edge[row + 1 : row + 4, middle]):  # fmt: skip
                    self.assertTrue(beside.any())

    def test_apart(self):
        """In no layer, without tone, and without a trace when it is off."""
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer, 400, 300)
        relievo.stage(renderer, "tone", exposure=-2)
        layers = ["depth", "actor", "normal"]
        pictures, captures = [seen(window)], [relievo.capture(renderer, layers)]
        bar = relievo.scale_bar(renderer, "mm")
        pictures.append(seen(window))
        captures.append(relievo.capture(renderer, layers))
        for name in layers:
            numpy.testing.assert_array_equal(*(relievo.layer(each, name) for each in captures))
        half = numpy.sqrt(2**2 + 3**2 + 12**2) * numpy.tan(numpy.radians(17.5))
        pixels = bar.GetShownLength(renderer) * 300 / (2 * half)
        self.assertLessEqual(abs(length_of(pictures[1]) - pixels), 1)  # pure white
        numpy.testing.assert_array_equal(pictures[0][:260], pictures[1][:260])
        bar.VisibilityOff()
        numpy.testing.assert_array_equal(pictures[0], seen(window))
        bar.VisibilityOn()
        numpy.testing.assert_array_equal(pictures[1], seen(window))
        again = relievo.scale_bar(renderer, "mm")
        self.assertFalse(renderer.HasViewProp(bar))
        numpy.testing.assert_array_equal(pictures[1], seen(window))
        renderer.RemoveViewProp(again)
        numpy.testing.assert_array_equal(pictures[0], seen(window))

    def test_too_long(self):
        """Reported once, with a fitting length, and nothing is drawn."""
        renderer = placed(True)
        window = scenes.window_of(renderer, 400, 300)
        without = seen(window)
        bar = relievo.scale_bar(renderer, "mm", 50)
        said = []

        def keep(_bar, _event, text):
            said.append(text)

        keep.CallDataType = "string0"
        bar.AddObserver("ErrorEvent", keep)
        for _ in range(3):
            numpy.testing.assert_array_equal(without, seen(window))
        self.assertEqual(len(said), 1)
        self.assertIn("Length is 50, and the picture is 18.6667 wide", said[0])
        bar.SetLength(18)
        self.assertLessEqual(abs(length_of(seen(window)) - 18 * 300 / 14), 1)

    def test_wrong_arguments(self):
        renderer = placed(True)
        for arguments, message in (
            ((renderer, 3), "unit: got 3"), ((renderer, "m\nm"), "unit: got"),
            ((renderer, "mm", 0), "length: got 0"), ((renderer, "mm", "5"), "length: got '5'"),
            ((renderer, "mm", float("nan")), "length: got nan"), ((3,), "renderer: got"),
        ):  # fmt: skip
            with self.assertRaisesRegex(ValueError, message):
                relievo.scale_bar(*arguments)
        self.assertEqual(renderer.GetViewProps().GetNumberOfItems(), 0)


class ColorBar(unittest.TestCase):
    def bar_of(self, low, high, size=(640, 480)):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        bar = relievo.vtkRelievoColorBar()
        grey = vtkColorTransferFunction()
        grey.AddRGBPoint(low, 0, 0, 0)
        grey.AddRGBPoint(high, 1, 1, 1)
        bar.SetLookupTable(grey)
        renderer.AddViewProp(bar)
        return scenes.window_of(renderer, *size), renderer, bar

    def test_smooth(self):
        """Each row has the map's colour, over about half the height, in small and large pictures,
        and in tiles."""
        for size, scale in (((400, 300), 1), ((4000, 3000), 1), ((500, 400), 2)):
            window, _, _ = self.bar_of(0, 1, size)
            picture = seen(window, scale)
            rows, columns = picture.shape[:2]
            # The column in the bar with the longest run between the black lines of its edges.
            band = picture[:, columns - columns // 4 :, 0]
            best = max(range(band.shape[1]), key=lambda x: len(set(band[:, x])))
            values = band[:, best]
            runs_ = [(end - begin, begin, end) for begin, end in
                     runs((values > 0) & (values < 255))]  # fmt: skip
            length, begin, end = max(runs_)
            self.assertTrue(0.45 < length / rows < 0.52, size)
            expected = 255 * (1 - (numpy.arange(length) + 0.5) / length)
            self.assertLess(abs(values[begin:end] - expected).max(), 255 / length + 3)
            self.assertGreater(len(set(values[begin:end])), min(140, length - 10))
            ink = (picture < 100).all(axis=2)[:, -columns // 30 :].any(axis=1)
            heights = [end - begin for begin, end in runs(ink)]
            self.assertGreaterEqual(max(heights), 7)  # pixels of a digit

    def test_round_values(self):
        """1, 2 or 5 times a power of ten apart, in the range, as many as fit."""
        rng = numpy.random.default_rng(4)
        ranges = [(0, 1), (-1, 1), (-12345, 98765), (101325, 101326), (0, 1e-4), (1e9, 3e9),
                  (0, 1e300), (-1e-9, 2e-9), (293.15, 294)]  # fmt: skip
        for _ in range(60):
            middle, width = rng.normal() * 10.0 ** rng.integers(-6, 7), 10.0 ** rng.uniform(-3, 6)
            ranges.append((middle - width, middle + width))
        window, renderer, bar = self.bar_of(0, 1)
        for low, high in ranges:
            with self.subTest(low=low, high=high):
                grey = vtkColorTransferFunction()
                grey.AddRGBPoint(low, 0, 0, 0)
                grey.AddRGBPoint(high, 1, 1, 1)
                bar.SetLookupTable(grey)
                title, *texts = bar.GetTexts(renderer).split("\n")
                raised = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
                power = title.strip("()").replace("×10", "1e").translate(raised)
                factor = float(power) if power else 1
                values = [float(text.replace("−", "-")) * factor for text in texts]
                self.assertTrue(3 <= len(values) <= 11, texts)
                self.assertEqual(len(set(texts)), len(texts))
                step = (values[-1] - values[0]) / (len(values) - 1)
                numpy.testing.assert_allclose(numpy.diff(values), step, rtol=1e-6)
                digit = step / 10 ** math.floor(math.log10(step * 1.000001))
                self.assertLess(min(abs(digit - each) for each in (1, 2, 5)), 1e-6)
                near = 1e-6 * step
                self.assertTrue(low - near <= values[0] < low + step + near)
                self.assertTrue(high - step - near < values[-1] <= high + near)
        self.assertTrue(window)

    def test_texts(self):
        """Title, unit, ends and boxes; the values of steps are where colours change."""
        _, renderer, bar = self.bar_of(0, 10)
        bar.SetTitle("Pressure")
        bar.SetUnit("Pa")
        self.assertEqual(bar.GetTexts(renderer).split("\n")[0], "Pressure (Pa)")
        bar.SetSteps(4)
        values = bar.GetTexts(renderer).split("\n")[1:]
        self.assertEqual(values, ["0.0", "2.5", "5.0", "7.5", "10.0"])
        bar.BelowBoxOn()
        bar.AboveBoxOn()
        bar.NanBoxOn()
        self.assertEqual(bar.GetTexts(renderer).split("\n")[-3:], ["> 10", "< 0", "NaN"])
        bar.SetEnds("dark", "lit")
        self.assertEqual(bar.GetTexts(renderer).split("\n")[1:3], ["dark", "lit"])
        bar.SetLookupTable(None)
        self.assertEqual(bar.GetTexts(renderer), "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
