# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--fog: its transmittance in the layer and in the picture; its values, and refused arguments."""

import math

from cli import CliTest, main, read_png
from points import polydata
from srgb import encoded

SIZE = ["--size", "101x101"]


class Fog(CliTest):
    def setUp(self):
        super().setUp()
        self.write("fog.vtp", [(0, 0, 0)], radius=(1, [0.8]), density=(1, [0.5]),
                   color=(3, [1, 0.5, 0]))  # fmt: skip
        self.write("bare.vtp", [(0, 0, 0)])

    def write(self, name, points, **arrays):
        (self.folder / name).write_text(polydata(points, **arrays))
        self.before = self.names()

    def passes(self, *words):
        """The layer a little below the middle, where the triangle is, and above, in the sky."""
        self.render(*SIZE, "--layers", "fog", "--exr", "a.exr", *words)
        _, channels = self.exr("a.exr")
        return channels["fog.V"][52, 50], channels["fog.V"][48, 50], channels["fog.V"][0, 0]

    def check(self, found, on_triangle, in_sky):
        """Two pixels off the middle a chord is shorter by a two-hundredth."""
        self.assertAlmostEqual(found[0], on_triangle, delta=0.01)
        self.assertAlmostEqual(found[1], in_sky, delta=0.01)
        self.assertEqual(found[2], 1)

    def test_what_passes(self):
        self.check(self.passes("--fog", "fog.vtp"), math.exp(-0.4), math.exp(-0.8))
        self.check(self.passes("--fog", "fog.vtp,mode=chord"), 0.75, 0.5)
        self.check(self.passes("--fog", "fog.vtp,density=1"), math.exp(-0.8), math.exp(-1.6))
        self.check(self.passes("--fog", "fog.vtp,radius=0.4"), math.exp(-0.2), math.exp(-0.4))
        self.check(self.passes("--fog", "fog.vtp,radius=density"), math.exp(-0.25), math.exp(-0.5))
        self.check(self.passes("--fog", "bare.vtp,radius=0.4,density=2"),
                   math.exp(-0.8), math.exp(-1.6))  # fmt: skip
        twice = self.passes("--fog", "fog.vtp", "--fog", "bare.vtp,radius=0.8,density=0.5")
        self.check(twice, math.exp(-0.8), math.exp(-1.6))
        largest = self.passes("--fog", "fog.vtp", "--fog", "bare.vtp,radius=0.8,density=0.5",
                              "--stage", "fog:overlap=dominant")  # fmt: skip
        self.check(largest, math.exp(-0.4), math.exp(-0.8))

    def test_without_fog_all_passes(self):
        self.check(self.passes(), 1, 1)

    def test_picture(self):
        """Over black: the colour of the fog times its opacity, as sRGB."""
        for words, color in (([], (1, 0.5, 0)), ([",color=0.2/1/0.4"], (0.2, 1, 0.4))):
            self.render(*SIZE, "--fog", "fog.vtp" + "".join(words), "--png", "a.png")
            found = read_png(self.folder / "a.png")[48, 50]
            for value, share in zip(found, color):
                expected = encoded(share * (1 - math.exp(-0.8)))
                self.assertAlmostEqual(value, 255 * expected, delta=2)

    def test_notes(self):
        done = self.render("--fog", "bare.vtp", "--png", "a.png")
        self.assertIn("bare.vtp: fog with radius 1 and density 0.2", done.stderr)
        done = self.render("--fog", "fog.vtp", "--png", "a.png")
        self.assertEqual(done.stderr, "")
        self.write("some.vtp", [(0, 0, 0), (1, 0, 0)], radius=(1, [0.8, 0]), density=(1, [1, 1]))
        done = self.render("--fog", "some.vtp", "--png", "a.png")
        self.assertIn("some.vtp: left out 1 of 2 points that are no fog", done.stderr)

    def test_refused_words(self):
        for word, says in (
            ("fog.vtp,depth=1", ["'depth=1'", "radius, density, color, mode"]),
            ("fog.vtp,density=-0.5", ["density", "'-0.5'"]),
            ("fog.vtp,radius=-1", ["radius", "'-1'"]),
            ("fog.vtp,radius=", ["radius", "the name of a point array"]),
            ("fog.vtp,color=1/0", ["color", "red,green,blue"]),
            ("fog.vtp,mode=linear", ["mode", "'linear'", "beer, chord"]),
            ("fog.vtp,mode=beer,mode=beer", ["FILE[,NAME=VALUE]", "each once"]),
            (",density=1", ["FILE[,NAME=VALUE]"]),
            ("fog.xyz", ["fog.xyz", ".vtp"]),
            ("scene.gltf", ["scene.gltf", "a file of points"]),
        ):
            with self.subTest(word):
                self.refused("render", "triangle.off", "--png", "a.png", "--fog", word, status=2,
                             says=says)  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "fog.vtp,mode=beer",
                     "--fog", "bare.vtp,mode=chord", status=2,
                     says=["--fog", "one mode"])  # fmt: skip

    def test_refused_files(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "none.vtp", status=1,
                     says=["none.vtp", "No such file"])  # fmt: skip
        self.write("empty.vtp", [])
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "empty.vtp", status=1,
                     says=["empty.vtp", "no points"])  # fmt: skip
        self.write("zero.vtp", [(0, 0, 0)], radius=(1, [0]))
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "zero.vtp", status=1,
                     says=["zero.vtp", "above 0"])  # fmt: skip
        self.write("wide.vtp", [(0, 0, 0)], radius=(2, [1, 2]))
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "wide.vtp", status=1,
                     says=["wide.vtp", "'radius'", "2 components"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--fog", "fog.vtp,density=thick",
                     status=2, says=["--fog fog.vtp,density", "'thick'", "color, density, radius"],
                     )  # fmt: skip
        self.refused("render", "triangle.off", "--report", "fog.vtp", "--fog", "fog.vtp", status=2,
                     says=["--report", "fog.vtp"])  # fmt: skip


if __name__ == "__main__":
    main()
