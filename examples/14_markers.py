# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Balloons over hills: rings on the ground around stations, a glow, and soft shadows without maps.

    14_markers.py [FOLDER]    writes FOLDER/markers.png and FOLDER/markers_layer.png

The stations are points with the arrays `radius` and `color`; one of the huts is selected, and has a
ring around its box; each balloon casts a blob shadow on the surface below. The second picture
shows the layer `marker`: the share of each pixel that markers cover.
"""

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkPolyDataNormals
from relievo.vtk.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
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
UP = (0, 0, 1)


def height(x, y):
    hills = 0.7 * numpy.sin(0.55 * x + 0.3) * numpy.cos(0.45 * y)
    return hills + 0.25 * numpy.sin(1.3 * x + 0.8 * y)


def shown(renderer, source, color, place=(0, 0, 0), turn=0.0, stretch=(1, 1, 1)):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(*place)
    actor.RotateZ(turn)
    actor.SetScale(*stretch)
    actor.GetProperty().SetColor(*color)
    renderer.AddActor(actor)
    return actor


def land():
    grid = vtkPlaneSource()
    grid.SetOrigin(-9, -5, 0)
    grid.SetPoint1(9, -5, 0)
    grid.SetPoint2(-9, 13, 0)
    grid.SetResolution(300, 300)
    grid.Update()
    surface = grid.GetOutput()
    places = vtk_to_numpy(surface.GetPoints().GetData())
    places[:, 2] = height(places[:, 0], places[:, 1])
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    return normals


def stations():
    """Points on the ground, each with a radius and a colour."""
    x = numpy.array([-4.6, -1.6, 2.2, 5.2, -3.2, 0.6, 4.4])
    y = numpy.array([1.5, -0.6, 0.4, 2.6, 5.6, 3.4, 6.6])
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([x, y, height(x, y)], axis=-1), deep=True))
    data.SetPoints(points)
    warm = numpy.linspace(0, 1, len(x))
    for name, values in (
        ("radius", 0.6 + 0.6 * warm),
        ("color", numpy.stack([warm, 0.6 * numpy.ones(len(x)), 1 - warm], axis=-1)),
    ):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def main():
    folder = scene.folder()
    renderer = vtkRenderer()
    renderer.SetBackground(0.75, 0.82, 0.9)
    renderer.SetBackground2(0.45, 0.6, 0.85)
    renderer.GradientBackgroundOn()
    shown(renderer, land(), (0.55, 0.62, 0.4))
    ball = vtkSphereSource()
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    balloons = []
    for i, (x, y, above) in enumerate(
        ((-3.2, 0.2, 1.0), (0.3, 1.3, 0.8), (3.4, 3.6, 1.4), (-0.9, 5.2, 1.7), (6.2, 0.2, 0.9))
    ):
        color = ((0.85, 0.3, 0.2), (0.9, 0.75, 0.2), (0.3, 0.45, 0.8))[i % 3]
        place = (x, y, height(x, y) + above)
        balloons.append(shown(renderer, ball, color, place, 0, (0.9, 0.9, 1.1)))
    huts = []
    for x, y, turn in ((-5.8, 3.6, 20), (-1.3, 2.7, 35), (5.6, 4.4, -15)):
        place = (x, y, height(x, y) + 0.2)
        huts.append(shown(renderer, vtkCubeSource(), (0.6, 0.5, 0.45), place, turn, (1, 0.6, 0.6)))
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-3, -4, 7)
    renderer.AddLight(sun)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -7.5, 7.5)
    camera.SetFocalPoint(0.4, 2.2, 0)
    camera.SetViewUp(*UP)
    camera.SetViewAngle(30)
    camera.SetClippingRange(1, 40)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)

    relievo.markers(renderer, balloons, shape="shadow", radius=0.1, opacity=0.9, up=UP)
    relievo.markers(renderer, stations(), width=0.12, opacity=0.9)
    relievo.markers(renderer, stations(), shape="glow", opacity=0.35)
    relievo.markers(renderer, huts[1], radius=0.25, width=0.35, color=(1, 1, 1), opacity=1)
    image = relievo.capture(renderer, ["color", "marker"])
    covered = relievo.layer(image, "marker")
    print(f"{(covered > 0.01).mean():.0%} of the pixels are marked or in a shadow")
    for name, file in (("color", "markers.png"), ("marker", "markers_layer.png")):
        picture, _ = demo_sheet.picture_of(name, relievo.layer(image, name))
        demo_sheet.write_png(folder / file, picture)
        print(folder / file)


if __name__ == "__main__":
    main()
