// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoStage.h"

//------------------------------------------------------------------------------
void vtkRelievoStage::Render(const vtkRenderState*)
{
  vtkErrorMacro("A stage is not a pass by itself: add it to a vtkRelievoPass.");
}

//------------------------------------------------------------------------------
void vtkRelievoStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "DrawCalls: " << this->DrawCalls << "\n";
}
