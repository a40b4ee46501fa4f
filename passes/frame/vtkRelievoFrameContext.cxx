// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameContext.h"

#include "vtkRelievoColorTarget.h"
#include "vtkRelievoResource.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkRelievoResource::~vtkRelievoResource() = default;

//------------------------------------------------------------------------------
std::string vtkRelievoResource::GetDefines() const
{
  return std::string();
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkRelievoFrameContext::GetAsked(const vtkRelievoStage* stage) const
{
  static const std::vector<std::string> nothing;
  const auto found = this->Asked.find(stage);
  return found == this->Asked.end() ? nothing : found->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::IsAsked(
  const vtkRelievoStage* stage, const std::string& resource) const
{
  const std::vector<std::string>& asked = this->GetAsked(stage);
  return std::binary_search(asked.begin(), asked.end(), resource);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::Provide(const std::string& name, vtkRelievoResource* resource)
{
  this->Resources[name] = resource;
}

//------------------------------------------------------------------------------
vtkRelievoResource* vtkRelievoFrameContext::Find(const std::string& name) const
{
  const auto found = this->Resources.find(name);
  return found == this->Resources.end() ? nullptr : found->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::DrawColor(vtkRelievoScreenQuad& quad, bool replaces)
{
  return this->Color && this->Color->Draw(*this, quad, replaces);
}
