# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers of a scene whose parts lie on the processes there are:

    layersScene.py FOLDER NAME PORT server|client...

The scene is a pvserver's, drawn by it or by this client. Writes FOLDER/NAME-server.npz and
FOLDER/NAME-client.npz: the layers, those of an exported and of a saved file, the number of points
made of them.
"""

import sys

import layers
import numpy
import pv
from paraview import simple

NAMES = (
    "depth range normal geometric_normal position albedo actor block cell color RTData".split()
)


def scene():
    """A contour and a ball: ParaView gives each process a part of either."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [300, 200]
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 0
    view.MultiSamples = 0
    contour = simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"])
    contour.Isosurfaces = [157.0]
    simple.Show(contour, view)
    ball = simple.Sphere(Center=[0, 0, 14], Radius=6, ThetaResolution=64, PhiResolution=64)
    simple.Show(ball, view)
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint = [40, -60, 30], [0, 0, 0]
    view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], 30
    return view


def keep(view, folder, name):
    """Grabs the view's layers by all methods and writes the results."""
    source = simple.RelievoLayers(View=view, Layers=NAMES)
    found = layers.arrays(source)
    points = simple.DepthToPoints(Input=source)
    points.UpdatePipeline()
    found["points"] = points.GetDataInformation().GetNumberOfPoints()
    path = f"{folder}/{name}-saved.exr"
    simple.SaveData(path, source)
    found["saved"] = layers.arrays(simple.OpenDataFile(path))["depth"]
    path = f"{folder}/{name}-exported.exr"
    simple.ExportView(path, view=view)
    exported = layers.arrays(simple.OpenDataFile(path))
    found["exported"], found["picture"] = exported["depth"], exported["color"]
    # Nothing is in sight: no process has a part of it.
    camera = view.CameraFocalPoint[:]
    view.CameraFocalPoint = [80, -120, 60]
    source.Layers = ["depth", "normal", "actor", "shadow_0", "color"]
    nothing = layers.arrays(source)
    assert (nothing["shadow_0"] == 1).all(), "nothing"
    assert numpy.isposinf(nothing["depth"]).all() and not nothing["normal"].any(), "nothing"
    assert (nothing["actor"] == -1).all(), "nothing"
    view.CameraFocalPoint = camera
    # The layers are shown, over the processes, and follow the view.
    other = simple.CreateView("RenderView")
    simple.Show(source, other)
    simple.Show(points, other)
    simple.Render(other)
    source.FollowView = 1
    simple.Render(view)
    found["followed"] = layers.arrays(source)["depth"]
    numpy.savez(f"{folder}/{name}.npz", **found)


def keep_remotely(folder, name, port, *places):
    simple.Connect("localhost", int(port))
    pv.load()
    pv.load(remote=True)
    for where in places:
        there = scene()
        there.RemoteRenderThreshold = 0.0 if where == "server" else 1e9
        keep(there, folder, f"{name}-{where}")
        drawn = there.SMProxy.GetClientSideObject().GetUseDistributedRenderingForRender()
        assert bool(drawn) == (where == "server"), where
        pv.clear()


if __name__ == "__main__":
    keep_remotely(*sys.argv[1:])
    print("kept", sys.argv[2])
