// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataSets_h
#define DataSets_h

#include <functional>

class vtkDataObject;
class vtkDataSet;

namespace cli
{
/// Calls visit for the data set that the object is, or for each one that a composite holds.
void ForEachDataSet(vtkDataObject* data, const std::function<void(vtkDataSet*)>& visit);
}

#endif
