# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Glyphs of several sources, scaled and turned by data."""

from parts import actor, cone, cube, plane, show, sphere
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkRenderingCore import vtkGlyph3DMapper

input_points = vtkElevationFilter()
ball = sphere(1.0, 7)
input_points.SetInputConnection(ball.GetOutputPort())
input_points.SetLowPoint(-1, 0, 0)
input_points.SetHighPoint(1, 0, 0)
glyphs = vtkGlyph3DMapper()
glyphs.SetInputConnection(input_points.GetOutputPort())
sources = [cone(), cube(), sphere()]
for i, source in enumerate(sources):
    glyphs.SetSourceConnection(i, source.GetOutputPort())
glyphs.SourceIndexingOn()
glyphs.SetSourceIndexArray("Elevation")
glyphs.SetRange(0, 1)
glyphs.SetOrientationArray("Normals")
glyphs.SetScaleFactor(0.25)
window = show(actor(glyphs), actor(plane(y=-1)))
