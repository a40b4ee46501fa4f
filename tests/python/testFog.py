# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo.fog: its arguments, its transmittance, and refusals."""

import unittest

import numpy
import relievo

from scenes import PointsTest, point_source, points_at, rays


class Fog(PointsTest):
    def passes(self):
        return relievo.layer(relievo.capture(self.renderer, ["fog"]), "fog")

    def expected(self, spheres):
        """The transmittance of spheres (place, radius, density), by rays that end at the captured
        depth."""
        relievo.attach(self.renderer).GetLayersStage().RefineDepthOff()
        depth = relievo.layer(relievo.capture(self.renderer, ["depth"]), "depth").astype(float)
        origin, direction = rays(self.renderer.GetActiveCamera(), 90, 60)
        length = numpy.linalg.norm(direction, axis=-1)
        total = numpy.zeros(depth.shape)
        for place, radius, density in spheres:
            to = numpy.array(place) - origin
            middle = (to * direction).sum(axis=-1) / length
            under = radius**2 - (to * to).sum(axis=-1) + middle**2
            half = numpy.sqrt(numpy.maximum(under, 0))
            chord = numpy.minimum(middle + half, depth * length) - numpy.maximum(middle - half, 0)
            total += density * numpy.where(under > 0, numpy.maximum(chord, 0), 0)
        return numpy.exp(-total)

    def test_values(self):
        """Arrays by their own names and others, numbers for all, a port that is followed."""
        places = [(0, 0, 2), (3, 1, 0)]
        fog = relievo.fog(
            self.renderer, points_at(places, radius=[1.5, 3], thickness=[0.4, 0.2]),
            density="thickness", color=(1, 0.5, 0.25))
        expected = self.expected([(places[0], 1.5, 0.4), (places[1], 3, 0.2)])
        self.assertLess(expected.min(), 0.5)
        numpy.testing.assert_allclose(self.passes(), expected, rtol=0, atol=5e-6)
        relievo.attach(self.renderer).GetFogStage().RemovePoints(fog)
        self.assertTrue((self.passes() == 1).all())

        source = point_source(places[0])
        relievo.fog(self.renderer, source, radius=1, density=0.7)
        numpy.testing.assert_allclose(
            self.passes(), self.expected([(places[0], 1, 0.7)]), rtol=0, atol=5e-6)
        source.SetCenter(*places[1])
        numpy.testing.assert_allclose(
            self.passes(), self.expected([(places[1], 1, 0.7)]), rtol=0, atol=5e-6)

    def test_modes(self):
        data = points_at([(0, 0, 4), (0, 0, 4)], radius=[1, 0.8])
        relievo.fog(self.renderer, data, density=0.5, mode="chord")
        both = self.passes().min()
        self.assertAlmostEqual(both, 0.25, delta=0.01)
        relievo.fog(self.renderer, points_at([]), overlap="dominant")
        self.assertAlmostEqual(self.passes().min(), 0.5, delta=0.01)
        stage = relievo.attach(self.renderer).GetFogStage()
        self.assertEqual((stage.GetParameter("mode"), stage.GetParameter("overlap")),
                         ("chord", "dominant"))  # fmt: skip

    def test_refusals(self):
        """Wrong arguments are named, and change nothing."""
        data = points_at([(0, 0, 4)])
        self.check_refusals(relievo.fog, "points", data, (
            ({"points": 5}, "points"),
            ({"radius": -1}, "radius.*0 or more"),
            ({"radius": (1, 2)}, "radius"),
            ({"radius": True}, "radius.*0 or more"),
            ({"density": float("nan")}, "density.*0 or more"),
            ({"color": (1, 2)}, "color.*red,green,blue, each 0 or more"),
            ({"color": (0, 0, -0.5)}, "color.*red,green,blue, each 0 or more"),
            ({"mode": "linear"}, "mode.*beer, chord"),
            ({"mode": "beer", "overlap": 3}, "overlap.*sum, dominant"),
        ))  # fmt: skip


if __name__ == "__main__":
    unittest.main()
