# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--lens: pictures and layers against rays by hand, calibrations of files, what is refused."""

import json

import numpy

from cli import LOOK, CliTest, main, read_png

CALIBRATION = """%YAML:1.0
---
image_width: 120
image_height: 90
fisheye_model: 1
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 60., 0., 55.5, 0., 62., 47., 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 4
   cols: 1
   dt: d
   data: [ 0.05, 0., 0., 0. ]
"""


def inside(origins, directions):
    """Whether rays meet the triangle of cli.py, which lies in the plane z = 0."""
    away = -origins[..., 2] / directions[..., 2]
    x, y, _ = numpy.moveaxis(origins + away[..., None] * directions, -1, 0)
    return (away > 0) & (x > -1) & (y > -1) & (x + y < 0)


def inner(mask):
    """Where the mask's neighbours are as it is."""
    same = numpy.ones(mask.shape, bool)
    for shift in ((0, 1), (1, 0), (1, 1), (1, -1)):
        for sign in (1, -1):
            same &= numpy.roll(mask, (sign * shift[0], sign * shift[1]), (0, 1)) == mask
    return same


class Lens(CliTest):
    LOOK = ["--camera", "0.2,0.1,1.5,0,0,0,0,1,0", "--preset", "none", "--shading", "flat",
            "--color", "white", "--background", "#204060"]  # fmt: skip

    def expected(self, size, direction_of):
        """The triangle's mask, by directions (x right, y down, z forward) of places (u, v)."""
        u, v = numpy.meshgrid(numpy.arange(size[0]), numpy.arange(size[1]))
        eye = numpy.array((0.2, 0.1, 1.5))
        forward = -eye / numpy.linalg.norm(eye)
        right = numpy.cross(forward, (0, 1, 0))
        right /= numpy.linalg.norm(right)
        axes = numpy.stack([right, numpy.cross(forward, right), forward])
        with numpy.errstate(divide="ignore", invalid="ignore"):
            return inside(eye, direction_of(u, v) @ axes)

    def check(self, words, size, direction_of):
        self.relievo("render", "triangle.off", *self.LOOK, *words, "--png", "a.png", "--exr",
                     "a.exr", "--layers", "actor,position", "--report", "a.json")  # fmt: skip
        expected = self.expected(size, direction_of)
        self.assertGreater(expected.sum(), 200)
        header, channels = self.exr("a.exr")
        self.assertEqual((header["width"], header["height"]), size)
        self.assertEqual({name.split(".")[0] for name in channels},
                         {"R", "G", "B", "A", "actor", "position"})  # fmt: skip
        actor = channels["actor.id"] if "actor.id" in channels else channels["actor"]
        met = actor == 0
        self.assertGreater((met == expected).mean(), 0.999)
        flat = inner(expected)
        picture = read_png(self.folder / "a.png")
        self.assertEqual(picture.shape[:2], size[::-1])
        self.assertTrue((picture[~expected & flat] == (0x20, 0x40, 0x60)).all())
        self.assertTrue((picture[expected & flat].min(axis=1) > 0x90).all())
        bright = picture[..., 0] > 0x80
        self.assertLess((bright != expected)[~flat].mean(), 0.5)  # an edge is between its pixels
        with open(self.folder / "a.json") as file:
            return json.load(file)["camera"], header["attributes"]

    @staticmethod
    def fisheye(fx, fy, cx, cy, k1):
        def direction_of(u, v):
            a, b = (u - cx) / fx, (v - cy) / fy
            bent = numpy.hypot(a, b)
            angle = bent.copy()
            for _ in range(50):
                angle -= (angle * (1 + k1 * angle**2) - bent) / (1 + 3 * k1 * angle**2)
            side = numpy.sin(angle) / numpy.maximum(bent, 1e-300)
            return numpy.stack([side * a, side * b, numpy.cos(angle)], axis=-1)
        return direction_of

    def test_words(self):
        focal = 45 / (numpy.pi / 2 * (1 + 0.05 * (numpy.pi / 2) ** 2))
        by_hand = self.fisheye(focal, focal, 59.5, 44.5, 0.05)
        camera, attributes = self.check(
            ["--size", "120x90", "--lens", "fisheye:0.05,angle=180"], (120, 90), by_hand)
        self.assertEqual(camera["lens"], "fisheye")
        self.assertEqual(camera["size"], [120, 90])
        self.assertEqual(camera["distortion"], [0.05, 0, 0, 0])
        numpy.testing.assert_allclose(camera["K"], [focal, 0, 59.5, 0, focal, 44.5, 0, 0, 1])
        self.assertEqual(attributes["lens"]["value"], "fisheye")
        self.assertEqual(attributes["distortion"]["value"], "[0.05, 0, 0, 0]")

    def test_files(self):
        (self.folder / "lens.yml").write_text(CALIBRATION)
        self.check(["--lens", "lens.yml"], (120, 90), self.fisheye(60, 62, 55.5, 47, 0.05))
        self.check(["--lens", "lens.yml", "--size", "240x180"], (240, 180),
                   self.fisheye(120, 124, 111.5, 94.5, 0.05))

    def test_panorama(self):
        def direction_of(u, v):
            azimuth = numpy.radians((u + 0.5) / 200 * 360 - 180)
            elevation = numpy.radians(90 - (v + 0.5) / 100 * 180)
            return numpy.stack([numpy.cos(elevation) * numpy.sin(azimuth), -numpy.sin(elevation),
                                numpy.cos(elevation) * numpy.cos(azimuth)], axis=-1)  # fmt: skip
        self.check(["--lens", "equirectangular", "--size", "200x100"], (200, 100), direction_of)

    def test_pinhole_is_the_picture(self):
        for words in ([], ["--lens", "pinhole"]):
            self.relievo("render", "triangle.off", "--size", "90x70", *words, "--png", "a.png",
                         "--report", "a.json")  # fmt: skip
            picture = read_png(self.folder / "a.png").astype(int)
            with open(self.folder / "a.json") as file:
                camera = json.load(file)["camera"]
            if words:
                self.assertLessEqual(numpy.abs(picture - before[0]).max(), 1)
                for key in ("K", "R", "t"):
                    numpy.testing.assert_allclose(camera[key], before[1][key], atol=1e-9)
            before = picture, camera

    def test_fitted_to_an_angle(self):
        """The ball around the triangle touches the view's edges, whatever the angle."""
        for angle in (30, 60, 100):
            self.relievo("render", "triangle.off", "--preset", "none", "--size", "90x70",
                         "--view-angle", angle, "--report", "a.json")  # fmt: skip
            with open(self.folder / "a.json") as file:
                camera = json.load(file)["camera"]
            half = numpy.radians(angle / 2)
            self.assertAlmostEqual(camera["K"][4], 35 / numpy.tan(half), places=6)
            self.assertAlmostEqual(camera["t"][2], numpy.sqrt(2) / numpy.sin(half), places=6)

    def test_refused(self):
        (self.folder / "wide.yml").write_text(CALIBRATION)
        (self.folder / "bad.yml").write_text(CALIBRATION.replace("image_width", "breadth"))
        self.before = self.names()
        for says, status, words in (
            ("--lens: got 'fishy', expected pinhole, brown:", 2, ["--lens", "fishy"]),
            ("six times as wide as high", 2, ["--lens", "cube", "--size", "60x40"]),
            ("cannot span 30 degrees", 2, ["--lens", "brown:-9,0"]),
            ("cannot span 180 degrees", 2, ["--lens", "pinhole:angle=180"]),
            ("wide.yml: the calibration is for pictures of 120x90", 2,
             ["--lens", "wide.yml", "--size", "100x100"]),
            ("bad.yml: image_width: it is missing", 1, ["--lens", "bad.yml"]),
            ("nowhere.yml: No such file", 1, ["--lens", "nowhere.yml"]),
            ("--lens and --transparent", 2, ["--lens", "fisheye", "--transparent"]),
            ("--lens and --grid", 2, ["--lens", "fisheye", "--grid"]),
            ("--lens and --scale-bar", 2, ["--lens", "fisheye", "--scale-bar", "mm"]),
            ("--lens and --stage display", 2,
             ["--lens", "fisheye", "--stage", "display:layer=depth"]),
            ("--lens and --parallel-scale", 2, ["--lens", "fisheye", "--parallel-scale", "2"]),
            ("with --lens one of color, depth", 2,
             ["--lens", "fisheye", "--exr", "a.exr", "--layers", "albedo"]),
        ):
            with self.subTest(words=words):
                self.refused("render", "triangle.off", *LOOK, *words, "--png", "a.png",
                             status=status, says=says)  # fmt: skip


if __name__ == "__main__":
    main()
