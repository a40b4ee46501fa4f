# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""tools/compare-frames finds each kind of difference of two builds, and refuses wrong words."""

import json
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

ROOT = pathlib.Path(__file__).parents[2]
# Writes its data beside itself under the names of --png and so on; {build} is its folder.
STUB = """#!/bin/sh
while [ $# -gt 0 ]; do
  case "$1" in
    --png) cp "{build}/picture.png" "$2" ;;
    --exr) cp "{build}/frame.exr" "$2" ;;
    --report) cp "{build}/report.json" "$2" ;;
  esac
  shift
done
. "{build}/says"
"""


def png(colors, level):
    """Rows of RGB bytes; `level` is zlib's."""

    def chunk(kind, data):
        kind += data
        return struct.pack(">I", len(kind) - 4) + kind + struct.pack(">I", zlib.crc32(kind))

    rows = b"".join(b"\0" + bytes(row) for row in colors)
    size = struct.pack(">IIBBBBB", len(colors[0]) // 3, len(colors), 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(
        b"IDAT", zlib.compress(rows, level)) + chunk(b"IEND", b"")  # fmt: skip


def exr(values, level, near=1.5):
    """One channel of 4-byte floats, two in a row, in a block of up to 16 rows."""
    box = struct.pack("<4i", 0, 0, 1, len(values) - 1)
    channels = b"depth.Z\0" + struct.pack("<iB3xii", 2, 0, 1, 1) + b"\0"
    header = b"\x76\x2f\x31\x01" + struct.pack("<I", 2)
    for name, kind, held in (
        (b"channels", b"chlist", channels), (b"compression", b"compression", b"\3"),
        (b"dataWindow", b"box2i", box), (b"near", b"float", struct.pack("<f", near)),
    ):  # fmt: skip
        header += name + b"\0" + kind + b"\0" + struct.pack("<i", len(held)) + held
    block = pack(b"".join(struct.pack("<2f", *row) for row in values), level)
    place = struct.pack("<Q", len(header) + 1 + 8)
    return header + b"\0" + place + struct.pack("<ii", 0, len(block)) + block


def pack(data, level):
    """Zipped like OpenEXR's: even and odd bytes apart, and their steps; bare if that is less."""
    parted = data[::2] + data[1::2]
    steps = [parted[0], *((b - a + 128) & 255 for a, b in zip(parted, parted[1:]))]
    packed = zlib.compress(bytes(steps), level)
    return packed if len(packed) < len(data) else data


PIXELS = [[10, 20, 30, 40, 50, 60], [70, 80, 90, 100, 110, 120]]
DEPTHS = [[1.0, 2.0]] * 12
REPORT = {"size": [2, 2], "gpu_ms": 1.5, "shadow_plan": "map, 3 ms",
    "stages": [{"name": "fog", "ran": True, "gpu_ms": 0.5}]}  # fmt: skip
SAYS = "echo drawn in 12.5 ms; echo {build}: a note >&2"


class CompareFrames(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        (self.folder / "data").mkdir()
        for side in ("old", "new"):
            self.build(side)

    def build(self, side, pixels=PIXELS, depths=DEPTHS, near=1.5, report=REPORT, says=SAYS):
        """A build whose `relievo` writes these."""
        here = self.folder / side
        (here / "bin").mkdir(parents=True, exist_ok=True)
        program = here / "bin" / "relievo"
        program.write_text(STUB.format(build=here))
        program.chmod(0o755)
        level = 9 if side == "old" else 0  # files need not be equal, where their values are
        (here / "picture.png").write_bytes(png(pixels, level))
        (here / "frame.exr").write_bytes(exr(depths, level, near))
        (here / "report.json").write_text(json.dumps(report, indent=1 if side == "old" else None))
        (here / "says").write_text(says.format(build=here))

    def compare(self, *words):
        return subprocess.run(
            [ROOT / "tools" / "compare-frames", *map(str, words)], text=True, check=False,
            capture_output=True, timeout=120,
            env={**os.environ, "RELIEVO_DATA": str(self.folder / "data"),
                "TMPDIR": str(self.folder)})  # fmt: skip

    def differ(self, *says):
        """One scene differs, in lines that begin with these."""
        done = self.compare(self.folder / "old", self.folder / "new", "--only", "^render/fog-beer$")
        *lines, last = done.stdout.splitlines()
        self.assertEqual((done.returncode, done.stderr), (1, ""), done.stdout)
        self.assertEqual(len(lines), len(says), done.stdout)
        for line, text in zip(lines, says):
            self.assertTrue(line.startswith(f"render/fog-beer: {text}"), line)
        kept = pathlib.Path(last.split("see ")[1])
        for side in ("old", "new"):
            self.assertTrue((kept / side / "render/fog-beer/picture.png").exists(), last)

    def test_identical(self):
        """Values that vary, and other packing, are no difference; nothing stays."""
        self.build("new", report={**REPORT, "gpu_ms": 7.5, "shadow_plan": "map, 9.5 ms"},
                   says=SAYS.replace("12.5", "9"))  # fmt: skip
        words = (self.folder / "old", self.folder / "new", "--only", "^render/(fog|hdr)")
        done = self.compare(*words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertEqual(done.stdout, "4 scenes: identical\n")
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"data", "new", "old"})
        kept = self.folder / "kept"
        self.assertEqual(self.compare(*words, "--keep", kept).returncode, 0)
        self.assertTrue((kept / "new/render/hdr/frame.exr").exists())
        again = self.compare(*words, "--keep", kept)
        self.assertEqual((again.returncode, again.stdout), (2, ""))

    def test_pictures(self):
        self.build("new", pixels=[PIXELS[0], [70, 80, 90, 100, 110, 123]])
        self.differ("picture.png: 1 of 4 pixels differ, at most by 3 of 255 levels")

    def test_layers(self):
        """A channel and an attribute."""
        self.build("new", depths=DEPTHS[:-1] + [[1.0, 2.25]], near=2.5)
        self.differ(
            "frame.exr: attribute near: float 1.5 became float 2.5",
            "frame.exr: channel depth.Z: 1 of 24 values differ, at most by 0.25",
        )

    def test_reports(self):
        self.build("new", report={**REPORT, "stages": [{"name": "fog", "ran": False}]})
        self.differ("report.json: stages.fog.ran: True became False")

    def test_messages(self):
        self.build("new", says=SAYS.replace("a note", "another"))
        self.differ("messages.txt: line 4: 'BUILD: a note' became 'BUILD: another'")

    def test_failures(self):
        """A scene that fails is none that was compared, though it fails with both."""
        for side in ("old", "new"):
            self.build(side, says="echo no display >&2; exit 1")
        self.differ("old: 'render ", "new: 'render ")
        self.build("old")
        (self.folder / "old/bin/relievo").write_text("#!/bin/sh\necho >a.png\n")
        self.build("new", says="")
        done = self.compare(self.folder / "old", self.folder / "new", "--only", "^render/hdr$")
        self.assertIn("a.png: only the old build writes it", done.stdout)
        self.assertIn("picture.png: only the new build writes it", done.stdout)

    def test_refusals(self):
        old, new = self.folder / "old", self.folder / "new"
        for words, says in (
            ((), "give two folders"), ((old,), "give two folders"), ((old, new, new), "give two"),
            ((old, new, "--list"), "give two"), ((old, new, "--fast"), "unrecognized"),
            ((old, self.folder / "data", "--only", "hdr"), "lacks bin/relievo"),
            ((old, new, "--only", "viewer/"), "lacks bin/relievo-viewer"),
            ((old, new, "--only", "plain"), "run tools/unpack-data"),
            ((old, new, "--only", "no such scene"), "no scene"),
            ((old, new, "--only", "("), "no regular expression"),
            ((old, new, "--only", "hdr", "--keep", old), "no empty folder"),
        ):  # fmt: skip
            done = self.compare(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(says, done.stderr)
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"data", "new", "old"})

    def test_list(self):
        """At least forty scenes, through every front end."""
        names = self.compare("--list").stdout.split()
        self.assertGreaterEqual(len(names), 40)
        fronts = {name.split("/")[0] for name in names}
        self.assertEqual(fronts, {"render", "messages", "cave", "python", "viewer", "paraview"})
        for name in names:
            self.assertEqual(names.count(name), 1, name)


if __name__ == "__main__":
    unittest.main()
