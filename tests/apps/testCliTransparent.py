# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--transparent: over white and over black the picture is that with such a background."""

import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter

from cli import CliTest, main, read_png

SIZE = ["--size", "240x180"]


class Transparent(CliTest):
    def setUp(self):
        super().setUp()
        ball = vtkSphereSource()
        ball.SetThetaResolution(48)
        ball.SetPhiResolution(48)
        writer = vtkOBJWriter()
        writer.SetInputConnection(ball.GetOutputPort())
        writer.SetFileName(str(self.folder / "ball.obj"))
        writer.Write()
        self.before = self.names()

    def picture(self, *words):
        self.relievo("render", "ball.obj", *SIZE, *words, "--png", "a.png")
        return read_png(self.folder / "a.png").astype(float)

    def compare(self, *words, step=1.01, more=()):
        """The picture, after its comparison with those over black and white."""
        rgba = self.picture(*words, "--transparent")
        self.assertEqual(rgba.shape[2], 4)
        alpha = rgba[..., 3:] / 255
        for name, level in (("black", 0), ("white", 255), *more):
            over = rgba[..., :3] * alpha + level * (1 - alpha)
            expected = self.picture(*words, "--background", name)[..., :3]
            self.assertLessEqual(numpy.abs(over - expected).max(), step, f"{name}: {words}")
        return rgba

    def test_studio(self):
        # The light, and so its shadow on white, is a little yellow; edges are mixed linearly.
        words = ["--preset", "studio", "--soft-shadows", "4", "--shadows", "map",
                 "--shadow-size", "256"]  # fmt: skip
        rgba = self.compare(*words, step=3.5)
        alpha = rgba[..., 3]
        self.assertEqual(alpha[0, 0], 0)
        self.assertEqual(alpha[90, 120], 255)  # on the ball
        # The ground's shadow is there, black; the rest of the ground is not.
        shadow = (alpha > 40) & (alpha < 250) & (rgba[..., :3].max(axis=2) == 0)
        self.assertGreater(shadow.sum(), 100)
        self.assertGreater((alpha == 0).sum(), 240 * 180 / 4)
        without = self.compare(*words, "--ground", "off", step=3.5)[..., 3]
        self.assertLess(((without > 40) & (without < 250)).sum(), shadow.sum())

    def test_scale_bar(self):
        """It is opaque, in the ink that it has on the background that is left out."""
        for background, ink in ("black", 255), ("white", 0):
            rgba = self.picture("--preset", "none", "--parallel-scale", "4", "--background",
                                background, "--scale-bar", "mm", "--transparent")  # fmt: skip
            bar = (rgba[150:] == (ink, ink, ink, 255)).all(axis=2)
            self.assertLessEqual(abs(bar.sum(axis=1).max() - 2 * 180 / 8), 1)

    def test_bare(self):
        rgba = self.compare("--preset", "none")
        self.assertEqual(sorted(numpy.unique(rgba[..., 3])), [0, 255])
        self.compare(
            "--preset", "none", "--opacity", "0.4", "--color", "white", more=[("gray", 128)]
        )
        self.compare("--preset", "none", "--stage", "antialias:samples=8")

    def test_with_layers(self):
        """Beside an EXR, whose colour is as without it."""
        words = ["--preset", "studio", "--layers", "depth"]
        self.relievo("render", "ball.obj", *SIZE, *words, "--exr", "a.exr")
        before = (self.folder / "a.exr").read_bytes()
        rgba = self.picture("--transparent", *words, "--exr", "a.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), before)
        self.assertEqual(rgba[0, 0, 3], 0)

    def test_needs_a_picture(self):
        self.refused("render", "ball.obj", "--transparent", "--exr", "a.exr", status=2,
                     says=["--transparent", "--png"])  # fmt: skip


if __name__ == "__main__":
    main()
