# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A town at night: 2 000 street lamps from a table of points, under the moon.

    12_town_at_night.py [FOLDER]    writes FOLDER/town.png and FOLDER/town_lamps.png

Each lamp is a point with a radius and a colour. For each pixel, the second picture shows
the number of lamps that reach it, and the number of lamps computed for it.
"""

import numpy
import relievo
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData
from relievo.vtk.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene

SIZE = (1280, 720)
BLOCKS, STREET, BLOCK = 20, 14.0, 46.0  # blocks each way; widths in metres
PITCH = BLOCK + STREET
EDGE = 0.5 * BLOCKS * PITCH
rng = numpy.random.default_rng(7)


def add(renderer, data, colour):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    renderer.AddActor(actor)


def houses():
    """Four houses per block, higher towards the middle."""
    town = vtkAppendPolyData()
    for column in range(BLOCKS):
        for row in range(BLOCKS):
            for corner in range(4):
                x = -EDGE + STREET + column * PITCH + (corner % 2 + 0.5) * BLOCK / 2
                y = -EDGE + STREET + row * PITCH + (corner // 2 + 0.5) * BLOCK / 2
                middle = numpy.exp(-(x * x + y * y) / (0.15 * EDGE * EDGE))
                height = rng.uniform(6, 14) + middle * rng.uniform(0, 70)
                house = vtkCubeSource()
                width, depth = rng.uniform(13, 21, 2)
                house.SetBounds(
                    x - width / 2, x + width / 2, y - depth / 2, y + depth / 2, 0, height)
                town.AddInputConnection(house.GetOutputPort())
    town.Update()
    return town.GetOutput()


def street_lamps():
    """Pairs of lamps along every street, some of them colder than others."""
    along = numpy.arange(-EDGE + STREET, EDGE, 24.0)
    across = -EDGE + STREET / 2 + PITCH * numpy.arange(BLOCKS + 1)
    places = []
    for street in across:
        for sign, offset in ((1, 0.0), (-1, 12.0)):
            line = numpy.full_like(along, street + sign * 0.36 * STREET)
            places += [numpy.c_[along + offset, line], numpy.c_[line, along + offset]]
    flat = rng.permutation(numpy.concatenate(places))[:2000]
    points = numpy.c_[flat, numpy.full(len(flat), 5.5)]
    cold = rng.random(len(points))[:, None] < 0.25
    colours = numpy.where(cold, (0.75, 0.85, 1.0), (1.0, 0.72, 0.38))
    return points, numpy.full(len(points), 34.0), colours


folder = scene.folder()
renderer = vtkRenderer()
renderer.SetBackground(0.012, 0.016, 0.035)
ground = vtkPlaneSource()
ground.SetOrigin(-EDGE, -EDGE, 0)
ground.SetPoint1(EDGE + STREET, -EDGE, 0)
ground.SetPoint2(-EDGE, EDGE + STREET, 0)
ground.Update()
add(renderer, ground.GetOutput(), (0.45, 0.45, 0.47))
add(renderer, houses(), (0.72, 0.68, 0.62))
moon = vtkLight()
moon.SetLightTypeToSceneLight()
moon.SetPosition(-1, 0.6, 1.2)
moon.SetColor(0.55, 0.65, 1.0)
moon.SetIntensity(0.4)
renderer.AutomaticLightCreationOff()
renderer.AddLight(moon)
camera = renderer.GetActiveCamera()
camera.SetPosition(-300, -560, 170)
camera.SetFocalPoint(10, 0, -60)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle(32)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(*SIZE)
window.AddRenderer(renderer)
renderer.UseFXAAOn()

places, radii, colours = street_lamps()
lamps = scene.points(places, radius=radii, color=colours)
relievo.lamps(renderer, lamps, intensity=42, falloff="inverse-square")
image = relievo.capture(renderer, ["color", "lamps_reaching", "lamp_evaluations"])

picture, _ = demo_sheet.picture_of("color", relievo.layer(image, "color"))
demo_sheet.write_png(folder / "town.png", picture)
tiles = []
for name, words in (("lamps_reaching", "lamps that reach the pixel"),
                    ("lamp_evaluations", "lamps computed for it")):  # fmt: skip
    count = relievo.layer(image, name)
    grey = demo_sheet.bytes_of(numpy.minimum(count / 12.0, 1.0))
    tiles.append((name, f"{words}: {count.mean():.1f} on average; white: 12",
                  grey[..., None].repeat(3, axis=2)))
    print(f"{name}: {count.mean():.2f} on average, {count.max():.0f} at most")
sheet = demo_sheet.contact_sheet(tiles, 2, SIZE[0] / 2, "2 000 lamps")
demo_sheet.write_png(folder / "town_lamps.png", sheet)
for name in ("town.png", "town_lamps.png"):
    print(folder / name)
