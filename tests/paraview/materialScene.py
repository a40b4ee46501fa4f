# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A white square, seen straight from above in the light of one lamp at the camera; and maps.

With the words `restore FILE PICTURE` the script loads a state and draws it; with `invalid` it
sets invalid files and values and prints the results; with `ranks FOLDER NAMES [PORT]` it draws
parts of a square that lie on the ranks, or with a server, and for the name `client` as its
client.
"""

import math
import sys

import numpy
import pv
from paraview import simple

SIZE = (240, 180)
LIGHT = 0.8
DISTANCE = 2.0
ANGLE = 30.0  # of the camera's view, up and down


def write_normals(name, normal, shape=(16, 16)):
    """An 8-bit map of one normal everywhere; its path."""
    codes = numpy.round((numpy.asarray(normal, float) + 1) / 2 * 255)
    pv.write(pv.OUTPUT / name, numpy.broadcast_to(codes, (*shape, 3)))
    return str(pv.OUTPUT / name)


def write_heights(name, heights):
    """An 8-bit map of heights from 0 to 1, the top row first; its path."""
    codes = numpy.round(numpy.asarray(heights, float) * 255)
    pv.write(pv.OUTPUT / name, numpy.repeat(codes[:, :, None], 3, axis=2))
    return str(pv.OUTPUT / name)


def lean(degrees, towards=0.0):
    """The unit normal that leans so far from z, towards an angle from u to v."""
    lean, towards = math.radians(degrees), math.radians(towards)
    level = math.sin(lean)
    return numpy.array([level * math.cos(towards), level * math.sin(towards), math.cos(lean)])


# The colour of light from +x, -x, +y, -y, +z, -z of an environment; the same in sRGB and linear.
AXES = numpy.array(
    [[255, 0, 0], [0, 255, 255], [0, 255, 0], [255, 0, 255], [0, 0, 255], [255, 255, 0]]
)


def write_axes(name, rows=64):
    """
    An equirectangular picture of the colours of the axes; its path. As vtkRelievoEnvironment has
    it: +y is up, the middle looks along +x, +z is a quarter to its right.
    """
    high = math.pi * (0.5 - (numpy.arange(rows) + 0.5) / rows)[:, None]
    right = 2 * math.pi * ((numpy.arange(2 * rows) + 0.5) / (2 * rows) - 0.5)[None, :]
    level = numpy.cos(high)
    towards = numpy.stack(
        [level * numpy.cos(right), numpy.sin(high) + 0 * right, level * numpy.sin(right)], axis=-1
    )
    axis = numpy.abs(towards).argmax(axis=-1)
    negative = numpy.take_along_axis(towards, axis[..., None], axis=-1)[..., 0] < 0
    pv.write(pv.OUTPUT / name, AXES[2 * axis + negative])
    return str(pv.OUTPUT / name)


class Scene:
    """`square` is the source, one unit wide, `shown` its representation."""

    def __init__(self, source=None, size=SIZE, light=(0.0, 0.0, 1.0)):
        self.view = make_view(size)
        self.square = source or simple.Plane(XResolution=1, YResolution=1)
        self.shown = self.show(self.square)
        self.lamp = lamp = simple.AddLight(self.view)
        lamp.Coords, lamp.Type, lamp.Intensity = "Scene", "Directional", LIGHT
        lamp.Position, lamp.FocalPoint = list(light), [0.0, 0.0, 0.0]
        simple.Render(self.view)  # whose first call in a process turns the camera
        self.look()

    def show(self, source):
        """Shows it all white, without the light that comes from nowhere."""
        shown = simple.Show(source, self.view)
        shown.AmbientColor = shown.DiffuseColor = [1.0, 1.0, 1.0]
        return shown

    def look(self):
        self.view.CameraPosition = [0.0, 0.0, DISTANCE]
        self.view.CameraFocalPoint = [0.0, 0.0, 0.0]
        self.view.CameraViewUp = [0.0, 1.0, 0.0]
        self.view.CameraViewAngle = ANGLE

    def middle(self):
        """The colour in the middle of the picture, and the picture."""
        picture = pv.picture(self.view)
        return picture[picture.shape[0] // 2, picture.shape[1] // 2], picture


def make_view(size=SIZE):
    """A view without lights, one sample a pixel, black behind."""
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseFXAA, view.MultiSamples = 0, 0
    view.UseColorPaletteForBackground, view.Background = 0, [0.0, 0.0, 0.0]
    view.UseLight = 0
    return view


def say(*words):
    """Where ParaView's messages go, in order."""
    print(*words, file=sys.stderr, flush=True)


# Invalid files and values, and the message for each.
def invalid_values():
    """(property, value, words of the message)."""
    text = pv.OUTPUT / "no image.png"
    text.write_text("no image")
    cut = pv.OUTPUT / "cut.png"
    whole = pv.OUTPUT / "whole.png"
    pv.write(whole, numpy.random.default_rng(1).integers(0, 255, (64, 64, 3)))
    pv.write(pv.OUTPUT / "wide.png", numpy.zeros((16, 48, 3)))
    cut.write_bytes(whole.read_bytes()[:2000])
    return (
        ("RelievoNormalMap", "/nowhere.png", "'/nowhere.png', expected an image, but there is no"),
        ("RelievoHeightMap", str(text), "expected an image (png, jpg, tif, bmp, tga, hdr, exr)"),
        ("RelievoNormalMap", str(pv.OUTPUT), "expected an image, but it is a folder"),
        ("RelievoNormalMap", str(cut), "expected an image, but it cannot be read"),
        ("RelievoEnvironment", "/nowhere.hdr", "/nowhere.hdr', expected an image, but there is"),
        ("RelievoEnvironment", str(whole).replace("whole", "wide"), "but it has 48 x 16 pixels"),
        ("RelievoEnvironmentIntensity", -1.0, "was given -1, expected 0 or more: 0 is taken"),
        ("RelievoEnvironmentUp", 3, "was given 3, expected 0 to 2: 2 is taken"),
        ("RelievoHeightScale", -1.0, "was given -1, expected 0 or more: 0 is taken"),
        ("RelievoReliefMethod", 9, "was given 9, expected 0 to 4: 4 is taken"),
        ("RelievoRoughness", 2.0, "was given 2, expected 0 to 1: 1 is taken"),
        ("RelievoMaximumSteps", 0, "was given 0, expected 1 to 4096: 1 is taken"),
    )


def set_invalid():
    """Sets and resets each; the output of the process is the result."""
    scene = Scene()
    scene.shown.RelievoMaterial = 1
    scene.view.RelievoSkybox = 1
    _, first = scene.middle()
    for number, (name, value, _) in enumerate(invalid_values()):
        say(f"case {number} {name}")
        owner = scene.view if "Environment" in name else scene.shown
        before = getattr(owner, name)
        setattr(owner, name, value)
        same = (scene.middle()[1] == first).all() and (scene.middle()[1] == first).all()
        setattr(owner, name, before)
        say("same", same and (scene.middle()[1] == first).all())
    say("case", "no texture coordinates")
    bare = simple.ProgrammableFilter(Input=scene.square)
    bare.Script = "output.GetPointData().SetTCoords(None)"
    simple.Hide(scene.square, scene.view)
    shown = scene.show(bare)
    _, first = scene.middle()
    shown.RelievoMaterial = 1
    shown.RelievoNormalMap = write_normals("leaning.png", lean(30))
    # all() is ParaView's own since the filter's script.
    say("same", numpy.all([(scene.middle()[1] == first).all() for _ in range(3)]))


# A rank's part of a square: as many stripes as there are ranks.
STRIPES = """
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
ranks, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()
first, last = rank / ranks, (rank + 1) / ranks
stripe = vtkPlaneSource()
stripe.SetOrigin(first - 0.5, -0.5, 0)
stripe.SetPoint1(last - 0.5, -0.5, 0)
stripe.SetPoint2(first - 0.5, 0.5, 0)
stripe.Update()
made = stripe.GetOutput()
places = made.GetPointData().GetTCoords()
for i in range(places.GetNumberOfTuples()):
    u, v = places.GetTuple(i)
    places.SetTuple(i, (first + u * (last - first), v))
self.GetOutput().ShallowCopy(made)
"""


def draw_ranks(folder, names, port=None):
    """Writes FOLDER/NAME-STEP.png for each step, and each of the names `server,client`."""
    if port:
        simple.Connect("localhost", int(port))
        pv.load()
        pv.load(remote=True)
    stripes = simple.ProgrammableSource()
    stripes.OutputDataSetType = "vtkPolyData"
    stripes.Script = STRIPES
    scene = Scene(stripes, light=(1.0, 1.0, 2.0))
    scene.view.CameraPosition = [0.9, -1.1, 1.2]
    for name in names.split(","):
        scene.view.RemoteRenderThreshold = 1e9 if name == "client" else 0
        draw_steps(scene, folder, name)


def draw_steps(scene, folder, name):
    def step(what):
        pv.write(f"{folder}/{name}-{what}.png", pv.picture(scene.view))

    step("off")
    wave = numpy.linspace(0, 4 * numpy.pi, 128)
    heights = 0.5 + 0.25 * (numpy.sin(wave)[:, None] + numpy.cos(2 * wave)[None, :])
    scene.shown.RelievoMaterial = 1
    scene.shown.RelievoHeightMap = write_heights(f"{name}.png", heights)
    scene.shown.RelievoHeightScale = 0.1
    scene.shown.RelievoSelfShadow = 1
    scene.shown.RelievoClipAtBorders = 1
    step("relief")
    scene.shown.RelievoHeightMap = ""
    scene.shown.RelievoNormalMap = write_normals(f"{name}-n.png", lean(30, 45))
    step("normals")
    scene.view.RelievoEnvironment = write_axes(f"{name}-e.png")
    scene.view.RelievoSkybox = 1
    scene.shown.RelievoMirror, scene.shown.RelievoReflectivity = 1, 0.5
    scene.shown.RelievoRoughness = 0.3
    step("sky")
    scene.shown.Opacity = 0.5
    step("glass")
    scene.shown.Opacity = 1.0
    scene.view.RelievoSkybox = 0
    scene.shown.RelievoMaterial = 0
    step("off-again")
    # For the next name.
    scene.view.RelievoEnvironment = scene.shown.RelievoNormalMap = ""
    scene.shown.RelievoMirror = 0


if __name__ == "__main__":
    pv.load()
    {"restore": pv.restore, "invalid": set_invalid, "ranks": draw_ranks}[sys.argv[1]](*sys.argv[2:])
    if sys.argv[1] == "ranks":
        pv.clear()  # no sys.exit() here: the other ranks would not hear of it
    else:
        pv.leave()
