# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""tools/bench-bundle packs a program that measures without a display, with its own libraries."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
TOOL = ROOT / "tools" / "bench-bundle"


def run(words, **variables):
    environment = {**os.environ, **variables}
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        environment.pop(name, None)
    return subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          env=environment, check=False)  # fmt: skip


class Bundle(unittest.TestCase):
    def test_it_measures(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        folder = pathlib.Path(kept.name)
        data = folder / "data"
        data.mkdir()
        for name in re.search(r"meshes=\(([^)]*)\)", TOOL.read_text()).group(1).split():
            mesh = pathlib.Path(os.environ["RELIEVO_DATA"]) / name
            if mesh.exists():
                (data / name).symlink_to(mesh)
            else:  # not needed by tests or the bench below
                (data / name).write_text("none")
        bundle = folder / "bundle"
        done = run([TOOL, "--build", os.environ["BUILD"], bundle], RELIEVO_DATA=str(data))
        self.assertEqual(done.returncode, 0, done.stderr)

        libraries = run(["ldd", bundle / "bin/relievo"], LD_LIBRARY_PATH=str(bundle / "lib")).stdout
        own = re.findall(r"(libvtk\S+|libOpenEXR\S+|libembree\S+) => (\S+)", libraries)
        self.assertGreater(len(own), 20, libraries)
        for name, path in own:
            self.assertEqual(pathlib.Path(path).parent, bundle / "lib", name)

        results = folder / "results"
        done = run([bundle / "run", "--quick", results, "tone"])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for name in ("tone.csv", "summary.md", "renderer.txt"):
            self.assertTrue((results / name).stat().st_size > 0, name)


if __name__ == "__main__":
    unittest.main()
