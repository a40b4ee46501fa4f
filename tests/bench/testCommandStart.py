# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""bench/command_start.py with commands that only write a file: what it prints, and refuses."""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "bench" / "command_start.py"


class Start(unittest.TestCase):
    def run_with(self, *pictures):
        with tempfile.TemporaryDirectory() as folder:
            commands = []
            for i, picture in enumerate(pictures):
                command = pathlib.Path(folder, f"command{i}")
                command.write_text(f'#!/bin/sh\nfor last; do :; done\nprintf {picture} >"$last"\n')
                command.chmod(0o755)
                commands.append(str(command))
            return subprocess.run(
                [sys.executable, SCRIPT, commands[0], folder, "--rounds", "3", "--looks", "none",
                 *(["--against", commands[1]] if len(commands) > 1 else [])],
                capture_output=True, text=True, check=False)  # fmt: skip

    def test_prints_each_program(self):
        done = self.run_with("same", "same")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = list(csv.DictReader(done.stdout.splitlines()))
        self.assertEqual([row["program"] for row in rows if row["program"] != "F3D"],
                         ["relievo, none", "relievo, the other build, none"])  # fmt: skip
        self.assertEqual(float(rows[0]["ratio"]), 1)
        self.assertGreater(float(rows[1]["milliseconds"]), 0)

    def test_refuses_builds_that_differ(self):
        done = self.run_with("one", "other")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("the builds draw --preset none differently", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
