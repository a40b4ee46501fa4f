# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each file of an installation belongs to the component that its package is made of."""

import os
import pathlib
import re
import subprocess
import unittest

BUILD = os.environ["RELIEVO_BUILD"]
PARAVIEW = os.environ["PARAVIEW"] == "1"
VIEWER = os.environ["VIEWER"] == "1"
PYTHON = os.environ["PYTHON_PACKAGE"]  # where it is installed, or empty
OUTPUT = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])

# The allowed and the required content of a component.
LIBRARY = r"lib(/[^/]+)*/libvtkRelievo\w+\.so"
MAY = {
    "runtime": rf"{LIBRARY}\.\d.*|lib(/[^/]+)*/relievo/relievo-reader|share/doc/.*/LICENSE",
    "command": r"bin/relievo|share/man/man1/relievo\.1|share/bash-completion/completions/relievo",
    "viewer": r"bin/relievo-viewer|share/man/man1/relievo-viewer\.1"
    r"|share/(applications|icons/hicolor/scalable/apps)/relievo-viewer\.(desktop|svg)"
    r"|share/bash-completion/completions/relievo-viewer",
    "development": rf"{LIBRARY}|include/relievo/.*|lib/.*/?(cmake/relievo|relievo/hierarchy)/.*"
    r"|lib(/[^/]+)*/libvtkRelievo\w+CS\.a",
    "python": rf"{re.escape(PYTHON)}/"
    r"((relievo(/_[a-z]+)?|vtk_relievo-[\d.]+\.dist-info)/[^/]+|relievo/vtk/.*\.pyi"
    r"|pytest_relievo\.py)",
    "plugin": r"lib/.*plugins/(Relievo/Relievo\.so|relievo\.plugins\.xml)",
}
MUST = {
    "runtime": ["libvtkRelievoPasses.so.", "relievo/relievo-reader"],
    "command": ["bin/relievo", "bash-completion/completions/relievo"],
    "viewer": ["bin/relievo-viewer", "relievo-viewer.desktop"],
    "development": ["libvtkRelievoPasses.so", "RelievoConfig.cmake",
                    "RelievoPictureTest.cmake", "RelievoRunPictureTest.cmake",
                    "vtkRelievoPass.h"],  # fmt: skip
    "python": ["relievo/__init__.py", "relievo/_wrapped.py", "relievo/vtkRelievoPasses",
               "relievo/__init__.pyi", "relievo/vtkRelievoPasses.pyi", "relievo/py.typed",
               "relievo/vtk/__init__.pyi", "relievo/vtk/vtkRenderingCore.pyi",
               "pytest_relievo.py", ".dist-info/entry_points.txt"],  # fmt: skip
    "plugin": ["Relievo/Relievo.so", "relievo.plugins.xml"],
}


def install(*words):
    """The files that this part of the installation has, below its prefix."""
    prefix = OUTPUT / (words[-1] if words else "all")
    subprocess.run(["rm", "-rf", str(prefix)], check=True)
    subprocess.run(
        ["cmake", "--install", BUILD, "--prefix", str(prefix), *words],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    return {str(path.relative_to(prefix)) for path in prefix.rglob("*") if not path.is_dir()}


class Components(unittest.TestCase):
    def test_each_file_is_where_it_belongs(self):
        absent = {"python": not PYTHON, "viewer": not VIEWER, "plugin": not PARAVIEW}
        names = [name for name in MAY if not absent.get(name)]
        left = install()
        for name in names:
            files = install("--component", name)
            with self.subTest(name):
                strangers = [file for file in files if not re.fullmatch(MAY[name], file)]
                self.assertEqual(strangers, [])
                for wanted in MUST[name]:
                    self.assertTrue(any(wanted in file for file in files), f"no {wanted}: {files}")
                self.assertLessEqual(files, left, "in two components, or in none of the whole")
                left -= files
        self.assertEqual(left, set(), "in no component")


if __name__ == "__main__":
    unittest.main()
