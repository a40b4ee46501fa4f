# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of tools/compare-frames of filters and actors: filterScenes.py MADE DATA NAME."""

import sys

import numpy
import relievo
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkRenderer

from drawing import (
    DATA,
    NORMALS,
    actor_of,
    grab,
    keep,
    read,
    read_picture,
    room,
    save,
    see,
    window_of,
)


def relief():
    """Material maps on the ground, by every method, with and without self-shadowing."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(read("ground"))
    laid = relievo.vtkRelievoTextureCoordinates()
    laid.SetInputConnection(triangles.GetOutputPort())
    tangents = relievo.vtkRelievoTangents()
    tangents.SetInputConnection(laid.GetOutputPort())
    tangents.Update()
    keep(tangents.GetOutput(), "tangents")
    normals = relievo.vtkRelievoHeightsToNormals()
    normals.SetInputData(read_picture("heights.png"))
    normals.Update()
    save(normals.GetOutput(), "normals")
    actor = actor_of(tangents.GetOutput(), (0.7, 0.7, 0.7))
    renderer, window = room("things", actors=[actor])
    material = relievo.vtkRelievoMaterial()
    material.SetHeightMap(read_picture("heights.png"))
    material.SetHeightScale(0.15)
    material.Attach(actor)
    for method in range(5):
        material.SetReliefMethod(method)
        material.SetSelfShadow(method % 2 == 0)
        material.SetDepthCorrection(method > 2)
        save(relievo.capture(renderer, NORMALS), f"method-{method}")
    relievo.attach(renderer).ShadowsOn()
    material.SetNormalMap(read_picture("normals.png"))
    material.SetClipAtBorders(True)
    grab(window)


def blocks():
    random = numpy.random.default_rng(4)
    image = vtkImageData()
    image.SetDimensions(13, 11, 9)
    labels = numpy_to_vtk(numpy.uint8(random.integers(0, 4, 12 * 10 * 8)), deep=True)
    labels.SetName("labels")
    image.GetCellData().SetScalars(labels)
    maker = relievo.vtkRelievoSmoothBlocks()
    maker.SetInputData(image)
    for rigid in (False, True):
        maker.TextureCoordinatesOn()
        maker.SetNoiseAmplitude(0.3)
        if rigid:
            maker.AddRigidLabel(2)
            maker.SeamsOff()
        maker.Update()
        keep(maker.GetOutput(), f"blocks-{rigid}")
    see([actor_of(maker.GetOutput(), (0.5, 0.6, 0.4))])


def voxels():
    shell = relievo.vtkRelievoVoxelShell()
    shell.SetInputData(read("things"))
    shell.SetResolution(24)
    shell.Update()
    print(shell.GetReport())
    keep(shell.GetOutput(), "shell")
    cubes = relievo.vtkRelievoVoxelCubes()
    cubes.SetInputConnection(shell.GetOutputPort())
    cubes.SetTransition(0.6)
    cubes.Update()
    keep(cubes.GetOutput(), "cubes")
    cubes.InstancedOn()
    moving = relievo.vtkRelievoVoxelCubesActor()
    moving.SetInputConnection(cubes.GetOutputPort())
    cubes.Update()
    moving.SetCellSize(shell.GetOutput().GetSpacing())
    moving.SetTransition(0.6)
    moving.SetGrowth(0.7)
    moving.SetRepeller(0, 0.5, 1)
    moving.SetRepellerRadius(0.8)
    see([moving])


def particles():
    maker = relievo.vtkRelievoSurfaceParticles()
    maker.SetInputData(read("things"))
    maker.SetNumberOfParticles(900)
    maker.SetNoiseSpeed(0.05)
    maker.SetNumberOfSteps(20)
    maker.OrientationsOn()
    for time in (0, 7, 20):
        maker.UpdateTimeStep(time)
        keep(maker.GetOutput(), f"time-{time}")
    box = vtkCubeSource()
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(maker.GetOutputPort())
    mapper.SetSourceConnection(box.GetOutputPort())
    mapper.SetScaleFactor(0.05)
    mapper.SetOrientationArray("orientation")
    mapper.SetOrientationModeToQuaternion()
    glyphs = vtkActor()
    glyphs.SetMapper(mapper)
    see([actor_of(read("things"), (0.3, 0.3, 0.3)), glyphs])


def caves():
    maker = relievo.vtkRelievoCaves()
    maker.SetSize(40, 32, 24)
    maker.SetSeed(5)
    maker.SetTunnelWidth(6)
    maker.SetScale(30)
    for content in (maker.MASK, maker.DENSITY, maker.LABELS):
        maker.SetContent(content)
        maker.Update()
        keep(maker.GetOutput(), f"caves-{content}")
    smooth = relievo.vtkRelievoSmoothBlocks()
    smooth.SetInputConnection(maker.GetOutputPort())
    smooth.CloseBordersOff()
    smooth.Update()
    see([actor_of(smooth.GetOutput(), (0.6, 0.5, 0.4))])


def skinned():
    reader = relievo.vtkRelievoModelReader()
    reader.SetFileName(str(DATA / "models/X/Testwuson.X"))
    reader.SetPose(reader.POSE_REST)
    reader.Update()
    actors = []
    for i in range(reader.GetOutput().GetNumberOfBlocks()):
        actor = relievo.vtkRelievoSkinnedActor()
        actor.SetInputData(reader.GetOutput().GetBlock(i))
        actor.SetSkeletonConnection(reader.GetOutputPort(1))
        actors.append(actor)
    renderer = vtkRenderer()
    for actor in actors:
        renderer.AddActor(actor)
    window = window_of(renderer, (200, 200))
    relievo.attach(renderer).ShadowsOn()
    for time in (0, 0.4, 0.9):
        reader.UpdateTimeStep(time)
        renderer.ResetCamera()
        save(relievo.capture(renderer, NORMALS), f"time-{time}")
    grab(window)


def views():
    """Depth from six sides, and the shell from these views."""
    renderer, window = room("things", size=(200, 200))
    seen = relievo.vtkRelievoDepthViews()
    seen.SetRenderer(renderer)
    seen.SetResolution(60)
    seen.Update()
    sides = seen.GetOutput()
    for i in range(sides.GetNumberOfBlocks()):
        save(sides.GetBlock(i), f"side-{i}")
    shell = relievo.vtkRelievoVoxelShell()
    shell.SetInputConnection(1, seen.GetOutputPort())
    shell.SetBounds(*renderer.ComputeVisiblePropBounds())
    shell.SetResolution(24)
    shell.Update()
    keep(shell.GetOutput(), "shell")
    grab(window)


def points():
    renderer, window = room("ground", "things")
    image = relievo.capture(renderer, ["depth", "normal", "albedo", "actor", "zone"])
    window.Render()
    keep(relievo.depth_to_points(image), "points")
    relievo.write_exr("depth.exr", image)
    keep(relievo.depth_to_points(relievo.read_exr("depth.exr")), "again")


if __name__ == "__main__":
    globals()[sys.argv[3]]()
