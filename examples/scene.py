# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the examples: paths of files, three shapes on a floor, a sunny room."""

import os
import pathlib
import sys

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkImageData, vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkElevationFilter
from relievo.vtk.vtkFiltersSources import (
    vtkConeSource,
    vtkPlaneSource,
    vtkSphereSource,
    vtkSuperquadricSource,
)
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTexture,
    vtkVolume,
)
from relievo.vtk.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper


def folder():
    """The output folder of an example: the first argument, or the current folder."""
    chosen = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    chosen.mkdir(parents=True, exist_ok=True)
    return chosen


def data(name):
    """The path of a real mesh that tools/unpack-data puts into the folder RELIEVO_DATA."""
    default = pathlib.Path(__file__).resolve().parent.parent / "build" / "data"
    path = pathlib.Path(os.environ.get("RELIEVO_DATA", default)) / name
    if not path.is_file():
        raise SystemExit(f"{path} is missing: run tools/unpack-data")
    return str(path)


def points(places, **arrays):
    """Points without cells, with the named arrays."""
    data = vtkPolyData()
    at = vtkPoints()
    at.SetData(numpy_to_vtk(numpy.array(places, dtype=float), deep=True))
    data.SetPoints(at)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def image(values, spacing=(1, 1, 1), origin=(0, 0, 0)):
    """Values of shape (z, y, x) as an image for a volume."""
    made = vtkImageData()
    made.SetDimensions(*values.shape[::-1])
    made.SetSpacing(*spacing)
    made.SetOrigin(*origin)
    array = numpy_to_vtk(numpy.ascontiguousarray(values).ravel(), deep=True)
    array.SetName("values")
    made.GetPointData().SetScalars(array)
    return made


def volume(data, opacity, colours, unit, step=0.5):
    """A shaded volume: opacity over `unit` world units and colour by value, as pairs and rows; the
    step is a share of the distance of the image's points."""
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputData(data)
    # VTK's defaults let the time of earlier frames choose the step, which shows as rings.
    mapper.InteractiveAdjustSampleDistancesOff()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(step * min(data.GetSpacing()))
    made = vtkVolume()
    made.SetMapper(mapper)
    look = made.GetProperty()
    for value, share in opacity:
        look.GetScalarOpacity().AddPoint(value, share)
    for row in colours:
        look.GetRGBTransferFunction().AddRGBPoint(*row)
    look.SetScalarOpacityUnitDistance(unit)
    look.SetInterpolationTypeToLinear()
    look.ShadeOn()
    look.SetAmbient(0.3)
    look.SetDiffuse(0.9)
    look.SetSpecular(0.1)
    return made


def ground(half, height=0, colour=(0.6, 0.6, 0.62)):
    """A square floor around the origin, at this height; y is up."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-half, height, -half)
    plane.SetPoint1(-half, height, half)
    plane.SetPoint2(half, height, -half)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    return actor


def texture(colours):
    """Colours (rows, columns, 3) from 0 to 1, the first row lowest, as a texture that repeats."""
    image = vtkImageData()
    image.SetDimensions(colours.shape[1], colours.shape[0], 1)
    texels = (255 * numpy.clip(colours, 0, 1)).astype(numpy.uint8).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(texels, deep=True))
    made = vtkTexture()
    made.SetInputData(image)
    made.InterpolateOn()
    made.MipmapOn()
    made.RepeatOn()
    return made


def make(columns=640, rows=480):
    """A renderer in an off-screen window; keep the window as long as the renderer is drawn."""
    floor = vtkPlaneSource()
    floor.SetOrigin(-3, 0, -3)
    floor.SetPoint1(-3, 0, 3)
    floor.SetPoint2(3, 0, -3)
    ball = vtkSphereSource()
    ball.SetCenter(-1.1, 0.6, 0.4)
    ball.SetRadius(0.6)
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(64)
    cone = vtkConeSource()
    cone.SetCenter(1.2, 0.6, 0.6)
    cone.SetDirection(0, 1, 0)
    cone.SetHeight(1.2)
    cone.SetRadius(0.5)
    cone.SetResolution(48)
    ring = vtkSuperquadricSource()
    ring.ToroidalOn()
    ring.SetThickness(0.4)
    ring.SetSize(0.8)
    ring.SetCenter(0.1, 0.8, -0.9)
    ring.SetThetaResolution(64)
    ring.SetPhiResolution(64)

    renderer = vtkRenderer()
    for source, colour in (
        (floor, (0.55, 0.55, 0.6)),
        (ball, (0.8, 0.25, 0.2)),
        (cone, (0.25, 0.6, 0.35)),
        (ring, (0.25, 0.4, 0.8)),
    ):
        height = vtkElevationFilter()  # the point array "Elevation": 0 on the floor, 1 at y = 2
        height.SetInputConnection(source.GetOutputPort())
        height.SetLowPoint(0, 0, 0)
        height.SetHighPoint(0, 2, 0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(height.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*colour)
        actor.GetProperty().SetInterpolationToPhong()
        renderer.AddActor(actor)
    add_sun(renderer, (3, 5, 2))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.5, 3, 6)
    camera.SetFocalPoint(0, 0.5, 0)
    camera.SetClippingRange(2, 14)
    return renderer, window_of(renderer, (columns, rows))


def room(actors, size, sun, background):
    """A renderer of the actors under a sun that casts shadows, lit a little by the camera as well,
    and its off-screen window; keep the window as long as the renderer is drawn."""
    renderer = vtkRenderer()
    renderer.SetBackground(*background)
    for actor in actors:
        renderer.AddActor(actor)
    add_sun(renderer, sun)
    fill = vtkLight()
    fill.SetLightTypeToHeadlight()
    fill.SetIntensity(0.35)
    renderer.AddLight(fill)
    relievo.attach(renderer).ShadowsOn()
    return renderer, window_of(renderer, size)


def picture(renderer):
    """The renderer's picture as rows of colours, the first row at the top."""
    renderer.ResetCameraClippingRange()
    return relievo.picture(relievo.capture(renderer, ["color"]), "color")


def add_sun(renderer, position):
    """Adds white light from a position towards the origin."""
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(*position)
    renderer.AddLight(sun)


def window_of(renderer, size):
    """An off-screen window of the size (columns, rows)."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return window
