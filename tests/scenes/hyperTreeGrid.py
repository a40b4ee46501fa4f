# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surface and edges of a hyper tree grid, by one mapper."""

from parts import actor, mapper_of, show
from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridGeometry
from vtkmodules.vtkFiltersSources import vtkHyperTreeGridSource

grid = vtkHyperTreeGridSource()
grid.SetMaxDepth(3)
grid.SetDimensions(4, 4, 3)
grid.SetGridScale(1, 1, 1)
grid.SetBranchFactor(2)
grid.SetDescriptor("RRR .R. .RR ..R ..R .R.|R....... ........ ........ ........ ........ ........ "
                   "........ ........ ........|........")  # fmt: skip
geometry = vtkHyperTreeGridGeometry()
geometry.SetInputConnection(grid.GetOutputPort())
mapper = mapper_of(geometry)
mapper.ScalarVisibilityOff()
edges = actor(mapper, (0, 0, 0))
edges.GetProperty().SetRepresentationToWireframe()
window = show(actor(mapper, (0.5, 0.7, 0.9)), edges)
