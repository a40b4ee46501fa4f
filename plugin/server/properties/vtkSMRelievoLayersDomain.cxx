// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoLayersDomain.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMRelievoLayersDomain);

//------------------------------------------------------------------------------
vtkSMRelievoLayersDomain::vtkSMRelievoLayersDomain()
{
  // Skips ParaView's own, of its constructor. The list never changes, and the definition has
  // defaults.
  this->RemoveObservers(vtkCommand::DomainModifiedEvent);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
