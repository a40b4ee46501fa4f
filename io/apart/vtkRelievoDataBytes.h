// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data objects as bytes: polygonal meshes, images, and composites of these, with their arrays bit
// for bit. A shared array is written once and is shared again when read.
#ifndef vtkRelievoDataBytes_h
#define vtkRelievoDataBytes_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkDataObject;

namespace relievo
{
// Writes points, cells, field data, point and cell arrays with the names of their components,
// attributes, colour tables, names of blocks, and the position of an image. Leaves out arrays of
// variants, and the information of objects and arrays. A block that is neither mesh nor image is
// written as none.
VTKRELIEVOIO_EXPORT void PutData(ByteWriter& writer, vtkDataObject* data);

// nullptr if none was written.
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkDataObject> GetData(ByteReader& reader);
}

#endif
