# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""An island of labelled blocks as a smooth, textured surface, with huts that stay cubes.

    15_blocks.py [FOLDER]    writes FOLDER/blocks.png

Each block has a label. One filter makes the surface, with texture coordinates without distortion;
water stays level, and huts rigid. Prints the time.
"""

import time

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk
from relievo.vtk.vtkCommonDataModel import vtkDataObject, vtkImageData
from relievo.vtk.vtkFiltersCore import vtkThreshold
from relievo.vtk.vtkFiltersGeometry import vtkGeometryFilter
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkDataSetMapper,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene

SIZE = (1280, 720)
BLOCKS, TALL, SEA = 144, 44, 9  # blocks each way, upwards, and of water
SAND, GRASS, ROCK, SNOW, WATER, WALL, ROOF = range(1, 8)
# Colours in the picture, and the variation of each texture.
LOOKS = {
    SAND: ((0.80, 0.71, 0.50), 0.10),
    GRASS: ((0.33, 0.46, 0.16), 0.28),
    ROCK: ((0.47, 0.43, 0.39), 0.30),
    SNOW: ((0.93, 0.95, 0.98), 0.04),
    WATER: ((0.10, 0.30, 0.42), 0.12),
    WALL: ((0.82, 0.74, 0.60), 0.08),
    ROOF: ((0.60, 0.22, 0.14), 0.16),
}
random = numpy.random.default_rng(11)


def waves(size, slope, finest):
    """Periodic waves, from 0 to 1, whose height falls with frequency."""
    frequency = numpy.hypot(*numpy.meshgrid(*[numpy.fft.fftfreq(size, 1 / size)] * 2))
    spectrum = numpy.fft.fft2(random.standard_normal((size, size)))
    spectrum *= numpy.exp(-((frequency / finest) ** 2)) / numpy.maximum(frequency, 1) ** slope
    spectrum[0, 0] = 0
    heights = numpy.fft.ifft2(spectrum).real
    return (heights - heights.min()) / numpy.ptp(heights)


def island():
    """Labels of the blocks, [z, y, x]; 0 is air."""
    y, x = numpy.mgrid[:BLOCKS, :BLOCKS] / BLOCKS * 2 - 1
    away = numpy.hypot(x - 0.1, y - 0.15)
    rough = waves(BLOCKS, 1.8, 45)
    height = 3 + 44 * numpy.exp(-((away / 0.6) ** 2)) * rough**1.2
    height += 9 * numpy.exp(-((away / 0.75) ** 6)) * waves(BLOCKS, 1.6, 30)
    z = numpy.arange(TALL)[:, None, None]
    steep = numpy.hypot(*numpy.gradient(height)) > 1.25
    ground = numpy.where(steep | (height > 23), ROCK, GRASS)
    ground = numpy.where(height < SEA + 2, SAND, ground)
    ground = numpy.where((height > 25) & ~steep, SNOW, ground)
    labels = numpy.where(z < height, ground, 0)
    labels[(labels == 0) & (z < SEA)] = WATER
    homes = numpy.argwhere((height > SEA + 2) & (height < SEA + 7) & ~steep & (y < -0.05))
    for row, column in random.permutation(homes)[:16]:
        here = slice(row, row + 4), slice(column, column + 5)
        if (labels[:, here[0], here[1]] >= WALL).any() or labels[0, here[0], here[1]].size < 20:
            continue
        floor = int(height[here].max()) + 1
        column_of = labels[: floor + 3, here[0], here[1]]
        column_of[column_of == 0] = WALL
        labels[floor + 3, here[0], here[1]] = ROOF
        labels[floor + 4, here[0], slice(column + 1, column + 4)] = ROOF
    return labels


def surface(labels):
    image = vtkImageData()
    image.SetDimensions(*(n + 1 for n in labels.shape[::-1]))
    cells = numpy_to_vtk(labels.astype(numpy.uint8).ravel(), deep=True)
    cells.SetName("labels")
    image.GetCellData().SetScalars(cells)
    blocks = relievo.vtkRelievoSmoothBlocks()
    blocks.SetInputData(image)
    blocks.SetSurface(blocks.OUTSIDE)
    blocks.SetNormals(blocks.ACROSS_MATERIALS)
    blocks.CloseBordersOff()
    blocks.SeamsOff()
    blocks.AddLevelLabel(WATER)
    for label in (WALL, ROOF):
        blocks.AddRigidLabel(label)
    blocks.SetNoiseAmplitude(0.35)
    blocks.SetNoiseScale(4)
    blocks.TextureCoordinatesOn()
    blocks.SetTileSize(16)
    start = time.perf_counter()
    blocks.Update()
    made = blocks.GetOutput()
    print(
        f"{labels.size} blocks, {made.GetNumberOfPolys()} triangles in "
        f"{1e3 * (time.perf_counter() - start):.0f} ms"
    )
    return made


def texture(label):
    """A tile of 256 texels that repeats."""
    colour, varies = LOOKS[label]
    grain = 0.6 * waves(256, 0.6, 80) + 0.4 * waves(256, 1.8, 60)
    rows = colour * (1 + varies * 2.2 * (grain[..., None] - 0.5))
    return scene.texture(rows)


def actor(blocks, label):
    only = vtkThreshold()
    only.SetInputData(blocks)
    only.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "material")
    only.SetLowerThreshold(label)
    only.SetUpperThreshold(label)
    faces = vtkGeometryFilter()
    faces.SetInputConnection(only.GetOutputPort())
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(faces.GetOutputPort())
    mapper.ScalarVisibilityOff()
    made = vtkActor()
    made.SetMapper(mapper)
    made.SetTexture(texture(label))
    made.GetProperty().SetAmbient(0)
    if label in (WALL, ROOF):
        made.GetProperty().SetInterpolationToFlat()
    if label == WATER:
        made.GetProperty().SetSpecular(0.5)
        made.GetProperty().SetSpecularPower(60)
    return made


def main():
    folder = scene.folder()
    renderer = vtkRenderer()
    blocks = surface(island())
    for label in LOOKS:
        renderer.AddActor(actor(blocks, label))
    renderer.SetBackground(0.74, 0.83, 0.90)
    renderer.SetBackground2(0.35, 0.55, 0.80)
    renderer.GradientBackgroundOn()
    lights = {}
    for name, place, colour, intensity in (
        ("sun", (-6, -3, 3.6), (1, 0.93, 0.80), 1.0),
        ("sky", (2, -2, 9), (0.60, 0.75, 1), 0.4),
    ):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*place)
        light.SetColor(*colour)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
        lights[name] = light
    camera = renderer.GetActiveCamera()
    camera.SetPosition(44, -14, 38)
    camera.SetFocalPoint(80, 74, 7)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(40)
    renderer.ResetCameraClippingRange()
    renderer.UseFXAAOn()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    frame.GetShadowStage().SetMapSize(4096)
    frame.GetShadowStage().SetLightCasts(lights["sky"], False)
    image = relievo.capture(renderer, ["color"])
    picture, _ = demo_sheet.picture_of("color", relievo.layer(image, "color"))
    demo_sheet.write_png(folder / "blocks.png", picture)
    print(folder / "blocks.png")


if __name__ == "__main__":
    main()
