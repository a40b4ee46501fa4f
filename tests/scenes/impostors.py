# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points as spheres and lines as tubes, beside plain ones."""

from parts import actor, cube, plane, show, sphere

points = actor(sphere(resolution=8), (0.9, 0.6, 0.3))
points.GetProperty().SetRepresentationToPoints()
points.GetProperty().SetPointSize(9)
points.GetProperty().RenderPointsAsSpheresOn()
tubes = actor(cube(at=(1.3, 0, 0)), (0.3, 0.5, 0.9))
tubes.GetProperty().SetRepresentationToWireframe()
tubes.GetProperty().SetLineWidth(7)
tubes.GetProperty().RenderLinesAsTubesOn()
thin = actor(sphere(at=(-1.3, 0, 0)))
thin.GetProperty().SetRepresentationToWireframe()
window = show(points, tubes, thin, actor(plane()))
