# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A knot of cubes that grow and move aside, entirely on the graphics card.

    20_moving_cubes.py [FOLDER]    writes FOLDER/cubes.png

The filters find the cubes once. vtkRelievoVoxelCubesActor then sizes and places them in the vertex
shader: a transition from small cubes to the knot, and a point that repels cubes. In a
window with an interactor, set Growth or Repeller before each Render.
"""

import time

import numpy
import relievo

import demo_sheet
import scene
from knot import knot, room


def cubes_of(model):
    shell = relievo.vtkRelievoVoxelShell()
    shell.SetInputData(model)
    shell.SetResolution(44)
    shell.SetPadding(4)
    cubes = relievo.vtkRelievoVoxelCubes()
    cubes.SetInputConnection(shell.GetOutputPort())
    cubes.SetInputData(1, model)
    cubes.SetTransition(0.6)
    cubes.InstancedOn()
    cubes.Update()
    actor = relievo.vtkRelievoVoxelCubesActor()
    actor.SetInputConnection(cubes.GetOutputPort())
    actor.SetCellSize(shell.GetOutput().GetSpacing())
    actor.SetTransition(0.6)
    print(f"{cubes.GetOutput().GetNumberOfPoints()} cubes")
    return actor


def main():
    folder = scene.folder()
    cubes = cubes_of(knot())
    renderer, _window = room(cubes)
    pictures = []
    for growth, radius, x in ((0.15, 0, 0), (0.6, 0, 0), (1, 1.8, -2.2), (1, 1.8, 1.8)):
        start = time.perf_counter()
        cubes.SetGrowth(growth)
        cubes.SetRepeller(x, 0.2, 1.0)
        cubes.SetRepellerRadius(radius)
        print(f"set in {1e3 * (time.perf_counter() - start):.2f} ms")
        pictures.append(scene.picture(renderer))
    demo_sheet.write_png(folder / "cubes.png", numpy.concatenate(pictures, axis=1))
    print(folder / "cubes.png")


if __name__ == "__main__":
    main()
