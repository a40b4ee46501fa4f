# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of the scenes in tests/scenes."""

import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import (
    vtkConeSource,
    vtkCubeSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)


def sphere(radius=0.5, resolution=16, at=(0, 0, 0)):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetCenter(*at)
    return source


def cone(resolution=12, at=(0, 0, 0)):
    source = vtkConeSource()
    source.SetResolution(resolution)
    source.SetCenter(*at)
    return source


def cube(at=(0, 0, 0)):
    source = vtkCubeSource()
    source.SetCenter(*at)
    return source


def plane(half=1.5, y=-0.6, resolution=4):
    source = vtkPlaneSource()
    source.SetOrigin(-half, y, -half)
    source.SetPoint1(-half, y, half)
    source.SetPoint2(half, y, -half)
    source.SetResolution(resolution, resolution)
    return source


def mapper_of(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    return mapper


def actor(drawn, color=(0.8, 0.7, 0.5), at=(0, 0, 0)):
    """An actor of a source, or of a mapper."""
    shown = vtkActor()
    shown.SetMapper(drawn if drawn.IsA("vtkMapper") else mapper_of(drawn))
    shown.GetProperty().SetColor(*color)
    shown.SetPosition(*at)
    return shown


def separate(*props):
    """Separate actors that show the props' paths, each with its own mapper."""
    found = []
    for prop in props:
        prop.InitPathTraversal()
        path = prop.GetNextPath()
        while path is not None:
            node = path.GetLastNode()
            part = node.GetViewProp()
            shown = actor(part.GetMapper().GetInputAlgorithm(), part.GetProperty().GetColor())
            if node.GetMatrix() is not None:
                matrix = vtkMatrix4x4()
                matrix.DeepCopy(node.GetMatrix())
                shown.SetUserMatrix(matrix)
            found.append(shown)
            path = prop.GetNextPath()
    return found


def renderer_of(*props, background=(0.1, 0.2, 0.3)):
    """A renderer with the props, seen from the upper right."""
    renderer = vtkRenderer()
    for prop in props:
        renderer.AddViewProp(prop)
    renderer.SetBackground(*background)
    look(renderer)
    return renderer


def look(renderer, azimuth=25, elevation=20):
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(azimuth)
    renderer.GetActiveCamera().Elevation(elevation)
    renderer.ResetCameraClippingRange()


def window_of(*renderers, size=(200, 150)):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(*size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    return window


def show(*props, **more):
    """A window with one renderer of the props."""
    return window_of(renderer_of(*props), **more)
