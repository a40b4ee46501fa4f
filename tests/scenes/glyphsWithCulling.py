# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Glyphs that the graphics card culls and draws in two levels of detail."""

from parts import actor, cone, plane, show, sphere
from vtkmodules.vtkRenderingCore import vtkGlyph3DMapper

glyphs = vtkGlyph3DMapper()
places, head = plane(y=0, resolution=9), cone(resolution=24)
glyphs.SetInputConnection(places.GetOutputPort())
glyphs.SetSourceConnection(head.GetOutputPort())
glyphs.SetScaleFactor(0.3)
glyphs.SetCullingAndLOD(True)
glyphs.SetNumberOfLOD(2)
glyphs.SetLODDistanceAndTargetReduction(0, 3.0, 0.2)
glyphs.SetLODDistanceAndTargetReduction(1, 6.0, 0.6)
window = show(actor(glyphs, (0.9, 0.6, 0.3)), actor(plane()), actor(sphere(0.3)))
