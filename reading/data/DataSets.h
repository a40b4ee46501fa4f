// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataSets_h
#define DataSets_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkDataObject;
class vtkDataSet;

namespace reading
{
/// Calls `visit` for the object if it is a data set, or for each data set in a composite.
void ForEachDataSet(vtkDataObject* data, const std::function<void(vtkDataSet*)>& visit);

/// Returns the object, or the composite, with each of its data sets changed; the input stays.
vtkSmartPointer<vtkDataObject> ReplaceDataSets(
  vtkDataObject* data, const std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*)>& change);

/// Shallow copies of the data sets.
vtkSmartPointer<vtkDataObject> CopyDataSets(vtkDataObject* data);

/// The points of the object, or of all its data sets, as meshes without cells, with their point and
/// field data.
vtkSmartPointer<vtkDataObject> KeepPoints(vtkDataObject* data);

/// Numbers the cells, from 0, in the cell array vtkOriginalCellIds.
void NumberCells(vtkDataSet* data);
}

#endif
