# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A widget that selects points by hardware while the picture is drawn."""

from parts import renderer_of, sphere, window_of
from vtkmodules.vtkInteractionWidgets import vtkPointCloudRepresentation, vtkPointCloudWidget
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

renderer = renderer_of()
window = window_of(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
points = sphere(resolution=12)
points.Update()
representation = vtkPointCloudRepresentation()
representation.SetPickingModeToHardware()
representation.PlacePointCloud(points.GetOutput())
widget = vtkPointCloudWidget()
widget.SetInteractor(interactor)
widget.SetRepresentation(representation)
interactor.Initialize()
renderer.ResetCamera()
window.Render()
widget.On()
