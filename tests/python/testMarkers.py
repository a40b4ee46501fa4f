# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo.markers: its arguments, its coverage, and refusals."""

import unittest

import numpy
import relievo

from scenes import PointsTest, point_source, points_at


class Markers(PointsTest):
    def read(self, *names):
        relievo.attach(self.renderer).GetLayersStage().RefineDepthOff()
        image = relievo.capture(self.renderer, list(names))
        found = [numpy.array(relievo.layer(image, name), float) for name in names]
        return found[0] if len(found) == 1 else found

    def check(self, disc, opacity):
        """Covered within the distance, and nothing beyond, but for a pixel at the edge."""
        covered, place, depth = self.read("marker", "position", "depth")
        there = numpy.isfinite(depth)
        away = numpy.where(there, disc(place), numpy.inf)
        self.assertGreater((away < -0.3).sum(), 10)
        numpy.testing.assert_allclose(covered[away < -0.3], opacity, rtol=0, atol=1e-6)
        self.assertFalse(covered[away > 0.5].any())
        self.assertTrue(((covered >= 0) & (covered <= opacity + 1e-6)).all())

    @staticmethod
    def ball(centre, radius):
        return lambda place: numpy.linalg.norm(place - numpy.array(centre), axis=-1) - radius

    def test_points(self):
        """Arrays by their own names and others, numbers for all, a port that is followed."""
        place = (0, 0, 1)
        made = relievo.markers(
            self.renderer, points_at([place], radius=[2.5], dim=[0.4]), shape="disc",
            opacity="dim", color=(1, 0.5, 0.25))
        self.check(self.ball(place, 2.5), 0.4)
        relievo.attach(self.renderer).GetMarkersStage().RemovePoints(made)
        self.assertFalse(self.read("marker").any())

        source = point_source(place)
        relievo.markers(self.renderer, source, shape="disc", radius=2, opacity=1)
        self.check(self.ball(place, 2), 1)
        source.SetCenter(-1, 1, 0)
        self.check(self.ball((-1, 1, 0), 2), 1)

    def test_actors(self):
        """Within a distance of the box of the sphere, wherever it is."""
        sphere = self.renderer.GetActors().GetLastActor()
        relievo.markers(self.renderer, sphere, shape="disc", radius=0.7, opacity=0.5)
        for move in ((0, 0, 0), (1, -0.5, 0.7)):
            sphere.SetPosition(*move)
            low, high = numpy.array(sphere.GetBounds()).reshape(3, 2).T
            self.check(
                lambda place: numpy.linalg.norm(  # noqa: B023
                    place - numpy.clip(place, low, high), axis=-1) - 0.7, 0.5)  # noqa: B023

    def test_shapes(self):
        """A ring has a hole, a glow is brightest inside, a shadow is only below."""
        place = (0, 0.5, 2.5)
        for shape in ("ring", "glow", "shadow"):
            made = relievo.markers(
                self.renderer, points_at([place]), shape=shape, radius=2, width=0.3, reach=3,
                up=(0, 0, 1))
            covered, found = self.read("marker", "position")
            away = numpy.linalg.norm(found - numpy.array(place), axis=-1)
            self.assertTrue((covered > 0.05).sum() > 20, shape)
            if shape == "ring":
                self.assertFalse(covered[away < 1].any())
            elif shape == "glow":
                self.assertGreater(covered[away < 1.2].min(), covered[away > 1.7].max())
            else:
                self.assertFalse(covered[found[..., 2] > 2.51].any())
            relievo.attach(self.renderer).GetMarkersStage().RemovePoints(made)

    def test_refusals(self):
        """Wrong arguments are named, and change nothing."""
        data = points_at([(0, 0, 4)])
        self.check_refusals(relievo.markers, "points", data, (
            ({"points": 5}, "points"),
            ({"points": [data]}, "points.*vtkProp3D"),
            ({"points": []}, "points"),
            ({"shape": "square"}, "shape.*ring, glow, disc, shadow"),
            ({"radius": -1}, "radius.*0 or more"),
            ({"width": (1, 2)}, "width"),
            ({"opacity": float("nan")}, "opacity.*from 0 to 1"),
            ({"color": (1, 2)}, "color.*red,green,blue, each 0 or more"),
            ({"color": (0, 0, -0.5)}, "color.*red,green,blue, each 0 or more"),
            ({"up": (0, 0, 0)}, "up.*a direction"),
            ({"up": 3}, "up.*three numbers"),
        ))  # fmt: skip


if __name__ == "__main__":
    unittest.main()
