// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoneWeights.h"

#include "vtkRelievoErrorOnce.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinWeights.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <limits>

vtkStandardNewMacro(vtkRelievoBoneWeights);

//------------------------------------------------------------------------------
vtkRelievoBoneWeights::vtkRelievoBoneWeights()
  : Errors(new relievo::ErrorOnce(this))
{
  this->SetNumberOfInputPorts(2);
  this->Parameters.AddWhole("bone", vtkRelievoMember(Bone), -1, VTK_INT_MAX, "",
    "The bone whose weights are shown, as a point of the skeleton; -1 for none.");
}

//------------------------------------------------------------------------------
vtkRelievoBoneWeights::~vtkRelievoBoneWeights()
{
  this->SetBoneName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoBoneWeights::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoBoneWeights::Complain(const std::string& error)
{
  if (this->Errors->IsNew(error))
  {
    vtkErrorMacro("" << error);
  }
}

//------------------------------------------------------------------------------
int vtkRelievoBoneWeights::FindBone(vtkPolyData* skeleton)
{
  if (!this->BoneName || !*this->BoneName)
  {
    return this->Bone;
  }
  auto* names = vtkStringArray::SafeDownCast(
    skeleton ? skeleton->GetPointData()->GetAbstractArray("name") : nullptr);
  const vtkIdType found = names ? names->LookupValue(this->BoneName) : -1;
  if (found < 0)
  {
    this->Complain(names ? std::string("the skeleton has no bone ") + this->BoneName
                         : std::string("there is no skeleton to look for ") + this->BoneName +
          ": expected one with the point array name");
  }
  return static_cast<int>(found);
}

//------------------------------------------------------------------------------
int vtkRelievoBoneWeights::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(mesh);
  vtkDataArray* nodes = mesh->GetFieldData()->GetArray(relievo::BoneNodeArray);
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  relievo::SkinWeights weights;
  const std::string missing = weights.Read(mesh);
  if (!missing.empty())
  {
    this->Complain(missing);
    return 1;
  }
  const std::size_t bones = nodes ? static_cast<std::size_t>(nodes->GetNumberOfTuples())
                                  : std::size_t(std::numeric_limits<int>::max()) + 1;
  const int bone = this->FindBone(vtkPolyData::GetData(inputVector[1]));
  vtkNew<vtkIntArray> firsts;
  firsts->SetName(relievo::FirstBoneArray);
  firsts->SetNumberOfValues(count);
  vtkNew<vtkFloatArray> shares;
  shares->SetName(relievo::BoneWeightArray);
  shares->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    int first = -1;
    double most = 0.;
    double own = 0.;
    double sum = 0.;
    for (int k = 0; k < weights.GetCount(); ++k)
    {
      const int joint = weights.GetJoints(i)[k];
      const float weight = weights.GetWeights(i)[k];
      if (!relievo::IsInfluence(joint, weight, bones))
      {
        continue;
      }
      const int node = nodes ? static_cast<int>(nodes->GetComponent(joint, 0)) : joint;
      first = weight > most ? node : first;
      most = weight > most ? weight : most;
      own += node == bone ? weight : 0.;
      sum += weight;
    }
    firsts->SetValue(i, first);
    shares->SetValue(i, static_cast<float>(sum > 0. ? own / sum : 0.));
  }
  output->GetPointData()->AddArray(firsts);
  // Without nodes, joints are indices in the mesh's own list, unrelated to the skeleton.
  if (bone >= 0 && nodes)
  {
    output->GetPointData()->AddArray(shares);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoBoneWeights::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bone: " << this->Bone << "\n";
  os << indent << "BoneName: " << (this->BoneName ? this->BoneName : "(none)") << "\n";
}
