// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoDoubleVectorProperty.h"

#include "vtkObjectFactory.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMRelievoRange.h"

vtkStandardNewMacro(vtkSMRelievoDoubleVectorProperty);

//------------------------------------------------------------------------------
void vtkSMRelievoDoubleVectorProperty::WriteTo(vtkSMMessage* message)
{
  vtkSMRelievoRange::Enforce<vtkSMDoubleRangeDomain>(this);
  this->Superclass::WriteTo(message);
}

//------------------------------------------------------------------------------
void vtkSMRelievoDoubleVectorProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
