# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""One actor is drawn twice in a row, by assemblies with different matrices."""

from parts import actor, cone, plane, show
from vtkmodules.vtkRenderingCore import vtkAssembly

shared = actor(cone(), (0.9, 0.4, 0.3))
left, right = vtkAssembly(), vtkAssembly()
left.AddPart(shared)
left.SetPosition(-0.8, 0, 0)
right.AddPart(shared)
right.SetPosition(0.8, 0, 0)
right.RotateZ(90)
window = show(left, right, actor(plane()))

single = [actor(cone(), (0.9, 0.4, 0.3)) for _ in range(2)]
single[0].SetPosition(-0.8, 0, 0)
single[1].SetPosition(0.8, 0, 0)
single[1].RotateZ(90)
twin = show(*single, actor(plane()))
