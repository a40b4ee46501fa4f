# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text that turns to the camera."""

from parts import actor, mapper_of, plane, renderer_of, sphere, window_of
from vtkmodules.vtkRenderingCore import vtkFollower
from vtkmodules.vtkRenderingFreeType import vtkVectorText

text = vtkVectorText()
text.SetText("up")
follower = vtkFollower()
follower.SetMapper(mapper_of(text))
follower.SetPosition(0.3, 0.4, 0)
follower.SetScale(0.5)
renderer = renderer_of(actor(sphere()), actor(plane()), follower)
follower.SetCamera(renderer.GetActiveCamera())
window = window_of(renderer)
