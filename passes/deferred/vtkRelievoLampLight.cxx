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
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Take(
  vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets)
{
  vtkRelievoWithThreads([&]() { this->List.Take(context.View, sets); });
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Prepare(
  vtkRelievoFrameContext& context, int way, bool floats, bool counts)
{
  this->Way = way;
  this->Counting = counts;
  this->Floats = floats;
  this->Computed = this->Reaching = -1.0;
  const bool quads = way == vtkRelievoLampsStage::QUADS;
  if (way == vtkRelievoLampsStage::CLUSTERS)
  {
    vtkRelievoWithThreads([&]() { this->Clusters.Build(context.View, this->List); });
  }
  else
  {
    this->Cells.Release(context.Window);
    this->Lists.Release(context.Window);
  }
  if (!quads)
  {
    this->Quads.Release(context.Window);
  }
  // Half floats lose what is small beside the sum so far: rectangles add to floats.
  const bool white = this->List.IsWhite();
  const std::string wrong = this->Sum.Prepare(context, { white ? 1 : 4, !floats && !quads, quads });
  this->Sum.SetDefines(white ? "#define RELIEVO_WHITE_LIGHT\n" : "");
  if (counts && wrong.empty())
  {
    return this->Counts.Prepare(context, { 2, false, quads });
  }
  this->Counts.Release(context.Window);
  return wrong;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Draw(vtkRelievoFrameContext& context, bool glossy)
{
  this->DrawCalls = 0;
  std::string wrong = this->Upload(context);
  if (wrong.empty())
  {
    wrong = this->DrawInto(context, this->Sum, this->Lights,
      this->Sum.GetFormat().Halves ? "#define RELIEVO_HALVES\n" : "");
  }
  const bool quads = this->Way == vtkRelievoLampsStage::QUADS;
  if (!glossy)
  {
    this->Gloss.Release(context.Window);
  }
  else if (wrong.empty())
  {
    wrong = this->Gloss.Prepare(context, { 4, !this->Floats && !quads, quads });
    this->Gloss.SetDefines("#define RELIEVO_GLOSS\n");
  }
  if (glossy && wrong.empty())
  {
    wrong = this->DrawInto(context, this->Gloss, this->Glosses,
      this->Gloss.GetFormat().Halves ? "#define RELIEVO_GLOSS\n#define RELIEVO_HALVES\n"
                                     : "#define RELIEVO_GLOSS\n");
  }
  if (wrong.empty() && this->Counting)
  {
    wrong = this->DrawInto(context, this->Counts, this->Counter, "#define RELIEVO_COUNT_LAMPS\n");
    this->SumCounts();
  }
  return wrong;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::Upload(vtkRelievoFrameContext& context)
{
  std::string wrong = this->Lamps.Upload(context.Window, this->List.GetTexels(), 4);
  if (wrong.empty())
  {
    wrong = this->Attenuations.Upload(context.Window, this->List.GetAttenuations(), 4);
  }
  if (wrong.empty() && this->Way == vtkRelievoLampsStage::CLUSTERS)
  {
    wrong = this->Cells.Upload(context.Window, this->Clusters.GetCells(), 1);
    wrong =
      !wrong.empty() ? wrong : this->Lists.Upload(context.Window, this->Clusters.GetLists(), 1);
  }
  return wrong;
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Bind(vtkShaderProgram* program)
{
  this->Lamps.Activate(program, "relievoLamps");
  this->Attenuations.Activate(program, "relievoLampAttenuations");
  program->SetUniformi("relievoLampCount", static_cast<int>(this->List.GetLamps().size()));
  if (this->Way == vtkRelievoLampsStage::CLUSTERS)
  {
    this->Cells.Activate(program, "relievoCells");
    this->Lists.Activate(program, "relievoLists");
    program->SetUniformi("relievoColumns", this->Clusters.GetColumns());
    program->SetUniformi("relievoRows", this->Clusters.GetRows());
    program->SetUniformi("relievoSlices", this->Clusters.GetSlices());
    program->SetUniformi("relievoTile", this->Clusters.GetTile());
    program->SetUniformf("relievoSliceScale", this->Clusters.GetSliceScale());
    program->SetUniformf("relievoSliceOffset", this->Clusters.GetSliceOffset());
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Unbind()
{
  this->Lamps.Deactivate();
  this->Attenuations.Deactivate();
  if (this->Way == vtkRelievoLampsStage::CLUSTERS)
  {
    this->Cells.Deactivate();
    this->Lists.Deactivate();
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampLight::DrawInto(vtkRelievoFrameContext& context,
  vtkRelievoScreenTarget& target, vtkRelievoScreenQuad& quad, const std::string& defines)
{
  target.Begin(context);
  std::string wrong;
  if (this->List.GetLamps().empty())
  {
    // Cleared is what it is.
  }
  else if (this->Way == vtkRelievoLampsStage::QUADS)
  {
    wrong = this->Quads.Draw(context, this->List, target, defines,
      [this](vtkShaderProgram* program) { this->Bind(program); });
    this->Unbind();
    this->DrawCalls += 2;
  }
  else
  {
    std::string all = defines;
    all += this->Way == vtkRelievoLampsStage::CLUSTERS ? "#define RELIEVO_LAMPS_IN_CLUSTERS\n" : "";
    all += context.View.Parallel ? "#define RELIEVO_LINEAR_SLICES\n" : "";
    std::vector<std::string> reads{ "depth", "normal" };
    if (&target == &this->Gloss)
    {
      reads.emplace_back("surface");
    }
    vtkShaderProgram* program = quad.Ready(context, "deferred/lampsFS.glsl", reads, all);
    wrong = quad.GetWrong();
    if (program)
    {
      this->Bind(program);
      quad.Draw(context, target.GetArea());
      this->Unbind();
      ++this->DrawCalls;
    }
  }
  target.End();
  return wrong;
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
    this->Lists.GetBytes() + this->Quads.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLampLight::Release(vtkWindow* window)
{
  this->Sum.Release(window);
  this->Gloss.Release(window);
  this->Counts.Release(window);
  this->Lights.Release(window);
  this->Glosses.Release(window);
  this->Counter.Release(window);
  this->Quads.Release(window);
  for (vtkRelievoTextureBuffer* buffer :
    { &this->Lamps, &this->Attenuations, &this->Cells, &this->Lists })
  {
    buffer->Release(window);
  }
}
