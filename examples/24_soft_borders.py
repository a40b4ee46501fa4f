# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grass and rock of labelled blocks, with a hard border and a soft one.

    24_soft_borders.py [FOLDER]    writes FOLDER/soft_borders.png

vtkRelievoSmoothBlocks gives each point the share of each label (MaterialWeights). VTK's mapper
hands the shares to the shader, which mixes the labels' textures by them.
"""

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk
from relievo.vtk.vtkCommonDataModel import vtkDataObject, vtkImageData
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

import demo_sheet
import scene

GRASS, ROCK = 1, 2
COLUMNS, TALL = 30, 9


def ground():
    """An image of labels on its cells; 0 is air."""
    y, x = numpy.mgrid[:COLUMNS, :COLUMNS]
    height = 4 + 2.6 * numpy.sin(x / 4.3) * numpy.cos(y / 5.1) + 0.05 * x
    labels = numpy.where(numpy.arange(TALL)[:, None, None] < height, GRASS, 0)
    labels[(labels == GRASS) & (x + 4 * numpy.sin(y / 3.1) > 15)] = ROCK
    image = vtkImageData()
    image.SetDimensions(COLUMNS + 1, COLUMNS + 1, TALL + 1)
    cells = numpy_to_vtk(labels.astype(numpy.uint8).ravel(), deep=True)
    cells.SetName("labels")
    image.GetCellData().SetScalars(cells)
    return image


def grains(colour, varies):
    random = numpy.random.default_rng(3).random((32, 32, 1))
    return scene.texture(numpy.array(colour) * (1 - varies * random.repeat(4, 0).repeat(4, 1)))


def actor(image, soft):
    blocks = relievo.vtkRelievoSmoothBlocks()
    blocks.SetInputData(image)
    blocks.TextureCoordinatesOn()
    blocks.SetTileSize(4)
    blocks.MaterialWeightsOn()
    for label in (GRASS, ROCK):
        blocks.AddWeightedLabel(label)  # "weights" has a component for each, in this order
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(blocks.GetOutputPort())
    mapper.ScalarVisibilityOff()
    points = vtkDataObject.FIELD_ASSOCIATION_POINTS
    mapper.MapDataArrayToVertexAttribute("shares", "weights", points, -1)
    made = vtkActor()
    made.SetMapper(mapper)
    made.GetProperty().SetAmbient(0)
    made.GetProperty().SetTexture("grass", grains((0.40, 0.60, 0.22), 0.5))
    made.GetProperty().SetTexture("rock", grains((0.66, 0.62, 0.58), 0.4))
    shader = made.GetShaderProperty()
    for tag, text in (
        ("TCoord::Dec", "in vec2 shares;\nout vec2 sharesVS;"),
        ("TCoord::Impl", "sharesVS = shares;"),
    ):
        shader.AddVertexShaderReplacement(f"//VTK::{tag}", True, f"//VTK::{tag}\n{text}", False)
    share = "sharesVS.y" if soft else "step(0.5, sharesVS.y)"
    mixed = f"mix(texture(grass, tcoordVCVSOutput), texture(rock, tcoordVCVSOutput), {share})"
    for tag, text in (
        ("TCoord::Dec", "//VTK::TCoord::Dec\nin vec2 sharesVS;"),
        ("Color::Impl", f"//VTK::Color::Impl\ndiffuseColor = {mixed}.rgb;"),
        ("TCoord::Impl", ""),  # VTK would multiply by both textures
    ):
        shader.AddFragmentShaderReplacement(f"//VTK::{tag}", True, text, False)
    return made


def main():
    folder = scene.folder()
    image = ground()
    pictures = []
    for soft in (False, True):
        renderer = vtkRenderer()
        renderer.AddActor(actor(image, soft))
        renderer.SetBackground(0.74, 0.83, 0.90)
        scene.add_sun(renderer, (-5, -9, 8))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(15, -16, 24)
        camera.SetFocalPoint(15, 13, 3)
        camera.SetViewUp(0, 0, 1)
        _window = scene.window_of(renderer, (600, 420))
        relievo.attach(renderer)
        pictures.append(scene.picture(renderer))
    demo_sheet.write_png(folder / "soft_borders.png", numpy.concatenate(pictures, axis=1))
    print(folder / "soft_borders.png")


if __name__ == "__main__":
    main()
