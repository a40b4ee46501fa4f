# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two actors hold one vtkInformation of property keys."""

from parts import actor, cube, plane, show, sphere
from vtkmodules.vtkCommonCore import vtkInformation



def scene(*keys):
    one, other = actor(sphere()), actor(cube(at=(1.2, 0, 0)), (0.3, 0.5, 0.9))
    one.SetPropertyKeys(keys[0])
    other.SetPropertyKeys(keys[-1])
    return show(one, other, actor(plane()))


window = scene(vtkInformation())
twin = scene(vtkInformation(), vtkInformation())
