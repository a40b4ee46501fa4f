# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Features that a user may switch on in a render view: name, and how to switch it on."""

import pv
import stage
from paraview import simple


def of_view(**values):
    """Properties of the view."""

    def switch_on(scene):
        for name, value in values.items():
            setattr(scene.view, name, value)

    return switch_on


def annotations(scene):
    """Colour bar, text, orientation marker, and the axes that are drawn over and beside data."""
    simple.ColorBy(scene.ball_shown, ("POINTS", "Normals", "Z"))
    scene.ball_shown.SetScalarBarVisibility(scene.view, True)
    simple.Show(simple.Text(Text="As it was"), scene.view)
    scene.view.OrientationAxesVisibility = 1
    scene.view.CenterAxesVisibility = 1
    scene.view.CenterOfRotation = [0.0, -2.0, 0.5]


def axes(scene):
    """Axes among the data: around all, around the sphere, polar."""
    scene.view.AxesGrid.Visibility = 1
    scene.view.AxesGrid.YTitle = ""  # titles would stand before the shadow
    scene.ball_shown.DataAxesGrid.GridAxesVisibility = 1
    scene.ball_shown.DataAxesGrid.YTitle = ""
    scene.ground_shown.PolarAxes.Visibility = 1
    for _ in range(3):
        scene.render()  # in which they find their size


def glass(scene, peeling=0):
    """A pane in the light, before the ground: it casts nothing."""
    scene.view.DepthPeeling = peeling
    pane = simple.Box(Center=[1.6, -2.0, 0.7], XLength=1.4, YLength=0.05, ZLength=0.9)
    shown = simple.Show(pane, scene.view)
    shown.Opacity = 0.4
    shown.DiffuseColor = [0.3, 0.9, 0.6]


def materials(scene):
    """Physically based and flat shading, and a background of two colours."""
    scene.ball_shown.Interpolation = "PBR"
    scene.ball_shown.Metallic = 0.4
    scene.ground_shown.Interpolation = "Flat"
    of_view(
        UseColorPaletteForBackground=0,
        BackgroundColorMode="Gradient",
        Background=[0.1, 0.2, 0.4],
        Background2=[0.9, 0.5, 0.2],
    )(scene)


def selection(scene):
    """Selected cells of the sphere, drawn as ParaView does."""
    scene.render()
    simple.SelectSurfaceCells(Rectangle=[120, 100, 150, 130], View=scene.view)


def wires(scene, hidden=0):
    """An outline, which casts nothing, and a wire frame whose shadow misses the ground."""
    scene.view.HiddenLineRemoval = hidden
    for kind, place in (("Outline", [-1.0, -2.0, 0.5]), ("Wireframe", [3.1, 2.0, 1.0])):
        shown = simple.Show(simple.Box(Center=place), scene.view)
        shown.Representation = kind


# name: how it is switched on, and how far in pixels it carries one pixel's colour.
FEATURES = {
    "nothing": (lambda scene: None, 0),
    "FXAA": (of_view(UseFXAA=1), 3),
    "ambient occlusion": (of_view(UseAmbientOcclusion=1), 3),
    "tone mapping": (of_view(UseToneMapping=1), 0),
    "glass": (glass, 0),
    "depth peeling": (lambda scene: glass(scene, peeling=1), 0),
    "8 samples": (of_view(MultiSamples=8), 1),
    "parallel projection": (of_view(CameraParallelProjection=1, CameraParallelScale=2.5), 0),
    "annotations": (annotations, 0),
    "axes": (axes, 0),
    "materials": (materials, 0),
    "selection": (selection, 0),
    "wires": (wires, 0),
    "hidden lines": (lambda scene: wires(scene, hidden=1), 0),
}


def make(name, size=stage.SIZE):
    """A stage in a new view with that feature on. Earlier content is removed."""
    pv.clear()
    scene = stage.Stage(size)
    FEATURES[name][0](scene)
    return scene
