# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke above buildings under a low sun: its shadow lies on roofs, walls and ground.

    31_smoke.py [FOLDER]    writes FOLDER/smoke.png
"""

import numpy
import relievo
from relievo.vtk.vtkIOGeometry import vtkOBJReader
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import scene

SIZE = (960, 540)
POINTS = 96  # of the smoke along its longest side


def buildings():
    reader = vtkOBJReader()
    reader.SetFileName(scene.data("buildings.obj"))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.RotateX(-90)  # z is up in the file
    actor.GetProperty().SetColor(0.78, 0.72, 0.66)
    return actor


def smoke(start, length):
    """A plume that rises from a place and drifts along x: puffs that grow and thin out."""
    spacing = length / (POINTS - 1)
    shape = (POINTS // 2, POINTS * 2 // 3, POINTS)
    z, y, x = numpy.mgrid[0:shape[0], 0:shape[1], 0:shape[2]] * spacing
    z -= shape[0] * spacing / 2
    random = numpy.random.default_rng(7)
    density = numpy.zeros(shape)
    for _ in range(260):
        age = random.uniform(0, 0.85) ** 1.3
        radius = length * (0.022 + 0.06 * age)
        wander = random.normal(0, (0.008 + 0.055 * age) * length, 3)
        place = (age * length + 0.06 * length + wander[0],
                 length * (0.02 + 0.4 * age**0.7) + wander[1] * 0.7, wander[2])  # fmt: skip
        away = (x - place[0]) ** 2 + (y - place[1]) ** 2 + (z - place[2]) ** 2
        density += numpy.exp(-away / (0.4 * radius**2)) / (0.5 + 3 * age)
    origin = (start[0] - 0.04 * length, start[1], start[2] - shape[0] * spacing / 2)
    return scene.volume(
        scene.image(density.astype("f4"), (spacing,) * 3, origin),
        [(0, 0), (0.05, 0), (0.5, 0.15), (2.5, 0.7)],
        [(0, 0.6, 0.58, 0.56), (1, 0.85, 0.83, 0.8), (3, 0.55, 0.53, 0.52)],
        unit=0.03 * length)  # fmt: skip


def main():
    folder = scene.folder()
    town = buildings()
    low, high = numpy.reshape(town.GetBounds(), (3, 2)).T
    width = max(high[0] - low[0], high[2] - low[2])
    middle = (low + high) / 2
    floor = scene.ground(6 * width, low[1], (0.75, 0.78, 0.7))
    floor.GetProperty().SetAmbient(0.25)
    town.GetProperty().SetAmbient(0.1)
    town.GetProperty().SetDiffuse(0.8)
    renderer, window = scene.room([floor, town], SIZE, (-0.35, 0.55, 1.0), (0.62, 0.74, 0.88))
    start = (low[0] + 0.28 * (high[0] - low[0]), high[1] * 0.72, middle[2])
    renderer.AddVolume(smoke(start, 0.95 * width))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle[0] + 0.05 * width, middle[1] + 0.08 * width, middle[2])
    camera.SetPosition(*(middle + width * numpy.array([-0.25, 0.75, 1.45])))
    camera.SetViewUp(0, 1, 0)
    renderer.ResetCameraClippingRange()
    relievo.screenshot(renderer, folder / "smoke.png")
    print(folder / "smoke.png")


if __name__ == "__main__":
    main()
