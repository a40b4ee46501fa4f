# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tube along a trefoil knot and its room, shared by several examples."""

import numpy
from relievo.vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkCellArray, vtkPolyData

import scene

SIZE = (420, 420)


def knot(around=360, across=48, radius=0.62):
    """A closed tube along a trefoil knot; its point data give the position along the knot."""
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


def room(*actors):
    """scene.room() with the knot in the middle of its picture."""
    renderer, window = scene.room(actors, SIZE, (-3, 4, 7), (0.09, 0.1, 0.13))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-4, -9, 13)
    camera.SetFocalPoint(0, 0.1, -0.2)
    return renderer, window
