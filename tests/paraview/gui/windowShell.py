# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Code that the tests of ParaView's window run in its Python shell. Its results go into a file,
because the shell itself only prints."""

import json
import os
import pathlib
import time
import traceback

from paraview import simple, smtrace

OUTPUT = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])


def note(name, value):
    """Keeps a value for the test."""
    with open(OUTPUT / "notes.jsonl", "a", encoding="utf-8") as notes:
        notes.write(json.dumps([name, value]) + "\n")


def noted(function):
    """An exception is kept as well: without this it would be lost in the shell."""

    def run(*arguments, **named):
        try:
            return function(*arguments, **named)
        except Exception:  # pylint: disable=broad-except
            note("exception", traceback.format_exc())
            raise

    return run


@noted
def scene():
    """A ball above a floor in the active view."""
    view = simple.GetActiveView()
    simple._DisableFirstRenderCameraReset()
    floor = simple.Plane(Origin=[-3, -3, 0], Point1=[3, -3, 0], Point2=[-3, 3, 0])
    simple.Show(floor, view)
    ball = simple.Sphere(Center=[0, 0, 1], ThetaResolution=32, PhiResolution=32)
    simple.Show(ball, view)
    view.OrientationAxesVisibility = 0
    view.CameraPosition = [4, -6, 5]
    view.CameraFocalPoint = [0, 0, 0.5]
    view.CameraViewUp = [0, 0, 1]
    simple.Render(view)


@noted
def ball():
    """A ball alone in the active view, with y up, twice as wide as high."""
    view = simple.GetActiveView()
    simple._DisableFirstRenderCameraReset()
    shown = simple.Show(simple.Sphere(Radius=1, PhiResolution=33), view)
    move(shown, [0, 3, 5])
    shown.Scale = [2, 1, 2]
    view.OrientationAxesVisibility = 0
    view.CameraPosition = [6, 9, 15]
    view.CameraFocalPoint = [0, 2.5, 5]
    view.CameraViewUp = [0, 1, 0]
    simple.Render(view)


def move(shown, place):
    """Moves a representation; ParaView 5.13 gave the property another name."""
    name = "Translation" if shown.SMProxy.GetProperty("Translation") else "Position"
    setattr(shown, name, place)


@noted
def ground(name):
    """Keeps the corners of the source that the dock's button makes, whether it is seen, and how
    bright it is."""
    plane = simple.FindSource("Ground")
    shown = simple.GetRepresentation(plane, simple.GetActiveView()) if plane else None
    note(name, plane and [list(plane.Origin), list(plane.Point1), list(plane.Point2),
                          shown.Visibility, list(shown.DiffuseColor)])


@noted
def dropGround():
    """Deletes it."""
    simple.Delete(simple.FindSource("Ground"))
    simple.Render(simple.GetActiveView())


@noted
def replay(name):
    """Runs a trace that was kept."""
    with open(OUTPUT / "notes.jsonl", encoding="utf-8") as notes:
        kept = dict(json.loads(line) for line in notes)
    exec(compile(kept[name], name, "exec"), {})
    simple.Render(simple.GetActiveView())


@noted
def skyAround():
    """Sets the view's current picture as its environment."""
    shoot("sky", (400, 200))
    change(RelievoEnvironment=str(OUTPUT / "sky.png"))


@noted
def mirrors(name):
    """Keeps how many representations are seen, and how many of them mirror the environment."""
    shown = [each for each in simple.GetActiveView().Representations if each.Visibility]
    note(name, [len(shown), sum(each.RelievoMaterial * each.RelievoMirror for each in shown)])


@noted
def shoot(name, size=(400, 300)):
    """Saves the active view's picture."""
    simple.SaveScreenshot(str(OUTPUT / f"{name}.png"), simple.GetActiveView(),
                          ImageResolution=list(size))


@noted
def render(times=1):
    """Draws the active view; time passes in which the panel may read the report."""
    for _ in range(times):
        simple.Render(simple.GetActiveView())
    time.sleep(0.4)


@noted
def drawOnServer():
    """The server draws the active view's pictures, however little there is to draw."""
    view = simple.GetActiveView()
    view.RemoteRenderThreshold = 0
    simple.Render(view)
    note("server draws", view.SMProxy.GetClientSideObject().GetUseDistributedRenderingForRender())


@noted
def follow():
    """Layers of the active view that follow it, though it shows nothing of Relievo."""
    view = simple.GetActiveView()
    simple._add_functions(simple.__dict__)  # of the plugin, which was loaded since
    simple.RelievoLayers(View=view, Layers=["depth"], FollowView=1).UpdatePipeline()


@noted
def change(**values):
    """Sets properties of the active view, as a script does."""
    view = simple.GetActiveView()
    for name, value in values.items():
        setattr(view, name, value)
    simple.Render(view)


@noted
def values(name, *properties):
    """Keeps properties of the active view."""
    view = simple.GetActiveView()
    note(name, [view.GetPropertyValue(each) for each in properties])


@noted
def settings(name):
    """Keeps Relievo's settings of every view, as far as the views know them."""
    note(name, [{key: view.GetPropertyValue(key)
                 for key in ("RelievoShadows", "RelievoSun", "RelievoShadowMapSize")
                 if view.SMProxy.GetProperty(key)}
                for view in simple.GetRenderViews()])


@noted
def size(name):
    """Keeps the active view's size."""
    note(f"size {name}", list(simple.GetActiveView().ViewSize))


@noted
def sun(name):
    """Keeps where the sun stands: azimuth and elevation, and whether its light is on."""
    view = simple.GetActiveView()
    simple.Render(view)
    view.UpdatePropertyInformation()
    angles = view.GetProperty("RelievoSunAngles")
    lights = view.SMProxy.GetRenderer().GetLights()
    on = sum(lights.GetItemAsObject(i).GetSwitch() for i in range(lights.GetNumberOfItems()))
    note(f"sun {name}", [angles.GetElement(0), angles.GetElement(1), on])


@noted
def material(name):
    """Saves the material of the active surface."""
    shown = simple.GetDisplayProperties()
    note(name, [shown.RelievoMaterial, shown.RelievoMirror])


@noted
def shown(name, *properties):
    """Keeps display properties of the active source."""
    display = simple.GetDisplayProperties()
    note(name, [str(display.GetProperty(each).GetElement(0)) for each in properties])


@noted
def style(**values):
    """Sets display properties of the active source, as a script does."""
    display = simple.GetDisplayProperties()
    for name, value in values.items():
        setattr(display, name, value)


@noted
def chooseFloor():
    """The floor is the active source."""
    simple.SetActiveSource(simple.FindSource("Plane1"))


@noted
def goToOutput():
    """From now on names of files without a folder are of the test's own."""
    os.chdir(OUTPUT)


@noted
def comparativeView():
    """A comparative view beside the first; it becomes the active one."""
    layout = simple.GetLayout()
    layout.SplitHorizontal(0, 0.5)
    view = simple.CreateView("ComparativeRenderView")
    layout.AssignView(2, view)
    simple.SetActiveView(view)


@noted
def startTrace():
    """Starts to trace actions as Python."""
    smtrace.start_trace()


@noted
def stopTrace(name):
    """Keeps the trace."""
    note(name, smtrace.stop_trace())


@noted
def secondView():
    """A view beside the first; it becomes the active one."""
    layout = simple.GetLayout()
    layout.SplitHorizontal(0, 0.5)
    layout.AssignView(2, simple.CreateView("RenderView"))
    simple.RenderAllViews()


@noted
def moveBall():
    """Takes the ball out of the first view's sight."""
    simple.FindSource("Sphere1").Center = [0, 0, -100]


@noted
def layers(name):
    """Saves the inputs of the layers: the view, its size, its visible share and nearest depth."""
    source = simple.FindSource("RelievoLayers1")
    if not source.View:
        note(name, None)
        return
    source.UpdatePipeline()
    image = simple.FetchData(source)[0]
    depth = image.GetPointData().GetArray("depth")
    depths = [depth.GetValue(i) for i in range(depth.GetNumberOfTuples())]
    seen = [each for each in depths if each < 1e30]
    note(name, {"size": image.GetDimensions()[:2], "view": list(source.View.ViewSize),
                "first": source.View == simple.FindView("RenderView1"),
                "seen": len(seen), "mean": sum(seen) / len(seen)})


@noted
def points(name):
    """Keeps how many points the depth makes."""
    note(name, simple.FindSource("DepthToPoints1").GetDataInformation().GetNumberOfPoints())


@noted
def closeView():
    """Closes the view that the layers are of."""
    simple.Delete(simple.FindView("RenderView1"))
