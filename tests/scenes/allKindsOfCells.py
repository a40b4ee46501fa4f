# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vertices, lines, polygons and strips in one mesh, with cell colours and back faces."""

from parts import actor, plane, show
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkProperty

corners = vtkPoints()
for i in range(12):
    corners.InsertNextPoint(0.3 * (i // 2) - 0.8, 0.5 * (i % 2), 0.1 * (i % 3))
kinds = [[(0,), (1,)], [(0, 3, 4), (2, 5)], [(0, 1, 2), (4, 5, 7, 6)], [(6, 7, 8, 9, 10, 11)]]
cells = []
for kind in kinds:
    cells.append(vtkCellArray())
    for points in kind:
        cells[-1].InsertNextCell(len(points), points)
mesh = vtkPolyData()
mesh.SetPoints(corners)
mesh.SetVerts(cells[0])
mesh.SetLines(cells[1])
mesh.SetPolys(cells[2])
mesh.SetStrips(cells[3])
values = vtkFloatArray()
for i in range(mesh.GetNumberOfCells()):
    values.InsertNextValue(i)
mesh.GetCellData().SetScalars(values)
mapper = vtkPolyDataMapper()
mapper.SetInputData(mesh)
mapper.SetScalarRange(0, mesh.GetNumberOfCells())
shown = actor(mapper)
shown.GetProperty().SetPointSize(6)
shown.GetProperty().SetLineWidth(3)
back = vtkProperty()
back.SetColor(0.9, 0.1, 0.1)
shown.SetBackfaceProperty(back)
window = show(shown, actor(plane()))
