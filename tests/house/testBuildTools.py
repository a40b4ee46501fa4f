# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""tools/build-vtk and tools/build-paraview ask CMake for what Relievo needs; they and
tools/bench-bundle refuse wrong calls."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
# What each demands of a source tree, and what it makes.
TREES = {
    "build-vtk": ["CMake/vtkVersion.cmake"],
    "build-paraview": ["CMake/paraview-config.cmake.in", "VTK/CMake/vtkVersion.cmake"],
}


class BuildTools(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        # A cmake that only notes its words.
        (self.folder / "bin").mkdir()
        stub = self.folder / "bin" / "cmake"
        stub.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@" >>"{self.folder}/words"\n'
                        '[ "$5" != -B ] || mkdir -p "$6"\n')
        stub.chmod(0o755)

    def run_tool(self, name, *words):
        return subprocess.run(
            [ROOT / "tools" / name, *map(str, words)], text=True, capture_output=True, check=False,
            env={**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"})

    def tree(self, name):
        source = self.folder / "source"
        for file in TREES[name]:
            (source / file).parent.mkdir(parents=True, exist_ok=True)
            (source / file).touch()
        return source

    def test_modules(self):
        """Each component that cmake/RelievoDependencies.cmake demands is built."""
        text = (ROOT / "cmake" / "RelievoDependencies.cmake").read_text()
        demanded = re.search(r"set\(relievo_vtk_components([^)]*)\)", text)[1].split()
        self.assertGreater(len(demanded), 20)
        for name in TREES:
            with self.subTest(name):
                done = self.run_tool(name, self.tree(name), self.folder / "dest", "-DMORE=1")
                self.assertEqual(done.returncode, 0, done.stderr)
                words = (self.folder / "words").read_text().splitlines()
                for component in demanded:
                    self.assertIn(f"-DVTK_MODULE_ENABLE_VTK_{component}=YES", words)
                wrong = [word for word in words if "ENABLE_VTK_" in word
                         and not re.fullmatch(r"-DVTK_MODULE_ENABLE_VTK_[A-Z]\w+=YES", word)]
                self.assertEqual(wrong, [])
                self.assertIn("-DMORE=1", words)
                self.assertIn("--build", words)
                self.assertIn("--install", words)
                (self.folder / "words").unlink()

    def test_windows(self):
        """EGL beside X only where VTK can have both."""
        for name, files in TREES.items():
            version = self.tree(name) / files[-1]
            for minor, egl in ((1, "OFF"), (3, "OFF"), (4, "ON"), (10, "ON")):
                version.write_text(f"set(VTK_MAJOR_VERSION 9)\nset(VTK_MINOR_VERSION {minor})\n")
                done = self.run_tool(name, self.folder / "source", self.folder / "dest")
                self.assertEqual(done.returncode, 0, done.stderr)
                words = (self.folder / "words").read_text().splitlines()
                self.assertIn(f"-DVTK_OPENGL_HAS_EGL={egl}", words, name)
                (self.folder / "words").unlink()

    def test_leaves_what_is_in_the_folder(self):
        """The folder may be a home or a repository, with a folder build of its own."""
        mine = self.folder / "dest" / "build" / "data"
        mine.mkdir(parents=True)
        for name in TREES:
            with self.subTest(name):
                done = self.run_tool(name, self.tree(name), self.folder / "dest")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(mine.is_dir())
                words = (self.folder / "words").read_text().splitlines()
                folder = pathlib.Path(words[words.index("-B") + 1])
                self.assertEqual(folder.parent, (self.folder / "dest").resolve())
                self.assertFalse(folder.exists())
                (self.folder / "words").unlink()

    def test_refusals(self):
        for name in TREES:
            with self.subTest(name):
                for words in ((), ("source",), ("--fast",), (self.folder, self.folder / "dest"),
                              (self.tree(name), self.folder / "dest", "fast")):  # fmt: skip
                    done = self.run_tool(name, *words)
                    self.assertEqual(done.returncode, 2, words)
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertFalse((self.folder / "words").exists())
                self.assertEqual(self.run_tool(name, "--help").returncode, 0)
        (self.folder / "source" / "VTK" / "CMake" / "vtkVersion.cmake").unlink()
        done = self.run_tool("build-paraview", self.folder / "source", self.folder / "dest")
        self.assertIn("submodule", done.stderr)

    def test_bundle_refusals(self):
        """Without a build that fits, nothing is left behind."""
        there = self.folder / "there"
        there.mkdir()
        old = self.folder / "old" / "bin" / "relievo"  # of a VTK that needs a display
        old.parent.mkdir(parents=True)
        old.write_text('#!/bin/sh\n[ "$1" = bench ] && echo planner && exit 2\necho VTK 9.2.1\n')
        old.chmod(0o755)
        bundle = self.folder / "bundle"
        for words, status, says in (
            ((), 2, "usage"), (("--fast",), 2, "unknown option"), ((bundle, bundle), 2, "usage"),
            ((there,), 2, "there already"), (("--build", there, bundle), 1, "build it first"),
            (("--build", old.parents[1], bundle), 1, "VTK 9.2, which needs a display"),
        ):
            done = self.run_tool("bench-bundle", *words)
            self.assertEqual((done.returncode, done.stdout), (status, ""), words)
            self.assertIn(says, done.stderr)
        self.assertEqual({each.name for each in self.folder.iterdir()}, {"bin", "old", "there"})


if __name__ == "__main__":
    unittest.main()
