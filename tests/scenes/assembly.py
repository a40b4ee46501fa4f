# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""An assembly lends its property keys to its parts, and one part is drawn on its own as well."""

from parts import actor, cone, cube, separate, show, sphere
from vtkmodules.vtkRenderingCore import vtkAssembly

inner, outer = vtkAssembly(), vtkAssembly()
twice = actor(cone(), (0.9, 0.4, 0.3), at=(1.2, 0, 0))
inner.AddPart(actor(cube(), (0.3, 0.5, 0.9)))
inner.AddPart(twice)
inner.SetPosition(0.4, 1.2, 0)
inner.RotateZ(30)
outer.AddPart(inner)
outer.AddPart(actor(sphere(), (0.4, 0.8, 0.4), at=(-1, 0, 0)))
outer.RotateX(15)
window = show(outer, twice)
twin = show(*separate(outer, twice))
