// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthToPoints.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRelievoDepthToPoints);

//------------------------------------------------------------------------------
void vtkRelievoDepthToPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
