// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowVolumes.h"

#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoPlacedVolume.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowMapUniforms.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

using namespace vtkRelievoSpliceText;

namespace
{
const char* const VolumeExtensions = "//RELIEVO::ShadowVolume::Extensions";
const char* const VolumeDec = "//RELIEVO::ShadowVolume::Dec";
const char* const LightingDec = "//VTK::ComputeLighting::Dec";

std::string VolumeSection(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("shadow/volume.glsl", section);
}

// The lines of a section.
std::vector<std::string> GetLines(const char* section)
{
  std::vector<std::string> lines;
  std::istringstream text(VolumeSection(section));
  for (std::string line; std::getline(text, line);)
  {
    if (!line.empty())
    {
      lines.push_back(line);
    }
  }
  return lines;
}

// Multiplies VTK's lights by their visibility. Returns whether there were any.
bool DimLights(std::string& fragment)
{
  const std::string before = fragment;
  for (const std::string& number : GetLines("Numbers"))
  {
    for (std::string color : GetLines("Colors"))
    {
      std::string dimmed = color;
      FillWord(dimmed, GetLines("Color").front(), GetLines("DimmedColor").front());
      FillWord(color, "RELIEVO_NUMBER", number);
      FillWord(dimmed, "RELIEVO_NUMBER", number);
      FillWord(fragment, color, dimmed);
    }
  }
  return fragment != before;
}

// Whether all rays from the volumes to a light miss the box: it is beside the box of them and the
// light.
bool IsAside(
  const vtkRelievoBox& caster, const vtkRelievoBox& volumes, const vtkRelievoShadowLight& light)
{
  if (caster.Loose)
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    const bool up =
      light.Positional ? light.Position[i] > volumes.Max[i] : light.Direction[i] < 0.0;
    const bool down =
      light.Positional ? light.Position[i] < volumes.Min[i] : light.Direction[i] > 0.0;
    const double low = !down ? volumes.Min[i]
      : light.Positional     ? light.Position[i]
                             : -std::numeric_limits<double>::infinity();
    const double high = !up ? volumes.Max[i]
      : light.Positional    ? light.Position[i]
                            : std::numeric_limits<double>::infinity();
    if (caster.Max[i] < low || caster.Min[i] > high)
    {
      return true;
    }
  }
  return false;
}

// The lights from which surfaces may shade a volume.
std::vector<bool> FindPast(const vtkRelievoShadowContext& work)
{
  vtkRelievoBox volumes;
  volumes.Min = glm::dvec3(std::numeric_limits<double>::infinity());
  volumes.Max = -volumes.Min;
  for (vtkProp* prop : work.Props.GetVolumeReceivers())
  {
    const double* b = prop->GetBounds();
    volumes.Min = glm::min(volumes.Min, glm::dvec3(b[0], b[2], b[4]));
    volumes.Max = glm::max(volumes.Max, glm::dvec3(b[1], b[3], b[5]));
  }
  const std::vector<vtkRelievoBox> casters = work.Props.GetCasterBoxes(false);
  std::vector<bool> past;
  for (const auto& entry : work.Cache.GetEntries())
  {
    past.push_back(work.Others.IsOn() ||
      !std::all_of(casters.begin(), casters.end(),
        [&](const vtkRelievoBox& caster) { return IsAside(caster, volumes, entry.Light); }));
  }
  return past;
}

// The lights that are on, by their numbers in VTK's shader of volumes.
std::vector<int> GetSlots(
  const vtkRelievoShadowVolumes::Shadows& shadows, bool lampsFirst, std::size_t least)
{
  std::vector<vtkLight*> lights;
  for (const vtkRelievoFrameLight& light : vtkRelievoFrameScene::FindLights(shadows.Renderer))
  {
    if (light.ShaderIndex >= 0)
    {
      lights.push_back(light.Light);
    }
  }
  if (lampsFirst)
  {
    std::stable_partition(
      lights.begin(), lights.end(), [](vtkLight* light) { return light->GetPositional() != 0; });
  }
  std::vector<int> slots;
  for (vtkLight* light : lights)
  {
    const auto& entries = shadows.Work.Cache.GetEntries();
    const auto entry = std::find_if(entries.begin(), entries.end(),
      [&](const vtkRelievoShadowCache::Entry& each) { return each.Light.Light == light; });
    slots.push_back(entry == entries.end() ? -1 : static_cast<int>(entry - entries.begin()));
  }
  slots.resize(std::max(least, slots.size()), -1);
  return slots;
}
}

//------------------------------------------------------------------------------
vtkRelievoShadowVolumes::vtkRelievoShadowVolumes()
{
  this->Splice->Mark = [](std::string& fragment) {
    MarkBehind(fragment, "//VTK::System::Dec", VolumeExtensions);
    vtkShaderProgram::Substitute(
      fragment, LightingDec, std::string(VolumeDec) + "\n" + LightingDec, false);
  };
}

//------------------------------------------------------------------------------
void vtkRelievoShadowVolumes::Begin(const Shadows& shadows)
{
  const std::vector<vtkProp*>& props = shadows.Work.Props.GetVolumeReceivers();
  const vtkRelievoShadowStructure& structure = shadows.Work.Structure;
  if (props.empty() || structure.Lights.empty() || this->Begun || shadows.Strength <= 0.0)
  {
    return;
  }
  this->Begun = true;
  const std::vector<bool> past = FindPast(shadows.Work);
  if (past != this->Past)
  {
    this->Past = past;
    this->Splice->ModifyShaders();
  }
  this->Splice->Fill = [this, shadows](std::string& fragment, vtkVolumeMapper* mapper, vtkVolume*) {
    return vtkRelievoVolumeSplice::HasPartitions(mapper)
      ? std::string("it has partitions; call SetPartitions(1, 1, 1)")
      : this->Fill(fragment, shadows);
  };
  this->Splice->Set = [this, shadows](vtkShaderProgram* program, vtkVolumeMapper* mapper,
                        vtkVolume* volume) { this->SetUniforms(program, mapper, volume, shadows); };
  this->Splice->Report = shadows.Report;
  this->Splice->Begin(
    props, static_cast<vtkOpenGLRenderWindow*>(shadows.Renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
void vtkRelievoShadowVolumes::End()
{
  if (this->Begun)
  {
    this->Splice->End();
    this->Splice->Fill = nullptr;
    this->Splice->Set = nullptr;
    this->Splice->Report = nullptr;
    this->Begun = false;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowVolumes::Fill(std::string& fragment, const Shadows& shadows)
{
  const vtkRelievoShadowStructure& structure = shadows.Work.Structure;
  if (!DimLights(fragment)) // neither has a head light a shadow
  {
    FillMark(fragment, VolumeExtensions, "");
    FillMark(fragment, VolumeDec, "");
    return std::string();
  }
  const std::string begin = GetLines("FunctionBegin").front();
  std::size_t at = fragment.find(GetLines("Function").front());
  at = at == std::string::npos ? at : fragment.find(begin, at);
  if (at == std::string::npos || !Has(fragment, VolumeExtensions) || !Has(fragment, VolumeDec))
  {
    return "its fragment shader lacks VTK's tags System::Dec and ComputeLighting::Dec; use VTK's "
           "template";
  }
  fragment.insert(at + begin.size(), "\n" + VolumeSection("LookUp"));
  this->LampsFirst = Has(fragment, "NUMBER_POS_LIGHTS");
  std::string lookUps;
  int slot = 0;
  int face = 0;
  for (const vtkRelievoShadowStructure::Light& light : structure.Lights)
  {
    std::string past;
    if (this->Past[slot])
    {
      past += !structure.Maps ? "" : VolumeSection(light.Cube ? "CubeImpl" : "MapImpl");
      past += structure.Traced ? VolumeSection("TraceImpl") : "";
    }
    past += structure.Volumes ? VolumeSection("ShadeImpl") : "";
    std::string text = VolumeSection("LightImpl");
    FillWord(text, "RELIEVO_VOLUME_PAST", past);
    FillWord(text, "RELIEVO_SLOT", std::to_string(slot++));
    FillWord(text, "RELIEVO_FACE", std::to_string(face));
    face += light.GetRoom();
    lookUps += text;
  }
  const std::string method = shadows.Method.GetVolumeShader();
  const auto ofMethod = [&](const char* section) {
    return vtkRelievoShaderLibrary::GetSection(method, section);
  };
  std::string lit = VolumeSection("LitDec");
  FillWord(lit, "RELIEVO_VOLUME_LOOKUPS", lookUps);
  std::ostringstream dec;
  dec << "#define RELIEVO_SHADOW_LIGHTS " << structure.Lights.size() << "\n";
  dec << "#define RELIEVO_SHADOW_FACES " << structure.GetFaces() << "\n";
  dec << "#define RELIEVO_VOLUME_NUMBERS " << GetSlots(shadows, true, 1).size() << "\n";
  dec << (structure.Around ? "#define RELIEVO_VOLUME_AROUND\n" : "");
  dec << "#define RELIEVO_VOLUME_HARMONICS " << structure.Harmonics << "\n";
  dec << (structure.Colored ? "#define RELIEVO_SHADOW_COLORED\n" : "");
  dec << (structure.Tinted ? "#define RELIEVO_VOLUME_TINTED\n" : "");
  FillMark(fragment, VolumeExtensions,
    vtkRelievoShaderLibrary::GetSection("shadow/receive.glsl", "Extensions") + GetContract());
  FillMark(fragment, VolumeDec,
    dec.str() + VolumeSection("Dec") + ofMethod("MethodDec") +
      (structure.Traced ? ofMethod("TraceDec") : std::string()) +
      (structure.Volumes ? VolumeSection("ShadeDec") : std::string()) + lit);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowVolumes::SetUniforms(vtkShaderProgram* program, vtkVolumeMapper* mapper,
  vtkVolume* volume, const Shadows& shadows) const
{
  if (!program->IsUniformUsed("relievoVolumeSlot"))
  {
    return;
  }
  const vtkRelievoShadowContext& work = shadows.Work;
  const glm::dmat4 placeToWorld = vtkRelievoPlacedVolume::GetTextureToWorld(mapper, volume);
  const glm::dmat4 placeToView = work.View.WorldToView * placeToWorld;
  vtkRelievoShadowMapUniforms faces(work, work.Structure.GetFaces(), placeToView);
  std::vector<float> strengths;
  int first = 0;
  for (const auto& entry : work.Cache.GetEntries())
  {
    int face = first;
    for (const auto& map : entry.Maps)
    {
      faces.Set(face++, map, shadows.Method.GetBias(map.View, work.Bias));
    }
    first += work.Structure.Lights[strengths.size()].GetRoom();
    strengths.push_back(static_cast<float>(shadows.Strength * entry.Light.GetStrength()));
  }
  faces.Tell(program);
  const std::vector<int> slots = GetSlots(shadows, this->LampsFirst, 1);
  program->SetUniform1iv("relievoVolumeSlot", static_cast<int>(slots.size()), slots.data());
  program->SetUniform1fv(
    "relievoShadowStrength", static_cast<int>(strengths.size()), strengths.data());
  program->SetUniformf("relievoShadowInner", work.GetInner());
  program->SetUniformf("relievoShadowLift", 0.f);
  shadows.Method.SetVolumeUniforms(program, work, placeToView);
  if (work.Structure.Volumes)
  {
    work.Shade.SetUniforms(program, placeToWorld);
  }
}
