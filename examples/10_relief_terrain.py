# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain as two triangles with relief, beside the same terrain as two million triangles.

    10_relief_terrain.py [FOLDER [CORNERS]]    writes FOLDER/relief_terrain.png

Relief is on the left, geometry on the right. Prints the frame time of each, and the difference of
their depths. CORNERS (1025): corners of the geometry along a side, one more than the texels of the
heights.
"""

import sys
import time

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkPolyDataNormals
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import demo_sheet
import scene

HEIGHT = 0.4  # of the terrain, on a square of side 2


def terrain(texels):
    """Heights from 0 to 1 of a periodic terrain: waves whose height falls with frequency."""
    random = numpy.random.default_rng(7)
    u = (numpy.arange(texels) + 0.5) / texels
    frequency = numpy.hypot(*numpy.meshgrid(*[numpy.fft.fftfreq(texels, 1 / texels)] * 2))
    spectrum = numpy.fft.fft2(random.standard_normal((texels, texels)))
    spectrum *= numpy.exp(-frequency / 60) / numpy.maximum(frequency, 1) ** 2.1
    spectrum[0, 0] = 0
    heights = numpy.fft.ifft2(spectrum).real * len(u)
    return (heights - heights.min()) / (heights.max() - heights.min())


def relief_actor(heights):
    """Two triangles and a material."""
    image = vtkImageData()
    rows, columns = heights.shape
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.astype(numpy.float32).ravel(), deep=True))
    plane = vtkPlaneSource()
    plane.SetOrigin(-1, -1, 0)
    plane.SetPoint1(1, -1, 0)
    plane.SetPoint2(-1, 1, 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)

    material = relievo.vtkRelievoMaterial()
    material.SetHeightMap(image)
    material.SetHeightScale(HEIGHT)
    material.SelfShadowOn()
    material.DepthCorrectionOn()
    material.ClipAtBordersOn()
    material.Attach(actor)
    return actor


def geometry_actor(heights, corners):
    """The surface as triangles."""
    texels = len(heights)
    at = (numpy.arange(corners) / (corners - 1) * texels).astype(int) % texels
    # A corner lies between four texels.
    heights = (heights + numpy.roll(heights, 1, 0)) / 2
    heights = (heights + numpy.roll(heights, 1, 1)) / 2
    x, y = numpy.meshgrid(*[numpy.linspace(-1, 1, corners)] * 2)
    z = (heights[numpy.ix_(at, at)] - 1) * HEIGHT
    first = (numpy.arange(corners - 1)[:, None] * corners + numpy.arange(corners - 1)).ravel()
    a, b, c, d = first, first + 1, first + corners + 1, first + corners
    cells = numpy.concatenate([numpy.stack([a, b, c], 1), numpy.stack([a, c, d], 1)])
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    points = numpy.stack([x.ravel(), y.ravel(), z.ravel()], 1)
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    triangles = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(cells) + 1, 3)
    triangles.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                      numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))  # fmt: skip
    mesh.SetPolys(triangles)
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def window_of(actor):
    """A window with the terrain under a low sun."""
    actor.GetProperty().SetColor(0.85, 0.78, 0.66)
    actor.GetProperty().SetAmbient(0.12)
    renderer = vtkRenderer()
    renderer.SetBackground(0.55, 0.66, 0.8)
    renderer.AddActor(actor)
    sun = vtkLight()
    sun.SetPosition(3, 2, 1.6)
    sun.SetFocalPoint(0, 0, 0)
    renderer.AddLight(sun)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(600, 420)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.3, -2.5, 1.9)
    camera.SetFocalPoint(0, -0.05, -0.25)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(37)
    camera.SetClippingRange(0.5, 8)
    return window


def renderer_of(window):
    """The window's one renderer."""
    return window.GetRenderers().GetFirstRenderer()


folder = scene.folder()
corners = int(sys.argv[2]) if len(sys.argv) > 2 else 1025
heights = terrain(corners - 1)
windows = [window_of(relief_actor(heights)), window_of(geometry_actor(heights, corners))]
relievo.attach(renderer_of(windows[1])).ShadowsOn()  # the relief casts on itself

for window in windows:
    window.Render()
times: list[list[float]] = [[], []]
for _ in range(5):
    for window, seconds in zip(windows, times):
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        seconds.append(time.perf_counter() - start)
relief, geometry = (1000 * sorted(seconds)[2] for seconds in times)
print(f"2 triangles with relief: {relief:.0f} ms a frame; "
      f"{2 * (corners - 1) ** 2} triangles: {geometry:.0f} ms, "
      f"{geometry / relief:.1f} times that")  # fmt: skip

depths = [relievo.layer(relievo.capture(renderer_of(w), ["depth"]), "depth") for w in windows]
both = numpy.isfinite(depths[0]) & numpy.isfinite(depths[1])
apart = abs(depths[0][both] - depths[1][both]) / HEIGHT
print(f"depths are {100 * numpy.median(apart):.4f} % of the terrain's height apart in the median, "
      f"more than 5 % in {100 * (apart > 0.05).mean():.2f} % of the pixels")  # fmt: skip

pictures = []
for window in windows:
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    window.Render()
    grab.Update()
    pictures.append(relievo.layer(grab.GetOutput(), "ImageScalars"))
demo_sheet.write_png(folder / "relief_terrain.png", numpy.concatenate(pictures, axis=1))
print(folder / "relief_terrain.png")
