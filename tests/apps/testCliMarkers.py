# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--markers: their coverage in the layer and in the picture; their values, and refused arguments.
"""

import math

import numpy

from cli import CliTest, main, read_png
from points import polydata
from srgb import decoded, encoded

SIZE = ["--size", "101x101"]
PLACE = (-0.4, -0.4)  # on the triangle


def distances():
    """Of each pixel's point in the plane of the triangle, top row first."""
    step = 2 * 5 * math.tan(math.radians(15)) / 101
    along = (numpy.arange(101) - 50) * step
    return numpy.hypot(along[None, :] - PLACE[0], -along[:, None] - PLACE[1]), step


class Markers(CliTest):
    def setUp(self):
        super().setUp()
        self.write("marks.vtp", [(*PLACE, 0)], radius=(1, [0.3]), opacity=(1, [0.5]),
                   size=(1, [0.2]), color=(3, [1, 0.5, 0]))  # fmt: skip
        self.write("bare.vtp", [(*PLACE, 0)])

    def write(self, name, points, **arrays):
        (self.folder / name).write_text(polydata(points, **arrays))
        self.before = self.names()

    def check(self, words, inner, outer, opacity):
        """Covered between the two distances, and nowhere else, but for a pixel at the edges."""
        self.render(*SIZE, "--layers", "marker", "--exr", "a.exr", "--view-angle", "30",
                    "--markers", words)  # fmt: skip
        _, channels = self.exr("a.exr")
        found = channels["marker.V"]
        away, step = distances()
        inside = (away > inner + step) & (away < outer - step)
        self.assertGreater(inside.sum(), 20)
        self.assertTrue(numpy.allclose(found[inside], opacity, atol=1e-5), words)
        self.assertFalse(found[(away < inner - step) | (away > outer + step)].any())

    def test_what_is_covered(self):
        self.check("marks.vtp,shape=disc", -1, 0.3, 0.5)
        self.check("marks.vtp,shape=disc,opacity=1", -1, 0.3, 1)
        self.check("marks.vtp,shape=disc,radius=size", -1, 0.2, 0.5)
        self.check("marks.vtp,width=0.6", 0.12, 0.3, 0.5)
        self.check("bare.vtp,shape=disc,radius=0.25", -1, 0.25, 0.8)

    def test_shadow(self):
        """Below a point on the way to the eye, which is up: as dark as the height says."""
        self.write("above.vtp", [(*PLACE, 0.3)], radius=(1, [0.4]), reach=(1, [2]),
                   opacity=(1, [1]))  # fmt: skip
        for words, up in (("", []), (",up=0/0/1", []), ("", ["--up", "z"])):
            self.render(*SIZE, "--layers", "marker", "--exr", "a.exr", "--view-angle", "30",
                        *up, "--markers", "above.vtp,shape=shadow" + words)  # fmt: skip
            _, channels = self.exr("a.exr")
            away, _ = distances()
            soft = numpy.maximum(0, 1 - (away / 0.4) ** 2) ** 2 * (1 - 0.3 / 0.8)
            if words or up:
                near = away < 0.3
                self.assertTrue(numpy.allclose(channels["marker.V"][near], soft[near], atol=1e-4))
            else:
                self.assertFalse((channels["marker.V"] > 0).any(), "the triangle does not face y")

    def test_picture(self):
        """The linear colour of the marker, half over that of the surface."""
        words = ["--view-angle", "30", "--png", "a.png"]
        self.render(*SIZE, *words)
        before = read_png(self.folder / "a.png")
        self.render(*SIZE, *words, "--markers", "marks.vtp,shape=disc")
        after = read_png(self.folder / "a.png")
        away, _ = distances()
        row, column = numpy.unravel_index(away.argmin(), away.shape)
        for i, share in enumerate((1, 0.5, 0)):
            linear = 0.5 * decoded(before[row, column, i] / 255) + 0.5 * share
            expected = encoded(linear)
            self.assertAlmostEqual(after[row, column, i], 255 * expected, delta=2)
        self.assertEqual(tuple(after[0, 100]), tuple(before[0, 100]))

    def test_notes(self):
        done = self.render("--markers", "bare.vtp", "--png", "a.png")
        self.assertIn("bare.vtp: markers with radius 1", done.stderr)
        done = self.render("--markers", "marks.vtp", "--png", "a.png")
        self.assertEqual(done.stderr, "")
        self.write("some.vtp", [(0, 0, 0), (1, 0, 0)], radius=(1, [0.8, 0]))
        done = self.render("--markers", "some.vtp", "--png", "a.png")
        self.assertIn("some.vtp: left out 1 of 2 points that are no markers", done.stderr)

    def test_refused_words(self):
        for word, says in (
            ("marks.vtp,size=1", ["'size=1'", "radius, width, reach, opacity, color, shape, up"]),
            ("marks.vtp,radius=-1", ["radius", "'-1'"]),
            ("marks.vtp,shape=square", ["shape", "'square'", "ring, glow, disc, shadow"]),
            ("marks.vtp,up=0/0/0", ["up", "a direction"]),
            ("marks.vtp,up=0/1", ["up", "three numbers"]),
            ("marks.vtp,color=1/0", ["color", "red,green,blue"]),
            ("marks.vtp,radius=1,radius=2", ["FILE[,NAME=VALUE]", "each once"]),
            ("marks.xyz", ["marks.xyz", ".vtp"]),
        ):
            with self.subTest(word):
                self.refused("render", "triangle.off", "--png", "a.png", "--markers", word,
                             status=2, says=says)  # fmt: skip

    def test_refused_files(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--markers", "none.vtp", status=1,
                     says=["none.vtp", "No such file"])  # fmt: skip
        self.write("zero.vtp", [(0, 0, 0)], radius=(1, [0]))
        self.refused("render", "triangle.off", "--png", "a.png", "--markers", "zero.vtp", status=1,
                     says=["zero.vtp", "above 0"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--markers",
                     "marks.vtp,radius=far", status=2,
                     says=["--markers marks.vtp,radius", "'far'", "color, opacity"])  # fmt: skip


if __name__ == "__main__":
    main()
