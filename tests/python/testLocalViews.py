# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes drawn by the browser: Relievo lists their losses, against a stand-in of trame's
functions. tests/clients has trame itself."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TRAME = "trame_vtk/modules/vtk/serializers"
FILES = {
    "registry.py": "SERIALIZERS = {}\n",
    "initialize.py": """
from .registry import SERIALIZERS

def renderer_serializer(parent, renderer, name, context, depth):
    return {"id": name}

def initialize_serializers():
    SERIALIZERS["vtkOpenGLRenderer"] = renderer_serializer
    SERIALIZERS["vtkActor"] = None
""",
}
SCENE = """
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
def scene():
    renderer = vtkRenderer()
    renderer.AddActor(vtkActor())
    return renderer
def send(renderer):
    from trame_vtk.modules.vtk.serializers import initialize, registry
    initialize.initialize_serializers()
    sent = registry.SERIALIZERS["vtkOpenGLRenderer"](None, renderer, "1", None, 0)
    assert sent == {"id": "1"}, sent
"""


class LocalViews(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.folder = kept.name
        folder = pathlib.Path(kept.name, TRAME)
        folder.mkdir(parents=True)
        for name, text in FILES.items():
            (folder / name).write_text(text)
        for each in (folder, *folder.parents[:3]):
            (each / "__init__.py").touch()

    def said(self, script):
        """The warnings of a script, which ends well."""
        done = subprocess.run(
            [sys.executable, "-W", "always", "-c", SCENE + script], capture_output=True, text=True,
            env={**os.environ, "PYTHONPATH": f"{self.folder}:{os.environ.get('PYTHONPATH', '')}"},
            timeout=300, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line for line in done.stderr.splitlines() if "RuntimeWarning" in line]

    def test_a_frame(self):
        """Reported once per process, with a remedy."""
        found = self.said("""
import relievo
first, second = scene(), scene()
send(first)
relievo.stage(first, "shadows")
relievo.attach(second)
send(first); send(second); send(first)
""")
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], "the browser draws this scene.*without Relievo's.*VtkRemoteView")

    def test_within_another_pass(self):
        found = self.said("""
import relievo
from vtkmodules.vtkRenderingOpenGL2 import vtkSSAAPass
renderer, outer = scene(), vtkSSAAPass()
outer.SetDelegatePass(relievo.attach(renderer))
renderer.SetPass(outer)
send(renderer)
""")
        self.assertEqual(len(found), 1, found)

    def test_imported_later(self):
        """Also if trame was there first."""
        found = self.said("""
renderer = scene()
send(renderer)
import relievo
relievo.attach(renderer)
from trame_vtk.modules.vtk.serializers import registry
registry.SERIALIZERS["vtkOpenGLRenderer"](None, renderer, "1", None, 0)
send(renderer)
""")
        self.assertEqual(len(found), 1, found)

    def test_materials_and_actors(self):
        for change in (
            "material = relievo.vtkRelievoMaterial(); material.Attach(actor)",
            "renderer.AddViewProp(relievo.vtkRelievoSkybox())",
            "renderer.AddViewProp(relievo.vtkRelievoSkinnedActor())",
        ):
            found = self.said(f"""
import relievo
renderer = scene()
actor = renderer.GetActors().GetLastActor()
{change}
send(renderer)
""")
            self.assertEqual(len(found), 1, change)

    def test_nothing_is_lost(self):
        self.assertEqual(self.said("""
import relievo
renderer = scene()
relievo.attach(renderer)
relievo.detach(renderer)
send(renderer)
"""), [])  # fmt: skip


if __name__ == "__main__":
    unittest.main(verbosity=2)
