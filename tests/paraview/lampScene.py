# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A floor and a ball under lamps. As a script: lampScene.py FOLDER NAMES PORT."""

import sys

import numpy
import pv
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLACES = ((-1.2, 0.3, 0.6), (0.9, -0.8, 0.5), (0.4, 1.1, 0.9), (-0.5, -1.0, 0.3))
RADII = (1.4, 1.1, 1.6, 0.8)


def lamps():
    """Points with the array `radius`; each rank has every second one."""
    source = simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    source.Script = f"""
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId() if controller else 0
ranks = controller.GetNumberOfProcesses() if controller else 1
points = vtkPoints()
points.SetDataTypeToDouble()
radius = vtkDoubleArray()
radius.SetName("radius")
for i, (place, size) in enumerate(zip({PLACES}, {RADII})):
    if i % ranks == rank:
        points.InsertNextPoint(place)
        radius.InsertNextValue(size)
output.SetPoints(points)
output.GetPointData().AddArray(radius)
"""
    return source


class Scene:
    def __init__(self, size=(160, 120)):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = list(size)
        self.view.OrientationAxesVisibility = self.view.UseFXAA = self.view.MultiSamples = 0
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [0, 0, 0]
        self.view.LightScale = 0.2
        floor = simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0],
                             XResolution=8, YResolution=8)  # fmt: skip
        self.floor = simple.Show(floor, self.view)
        ball = simple.Sphere(Center=[0, 0, 0.4], Radius=0.4, ThetaResolution=32, PhiResolution=32)
        self.ball = simple.Show(ball, self.view)
        self.points = lamps()
        self.lamps = simple.Show(self.points, self.view)
        simple.Render(self.view)
        self.view.CameraPosition, self.view.CameraFocalPoint = [1, -4, 4], [0, 0, 0.2]
        self.view.CameraViewUp = [0, 0, 1]


class Test(pv.PluginTest):
    """In each case a new scene."""

    def setUp(self):
        super().setUp()
        self.scene = Scene()
        self.view, self.shown = self.scene.view, self.scene.lamps

    def layers(self, *names):
        grab = simple.RelievoLayers(View=self.view)
        grab.Layers = list(names)
        grab.UpdatePipeline()
        image = simple.FetchData(grab)[0].GetPointData()
        found = [vtk_to_numpy(image.GetArray(name)).astype(float) for name in names]
        simple.Delete(grab)
        return found


def light(place, normal, places=PLACES, radii=RADII):
    """The light of the lamps at places with normals: (..., 3) each, in double."""
    total = numpy.zeros(place.shape[:-1])
    for lamp, radius in zip(places, radii):
        to = numpy.array(lamp) - place
        d = numpy.linalg.norm(to, axis=-1)
        total += numpy.maximum(0, 1 - d / radius) * numpy.maximum(0, (to * normal).sum(-1) / d)
    return total


def draw_remotely(folder, names, port):
    """Pictures by a server, and of the name `client` by its client. One process draws for all
    names, `server,client`."""
    simple.Connect("localhost", int(port))
    pv.load(remote=True)
    pv.load()
    scene = Scene()
    for name in names.split(","):
        scene.view.RemoteRenderThreshold = 1e9 if name == "client" else 0
        draw_steps(scene, folder, name)


def draw_steps(scene, folder, name):
    """Pictures without and with lamps, hidden, fog, and markers."""
    for step, lamps, fog, markers, visible in (
            ("off", 0, 0, 0, 1), ("on", 1, 0, 0, 1), ("far", 1, 0, 0, 1), ("cast", 1, 0, 0, 1),
            ("hidden", 1, 1, 1, 0), ("fog", 0, 1, 0, 1), ("markers", 0, 0, 1, 1)):  # fmt: skip
        scene.lamps.RelievoLamps, scene.lamps.RelievoFog = lamps, fog
        scene.lamps.RelievoMarkers = markers
        far = step in ("far", "cast")
        scene.lamps.RelievoLampsRadiusArray = "" if far else "radius"
        scene.lamps.RelievoLampsRadius = 5 if far else 1
        scene.lamps.RelievoLampsIntensity = 0.2 if far else 1
        scene.lamps.RelievoLampsCasts = "Always" if step == "cast" else "If Large"
        scene.lamps.Visibility = visible
        simple.Render(scene.view)
        simple.SaveScreenshot(f"{folder}/{name}-{step}.png", scene.view)


if __name__ == "__main__":
    if sys.argv[1] == "restore":
        pv.load()
        pv.restore(*sys.argv[2:])
        pv.leave()
    else:
        draw_remotely(*sys.argv[1:])
        pv.clear()  # no sys.exit() here: the server would not hear of it
