# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A valley at dawn: fog along its river, from points, and the fog's transmittance.

    13_fog_valley.py [FOLDER]    writes FOLDER/fog.png and FOLDER/fog_layer.png

The land is a grid of heights; 900 points along the river have a radius and a density each. The
second picture shows the layer `fog`: white where all light passes.
"""

import math

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkPolyDataNormals
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene

SIZE = (1200, 600)
SPHERES = 900


def river(y):
    """The river's position, from south to north."""
    return 2.2 * numpy.sin(0.45 * y) + 0.8 * numpy.sin(1.1 * y + 1)


def height(x, y):
    away = numpy.abs(x - river(y))
    hills = 0.25 * numpy.sin(1.7 * x + 0.6 * y) + 0.2 * numpy.sin(2.3 * y - 0.9 * x)
    rough = 0.05 * numpy.sin(7 * x + 3 * y) * numpy.sin(6 * y - 2 * x)
    return 1.9 * (1 - numpy.exp(-((away / 2.6) ** 2))) * (1 + hills) + rough * away / (1 + away)


def land():
    grid = vtkPlaneSource()
    grid.SetOrigin(-14, -6, 0)
    grid.SetPoint1(14, -6, 0)
    grid.SetPoint2(-14, 26, 0)
    grid.SetResolution(420, 480)
    grid.Update()
    surface = grid.GetOutput()
    places = vtk_to_numpy(surface.GetPoints().GetData())
    places[:, 2] = height(places[:, 0], places[:, 1])
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.36, 0.42, 0.26)
    actor.GetProperty().SetInterpolationToPhong()
    return actor


def mist():
    """Points along the river with radii and densities, thin at the edges."""
    random = numpy.random.default_rng(5)
    y = random.uniform(-3, 26, SPHERES)
    aside = random.normal(0, 0.8, SPHERES)
    x = river(y) + aside
    places = numpy.stack([x, y, height(x, y) + random.uniform(-0.4, 0.1, SPHERES)], axis=-1)
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data.SetPoints(points)
    for name, values in (
        ("radius", random.uniform(0.5, 1.3, SPHERES)),
        ("density", 0.07 * numpy.exp(-(aside**2)) * random.uniform(0.3, 1, SPHERES)),
    ):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def main():
    folder = scene.folder()
    renderer = vtkRenderer()
    renderer.AddActor(land())
    renderer.SetBackground(0.95, 0.72, 0.55)
    renderer.SetBackground2(0.35, 0.5, 0.75)
    renderer.GradientBackgroundOn()
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-6, -3, 4.5)
    sun.SetColor(1, 0.85, 0.7)
    renderer.AddLight(sun)
    sky = vtkLight()
    sky.SetLightTypeToSceneLight()
    sky.SetPosition(2, -2, 9)
    sky.SetColor(0.6, 0.75, 1)
    sky.SetIntensity(0.45)
    renderer.AddLight(sky)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1.5, -4.5, 4.2)
    camera.SetFocalPoint(0.3, 8, 0.2)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(34)
    camera.SetClippingRange(1, 60)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    frame.GetShadowStage().SetLightCasts(sky, False)

    relievo.fog(renderer, mist(), color=(0.85, 0.8, 0.78))
    image = relievo.capture(renderer, ["color", "fog"])
    passes = relievo.layer(image, "fog")
    least = passes.min()
    print(
        f"{(passes < 0.99).mean():.0%} of the pixels have fog; the thickest lets {least:.1%} "
        f"through, an optical depth of {-math.log(least):.1f}"
    )
    for name, file in (("color", "fog.png"), ("fog", "fog_layer.png")):
        picture, _ = demo_sheet.picture_of(name, relievo.layer(image, name))
        demo_sheet.write_png(folder / file, picture)
        print(folder / file)


if __name__ == "__main__":
    main()
