# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new setting of a filter is made in its class, and a new option of a command in the command's
file; each has a row in its page. After that the command, its help, its completion, Python and
ParaView have them. For testNewPass.py, which builds the tree anyway.

The setting ignores the sun where it stands low, the option suppresses the command's output.
"""

import os

SETTING = """  list.AddNumber(
    "horizon", this->Horizon, [this](double degrees) { this->SetHorizon(degrees); }, 0.0, 80.0,
    "degrees", "Height below which the sun does not count.");
"""
METHODS = """  ///@{
  /** Height below which the sun does not count, 0 to 80 degrees. Default 0. */
  vtkSetClampMacro(Horizon, double, 0.0, 80.0);
  vtkGetMacro(Horizon, double);
  ///@}

"""
OPTION = """    this->AddFlag("--silent", "prints nothing", this->Silent);
"""


def replace(path, *edits):
    text = path.read_text(encoding="utf-8")
    for old, new in edits:
        assert text.count(old) == 1, (path, old)
        text = text.replace(old, new.replace("{0}", old))
    path.write_text(text, encoding="utf-8")


def add(tree):
    """The filter's class and the command's file, and their documentation."""
    filter_ = tree / "filters" / "sight" / "vtkRelievoSunExposure"
    replace(filter_.with_suffix(".h"),
            ("  double Latitude = 48.0;\n", "{0}  double Horizon = 0.0;\n"),
            ("  /** The error of a first and a last day:", METHODS + "{0}"))  # fmt: skip
    replace(filter_.with_suffix(".cxx"), ("  list.AddWhole(\n    \"sky_samples\"", SETTING + "{0}"),
            ("clock.GetParts(begin, end, least)",
             "clock.GetParts(begin, end, std::max(least,\n      "
             "std::sin(vtkMath::RadiansFromDegrees(this->Horizon))))"))
    replace(tree / "apps" / "relievo" / "commands" / "CaveCommand.cxx",
            ("  vtkNew<vtkRelievoCaves> Caves;\n", "{0}  bool Silent = false;\n"),
            ("    this->Caves->SetSize(", OPTION + "{0}"),
            ("    outputs.Commit();\n",
             "{0}    if (this->Silent)\n    {\n      return 0;\n    }\n"),
            )
    replace(tree / "docs" / "command-line.md",
            ("| `--sky N` |", "| `--horizon N` | the sun counts above it, degrees | 0 |\n{0}"))
    replace(tree / "docs" / "caves.md",
            ("| `MemoryLimit` |", "| | `--silent` | prints nothing | |\n{0}"))  # fmt: skip


def on_the_command_line(run, build, folder):
    """In the help, in the completion's words, and in the results."""
    relievo = build / "bin" / "relievo"
    page, words = run([relievo, "--help"]), run([relievo, "--words"])
    assert "\n  --horizon N " in page and "does not count, 0 to 80 degrees (0)" in page, page
    assert "\n  --silent  " in page and "\ncave --silent flag\n" in words, words
    assert "\nsun --horizon value\n" in words, words
    mesh = folder / "level.off"
    mesh.write_text("OFF\n4 1 0\n-1 0 -1\n-1 0 1\n1 0 1\n1 0 -1\n4 0 1 2 3\n", encoding="utf-8")
    sun = [relievo, "sun", mesh, "--place", "0,0", "--dates", "2026-03-20", "--up", "y", "-o",
           folder / "sun.vtp"]  # fmt: skip
    for horizon, hours in (("0", "12."), ("60", "4.")):  # by 15 degrees an hour, past the zenith
        said = run([*sun, "--horizon", horizon])
        assert f": {hours}" in said, said
    message = run([*sun, "--horizon", "81"], status=2)
    assert "--horizon: got '81', expected a number from 0 to 80" in message, message
    cave = [relievo, "cave", "--size", "8x8x8", "-o", folder / "cave.vti"]
    assert "512 samples" in run(cave) and run([*cave, "--silent"]) == ""


PYTHON = """
import inspect

import relievo
from vtkmodules.vtkFiltersSources import vtkPlaneSource

assert inspect.signature(relievo.sun_exposure).parameters["horizon"].default == 0
assert "horizon: Height below which" in relievo.sun_exposure.__doc__
level = vtkPlaneSource()
level.SetNormal(0, 1, 0)
hours = [
    relievo.sun_exposure(level, 0, 0, "2026-03-20", horizon=each)
    .GetCellData().GetArray("sun_hours").GetValue(0) for each in (0, 60)
]
assert abs(hours[0] - 12) < 0.4 and abs(hours[1] - 4) < 0.4, hours
try:
    relievo.sun_exposure(level, 0, 0, "2026-03-20", horizon=-1)
    raise SystemExit("a horizon of -1 was taken")
except ValueError as error:
    assert "horizon: got -1, expected a number from 0 to 80" in str(error), error
"""


def in_python(run, build, python, folder):
    """A keyword of relievo.sun_exposure and of its docstring."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON], env={**os.environ, "PYTHONPATH": path}, cwd=folder)


PARAVIEW = """
import sys

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=simple.__dict__)
level = simple.Plane()
sun = simple.SunExposure(Input=level)
assert sun.Horizon == 0
sun.Latitude, sun.FirstDay, sun.LastDay, sun.Horizon = 0, [2026, 3, 20], [2026, 3, 20], 60
sun.UpAxis = 2
data = simple.servermanager.Fetch(sun)
assert abs(data.GetCellData().GetArray("sun_hours").GetValue(0) - 4) < 0.4
"""


def in_paraview(run, build, folder):
    """A property of the filter."""
    script = folder / "setting.py"
    script.write_text(PARAVIEW, encoding="utf-8")
    output = run(["pvpython", script, build / "plugin" / "Relievo" / "Relievo.so"])
    assert "ERR|" not in output, output
