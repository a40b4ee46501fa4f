// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRelievoPass);

//------------------------------------------------------------------------------
void vtkRelievoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkRelievoPass::Render(const vtkRenderState*) {}
