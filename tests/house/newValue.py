# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new value of fog is a line and a column of its class and a row of its page: after that the
command, its help, the viewer's words, Python and ParaView have it. For testNewPass.py, which builds
the tree anyway."""

import os

VALUE = """  this->AddValue(
    "share", 1.0, 0.0, 1.0, "", "Fog of less than half a share is not drawn.");
"""
ROW = "| `share` | fog of less than half a share is not drawn | 1 |\n"


def add(tree):
    """The class: the columns of a row, and the value's effect; and its page."""
    fog = tree / "passes" / "effects" / "fog" / "vtkRelievoFogSpheres.h"
    text = fog.read_text(encoding="utf-8")
    assert text.count("    BLUE\n") == 1, text
    fog.write_text(text.replace("    BLUE\n", "    BLUE,\n    SHARE\n"), encoding="utf-8")
    fog = fog.with_suffix(".cxx")
    text = fog.read_text(encoding="utf-8")
    last = '  this->AddColorValue("color", white, "Linear colour of the fog.");\n'
    effect = "row[RADIUS] > 0.0 && row[DENSITY] > 0.0"
    assert text.count(last) == text.count(effect) == 1, text
    text = text.replace(last, last + VALUE).replace(effect, effect + " && row[SHARE] >= 0.5")
    fog.write_text(text, encoding="utf-8")
    page = tree / "docs" / "passes" / "Fog.md"
    text = page.read_text(encoding="utf-8")
    lines = text.splitlines(keepends=True)
    last = [at for at, line in enumerate(lines) if line.startswith("| `color` |")]
    assert len(last) == 1, text
    lines.insert(last[0] + 1, ROW)
    page.write_text("".join(lines), encoding="utf-8")


def on_the_command_line(run, build, folder):
    """In the help, as a number and as the name of an array."""
    relievo = build / "bin" / "relievo"
    mesh = folder / "ground.off"
    mesh.write_text("OFF\n4 1 0\n-1 0 -9\n1 0 -9\n1 0 1\n-1 0 1\n4 0 1 2 3\n", encoding="utf-8")
    (folder / "fog.vtk").write_text(
        "# vtk DataFile Version 3.0\nfog\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
        "0 0 -1 0 0 -4\nPOINT_DATA 2\nSCALARS wanted float 1\nLOOKUP_TABLE default\n1 0\n",
        encoding="utf-8",
    )
    assert "share=N" in run([relievo, "--help"])
    words = [relievo, "render", mesh, "--color", "navy", "--size", "90x70", "--png"]
    points = f"{folder / 'fog.vtk'},density=1,radius=1"
    pictures = set()
    for share in ("1", "wanted"):
        run([*words, folder / "fog.png", "--fog", f"{points},share={share}"])
        pictures.add((folder / "fog.png").read_bytes())
    assert len(pictures) == 2
    none = run([*words, folder / "fog.png", "--fog", f"{points},share=0.2"], status=1)
    assert "holds no points that are fog" in none, none
    said = run([*words, folder / "fog.png", "--fog", f"{points},share=2"], status=2)
    assert "--fog share" in said and "from 0 to 1" in said, said


PYTHON = """
import inspect
import sys

import relievo
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkRenderingCore import vtkRenderer

folder = sys.argv[1]
assert "share" in inspect.signature(relievo.fog).parameters
assert "half a share" in relievo.fog.__doc__
reader = vtkPolyDataReader()
reader.SetFileName(folder + "/fog.vtk")
renderer = vtkRenderer()
assert relievo.fog(renderer, reader, share="wanted").GetNumberOfPoints() == 1
assert relievo.fog(renderer, reader, share=0.5).GetNumberOfPoints() == 2
try:
    relievo.fog(renderer, reader, share=-1)
    raise SystemExit("a share of -1 was taken")
except ValueError as error:
    assert "from 0 to 1" in str(error), error

# The viewer's Python program uses these words.
relievo.scene(
    folder + "/ground.off", size="90x70", fog=[folder + "/fog.vtk,density=1,radius=1,share=wanted"]
).render(folder + "/scene.png")
assert open(folder + "/scene.png", "rb").read() == open(folder + "/fog.png", "rb").read()
"""


def in_python(run, build, python, folder):
    """A keyword of relievo.fog and of its docstring, and words of relievo.scene."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([build / "bin" / "relievo", "render", folder / "ground.off", "--size", "90x70", "--png",
         folder / "fog.png", "--fog", f"{folder / 'fog.vtk'},density=1,radius=1,share=wanted"])
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})


PARAVIEW = """
import sys

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=simple.__dict__)
view = simple.CreateView("RenderView")
view.ViewSize = [200, 150]
shown = simple.Show(simple.Plane(), view)
assert (shown.RelievoFogShare, shown.RelievoFogShareArray) == (1.0, "share")
pictures = []
for on, share in ((0, 1), (1, 1), (1, 0.2)):
    shown.RelievoFog, shown.RelievoFogShare, shown.RelievoFogDensity = on, share, 3
    simple.Render(view)
    pixels = view.SMProxy.CaptureWindow(1).GetPointData().GetScalars()
    pictures.append(bytes(memoryview(pixels)))
assert pictures[0] == pictures[2] != pictures[1]
"""


def in_paraview(run, build, folder):
    """Properties of each surface: the value and its array."""
    script = folder / "value.py"
    script.write_text(PARAVIEW, encoding="utf-8")
    output = run(["pvpython", script, build / "plugin" / "Relievo" / "Relievo.so"])
    assert "ERR|" not in output, output
