# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps, fog, glass and a marker in ParaView: a hall at night, without and with the plugin.

    pvbatch 17_paraview_hall.py [FOLDER]    writes FOLDER/paraview_hall.png

Run it with ParaView's own pvbatch or pvpython. It loads the plugin from the folder
RELIEVO_PLUGIN_PATH (default: build/release/plugin/Relievo beside this folder).
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter

import paraview_sheet

WIDTH, LENGTH, HEIGHT = 12.0, 40.0, 7.0  # of the hall, in metres
BAYS = 8
rng = numpy.random.default_rng(3)


def points(places, **arrays):
    """Places, with an array of each name, as a source of ParaView's pipeline."""
    data, at = vtkPolyData(), vtkPoints()
    at.SetData(numpy_to_vtk(numpy.array(places, dtype=float), deep=True))
    data.SetPoints(at)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    vertices = vtkVertexGlyphFilter()  # ParaView draws cells
    vertices.SetInputData(data)
    vertices.Update()
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(vertices.GetOutput())
    source.UpdatePipeline()
    return source


def box(center, lengths):
    return simple.Box(Center=list(center), XLength=lengths[0], YLength=lengths[1],
                      ZLength=lengths[2])  # fmt: skip


def pillar(x, y):
    upright = simple.Transform(Input=simple.Cylinder(Radius=0.45, Height=HEIGHT, Resolution=40))
    upright.Transform.Rotate = [90, 0, 0]
    upright.Transform.Translate = [x, y, HEIGHT / 2]
    return upright


def hall():
    """Walls, pillars and a pedestal with a ball, by name."""
    pillars = [pillar(side * 0.3 * WIDTH, (bay + 0.5) * LENGTH / BAYS)
               for bay in range(BAYS) for side in (-1, 1)]  # fmt: skip
    parts = {
        "stone": [box((0, LENGTH / 2, -0.05), (WIDTH, LENGTH, 0.1)),
                  box((0, LENGTH / 2, HEIGHT), (WIDTH, LENGTH, 0.1)),
                  box((-WIDTH / 2, LENGTH / 2, HEIGHT / 2), (0.1, LENGTH, HEIGHT)),
                  box((WIDTH / 2, LENGTH / 2, HEIGHT / 2), (0.1, LENGTH, HEIGHT)),
                  box((0, LENGTH, HEIGHT / 2), (WIDTH, 0.1, HEIGHT)), *pillars],
        "bronze": [box((0, 9, 0.5), (1.6, 1.6, 1.0)),
                   simple.Sphere(Center=[0, 9, 1.9], Radius=0.9, ThetaResolution=64,
                                 PhiResolution=64)],
        "glass": [box((2.3, 7.5, 1.5), (2.6, 0.06, 3.0))],
    }  # fmt: skip
    # One source for each kind: showing a source takes ParaView longer than drawing all of them.
    return {name: simple.AppendGeometry(Input=each) for name, each in parts.items()}


def make_view(parts):
    """The hall in its own view, dimly lit; returns the representations by name."""
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground, view.Background = 0, [0.0, 0.0, 0.0]
    view.UseFXAA = 0  # would smooth surfaces behind glass together with the glass
    view.CameraPosition, view.CameraFocalPoint = [-2.4, -1.0, 2.1], [0.4, 12, 1.9]
    view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], 55
    colours = {"stone": [0.62, 0.58, 0.52], "bronze": [0.75, 0.5, 0.28], "glass": [0.5, 0.8, 0.75]}
    shown = {name: simple.Show(part, view) for name, part in parts.items()}
    for name, part in shown.items():
        part.AmbientColor = part.DiffuseColor = colours[name]
    shown["bronze"].Specular, shown["bronze"].SpecularPower = 0.6, 30
    shown["glass"].Opacity = 0.35
    return view


def light(view):
    """A lamp at each pillar and 150 fireflies; mist on the floor; a ring on the floor."""
    view.KeyLightIntensity = 0.25
    bays = (numpy.arange(BAYS) + 0.5) * LENGTH / BAYS
    sconces = [(side * 0.225 * WIDTH, y, 3.4) for y in bays for side in (-1, 1)]
    lamps = simple.Show(points(sconces), view)
    lamps.Representation, lamps.PointSize = "Points", 5
    lamps.AmbientColor = lamps.DiffuseColor = [1.0, 0.85, 0.6]
    lamps.Ambient = 1.0
    lamps.RelievoLamps, lamps.RelievoLampsFalloff = 1, "Inverse Square"
    lamps.RelievoLampsRadius, lamps.RelievoLampsIntensity = 9.0, 1.6
    lamps.RelievoLampsColor = [1.0, 0.66, 0.33]
    places = rng.uniform((-WIDTH / 2, 3, 0.2), (WIDTH / 2, LENGTH, 3.0), (150, 3))
    flies = simple.Show(points(places), view)
    flies.Representation = "Points"
    flies.PointSize, flies.Ambient = 3, 1.0
    flies.AmbientColor = flies.DiffuseColor = [0.7, 1.0, 0.5]
    flies.RelievoLamps, flies.RelievoLampsRadius = 1, 1.2
    flies.RelievoLampsIntensity, flies.RelievoLampsColor = 0.5, [0.55, 1.0, 0.35]
    banks = rng.uniform((-WIDTH / 2, 8, -0.6), (WIDTH / 2, LENGTH, 0.2), (60, 3))
    mist = simple.Show(points(banks, radius=rng.uniform(1.0, 2.6, 60)), view)
    mist.Representation, mist.Opacity = "Points", 0.0
    mist.RelievoFog, mist.RelievoFogDensity = 1, 0.09
    mist.RelievoFogColor = [0.16, 0.2, 0.24]
    mark = simple.Show(points([(-1.2, 5, 0)]), view)
    mark.Representation, mark.Opacity = "Points", 0.0
    mark.RelievoMarkers, mark.RelievoMarkersShape = 1, "Ring"
    mark.RelievoMarkersRadius, mark.RelievoMarkersWidth = 0.7, 0.08
    mark.RelievoMarkersColor = [0.1, 0.7, 1.0]
    view.RelievoStageTone, view.RelievoStageToneOperator = 1, "Reinhard"
    view.RelievoStageToneExposure, view.RelievoStageToneWhite = 0.4, 3.0


def main():
    folder, plugin, _ = paraview_sheet.words()
    # Before the first view is made; in a client-server session also once with remote=True.
    simple.LoadPlugin(str(plugin), remote=False, ns=globals())
    parts = hall()
    plain, lit = make_view(parts), make_view(parts)
    light(lit)
    paraview_sheet.save(folder / "paraview_hall.png", [plain, lit])


main()
