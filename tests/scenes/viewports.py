# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Four viewports that share actors, with gradients and textured backgrounds."""

from parts import actor, cube, look, plane, renderer_of, sphere, window_of

props = [actor(sphere()), actor(cube(at=(1.2, 0, 0)), (0.3, 0.5, 0.9)), actor(plane())]
renderers = []
for i in range(4):
    renderer = renderer_of(*props[: 3 - i % 2], background=(0.1 * i, 0.2, 0.3))
    renderer.SetViewport(0.5 * (i % 2), 0.5 * (i // 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i // 2))
    look(renderer, azimuth=20 * i)
    renderers.append(renderer)
renderers[1].GradientBackgroundOn()
renderers[2].GetActiveCamera().ParallelProjectionOn()
window = window_of(*renderers, size=(201, 151))
