# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of all kinds as textures and maps: pictures of known texels; damaged images."""

import struct
import zlib

import numpy
from PIL import Image

from cli import CliTest, main, read_png

PLANE = """mtllib plane.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl picture
f 1/1 2/2 3/3 4/4
"""
SIDE = 64
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "1",
        "--size", f"{SIDE}x{SIDE}"]  # fmt: skip


def png(values):
    """16 bits of 1 to 4 components, which Pillow does not write in colour."""
    rows, columns, components = values.shape
    color = {1: 0, 2: 4, 3: 2, 4: 6}[components]
    data = zlib.compress(b"".join(b"\0" + row.astype(">u2").tobytes() for row in values))

    def chunk(name, content):
        return (struct.pack(">I", len(content)) + name + content
                + struct.pack(">I", zlib.crc32(name + content)))
    head = struct.pack(">IIBBBBB", columns, rows, 16, color, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data)
            + chunk(b"IEND", b""))


class Images(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plane.obj").write_text(PLANE)

    def albedo(self, name, *words, layers="albedo,actor"):
        (self.folder / "plane.mtl").write_text(f"newmtl picture\nKd 1 1 1\nmap_Kd {name}\n")
        done = self.relievo("render", "plane.obj", *LOOK, *words, "--layers", layers, "--exr",
                            "a.exr")  # fmt: skip
        self.assertEqual(done.stderr, "")
        channels = self.exr("a.exr")[1]
        self.actor = channels["actor.id"]
        return numpy.stack([channels[f"albedo.{c}"] for c in "RGBA"], axis=-1)

    def test_sixteen_bits(self):
        """White is white, and every value that of the file: VTK's table of colours made red."""
        for components in (1, 2, 3, 4):
            with self.subTest(components=components):
                values = numpy.full((8, 8, components), 65535, numpy.uint16)
                values[:, :, : components - 1 + components % 2] = (52000, 30000, 9000)[
                    : components - 1 + components % 2]
                (self.folder / "deep.png").write_bytes(png(values))
                seen = self.albedo("deep.png")[SIDE // 2, SIDE // 2]
                shown = values[0, 0, : components - 1 + components % 2] / 65535
                expected = shown if components > 2 else numpy.repeat(shown, 3)
                numpy.testing.assert_allclose(seen[:3], expected, atol=1.1 / 255)
        white = numpy.full((8, 8, 3), 65535, numpy.uint16)
        (self.folder / "white.png").write_bytes(png(white))
        numpy.testing.assert_allclose(self.albedo("white.png"), 1, atol=1e-6)

    def test_palette_and_few_bits(self):
        image = Image.new("P", (8, 8), 1)
        image.putpalette([10, 20, 30, 200, 100, 50])
        image.save(self.folder / "palette.png", bits=1)
        image.save(self.folder / "palette.bmp")
        image.save(self.folder / "palette.tif")
        Image.new("RGB", (8, 8), (200, 100, 50)).save(self.folder / "plain.tga")
        for name in ("palette.png", "palette.bmp", "palette.tif", "plain.tga"):
            seen = self.albedo(name)[SIDE // 2, SIDE // 2, :3]
            numpy.testing.assert_allclose(seen, numpy.array((200, 100, 50)) / 255, atol=1 / 255)

    def test_cut_outs(self):
        """Holes show the background in all layers; the rest is opaque, and stays smooth."""
        for components in (2, 4):
            values = numpy.full((8, 8, components), 255, numpy.uint8)
            values[2:6, 2:6, -1] = 0
            Image.fromarray(values, {2: "LA", 4: "RGBA"}[components]).save(
                self.folder / "hole.png")
            seen = self.albedo("hole.png")
            # Half of the way between texel centres, which is the texels' border.
            place = (numpy.arange(SIDE) + 0.5) / SIDE * 8
            inside = (place > 2) & (place < 6)
            sure = (abs(place - 2) > 0.2) & (abs(place - 6) > 0.2)
            hole = inside[:, None] & inside[None]
            known = sure[:, None] & sure[None]
            nothing = 0xFFFFFFFF
            numpy.testing.assert_array_equal((self.actor == nothing)[known], hole[known])
            numpy.testing.assert_array_equal(seen[known & ~hole], 1)

    def test_see_through_cut_outs(self):
        """--opacity makes the rest see-through: layers have none of it, and the holes stay."""
        values = numpy.full((8, 8, 4), 255, numpy.uint8)
        values[2:6, 2:6, 3] = 0
        Image.fromarray(values, "RGBA").save(self.folder / "hole.png")
        self.albedo("hole.png", "--opacity", "0.4")
        self.assertEqual(set(self.actor.ravel()), {0xFFFFFFFF})
        self.relievo("render", "plane.obj", *LOOK, "--opacity", "0.4", "--png", "a.png")
        picture = read_png(self.folder / "a.png")
        self.assertEqual(picture[SIDE // 2, SIDE // 2].max(), 0)
        self.assertLess(abs(picture[2, 2].astype(int) - 0.4 * 255).max(), 2)

    def test_shadow_of_a_cut_out(self):
        values = numpy.full((8, 8, 4), 255, numpy.uint8)
        values[2:6, 2:6, 3] = 0
        Image.fromarray(values, "RGBA").save(self.folder / "hole.png")
        (self.folder / "plane.mtl").write_text("newmtl picture\nKd 1 1 1\nmap_Kd hole.png\n")
        (self.folder / "floor.off").write_text(
            "OFF\n4 1 0\n-4 -4 -1\n4 -4 -1\n4 4 -1\n-4 4 -1\n4 0 1 2 3\n")
        for method in ("map", "exact"):
            self.relievo("render", "plane.obj", "floor.off", "--camera", "0,0,9,0,0,0,0,1,0",
                         "--clip", "1,20", "--parallel-scale", "2", "--size", "80x80", "--light",
                         "sun:1,0,1", "--shadows", method, "--layers", "shadow_0,actor", "--exr",
                         "a.exr")  # fmt: skip
            channels = self.exr("a.exr")[1]
            shadow = channels["shadow_0.V"]
            x = (numpy.arange(80) + 0.5) / 80 * 4 - 2
            row = shadow[40]
            # The plane's shadow is moved by -1 in x; its hole was -1/2 to 1/2.
            floor = channels["actor.id"][40] == 1
            lit = (x < -2.1) | ((x > -1.4) & (x < -0.6))
            dark = (x > -1.95) & (x < -1.6)
            self.assertGreater((floor & lit).sum(), 3)
            self.assertGreater((floor & dark).sum(), 3)
            numpy.testing.assert_array_equal(row[floor & lit], 1)
            numpy.testing.assert_array_equal(row[floor & dark], 0)

    def test_normal_maps_of_tiff(self):
        """A normal that leans up stays so whatever row the file begins with."""
        tilted = numpy.round((numpy.array([0.0, 0.6, 0.8]) * 0.5 + 0.5) * 255).astype(numpy.uint8)
        flat = numpy.array([128, 128, 255], numpy.uint8)
        values = numpy.tile(flat, (8, 8, 1))
        values[:4] = tilted  # the upper half
        for orientation in (1, 4):
            stored = values if orientation == 1 else values[::-1]
            image = Image.fromarray(numpy.ascontiguousarray(stored))
            image.save(self.folder / "normals.tif", tiffinfo={274: orientation})
            (self.folder / "plane.mtl").write_text("newmtl picture\nKd 1 1 1\n")
            self.relievo("render", "plane.obj", *LOOK, "--normal-map", "normals.tif", "--layers",
                         "normal", "--exr", "a.exr")  # fmt: skip
            y = self.exr("a.exr")[1]["normal.Y"]
            self.assertGreater(y[SIDE // 4].min(), 0.55)
            self.assertLess(abs(y[3 * SIDE // 4]).max(), 0.02)

    def test_damage(self):
        """One line with the image's name; textures that cannot be read are left out with a note."""
        good = numpy.full((64, 64, 3), 128, numpy.uint8)
        for ending in ("png", "jpg", "tif", "bmp", "tga"):
            Image.fromarray(good).save(self.folder / f"good.{ending}")
            whole = (self.folder / f"good.{ending}").read_bytes()
            (self.folder / f"cut.{ending}").write_bytes(whole[: len(whole) // 2])
        head = struct.pack(">IIBBBBB", 60000, 60000, 8, 2, 0, 0, 0)
        (self.folder / "bomb.png").write_bytes(
            b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + b"IHDR" + head
            + struct.pack(">I", zlib.crc32(b"IHDR" + head)))
        (self.folder / "plane.mtl").write_text("newmtl picture\nKd 1 1 1\n")
        self.before = self.names()
        names = ["cut.png", "cut.jpg", "cut.tif", "cut.bmp", "cut.tga", "bomb.png"]
        for name in names:
            for option in ("--normal-map", "--height-map", "--environment"):
                self.refused("render", "plane.obj", option, name, "--png", "a.png", status=1,
                             says=name)  # fmt: skip
            (self.folder / "plane.mtl").write_text(f"newmtl picture\nKd 1 1 1\nmap_Kd {name}\n")
            done = self.relievo("render", "plane.obj", *LOOK, "--png", "a.png")
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(name, done.stderr)
            self.assertEqual(read_png(self.folder / "a.png")[SIDE // 2, SIDE // 2].max(), 255)
            (self.folder / "a.png").unlink()
            (self.folder / "plane.mtl").write_text("newmtl picture\nKd 1 1 1\n")


if __name__ == "__main__":
    main()
