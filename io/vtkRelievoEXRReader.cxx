// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRReader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRelievoEXRReader);

//------------------------------------------------------------------------------
void vtkRelievoEXRReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
