# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo, small: its files, their content, and its errors."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import relievo

DEMO = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]) / "demo.py"
FILES = ["demo.exr", "demo.png", "demo_layers.png", "demo_report.json"]


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return relievo.layer(reader.GetOutput(), reader.GetOutput().GetPointData().GetArrayName(0))


class Demo(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def demo(self, *words, status=0, **environment):
        done = subprocess.run(
            [sys.executable, DEMO, *words],
            cwd=self.folder, env={**os.environ, **environment},
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600,
        )  # fmt: skip
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_files(self):
        done = self.demo("pictures", "--size", "320x180")
        self.assertEqual(done.stderr, "")
        folder = self.folder / "pictures"
        self.assertEqual(sorted(path.name for path in folder.iterdir()), FILES)
        for name in FILES:
            self.assertIn(name, done.stdout)

        picture = read_png(folder / "demo.png")
        self.assertEqual(picture.shape, (180, 320, 3))
        self.assertLess((picture >= 254).all(axis=2).mean(), 0.02, "too bright")
        self.assertGreater(picture.std(), 25, "hardly anything in sight")

        image = relievo.read_exr(folder / "demo.exr")
        names = relievo.layer_names(image)
        self.assertEqual(len(names), 14)
        for name in names:
            self.assertEqual(relievo.layer(image, name).shape[:2], (180, 320), name)
        # The bunny's height is known where the bunny is, and nowhere else; the bike has many parts.
        actor, height = relievo.layer(image, "actor"), relievo.layer(image, "height")
        self.assertEqual(len(set(actor[numpy.isfinite(height)])), 1)
        self.assertGreater(numpy.isfinite(height).mean(), 0.05)
        part = relievo.layer(image, "part")
        self.assertGreater(len(numpy.unique(part[numpy.isfinite(part)])), 20)
        self.assertEqual(set(relievo.layer(image, "block").ravel()), {0, 1, 2, 3})
        # A part of the visible surfaces is lit by the key light, a part is in its shadow; the
        # picture shows that: the floor is darker there.
        lit, floor = relievo.layer(image, "shadow_0"), actor == 0
        self.assertGreater((lit == 1).mean(), 0.3)
        self.assertGreater((lit == 0).mean(), 0.03)
        dark = picture[floor & (lit == 0)].mean()
        self.assertLess(dark, 0.85 * picture[floor & (lit == 1)].mean())
        # Nothing lies below the studio's floor.
        self.assertGreater(relievo.layer(image, "position")[..., 1].min(), -1e-4)

        sheet = read_png(folder / "demo_layers.png")
        self.assertGreater(sheet.shape[0], 4 * 60)
        self.assertGreater(len(numpy.unique(sheet.reshape(-1, 3), axis=0)), 1000)

        report = json.loads((folder / "demo_report.json").read_text())
        ran = {stage["name"]: stage["ran"] for stage in report["stages"]}
        self.assertTrue(ran["gbuffer"] and ran["shadows"])
        self.assertEqual(report["size"], [320, 180])

    def test_errors(self):
        done = self.demo("pictures", status=1, RELIEVO_DATA=str(self.folder))
        self.assertIn(str(self.folder / "motorBike.obj"), done.stderr)
        self.assertIn("tools/unpack-data", done.stderr)
        self.assertIn("'7'", self.demo("--size", "7", status=2).stderr)
        self.assertIn("--sise", self.demo("--sise", status=2).stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
