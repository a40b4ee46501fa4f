// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass tells VTK's mappers and their shaders.
#include "vtkRelievoShadowInternals.h"

#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoShaderTrial.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Internal->Spliced && vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    vtkRelievoShadowSplice::Mark(vertexShader, geometryShader, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Spliced || !mapper || !actor)
  {
    return true;
  }
  const std::string own[3] = { vertexShader, geometryShader, fragmentShader };
  std::string missing = vtkRelievoShadowSplice::Fill(
    vertexShader, geometryShader, fragmentShader, mapper, actor, in.Structure);
  std::string key = mapper->GetClassName() + missing;
  if (missing.empty())
  {
    key += "compiles not";
    missing = vtkRelievoShaderTrial::Compile(
      in.Window, actor->GetShaderProperty(), vertexShader, geometryShader, fragmentShader);
    if (!missing.empty())
    {
      vertexShader = own[0];
      geometryShader = own[1];
      fragmentShader = own[2];
    }
  }
  // Gaussian splats are known to cast and not to receive: nothing that a user could mend.
  const bool known = mapper->IsA("vtkOpenGLPointGaussianMapperHelper") != 0;
  if (!missing.empty() && !known && in.Said.insert(key).second)
  {
    vtkErrorMacro("No shadows on what " << mapper->GetClassName() << " draws: " << missing << ".");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetFrameParameters(vtkShaderProgram* program)
{
  Internals& in = *this->Internal;
  const glm::dmat4 viewToWorld = glm::inverse(in.View.WorldToView);
  const glm::dmat4 ndcToMap = vtkRelievoShadowMaps::GetNDCToMap(in.Maps.GetSize());
  // As the shader has it, in float.
  const glm::vec3 center(in.View.WorldToView * glm::dvec4(in.Cache.GetCenter(), 1.0));
  glm::dmat4 fromCenter(1.0);
  fromCenter[3] = glm::dvec4(glm::dvec3(center), 1.0);
  const int faces = in.Structure.GetFaces();
  // Where there is no map, every point is outside of it.
  glm::mat4 nowhere(0.f);
  nowhere[3] = glm::vec4(-1e9f, -1e9f, 0.f, 1.f);
  std::vector<glm::mat4> matrices(faces, nowhere);
  std::vector<glm::vec4> eyes(faces, glm::vec4(0.f));
  std::vector<float> texels(faces, 0.f);
  std::vector<float> layers(faces, 0.f);
  std::vector<float> lowest(faces, -1.f);
  std::vector<int> masks(faces, 0);
  std::vector<float> strengths;
  std::vector<int> slots(in.Structure.Numbers, -1);
  int first = 0;
  for (const auto& entry : in.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    const double strength = this->Strength * light.Light->GetShadowAttenuation();
    int face = first;
    for (const auto& map : entry.Maps)
    {
      const glm::dmat4 viewToMap =
        ndcToMap * map.View.ViewToNDC * (map.View.WorldToView * viewToWorld);
      glm::dmat4 biased = viewToMap;
      // The width of a texel of a warped map depends on the place: its bias as well.
      biased[3].z -= in.Structure.Warped ? 0.0 : this->Bias * map.View.Texel;
      matrices[face] = glm::mat4(biased * fromCenter);
      eyes[face] =
        glm::vec4(viewToMap * (in.View.Parallel ? glm::dvec4(0, 0, 1, 0) : glm::dvec4(0, 0, 0, 1)));
      texels[face] = static_cast<float>(map.View.Texel);
      lowest[face] = map.View.NearCut ? 1e-7f : -1e9f;
      masks[face] = static_cast<int>(strengths.size());
      layers[face++] = static_cast<float>(map.Layer);
    }
    first += in.Structure.Lights[strengths.size()].GetRoom();
    slots[light.Number] = static_cast<int>(strengths.size());
    strengths.push_back(this->Visible ? static_cast<float>(strength) : 0.f);
  }
  const int lights = static_cast<int>(strengths.size());
  program->SetUniformi("relievoShadowMaps", in.Maps.GetTextureUnit());
  program->SetUniform3f("relievoShadowCenter", &center.x);
  program->SetUniformMatrix4x4v("relievoShadowMatrix", faces, &matrices[0][0][0]);
  program->SetUniform4fv(
    "relievoShadowEye", faces, reinterpret_cast<const float(*)[4]>(&eyes[0][0]));
  program->SetUniform1fv("relievoShadowTexel", faces, texels.data());
  program->SetUniform1fv("relievoShadowLayer", faces, layers.data());
  program->SetUniform1fv("relievoShadowLowest", faces, lowest.data());
  program->SetUniform1fv("relievoShadowStrength", lights, strengths.data());
  program->SetUniform1iv("relievoShadowSlot", in.Structure.Numbers, slots.data());
  const bool mirrored = glm::determinant(glm::dmat3(in.View.WorldToView)) *
      glm::determinant(glm::dmat2(in.View.ViewToNDC)) <
    0.0;
  program->SetUniformf("relievoShadowHand", mirrored ? 1.f : -1.f);
  program->SetUniformf("relievoShadowSize", static_cast<float>(in.Maps.GetSize()));
  program->SetUniformi("relievoShadowRadius", in.Radius);
  if (in.Structure.Warped)
  {
    this->SetWarpParameters(program);
  }
  if (in.Structure.Forward)
  {
    // While maps are drawn there are no masks yet; the sampler needs a unit all the same.
    program->SetUniformi("relievoShadowMasks",
      in.Masks.GetTextureUnit() >= 0 ? in.Masks.GetTextureUnit() : in.Maps.GetTextureUnit());
    program->SetUniform1iv("relievoShadowMask", faces, masks.data());
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetWarpParameters(vtkShaderProgram* program)
{
  Internals& in = *this->Internal;
  const int faces = in.Structure.GetFaces();
  std::vector<glm::vec4> breaks(faces, glm::vec4(1e30f));
  std::vector<glm::vec4> scales(faces, glm::vec4(1.f, 0.f, 0.f, 0.f));
  std::vector<glm::vec4> offsets(faces, glm::vec4(0.f));
  std::vector<float> across(faces, 1.f);
  const double size = in.Maps.GetSize();
  int first = 0;
  int slot = 0;
  for (const auto& entry : in.Cache.GetEntries())
  {
    int face = first;
    for (const auto& map : entry.Maps)
    {
      // A texel's place x goes to scale * x + offset; each piece adds to what the one before has.
      const vtkRelievoMapAxis& axis = map.View.U;
      double scale = 0.0;
      double offset = 0.0;
      for (int i = 0; i < axis.Pieces; ++i)
      {
        const double s = (axis.To[i + 1] - axis.To[i]) / (axis.From[i + 1] - axis.From[i]);
        const double o = (axis.To[i] - s * axis.From[i]) * size + 0.5 * s - 0.5;
        scales[face][i] = static_cast<float>(s - scale);
        offsets[face][i] = static_cast<float>(o - offset);
        if (i > 0)
        {
          breaks[face][i - 1] = static_cast<float>(axis.From[i] * size - 0.5);
        }
        scale = s;
        offset = o;
      }
      across[face++] = static_cast<float>(map.View.Height / map.View.Width);
    }
    first += in.Structure.Lights[slot++].GetRoom();
  }
  auto floats = [](std::vector<glm::vec4>& v) {
    return reinterpret_cast<const float(*)[4]>(&v[0][0]);
  };
  program->SetUniform4fv("relievoShadowBreaks", faces, floats(breaks));
  program->SetUniform4fv("relievoShadowScales", faces, floats(scales));
  program->SetUniform4fv("relievoShadowOffsets", faces, floats(offsets));
  program->SetUniform1fv("relievoShadowAcross", faces, across.data());
  program->SetUniformf("relievoShadowBias", static_cast<float>(this->Bias));
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Spliced || !actor)
  {
    return true;
  }
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper))
  {
    in.PlainDraw.Learn(mapper);
  }
  if (in.DrawingMaps)
  {
    ++this->DrawCalls;
    in.LitForMaps.insert(program);
    // A sheet blocks light from both sides.
    in.Maps.DrawBothSides();
  }
  if (!program->IsUniformUsed("relievoShadowMaps"))
  {
    return true;
  }
  if (in.Told.insert(program).second)
  {
    this->SetFrameParameters(program);
  }
  vtkProperty* property = actor->GetProperty();
  program->SetUniformf("relievoShadowInner",
    in.Props.Receives(prop) ? 0.5f * (in.Maps.GetSize() - 1) - in.Radius : -1.f);
  if (in.Structure.Forward)
  {
    int region[4];
    vtkRelievoForwardMasks::GetViewport(region);
    // A mask is of the opaque surfaces that are seen, at the size of the viewport.
    const bool holds = !in.DrawingMaps && !in.DrawingDepth && actor->HasOpaqueGeometry() &&
      region[2] == in.View.Viewport[2] && region[3] == in.View.Viewport[3];
    program->SetUniformi("relievoShadowMasked", holds ? 1 : 0);
    program->SetUniform2i("relievoShadowOrigin", region);
  }
  program->SetUniformf(
    "relievoShadowLift", std::max(property->GetPointSize(), property->GetLineWidth()));
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoShadowPass::GetShaderStageMTime()
{
  // Asked outside of its own drawing by keys that were copied meanwhile: there it splices nothing.
  Internals& in = *this->Internal;
  if (!in.Spliced || in.Strayed)
  {
    in.StructureTime.Modified();
    in.Strayed = !in.Spliced;
  }
  return in.StructureTime.GetMTime();
}
