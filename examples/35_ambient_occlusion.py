# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A motorbike in even light, without and with ambient occlusion, and the share of the sky that each
of its surfaces sees.

    35_ambient_occlusion.py [FOLDER]    writes FOLDER/ambient.png

Needs motorBike.obj in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data writes it.
"""

import numpy
import relievo
from relievo.vtk.vtkFiltersSources import vtkDiskSource
from relievo.vtk.vtkIOGeometry import vtkOBJReader
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

import demo_sheet
import scene

SIZE = (480, 400)  # of each of the three pictures
FINER = 2  # they are drawn so many times larger, and shrunk: layers have one sample per pixel
GAP = 8
LEFT, BEHIND, UP = -0.7, -1.0, 0.45  # from which the motorbike is seen


def add(renderer, source, colour):
    """Adds a mesh in even light: almost all of it is VTK's ambient term."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetAmbient(0.8)
    actor.GetProperty().SetDiffuse(0.2)
    renderer.AddActor(actor)
    return actor


def make():
    """The renderer of the motorbike on a disc, and its window."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.93, 0.94, 0.96)
    reader = vtkOBJReader()
    reader.SetFileName(scene.data("motorBike.obj"))
    bike = add(renderer, reader, (0.86, 0.87, 0.9))
    left, right, front, back, low, high = bike.GetBounds()
    middle = numpy.array([left + right, front + back, low + high]) / 2
    length = right - left
    disc = vtkDiskSource()
    disc.SetInnerRadius(0)
    disc.SetOuterRadius(1.6 * length)
    disc.SetCircumferentialResolution(96)
    add(renderer, disc, (0.92, 0.92, 0.92)).SetPosition(middle[0], middle[1], low)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + 1.7 * length * numpy.array([LEFT, BEHIND, UP])))
    camera.SetViewUp(0, 0, 1)
    return renderer, scene.window_of(renderer, [FINER * side for side in SIZE])


def main():
    folder = scene.folder()
    renderer, window = make()
    pictures = [scene.picture(renderer)]
    relievo.stage(renderer, "ambient")
    pictures.append(scene.picture(renderer))
    share = relievo.layer(relievo.capture(renderer, ["ambient"]), "ambient")
    print(f"the surface that sees least of the sky sees {share.min():.2f} of it")
    pictures.append(numpy.repeat(255 * share[..., None], 3, axis=2))
    pictures = [numpy.round(demo_sheet.shrunk(each, FINER)).astype("u1") for each in pictures]
    white = numpy.full((SIZE[1], GAP, 3), 255, "u1")
    sheet = [pictures[0], white, pictures[1], white, pictures[2]]
    demo_sheet.write_png(folder / "ambient.png", numpy.concatenate(sheet, axis=1))
    print(folder / "ambient.png")
    del window


if __name__ == "__main__":
    main()
