# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo.lamps: its arguments, its light, and refusals."""

import types
import unittest

import numpy
import relievo
import scenes

from scenes import PointsTest, point_source, points_at


def linear(byte):
    """Light of a byte that displays show, by IEC 61966-2-1."""
    return ((byte / 255 + 0.055) / 1.055) ** 2.4 if byte > 10 else byte / 255 / 12.92


class Lamps(PointsTest):
    def light(self):
        return relievo.layer(relievo.capture(self.renderer, ["light"]), "light")

    def expected(self, lamps):
        """Sums lamps (place, radius, intensity, colour) over the captured positions and normals."""
        image = relievo.capture(self.renderer, ["position", "normal", "depth"])
        position, normal = relievo.layer(image, "position"), relievo.layer(image, "normal")
        total = numpy.zeros_like(position)
        for place, radius, intensity, colour in lamps:
            to = numpy.array(place) - position
            d = numpy.linalg.norm(to, axis=-1)
            cosine = numpy.maximum(0, (to * normal).sum(axis=-1) / d)
            total += (intensity * numpy.maximum(0, 1 - d / radius) * cosine)[..., None] * colour
        total[numpy.isinf(relievo.layer(image, "depth"))] = 0
        return total

    def test_values(self):
        """Arrays by their own names and others, numbers for all, a port that is followed."""
        places = [(0, 0, 4), (3, 1, 3)]
        lamps = relievo.lamps(
            self.renderer, points_at(places, radius=[6, 3], power=[1, 2]), intensity="power",
            color=(1, 0.5, 0.25))
        colour = numpy.array([1, 0.5, 0.25])
        expected = self.expected([(places[0], 6, 1, colour), (places[1], 3, 2, colour)])
        self.assertGreater(expected.max(), 0.5)
        numpy.testing.assert_allclose(self.light(), expected, rtol=1e-4, atol=5e-5)
        stage = relievo.attach(self.renderer).GetStage("lamps")
        stage.RemovePoints(lamps)
        self.assertFalse(self.light().any())

        source = point_source(places[0])
        relievo.lamps(self.renderer, source, radius=5)
        white = numpy.ones(3)
        numpy.testing.assert_allclose(
            self.light(), self.expected([(places[0], 5, 1, white)]), rtol=1e-4, atol=5e-5)
        source.SetCenter(*places[1])
        numpy.testing.assert_allclose(
            self.light(), self.expected([(places[1], 5, 1, white)]), rtol=1e-4, atol=5e-5)
        self.window.Render()
        report = relievo.report(relievo.attach(self.renderer))
        self.assertEqual((report["lamps"], report["lamps_drawn"]), (1, 1))

    def test_casts(self):
        """By a word for all, by an array, and by the stage's number."""

        def casting(number=0, **more):
            points = points_at([(0, 0, 4), (3, 1, 3)], radius=[6, 3], lit=[1, 0])
            lamps = relievo.lamps(self.renderer, points, **more)
            relievo.stage(self.renderer, "lamps", casting=number)
            self.window.Render()
            stage = relievo.attach(self.renderer).GetStage("lamps")
            stage.RemovePoints(lamps)
            return stage.GetNumberCasting()

        self.assertEqual(casting(), 0)
        self.assertEqual(casting(1), 1)
        self.assertEqual(casting(8), 2)
        self.assertEqual(casting(8, casts=False), 0)
        self.assertEqual(casting(casts=True), 2)
        self.assertEqual(casting(casts="lit"), 1)
        self.assertEqual(casting(2, casts="lit"), 1)

    def test_refusals(self):
        """Wrong arguments are named, and change nothing."""
        data = points_at([(0, 0, 4)])
        self.check_refusals(relievo.lamps, "points", data, (
            ({"points": 5}, "points"),
            ({"radius": -1}, "radius.*0 or more"),
            ({"radius": (1, 2)}, "radius"),
            ({"intensity": float("nan")}, "intensity.*a number"),
            ({"color": (1, float("nan"), 0)}, "color.*red,green,blue, each 0 or more"),
            ({"color": (-1, 0, 0)}, "color: '-1,0,0' was given.* red,green,blue, each 0 or more"),
            ({"intensity": None, "color": (1, 2)}, "color.*red,green,blue"),
            ({"falloff": "cubic"}, "falloff.*inverse-square"),
            ({"attenuation": (1, 0, 0)}, "attenuation.*falloff='vtk'"),
            ({"casts": 3}, "casts.*never, always"),
            ({"radius": "reach"}, "radius: got 'reach', which is neither.*arrays are none"),
            ({"points": numpy.zeros((4, 2))}, r"points: got an array of shape \(4, 2\).*n x 3"),
        ))  # fmt: skip
        data = points_at([(0, 0, 4)], brightness=[2], color=[(1, 0, 0)])
        with self.assertRaisesRegex(ValueError, "did you mean 'brightness'.*are brightness, color"):
            relievo.lamps(self.renderer, data, intensity="brightnes")
        with self.assertRaisesRegex(ValueError, "'brightness', an array of 1 comp.*expected 3"):
            relievo.lamps(self.renderer, data, color="brightness")

    def test_points_and_colors_as_people_have_them(self):
        """Points of numpy and colours by name light as a dataset and numbers do."""
        places = numpy.array([(0, 0, 4), (1, 0, 2)], float)
        holder = types.SimpleNamespace(dataset=points_at(places))
        expected = None
        for given in (points_at(places), places, places.astype("float32"), places.tolist(), holder):
            for color in ((1, 0.5, 0), [1, 0.5, 0], "#ff8000", "tomato"):
                renderer = scenes.plane_and_sphere()
                plotter = types.SimpleNamespace(renderer=renderer)
                relievo.lamps(plotter, given, radius=9, color=color)
                light = relievo.layer(relievo.capture(renderer, "light", size=(40, 30)), "light")
                shown = {"#ff8000": (128, 0), "tomato": (99, 71)}.get(str(color))
                share, blue = map(linear, shown) if shown else (0.5, 0)
                if expected is None:
                    expected = light[..., 0]
                    self.assertGreater(expected.max(), 0.01)
                for i, part in enumerate((1, share, blue)):
                    numpy.testing.assert_allclose(
                        light[..., i], part * expected, atol=2e-3 * expected.max())  # fmt: skip

    def test_an_array_goes_before_a_colour_of_its_name(self):
        data = points_at([(0, 0, 4)], red=[(0, 1, 0)])
        renderer = scenes.plane_and_sphere()
        relievo.lamps(renderer, data, radius=9, color="red")
        light = relievo.layer(relievo.capture(renderer, "light", size=(40, 30)), "light")
        self.assertGreater(light[..., 1].max(), 0.01)
        self.assertEqual(light[..., 0].max(), 0)


if __name__ == "__main__":
    unittest.main()
