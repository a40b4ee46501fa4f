# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""bench/f3d_frames.py without F3D: it reports that it is skipped; and its statistics."""

import pathlib
import subprocess
import sys
import unittest

import numpy

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "bench" / "f3d_frames.py"
sys.path.insert(0, str(SCRIPT.parent))
import f3d_frames  # noqa: E402


class Frames(unittest.TestCase):
    def test_without_f3d(self):
        done = subprocess.run([sys.executable, "-I", "-S", SCRIPT, "."], capture_output=True,
                              text=True, check=False)  # fmt: skip
        self.assertEqual((done.returncode, done.stdout), (3, ""), done.stderr)
        self.assertRegex(done.stderr, "^skipped: this Python has no f3d; `pip install relievo f3d`")

    def test_ratio(self):
        """Ratios per round, not of medians: a disturbance slows both programs of a round."""
        found = f3d_frames.ratio([2, 40, 6, 80, 10], [1, 20, 30, 40, 5])
        self.assertEqual(found[0], 2)
        self.assertGreater(found[1], 0)
        self.assertEqual(f3d_frames.ratio([6], [4]), (1.5, 0))

    def test_pictures_are_of_one_object(self):
        own = numpy.full((20, 30, 3), f3d_frames.BACKGROUND, numpy.uint8)
        own[5:15, 5:25] = 200
        same = own.copy()
        same[5:15, 5:25] = 90
        f3d_frames.same_object({"F3D": own, "Relievo": same})
        moved = numpy.roll(own, 1, axis=0)
        with self.assertRaisesRegex(SystemExit, "different objects: 81.8 %"):
            f3d_frames.same_object({"F3D": own, "Relievo": moved})


if __name__ == "__main__":
    unittest.main(verbosity=2)
