// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkin.h"

#include "vtkRelievoErrorOnce.h"
#include "vtkRelievoParameter.h"
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
  this->Parameters
    .AddChoice("method", vtkRelievoMember(Method), { "linear", "dual_quaternion", "key_matrix" },
      "How bones are blended. Files are made for Linear. Dual Quaternion keeps the volume of "
      "joints that twist. Key Matrix blends the matrices of whole keys.")
    .ChoiceLabels = { "Linear", "Dual Quaternion", "Key Matrix" };
  vtkRelievoParameter& precision = this->Parameters.AddChoice("output_points_precision",
    vtkRelievoMember(OutputPointsPrecision), { "single", "double", "input" },
    "Type of the coordinates. Double also for poses far from the origin, of meshes near it.");
  precision.Label = "Points' Precision";
  precision.ChoiceLabels = { "Single", "Double", "As they are" };
  precision.Advanced = true;
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
