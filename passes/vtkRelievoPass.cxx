// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPass.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoBuiltInStages.h"

vtkStandardNewMacro(vtkRelievoPass);

//------------------------------------------------------------------------------
vtkRelievoPass::vtkRelievoPass()
{
  vtkRelievoAddBuiltInStages();
  this->AddRegisteredStages();
}

//------------------------------------------------------------------------------
vtkRelievoPass::~vtkRelievoPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* shown = this->GetDisplayLayer();
  os << indent << "Shadows: " << this->GetShadows() << "\n";
  os << indent << "Deferred: " << this->GetDeferred() << "\n";
  os << indent << "DisplayLayer: " << (shown ? shown : "(none)") << "\n";
  os << indent << "DisplayRange: " << this->GetDisplayRange()[0] << " "
     << this->GetDisplayRange()[1] << "\n";
  os << indent << "DisplayGrey: " << this->GetDisplayGrey() << "\n";
}
