// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEmptySpaceStage.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRelievoDeclaration.h"
#include "vtkRelievoEmptyBlocks.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoVolumeSplice.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <list>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace
{
const char* const SkipFile = "volumes/skip.glsl";

// A tag of VTK's, behind or in front of which a section of the file goes.
struct SkipPlace
{
  const char* Tag;
  bool Before;
  const char* Section;
};
const SkipPlace SkipPlaces[] = { { "//VTK::DepthPeeling::Dec", false, "Dec" },
  { "//VTK::Shading::Init", false, "Begin" }, { "//VTK::Base::Impl", true, "Skip" },
  { "//VTK::Terminate::Impl", false, "Next" } };

// Without gradients a sample is about as expensive as the look-up of a block.
constexpr double LeastEmpty = 0.6;

bool HasGradients(vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  return property->GetShade() || property->HasGradientOpacity();
}

std::string GetSkipMark(const SkipPlace& place)
{
  return std::string("//RELIEVO::EmptySpace::") + place.Section;
}
}

class vtkRelievoEmptySpaceStage::Internals
{
public:
  // The blocks of a mapper, which may be inside of a volume's own.
  struct Drawn
  {
    vtkWeakPointer<vtkOpenGLGPUVolumeRayCastMapper> Mapper;
    vtkRelievoEmptyBlocks Blocks;
    std::string WhyInFull;
    std::optional<bool> Filled; // whether the last shader that was built should skip
    bool InFrame = false;
  };

  vtkNew<vtkRelievoVolumeSplice> Splice;
  std::list<Drawn> All;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context has the textures
  vtkRenderer* Renderer = nullptr;              // of the frame
  int Unit = -1;
  std::set<std::string> Others; // why volumes of the frame are drawn in full
  int Volumes = 0;              // of the frame, with parts that are left out
  vtkIdType Blocks = 0;         // theirs
  vtkIdType Empty = 0;

  // Brings a mapper's blocks up to date.
  Drawn& Update(vtkVolumeMapper* drawing, vtkVolume* volume)
  {
    auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(drawing);
    auto found = std::find_if(
      this->All.begin(), this->All.end(), [&](const Drawn& each) { return each.Mapper == mapper; });
    if (found == this->All.end())
    {
      found = this->All.emplace(this->All.end());
      found->Mapper = mapper;
    }
    found->WhyInFull = this->Unit < 0
      ? "this OpenGL has no free texture unit"
      : found->Blocks.Update(mapper, volume, HasGradients(volume) ? 0.0 : LeastEmpty, this->Window);
    if (!found->WhyInFull.empty())
    {
      found->Blocks.Release(); // a shader that VTK keeps skips nothing
    }
    return *found;
  }

  // Before a draw: sets the uniforms, and makes the notes of the report.
  void Set(vtkShaderProgram* program, vtkVolumeMapper* mapper, vtkVolume* volume)
  {
    Drawn& drawn = this->Update(mapper, volume);
    const bool skips = drawn.WhyInFull.empty();
    const bool spliced = program->IsUniformUsed("relievoEmptyBlocks");
    const bool filled = drawn.Filled.value_or(spliced);
    if (skips != filled && !program->IsUniformUsed("relievoVolumeRule"))
    {
      this->Splice->ModifyShaders(); // VTK kept its shader
    }
    if (spliced)
    {
      drawn.Blocks.SetUniforms(program, this->Window, this->Unit);
    }
    if (skips && spliced && !drawn.InFrame)
    {
      ++this->Volumes;
      this->Blocks += drawn.Blocks.GetNumber();
      this->Empty += drawn.Blocks.GetNumberEmpty();
    }
    drawn.InFrame = true;
    if (!skips || !spliced)
    {
      const std::string why = !skips ? drawn.WhyInFull
        : filled                     ? "its shader could not be changed"
                                     : "its shader changes with the next frame";
      const int number = this->Renderer->GetVolumes()->IsItemPresent(volume) - 1;
      this->Others.insert((number < 0 ? "a volume" : "volume " + std::to_string(number)) +
        " is drawn in full, since " + why);
    }
  }

  // Frees the blocks of volumes that were not drawn in the frame, or all, with the window's context
  // current.
  void Release(bool all)
  {
    for (auto drawn = this->All.begin(); drawn != this->All.end();)
    {
      const bool keep = !all && drawn->InFrame && drawn->Mapper;
      if (!keep)
      {
        drawn->Blocks.Release();
      }
      drawn = keep ? std::next(drawn) : this->All.erase(drawn);
    }
  }
};

vtkStandardNewMacro(vtkRelievoEmptySpaceStage);

//------------------------------------------------------------------------------
vtkRelievoEmptySpaceStage::vtkRelievoEmptySpaceStage()
  : Internal(new Internals)
{
  vtkRelievoVolumeSplice* splice = this->Internal->Splice;
  splice->Mark = [](std::string& fragment) {
    for (const SkipPlace& place : SkipPlaces)
    {
      const std::string mark = GetSkipMark(place);
      vtkRelievoSpliceText::FillMark(fragment, place.Tag,
        place.Before ? mark + "\n" + place.Tag : std::string(place.Tag) + "\n" + mark);
    }
  };
  splice->Fill = [this](std::string& fragment, vtkVolumeMapper* mapper, vtkVolume* volume) {
    Internals::Drawn& drawn = this->Internal->Update(mapper, volume);
    const bool skips = drawn.WhyInFull.empty();
    drawn.Filled = skips;
    const std::string defines = HasGradients(volume) ? "#define RELIEVO_EMPTY_PROBES\n" : "";
    for (const SkipPlace& place : SkipPlaces)
    {
      const std::string mark = GetSkipMark(place);
      if (skips && !vtkRelievoSpliceText::Has(fragment, mark))
      {
        return std::string("its shader has no place '") + place.Tag + "'; use VTK's template";
      }
      const std::string text = vtkRelievoShaderLibrary::GetSection(SkipFile, place.Section);
      vtkRelievoSpliceText::FillMark(
        fragment, mark, skips ? (&place == SkipPlaces ? defines : "") + text : std::string());
    }
    return std::string();
  };
  splice->Report = [this](const std::string& message) {
    vtkErrorMacro("Empty space is not skipped: " << message << ".");
  };
  splice->Set = [this](vtkShaderProgram* program, vtkVolumeMapper* mapper, vtkVolume* volume) {
    this->Internal->Set(program, mapper, volume);
  };
}

//------------------------------------------------------------------------------
vtkRelievoEmptySpaceStage::~vtkRelievoEmptySpaceStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoEmptySpaceStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "empty_space";
  description.Label = "Skip Empty Space";
  description.Help = "Draws volumes faster: rays skip the parts of a volume that are wholly "
                     "transparent. The picture stays the same.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { vtkRelievoResourceName::Of("empty space") };
}

//------------------------------------------------------------------------------
void vtkRelievoEmptySpaceStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  if (context.Renderer->GetVolumes()->GetNumberOfItems() == 0)
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = "there are no volumes";
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEmptySpaceStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Window != context.Window)
  {
    this->ReleaseGraphicsResources(in.Window);
    in.Window = context.Window;
  }
  in.Renderer = context.Renderer;
  in.Others.clear();
  in.Volumes = 0;
  in.Blocks = in.Empty = 0;
  std::vector<vtkProp*> props;
  for (const vtkRelievoFrameProp& each : context.Scene.Props)
  {
    vtkNew<vtkPropCollection> volumes;
    each.Prop->GetVolumes(volumes);
    if (volumes->GetNumberOfItems() > 0)
    {
      props.push_back(each.Prop);
    }
  }
  for (auto& drawn : in.All)
  {
    drawn.InFrame = false;
  }
  in.Unit = context.Window->GetState()->GetTextureUnitManager()->Allocate();
  in.Splice->Begin(props, context.Window);
}

//------------------------------------------------------------------------------
void vtkRelievoEmptySpaceStage::Finish(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Splice->End();
  in.Release(false);
  if (in.Unit >= 0)
  {
    vtkOpenGLState* state = context.Window->GetState();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(in.Unit));
    glBindTexture(GL_TEXTURE_3D, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    state->GetTextureUnitManager()->Free(in.Unit);
    in.Unit = -1;
  }
  std::string words;
  if (in.Volumes > 0)
  {
    words = "skips empty space of " + std::to_string(in.Volumes) +
      (in.Volumes == 1 ? " volume, " : " volumes, ") +
      std::to_string(
        static_cast<int>(100.0 * static_cast<double>(in.Empty) / static_cast<double>(in.Blocks))) +
      " % of whose blocks are transparent";
  }
  for (const std::string& other : in.Others)
  {
    words += (words.empty() ? "" : "; ") + other;
  }
  this->Explain(in.Volumes > 0 ? "ran" : "idle",
    words.empty() ? "no volume is drawn by rays on the GPU" : words);
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoEmptySpaceStage::GetFacts()
{
  const Internals& in = *this->Internal;
  return { { "skipped_volumes", vtkVariant(in.Volumes) },
    { "empty_share",
      in.Blocks > 0 ? vtkVariant(static_cast<double>(in.Empty) / static_cast<double>(in.Blocks))
                    : vtkVariant() } };
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoEmptySpaceStage::GetBytesHeld()
{
  vtkIdType bytes = 0;
  for (const auto& drawn : this->Internal->All)
  {
    bytes += drawn.Blocks.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoEmptySpaceStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  if (in.Window && !in.All.empty())
  {
    const vtkRelievoScopedContext current(in.Window);
    in.Release(true);
  }
  in.All.clear();
  in.Splice->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
