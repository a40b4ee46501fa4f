// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkin.h"

#include "vtkRelievoErrorOnce.h"
#include "vtkRelievoSkinPoints.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkRelievoSkin);

//------------------------------------------------------------------------------
vtkRelievoSkin::vtkRelievoSkin()
  : Errors(new relievo::ErrorOnce(this))
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkRelievoSkin::~vtkRelievoSkin() = default;

//------------------------------------------------------------------------------
int vtkRelievoSkin::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoSkin::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* skeleton = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::string error = relievo::SkinMesh(mesh, skeleton,
    static_cast<relievo::SkinMethod>(this->Method), this->OutputPointsPrecision, output);
  if (!error.empty() && this->Errors->IsNew(error))
  {
    vtkErrorMacro("" << error);
  }
  // Returns 1 even on errors: after 0 the pipeline would add its own error.
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSkin::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
