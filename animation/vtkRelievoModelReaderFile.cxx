// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What there is in the file.
#include "vtkRelievoModelReaderInternals.h"

#include "vtkRelievoModelFile.h"
#include "vtkRelievoModelImages.h"

#include "vtkErrorCode.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <vector>

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::Read()
{
  Internals& self = *this->Self;
  const std::string path = this->FileName ? this->FileName : "";
  if (path == self.Path && this->WeightsPerPoint == self.Weights && self.Sources.AreSame())
  {
    return self.Stands; // what is wrong with it was said
  }
  self = Internals();
  self.Path = path;
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
  const std::string wrong =
    relievo::ReadModel(path, this->WeightsPerPoint, progress, self.Sources, self.Model);
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
int vtkRelievoModelReader::FindAnimation(const char* name)
{
  Internals& self = *this->Self;
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
  if (!wanted.empty() && self.Refused.insert("animation " + wanted).second)
  {
    vtkErrorMacro(<< self.Path << ": there is no animation '" << wanted << "'; "
                  << (all.empty() ? "the file has none" : "it has " + names));
  }
  return -1;
}

//------------------------------------------------------------------------------
void vtkRelievoModelReader::Internals::Choose(
  vtkRelievoModelReader& reader, relievo::ModelPlay& play)
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
int vtkRelievoModelReader::FindBone()
{
  Internals& self = *this->Self;
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
  if (!wanted.empty() && self.Refused.insert("bone " + wanted).second)
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
vtkStringArray* vtkRelievoModelReader::GetBoneNames()
{
  this->Self->Bones->SetNumberOfValues(0);
  for (const relievo::ModelNode& node : this->Self->Model.Nodes)
  {
    if (node.IsBone)
    {
      this->Self->Bones->InsertNextValue(node.Name);
    }
  }
  return this->Self->Bones;
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoModelReader::GetEmbeddedTexture(const char* name)
{
  Internals& self = *this->Self;
  const auto found = self.Model.Images.find(name ? name : "");
  if (found == self.Model.Images.end())
  {
    return nullptr;
  }
  const auto [known, isNew] = self.Images.emplace(found->first, nullptr);
  if (isNew)
  {
    std::string wrong;
    known->second = relievo::DecodeImage(found->second, wrong);
    if (!wrong.empty())
    {
      vtkErrorMacro(<< self.Path << ": the image '" << found->first << "' in it: " << wrong);
    }
  }
  return known->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoModelReader::HasEmbeddedTexture(const char* name)
{
  return this->Self->Model.Images.count(name ? name : "") > 0;
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
