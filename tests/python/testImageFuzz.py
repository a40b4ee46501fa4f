# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images with bytes changed, added or cut, the same in every run: each is read, or refused with one
message that names it, within the stated memory and a few seconds. They are read in the
script's own process: in another one, a decoder that crashes would be an error like others.

    IMAGES=2000 testImageFuzz.py        more of them
"""

import io
import os
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy
from PIL import Image

LACKS = os.environ.get("RELIEVO_VTK_LACKS", "").split()  # tests/wheel/CMakeLists.txt
COMPRESSIONS = ("tiff_lzw", "tiff_adobe_deflate", "packbits", "jpeg")
COUNT = int(os.environ.get("IMAGES", 400))
BATCH = 100
MEMORY = 4 << 30  # of a process: the greatest image and a copy of it
SECONDS = 20


def seeds():
    """Small whole images: kind, bytes."""
    rng = numpy.random.default_rng(3)
    color = rng.integers(0, 256, (24, 20, 4), dtype=numpy.uint8)
    color[:, :10] = color[:, :1]
    grey = Image.fromarray(color[..., 0])
    rgb = Image.fromarray(color[..., :3])
    made = []

    def add(image, kind, **options):
        out = io.BytesIO()
        image.save(out, kind, **options)
        made.append(({"jpeg": "jpg", "tiff": "tif"}.get(kind, kind), out.getvalue()))
    for image in (grey, rgb, Image.fromarray(color), rgb.quantize(16), grey.convert("1")):
        add(image, "png")
        if image.mode != "RGBA":
            add(image, "bmp")
        add(image, "tiff")
    add(Image.fromarray((color[..., 0].astype(numpy.uint16) * 257)), "png")
    for compression in [kind for kind in COMPRESSIONS if kind not in LACKS]:
        add(rgb, "tiff", compression=compression)
    add(grey.convert("1"), "tiff", compression="group4")
    add(rgb.convert("CMYK"), "tiff")
    add(rgb, "jpeg", quality=60)
    add(rgb, "jpeg", progressive=True)
    add(rgb.convert("CMYK"), "jpeg")
    for image in (grey, rgb, Image.fromarray(color)):
        add(image, "tga")
        add(image, "tga", rle=True)
    flat = color.copy()
    made.append(("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 24 +X 20\n" + flat.tobytes()))
    row = b"".join(b"\x8a\x05\x0a" + flat[0, :10, c].tobytes() for c in range(4))
    made.append(("hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 20\n"
                 + (b"\2\2\0\x14" + row) * 4))
    return made


def sums_of(content):
    """A PNG with the checksums that its chunks ought to have."""
    out, at = content[:8], 8
    while at + 12 <= len(content):
        length = struct.unpack_from(">I", content, at)[0]
        if at + 12 + length > len(content):
            break
        body = content[at + 4:at + 8 + length]
        out += content[at:at + 4] + body + struct.pack(">I", zlib.crc32(body))
        at += 12 + length
    return out + content[at:]


def mutant(rng, kind, content):
    content = bytearray(content)
    for _ in range(rng.choice((1, 1, 2, 4, 9))):
        at = rng.randrange(len(content)) if rng.random() < 0.5 else rng.randrange(
            min(64, len(content)))
        way = rng.randrange(7)
        if way == 0:
            content[at] ^= 1 << rng.randrange(8)
        elif way == 1:
            content[at] = rng.choice((0, 1, 0x7F, 0x80, 0xFF))
        elif way == 2:
            value = rng.choice((0, 1, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 65536, 30000))
            form = rng.choice(("<I", ">I", "<H", ">H"))
            content[at:at + struct.calcsize(form)] = struct.pack(
                form, value & (0xFFFF if form[1] == "H" else 0xFFFFFFFF))
        elif way == 3:
            del content[at:at + rng.randrange(1, 40)]
        elif way == 4:
            content[at:at] = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 20)))
        elif way == 5:
            del content[max(4, at):]
        else:
            content[at:at] = content[at:at + rng.randrange(1, 60)]
        if not content:
            content = bytearray(b"\0")
    return sums_of(bytes(content)) if kind == "png" and rng.random() < 0.8 else bytes(content)


def read_all(folder):
    """In a process of its own: a line before and after each."""
    from relievo._arguments.errors import Watch
    from relievo.vtkRelievoIO import vtkRelievoImageReader

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for path in sorted(pathlib.Path(folder).iterdir()):
        print(path.name, end=" ", flush=True)
        reader = vtkRelievoImageReader()
        reader.SetFileName(str(path))
        reader.SetColors(path.name.endswith("0"))
        with Watch(reader) as watch:
            reader.Update()
        image = reader.GetOutput()
        texels = image.GetNumberOfPoints()
        whole = texels > 0 and image.GetPointData().GetScalars().GetNumberOfTuples() == texels
        named = len(watch.errors) == 1 and str(path) in watch.errors[0]
        print("read" if whole and not watch.errors else "refused" if named and not texels
              else f"odd: {texels} texels, {watch.errors}", flush=True)


class Fuzz(unittest.TestCase):
    def run_batch(self, folder):
        here = {**os.environ, "RELIEVO_READ_HERE": "1"}
        done = subprocess.run([sys.executable, __file__, "--read", folder], capture_output=True,
                              env=here, text=True, timeout=SECONDS + BATCH)  # fmt: skip
        lines = done.stdout.splitlines()
        last = lines[-1] if lines else "nothing"
        self.assertEqual(done.returncode, 0, f"{last}: {done.stderr[-600:]}")
        self.assertEqual(done.stderr, "")
        return [line.split(" ", 1)[1] for line in lines]

    def test_whole_ones_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            for i, (kind, content) in enumerate(seeds()):
                (pathlib.Path(folder) / f"{i:03}.{kind}").write_bytes(content)
            self.assertEqual(set(self.run_batch(folder)), {"read"})

    def test_mutants(self):
        rng = random.Random(27)
        known = seeds()
        results = []
        for first in range(0, COUNT, BATCH):
            with tempfile.TemporaryDirectory() as folder:
                for i in range(first, min(COUNT, first + BATCH)):
                    kind, content = known[i % len(known)]
                    (pathlib.Path(folder) / f"{i:05}.{kind}").write_bytes(
                        mutant(rng, kind, content))
                results += self.run_batch(folder)
        odd = [result for result in results if result not in ("read", "refused")]
        self.assertEqual(odd, [])
        self.assertEqual(len(results), COUNT)
        self.assertGreater(results.count("refused"), COUNT / 4)
        self.assertGreater(results.count("read"), COUNT / 20)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--read"]:
        read_all(sys.argv[2])
    else:
        unittest.main(verbosity=2)
