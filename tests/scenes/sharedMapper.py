# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Actors that share a mapper, as surface, as wire frame and as points."""

from parts import actor, mapper_of, plane, show, sphere


def scene(mappers):
    surface = actor(mappers[0], (0.9, 0.6, 0.3))
    wires = actor(mappers[1], (0.3, 0.6, 0.9), at=(1.2, 0, 0))
    wires.GetProperty().SetRepresentationToWireframe()
    points = actor(mappers[2], (0.6, 0.9, 0.3), at=(-1.2, 0, 0))
    points.GetProperty().SetRepresentationToPoints()
    points.GetProperty().SetPointSize(4)
    return show(surface, wires, points, actor(plane()))


window = scene([mapper_of(sphere(resolution=12))] * 3)
twin = scene([mapper_of(sphere(resolution=12)) for _ in range(3)])
