# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textures, one with holes, repeated and interpolated."""

import numpy
from parts import actor, cube, plane, show
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture

colors = numpy.random.default_rng(3).integers(0, 256, (64, 4), dtype=numpy.uint8)
colors[:, 3] = numpy.where(numpy.arange(64) % 3 == 0, 0, 255)
props = []
for components, source in ((3, plane()), (4, cube())):
    image = vtkImageData()
    image.SetDimensions(8, 8, 1)
    values = numpy.ascontiguousarray(colors[:, :components])
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOff() if components == 4 else texture.InterpolateOn()
    prop = actor(source, (1, 1, 1))
    prop.SetTexture(texture)
    if components == 4:
        prop.ForceOpaqueOn()
    props.append(prop)
window = show(*props)
