// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time of the last change of drawn data, for cases that VTK's own GetMTime omits.
#ifndef vtkRelievoPropMTime_h
#define vtkRelievoPropMTime_h

#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkType.h"

class vtkDataObject;
class vtkMapper;
class vtkTexture;

namespace vtkRelievoPropMTime
{
// Includes the data of blocks.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfData(vtkDataObject* data);

// Includes the texture's images, after an update.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfTexture(vtkTexture* texture);

// A mapper's inputs and clipping planes, without its own settings.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfInputs(vtkMapper* mapper);
}

#endif
