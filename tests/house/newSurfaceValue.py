# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new value of materials is made in their class and has a row in their page: after that the
command, its help, Python, the viewer's panel and ParaView have it. For testNewPass.py, which builds
the tree anyway.

The value removes a share of the reflected light, so that 1 equals a weight of 0.
"""

import os

VALUE = """  list
    .AddNumber(
      "darkness", this->Internal->Darkness,
      [this](double share) {
        this->Internal->Darkness = share;
        this->Modified();
      },
      0.0, 1.0, "", "Share of the mirrored light that is swallowed.")
    .OnlyIf = "environment";
"""
EDITS = (
    ("  vtkRelievoParameterList Description;\n", "{0}  double Darkness = 0.0;\n"),
    ('  list.AddNumber(\n    "reflection_weight"', VALUE + "{0}"),
    ("this->Roughness, this->ReflectionWeight,",
     "this->Roughness, this->ReflectionWeight * (1.0 - in.Darkness),"),
)  # fmt: skip
ROW = "| `darkness` | share of the mirrored light that is swallowed, 0 to 1 | 0 |\n"


def replace(path, *edits):
    text = path.read_text(encoding="utf-8")
    for old, new in edits:
        assert text.count(old) == 1, (path, old)
        text = text.replace(old, new.replace("{0}", old))
    path.write_text(text, encoding="utf-8")


def add(tree):
    """Two files: the class, and its documentation."""
    replace(tree / "materials" / "vtkRelievoMaterial.cxx", *EDITS)
    replace(tree / "docs" / "materials.md", ("| `reflection_weight` |", ROW + "{0}"))


def on_the_command_line(run, build, folder):
    """In the help, and behind --material."""
    relievo = build / "bin" / "relievo"
    (folder / "tile.off").write_text(
        "OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n", encoding="utf-8")
    # A picture of all directions, grey and lighter to the right: TGA, 24 bits, no compression.
    head = bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 32, 0, 24, 0])
    row = bytes(4 * (i // 3) for i in range(3 * 64))
    (folder / "around.tga").write_bytes(head + 32 * row)
    assert "darkness=N" in run([relievo, "--help"])
    words = [relievo, "render", folder / "tile.off", "--size", "60x60", "--environment",
             folder / "around.tga", "--reflectivity", "1,0", "--png"]  # fmt: skip

    def draw(material):
        run([*words, folder / "dark.png", "--material", material])
        return (folder / "dark.png").read_bytes()

    run([*words, folder / "bright.png"])
    bright = (folder / "bright.png").read_bytes()
    assert draw("darkness=0") == bright
    assert draw("darkness=1") == draw("reflection_weight=0") != bright
    said = run([*words, folder / "dark.png", "--material", "darkness=2"], status=2)
    assert "--material darkness" in said and "from 0 to 1" in said, said


PYTHON = """
import inspect
import sys

import relievo
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

folder = sys.argv[1]
assert inspect.signature(relievo.environment).parameters["darkness"].default == 0
assert "swallowed" in relievo.environment.__doc__
actor, renderer = vtkActor(), vtkRenderer()
renderer.AddActor(actor)
relievo.environment(renderer, folder + "/around.tga", darkness=0.25)
assert relievo.vtkRelievoMaterial.Get(actor).GetParameter("darkness") == "0.25"
try:
    relievo.environment(renderer, folder + "/around.tga", darkness=-1)
    raise SystemExit("a darkness of -1 was taken")
except ValueError as error:
    assert "from 0 to 1" in str(error), error

# The viewer's Python program uses these words.
relievo.scene(
    folder + "/tile.off", size="60x60", environment=folder + "/around.tga", reflectivity="1,0",
    material="darkness=0.25",
).render(folder + "/scene.png")
assert open(folder + "/scene.png", "rb").read() not in [
    open(folder + "/" + name, "rb").read() for name in ("dark.png", "bright.png")
]
"""


def in_python(run, build, python, folder):
    """A keyword of relievo.environment and of its docstring, and words of relievo.scene."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})


def in_the_viewer(run, build, python):
    """The viewer's own test finds the value's row of its panel."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])
    viewer = build / "tests" / "bin" / "relievo_tests_viewer"
    run([viewer, "--case", "testViewerEvery", "surfaceValues"],
        env={**os.environ, "PYTHONPATH": path, "PYTHON": python,
             "RELIEVO": str(build / "bin" / "relievo")})  # fmt: skip


PARAVIEW = """
import sys

from paraview import simple

plugin, folder = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
view = simple.CreateView("RenderView")
view.ViewSize = [60, 60]
view.RelievoEnvironment = folder + "/around.tga"
shown = simple.Show(simple.Plane(), view)
assert shown.RelievoDarkness == 0.0
shown.RelievoMaterial = shown.RelievoMirror = shown.RelievoReflectivity = 1
pictures = []
for darkness, weight in ((0, 1), (1, 1), (0, 0)):
    shown.RelievoDarkness, shown.RelievoReflectionWeight = darkness, weight
    simple.Render(view)
    pixels = view.SMProxy.CaptureWindow(1).GetPointData().GetScalars()
    pictures.append(bytes(memoryview(pixels)))
assert pictures[0] != pictures[1] == pictures[2]
"""


def in_paraview(run, build, folder):
    """A property of each surface."""
    script = folder / "surfaceValue.py"
    script.write_text(PARAVIEW, encoding="utf-8")
    output = run(["pvpython", script, build / "plugin" / "Relievo" / "Relievo.so", folder])
    assert "ERR|" not in output, output
