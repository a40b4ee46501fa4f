// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When what is drawn was last changed, where VTK's own GetMTime leaves something out.
#ifndef vtkRelievoPropMTime_h
#define vtkRelievoPropMTime_h

#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkType.h"

class vtkDataObject;
class vtkMapper;
class vtkTexture;

namespace vtkRelievoPropMTime
{
// With the data of its blocks.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfData(vtkDataObject* data);

// With its image or images, brought up to date.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfTexture(vtkTexture* texture);

// Of a mapper's inputs and clipping planes, not of its own settings.
VTKRELIEVORAYS_EXPORT vtkMTimeType OfInputs(vtkMapper* mapper);
}

#endif
