# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wire frame of a mapper over its own surface."""

from parts import actor, mapper_of, plane, show, sphere

mapper = mapper_of(sphere(resolution=12))
wires = actor(mapper, (0, 0, 0))
wires.GetProperty().SetRepresentationToWireframe()
wires.GetProperty().SetLineWidth(2)
window = show(actor(mapper, (0.9, 0.6, 0.3)), wires, actor(plane()))
