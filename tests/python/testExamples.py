# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every numbered example runs and writes what it says."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

import relievo

EXAMPLES = pathlib.Path(os.environ["RELIEVO_EXAMPLES"])

# file name: the files that the example writes
WRITES = {
    "01_capture_depth.py": [],
    "02_write_exr.py": ["layers.exr"],
    "03_debug_views.py": [
        "view_Elevation.png", "view_actor.png", "view_albedo.png", "view_cell.png",
        "view_depth.png", "view_depth_4_to_9.png", "view_geometric_normal.png",
        "view_linear_depth.png", "view_normal.png",
    ],
    "04_point_cloud.py": ["points.vtp"],
    "05_frame_report.py": [],
}  # fmt: skip


class Examples(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def run_example(self, name):
        done = subprocess.run(
            [sys.executable, EXAMPLES / name, self.folder / "out"],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100,
        )  # fmt: skip
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_all_are_known(self):
        self.assertEqual(sorted(WRITES), sorted(path.name for path in EXAMPLES.glob("[0-9]*.py")))

    def test_they_run(self):
        for name, files in WRITES.items():
            with self.subTest(example=name):
                said = self.run_example(name)
                for file in files:
                    self.assertGreater((self.folder / "out" / file).stat().st_size, 100, file)
                    self.assertIn(file, said)
                for path in (self.folder / "out").glob("*"):
                    self.assertIn(path.name, files)
                    path.unlink()
                for path in self.folder.glob("*"):
                    self.assertEqual(path.name, "out")

    def test_values(self):
        # A sphere of radius 1/2 around the origin: the nearest depth is the camera's distance less
        # the radius, but for the flat triangles.
        said = self.run_example("01_capture_depth.py")
        nearest = float(said.split("nearest ")[1].split(",")[0])
        self.assertAlmostEqual(nearest, 3.2903743 - 0.5, delta=2e-3)
        self.assertIn("corner inf", said)

        self.run_example("02_write_exr.py")
        image = relievo.read_exr(self.folder / "out" / "layers.exr")
        floor = relievo.layer(image, "actor") == 0
        height = relievo.layer(image, "position")[..., 1]
        numpy.testing.assert_allclose(height[floor], 0, atol=5e-6)
        numpy.testing.assert_allclose(relievo.layer(image, "Elevation")[floor], 0, atol=5e-6)

        self.assertTrue(self.run_example("05_frame_report.py").strip().endswith("True"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
