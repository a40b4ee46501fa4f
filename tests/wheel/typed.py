# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A program for type checkers (tools/check-types): functions, classes and VTK by their types."""

import numpy
import relievo
from relievo.vtk.vtkFiltersSources import vtkSphereSource
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

sphere = vtkSphereSource()
sphere.SetRadius(2.0)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(sphere.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
frame: relievo.vtkRelievoPass = relievo.attach(renderer)
frame.ShadowsOn()
stage = frame.GetShadowStage()
stage.SetMapSize(512)
image = relievo.capture(renderer, ["depth", "normal"], size=(40, 30))
depth: numpy.ndarray = relievo.layer(image, "depth")
print(depth.min(), image.GetDimensions(), relievo.__version__)
lens = relievo.Pinhole([[100, 0, 20], [0, 100, 15], [0, 0, 1]], (40, 30))
seen = relievo.capture(renderer, "depth", camera=lens)
hits = relievo.rays(renderer).nearest([(0, 0, 9)], (0, 0, -1))
print(hits.hit, relievo.lens("fisheye:180", size=(30, 30)).size)
writer = relievo.vtkRelievoEXRWriter()
writer.SetFileName("a.exr")
