# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every model of Debian's assimp-testmodels that `relievo render` offers to read, by relievo.scene;
of each kind the first that is drawn and the first that is refused by the command, which makes the
same picture byte for byte or says the same words, and by the viewer, which shows it or refuses it.
testCliApart compares the command with vtkRelievoScene for all."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import relievo

DATA = pathlib.Path(os.environ["RELIEVO_DATA"]).resolve()  # as the viewer names files
KINDS = (".dae", ".fbx", ".x", ".ms3d", ".gltf", ".glb", ".iqm", ".bvh")


class Interfaces(unittest.TestCase):
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
        drawn, window, kinds = 0, None, set()
        for path in paths:
            refusal = ""
            scene = relievo.scene(path, size="96x96")
            scene.window = window  # that of the one before, which takes long to open
            try:
                scene.render(ours)
                window = scene.window
            except (OSError, RuntimeError, ValueError) as error:
                refusal = str(error)
            scene.window = None
            drawn += not refusal
            kind = path.suffix.lower(), bool(refusal)
            if kind in kinds:
                continue
            kinds.add(kind)
            with self.subTest(path=str(path.relative_to(DATA))):
                done = self.run_on("RELIEVO", "render", path, "--size", "96x96", "--png", theirs)
                self.assertEqual(done.returncode, 1 if refusal else 0, done.stderr)
                if refusal:
                    self.assertEqual(done.stderr, f"relievo: {refusal}\n")
                else:
                    self.assertEqual(ours.read_bytes(), theirs.read_bytes())
                if "VIEWER" in os.environ:
                    shown = self.run_on("VIEWER", path, "--once")
                    self.assertEqual(shown.returncode, done.returncode, shown.stderr)
                    self.assertIn(refusal, shown.stderr)
        self.assertGreaterEqual(drawn, 75)
        self.assertGreaterEqual(len(kinds), len(KINDS))


if __name__ == "__main__":
    unittest.main()
