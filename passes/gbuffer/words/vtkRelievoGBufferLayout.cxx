// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferLayout.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoWordFormats.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr std::uint32_t NothingId = 0xffffffffu;

// The words that decode to a depth of +infinity, named by the formula file.
std::uint32_t GetDepthBackground(int format)
{
  switch (format)
  {
    case vtkRelievoWordFormats::DEPTH_16F:
      return relievo::f32::relievoDepth16FNone;
    case vtkRelievoWordFormats::DEPTH_WINDOW_Z24:
      return relievo::f32::relievoDepth24None;
    case vtkRelievoWordFormats::DEPTH_REVERSED_32F:
      return relievo::f32::relievoReversed32FNone;
    default:
      return relievo::f32::relievoDepth32FNone;
  }
}

std::vector<std::uint32_t> GetNormalDepthBackground(int format)
{
  using namespace relievo::f32;
  switch (format)
  {
    case vtkRelievoWordFormats::NORMAL_DEPTH_RGBA32F:
      return { relievoNormalDepth32FNone.x, relievoNormalDepth32FNone.y,
        relievoNormalDepth32FNone.z, relievoNormalDepth32FNone.w };
    case vtkRelievoWordFormats::NORMAL_DEPTH_RGBA16F:
      return { relievoNormalDepth16FNone.x, relievoNormalDepth16FNone.y };
    default:
      return { relievoNormalDepth8None };
  }
}
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetLight(const std::string& layer) const
{
  const auto found = this->Lights.find(layer);
  return found == this->Lights.end() ? vtkRelievoLayerCatalogue::GetLight(layer) : found->second;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetNormalWords(int format)
{
  switch (format)
  {
    case vtkRelievoWordFormats::NORMAL_FLOAT32:
      return 3;
    case vtkRelievoWordFormats::NORMAL_FLOAT16:
      return 2;
    default:
      return 1;
  }
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetNormalDepthWords(int format)
{
  return static_cast<int>(GetNormalDepthBackground(format).size());
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferLayout::Arrange()
{
  this->Background.clear();
  auto add = [this](const std::vector<std::uint32_t>& background) {
    const int first = this->GetNumberOfWords();
    this->Background.insert(this->Background.end(), background.begin(), background.end());
    return first;
  };

  const bool together = this->NormalDepth != vtkRelievoWordFormats::NORMAL_DEPTH_SEPARATE &&
    this->Normal && this->Depth;
  const bool depthAlone = this->Depth && !together;
  const bool normalAlone = this->Normal && !together;

  const int shadowWords = static_cast<int>(this->Shadows.size() + 1) / 2;
  const int normals = (normalAlone ? 1 : 0) + (this->GeometricNormal ? 1 : 0);
  this->ChosenNormalFormat = this->NormalFormat;
  if (this->NormalFormat == vtkRelievoWordFormats::NORMAL_AUTO)
  {
    // Full floats if they fit into the attachments of four words that are needed anyway, otherwise
    // one word. Narrow attachments do not count, so that values are the same as on a GPU.
    const int togetherWords = together ? GetNormalDepthWords(this->NormalDepth) : 0;
    const int others = togetherWords + (depthAlone ? 1 : 0) + (this->Ids ? 1 : 0) +
      (this->Places ? 2 : 0) + (this->Albedo ? 1 : 0) + (this->Surface ? 1 : 0) +
      (this->SurfaceDetail ? 1 : 0) + (this->SurfaceSpecular ? 1 : 0) +
      (this->DirectLight ? 1 : 0) + shadowWords;
    const int attachmentsFloat = (others + 3 * normals + 3) / 4;
    const int attachmentsPacked = (others + normals + 3) / 4;
    this->ChosenNormalFormat = attachmentsFloat == attachmentsPacked
      ? vtkRelievoWordFormats::NORMAL_FLOAT32
      : vtkRelievoWordFormats::NORMAL_OCT16;
  }
  // A normal's words are all 0 where there is none, in every format.
  const std::vector<std::uint32_t> noNormal(GetNormalWords(this->ChosenNormalFormat), 0u);
  this->NormalDepthWord = together ? add(GetNormalDepthBackground(this->NormalDepth)) : -1;
  this->DepthWord = depthAlone ? add({ GetDepthBackground(this->DepthFormat) }) : -1;
  this->IdWord = this->Ids ? add({ NothingId }) : -1;
  this->PlaceWord = this->Places ? add({ 0u, 0u }) : -1;
  this->NormalWord = normalAlone ? add(noNormal) : -1;
  this->GeometricNormalWord = this->GeometricNormal ? add(noNormal) : -1;
  this->AlbedoWord = this->Albedo ? add({ 0u }) : -1;
  this->SurfaceWord = this->Surface ? add({ 0u }) : -1;
  this->SurfaceDetailWord = this->SurfaceDetail ? add({ 0u }) : -1;
  this->SurfaceSpecularWord = this->SurfaceSpecular ? add({ 0u }) : -1;
  this->DirectLightWord = this->DirectLight ? add({ 0u }) : -1;
  // In the background no light is blocked.
  this->ShadowWord =
    shadowWords > 0 ? add(std::vector<std::uint32_t>(shadowWords, 0xffffffffu)) : -1;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetWordsPerAttachment() const
{
  return this->Narrow && this->GetNumberOfWords() <= 2 * MostAttachments ? 2 : 4;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetNumberOfAttachments() const
{
  const int words = this->GetWordsPerAttachment();
  return (this->GetNumberOfWords() + words - 1) / words;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferLayout::GetNumberOfChannels(int attachment) const
{
  const int words = this->GetWordsPerAttachment();
  const int rest = std::min(words, this->GetNumberOfWords() - words * attachment);
  return rest == 3 ? 4 : rest;
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferLayout::GetDefines() const
{
  std::ostringstream out;
  out << "#define RELIEVO_ATTACHMENTS " << this->GetNumberOfAttachments() << "\n";
  out << "#define RELIEVO_ATTACHMENT_WORDS " << this->GetWordsPerAttachment() << "\n";
  auto define = [&out](const char* name, int word) {
    if (word >= 0)
    {
      out << "#define RELIEVO_" << name << "_WORD " << word << "\n";
    }
  };
  define("NORMAL_DEPTH", this->NormalDepthWord);
  define("DEPTH", this->DepthWord);
  define("ID", this->IdWord);
  define("PLACE", this->PlaceWord);
  define("NORMAL", this->NormalWord);
  define("GEOMETRIC_NORMAL", this->GeometricNormalWord);
  define("ALBEDO", this->AlbedoWord);
  define("SURFACE", this->SurfaceWord);
  define("SURFACE_DETAIL", this->SurfaceDetailWord);
  define("SURFACE_SPECULAR", this->SurfaceSpecularWord);
  define("DIRECT_LIGHT", this->DirectLightWord);
  define("SHADOW", this->ShadowWord);
  for (std::size_t i = 0; i < this->Shadows.size(); ++i)
  {
    out << "#define RELIEVO_SHADOW_PLACE_" << this->Shadows[i] << " " << i << "\n";
  }
  out << (this->SurfaceSpecular || this->SurfacePbr ? "#define RELIEVO_GLOSSY_SURFACES\n" : "");
  out << "#define RELIEVO_NORMAL_FORMAT " << this->ChosenNormalFormat << "\n";
  out << "#define RELIEVO_DEPTH_FORMAT " << this->DepthFormat << "\n";
  out << "#define RELIEVO_NORMAL_DEPTH_FORMAT " << this->NormalDepth << "\n";
  return out.str();
}
