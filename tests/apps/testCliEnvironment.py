# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--environment and --skybox: each direction must have the colour that the image holds there."""

import struct

import numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter

from cli import CliTest, main, read_png, write_image
from srgb import decoded

# Seen along x, y, z from the front and from the back: faces the camera with both sides.
PLANE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
ROWS = 64
COLOURS = {
    (1, 0, 0): (255, 0, 0),
    (-1, 0, 0): (0, 255, 255),
    (0, 1, 0): (0, 255, 0),
    (0, -1, 0): (255, 0, 255),
    (0, 0, 1): (0, 0, 255),
    (0, 0, -1): (255, 255, 0),
}


def axis_image():
    """Bytes (ROWS, 2 ROWS, 3), row 0 lowest: the colour of the axis that is nearest.

    As docs/environment.md says it: the middle looks along +x, +z is a quarter to its right.
    """
    up = numpy.pi * ((numpy.arange(ROWS) + 0.5) / ROWS - 0.5)[:, None]
    east = 2 * numpy.pi * ((numpy.arange(2 * ROWS) + 0.5) / (2 * ROWS) - 0.5)[None, :]
    towards = numpy.stack([numpy.cos(up) * numpy.cos(east), numpy.sin(up) + 0 * east,
                           numpy.cos(up) * numpy.sin(east)], axis=-1)  # fmt: skip
    axes = numpy.array(list(COLOURS))
    return numpy.array(list(COLOURS.values()), numpy.uint8)[(towards @ axes.T).argmax(axis=-1)]


def write_exr(path, values):
    """Floats (rows, columns, 3), row 0 lowest: OpenEXR's plainest file, by its specification."""
    rows, columns, _ = values.shape

    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(data)) + data

    float_channel = b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1)
    channels = b"".join(name + float_channel for name in (b"B", b"G", b"R"))
    window = struct.pack("<4i", 0, 0, columns - 1, rows - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += attribute(b"channels", b"chlist", channels + b"\0")
    header += attribute(b"compression", b"compression", b"\0")
    header += attribute(b"dataWindow", b"box2i", window)
    header += attribute(b"displayWindow", b"box2i", window)
    header += attribute(b"lineOrder", b"lineOrder", b"\0")
    header += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    header += attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0))
    header += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    line = 8 + 12 * columns
    first = len(header) + 8 * rows
    table = b"".join(struct.pack("<q", first + line * y) for y in range(rows))
    lines = b"".join(
        struct.pack("<ii", y, 12 * columns) + row[:, ::-1].T.astype("<f4").tobytes()
        for y, row in enumerate(values[::-1])
    )
    path.write_bytes(header + table + lines)


def write_hdr(path, values):
    """Radiance's plain pixels: three mantissas of 8 bits and their exponent; the top row first."""
    rows, columns, _ = values.shape
    _, exponent = numpy.frexp(values.max(axis=-1))
    mantissas = values / numpy.exp2(exponent - 8.0)[..., None]
    code = numpy.where(values.max(axis=-1) > 0, exponent + 128, 0)
    pixels = numpy.concatenate([mantissas.clip(0, 255), code[..., None]], axis=-1)
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {rows} +X {columns}\n".encode()
    path.write_bytes(head + pixels[::-1].astype(numpy.uint8).tobytes())


def shown(light):
    """The byte of a picture that stands for a light, by a power of 1 / 2.2."""
    return 255 * light ** (1 / 2.2)


def words_of(vector):
    return ",".join(f"{x:g}" for x in vector)


class Environments(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plane.obj").write_text(PLANE)
        self.axes = axis_image()
        write_image(vtkPNGWriter(), self.folder / "axes.png", self.axes)
        self.before = self.names()

    def draw(self, *words, camera, size="16x12"):
        """The picture from the camera (position, focal point, up)."""
        self.relievo("render", "plane.obj", "--camera", words_of(numpy.concatenate(camera)),
                     "--size", size, *words, "--png", "a.png")  # fmt: skip
        return read_png(self.folder / "a.png").astype(int)

    def check_sky(self, towards, *words, shows=numpy.eye(3), off=0):
        """A wide picture of the sky, with the plane behind the camera: each pixel has the colour
        of its direction. shows: the image's directions that are along x, y and z."""
        towards, size = numpy.array(towards) / numpy.sqrt(3), 24
        right = numpy.cross(towards, (0, 1, 0)) / numpy.linalg.norm(numpy.cross(towards, (0, 1, 0)))
        seen = self.draw("--skybox", "--view-angle", "120", *words, size=f"{size}x{size}",
                         camera=(100 * towards, 200 * towards, (0, 1, 0)))  # fmt: skip
        across = (2 * (numpy.arange(size) + 0.5) / size - 1) * numpy.tan(numpy.radians(60))
        x, y = numpy.meshgrid(across, -across)
        rays = towards + x[..., None] * right + y[..., None] * numpy.cross(right, towards)
        near = rays @ numpy.array(shows) @ numpy.array(list(COLOURS)).T
        near /= numpy.linalg.norm(rays, axis=-1, keepdims=True)
        least = numpy.sort(near, axis=-1)
        sure = least[..., -1] - least[..., -2] > 0.35
        self.assertEqual(len(set(near.argmax(axis=-1)[sure])), 3)
        expected = numpy.array(list(COLOURS.values()))[near.argmax(axis=-1)]
        self.assert_colour(seen[sure], expected[sure], off)

    def sky(self, axis, *words):
        """The sky along an axis of the world, with the plane behind the camera."""
        axis = numpy.array(axis)
        up = (0, 0, 1) if axis[1] else (0, 1, 0)
        return self.draw("--skybox", *words, camera=(100 * axis, 200 * axis, up))

    def mirror(self, position, *words):
        """The picture in a perfect mirror at z = 0, with all rays in one direction."""
        seen = self.draw("--reflectivity", "1,0", "--parallel-scale", "0.2", *words,
                         camera=(position, (0, 0, 0), (0, 0.6, 0.8)))  # fmt: skip
        return seen[4:8, 6:10]

    def uniform(self, value, name="even.exr"):
        write_exr(self.folder / name, numpy.full((8, 16, 3), value))
        return name

    def assert_colour(self, seen, colour, off=0):
        self.assertLessEqual(abs(seen - numpy.array(colour)).max(), off)

    def test_sky(self):
        for towards in ((1, 1, 1), (-1, -1, -1)):
            self.check_sky(towards, "--environment", "axes.png")

    def test_files(self):
        """Every kind of file the same way up and round."""
        light = self.axes / 255.0
        write_exr(self.folder / "axes.exr", light)
        write_hdr(self.folder / "axes.hdr", light)
        write_image(vtkJPEGWriter(), self.folder / "axes.jpg", self.axes)
        for name, off in (("axes.exr", 0), ("axes.hdr", 1), ("axes.jpg", 25)):
            self.check_sky((1, 1, 1), "--environment", name, off=off)

    def test_rotation(self):
        """Rotation by 90: +z becomes +x; y stays."""
        self.check_sky((1, 1, -1), "--environment", "axes.png,90",
                       shows=((0, 0, 1), (0, 1, 0), (-1, 0, 0)))  # fmt: skip
        self.check_sky((-1, 1, 1), "--environment", "axes.png,-90",
                       shows=((0, 0, -1), (0, 1, 0), (1, 0, 0)))  # fmt: skip

    def test_up(self):
        """With z up the environment's y is there, its x stays, its z is the world's -y."""
        self.check_sky((1, -1, 1), "--environment", "axes.png", "--up", "z",
                       shows=((1, 0, 0), (0, 0, -1), (0, 1, 0)))  # fmt: skip
        # The camera that fits the scene looks along y then, away from the environment's z.
        (self.folder / "solid.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\n"
                                               "f 1 2 4\nf 2 3 4\nf 1 4 3\n")  # fmt: skip
        self.relievo("render", "solid.obj", "--size", "9x9", "--environment", "axes.png", "--up",
                     "z", "--skybox", "--png", "a.png")  # fmt: skip
        self.assert_colour(read_png(self.folder / "a.png")[0, 0].astype(int), COLOURS[0, 0, -1])

    def test_mirror(self):
        """A mirror in z = 0 seen from all around: all six axes."""
        for position, axis in (
            ((0.1, 0, 5), (0, 0, 1)),
            ((5, 0, 1.5), (-1, 0, 0)),
            ((-5, 0, 1.5), (1, 0, 0)),
            ((0, 5, 1.5), (0, -1, 0)),
            ((0, -5, 1.5), (0, 1, 0)),
            ((0.1, 0, -5), (0, 0, -1)),
        ):
            self.assert_colour(self.mirror(position, "--environment", "axes.png"), COLOURS[axis])

    def test_mirror_with_normal_map(self):
        """Normals (0.6, 0, 0.8) seen from above mirror (0.96, 0, 0.28)."""
        tilted = numpy.round((numpy.array([0.6, 0, 0.8]) * 0.5 + 0.5) * 255).astype(numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / "tilted.png", numpy.tile(tilted, (8, 8, 1)))
        seen = self.mirror((0, -0.001, 5), "--environment", "axes.png", "--normal-map",
                           "tilted.png")  # fmt: skip
        self.assert_colour(seen, COLOURS[1, 0, 0])

    def test_numbers(self):
        """Bytes are sRGB, floats are light."""
        even = numpy.full((8, 16, 3), 188, numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / "even.png", even)
        seen = self.sky((1, 0, 0), "--environment", "even.png")
        self.assert_colour(seen, shown(decoded(188 / 255)), 1)
        seen = self.sky((1, 0, 0), "--environment", self.uniform(188 / 255))
        self.assert_colour(seen, shown(188 / 255), 1)
        write_hdr(self.folder / "even.hdr", numpy.full((8, 16, 3), 0.25))
        self.assert_colour(self.sky((1, 0, 0), "--environment", "even.hdr"), shown(0.25), 1)

    def test_light_beyond_floats(self):
        """Light is cut at 1e12: it is drawn as that, in a time as for any other."""
        light = numpy.full((8, 16, 3), 0.25)
        seen = []
        for brightest in (1e12, 1e38):
            light[3, 2:7] = brightest
            write_exr(self.folder / "sun.exr", light)
            words = ["--environment", "sun.exr", "--skybox", "--reflectivity", "0.5,0.4"]
            seen.append(self.draw(*words, camera=((0, 0, 5), (0, 0, 0), (0, 1, 0))))
        numpy.testing.assert_array_equal(*seen)

    def test_even_light(self):
        """In even light a white surface is as bright as the sky, mirrors and lights as they may."""
        name = self.uniform(0.5)
        for words in ([], ["--reflectivity", "0"], ["--reflectivity", "0.5,1"],
                      ["--shading", "flat"], ["--shading", "gouraud"]):  # fmt: skip
            seen = self.draw("--environment", name, "--skybox", *words,
                             camera=((0, 0, 5), (0, 0, 0), (0, 1, 0)))  # fmt: skip
            self.assert_colour(seen, shown(0.5), 1)

    def test_very_bright_or_dark_light(self):
        """Even light becomes 0.4 with a preset, unless its intensity is given."""
        studio = {"RELIEVO_PRESET": "studio"}
        small = ("--size", "16x12", "--skybox", "--stage", "antialias:samples=1", "--ground", "off",
                 "--camera", "100,0,0,200,0,0,0,1,0")  # fmt: skip
        for light, words, expected, says in (
            (20, "", 0.4, "too bright"), (0.01, "", 0.4, "too dark"), (0.5, "", 0.5, ""),
            (20, ",intensity=0.01", 0.2, ""),
        ):  # fmt: skip
            with self.subTest(light=light, words=words):
                name = self.uniform(light)
                done = self.relievo("render", "plane.obj", "--environment", name + words, *small,
                                    "--png", "a.png", environment=studio)  # fmt: skip
                self.assertEqual("drawn with intensity=" in done.stderr, bool(says), done.stderr)
                self.assertIn(says, done.stderr)
                seen = read_png(self.folder / "a.png")[..., :3].astype(int)
                self.assert_colour(seen, shown(expected), 2)

    def test_nothing_else_lights(self):
        """Without --light there is no lamp beside the environment."""
        seen = self.draw("--environment", self.uniform(0.0), "--skybox",
                         camera=((0, 0, 5), (0, 0, 0), (0, 1, 0)))  # fmt: skip
        self.assert_colour(seen, 0)

    def test_shadow_and_layers(self):
        """In a lamp's shadow a white surface shows the environment's light; layers show no sky."""
        (self.folder / "lid.obj").write_text(
            "v -0.2 -0.2 0.5\nv 0.2 -0.2 0.5\nv 0.2 0.2 0.5\nv -0.2 0.2 0.5\nf 1 2 3 4\n"
        )
        self.relievo("render", "plane.obj", "lid.obj", "--camera", "0,0,5,0,0,0,0,1,0",
                     "--parallel-scale", "1.2", "--size", "96x96", "--light", "sun:0,-1,1",
                     "--shadows", "map", "--environment", self.uniform(0.25), "--skybox",
                     "--exr", "a.exr", "--layers", "depth,actor,shadow_0")  # fmt: skip
        seen = self.exr("a.exr")[1]
        ground = seen["actor.id"] == 0
        dark = ground & (seen["shadow_0.V"] == 0)
        self.assertGreater(dark.sum(), 100)
        # EXR's colour is the picture's, taken as sRGB.
        expected = decoded(shown(0.25) / 255)
        numpy.testing.assert_allclose(seen["R"][dark], expected, atol=0.005)
        # Lit, there is the lamp's as well: one over the root of two of it, coded as colours are.
        lit = ground & (seen["shadow_0.V"] == 1)
        self.assertGreater(seen["G"][lit].min(), 0.5)
        beyond = seen["actor.id"] == 0xFFFFFFFF
        self.assertGreater(beyond.sum(), 100)
        numpy.testing.assert_allclose(seen["B"][beyond], expected, atol=0.005)
        self.assertTrue(numpy.isposinf(seen["depth.Z"][beyond]).all())

    def test_parallel(self):
        """In a parallel projection the sky spans a view angle of 30 degrees, not one direction."""
        up = numpy.pi * ((numpy.arange(256) + 0.5) / 256 - 0.5)[:, None, None]
        rise = numpy.clip(numpy.tile(up, (1, 512, 3)) / numpy.radians(60) + 0.5, 0, 1)
        write_exr(self.folder / "rise.exr", rise)
        seen = self.draw("--environment", "rise.exr", "--skybox", "--parallel-scale", "1",
                         camera=((0, 0, 100), (0, 0, 200), (0, 1, 0)), size="9x9")  # fmt: skip
        y = 1 - 2 * (numpy.arange(9) + 0.5) / 9
        degrees = numpy.degrees(numpy.arctan(y * numpy.tan(numpy.radians(15))))
        self.assert_colour(seen[:, 4, 0], shown(degrees / 60 + 0.5), 1.5)

    def test_refusals(self):
        """Invalid environments are named with the expectation, and nothing is written."""
        look = ["render", "plane.obj", "--png", "a.png"]
        (self.folder / "torn.png").write_text("not a picture")
        (self.folder / "torn.exr").write_bytes(b"v/1\1" + (self.folder / "axes.png").read_bytes())
        (self.folder / "torn.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X")
        write_exr(self.folder / "cut.exr", numpy.ones((64, 128, 3)))
        write_hdr(self.folder / "cut.hdr", numpy.ones((64, 128, 3)))
        for name in ("cut.exr", "cut.hdr"):
            whole = (self.folder / name).read_bytes()
            (self.folder / name).write_bytes(whole[: len(whole) // 2])
        write_image(vtkPNGWriter(), self.folder / "wide.png", numpy.zeros((8, 30, 3), numpy.uint8))
        self.before = self.names()
        for name in ("no.exr", "torn.png", "torn.exr", "torn.hdr", "cut.exr", "cut.hdr"):
            self.refused(*look, "--environment", name, status=1, says=name)
        self.refused(*look, "--environment", "wide.png", status=1,
                     says=["wide.png", "30 x 8", "twice as wide as high"])  # fmt: skip
        self.refused(*look, "--environment", "sky.gif", status=2,
                     says=["--environment", "sky.gif", ".hdr"])  # fmt: skip
        self.refused(*look, "--skybox", status=2, says=["--skybox", "--environment"])
        self.refused(*look, "--reflectivity", "1", status=2,
                     says=["--reflectivity", "--environment"])  # fmt: skip
        self.refused(*look, "--skybox=yes", "--environment", "axes.png", status=2,
                     says=["--skybox", "no value"])  # fmt: skip
        self.refused("render", "plane.obj", "--environment", "axes.png", "--png", "axes.png",
                     status=2, says=["axes.png", "to read"])  # fmt: skip


if __name__ == "__main__":
    main()
