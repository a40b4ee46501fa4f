# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clipping planes, and blocks of a composite that have colours of their own or are hidden."""

from parts import actor, cone, cube, plane, show, sphere
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkRenderingCore import vtkCompositeDataDisplayAttributes

if vtkVersion().GetVTKMinorVersion() >= 3:
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as Mapper
else:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as Mapper

blocks = vtkMultiBlockDataSet()
for i, source in enumerate((sphere(), cube(at=(1.2, 0, 0)), cone(at=(-1.2, 0, 0)))):
    source.Update()
    blocks.SetBlock(i, source.GetOutput())
mapper = Mapper()
mapper.SetInputDataObject(blocks)
mapper.SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes())
mapper.SetBlockColor(1, 0.9, 0.3, 0.3)
mapper.SetBlockVisibility(3, False)
cut = vtkPlane()
cut.SetNormal(0.3, -1, 0)
cut.SetOrigin(0, 0.2, 0)
mapper.AddClippingPlane(cut)
window = show(actor(mapper), actor(plane()))
