# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A knot in cubes: the cells inside it, colored by its data; then dissolving, and pushed aside.

    18_voxel_cubes.py [FOLDER]    writes FOLDER/voxels.png

vtkRelievoVoxelShell finds the cells, vtkRelievoVoxelCubes gives each a size and the data of the
model's nearest point, and vtkGlyph3DMapper draws them all at once. In the last two pictures the
sizes fall outside, and a place repels the cubes.
"""

import numpy
import relievo
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene

SIZE = (420, 420)


def knot(around=360, across=48, radius=0.62):
    """A tube along a trefoil knot, closed; its point data say where along the knot a point is."""
    turn = numpy.linspace(0, 2 * numpy.pi, around, endpoint=False)

    def line(t):
        x = numpy.sin(t) + 2 * numpy.sin(2 * t)
        y = numpy.cos(t) - 2 * numpy.cos(2 * t)
        return numpy.stack([x, y, -numpy.sin(3 * t)], axis=-1)

    def unit(v):
        return v / numpy.linalg.norm(v, axis=-1, keepdims=True)

    along = unit(line(turn + 1e-4) - line(turn - 1e-4))
    side = unit(numpy.cross(along, (0.0, 0.0, 1.0)))
    up = numpy.cross(side, along)
    angle = numpy.linspace(0, 2 * numpy.pi, across, endpoint=False)[None, :, None]
    ring = numpy.cos(angle) * side[:, None] + numpy.sin(angle) * up[:, None]
    places = (line(turn)[:, None] + radius * ring).reshape(-1, 3)
    i, j = numpy.meshgrid(numpy.arange(around), numpy.arange(across), indexing="ij")
    after, beside = (i + 1) % around, (j + 1) % across
    corners = [(i, j), (after, j), (after, beside), (i, beside)]
    quads = numpy.stack([a * across + b for a, b in corners], axis=-1).reshape(-1, 4)
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(quads.ravel().astype(numpy.int64), deep=True))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    hue = numpy.repeat(turn, across)[:, None] + numpy.array([0, 2.1, 4.2])
    colors = (255 * (0.55 + 0.4 * numpy.cos(hue))).astype(numpy.uint8)
    array = numpy_to_vtk(colors, deep=True)
    array.SetName("color")
    mesh.GetPointData().SetScalars(array)
    return mesh


def cubes_of(shell, model, **settings):
    """An actor of the cubes; settings are vtkRelievoVoxelCubes's."""
    cubes = relievo.vtkRelievoVoxelCubes()
    cubes.SetInputConnection(shell.GetOutputPort())
    cubes.SetInputData(1, model)
    for name, value in settings.items():
        getattr(cubes, f"Set{name}")(value)
    cube = vtkCubeSource()
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(cubes.GetOutputPort())
    mapper.SetSourceConnection(cube.GetOutputPort())
    mapper.SetScaleModeToScaleByVectorComponents()
    mapper.SetScaleArray("scale")
    mapper.OrientOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    cubes.Update()
    return actor, cubes.GetOutput().GetNumberOfPoints()


def picture(actor):
    renderer = vtkRenderer()
    renderer.SetBackground(0.09, 0.1, 0.13)
    renderer.AddActor(actor)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-3, 4, 7)
    renderer.AddLight(sun)
    fill = vtkLight()
    fill.SetLightTypeToHeadlight()
    fill.SetIntensity(0.35)
    renderer.AddLight(fill)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-4, -9, 13)
    camera.SetFocalPoint(0, 0.1, -0.2)
    camera.SetViewAngle(30)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    image = relievo.capture(renderer, ["color"])
    return demo_sheet.picture_of("color", relievo.layer(image, "color"))[0]


def main():
    folder = scene.folder()
    model = knot()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(model)
    smooth = vtkActor()
    smooth.SetMapper(mapper)
    shell = relievo.vtkRelievoVoxelShell()
    shell.SetInputData(model)
    shell.SetResolution(44)
    shell.SetPadding(5)
    shell.Update()
    print(shell.GetReport())
    plain, count = cubes_of(shell, model)
    print(f"{count} cubes are seen")
    falling, _ = cubes_of(shell, model, Transition=0.6)
    pushed, _ = cubes_of(
        shell, model, Repeller=(-2.2, 0.2, 1.0), RepellerRadius=1.8
    )
    pictures = [picture(actor) for actor in (smooth, plain, falling, pushed)]
    demo_sheet.write_png(folder / "voxels.png", numpy.concatenate(pictures, axis=1))
    print(folder / "voxels.png")


if __name__ == "__main__":
    main()
