// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data objects as bytes: polygonal meshes, images, and composites of these, with their arrays bit
// for bit. An array that several have is written once, and is one when it is read.
#ifndef vtkRelievoDataBytes_h
#define vtkRelievoDataBytes_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkDataObject;

namespace relievo
{
// Kept are points, cells, field data, point and cell arrays with the names of their components,
// which of them are attributes, colour tables, the names of blocks, and the place of an image. Left
// out are arrays of variants, and the information of objects and arrays. A block that is neither
// mesh nor image is written as none.
VTKRELIEVOIO_EXPORT void PutData(ByteWriter& writer, vtkDataObject* data);

// nullptr for what was none.
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkDataObject> GetData(ByteReader& reader);
}

#endif
