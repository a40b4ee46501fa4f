// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataSets_h
#define DataSets_h

#include "vtkSmartPointer.h"

#include <functional>

class vtkDataObject;
class vtkDataSet;

namespace scene
{
/// Calls visit for the data set that the object is, or for each one that a composite holds.
void ForEachDataSet(vtkDataObject* data, const std::function<void(vtkDataSet*)>& visit);

/// The object, or the composite, with each of its data sets changed; what was given stays.
vtkSmartPointer<vtkDataObject> ReplaceDataSets(
  vtkDataObject* data, const std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*)>& change);

/// Data sets of its own, which share their arrays with the given one's.
vtkSmartPointer<vtkDataObject> CopyDataSets(vtkDataObject* data);

/// The points of the object, or of all data sets that it holds, as meshes without cells, with their
/// point and field data.
vtkSmartPointer<vtkDataObject> KeepPoints(vtkDataObject* data);

/// Gives each cell its number, from 0, in the cell array vtkOriginalCellIds.
void NumberCells(vtkDataSet* data);
}

#endif
