# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wire frames with hidden lines removed."""

from parts import actor, cube, renderer_of, sphere, window_of

wires = [actor(sphere(), (1, 1, 1)), actor(cube(at=(0.7, 0, -0.6)), (1, 0.8, 0.2))]
for wire in wires:
    wire.GetProperty().SetRepresentationToWireframe()
renderer = renderer_of(*wires)
renderer.UseHiddenLineRemovalOn()
window = window_of(renderer)
