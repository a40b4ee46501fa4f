// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The meshes of a data set's objects, to which the poses refer.
 */
#ifndef DatasetModels_h
#define DatasetModels_h

#include "DatasetNames.h"

class vtkRenderer;

namespace dataset
{
class DatasetObjects;
struct DatasetStyle;

/// Writes models/obj_NUMBER.ply of each object, and models/models_info.json, in BOP's layout: in
/// millimetres, relative to the axes and the origin of the object's pose. Throws FileError.
void WriteDatasetModels(
  const DatasetStyle& style, vtkRenderer* renderer, const DatasetObjects& objects);
}

#endif
