# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""New options of `relievo render`: one that sets a parameter of a stage takes a row with that
stage's others and one in the page; one of look/ takes a member, and a row with its use, in the
class that uses it; one of scene/ takes a row, its use and the page. After that the parser, the
help, the completion, the manual page, Python, the viewer and its copied programs have them, and
data sets take them. For testNewPass.py, which builds the tree anyway.
"""

import os

OF_STAGE = """  AddOfStage(rows, stages, "--sky-rays N", "ambient", "samples",
    "Rays of ambient occlusion from each pixel");
"""
OF_LOOK = """  rows
    .AddNumber("--line-width", "PIXELS", "width of lines and edges, @bounds@ pixels (1)",
      { 1.0, 20.0 }, look.LineWidth)
    .ShowIn("Look", "Line width");
"""
OF_OUTPUTS = """  rows
    .AddNumber("--png-level", "N", "effort for a small PNG, @bounds@ (5)", { 0.0, 9.0 },
      all.Numbers)
    .OfOutputs = true;
"""
PAGE = """| `--sky-rays N` | rays of ambient occlusion from each pixel, 1 to 4096 | 64 |
| `--line-width PIXELS` | width of lines and edges, 1 to 20 pixels | 1 |
| `--png-level N` | effort for a small PNG, 0 to 9 | 5 |
"""


def replace(path, *edits):
    text = path.read_text(encoding="utf-8")
    for old, new in edits:
        assert text.count(old) == 1, (path, old)
        text = text.replace(old, new.replace("{0}", old))
    path.write_text(text, encoding="utf-8")


def add(tree):
    """The rows, the member, its use, and the page."""
    replace(tree / "scene" / "options" / "Stages.cxx",
            ("  vtkRelievoOption& deferred =\n", OF_STAGE + "{0}"))  # fmt: skip
    replace(tree / "look" / "colors" / "LookOptions.h",
            ("  bool Edges = false;\n", "{0}  double LineWidth = 1.0; ///< pixels\n"))  # fmt: skip
    replace(tree / "look" / "colors" / "Look.cxx",
            ('  rows.AddFlag("--edges",', OF_LOOK + "{0}"),
            ("    if (look.PointSize > 1.0)\n",
             "    property->SetLineWidth(static_cast<float>(look.LineWidth));\n{0}"))  # fmt: skip
    replace(tree / "scene" / "options" / "OutputOptions.cxx",
            ("  vtkRelievoOption& png = rows.Add(", OF_OUTPUTS + "{0}"))  # fmt: skip
    replace(tree / "scene" / "WriteOutputs.cxx",
            ("  vtkNew<vtkPNGWriter> writer;\n",
             '{0}  const double level = options.Numbers.Get("--png-level", 5.0);\n'
             "  writer->SetCompressionLevel(static_cast<int>(level));\n"))  # fmt: skip
    replace(tree / "docs" / "command-line.md", ("| `--edges` |", PAGE + "{0}"))


def on_the_command_line(run, build, folder):
    """In the help, the completion's words of three programs, and the picture."""
    relievo = build / "bin" / "relievo"
    page, words = run([relievo, "--help"]), run([relievo, "--words"])
    assert "\n  --line-width PIXELS" in page and "edges, 1 to 20 pixels (1)" in page, page
    assert "\n  --sky-rays N" in page, page
    assert "\nrender --png-level value\n" in words, words
    for program in ("render", "dataset", "relievo-viewer"):
        for option in ("--line-width", "--sky-rays"):
            assert f"\n{program} {option} value\n" in words, words
    (folder / "sheet.off").write_text(
        "OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n", encoding="utf-8")
    picture = folder / "sheet.png"
    draw = [relievo, "render", folder / "sheet.off", "--size", "60x60", "--edges", "--png", picture]

    def pixels(*options):
        run([*draw, *options])
        return picture.read_bytes()

    assert pixels() == pixels("--line-width", "1") != pixels("--line-width", "5")
    assert len(pixels("--png-level", "0")) > 60 * 60 * 3 > len(pixels())
    said = run([*draw, "--png-level", "10"], status=2)
    assert "--png-level: got '10', expected a number from 0 to 9" in said, said
    said = run([*draw, "--line-width", "21"], status=2)
    assert "--line-width: got '21', expected a number from 1 to 20" in said, said
    said = run([*draw, "--sky-rays", "0"], status=2)
    assert "--sky-rays: got '0', expected" in said, said


PYTHON = r"""
import sys

import relievo

folder = sys.argv[1]
scene = relievo.scene(folder + "/sheet.off", size="60x60", edges=True, line_width=5, sky_rays=32)
scene.render(folder + "/scene.png")
assert "\nline_width=PIXELS\n" in relievo.scene.__doc__
try:
    scene.set(line_width=0)
    raise SystemExit("a width of 0 was taken")
except ValueError as error:
    assert "line_width: got '0', expected a number from 1 to 20" in str(error), error
"""


def in_python(run, build, python, folder):
    """Keywords of relievo.scene."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})


def in_the_viewer(run, build, python):
    """The viewer's own tests draw it as the command and the copied program do, and find its label
    in the panel that the messages name."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])
    viewer = build / "tests" / "bin" / "relievo_tests_viewer"
    words = {**os.environ, "PYTHONPATH": path, "PYTHON": python,
             "RELIEVO": str(build / "bin" / "relievo")}  # fmt: skip
    run([viewer, "--case", "testViewerEvery", "options"], env=words)
    run([viewer, "--case", "testViewerMessages"], env=words)
