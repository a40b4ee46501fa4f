// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelReader.h"

#include "vtkRelievoModelFile.h"
#include "vtkRelievoModelPose.h"
#include "vtkRelievoSkeleton.h"
#include "vtkRelievoSkinPoints.h"

#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <vtksys/SystemTools.hxx>

#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoModelReader);

struct vtkRelievoModelReader::Internals
{
  relievo::Model Model;
  // What the model was read from.
  std::string Path;
  long int Modified = 0;
  int Weights = 0;
  bool Stands = false;
  std::string AnimationRefused; // which name was complained about
  vtkSmartPointer<vtkStringArray> Names = vtkSmartPointer<vtkStringArray>::New();
};

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
bool vtkRelievoModelReader::Read()
{
  Internals& self = *this->Self;
  const std::string path = this->FileName ? this->FileName : "";
  const long int modified = path.empty() ? 0 : vtksys::SystemTools::ModifiedTime(path);
  const bool same =
    path == self.Path && modified == self.Modified && this->WeightsPerPoint == self.Weights;
  if (same)
  {
    return self.Stands; // what is wrong with it was said
  }
  self = Internals();
  self.Path = path;
  self.Modified = modified;
  self.Weights = this->WeightsPerPoint;
  if (path.empty())
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name is set: call SetFileName");
    return false;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  const auto progress = [this](double share) {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  const std::string wrong = relievo::ReadModel(path, this->WeightsPerPoint, progress, self.Model);
  self.Stands = wrong.empty();
  if (!self.Stands)
  {
    this->SetErrorCode(vtksys::SystemTools::FileExists(path, true)
        ? vtkErrorCode::FileFormatError
        : vtkErrorCode::FileNotFoundError);
    vtkErrorMacro("cannot read " << path << ": " << wrong);
  }
  return self.Stands;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::FindAnimation()
{
  Internals& self = *this->Self;
  const std::vector<relievo::ModelAnimation>& all = self.Model.Animations;
  const std::string wanted = this->Animation ? this->Animation : "";
  std::string names;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted.empty() || all[i].Name == wanted)
    {
      return static_cast<int>(i);
    }
    names += (i ? ", '" : "'") + all[i].Name + "'";
  }
  if (!wanted.empty() && self.AnimationRefused != wanted)
  {
    self.AnimationRefused = wanted;
    vtkErrorMacro(<< self.Path << ": there is no animation '" << wanted << "'; "
                  << (all.empty() ? "the file has none" : "it has " + names));
  }
  return -1;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int place = this->Read() ? this->FindAnimation() : -1;
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    info->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
    if (place < 0)
    {
      continue;
    }
    const relievo::ModelAnimation& animation =
      this->Self->Model.Animations[static_cast<std::size_t>(place)];
    std::vector<double> steps = animation.KeyTimes;
    if (steps.back() < animation.End)
    {
      steps.push_back(animation.End);
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
  const int place = this->FindAnimation();
  relievo::SkeletonPose pose;
  if (place < 0 || this->Pose == POSE_NODES)
  {
    std::vector<glm::dmat4> locals;
    for (const relievo::ModelNode& node : model.Nodes)
    {
      locals.push_back(node.Rest);
    }
    pose.Now = relievo::GetWorldMatrices(model.Nodes, locals);
    pose.Before = pose.Now;
    pose.After = pose.Now;
  }
  else
  {
    const relievo::ModelAnimation& animation = model.Animations[static_cast<std::size_t>(place)];
    const auto getPose = [&](double at) {
      return relievo::GetWorldMatrices(
        model.Nodes, relievo::GetLocalMatrices(model, animation, at, this->Slerp));
    };
    const double at = relievo::GetAnimationTime(animation, time * this->Speed, this->Loop);
    const relievo::KeySpan span = relievo::GetKeySpan(animation, at, this->KeyRate);
    pose.Now = getPose(at);
    pose.Before = getPose(span.Before);
    pose.After = getPose(span.After);
    pose.Share = span.Share;
  }
  relievo::MakeSkeleton(model, pose, skeleton);
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
  const int place = this->FindAnimation();
  if (!asked && place >= 0)
  {
    time = model.Animations[static_cast<std::size_t>(place)].Start / this->Speed;
  }
  vtkNew<vtkPolyData> skeleton;
  this->MakeSkeleton(time, skeleton);
  skeletonOutput->ShallowCopy(skeleton);

  unsigned int block = 0;
  for (const relievo::ModelMesh& mesh : model.Meshes)
  {
    vtkNew<vtkPolyData> moved;
    if (this->Pose == POSE_REST)
    {
      moved->ShallowCopy(mesh.Data);
    }
    else
    {
      const std::string wrong = relievo::SkinMesh(
        mesh.Data, skeleton, static_cast<relievo::SkinMethod>(this->Method), moved);
      if (!wrong.empty())
      {
        vtkErrorMacro("mesh '" << mesh.Name << "': " << wrong);
      }
    }
    output->SetBlock(block, moved);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), mesh.Name);
    ++block;
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
int vtkRelievoModelReader::GetNumberOfAnimations()
{
  return static_cast<int>(this->Self->Model.Animations.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoModelReader::GetAnimationName(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfAnimations();
  return there ? this->Self->Model.Animations[static_cast<std::size_t>(index)].Name.c_str()
               : nullptr;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoModelReader::GetAnimationNames()
{
  this->Self->Names->SetNumberOfValues(0);
  for (const relievo::ModelAnimation& animation : this->Self->Model.Animations)
  {
    this->Self->Names->InsertNextValue(animation.Name);
  }
  return this->Self->Names;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfNotes()
{
  return static_cast<int>(this->Self->Model.Notes.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoModelReader::GetNote(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfNotes();
  return there ? this->Self->Model.Notes[static_cast<std::size_t>(index)].c_str() : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Animation: " << (this->Animation ? this->Animation : "(the first)") << "\n";
  os << indent << "Pose: " << this->Pose << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "WeightsPerPoint: " << this->WeightsPerPoint << "\n";
  os << indent << "Slerp: " << this->Slerp << "\n";
  os << indent << "KeyRate: " << this->KeyRate << "\n";
  os << indent << "Loop: " << this->Loop << "\n";
  os << indent << "Speed: " << this->Speed << "\n";
  os << indent << "Animations: " << this->GetNumberOfAnimations() << "\n";
}
