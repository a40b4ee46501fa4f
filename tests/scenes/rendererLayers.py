# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renderers above each other, which share an actor, and one that keeps the depth."""

from parts import actor, cone, cube, plane, renderer_of, sphere, window_of

shared = actor(sphere(), (0.9, 0.6, 0.3))
below = renderer_of(shared, actor(plane()))
above = renderer_of(actor(cube(at=(1, 0, 0)), (0.3, 0.5, 0.9)), shared)
top = renderer_of(actor(cone(at=(-1, 0, 0)), (0.3, 0.9, 0.5)))
for layer, renderer in enumerate((below, above, top)):
    renderer.SetLayer(layer)
    renderer.SetActiveCamera(below.GetActiveCamera())
top.PreserveDepthBufferOn()
window = window_of(below, above, top)
window.SetNumberOfLayers(3)
