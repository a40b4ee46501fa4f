// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoIntVectorProperty.h"

#include "vtkObjectFactory.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMRelievoRange.h"

vtkStandardNewMacro(vtkSMRelievoIntVectorProperty);

//------------------------------------------------------------------------------
void vtkSMRelievoIntVectorProperty::WriteTo(vtkSMMessage* message)
{
  vtkSMRelievoRange::Enforce<vtkSMIntRangeDomain>(this);
  this->Superclass::WriteTo(message);
}

//------------------------------------------------------------------------------
void vtkSMRelievoIntVectorProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
