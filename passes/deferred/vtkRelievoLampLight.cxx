// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampLight.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLampsStage.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoTiles.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Take(
  vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, int casting)
{
  const glm::dmat4 toPicture = vtkRelievoGetTileToPicture(context.Renderer);
  vtkRelievoWithThreads([&]() { this->List.Take(context.View, sets, toPicture); });
  std::vector<double> strengths;
  this->Casting = this->List.TakeCasting(casting, strengths);
  context.CastingLamps.clear();
  for (const vtkRelievoLampList::Lamp& lamp : this->Casting.GetLamps())
  {
    const double* row = lamp.Row;
    context.CastingLamps.push_back(
      { glm::dvec3(row[0], row[1], row[2]), row[3], strengths[context.CastingLamps.size()] });
  }
}

//------------------------------------------------------------------------------
// Casting lamps are always drawn as quads.
bool vtkRelievoLampLight::HasQuads() const
{
  return this->Way == vtkRelievoLampsStage::QUADS || !this->Casting.GetLamps().empty();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Prepare(
  vtkRelievoFrameContext& context, int way, const Buffers& buffers)
{
  this->Way = way;
  this->Counting = buffers.Counts;
  this->Floats = buffers.Floats;
  this->Computed = this->Reaching = -1.0;
  const bool quads = this->HasQuads();
  if (way == vtkRelievoLampsStage::CLUSTERS)
  {
    vtkRelievoWithThreads([&]() { this->Clusters.Build(context.View, this->List); });
  }
  else
  {
    this->Cells.Release(context.Window);
    this->Lists.Release(context.Window);
  }
  if (way != vtkRelievoLampsStage::QUADS)
  {
    this->Quads.Release(context.Window);
  }
  if (this->Casting.GetLamps().empty())
  {
    this->CastingQuads.Release(context.Window);
    this->CastingLamps.Release(context.Window);
  }
  if (!buffers.Sums)
  {
    this->Sum.Release(context.Window);
    this->Gloss.Release(context.Window);
    this->Counts.Release(context.Window);
    return {};
  }
  // Half floats lose addends that are small beside the sum so far, so rectangles add up in floats.
  const bool white = this->List.IsWhite();
  const std::string error =
    this->Sum.Prepare(context, { white ? 1 : 4, !this->Floats && !quads, quads });
  this->Sum.SetDefines(white ? "#define RELIEVO_WHITE_LIGHT\n" : "");
  if (this->Counting && error.empty())
  {
    return this->Counts.Prepare(context, { 2, false, quads });
  }
  this->Counts.Release(context.Window);
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Draw(vtkRelievoFrameContext& context, bool glossy)
{
  std::string error = this->DrawInto(context, this->Sum, this->Lights,
    this->Sum.GetFormat().Halves ? "#define RELIEVO_HALVES\n" : "");
  const bool quads = this->HasQuads();
  if (!glossy)
  {
    this->Gloss.Release(context.Window);
  }
  else if (error.empty())
  {
    error = this->Gloss.Prepare(context, { 4, !this->Floats && !quads, quads });
    this->Gloss.SetDefines("#define RELIEVO_GLOSS\n");
  }
  if (glossy && error.empty())
  {
    error = this->DrawInto(context, this->Gloss, this->Glosses,
      this->Gloss.GetFormat().Halves ? "#define RELIEVO_GLOSS\n#define RELIEVO_HALVES\n"
                                     : "#define RELIEVO_GLOSS\n");
  }
  if (error.empty() && this->Counting)
  {
    error = this->DrawInto(context, this->Counts, this->Counter, "#define RELIEVO_COUNT_LAMPS\n");
    this->SumCounts();
  }
  return error;
}

//------------------------------------------------------------------------------
double vtkRelievoLampLight::FindReached(float all[4]) const
{
  double sum = 0.0;
  for (const vtkRelievoLampList::Lamp& lamp : this->List.GetLamps())
  {
    const float* r = lamp.Rectangle;
    if (r[0] >= r[2] || r[1] >= r[3])
    {
      continue;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      all[axis] = sum > 0.0 ? std::min(all[axis], r[axis]) : r[axis];
      all[axis + 2] = sum > 0.0 ? std::max(all[axis + 2], r[axis + 2]) : r[axis + 2];
    }
    sum += static_cast<double>(r[2] - r[0]) * (r[3] - r[1]);
  }
  return sum > 0.0 ? sum / (static_cast<double>(all[2] - all[0]) * (all[3] - all[1])) : 0.0;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Add(vtkRelievoFrameContext& context, bool glossy)
{
  float all[4];
  if (!(this->FindReached(all) > 0.0))
  {
    return {};
  }
  const int* size = context.View.Viewport + 2;
  int part[4];
  context.GetDrawnPart(part);
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto scale = 0.5f * static_cast<float>(size[axis]);
    const int begin = static_cast<int>(std::floor(scale * (all[axis] + 1.0f)));
    const int end = static_cast<int>(std::ceil(scale * (all[axis + 2] + 1.0f)));
    const int last = std::min(part[axis] + part[axis + 2], end);
    part[axis] = std::max(part[axis], begin);
    part[axis + 2] = last - part[axis];
  }
  if (part[2] <= 0 || part[3] <= 0)
  {
    return {};
  }
  std::string defines = "#define RELIEVO_LAMPS_ON_COLOR\n";
  defines += glossy ? "#define RELIEVO_GLOSS\n" : "";
  const bool finishes = context.FinishesColor();
  defines += finishes ? "#define RELIEVO_TO_DISPLAY\n" : "";
  std::vector<vtkRelievoResourceName> reads{ vtkRelievoResources::Depth,
    vtkRelievoResources::Normal, vtkRelievoResources::Surface, vtkRelievoResources::Color };
  if (finishes)
  {
    reads.push_back(vtkRelievoResources::Drawn);
  }
  if (vtkShaderProgram* program = this->ReadyPixels(context, this->Adder, reads, defines))
  {
    this->Bind(program, false);
    const bool drawn = finishes ? context.PresentPart(this->Adder, part, true)
                                : context.DrawColor(this->Adder, true, part);
    this->DrawCalls += drawn ? 1 : 0;
    this->Unbind();
  }
  return this->Adder.GetError();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Upload(vtkRelievoFrameContext& context)
{
  this->DrawCalls = 0;
  std::string error = this->Lamps.Upload(context.Window, this->List.GetTexels(), 4);
  if (error.empty() && !this->Casting.GetLamps().empty())
  {
    error = this->CastingLamps.Upload(context.Window, this->Casting.GetTexels(), 4);
  }
  if (error.empty())
  {
    error = this->Attenuations.Upload(context.Window, this->List.GetAttenuations(), 4);
  }
  if (error.empty() && this->Way == vtkRelievoLampsStage::CLUSTERS)
  {
    error = this->Cells.Upload(context.Window, this->Clusters.GetCells(), 1);
    error =
      !error.empty() ? error : this->Lists.Upload(context.Window, this->Clusters.GetLists(), 1);
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Bind(vtkShaderProgram* program, bool casting)
{
  (casting ? this->CastingLamps : this->Lamps).Activate(program, "relievoLamps");
  this->Attenuations.Activate(program, "relievoLampAttenuations");
  if (this->Way == vtkRelievoLampsStage::CLUSTERS && !casting)
  {
    this->Cells.Activate(program, "relievoCells");
    this->Lists.Activate(program, "relievoLists");
    this->Clusters.SetUniforms(program);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Unbind()
{
  for (vtkRelievoTextureBuffer* buffer :
    { &this->Lamps, &this->CastingLamps, &this->Attenuations, &this->Cells, &this->Lists })
  {
    buffer->Deactivate();
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::DrawInto(vtkRelievoFrameContext& context,
  vtkRelievoScreenTarget& target, vtkRelievoScreenQuad& quad, const std::string& defines)
{
  target.Begin(context);
  std::string error;
  if (this->Way != vtkRelievoLampsStage::QUADS && !this->List.GetLamps().empty())
  {
    error = this->DrawPixels(context, target, quad, defines);
  }
  if (error.empty() && this->HasQuads())
  {
    error = this->DrawQuads(context, target, defines);
  }
  target.End();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::DrawQuads(
  vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target, const std::string& defines)
{
  const bool others = this->Way == vtkRelievoLampsStage::QUADS && !this->List.GetLamps().empty();
  const bool casting = !this->Casting.GetLamps().empty();
  std::string error;
  if (others || casting)
  {
    error = (others ? this->Quads : this->CastingQuads).DrawSurfaces(context, target);
    ++this->DrawCalls;
  }
  if (others && error.empty())
  {
    error = this->Quads.Draw(
      context, this->List, defines,
      [this](vtkShaderProgram* program) { this->Bind(program, false); }, nullptr, this->DrawCalls);
    this->Unbind();
  }
  if (casting && error.empty())
  {
    // The count of computed lamps does not depend on their shadows.
    auto* shadows = &target == &this->Counts
      ? nullptr
      : static_cast<vtkRelievoLampShadows*>(context.Find(vtkRelievoResources::LampShadows));
    error = this->CastingQuads.Draw(
      context, this->Casting, defines,
      [this](vtkShaderProgram* program) { this->Bind(program, true); }, shadows, this->DrawCalls);
    this->Unbind();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::DrawPixels(vtkRelievoFrameContext& context,
  vtkRelievoScreenTarget& target, vtkRelievoScreenQuad& quad, const std::string& defines)
{
  std::vector<vtkRelievoResourceName> reads{ vtkRelievoResources::Depth,
    vtkRelievoResources::Normal };
  if (&target == &this->Gloss)
  {
    reads.push_back(vtkRelievoResources::Surface);
  }
  if (vtkShaderProgram* program = this->ReadyPixels(context, quad, reads, defines))
  {
    this->Bind(program, false);
    quad.Draw(context, target.GetArea());
    this->Unbind();
    ++this->DrawCalls;
  }
  return quad.GetError();
}

//------------------------------------------------------------------------------
// Prepares the quad in which each pixel loops over its lamps.
vtkShaderProgram* vtkRelievoLampLight::ReadyPixels(vtkRelievoFrameContext& context,
  vtkRelievoScreenQuad& quad, const std::vector<vtkRelievoResourceName>& reads, std::string defines)
{
  defines +=
    this->Way == vtkRelievoLampsStage::CLUSTERS ? "#define RELIEVO_LAMPS_IN_CLUSTERS\n" : "";
  const bool one = this->Way == vtkRelievoLampsStage::ALL && this->List.GetLamps().size() == 1;
  defines += one ? "#define RELIEVO_ONE_LAMP\n" : "";
  defines += this->List.IsLinear() ? "#define RELIEVO_LINEAR_LAMPS\n" : "";
  defines += context.View.Parallel ? "#define RELIEVO_LINEAR_SLICES\n" : "";
  vtkShaderProgram* program = quad.Ready(context, "deferred/lampsFS.glsl", reads, defines);
  if (program)
  {
    program->SetUniformi("relievoLampCount", static_cast<int>(this->List.GetLamps().size()));
    if (one)
    {
      const auto* texels = reinterpret_cast<const float(*)[4]>(this->List.GetTexels().data());
      program->SetUniform4fv("relievoOnlyLamp", 2, texels);
    }
  }
  return program;
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::SumCounts()
{
  vtkNew<vtkImageData> image;
  double* const means[2] = { &this->Computed, &this->Reaching };
  for (int i = 0; i < 2; ++i)
  {
    if (!this->Counts.Read("count", 1, image, i).empty())
    {
      return;
    }
    vtkDataArray* array = image->GetPointData()->GetArray("count");
    double sum = 0.0;
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
    {
      sum += array->GetComponent(k, 0);
    }
    *means[i] = sum / static_cast<double>(array->GetNumberOfTuples());
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLampLight::GetBytes() const
{
  return this->Sum.GetBytes() + this->Gloss.GetBytes() + this->Counts.GetBytes() +
    this->Lamps.GetBytes() + this->Attenuations.GetBytes() + this->Cells.GetBytes() +
    this->Lists.GetBytes() + this->Quads.GetBytes() + this->CastingQuads.GetBytes() +
    this->CastingLamps.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Release(vtkWindow* window)
{
  this->Sum.Release(window);
  this->Gloss.Release(window);
  this->Counts.Release(window);
  this->Adder.Release(window);
  this->Lights.Release(window);
  this->Glosses.Release(window);
  this->Counter.Release(window);
  this->Quads.Release(window);
  this->CastingQuads.Release(window);
  for (vtkRelievoTextureBuffer* buffer :
    { &this->Lamps, &this->CastingLamps, &this->Attenuations, &this->Cells, &this->Lists })
  {
    buffer->Release(window);
  }
}
