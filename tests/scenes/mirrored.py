# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Matrices that mirror and shear, with culled faces."""

from parts import actor, cone, plane, show, sphere
from vtkmodules.vtkCommonTransforms import vtkTransform

mirrored = actor(cone(), (0.9, 0.4, 0.3))
mirrored.SetScale(-1, 1, 0.6)
mirrored.GetProperty().BackfaceCullingOn()
sheared = actor(sphere(at=(1.2, 0, 0)), (0.3, 0.5, 0.9))
matrix = vtkTransform()
matrix.Concatenate([1, 0.4, 0, 0, 0, 1, 0, 0, 0, 0.2, -1, 0, 0, 0, 0, 1])
sheared.SetUserTransform(matrix)
sheared.GetProperty().FrontfaceCullingOn()
window = show(mirrored, sheared, actor(plane()))
