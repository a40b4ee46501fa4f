// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRelievoEXRWriter);

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
