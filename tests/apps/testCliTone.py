# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--tone and --exposure: the picture is the formula of the light in the EXR, which stays before."""

import json

import numpy

from cli import CliTest, main, read_png
from srgb import decoded, encoded

# A plate under three suns from where the camera is: its display colour is 3 times white.
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--parallel-scale", "2", "--size", "40x40",
        "--shading", "flat", *(3 * ["--light", "sun:0,0,1"])]  # fmt: skip
WEIGHTS = numpy.array([0.2126, 0.7152, 0.0722])


def curve(x, white):
    return x * (1 + x / white**2) / (1 + x)


def neutral(x):
    """Grey light of 0.08 or more."""
    base = x - 0.04
    return numpy.where(base < 0.76, base, 1 - 0.24**2 / (base + 0.24 - 0.76))


class Tone(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plate.off").write_text("OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n"
                                               "4 0 1 2 3\n")  # fmt: skip
        self.before = self.names()
        self.light = decoded(numpy.array([3.0, 3.0, 3.0]))

    def draw(self, *words, **more):
        return self.relievo("render", "plate.off", *LOOK, *words, **more)

    def check_picture(self, expected, *words):
        self.draw(*words, "--png", "a.png", "--exr", "a.exr")
        pixel = read_png(self.folder / "a.png")[20, 20].astype(float)
        numpy.testing.assert_allclose(pixel, 255 * encoded(expected), atol=0.6)
        _, channels = self.exr("a.exr")
        color = [channels[name][20, 20] for name in "RGB"]
        numpy.testing.assert_allclose(color, self.light, rtol=2e-3)

    def test_operators(self):
        light = self.light
        self.check_picture(light / (1 + light), "--tone", "simple")
        self.check_picture(curve(light, 20), "--tone", "reinhard,white=20")
        self.check_picture(curve(light, 20), "--tone", "reinhard-rgb,white=20")
        self.check_picture(numpy.minimum(light / 32, 1), "--tone", "clamp", "--exposure", -5)
        self.check_picture(neutral(light), "--tone", "neutral")
        self.check_picture(neutral(light / 8), "--exposure", -3)
        self.check_picture(numpy.ones(3), "--tone=reinhard,white=4")

    def test_white_is_exactly_white(self):
        self.draw("--tone", f"reinhard,white={float(self.light[0]) * 0.999}", "--png", "a.png")
        self.assertEqual(read_png(self.folder / "a.png")[20, 20].tolist(), [255, 255, 255])

    def test_automatic_exposure(self):
        # All that is drawn has one light, which becomes 0.18, a stop brighter 0.36.
        self.check_picture(neutral(0.18 * numpy.ones(3)), "--exposure", "auto")
        self.check_picture(numpy.full(3, 0.36), "--tone", "clamp", "--exposure", "auto", "--stage",
                           "tone:exposure=1")  # fmt: skip

    def test_dithering_beside_it(self):
        self.draw("--tone", "simple", "--stage", "tone:dither=blue_noise", "--png", "a.png")
        plate = read_png(self.folder / "a.png")[12:28, 12:28, 0]
        expected = 255 * encoded(self.light[0] / (1 + self.light[0]))
        self.assertEqual(sorted(set(plate.ravel())), [int(expected), int(expected) + 1])
        self.assertAlmostEqual(plate.mean(), expected, delta=0.1)

    def test_clamp_is_the_plain_picture(self):
        self.draw("--png", "plain.png")
        done = self.draw("--tone", "clamp", "--png", "a.png", "--report", "a.json")
        self.assertIn("--tone changed nothing: ", done.stderr)
        numpy.testing.assert_array_equal(
            read_png(self.folder / "plain.png"), read_png(self.folder / "a.png")
        )
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["bytes"], 0)

    def test_the_picture_beside_hdr(self):
        self.draw("--png", "plain.png")
        self.draw("--png", "a.png", "--exr", "a.exr", "--hdr")
        numpy.testing.assert_allclose(
            read_png(self.folder / "plain.png"), read_png(self.folder / "a.png"), atol=1
        )

    def test_wrong_words(self):
        for words, says in (
            (["--tone", "filmic"], ["--tone", "'filmic'", "reinhard-rgb"]),
            (["--tone", "reinhard_rgb"], ["--tone", "'reinhard_rgb'", "reinhard-rgb"]),
            (["--tone", "reinhard,4"], ["--tone", "'reinhard,4'", "white=W"]),
            (["--tone", "reinhard,white=4,white=5"], ["--tone", "white=W"]),
            (["--tone", "reinhard,white=0"], ["--tone", "white", "'0'", "0.01"]),
            (["--tone", "reinhard,white=nan"], ["--tone", "white", "'nan'"]),
            (["--tone", "neutral,white=4"], ["--tone", "'neutral,white=4'", "white point"]),
            (["--tone", "simple,white=4"], ["--tone", "'simple,white=4'", "white point"]),
            (["--exposure", "bright"], ["--exposure", "'bright'", "auto"]),
            (["--exposure", "nan"], ["--exposure", "'nan'", "auto"]),
            (["--exposure", "21"], ["--exposure", "'21'", "20"]),
            (["--exposure", "1e"], ["--exposure", "'1e'"]),
            (["--tone", "simple", "--tone", "clamp"], ["--tone", "twice"]),
            (["--tone", "simple", "--stage", "tone:operator=clamp"],
             ["--tone", "tone:operator", "one of them"]),
            (["--stage", "tone:exposure=2", "--exposure", "1"],
             ["--exposure", "tone:exposure", "one of them"]),
        ):  # fmt: skip
            with self.subTest(words=words):
                self.refused("render", "plate.off", "--png", "a.png", *words, status=2, says=says)

    def test_stages_lists_it(self):
        listed = self.relievo("stages").stdout
        self.assertIn("tone\n", listed)
        for parameter in ("operator=", "white=", "exposure=", "auto_exposure=", "dither="):
            self.assertIn(parameter, listed)


if __name__ == "__main__":
    main()
