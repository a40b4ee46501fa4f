// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelReader.h"

#include "vtkRelievoModelReaderInternals.h"

#include "vtkRelievoBoneWeights.h"
#include "vtkRelievoModelFile.h"
#include "vtkRelievoModelPose.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinPoints.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoModelReader);

//------------------------------------------------------------------------------
vtkRelievoModelReader::vtkRelievoModelReader()
  : Self(new Internals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkRelievoModelReader::~vtkRelievoModelReader()
{
  this->SetFileName(nullptr);
  this->SetAnimation(nullptr);
  this->SetBlendAnimation(nullptr);
  this->SetWeightsOf(nullptr);
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::CanReadFile(const char* fileName)
{
  return fileName && vtksys::SystemTools::FileExists(fileName, true) &&
    relievo::GetIsModelExtension(fileName);
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  relievo::ModelPlay play;
  if (this->Read())
  {
    this->Self->Choose(*this, play);
  }
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    std::vector<double> steps = relievo::GetTimes(play);
    if (steps.empty())
    {
      continue;
    }
    for (double& step : steps)
    {
      step /= this->Speed;
    }
    const double range[2] = { steps.front(), steps.back() };
    info->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::MakeSkeleton(double time, vtkPolyData* skeleton)
{
  const relievo::Model& model = this->Self->Model;
  relievo::SkeletonPose pose;
  if (this->Pose == POSE_BIND)
  {
    pose.Now = relievo::GetBindMatrices(model);
    pose.Before = pose.Now;
    pose.After = pose.Now;
  }
  else
  {
    relievo::ModelPlay play;
    if (this->Pose != POSE_NODES)
    {
      this->Self->Choose(*this, play);
    }
    pose = relievo::Play(model, play, time * this->Speed);
  }
  const double length = this->AxisLength > 0. ? this->AxisLength : relievo::GetAxisLength(model);
  relievo::MakeSkeleton(model, pose, this->SkeletonAxes ? length : 0., skeleton);
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::MakeMesh(std::size_t place, vtkPolyData* skeleton, vtkPolyData* mesh)
{
  const relievo::ModelMesh& source = this->Self->Model.Meshes[place];
  if (this->Pose == POSE_REST || this->Pose == POSE_BIND)
  {
    mesh->ShallowCopy(source.Data);
  }
  else
  {
    const std::string wrong = relievo::SkinMesh(source.Data, skeleton,
      static_cast<relievo::SkinMethod>(this->Method), vtkAlgorithm::DEFAULT_PRECISION, mesh);
    if (!wrong.empty())
    {
      vtkErrorMacro("mesh '" << source.Name << "': " << wrong);
      return;
    }
  }
  const int bone = this->FindBone();
  if (this->FirstBone || bone >= 0)
  {
    vtkNew<vtkRelievoBoneWeights> weights;
    weights->SetInputData(source.Data);
    weights->SetBone(bone);
    weights->Update();
    for (const char* name : { this->FirstBone ? relievo::FirstBoneArray : nullptr,
           bone >= 0 ? relievo::BoneWeightArray : nullptr })
    {
      if (name)
      {
        mesh->GetPointData()->AddArray(weights->GetOutput()->GetPointData()->GetArray(name));
        mesh->GetPointData()->SetActiveScalars(name);
      }
    }
  }
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  vtkPolyData* skeletonOutput = vtkPolyData::GetData(outputVector, 1);
  output->Initialize();
  skeletonOutput->Initialize();
  // Never 0 is returned: the pipeline would add an error of its own, which names no file.
  if (!this->Read())
  {
    return 1;
  }
  double time = 0.;
  bool asked = false;
  for (int port = 0; port < 2 && !asked; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    asked = info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    time = asked ? info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()) : time;
  }
  const relievo::Model& model = this->Self->Model;
  const int place = this->FindAnimation(this->Animation);
  if (!asked && place >= 0)
  {
    time = model.Animations[static_cast<std::size_t>(place)].Start / this->Speed;
  }
  // All of it is of the first piece: parallel processes together have it once.
  vtkInformation* asker = outputVector->GetInformationObject(0);
  const bool first = !asker->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) ||
    asker->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) <= 0;
  vtkNew<vtkPolyData> skeleton;
  if (first)
  {
    this->MakeSkeleton(time, skeleton);
    skeletonOutput->ShallowCopy(skeleton);
  }
  for (std::size_t i = 0; i < model.Meshes.size(); ++i)
  {
    const auto block = static_cast<unsigned int>(i);
    vtkNew<vtkPolyData> mesh;
    if (first)
    {
      this->MakeMesh(i, skeleton, mesh);
    }
    output->SetBlock(block, first ? mesh.Get() : nullptr);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), model.Meshes[i].Name);
  }
  for (vtkDataObject* each :
    { static_cast<vtkDataObject*>(output), static_cast<vtkDataObject*>(skeletonOutput) })
  {
    each->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  this->UpdateProgress(1.);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Animation: " << (this->Animation ? this->Animation : "(the first)") << "\n";
  os << indent << "BlendAnimation: " << (this->BlendAnimation ? this->BlendAnimation : "(none)")
     << "\n";
  os << indent << "BlendWeight: " << this->BlendWeight << "\n";
  os << indent << "Pose: " << this->Pose << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "WeightsPerPoint: " << this->WeightsPerPoint << "\n";
  os << indent << "Slerp: " << this->Slerp << "\n";
  os << indent << "KeyRate: " << this->KeyRate << "\n";
  os << indent << "Loop: " << this->Loop << ", at speed " << this->Speed << "\n";
  os << indent << "SkeletonAxes: " << this->SkeletonAxes << ", " << this->AxisLength << " long\n";
  os << indent << "FirstBone: " << this->FirstBone << "\n";
  os << indent << "WeightsOf: " << (this->WeightsOf ? this->WeightsOf : "(none)") << "\n";
}
