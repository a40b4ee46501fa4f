# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A knot in cubes: the cells inside it, colored by its data; then dissolving, and pushed aside.

    18_voxel_cubes.py [FOLDER]    writes FOLDER/voxels.png

vtkRelievoVoxelShell finds the cells, vtkRelievoVoxelCubes gives each a size and the data of the
model's nearest point, and vtkGlyph3DMapper draws them all at once. In the last two pictures, cubes
outside the knot shrink, and a point repels the cubes.
"""

import numpy
import relievo
from relievo.vtk.vtkFiltersSources import vtkCubeSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkPolyDataMapper,
)

import demo_sheet
import scene
from knot import knot, room


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


def picture_of(actor):
    renderer, _window = room(actor)
    return scene.picture(renderer)


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
    pictures = [picture_of(actor) for actor in (smooth, plain, falling, pushed)]
    demo_sheet.write_png(folder / "voxels.png", numpy.concatenate(pictures, axis=1))
    print(folder / "voxels.png")


if __name__ == "__main__":
    main()
