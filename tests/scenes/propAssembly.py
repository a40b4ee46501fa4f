# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""One actor in two prop assemblies, and prop assemblies in each other."""

from parts import actor, cone, cube, plane, separate, show
from vtkmodules.vtkRenderingCore import vtkPropAssembly

shared = actor(cube(), (0.3, 0.5, 0.9))
one, two, both = vtkPropAssembly(), vtkPropAssembly(), vtkPropAssembly()
one.AddPart(shared)
one.AddPart(actor(cone(at=(1.3, 0, 0))))
two.AddPart(shared)
two.AddPart(actor(plane()))
both.AddPart(one)
both.AddPart(two)
window = show(both)
twin = show(*separate(both))
