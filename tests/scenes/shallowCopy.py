# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A copy of an actor that has been drawn with layers shares its property keys."""

import relievo
from parts import actor, cone, plane, show, sphere
from vtkmodules.vtkRenderingCore import vtkActor

first = actor(sphere(), (0.8, 0.3, 0.3))
window = show(first, actor(plane()), actor(cone(at=(-1.2, 0, 0))))
renderer = window.GetRenderers().GetFirstRenderer()
relievo.attach(renderer).RequestLayer("depth")
window.Render()
copied = vtkActor()
copied.ShallowCopy(first)
copied.SetPosition(1.2, 0, 0)
renderer.AddActor(copied)
window.Render()
relievo.detach(renderer)

twin = show(
    actor(sphere(), (0.8, 0.3, 0.3)),
    actor(plane()),
    actor(cone(at=(-1.2, 0, 0))),
    actor(sphere(), (0.8, 0.3, 0.3), at=(1.2, 0, 0)),
)
camera = twin.GetRenderers().GetFirstRenderer().GetActiveCamera()
camera.DeepCopy(renderer.GetActiveCamera())
