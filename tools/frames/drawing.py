# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by packageScenes.py and filterScenes.py, whose arguments are MADE DATA NAME."""

import json
import pathlib
import sys

import numpy
import relievo
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

MADE, DATA = (pathlib.Path(word) for word in sys.argv[1:3])
SIZE = (300, 200)
COLORS = {"ground": (0.55, 0.55, 0.6), "things": (0.8, 0.5, 0.3)}
NORMALS = ["depth", "normal", "color"]


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(MADE / f"{name}.vtp"))
    reader.Update()
    return reader.GetOutput()


def read_picture(name):
    reader = vtkPNGReader()
    reader.SetFileName(str(MADE / name))
    reader.Update()
    return reader.GetOutput()


def actor_of(data, color=None):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*color)
    return actor


def room(*names, size=SIZE, actors=()):
    """A renderer of files and actors under two lights, and its window; keep both."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.1, 0.15, 0.2)
    for name in names:
        renderer.AddActor(actor_of(read(name), COLORS.get(name)))
    for actor in actors:
        renderer.AddActor(actor)
    for place, positional in (((3, 5, 2), False), ((-3, 4, 3), True)):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*place)
        light.SetPositional(positional)
        light.SetConeAngle(30)
        light.SetIntensity(0.7)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.5, 3, 6)
    camera.SetFocalPoint(0, 0.5, 0)
    camera.SetClippingRange(2, 14)
    return renderer, window_of(renderer, size)


def window_of(renderer, size=SIZE):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return window


def save(image, name="frame"):
    """Saves each layer separately, and all as OpenEXR."""
    for layer in relievo.layer_names(image):
        numpy.save(f"{name}-{layer.replace(':', '-')}.npy", relievo.layer(image, layer))
    relievo.write_exr(f"{name}.exr", image)


def grab(window, name="picture"):
    """Saves the window's picture."""
    window.Render()
    held = vtkWindowToImageFilter()
    held.SetInput(window)
    held.ReadFrontBufferOff()
    held.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(held.GetOutputPort())
    writer.SetFileName(f"{name}.png")
    writer.Write()


def write_report(renderer, name="report"):
    pathlib.Path(f"{name}.json").write_text(json.dumps(relievo.report(renderer)))


def keep(data, name):
    """Saves points, cells and arrays of a dataset."""
    if data.IsA("vtkPolyData"):
        numpy.save(f"{name}-points.npy", vtk_to_numpy(data.GetPoints().GetData()))
        numpy.save(f"{name}-cells.npy", vtk_to_numpy(data.GetPolys().GetConnectivityArray()))
    for kind in ("Point", "Cell"):
        held = getattr(data, f"Get{kind}Data")()
        for i in range(held.GetNumberOfArrays()):
            array = held.GetArray(i)
            if array:
                path = f"{name}-{kind}-{array.GetName()}.npy".replace("/", "_")
                numpy.save(path, vtk_to_numpy(array))


def see(actors):
    """Saves a picture fitted to the actors."""
    renderer = vtkRenderer()
    for actor in actors:
        renderer.AddActor(actor)
    relievo.attach(renderer).ShadowsOn()
    window = window_of(renderer, (200, 200))
    renderer.ResetCamera()
    save(relievo.capture(renderer, ["color", "normal"]))
    grab(window)
