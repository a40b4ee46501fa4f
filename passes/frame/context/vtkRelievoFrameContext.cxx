// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameContext.h"

#include "vtkRelievoBoundFramebuffer.h"
#include "vtkRelievoFrameColor.h"
#include "vtkRelievoResource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Table = std::map<std::string, vtkRelievoResource*>;

vtkRelievoResource* FindFirst(const std::string& name, const Table& first, const Table& second)
{
  const auto found = first.find(name);
  if (found != first.end())
  {
    return found->second;
  }
  const auto other = second.find(name);
  return other == second.end() ? nullptr : other->second;
}
}

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
  const vtkRelievoStage* stage, const vtkRelievoResourceName& resource) const
{
  return this->IsLayerAsked(stage, resource.Get());
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::IsLayerAsked(
  const vtkRelievoStage* stage, const std::string& name) const
{
  const std::vector<std::string>& asked = this->GetAsked(stage);
  return std::binary_search(asked.begin(), asked.end(), name);
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::IsPlanned(const vtkRelievoResourceName& resource) const
{
  return std::any_of(this->Asked.begin(), this->Asked.end(),
    [this, &resource](const auto& asked) { return this->IsAsked(asked.first, resource); });
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::Provide(
  const vtkRelievoResourceName& name, vtkRelievoResource* resource)
{
  this->Resources[name.Get()] = resource;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::ProvideLayer(const std::string& name, vtkRelievoResource* resource)
{
  this->Layers[name] = resource;
}

//------------------------------------------------------------------------------
vtkRelievoResource* vtkRelievoFrameContext::Find(const vtkRelievoResourceName& name) const
{
  return FindFirst(name.Get(), this->Resources, this->Layers);
}

//------------------------------------------------------------------------------
vtkRelievoResource* vtkRelievoFrameContext::FindLayer(const std::string& name) const
{
  return FindFirst(name, this->Layers, this->Resources);
}

//------------------------------------------------------------------------------
double vtkRelievoFrameContext::GetDrawnDepthError(double depth) const
{
  if (vtkRelievoBoundFramebuffer::GetSamples() > 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  // One step of z, as much again for the rasteriser's interpolation, and the float rounding in the
  // conversion from z to depth.
  const int bits = std::min(vtkRelievoBoundFramebuffer::GetDepth().Bits, 24);
  const double range = this->View.Far - this->View.Near;
  const double slope =
    this->View.Parallel ? range : depth * depth * range / (this->View.Far * this->View.Near);
  return std::ldexp(slope, 2 - bits) +
    std::ldexp(this->View.Parallel ? this->View.Far : depth, -22);
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::DrawColor(vtkRelievoScreenQuad& quad, bool replaces, const int* part)
{
  return this->Color && this->Color->Draw(*this, quad, replaces, part);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::KeepTranslucentApart(vtkRelievoScreenTarget* target, bool putBack)
{
  this->Translucent = target;
  this->PutBack = putBack;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::WantTranslucentDepth(vtkRelievoTranslucentDepth* depth)
{
  this->TranslucentDepth = depth;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::Present(vtkRelievoScreenQuad& quad, const float* background)
{
  return this->Color && this->Picture && this->Color->Present(*this, &quad, background);
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameContext::PresentPart(
  vtkRelievoScreenQuad& quad, const int part[4], bool drawnOnly)
{
  return this->Finishes && this->Color->Present(*this, &quad, nullptr, part, drawnOnly);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::GetDrawnPart(int part[4]) const
{
  std::fill_n(part, 4, 0);
  if (this->Color)
  {
    this->Color->GetDrawnPart(part);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameContext::GetBackground(float color[4]) const
{
  std::fill_n(color, 4, 0.0f);
  if (this->Color)
  {
    this->Color->GetBackground(*this, color);
  }
}
