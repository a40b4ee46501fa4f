// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The objects of a data set as meshes that their poses refer to.
 */
#ifndef DatasetModels_h
#define DatasetModels_h

#include <string>

class vtkRenderer;

namespace scene
{
class DatasetObjects;

/// Writes models/obj_NUMBER.ply of each object, and models/models_info.json, as BOP has them: in
/// millimetres, by the axes and from the origin that the object's pose places. What is there is
/// left. Throws FileError.
void WriteDatasetModels(const std::string& folder, vtkRenderer* renderer,
  const DatasetObjects& objects, double millimetersPerUnit);
}

#endif
