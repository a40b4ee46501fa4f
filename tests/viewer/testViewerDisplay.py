# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Displays that have no window or no OpenGL for the viewer: it says so in a line, with status 1."""

import os
import subprocess
import sys
import unittest

MESH = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


class Display(unittest.TestCase):
    def view(self, **variables):
        """Of an environment with these variables; None: without that one."""
        with open("triangle.off", "w", encoding="utf-8") as mesh:
            mesh.write(MESH)
        environment = {**os.environ, **variables}
        for name in [name for name, value in environment.items() if value is None]:
            del environment[name]
        return subprocess.run(
            [os.environ["VIEWER"], "triangle.off", "--once"],
            capture_output=True, text=True, env=environment, timeout=60, check=False)  # fmt: skip

    def test_a_window(self):
        done = self.view()
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_no_display(self):
        for variables in ({"DISPLAY": None, "WAYLAND_DISPLAY": None}, {"DISPLAY": ":77777"}):
            done = self.view(**variables)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertRegex(done.stderr, r"\Arelievo-viewer: no window can be opened: .*\n\Z")
            self.assertIn("relievo render", done.stderr)

    def test_no_opengl(self):
        without = {"QT_QPA_PLATFORM": "offscreen", "DISPLAY": None}
        for variables in (without, {"MESA_GL_VERSION_OVERRIDE": "2.1"}):
            done = self.view(**variables)
            self.assertEqual(done.returncode, 1, f"{variables}: {done.stderr}")
            self.assertIn("relievo-viewer: nothing can be drawn: ", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
