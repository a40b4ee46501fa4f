# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A caption, which is a 2D actor, with a leader that is drawn among the opaque geometry."""

from parts import actor, cone, plane, show, sphere
from vtkmodules.vtkRenderingAnnotation import vtkCaptionActor2D

head = cone()
caption = vtkCaptionActor2D()
caption.SetCaption("pole")
caption.SetAttachmentPoint(0, 0.5, 0)
caption.ThreeDimensionalLeaderOn()
caption.SetLeaderGlyphConnection(head.GetOutputPort())
caption.SetLeaderGlyphSize(0.1)
caption.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
caption.GetPositionCoordinate().SetReferenceCoordinate(None)
caption.GetPositionCoordinate().SetValue(0.6, 0.7)
window = show(actor(sphere(), (0.9, 0.6, 0.3)), actor(plane()), caption)
