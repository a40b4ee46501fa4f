// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelReader.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoBoneWeights.h"
#include "vtkRelievoModel.h"
#include "vtkRelievoModelFacets.h"
#include "vtkRelievoModelFile.h"
#include "vtkRelievoModelImages.h"
#include "vtkRelievoModelLook.h"
#include "vtkRelievoModelMorphs.h"
#include "vtkRelievoModelPlayback.h"
#include "vtkRelievoModelPose.h"
#include "vtkRelievoModelSources.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTexture.h"

#include <vtksys/SystemTools.hxx>

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

struct vtkRelievoModelReader::Internals
{
  relievo::Model Model;
  // The file and settings that the model was read with.
  std::string Path;
  std::vector<std::string> Folders;
  relievo::ModelSources Sources;
  int Weights = 0;
  bool Stands = false;
  vtkRelievoReportOnce Reported;                               // errors of names
  std::map<std::string, vtkSmartPointer<vtkImageData>> Images; // requested images
  vtkSmartPointer<vtkStringArray> Names = vtkSmartPointer<vtkStringArray>::New();
  vtkSmartPointer<vtkStringArray> Bones = vtkSmartPointer<vtkStringArray>::New();

  relievo::ModelLook Look;
  std::map<int, vtkSmartPointer<vtkProperty>> Properties; // of requested blocks
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  std::vector<vtkSmartPointer<vtkCamera>> Cameras;
  std::vector<glm::dmat4> Rest; // node to world
  double SunDistance = 0.;

  // Sets the playback from the reader's settings.
  void Choose(vtkRelievoModelReader& reader, relievo::ModelPlayback& play);
  // Whether the pose has the node in its rest position.
  bool IsAtRest(std::size_t node, const relievo::SkeletonPose& pose) const;
  // Moves lights and cameras to their nodes.
  void PlaceScene(const std::vector<glm::dmat4>& worlds);
  // Null for missing blocks, and for blocks without a material of the model.
  const relievo::ModelMaterial* FindMaterial(int block) const;
  bool HasCoordinates(int block) const;
};

vtkStandardNewMacro(vtkRelievoModelReader);

//------------------------------------------------------------------------------
vtkRelievoModelReader::vtkRelievoModelReader()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddNumber("blend_weight", vtkRelievoMember(BlendWeight), 0., 1., "",
    "The share of the blended animation: at 0 it has no effect, at 1 it replaces the other.");
  list.AddChoice("pose", vtkRelievoMember(Pose), { "rest", "nodes", "animation", "bind" },
    "Motion of the meshes: none, by the file's nodes, or by the animation. At rest the meshes "
    "carry their bones for the filter Skin. Bind shows the same meshes, and the skeleton where it "
    "was bound to them.");
  list
    .AddChoice("method", vtkRelievoMember(Method), { "linear", "dual_quaternion", "key_matrix" },
      "How bones are blended. Files are made for Linear. Dual Quaternion keeps the volume of "
      "joints that twist. Key Matrix blends the matrices of whole keys.")
    .ChoiceLabels = { "Linear", "Dual Quaternion", "Key Matrix" };
  list
    .AddWhole("weights_per_point", vtkRelievoMember(WeightsPerPoint), 1, 8, "",
      "Maximum number of bones of a point; the strongest are kept and rescaled.")
    .Advanced = true;
  list
    .AddFlag("slerp", vtkRelievoMember(Slerp),
      "Whether rotations have constant speed between keys (slerp). Otherwise they take the same "
      "way, a little unevenly (nlerp).")
    .Advanced = true;
  list
    .AddNumber("key_rate", vtkRelievoMember(KeyRate), 0., infinity, "",
      "Whole keys per second that the method Key Matrix blends; 0 uses every time at which any "
      "node has a key.")
    .Advanced = true;
  list.AddFlag("loop", vtkRelievoMember(Loop),
    "Whether the animation starts again after its end; otherwise the end holds.");
  list.AddNumber("speed", vtkRelievoMember(Speed), 1e-6, infinity, "",
    "Seconds of the animation per unit of time.");
  list.AddFlag("skeleton_axes", vtkRelievoMember(SkeletonAxes),
    "Whether the skeleton also has the axes of its joints. Colour by axis_color without mapping "
    "scalars to see x, y and z in red, green and blue.");
  list
    .AddNumber("axis_length", vtkRelievoMember(AxisLength), 0., infinity, "",
      "The length of these axes in world units; 0 uses 3 % of the model's diagonal at rest.")
    .Advanced = true;
  list.AddFlag("first_bone", vtkRelievoMember(FirstBone),
    "Whether points have the array first_bone: the point of the skeleton that holds them most.");
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
  relievo::ModelPlayback play;
  if (this->Read())
  {
    this->Internal->Choose(*this, play);
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
struct vtkRelievoModelReader::Moment
{
  relievo::SkeletonPose Pose;
  std::vector<relievo::ModelWeights> Weights; // of morph targets, by nodes; may be empty
};

//------------------------------------------------------------------------------
vtkRelievoModelReader::Moment vtkRelievoModelReader::MakeMoment(double time)
{
  const relievo::Model& model = this->Internal->Model;
  Moment moment;
  if (this->Pose == POSE_BIND)
  {
    moment.Pose.Now = relievo::GetBindMatrices(model);
    moment.Pose.Before = moment.Pose.Now;
    moment.Pose.After = moment.Pose.Now;
    moment.Weights = model.Weights;
    return moment;
  }
  relievo::ModelPlayback play;
  if (this->Pose != POSE_NODES)
  {
    this->Internal->Choose(*this, play);
  }
  moment.Pose = relievo::Play(model, play, time * this->Speed);
  moment.Weights = relievo::PlayMorphs(model, play, time * this->Speed);
  return moment;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::MakeSkeleton(const Moment& moment, vtkPolyData* skeleton)
{
  const relievo::Model& model = this->Internal->Model;
  const double length = this->AxisLength > 0. ? this->AxisLength : relievo::GetAxisLength(model);
  relievo::MakeSkeleton(model, moment.Pose, this->SkeletonAxes ? length : 0., skeleton);
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::MakeMesh(
  std::size_t place, const Moment& moment, vtkPolyData* skeleton, vtkPolyData* mesh)
{
  const relievo::ModelMesh& source = this->Internal->Model.Meshes[place];
  const auto node = static_cast<std::size_t>(source.Node);
  const vtkSmartPointer<vtkPolyData> shape = relievo::MorphMesh(
    source, node < moment.Weights.size() ? moment.Weights[node] : relievo::ModelWeights());
  const bool rests = this->Pose == POSE_REST || this->Pose == POSE_BIND;
  bool turned = false;
  if (rests)
  {
    mesh->ShallowCopy(shape);
  }
  else if (source.IsPlaced && this->Internal->IsAtRest(node, moment.Pose))
  {
    mesh->ShallowCopy(shape);
    relievo::TakeBones(mesh);
  }
  else
  {
    const std::string error = relievo::SkinMesh(shape, skeleton,
      static_cast<relievo::SkinMethod>(this->Method), vtkAlgorithm::DEFAULT_PRECISION, mesh);
    if (!error.empty())
    {
      vtkErrorMacro("mesh '" << source.Name << "': " << error);
      return;
    }
    turned = relievo::IsMirroredBy(source, moment.Pose.Now);
  }
  if (turned)
  {
    relievo::TurnFaces(mesh);
  }
  if (source.IsFaceted && (shape != source.Data || !rests))
  {
    relievo::GiveFaceNormals(mesh);
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
  // Returns 1 even on errors: after 0 the pipeline would add its own error, without a file name.
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
  const relievo::Model& model = this->Internal->Model;
  const int place = this->FindAnimation(this->Animation);
  if (!asked && place >= 0)
  {
    time = model.Animations[static_cast<std::size_t>(place)].Start / this->Speed;
  }
  // The first piece has everything, so that parallel processes together have it once.
  vtkInformation* asker = outputVector->GetInformationObject(0);
  const bool first = !asker->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) ||
    asker->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) <= 0;
  vtkNew<vtkPolyData> skeleton;
  Moment moment;
  if (first)
  {
    moment = this->MakeMoment(time);
    this->Internal->PlaceScene(moment.Pose.Now);
    this->MakeSkeleton(moment, skeleton);
    skeletonOutput->ShallowCopy(skeleton);
  }
  for (std::size_t i = 0; i < model.Meshes.size(); ++i)
  {
    const auto block = static_cast<unsigned int>(i);
    vtkNew<vtkPolyData> mesh;
    if (first)
    {
      this->MakeMesh(i, moment, skeleton, mesh);
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
  os << indent << "AllowedFolders:";
  for (const std::string& folder : this->AllowedFolders)
  {
    os << ' ' << folder;
  }
  os << "\n";
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

//------------------------------------------------------------------------------
void vtkRelievoModelReader::AddAllowedFolder(const char* folder)
{
  if (folder && *folder)
  {
    this->AllowedFolders.push_back(folder);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::RemoveAllAllowedFolders()
{
  if (!this->AllowedFolders.empty())
  {
    this->AllowedFolders.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::Read()
{
  Internals& self = *this->Internal;
  const std::string path = this->FileName ? this->FileName : "";
  if (path == self.Path && this->AllowedFolders == self.Folders &&
    this->WeightsPerPoint == self.Weights && self.Sources.AreSame())
  {
    return self.Stands; // its error has been reported
  }
  self = Internals();
  self.Path = path;
  self.Folders = this->AllowedFolders;
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
  const std::string error = relievo::ReadModel(
    path, self.Folders, this->WeightsPerPoint, progress, self.Sources, self.Model);
  self.Stands = error.empty();
  self.SunDistance = relievo::GetSunDistance(self.Model);
  self.Lights.resize(self.Model.Lights.size());
  self.Cameras.resize(self.Model.Cameras.size());
  std::vector<glm::dmat4> locals;
  for (const relievo::ModelNode& node : self.Model.Nodes)
  {
    locals.push_back(node.Rest);
  }
  self.Rest = relievo::GetWorldMatrices(self.Model.Nodes, locals);
  self.PlaceScene(self.Rest);
  if (!self.Stands)
  {
    this->SetErrorCode(vtksys::SystemTools::FileExists(path, true)
        ? vtkErrorCode::FileFormatError
        : vtkErrorCode::FileNotFoundError);
    vtkErrorMacro("cannot read " << path << ": " << error);
  }
  return self.Stands;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::FindAnimation(const char* name)
{
  Internals& self = *this->Internal;
  const std::vector<relievo::ModelAnimation>& all = self.Model.Animations;
  const std::string wanted = name ? name : "";
  std::string names;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted.empty() || all[i].Name == wanted)
    {
      return static_cast<int>(i);
    }
    names += (i ? ", '" : "'") + all[i].Name + "'";
  }
  if (!wanted.empty() && self.Reported.IsNew("animation " + wanted))
  {
    vtkErrorMacro(<< self.Path << ": there is no animation '" << wanted << "'; "
                  << (all.empty() ? "the file has none" : "it has " + names));
  }
  return -1;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::Internals::Choose(
  vtkRelievoModelReader& reader, relievo::ModelPlayback& play)
{
  const auto find = [&](const char* name) {
    const int place = reader.FindAnimation(name);
    return place < 0 ? nullptr : &this->Model.Animations[static_cast<std::size_t>(place)];
  };
  play.First = find(reader.Animation);
  const bool blends = play.First && reader.BlendAnimation && *reader.BlendAnimation;
  play.Second = blends ? find(reader.BlendAnimation) : nullptr;
  play.Weight = reader.BlendWeight;
  play.Slerp = reader.Slerp;
  play.Loop = reader.Loop;
  play.KeyRate = reader.KeyRate;
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::Internals::IsAtRest(
  std::size_t node, const relievo::SkeletonPose& pose) const
{
  const glm::dmat4& rest = this->Rest[node];
  return pose.Now[node] == rest && pose.Before[node] == rest && pose.After[node] == rest;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::Internals::PlaceScene(const std::vector<glm::dmat4>& worlds)
{
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    vtkSmartPointer<vtkLight>& light = this->Lights[i];
    light = light ? light : vtkSmartPointer<vtkLight>::New();
    const relievo::ModelLight& source = this->Model.Lights[i];
    const bool isSun = source.Is == relievo::ModelLight::Kind::Sun;
    relievo::PlaceLight(
      source, worlds[static_cast<std::size_t>(source.Node)], isSun ? this->SunDistance : 0., light);
  }
  for (std::size_t i = 0; i < this->Cameras.size(); ++i)
  {
    vtkSmartPointer<vtkCamera>& camera = this->Cameras[i];
    camera = camera ? camera : vtkSmartPointer<vtkCamera>::New();
    const relievo::ModelCamera& source = this->Model.Cameras[i];
    relievo::PlaceCamera(source, worlds[static_cast<std::size_t>(source.Node)], camera);
  }
}

//------------------------------------------------------------------------------
const relievo::ModelMaterial* vtkRelievoModelReader::Internals::FindMaterial(int block) const
{
  const std::vector<relievo::ModelMesh>& meshes = this->Model.Meshes;
  const bool there = block >= 0 && block < static_cast<int>(meshes.size());
  const int material = there ? meshes[static_cast<std::size_t>(block)].Material : -1;
  return material < 0 ? nullptr : &this->Model.Materials[static_cast<std::size_t>(material)];
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::Internals::HasCoordinates(int block) const
{
  return this->Model.Meshes[static_cast<std::size_t>(block)].Data->GetPointData()->GetTCoords();
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::FindBone()
{
  Internals& self = *this->Internal;
  const std::string wanted = this->WeightsOf ? this->WeightsOf : "";
  const std::vector<relievo::ModelNode>& nodes = self.Model.Nodes;
  const auto found =
    std::find_if(nodes.begin(), nodes.end(), [&wanted](const relievo::ModelNode& node) {
      return !wanted.empty() && node.IsBone && node.Name == wanted;
    });
  if (found != nodes.end())
  {
    return static_cast<int>(found - nodes.begin());
  }
  if (!wanted.empty() && self.Reported.IsNew("bone " + wanted))
  {
    std::string names;
    vtkStringArray* bones = this->GetBoneNames();
    constexpr vtkIdType most = 20;
    for (vtkIdType i = 0; i < std::min(most, bones->GetNumberOfValues()); ++i)
    {
      names += (i ? ", '" : "'") + bones->GetValue(i) + "'";
    }
    names += bones->GetNumberOfValues() > most ? " and more" : "";
    vtkErrorMacro(<< self.Path << ": there is no bone '" << wanted << "'; "
                  << (names.empty() ? "the file has none" : "it has " + names));
  }
  return -1;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfAnimations()
{
  return static_cast<int>(this->Internal->Model.Animations.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoModelReader::GetAnimationName(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfAnimations();
  return there ? this->Internal->Model.Animations[static_cast<std::size_t>(index)].Name.c_str()
               : nullptr;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoModelReader::GetAnimationNames()
{
  this->Internal->Names->SetNumberOfValues(0);
  for (const relievo::ModelAnimation& animation : this->Internal->Model.Animations)
  {
    this->Internal->Names->InsertNextValue(animation.Name);
  }
  return this->Internal->Names;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkRelievoModelReader::GetBoneNames()
{
  this->Internal->Bones->SetNumberOfValues(0);
  for (const relievo::ModelNode& node : this->Internal->Model.Nodes)
  {
    if (node.IsBone)
    {
      this->Internal->Bones->InsertNextValue(node.Name);
    }
  }
  return this->Internal->Bones;
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoModelReader::GetEmbeddedTexture(const char* name)
{
  Internals& self = *this->Internal;
  const auto found = self.Model.Images.find(name ? name : "");
  if (found == self.Model.Images.end())
  {
    return nullptr;
  }
  const auto [known, isNew] = self.Images.emplace(found->first, nullptr);
  if (isNew)
  {
    std::string error;
    known->second = relievo::DecodeImage(found->second, error);
    if (!error.empty())
    {
      vtkErrorMacro(<< self.Path << ": the image '" << found->first << "' in it: expected "
                    << error);
    }
  }
  return known->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::HasEmbeddedTexture(const char* name)
{
  return this->Internal->Model.Images.count(name ? name : "") > 0;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfNotes()
{
  return static_cast<int>(this->Internal->Model.Notes.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoModelReader::GetNote(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfNotes();
  return there ? this->Internal->Model.Notes[static_cast<std::size_t>(index)].c_str() : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfFiles()
{
  return static_cast<int>(this->Internal->Sources.GetPaths().size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoModelReader::GetFile(int index)
{
  const std::vector<std::string>& paths = this->Internal->Sources.GetPaths();
  const bool there = index >= 0 && index < this->GetNumberOfFiles();
  return there ? paths[static_cast<std::size_t>(index)].c_str() : nullptr;
}

//------------------------------------------------------------------------------
vtkProperty* vtkRelievoModelReader::GetProperty(int block)
{
  const relievo::ModelMaterial* material = this->Internal->FindMaterial(block);
  if (!material)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkProperty>& property = this->Internal->Properties[block];
  if (!property)
  {
    property = this->Internal->Look.MakeProperty(*material, this->Internal->HasCoordinates(block),
      [this](const std::string& name) { return this->GetEmbeddedTexture(name.c_str()); });
  }
  return property;
}

//------------------------------------------------------------------------------
vtkTexture* vtkRelievoModelReader::GetTexture(int block)
{
  const relievo::ModelMaterial* material = this->Internal->FindMaterial(block);
  return material
    ? this->Internal->Look
        .GetActorTexture(*material, this->Internal->HasCoordinates(block),
          [this](const std::string& name) { return this->GetEmbeddedTexture(name.c_str()); })
        .Get()
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetAlphaMode(int block)
{
  const relievo::ModelMaterial* material = this->Internal->FindMaterial(block);
  return material ? static_cast<int>(material->Alpha) : ALPHA_OPAQUE;
}

//------------------------------------------------------------------------------
double vtkRelievoModelReader::GetAlphaCutoff(int block)
{
  const relievo::ModelMaterial* material = this->Internal->FindMaterial(block);
  return material && material->Alpha == relievo::AlphaMode::Mask ? material->AlphaCutoff : 0.;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::ApplyMaterial(int block, vtkActor* actor)
{
  vtkProperty* property = this->GetProperty(block);
  if (!property || !actor)
  {
    return;
  }
  actor->SetProperty(property);
  actor->SetTexture(this->GetTexture(block));
  vtkTexture* base = property->GetTexture("albedoTex");
  const int alpha = this->GetAlphaMode(block);
  // A mask without a texture shows all or nothing.
  actor->SetForceOpaque(alpha == ALPHA_MASK && property->GetOpacity() > 0.);
  // VTK checks the actor's own texture, but not those of its property.
  actor->SetForceTranslucent(alpha == ALPHA_BLEND && base && base->IsTranslucent());
  if (vtkMapper* mapper = actor->GetMapper())
  {
    const bool colored =
      this->Internal->Model.Meshes[static_cast<std::size_t>(block)].Data->GetPointData()->HasArray(
        "RGBA");
    mapper->SetScalarVisibility(colored);
    if (colored)
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectColorArray("RGBA");
      mapper->SetColorModeToDirectScalars();
    }
  }
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfLights()
{
  return static_cast<int>(this->Internal->Lights.size());
}

//------------------------------------------------------------------------------
vtkLight* vtkRelievoModelReader::GetLight(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfLights();
  return there ? this->Internal->Lights[static_cast<std::size_t>(index)] : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoModelReader::GetNumberOfCameras()
{
  return static_cast<int>(this->Internal->Cameras.size());
}

//------------------------------------------------------------------------------
vtkCamera* vtkRelievoModelReader::GetCamera(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfCameras();
  return there ? this->Internal->Cameras[static_cast<std::size_t>(index)] : nullptr;
}
