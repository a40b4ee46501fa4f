// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoModelReader.h"

#include "vtkObjectFactory.h"

#include <cstring>

vtkStandardNewMacro(vtkPVRelievoModelReader);

const char* const vtkPVRelievoModelReader::NoName = "(none)";

namespace
{
const char* GetName(const char* chosen)
{
  return chosen && std::strcmp(chosen, vtkPVRelievoModelReader::NoName) == 0 ? nullptr : chosen;
}
}

//------------------------------------------------------------------------------
void vtkPVRelievoModelReader::SetBlendAnimation(const char* name)
{
  this->Superclass::SetBlendAnimation(GetName(name));
}

//------------------------------------------------------------------------------
void vtkPVRelievoModelReader::SetWeightsOf(const char* name)
{
  this->Superclass::SetWeightsOf(GetName(name));
}

//------------------------------------------------------------------------------
void vtkPVRelievoModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
