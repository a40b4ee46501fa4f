# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A vtkLODProp3D that shows the second of its levels."""

from parts import actor, cone, mapper_of, plane, show, sphere
from vtkmodules.vtkRenderingCore import vtkLODProp3D, vtkProperty

red = vtkProperty()
red.SetColor(0.9, 0.3, 0.3)
levels = vtkLODProp3D()
levels.AddLOD(mapper_of(sphere(resolution=40)), red, 0.0)
coarse = levels.AddLOD(mapper_of(sphere(resolution=8)), red, 0.0)
levels.AutomaticLODSelectionOff()
levels.SetSelectedLODID(coarse)
window = show(levels, actor(cone(at=(1.3, 0, 0))), actor(plane()))
