// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameReader.h"

#include "vtkRelievoColorTarget.h"
#include "vtkRelievoSampleAccumulator.h"
#include "vtkRelievoStage.h"

#include <utility>

//------------------------------------------------------------------------------
void vtkRelievoFrameReader::SetFrame(
  Stages writers, Stages amenders, std::map<std::string, std::string> missing)
{
  this->Writers = std::move(writers);
  this->Amenders = std::move(amenders);
  this->Missing = std::move(missing);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameReader::Forget(vtkRelievoStage* stage)
{
  for (Stages* stages : { &this->Writers, &this->Amenders })
  {
    for (auto each = stages->begin(); each != stages->end();)
    {
      each = each->second == stage ? stages->erase(each) : std::next(each);
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoStage* vtkRelievoFrameReader::FindWriter(const std::string& name) const
{
  auto found = this->Writers.find(name);
  // The layers' stage may have made more than requested: range comes with depth.
  found = found == this->Writers.end() ? this->Writers.find(std::string()) : found;
  return found == this->Writers.end() ? nullptr : found->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameReader::IsAlone(const std::string& name) const
{
  return name == "color" || this->Samples.Has(name);
}

//------------------------------------------------------------------------------
// Reads the layers stage by stage, in the order of the names.
std::string vtkRelievoFrameReader::Read(const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const auto missing = this->Missing.find(name);
    if (missing != this->Missing.end())
    {
      return "The frame did not make the layer '" + name + "', " + missing->second + ".";
    }
  }
  std::string error;
  for (std::size_t from = 0; from < names.size() && error.empty();)
  {
    vtkRelievoStage* writer = this->FindWriter(names[from]);
    std::size_t to = from + 1;
    while (!this->IsAlone(names[from]) && to < names.size() && !this->IsAlone(names[to]) &&
      this->FindWriter(names[to]) == writer)
    {
      ++to;
    }
    if (names[from] == "color")
    {
      error = this->Color.Read(image);
      error = error.empty() ? error : "The layer 'color' cannot be read: " + error + ".";
    }
    else if (this->Samples.Has(names[from]))
    {
      error = this->Samples.Read(names[from], image);
    }
    else
    {
      const auto first = names.begin() + static_cast<std::ptrdiff_t>(from);
      const auto last = names.begin() + static_cast<std::ptrdiff_t>(to);
      error = writer ? writer->ReadLayers({ first, last }, image)
                     : "The layer '" + names[from] +
          "' cannot be read: the last frame made no layers; ask for it (RequestLayer) and render "
          "before.";
    }
    from = to;
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameReader::Amend(const std::vector<std::string>& names, vtkImageData* image)
{
  std::map<vtkRelievoStage*, std::vector<std::string>> amended;
  for (const std::string& name : names)
  {
    const auto found = this->Amenders.find(name);
    if (found != this->Amenders.end() && !found->second)
    {
      return "The layer '" + name +
        "' cannot be read: another stage amends it, and does so only in frames that are asked for "
        "it; call RequestLayer and render before.";
    }
    if (found != this->Amenders.end())
    {
      amended[found->second].push_back(name);
    }
  }
  std::string error;
  for (const auto& [stage, layers] : amended)
  {
    error = error.empty() ? stage->ReadLayers(layers, image) : error;
  }
  return error;
}
