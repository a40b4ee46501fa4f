# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new layer is one entry of the catalogue, and a row of the page and of the package's docstring:
after that all who list, read, show or write layers have it. For testNewPass.py, which builds the
tree anyway."""

import os

ENTRY = """    { "altitude", L::NUMBER, L::FROM_DEPTH, VTK_FLOAT, 1, Infinity, "Z",
      "height above z = 0, world units", "", L::WORLD,
      [](const double point[3], double* altitude) { *altitude = point[2]; } },
"""
PAGE = "| `altitude` | float | height above z = 0, world units | +∞ |\n"
DOCSTRING = f"altitude           1 float     {'height above z = 0, world units':54}+infinity\n"


def add(tree):
    """Three files: each has it before the layer range."""
    for name, line, place in (
        ("layers/vtkRelievoLayerCatalogue.cxx", ENTRY, '    { "range", '),
        ("docs/layers.md", PAGE, "| `range` | "),
        ("python/relievo/__init__.py", DOCSTRING, "range              1 float "),
    ):
        path = tree / name
        text = path.read_text(encoding="utf-8")
        assert text.count(place) == 1, text
        path.write_text(text.replace(place, line + place), encoding="utf-8")


def on_the_command_line(run, build, folder):
    """In the help, in the message about an unknown name, and in OpenEXR by the entry's suffix."""
    relievo = build / "bin" / "relievo"
    mesh = folder / "slope.off"
    mesh.write_text("OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 2\n-1 1 2\n4 0 1 2 3\n", encoding="utf-8")
    assert " altitude, " in run([relievo, "--help"])
    words = [relievo, "render", mesh, "--size", "90x70", "--exr", folder / "slope.exr"]
    assert " altitude, " in run([*words, "--layers", "altitdue"], status=2)
    run([*words, "--layers", "altitude,position,depth"])
    assert b"altitude.Z\0" in (folder / "slope.exr").read_bytes()


PYTHON = """
import sys

import numpy
import relievo
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

assert relievo.layers()["altitude"] == {
    "help": "height above z = 0, world units", "type": "float", "components": 1,
    "background": numpy.inf}, relievo.layers()["altitude"]

def check(image):
    altitude = relievo.layer(image, "altitude")
    z = relievo.layer(image, "position")[..., 2]
    there = numpy.isfinite(relievo.layer(image, "depth"))
    assert altitude.dtype == numpy.float32 and 0.1 < there.mean() < 1
    assert (altitude[~there] == numpy.inf).all() and altitude[there].std() > 0.1
    assert numpy.abs(altitude[there] - z[there]).max() <= 1e-6

check(relievo.read_exr(sys.argv[1]))
mapper = vtkPolyDataMapper()
cone = vtkConeSource()
cone.SetDirection(1, 2, 3)
cone.SetResolution(40)
mapper.SetInputConnection(cone.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
check(relievo.capture(renderer, ["position", "altitude", "depth"], size=(120, 90)))

# Shown as the picture: lowest and highest in the colour map's ends, the background as it is.
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(120, 90)
window.AddRenderer(renderer)
frame = relievo.attach(renderer)
frame.SetDisplayLayer("altitude")
frame.SetDisplayGrey(True)
frame.RequestLayer("altitude")
window.Render()
grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
grab.ShouldRerenderOff()
grab.Update()
grey = relievo.layer(grab.GetOutput(), "ImageScalars")[..., 0].astype(float)
image = vtkImageData()
frame.ReadLayers(["altitude"], image)
altitude = relievo.layer(image, "altitude")
there = numpy.isfinite(altitude)
low, high = altitude[there].min(), altitude[there].max()
expected = 255 * (altitude[there] - low) / (high - low)
assert numpy.abs(grey[there] - expected).max() <= 1, numpy.abs(grey[there] - expected).max()
"""


def in_python(run, build, python, folder):
    """Listed, read from the file, captured, and shown as the picture."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder / "slope.exr"], env={**os.environ, "PYTHONPATH": path})


PARAVIEW = """
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(sys.argv[1], remote=False, ns=simple.__dict__)
view = simple.CreateView("RenderView")
view.ViewSize = [200, 150]
view.OrientationAxesVisibility = view.UseFXAA = view.MultiSamples = 0
assert "altitude" in view.GetProperty("RelievoDisplayLayer").Available
simple.Show(simple.Sphere(), view)
simple.Render(view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -2, 0], [0, 0, 0], [0, 0, 1]
layers = simple.RelievoLayers(View=view)
assert "altitude" in layers.GetProperty("Layers").Available
assert list(layers.Layers) == ["depth", "normal"], layers.Layers
layers.Layers = ["altitude", "position"]
layers.UpdatePipeline()
image = simple.FetchData(layers)[0].GetPointData()
altitude = vtk_to_numpy(image.GetArray("altitude"))
there = numpy.isfinite(altitude)
z = vtk_to_numpy(image.GetArray("position"))[:, 2]
assert numpy.abs(altitude[there] - z[there]).max() <= 1e-6
# Of a sphere of 8 x 8 corners the two facets at its poles are turned away; a pixel is 0.007 wide.
end = 0.5 * numpy.cos(numpy.pi / 7)
low, high = altitude[there].min(), altitude[there].max()
assert -end <= low < 0.008 - end and end - 0.008 < high <= end, (low, high)
view.RelievoDisplayLayer, view.RelievoDisplayGrey = "altitude", 1
view.RelievoDisplayRange, view.RelievoDisplayLegend = [-0.5, 0.5], 0
shown = vtk_to_numpy(view.SMProxy.CaptureWindow(1).GetPointData().GetScalars())
expected = 255 * (altitude[there] + 0.5)
assert numpy.abs(shown[there] - expected[:, None]).max() <= 1
"""


def in_paraview(run, build, folder):
    """Among the layers that a view shows and that Relievo Layers grabs."""
    script = folder / "layer.py"
    script.write_text(PARAVIEW, encoding="utf-8")
    output = run(["pvpython", script, build / "plugin" / "Relievo" / "Relievo.so"])
    assert "ERR|" not in output, output
