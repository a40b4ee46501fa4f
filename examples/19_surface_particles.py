# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Particles streaming over a knot, and pillars standing on it.

    19_surface_particles.py [FOLDER]    writes FOLDER/particles.png

vtkRelievoSurfaceParticles moves the particles by the curl of noise and holds them on the knot's
depth maps; it has time steps, like a reader of a series. In the last picture vtkGlyph3DMapper
turns a pillar to each particle's normal and velocity.
"""

import numpy
import relievo
from relievo.vtk.vtkFiltersSources import vtkCubeSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkGlyph3DMapper,
    vtkPolyDataMapper,
)

import demo_sheet
import scene
from knot import knot, room

COLORS = ((0.0, 0.20, 0.45, 0.95), (0.4, 0.98, 0.62, 0.18), (1.0, 1.0, 0.97, 0.75))


def particles_on(model, count):
    particles = relievo.vtkRelievoSurfaceParticles()
    particles.SetInputData(model)
    particles.SetNumberOfParticles(count)
    particles.SetNoiseSpeed(0.05)
    particles.SetNoiseScale(0.9)
    particles.SetNumberOfSteps(60)
    particles.OrientationsOn()
    return particles


def glyphs(particles, length, width):
    """An actor with a box for each particle, its longest side along the normal."""
    box = vtkCubeSource()
    box.SetXLength(length)
    box.SetYLength(2.5 * width)
    box.SetZLength(width)
    box.SetCenter(length / 2, 0, 0)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(particles.GetOutputPort())
    mapper.SetSourceConnection(box.GetOutputPort())
    mapper.ScalingOff()
    mapper.SetOrientationArray("orientation")
    mapper.SetOrientationModeToQuaternion()
    speed = vtkColorTransferFunction()
    for value, *color in COLORS:
        speed.AddRGBPoint(0.12 * value, *color)
    speed.SetVectorModeToMagnitude()
    mapper.SetLookupTable(speed)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("velocity")
    mapper.SetColorModeToMapScalars()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def main():
    folder = scene.folder()
    model = knot()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(model)
    mapper.ScalarVisibilityOff()
    body = vtkActor()
    body.SetMapper(mapper)
    body.GetProperty().SetColor(0.24, 0.26, 0.30)
    pictures = []
    shown = ((12000, 0.03, 0.03, 0), (12000, 0.03, 0.03, 60), (2500, 0.4, 0.03, 60))
    for count, length, width, time in shown:
        particles = particles_on(model, count)
        particles.UpdateTimeStep(time)
        print(f"{particles.GetOutput().GetNumberOfPoints()} particles at time {time}")
        renderer, _window = room(body, glyphs(particles, length, width))
        pictures.append(scene.picture(renderer))
    demo_sheet.write_png(folder / "particles.png", numpy.concatenate(pictures, axis=1))
    print(folder / "particles.png")


if __name__ == "__main__":
    main()
