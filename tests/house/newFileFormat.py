# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new format of files is a row of the file that opens them, of data or of images, and of the
page: after that the command, its help, its completion, Python, the viewer and ParaView have it. For
testNewPass.py, which builds the tree anyway.

The formats are those of OFF and BMP, under other names and with other first bytes.
"""

import os

DATA = '    { { "coff" }, Open<vtkRelievoOFFReader>, "coff", true },\n'
IMAGE = """    { { "dib" }, { "DIB" },
      [](const Bytes& bytes) { return DecodeBMP(bytes.From(3)); } },
"""


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path, old)
    path.write_text(text.replace(old, new), encoding="utf-8")


def add(tree):
    """The rows, and their documentation."""
    row = '    { { "off" }, Open<vtkRelievoOFFReader>, "off" },\n'
    replace(tree / "reading" / "files" / "Readers.cxx", row, row + DATA)
    row = '    { { "bmp" }, { "BM" }, DecodeBMP },\n'
    replace(tree / "io" / "image" / "vtkRelievoImageFile.cxx", row, row + IMAGE)
    replace(tree / "docs" / "command-line.md", "| `.stl` `.ply` `.off` |",
            "| `.stl` `.ply` `.off` `.coff` |")  # fmt: skip


def on_the_command_line(run, build, folder):
    """In the help, the completion's words and messages; read, with z up."""
    relievo = build / "bin" / "relievo"
    page, words = run([relievo, "--help"]), run([relievo, "--words"])
    assert " .off .coff and models" in " ".join(page.split()), page
    assert "|off|coff|gltf|" in words and "relievo-viewer --normal-map png|" in words, words
    assert "|bmp|dib|tga|" in words and ".bmp .dib .tga" in page, words
    (folder / "plate.coff").write_text(
        "OFF\n4 1 0\n-1 -1 1\n1 -1 1\n1 1 2\n-1 1 2\n4 0 1 2 3\n", encoding="utf-8")
    pixels = bytes([0, 0, 255, 0, 255, 0, 0, 0])  # one row of two
    head = b"BM" + (54 + len(pixels)).to_bytes(4, "little") + bytes(4) + bytes([54, 0, 0, 0])
    head += bytes([40, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 24, 0]) + bytes(24)
    (folder / "sky.dib").write_bytes(b"DIB" + head + pixels)
    run([relievo, "render", folder / "plate.coff", "--size", "40x30", "--environment",
         folder / "sky.dib", "--skybox", "--png", folder / "plate.png"])  # fmt: skip
    said = run([relievo, "render", folder / "plate.cof", "--png", folder / "no.png"], status=2)
    assert ".off .coff .gltf" in said, said
    (folder / "bad.coff").write_text("OFF\n1 1 0\n", encoding="utf-8")
    said = run([relievo, "render", folder / "bad.coff", "--png", folder / "no.png"], status=1)
    assert "bad.coff" in said, said


PYTHON = """
import sys

import relievo
from vtkmodules.vtkRenderingCore import vtkRenderer

assert "bmp, dib, tga" in relievo.environment.__doc__
folder = sys.argv[1]
scene = relievo.scene(folder + "/plate.coff", size="40x30").update()
light = relievo.environment(vtkRenderer(), folder + "/sky.dib")
assert light.GetImage().GetDimensions() == (2, 1, 1)
"""


def in_python(run, build, python, folder):
    """Scenes and environments read them."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})


PARAVIEW = """
import sys

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=simple.__dict__)
view = simple.CreateView("RenderView")
hints = view.SMProxy.GetProperty("RelievoEnvironment").GetHints()
assert " bmp dib tga " in hints.FindNestedElementByName("FileChooser").GetAttribute("extensions")
"""


def in_paraview(run, build, folder):
    """Dialogs of files offer it."""
    script = folder / "files.py"
    script.write_text(PARAVIEW, encoding="utf-8")
    output = run(["pvpython", script, build / "plugin" / "Relievo" / "Relievo.so"])
    assert "ERR|" not in output, output
