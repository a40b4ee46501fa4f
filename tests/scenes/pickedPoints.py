# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A selection of points by hardware before the frames, whose buffers VTK gives back."""

from parts import actor, plane, show, sphere
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import vtkHardwareSelector

points = actor(sphere(resolution=12), (0.9, 0.6, 0.3))
points.GetProperty().SetRepresentationToPoints()
points.GetProperty().SetPointSize(5)
window = show(points, actor(plane()))
window.Render()
selector = vtkHardwareSelector()
selector.SetRenderer(window.GetRenderers().GetFirstRenderer())
selector.SetArea(0, 0, 199, 149)
selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_POINTS)
assert selector.Select().GetNumberOfNodes() > 0
