# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every model of Debian's assimp-testmodels that `relievo render` offers to read: the command and
relievo.scene make the same picture byte for byte, or refuse it in the same words; the viewer shows
those that they draw and refuses the others."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import relievo

DATA = pathlib.Path(os.environ["RELIEVO_DATA"]).resolve()  # as the viewer names files
KINDS = (".dae", ".fbx", ".x", ".ms3d", ".gltf", ".glb", ".iqm", ".bvh")
VIEWED = 8  # one of so many of what is drawn: a window takes a second to open


class Doors(unittest.TestCase):
    def run_on(self, program, *words):
        return subprocess.run([os.environ[program], *map(str, words)], capture_output=True,
                              text=True, timeout=300, check=False)  # fmt: skip

    def test_all(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        ours, theirs = (pathlib.Path(kept.name) / name for name in ("scene.png", "command.png"))
        paths = sorted(path for folder in ("formats", "gltf", "models/IQM", "models/BVH")
                       for path in (DATA / folder).rglob("*")
                       if path.suffix.lower() in KINDS)  # fmt: skip
        self.assertGreaterEqual(len(paths), 95)
        drawn = 0
        for path in paths:
            done = self.run_on("RELIEVO", "render", path, "--size", "96x96", "--png", theirs)
            self.assertIn(done.returncode, (0, 1))
            refusal = ""
            try:
                relievo.scene(path, size="96x96").render(ours)
            except (OSError, RuntimeError, ValueError) as error:
                refusal = str(error)
            with self.subTest(path=str(path.relative_to(DATA))):
                self.assertEqual(done.returncode, 1 if refusal else 0, done.stderr)
                drawn += not refusal
                if refusal:
                    self.assertEqual(done.stderr, f"relievo: {refusal}\n")
                else:
                    self.assertEqual(ours.read_bytes(), theirs.read_bytes())
                if "VIEWER" in os.environ and (refusal or drawn % VIEWED == 0):
                    shown = self.run_on("VIEWER", path, "--once")
                    self.assertEqual(shown.returncode, done.returncode, shown.stderr)
                    if refusal:
                        self.assertIn(refusal, shown.stderr)
        self.assertGreaterEqual(drawn, 75)


if __name__ == "__main__":
    unittest.main()
