# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stage's layers: as ParaView's pipeline gives them, and by rays in double."""

import numpy
import stage
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NONE, GROUND, BALL = -1, 0, 1


def image(source):
    """The image that a source gives, from the process that has it."""
    source.UpdatePipeline()
    found = [each for each in simple.FetchData(source).values() if each.GetNumberOfPoints()]
    if len(found) != 1:
        raise AssertionError(f"{len(found)} processes have an image")
    return found[0]


def arrays(of):
    """Point arrays of an image, or of a source's, by name: (rows, columns, ...), top row first."""
    picture = of if hasattr(of, "GetDimensions") else image(of)
    columns, rows, _ = picture.GetDimensions()
    data = picture.GetPointData()
    found = {}
    for i in range(data.GetNumberOfArrays()):
        values = vtk_to_numpy(data.GetArray(i))
        found[data.GetArrayName(i)] = values.reshape(rows, columns, *values.shape[1:])[::-1].copy()
    return found


def alike(first, second):
    """Where two arrays are equal bit for bit, NaNs included: (rows, columns)."""
    equal = (first == second) | ((first != first) & (second != second))
    return equal.reshape(*first.shape[:2], -1).all(axis=2)


def truth(scene):
    """depth, range, position, normal and kind of every pixel, and `sure`: 3 pixels off any edge."""
    size = tuple(scene.view.ViewSize)
    origin, direction = scene.rays(size)
    ball = scene.sphere_hit(origin, direction)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        ground = -origin[..., 2] / direction[..., 2]
        there = origin + ground[..., None] * direction
    outside = (ground <= 0) | (numpy.abs(there[..., :2]) > stage.HALF).any(axis=2)
    ground = numpy.where(outside, numpy.inf, ground)
    distance = numpy.minimum(ball, ground)
    seen = numpy.isfinite(distance)
    kind = numpy.where(seen, numpy.where(ball < ground, BALL, GROUND), NONE)
    place = origin + numpy.where(seen, distance, 0.0)[..., None] * direction
    place = numpy.where(seen[..., None], place, 0.0)
    eye = numpy.array(scene.view.CameraPosition, dtype=float)
    gaze = numpy.array(scene.view.CameraFocalPoint, dtype=float) - eye
    gaze /= numpy.linalg.norm(gaze)
    normal = numpy.where(
        (kind == BALL)[..., None], (place - scene.center) / stage.RADIUS, [0.0, 0.0, 1.0]
    )
    sure = numpy.ones(kind.shape, bool)
    for axis in (0, 1):
        for step in (-3, -2, -1, 1, 2, 3):
            sure &= numpy.roll(kind, step, axis) == kind
    return {
        "depth": numpy.where(seen, (place - eye) @ gaze, numpy.inf),
        "range": numpy.where(seen, numpy.linalg.norm(place - eye, axis=2), numpy.inf),
        "position": place,
        "normal": numpy.where(seen[..., None], normal, 0.0),
        "kind": kind,
        "sure": sure,
    }
