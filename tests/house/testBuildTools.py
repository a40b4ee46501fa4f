# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tools that make and fetch packages refuse wrong calls, and touch nothing of others."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]


class BuildTools(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        # Package managers that only note that they were called.
        (self.folder / "bin").mkdir()
        for name in ("apt-get", "dpkg-deb", "pip"):
            stub = self.folder / "bin" / name
            stub.write_text(f'#!/bin/sh\necho "$@" >>"{self.folder}/called"\nexit 1\n')
            stub.chmod(0o755)

    def run_tool(self, name, *words):
        return subprocess.run(
            [ROOT / "tools" / name, *map(str, words)], text=True, capture_output=True, check=False,
            env={**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"})

    def test_unpack_refusals(self):
        """A folder that holds something else is left as it is."""
        mine = self.folder / "home" / "thesis.tex"
        mine.parent.mkdir()
        mine.write_text("chapter 1")
        other = self.folder / "other" / ".complete"  # of another program
        other.parent.mkdir()
        other.write_text("download 7\n")
        for words, says in (
            ((mine.parent,), "holds something else"),
            (("--wheel", mine.parent), "holds something else"),
            ((other.parent,), "holds something else"),
            ((mine,), "holds something else"), (("--fast",), "unknown option"),
            (("a", "b"), "usage"), (("--wheel", "a", "b"), "usage"),
        ):  # fmt: skip
            done = self.run_tool("unpack-vtk", *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(says, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertEqual(mine.read_text(), "chapter 1")
        self.assertEqual(other.read_text(), "download 7\n")
        self.assertFalse((self.folder / "called").exists())
        self.assertEqual(self.run_tool("unpack-vtk", "--help").returncode, 0)

    def test_package_refusals(self):
        """Neither packages nor a bare Debian are put where something else is."""
        home = self.folder / "home"
        (home / "letters").mkdir(parents=True)
        (home / "relievo_0.9_amd64.deb").write_text("old")
        (home / "letters" / "python3-relievo_0.9_amd64.deb").write_text("kept")
        debs = self.folder / "debs"
        debs.mkdir()
        for name in ("relievo", "libvtkrelievo-dev", "python3-relievo", "paraview-relievo"):
            (debs / f"{name}_1_amd64.deb").write_text("")
        root = self.folder / "root"
        (root / "etc").mkdir(parents=True)
        (root / "etc" / "debian_version").write_text("12\n")  # this machine's own is one, too
        there = sorted(self.folder.rglob("*"))
        for tool, words, says in (
            ("make-packages", (home,), "holds something else"),
            ("make-packages", (home / "relievo_0.9_amd64.deb",), "holds something else"),
            ("make-packages", ("--fast",), "unknown option"),
            ("make-packages", ("a", "b"), "usage"),
            ("try-packages", ("--root", root, debs), "holds something else"),
            ("try-packages", ("--root", home, debs), "holds something else"),
            ("try-packages", ("--fast",), "unknown option"),
            ("try-packages", (home,), "run tools/make-packages first"),
            ("wheel", ("--use",), "needs a word"),
            ("wheel", ("--use", self.folder / "none.whl"), "there is no"),
            ("wheel", ("--python", "/bin/true"), "CPython 3.11"),
        ):  # fmt: skip
            done = self.run_tool(tool, *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), (words, done.stderr))
            self.assertIn(says, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), there)
        for tool in ("make-packages", "try-packages"):
            self.assertIn("is refused", self.run_tool(tool, "--help").stdout)
        self.assertIn("CPython 3.11", self.run_tool("wheel", "--help").stdout)

    def test_packages_of_before(self):
        """Packages of a run before are replaced, in a tree whose programs make empty ones."""
        tree = self.folder / "tree"
        (tree / "tools").mkdir(parents=True)
        shutil.copy(ROOT / "tools" / "make-packages", tree / "tools")
        made = ("case $PWD in *-paraview) first=paraview- ;; esac\n"
                "mkdir packages\ntouch packages/${first}relievo_2_amd64.deb")
        for place, does in (("tree/tools/install-packages", ":"), ("tree/tools/unpack-vtk", ":"),
                            ("bin/cmake", ":"), ("bin/cpack", made)):  # fmt: skip
            stub = self.folder / place
            stub.write_text(f"#!/bin/sh\n{does}\n")
            stub.chmod(0o755)
        debs = self.folder / "debs"
        debs.mkdir()
        (debs / "relievo_1_amd64.deb").write_text("")
        for _ in range(2):
            done = self.run_tool(tree / "tools" / "make-packages", debs)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual({each.name for each in debs.iterdir()},
                             {"relievo_2_amd64.deb", "paraview-relievo_2_amd64.deb"})

    def test_unpack_failure(self):
        """Where nothing can be fetched, an older complete VTK stays, and nothing else is left."""
        old = self.folder / "vtk"
        old.mkdir()
        (old / ".complete").write_text("libvtk8-dev\n")
        done = self.run_tool("unpack-vtk", old)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("apt-get could not download", done.stderr)
        self.assertEqual((old / ".complete").read_text(), "libvtk8-dev\n")
        self.assertTrue((self.folder / "called").exists())
        self.assertEqual({each.name for each in self.folder.iterdir()}, {"bin", "called", "vtk"})

    def test_unreachable(self):
        """Where PyPI cannot be reached, that is a status of its own, and nothing is left."""
        if subprocess.run(["/usr/bin/python3", "-m", "pip", "--version"], capture_output=True,
                          check=False).returncode:  # fmt: skip
            self.skipTest("no pip")
        os.environ["PIP_NO_INDEX"] = "1"
        self.addCleanup(os.environ.pop, "PIP_NO_INDEX")
        done = self.run_tool("unpack-vtk", "--wheel", self.folder / "vtk")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("PyPI cannot be reached", done.stderr)
        self.assertEqual({each.name for each in self.folder.iterdir()}, {"bin"})
        done = self.run_tool("wheel")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("PyPI cannot be reached", done.stderr)

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
