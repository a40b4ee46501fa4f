# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent surfaces with depth peeling among opaque ones."""

from parts import actor, cube, plane, renderer_of, sphere, window_of

glass = actor(sphere(0.7), (0.3, 0.6, 0.9))
glass.GetProperty().SetOpacity(0.4)
renderer = renderer_of(glass, actor(cube(at=(0.6, 0, 0))), actor(plane()))
renderer.SetUseDepthPeeling(True)
renderer.SetMaximumNumberOfPeels(4)
window = window_of(renderer)
window.SetAlphaBitPlanes(1)
