# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth in world units of everything that a renderer shows, in ten lines."""

import relievo
from relievo.vtk.vtkFiltersSources import vtkSphereSource
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

sphere = vtkSphereSource()
actor = vtkActor()
actor.SetMapper(vtkPolyDataMapper())
actor.GetMapper().SetInputConnection(sphere.GetOutputPort())
renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.ResetCamera()
image = relievo.capture(renderer, ["depth", "normal"], size=(640, 480))
depth = relievo.layer(image, "depth")  # numpy, (480, 640), float32; infinity in the background
print(f"nearest {depth.min():.4f}, middle {depth[240, 320]:.4f}, corner {depth[0, 0]}")
