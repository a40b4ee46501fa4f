# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Image files of all formats against texels that are known, written here or by Pillow."""

import io
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy
from PIL import Image

import relievo
from relievo._arguments.errors import Watch
from relievo.vtkRelievoIO import vtkRelievoImageReader

LACKS = os.environ.get("RELIEVO_VTK_LACKS", "").split()  # tests/wheel/CMakeLists.txt
RANDOM = numpy.random.default_rng(27)


def texels(rows=5, columns=7, components=3, kind=numpy.uint8):
    shape = (rows, columns, components) if components > 1 else (rows, columns)
    return RANDOM.integers(0, numpy.iinfo(kind).max + 1, shape, dtype=kind)


def png_chunk(name, data):
    return (struct.pack(">I", len(data)) + name + data
            + struct.pack(">I", zlib.crc32(name + data)))


def png(columns, rows, depth, color, packed_rows, before=b"", interlace=0):
    """packed_rows: the bytes of each row, to which filter 0 is added."""
    data = zlib.compress(b"".join(b"\0" + row for row in packed_rows))
    return (b"\x89PNG\r\n\x1a\n"
            + png_chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, depth, color, 0, 0,
                                             interlace))
            + before + png_chunk(b"IDAT", data[:9]) + png_chunk(b"IDAT", data[9:])
            + png_chunk(b"IEND", b""))


def packed(row, depth):
    """Samples of 1 to 8 bits in bytes, the first one in the highest bits."""
    bits = "".join(format(int(value), f"0{depth}b") for value in row)
    bits += "0" * (-len(bits) % 8)
    return bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def tiff(values, order="<", orientation=1, photometric=None, bits=None, colormap=None,
         planar=1, tile=None, sample_format=None, extra=None):
    """An uncompressed TIFF of an array (rows, columns, samples)."""
    values = values if values.ndim == 3 else values[..., None]
    rows, columns, samples = values.shape
    bits = bits or values.dtype.itemsize * 8
    kind = {"u": 1, "i": 2, "f": 3}[values.dtype.kind] if sample_format is None else sample_format
    stored = values.astype(values.dtype.newbyteorder(order))

    def blocks(part):
        if tile is None:
            yield b"".join(packed(row, bits) if bits < 8 else row.tobytes()
                           for row in part.reshape(rows, -1))
            return
        for top in range(0, rows, tile):
            for left in range(0, columns, tile):
                block = numpy.zeros((tile, tile, part.shape[2]), part.dtype)
                cut = part[top:top + tile, left:left + tile]
                block[:cut.shape[0], :cut.shape[1]] = cut
                yield block.tobytes()
    parts = [stored] if planar == 1 else [stored[..., i:i + 1] for i in range(samples)]
    pieces = [block for part in parts for block in blocks(part)]
    entries = {256: ("I", [columns]), 257: ("I", [rows]), 258: ("H", [bits] * samples),
               259: ("H", [1]),
               262: ("H", [photometric if photometric is not None else 2 if samples > 2 else 1]),
               274: ("H", [orientation]), 277: ("H", [samples]), 284: ("H", [planar]),
               339: ("H", [kind] * samples)}
    if samples in (2, 4) and photometric is None:
        entries[338] = ("H", [2 if extra is None else extra])
    if colormap is not None:
        entries[320] = ("H", list(colormap))
    offsets, sizes = (273, 279) if tile is None else (324, 325)
    if tile is None:
        entries[278] = ("I", [rows])
    else:
        entries[322] = entries[323] = ("I", [tile])
    entries[sizes] = ("I", [len(piece) for piece in pieces])
    start = 8
    places = []
    for piece in pieces:
        places.append(start)
        start += len(piece)
    entries[offsets] = ("I", places)
    content = b"".join(pieces) + b"\0" * (start % 2)
    start += start % 2
    directory = b""
    tail = b""
    behind = start + 2 + 12 * len(entries) + 4
    for tag in sorted(entries):
        code, numbers = entries[tag]
        data = struct.pack(f"{order}{len(numbers)}{code}", *numbers)
        directory += struct.pack(order + "HHI", tag, 3 if code == "H" else 4, len(numbers))
        if len(data) <= 4:
            directory += data.ljust(4, b"\0")
        else:
            directory += struct.pack(order + "I", behind + len(tail))
            tail += data + b"\0" * (len(data) % 2)
    return (struct.pack(order + "2sHI", b"II" if order == "<" else b"MM", 42, start) + content
            + struct.pack(order + "H", len(entries)) + directory + b"\0\0\0\0" + tail)


def stored_as(shown, orientation):
    """The texels of a TIFF that is shown as `shown`: TIFF 6.0, Orientation."""
    turned = shown.swapaxes(0, 1) if orientation >= 5 else shown
    # The file's row 0 is the picture's: 1, 2 top; 3, 4 bottom; 5, 8 left; 6, 7 right. Its column 0:
    # 1, 4 left; 2, 3 right; 5, 6 top; 7, 8 bottom.
    if orientation in (3, 4, 6, 7):
        turned = turned[::-1]
    if orientation in (2, 3, 7, 8):
        turned = turned[:, ::-1]
    return numpy.ascontiguousarray(turned)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path_of(self, content, name):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def read(self, content, name, colors=False):
        """The image as an array, row 0 at the top."""
        reader = vtkRelievoImageReader()
        reader.SetFileName(str(self.path_of(content, name)))
        reader.SetColors(colors)
        with Watch(reader) as watch:
            reader.Update()
        watch.raise_as(ValueError, "read")
        return relievo.from_image(reader.GetOutput())

    def check(self, content, name, expected):
        got = self.read(content, name)
        self.assertEqual(got.dtype, expected.dtype)
        numpy.testing.assert_array_equal(got, expected)

    def written(self, image, form, **options):
        out = io.BytesIO()
        image.save(out, form, **options)
        return out.getvalue()


class Png(Files):
    def test_grey_of_few_bits(self):
        for depth in (1, 2, 4, 8):
            with self.subTest(depth=depth):
                values = RANDOM.integers(0, 2 ** depth, (5, 7), dtype=numpy.uint8)
                content = png(7, 5, depth, 0, [packed(row, depth) for row in values])
                scaled = (values * (255 // (2 ** depth - 1))).astype(numpy.uint8)
                self.check(content, "grey.png", scaled)

    def test_palette(self):
        colors = RANDOM.integers(0, 256, (16, 3), dtype=numpy.uint8)
        alpha = RANDOM.integers(0, 256, 5, dtype=numpy.uint8)
        table = png_chunk(b"PLTE", colors.tobytes())
        for depth in (1, 2, 4, 8):
            with self.subTest(depth=depth):
                most = min(16, 2 ** depth)
                values = RANDOM.integers(0, most, (5, 7), dtype=numpy.uint8)
                used = png_chunk(b"PLTE", colors[:most].tobytes())
                rows = [packed(row, depth) for row in values]
                self.check(png(7, 5, depth, 3, rows, used), "palette.png", colors[values])
        values = RANDOM.integers(0, 16, (5, 7), dtype=numpy.uint8)
        content = png(7, 5, 4, 3, [packed(row, 4) for row in values],
                      table + png_chunk(b"tRNS", alpha.tobytes()))
        full = numpy.concatenate([alpha, numpy.full(11, 255, numpy.uint8)])
        self.check(content, "alpha.png", numpy.dstack([colors[values], full[values]]))

    def test_sixteen_bits(self):
        for components, color in ((1, 0), (2, 4), (3, 2), (4, 6)):
            with self.subTest(components=components):
                values = texels(5, 7, components, numpy.uint16)
                rows = [row.astype(">u2").tobytes() for row in values]
                self.check(png(7, 5, 16, color, rows), "deep.png", values)

    def test_one_transparent_colour(self):
        values = texels()
        values[2, 3] = values[4, 1] = (7, 8, 9)
        content = png(7, 5, 8, 2, [row.tobytes() for row in values],
                      png_chunk(b"tRNS", struct.pack(">HHH", 7, 8, 9)))
        alpha = numpy.where((values == (7, 8, 9)).all(axis=2), 0, 255).astype(numpy.uint8)
        self.check(content, "key.png", numpy.dstack([values, alpha]))

    def test_interlaced(self):
        passes = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4),
                  (1, 0, 2, 2), (0, 1, 1, 2))
        for rows, columns in ((1, 1), (3, 2), (13, 11), (16, 16)):
            with self.subTest(rows=rows, columns=columns):
                values = texels(rows, columns)
                parts = [values[y::dy, x::dx] for x, y, dx, dy in passes]
                packed_rows = [row.tobytes() for part in parts if part.size for row in part]
                content = png(columns, rows, 8, 2, packed_rows, interlace=1)
                self.check(content, "interlaced.png", values)

    def test_filters_of_pillow(self):
        y, x = numpy.mgrid[0:64, 0:80]
        for components in (1, 3, 4):
            values = numpy.dstack([(3 * x + 5 * y * i + x * y // 7) % 256
                                   for i in range(components)]).astype(numpy.uint8).squeeze()
            content = self.written(Image.fromarray(values), "png", optimize=True)
            self.check(content, "smooth.png", values)

    def test_damage(self):
        values = texels()
        rows = [row.tobytes() for row in values]
        whole = png(7, 5, 8, 2, rows)
        head = whole[:33]
        sizes = b"\x89PNG\r\n\x1a\n" + b"%s" + whole[33:]
        cases = {
            "too little": (png(7, 5, 8, 2, rows[:4]), "Not enough image data"),
            "no data": (head + png_chunk(b"IEND", b""), "IEND: out of place"),
            "no palette": (png(7, 5, 8, 3, [row[:7] for row in rows]), "Missing PLTE"),
            "short palette": (png(7, 5, 8, 3, [b"\1" * 7] * 5, png_chunk(b"PLTE", b"abc")),
                              "palette"),
            "long transparency": (png(7, 5, 8, 3, [bytes(7)] * 5, png_chunk(b"PLTE", b"abc")
                                      + png_chunk(b"tRNS", b"abcd")), "tRNS"),
            "late transparency": (whole[:-12] + png_chunk(b"tRNS", bytes(6)) + whole[-12:],
                                  "tRNS: out of place"),
            "unknown chunk": (png(7, 5, 8, 2, rows, png_chunk(b"NEED", b"")), "NEED"),
            "turned bit of a text": (png(7, 5, 8, 2, rows, png_chunk(b"tEXt", b"a\0b")[:-1]
                                         + b"x"), "damaged"),
            "cut": (whole[:-20], "ends too early"),
            "turned bit": (whole[:50] + bytes([whole[50] ^ 4]) + whole[51:], "damaged"),
            "no header": (whole[:8] + whole[33:], "header"),
            "zero": (sizes.replace(b"%s", png_chunk(
                b"IHDR", struct.pack(">IIBBBBB", 0, 5, 8, 2, 0, 0, 0))), "0 x 5"),
            "2^31": (sizes.replace(b"%s", png_chunk(
                b"IHDR", struct.pack(">IIBBBBB", 2 ** 31, 5, 8, 2, 0, 0, 0))), "2147483648 x 5"),
            "bomb": (sizes.replace(b"%s", png_chunk(
                b"IHDR", struct.pack(">IIBBBBB", 50000, 50000, 8, 2, 0, 0, 0))), "at most 256 Mi"),
            "depth 3": (sizes.replace(b"%s", png_chunk(
                b"IHDR", struct.pack(">IIBBBBB", 7, 5, 3, 2, 0, 0, 0))), "bit depth"),
        }
        for label, (content, says) in cases.items():
            with self.subTest(label=label):
                with self.assertRaises(ValueError) as caught:
                    self.read(content, "damaged.png")
                self.assertIn("damaged.png", str(caught.exception))
                self.assertIn(says, str(caught.exception))


class Tiff(Files):
    def test_orientations(self):
        shown = texels(5, 7)
        for orientation in range(1, 9):
            with self.subTest(orientation=orientation):
                stored = stored_as(shown, orientation)
                self.check(tiff(stored, orientation=orientation), "turned.tif", shown)

    def test_kinds(self):
        for kind in (numpy.uint8, numpy.uint16):
            for samples in (1, 2, 3, 4):
                for order in "<>":
                    for planar in (1, 2):
                        for tile in (None, 16):
                            with self.subTest(kind=kind, samples=samples, order=order,
                                              planar=planar, tile=tile):
                                values = texels(21, 37, samples, kind)
                                content = tiff(values, order, planar=planar, tile=tile)
                                self.check(content, "kind.tif", values)

    def test_floats_and_signed(self):
        for kind in (numpy.float32, numpy.float64, numpy.int16, numpy.int32, numpy.uint32):
            with self.subTest(kind=kind):
                values = (RANDOM.normal(size=(5, 7)) * 1000).astype(kind)
                expected = values.astype(numpy.float32)
                self.check(tiff(values), "float.tif", expected)
                self.check(tiff(values, ">"), "float.tif", expected)

    def test_palette_and_few_bits(self):
        for bits in (1, 4, 8):
            values = RANDOM.integers(0, 2 ** bits, (5, 7), dtype=numpy.uint8)
            colors = RANDOM.integers(0, 256, (2 ** bits, 3), dtype=numpy.uint8)
            table = (colors.astype(int) * 257).T.ravel()
            with self.subTest(bits=bits):
                self.check(tiff(values, bits=bits, photometric=3, colormap=table), "palette.tif",
                           colors[values])
                scaled = (values * (255 // (2 ** bits - 1))).astype(numpy.uint8)
                self.check(tiff(values, bits=bits), "few.tif", scaled)
                self.check(tiff(values, bits=bits, photometric=0), "white.tif", 255 - scaled)

    def test_compressions_of_pillow(self):
        values = texels(40, 30)
        for compression in {"raw", "tiff_lzw", "tiff_adobe_deflate", "packbits"}.difference(LACKS):
            with self.subTest(compression=compression):
                content = self.written(Image.fromarray(values), "tiff", compression=compression)
                self.check(content, "packed.tif", values)

    def test_cmyk(self):
        inks = numpy.full((4, 4, 4), (255, 0, 128, 0), numpy.uint8)
        got = self.read(self.written(Image.fromarray(inks, "CMYK"), "tiff"), "inks.tif")
        self.assertEqual(got.shape, (4, 4, 3))
        numpy.testing.assert_allclose(got[0, 0], (0, 255, 127), atol=2)

    def test_damage(self):
        whole = tiff(texels(21, 37))
        for label, content in (("cut", whole[:-300]), ("data cut", tiff(texels(21, 37))[:900]),
                               ("no directory", whole[:8])):
            with self.subTest(label=label):
                with self.assertRaises(ValueError) as caught:
                    self.read(content, "damaged.tif")
                self.assertIn("damaged.tif: expected an image", str(caught.exception))


class Bmp(Files):
    @staticmethod
    def bmp(columns, rows, bits, data, from_top=False, packing=0, palette=b"", masks=b""):
        offset = 54 + len(masks) + len(palette)
        return (struct.pack("<2sIHHI", b"BM", offset + len(data), 0, 0, offset)
                + struct.pack("<IiiHHIIiiII", 40, columns, -rows if from_top else rows, 1, bits,
                              packing, len(data), 0, 0, len(palette) // 4, 0)
                + masks + palette + data)

    def test_both_ways_up(self):
        values = texels(5, 7)
        padded = [row[:, ::-1].tobytes() + b"\0" * (-21 % 4) for row in values]
        self.check(self.bmp(7, 5, 24, b"".join(padded[::-1])), "up.bmp", values)
        self.check(self.bmp(7, 5, 24, b"".join(padded), True), "down.bmp", values)

    def test_palettes(self):
        for bits in (1, 4, 8):
            with self.subTest(bits=bits):
                values = RANDOM.integers(0, 2 ** bits, (5, 7), dtype=numpy.uint8)
                colors = RANDOM.integers(0, 256, (2 ** bits, 3), dtype=numpy.uint8)
                table = b"".join(color[::-1].tobytes() + b"\0" for color in colors)
                rows = [packed(row, bits) for row in values[::-1]]
                data = b"".join(row + b"\0" * (-len(row) % 4) for row in rows)
                self.check(self.bmp(7, 5, bits, data, palette=table), "palette.bmp",
                           colors[values])

    def test_fields(self):
        values = texels(5, 7, 4)
        red, green, blue, alpha = numpy.moveaxis(values.astype(numpy.uint32), 2, 0)
        words = red << 8 | green << 16 | blue << 24 | alpha
        masks = struct.pack("<IIII", 0xFF00, 0xFF0000, 0xFF000000, 0xFF)
        data = words[::-1].astype("<u4").tobytes()
        self.check(self.bmp(7, 5, 32, data, packing=6, masks=masks), "fields.bmp", values)
        five = RANDOM.integers(0, 32, (5, 6, 3))
        words = (five[..., 0] << 11 | five[..., 1] << 6 | five[..., 2]).astype("<u2")
        masks = struct.pack("<III", 0xF800, 0x7C0, 0x1F)
        expected = ((five * 255 + 15) // 31).astype(numpy.uint8)
        self.check(self.bmp(6, 5, 16, words[::-1].tobytes(), packing=3, masks=masks), "565.bmp",
                   expected)

    def test_runs(self):
        colors = RANDOM.integers(0, 256, (256, 3), dtype=numpy.uint8)
        table = b"".join(color[::-1].tobytes() + b"\0" for color in colors)
        # From below: 3 x 7, then 1, 2, 3 one by one; a step up and right; the end.
        data = (b"\3\7\0\3\1\2\3\0" b"\0\0" b"\2\5\0\2\1\1\1\x09" b"\0\1")
        expected = numpy.zeros((3, 6), int)
        expected[2] = (7, 7, 7, 1, 2, 3)
        expected[1, :2] = 5
        expected[0, 3] = 9
        self.check(self.bmp(6, 3, 8, data, packing=1, palette=table), "runs.bmp",
                   colors[expected])

    def test_damage(self):
        values = texels(5, 7)
        padded = b"".join(row.tobytes() + b"\0" * (-21 % 4) for row in values)
        whole = self.bmp(7, 5, 24, padded)
        for label, content, says in (
                ("cut", whole[:-30], "ends too early"), ("header", whole[:20], "ends too early"),
                ("zero", self.bmp(0, 5, 24, padded), "0 x 5"),
                ("bomb", self.bmp(2 ** 30, 2 ** 30, 24, padded), "at most 256 Mi"),
                ("negative", self.bmp(-7, 5, 24, padded), "width"),
                ("palette", self.bmp(7, 5, 8, b"\xff" * 40, palette=b"abc\0"), "palette"),
                ("run", self.bmp(7, 5, 8, b"\xff\0\0\1", packing=1, palette=b"abc\0"), "run")):
            with self.subTest(label=label):
                with self.assertRaises(ValueError) as caught:
                    self.read(content, "damaged.bmp")
                self.assertIn(says, str(caught.exception))


class Tga(Files):
    @staticmethod
    def tga(kind, columns, rows, bits, data, descriptor=0, palette=b"", colors=0, color_bits=0):
        return (struct.pack("<BBBHHBHHHHBB", 3, int(colors > 0), kind, 0, colors, color_bits, 0, 0,
                            columns, rows, bits, descriptor) + b"abc" + palette + data)

    def test_orders(self):
        values = texels(5, 7)
        data = {0: values[::-1], 0x20: values, 0x10: values[::-1, ::-1], 0x30: values[:, ::-1]}
        for descriptor, stored in data.items():
            with self.subTest(descriptor=descriptor):
                content = self.tga(2, 7, 5, 24, stored[..., ::-1].tobytes(), descriptor)
                self.check(content, "plain.tga", values)

    def test_kinds(self):
        grey = texels(5, 7, 1)
        self.check(self.tga(3, 7, 5, 8, grey.tobytes(), 0x20), "grey.tga", grey)
        four = texels(5, 7, 4)
        data = four[..., [2, 1, 0, 3]].tobytes()
        self.check(self.tga(2, 7, 5, 32, data, 0x28), "alpha.tga", four)
        self.check(self.tga(2, 7, 5, 32, data, 0x20), "opaque.tga", four[..., :3])
        five = RANDOM.integers(0, 32, (5, 7, 3))
        words = (five[..., 0] << 10 | five[..., 1] << 5 | five[..., 2]).astype("<u2")
        self.check(self.tga(2, 7, 5, 16, words.tobytes(), 0x20), "five.tga",
                   ((five * 255 + 15) // 31).astype(numpy.uint8))
        colors = texels(1, 16, 3)[0]
        index = RANDOM.integers(0, 16, (5, 7), dtype=numpy.uint8)
        content = self.tga(1, 7, 5, 8, index.tobytes(), 0x20, colors[:, ::-1].tobytes(), 16, 24)
        self.check(content, "palette.tga", colors[index])

    def test_runs(self):
        values = numpy.repeat(texels(6, 10, 3), 3, axis=1)
        for mode in ("RGB", "L"):
            picked = values if mode == "RGB" else numpy.ascontiguousarray(values[..., 0])
            content = self.written(Image.fromarray(picked), "tga", rle=True)
            self.check(content, "runs.tga", picked)

    def test_damage(self):
        whole = self.tga(2, 7, 5, 24, texels(5, 7).tobytes())
        for content, says in ((whole[:-9], "ends too early"), (b"", "empty"),
                              (self.tga(4, 7, 5, 24, b""), "TGA"),
                              (self.tga(2, 0, 5, 24, b""), "0 x 5")):
            with self.assertRaises(ValueError) as caught:
                self.read(content, "damaged.tga")
            self.assertIn(says, str(caught.exception))


class Jpeg(Files):
    def test_modes(self):
        y, x = numpy.mgrid[0:24, 0:32]
        smooth = numpy.dstack([4 * x + 40, 5 * y + 60, 200 - 3 * x]).astype(numpy.uint8)
        for mode, atol in (("RGB", 6), ("L", 3)):
            image = Image.fromarray(smooth).convert(mode)
            for progressive in (False, True):
                content = self.written(image, "jpeg", quality=98, subsampling=0,
                                       progressive=progressive)
                numpy.testing.assert_allclose(
                    self.read(content, "mode.jpg").astype(int),
                    numpy.asarray(image).astype(int), atol=atol)

    def test_inks(self):
        inks = numpy.full((16, 16, 4), (255, 0, 128, 64), numpy.uint8)
        content = self.written(Image.fromarray(inks, "CMYK"), "jpeg", quality=98)
        expected = [(255 - ink) * (255 - 64) / 255 for ink in (255, 0, 128)]
        got = self.read(content, "inks.jpg")
        self.assertEqual(got.shape, (16, 16, 3))
        numpy.testing.assert_allclose(got[8, 8], expected, atol=4)

    def test_stored_texels_whatever_exif_says(self):
        image = Image.fromarray(numpy.dstack([numpy.mgrid[0:16, 0:32][1] * 7] * 3)
                                .astype(numpy.uint8))
        exif = Image.Exif()
        exif[0x0112] = 6
        got = self.read(self.written(image, "jpeg", quality=98, exif=exif), "turned.jpg")
        numpy.testing.assert_allclose(got.astype(int), numpy.asarray(image).astype(int), atol=3)

    def test_damage(self):
        whole = self.written(Image.fromarray(texels(64, 64)), "jpeg")
        for label, content in (("cut", whole[:len(whole) // 2]), ("header", whole[:40]),
                               ("end", whole[:-200])):
            with self.subTest(label=label):
                with self.assertRaises(ValueError) as caught:
                    self.read(content, "damaged.jpg")
                self.assertIn("damaged.jpg: expected an image", str(caught.exception))


class Hdr(Files):
    @staticmethod
    def floats(values):
        return (values[..., :3].astype(numpy.float64)
                * 2. ** (values[..., 3:].astype(int) - 136)).astype(numpy.float32)

    @staticmethod
    def hdr(size, data, form="32-bit_rle_rgbe"):
        return f"#?RADIANCE\n# a test\nFORMAT={form}\n\n{size}\n".encode() + data

    @staticmethod
    def values(rows, columns):
        values = RANDOM.integers(2, 256, (rows, columns, 4), dtype=numpy.uint8)
        values[..., 3] = RANDOM.integers(120, 140, (rows, columns))
        return values

    def test_flat(self):
        values = self.values(5, 7)
        self.check(self.hdr("-Y 5 +X 7", values.tobytes()), "flat.hdr", self.floats(values))

    def test_orders(self):
        shown = self.values(5, 7)
        expected = self.floats(shown)
        for size, orientation in (("-Y 5 +X 7", 1), ("-Y 5 -X 7", 2), ("+Y 5 -X 7", 3),
                                  ("+Y 5 +X 7", 4), ("+X 7 -Y 5", 5), ("-X 7 -Y 5", 6),
                                  ("-X 7 +Y 5", 7), ("+X 7 +Y 5", 8)):
            with self.subTest(size=size):
                data = stored_as(shown, orientation).tobytes()
                self.check(self.hdr(size, data), "order.hdr", expected)

    def test_runs(self):
        values = self.values(4, 20)
        values[:, 5:15] = values[:, 5:6]
        data = b""
        for row in values:
            data += b"\2\2\0\x14"
            for c in range(4):
                data += (b"\5" + row[:5, c].tobytes() + bytes([128 + 10, row[5, c]])
                         + b"\5" + row[15:, c].tobytes())
        self.check(self.hdr("-Y 4 +X 20", data), "runs.hdr", self.floats(values))

    def test_old_runs(self):
        values = self.values(1, 6)
        values[0, 2:] = values[0, 1]
        data = values[0, :2].tobytes() + b"\1\1\1\4"
        self.check(self.hdr("-Y 1 +X 6", data), "old.hdr", self.floats(values))

    def test_xyz(self):
        values = numpy.array([[[128, 128, 128, 129]]], numpy.uint8)
        got = self.read(self.hdr("-Y 1 +X 1", values.tobytes(), "32-bit_rle_xyze"), "xyz.hdr")
        numpy.testing.assert_allclose(got[0, 0], (1, 1, 1), atol=2e-3)

    def test_damage(self):
        values = self.values(5, 20)
        for content, says in ((self.hdr("-Y 5 +X 20", values.tobytes()[:-7]), "ends too early"),
                              (self.hdr("-Y 5 +X 20", b"\2\2\0\x14\xff\1\2" + b"\0" * 20), "run"),
                              (self.hdr("-Y 0 +X 20", b""), "20 x 0"),
                              (self.hdr("-Y 99999 +X 99999", b""), "at most 256 Mi"),
                              (self.hdr("wide", b""), "size"),
                              (self.hdr("-Y 5 +X 20", b"", "text"), "format")):
            with self.assertRaises(ValueError) as caught:
                self.read(content, "damaged.hdr")
            self.assertIn(says, str(caught.exception))


class Colors(Files):
    """The image passed to a vtkTexture."""

    def test_sixteen_bits(self):
        values = numpy.array([[0, 65535, 32768, 257, 100]], numpy.uint16)
        rows = [row.astype(">u2").tobytes() for row in values]
        got = self.read(png(5, 1, 16, 0, rows), "deep.png", True)
        numpy.testing.assert_array_equal(got, [[0, 255, 128, 1, 0]])
        self.assertEqual(got.dtype, numpy.uint8)

    def test_light(self):
        values = numpy.array([[0, 0.001, 0.2158605, 1, 7]], numpy.float32)
        got = self.read(tiff(values), "light.tif", True)
        numpy.testing.assert_array_equal(got, [[0, 3, 128, 255, 255]])  # IEC 61966-2-1


class NoFiles(Files):
    def test_what_is_no_file(self):
        os.mkfifo(self.folder / "pipe.png")
        for path, says in ((self.folder / "pipe.png", "a pipe"),
                           (pathlib.Path("/dev/zero"), "a device"),
                           (self.folder, "a folder"), (self.folder / "none.png", "no such file")):
            reader = vtkRelievoImageReader()
            reader.SetFileName(str(path))
            with Watch(reader) as watch:
                reader.Update()
            with self.assertRaises(ValueError) as caught:
                watch.raise_as(ValueError, "read")
            self.assertIn(says, str(caught.exception))


READ_TWICE = """
import sys
from relievo.vtkRelievoIO import vtkRelievoImageReader
for _ in range(2):
    reader = vtkRelievoImageReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (7, 5, 1)
"""


class WithoutProcess(Files):
    """relievo-reader is missing beside a copy of the library that starts it, or not executable."""

    def test_it_warns_once(self):
        lines = pathlib.Path("/proc/self/maps").read_text().splitlines()
        libraries = {line[line.index("/"):] for line in lines if ".so" in line and "/" in line}
        (library,) = [each for each in libraries if "/libvtkRelievoIO" in each]
        preloaded = shutil.copy(library, self.folder)
        folders = ":".join(sorted({os.path.dirname(each) for each in libraries}))
        environment = {**os.environ, "LD_LIBRARY_PATH": folders, "LD_PRELOAD":
                       f"{os.environ.get('LD_PRELOAD', '')}:{preloaded}"}  # fmt: skip
        image = self.path_of(self.written(Image.fromarray(texels()), "png"), "a.png")
        program = self.folder / "relievo" / "relievo-reader"
        for words, reason in (({}, "No such file"), ({}, "Permission denied"),
                              ({"RELIEVO_READ_HERE": "1"}, "")):  # fmt: skip
            with self.subTest(words=words, reason=reason):
                done = subprocess.run([sys.executable, "-c", READ_TWICE, image], check=True,
                                      stderr=subprocess.PIPE, text=True,
                                      env={**environment, **words})  # fmt: skip
                self.assertEqual(done.stderr.count(f"{program} cannot be started: {reason}"),
                                 1 if reason else 0, done.stderr)  # fmt: skip
                self.assertEqual(done.stderr.count("RELIEVO_READ_HERE=1"), 1 if reason else 0)
            program.parent.mkdir(exist_ok=True)
            program.write_text("")


if __name__ == "__main__":
    unittest.main(verbosity=2)
