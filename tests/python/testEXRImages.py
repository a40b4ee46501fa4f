# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR files as maps and environments: windows, names and types of channels, tiles, parts. They
are written here by the format's description (OpenEXR, File Layout)."""

import pathlib
import struct
import tempfile
import unittest

import numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import relievo
from relievo._arguments.errors import Watch
from relievo.vtkRelievoIO import vtkRelievoImageReader

RANDOM = numpy.random.default_rng(12)
TYPES = {"uint32": 0, "float16": 1, "float32": 2}


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(data)) + data


def header(channels, data, display, tile=None, part=None, chunks=0, sampling=None):
    listed = b""
    for name in sorted(channels):
        step = (sampling or {}).get(name, 1)
        kind = TYPES[channels[name].dtype.name]
        listed += name.encode() + b"\0" + struct.pack("<IIII", kind, 0, step, step)
    content = attribute("channels", "chlist", listed + b"\0")
    content += attribute("compression", "compression", b"\0")
    content += attribute("dataWindow", "box2i", struct.pack("<4i", *data))
    content += attribute("displayWindow", "box2i", struct.pack("<4i", *display))
    content += attribute("lineOrder", "lineOrder", b"\0")
    content += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    content += attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    content += attribute("screenWindowWidth", "float", struct.pack("<f", 1))
    if tile:
        content += attribute("tiles", "tiledesc", struct.pack("<IIB", tile, tile, 0))
    if part is not None:
        content += attribute("name", "string", part.encode())
        content += attribute("type", "string", b"scanlineimage")
        content += attribute("chunkCount", "int", struct.pack("<i", chunks))
    return content + b"\0"


def row_of(channels, y, columns=slice(None)):
    return b"".join(numpy.ascontiguousarray(channels[name][y, columns]).tobytes()
                    for name in sorted(channels))


def chunks_of(channels, data, tile):
    rows, columns = next(iter(channels.values())).shape
    if not tile:
        for y in range(rows):
            content = row_of(channels, y)
            yield struct.pack("<iI", data[1] + y, len(content)) + content
        return
    for j, top in enumerate(range(0, rows, tile)):
        for i, left in enumerate(range(0, columns, tile)):
            content = b"".join(row_of(channels, y, slice(left, left + tile))
                               for y in range(top, min(rows, top + tile)))
            yield struct.pack("<iiiiI", i, j, 0, 0, len(content)) + content


def exr(channels, data=None, display=None, tile=None):
    """channels: arrays (rows, columns) by name, the top row first; windows as OpenEXR has them."""
    rows, columns = next(iter(channels.values())).shape
    data = data or (0, 0, columns - 1, rows - 1)
    display = display or data
    start = struct.pack("<II", 20000630, 2 | (0x200 if tile else 0))
    start += header(channels, data, display, tile)
    pieces = list(chunks_of(channels, data, tile))
    at = len(start) + 8 * len(pieces)
    table = b""
    for piece in pieces:
        table += struct.pack("<Q", at)
        at += len(piece)
    return start + table + b"".join(pieces)


def parts_exr(parts):
    """parts: channels by the parts' names."""
    start = struct.pack("<II", 20000630, 2 | 0x1000)
    pieces = []
    display = None
    for number, (name, channels) in enumerate(parts.items()):
        rows, columns = next(iter(channels.values())).shape
        window = (0, 0, columns - 1, rows - 1)
        display = display or window  # all parts have the same
        start += header(channels, window, display, part=name, chunks=rows)
        pieces.append([struct.pack("<i", number) + chunk
                       for chunk in chunks_of(channels, window, None)])
    start += b"\0"
    at = len(start) + 8 * sum(len(each) for each in pieces)
    table = b""
    for piece in [chunk for each in pieces for chunk in each]:
        table += struct.pack("<Q", at)
        at += len(piece)
    return start + table + b"".join(chunk for each in pieces for chunk in each)


def planes(names, rows=4, columns=8, kind=numpy.float32):
    return {name: (RANDOM.random((rows, columns)) * 9).astype(kind) for name in names}


class Exr(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, content, warns=None):
        path = self.folder / "image.exr"
        path.write_bytes(content)
        reader = vtkRelievoImageReader()
        reader.SetFileName(str(path))
        warned = []
        reader.AddObserver("WarningEvent", lambda *_: warned.append(1))
        with Watch(reader) as watch:
            reader.Update()
        watch.raise_as(ValueError, "read")
        self.assertEqual(len(warned), 1 if warns else 0)
        return relievo.from_image(reader.GetOutput())

    def check(self, content, expected, warns=None):
        got = self.read(content, warns)
        self.assertEqual(got.dtype, numpy.float32)
        numpy.testing.assert_array_equal(got, numpy.asarray(expected, numpy.float32))

    def test_names(self):
        nuke = ["red", "green", "blue", "alpha"]
        for names in ("RGB", "RGBA", "rgb", "rgba", nuke[:3], nuke):
            for prefix in ("", "diffuse.", "main.left."):
                with self.subTest(names=names, prefix=prefix):
                    channels = planes([prefix + name for name in names])
                    expected = numpy.dstack([channels[prefix + name] for name in names])
                    self.check(exr(channels), expected)

    def test_other_channels_do_not_disturb(self):
        channels = planes(["R", "G", "B", "Z", "id.R", "id.G", "id.B", "normal.X"])
        expected = numpy.dstack([channels[name] for name in "RGB"])
        self.check(exr(channels), expected)

    def test_grey(self):
        channels = planes(["Y"])
        self.check(exr(channels), channels["Y"])
        channels = planes(["Y", "A"])
        self.check(exr(channels), numpy.dstack([channels["Y"], channels["A"]]))
        channels = planes(["height.V"])
        self.check(exr(channels), channels["height.V"])

    def test_several_layers(self):
        channels = planes(["b.R", "b.G", "b.B", "a.r", "a.g", "a.b"])
        self.check(exr(channels), numpy.dstack([channels["a." + name] for name in "rgb"]),
                   warns=True)

    def test_types(self):
        halfs = planes("RGB", kind=numpy.float16)
        self.check(exr(halfs), numpy.dstack([halfs[name] for name in "RGB"]))
        whole = planes("RGB", kind=numpy.uint32)
        self.check(exr(whole), numpy.dstack([whole[name] for name in "RGB"]))
        mixed = {"R": whole["R"], "G": halfs["G"], "B": planes("B")["B"]}
        self.check(exr(mixed), numpy.dstack([mixed[name] for name in "RGB"]))

    def test_windows(self):
        channels = planes("RGB", 4, 8)
        shown = numpy.dstack([channels[name] for name in "RGB"])
        for data, display in (
                ((10, 20, 17, 23), (10, 20, 17, 23)),  # the same, elsewhere
                ((2, 1, 9, 4), (0, 0, 11, 5)),  # cropped
                ((-2, -1, 5, 2), (0, 0, 3, 1)),  # overscan
                ((-5, -7, 2, -4), (-6, -8, 5, -3)),  # negative origins
                ((-3, 2, 4, 5), (0, 0, 7, 3))):  # across a corner
            with self.subTest(data=data, display=display):
                rows, columns = display[3] - display[1] + 1, display[2] - display[0] + 1
                expected = numpy.zeros((rows, columns, 3), numpy.float32)
                for y in range(4):
                    for x in range(8):
                        row, column = y + data[1] - display[1], x + data[0] - display[0]
                        if 0 <= row < rows and 0 <= column < columns:
                            expected[row, column] = shown[y, x]
                self.check(exr(channels, data, display), expected)

    def test_tiles(self):
        for tile in (3, 16):
            channels = planes("RGB", 7, 10)
            expected = numpy.dstack([channels[name] for name in "RGB"])
            self.check(exr(channels, tile=tile), expected)

    def test_parts(self):
        parts = {"beauty": planes("RGB"), "depth": planes("Z", 3, 3)}
        expected = numpy.dstack([parts["beauty"][name] for name in "RGB"])
        self.check(parts_exr(parts), expected, warns=True)
        last = {"depth": planes("Z"), "ids": planes(["id.V"]), "beauty": parts["beauty"]}
        self.check(parts_exr(last), expected, warns=True)
        grey = {"height": planes(["height.V"]), "depth": planes("Z")}
        self.check(parts_exr(grey), grey["height"]["height.V"], warns=True)

    def test_no_colours(self):
        """One of the channels, with a word on it."""
        channels = planes("RG")
        got = self.read(exr(channels), warns=True)
        self.assertTrue(any((got == channels[name]).all() for name in "RG"))

    def test_refusals(self):
        chroma = {"Y": planes("Y")["Y"], "RY": planes(["RY"])["RY"],
                  "BY": planes(["BY"])["BY"]}
        whole = exr(planes("RGB"))
        cases = ((exr(chroma), "luminance and chroma"),
                 (exr(planes("RGB"), (0, 0, 7, 3), (20, 20, 27, 23)), "display window"),
                 (exr(planes("RGB"), (0, 0, 7, 3), (0, 0, 10 ** 6, 10 ** 6)), "at most 256 Mi"),
                 (whole[:-40], "image.exr"), (whole[:60], "image.exr"))
        for content, says in cases:
            with self.subTest(says=says):
                with self.assertRaises(ValueError) as caught:
                    self.read(content)
                self.assertIn(says, str(caught.exception))

    def test_environment(self):
        """A cropped one is placed where it is seen; the rest is dark."""
        bright = {name: numpy.full((4, 4), 2, numpy.float32) for name in "rgb"}
        path = self.folder / "sky.exr"
        path.write_bytes(exr(bright, (4, 0, 7, 3), (0, 0, 15, 7)))
        made = relievo.environment(vtkRenderer(), str(path))
        values = relievo.from_image(made.GetImage())
        self.assertEqual(values.shape, (8, 16, 3))
        self.assertEqual(values[:4, 4:8].min(), 2)
        self.assertEqual(values.sum(), 4 * 4 * 3 * 2)
        self.assertFalse(made.GetSRGB())


if __name__ == "__main__":
    unittest.main(verbosity=2)
