# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A wire frame with its vertices shown, and a surface with its edges."""

from parts import actor, cube, plane, show, sphere

shown = actor(sphere(resolution=10), (0.9, 0.6, 0.3))
shown.GetProperty().SetRepresentationToWireframe()
shown.GetProperty().VertexVisibilityOn()
shown.GetProperty().SetVertexColor(0.9, 0.1, 0.1)
shown.GetProperty().SetPointSize(5)
edges = actor(cube(at=(1.3, 0, 0)), (0.3, 0.5, 0.9))
edges.GetProperty().EdgeVisibilityOn()
edges.GetProperty().SetLineWidth(2)
window = show(shown, edges, actor(plane()))
