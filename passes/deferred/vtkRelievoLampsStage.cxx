// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampsStage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoLampClusters.h"
#include "vtkRelievoLampQuads.h"
#include "vtkRelievoLamps.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkRelievoLampsStage);

namespace
{
const char* const Light = "light";
const char* const Evaluations = "lamp_evaluations";
const char* const Reaching = "lamps_reaching";
const std::vector<std::string> WayNames{ "auto", "quads", "clusters", "all" };

// Up to so many lamps rectangles are drawn by themselves: clusters cost more to list.
constexpr int MostQuads = 64;
}

class vtkRelievoLampsStage::Internals
{
public:
  std::vector<vtkSmartPointer<vtkRelievoLamps>> Sets;
  vtkRelievoLampList List;
  vtkRelievoLampClusters Clusters;
  vtkRelievoLampQuads Quads;
  vtkRelievoScreenTarget Sum{ "relievoLight" };
  vtkRelievoScreenTarget Counts{ "relievoLampCounts" };
  vtkRelievoScreenQuad Lights;
  vtkRelievoScreenQuad Counter;
  vtkRelievoScreenQuad Colors;
  vtkRelievoTextureBuffer Lamps;
  vtkRelievoTextureBuffer Attenuations;
  vtkRelievoTextureBuffer Cells;
  vtkRelievoTextureBuffer Lists;
  std::set<std::string> Said;
  double Computed = -1.0; // lamps a pixel in the last frame that counted; -1: it did not
  double Reach = -1.0;
  int LeftOut = 0;

  std::vector<vtkRelievoLamps*> GetSets() const
  {
    return { this->Sets.begin(), this->Sets.end() };
  }

  std::string Upload(vtkRelievoFrameContext& context, int way)
  {
    std::string wrong = this->Lamps.Upload(context.Window, this->List.GetTexels(), 4);
    wrong = !wrong.empty()
      ? wrong
      : this->Attenuations.Upload(context.Window, this->List.GetAttenuations(), 4);
    if (wrong.empty() && way == CLUSTERS)
    {
      wrong = this->Cells.Upload(context.Window, this->Clusters.GetCells(), 1);
      wrong =
        !wrong.empty() ? wrong : this->Lists.Upload(context.Window, this->Clusters.GetLists(), 1);
    }
    return wrong;
  }

  void Bind(vtkShaderProgram* program, int way)
  {
    this->Lamps.Activate(program, "relievoLamps");
    this->Attenuations.Activate(program, "relievoLampAttenuations");
    program->SetUniformi("relievoLampCount", static_cast<int>(this->List.GetLamps().size()));
    if (way == CLUSTERS)
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

  void Unbind(int way)
  {
    this->Lamps.Deactivate();
    this->Attenuations.Deactivate();
    if (way == CLUSTERS)
    {
      this->Cells.Deactivate();
      this->Lists.Deactivate();
    }
  }

  // Draws all lamps into the target. Returns what is wrong, in words.
  std::string Draw(vtkRelievoFrameContext& context, int way, vtkRelievoScreenTarget& target,
    vtkRelievoScreenQuad& quad, const std::string& defines)
  {
    target.Begin(context);
    std::string wrong;
    if (way == QUADS && !this->List.GetLamps().empty())
    {
      wrong = this->Quads.Draw(context, this->List, target, defines,
        [this, way](vtkShaderProgram* program) { this->Bind(program, way); });
      this->Unbind(way);
    }
    else if (way != QUADS)
    {
      std::string all = defines;
      all += way == CLUSTERS ? "#define RELIEVO_LAMPS_IN_CLUSTERS\n" : "";
      all += context.View.Parallel ? "#define RELIEVO_LINEAR_SLICES\n" : "";
      vtkShaderProgram* program =
        quad.Ready(context, "deferred/lampsFS.glsl", { "depth", "normal" }, all);
      wrong = quad.GetWrong();
      if (program)
      {
        this->Bind(program, way);
        quad.Draw(context, target.GetArea());
        this->Unbind(way);
      }
    }
    target.End();
    return wrong;
  }

  // What the counts come to, for the report.
  void SumCounts()
  {
    vtkNew<vtkImageData> image;
    this->Computed = this->Reach = -1.0;
    if (!this->Counts.Read(Evaluations, 1, image).empty() ||
      !this->Counts.Read(Reaching, 1, image, 1).empty())
    {
      return;
    }
    double* sums[2] = { &this->Computed, &this->Reach };
    const char* const names[2] = { Evaluations, Reaching };
    for (int i = 0; i < 2; ++i)
    {
      vtkDataArray* array = image->GetPointData()->GetArray(names[i]);
      double sum = 0.0;
      for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
      {
        sum += array->GetComponent(k, 0);
      }
      *sums[i] = sum / static_cast<double>(array->GetNumberOfTuples());
    }
  }
};

//------------------------------------------------------------------------------
vtkRelievoLampsStage::vtkRelievoLampsStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoLampsStage::~vtkRelievoLampsStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::AddLamps(vtkRelievoLamps* lamps)
{
  auto& sets = this->Internal->Sets;
  if (!lamps || std::find(sets.begin(), sets.end(), lamps) != sets.end())
  {
    vtkErrorMacro(
      "AddLamps was given " << (lamps ? "lamps that are there already." : "no lamps."));
    return;
  }
  sets.emplace_back(lamps);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::RemoveLamps(vtkRelievoLamps* lamps)
{
  auto& sets = this->Internal->Sets;
  sets.erase(std::remove(sets.begin(), sets.end(), lamps), sets.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::RemoveAllLamps()
{
  this->Internal->Sets.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoLampsStage::GetNumberOfLampSets()
{
  return static_cast<int>(this->Internal->Sets.size());
}

//------------------------------------------------------------------------------
vtkRelievoLamps* vtkRelievoLampsStage::GetLamps(int i)
{
  return i >= 0 && i < this->GetNumberOfLampSets() ? this->Internal->Sets[i] : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "lamps";
  description.Label = "Lamps";
  description.Help = "Lights surfaces with lamps from data, as many as there are.";
  description.Slot = vtkRelievoStageDescription::SHADE;
  description.Reads = { "depth", "normal" };
  description.Writes = { "color" };
  description.Layers = { Light, Evaluations, Reaching };
  description.OnByDefault = true;
  description.TakesData = true;
  description.AddChoice(
    "way", this->Way, [this](int way) { this->SetWay(way); }, WayNames,
    "How the lamps of a pixel are found; the result is the same.");
  description.AddFlag(
    "floats", this->Floats, [this](bool on) { this->SetFloats(on); },
    "Sums light in floats instead of half floats.");
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  const auto& sets = this->Internal->Sets;
  const bool any = std::any_of(
    sets.begin(), sets.end(), [](const auto& lamps) { return lamps->GetNumberOfPoints() > 0; });
  declaration.Words = "lights surfaces with lamps";
  if (!any)
  {
    // Without lamps the layers are still what they say: no light.
    declaration.Writes.clear();
    declaration.Words = "there are no lamps";
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoLampsStage::GetReadsFor(
  const vtkRelievoFrameContext&, const std::vector<std::string>& asked) const
{
  const bool color = std::find(asked.begin(), asked.end(), "color") != asked.end();
  return color ? std::vector<std::string>{ "albedo" } : std::vector<std::string>();
}

//------------------------------------------------------------------------------
bool vtkRelievoLampsStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const std::vector<vtkRelievoLamps*> sets = in.GetSets();
  in.List.Take(context.View, sets);
  this->NumberOfLamps = in.List.GetNumberGiven();
  this->NumberDrawn = static_cast<int>(in.List.GetLamps().size());
  in.LeftOut = 0;
  for (vtkRelievoLamps* lamps : sets)
  {
    in.LeftOut += lamps->GetNumberLeftOut();
  }
  this->WayTaken = this->Way != AUTOMATIC    ? this->Way
    : this->NumberDrawn <= MostQuads ? QUADS
                                             : CLUSTERS;
  const bool quads = this->WayTaken == QUADS;
  if (this->WayTaken == CLUSTERS)
  {
    in.Clusters.Build(context.View, in.List);
  }
  else
  {
    in.Cells.Release(context.Window);
    in.Lists.Release(context.Window);
  }
  if (!quads)
  {
    in.Quads.Release(context.Window);
  }
  std::string wrong = in.Sum.Prepare(
    context, { in.List.IsWhite() ? 1 : 4, !this->Floats && !quads, quads });
  const bool counts = context.IsAsked(this, Evaluations) || context.IsAsked(this, Reaching);
  if (counts && wrong.empty())
  {
    wrong = in.Counts.Prepare(context, { 2, false, quads });
  }
  else if (!counts)
  {
    in.Counts.Release(context.Window);
    in.Computed = in.Reach = -1.0;
  }
  if (!wrong.empty())
  {
    this->Explain("failed", wrong);
    if (in.Said.insert(wrong).second)
    {
      vtkErrorMacro("No light of lamps: " << wrong << ".");
    }
  }
  return wrong.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  const int way = this->WayTaken;
  in.Sum.SetDefines(in.List.IsWhite() ? "#define RELIEVO_WHITE_LIGHT\n" : "");
  std::string wrong = in.Upload(context, way);
  if (wrong.empty())
  {
    wrong = in.Draw(context, way, in.Sum, in.Lights,
      in.Sum.GetFormat().Halves ? "#define RELIEVO_HALVES\n" : "");
    this->DrawCalls += way == QUADS ? 2 : 1;
  }
  const bool counts = context.IsAsked(this, Evaluations) || context.IsAsked(this, Reaching);
  if (wrong.empty() && counts)
  {
    wrong = in.Draw(context, way, in.Counts, in.Counter, "#define RELIEVO_COUNT_LAMPS\n");
    in.SumCounts();
    this->DrawCalls += way == QUADS ? 2 : 1;
  }
  if (wrong.empty())
  {
    context.ProvideLayer(Light, &in.Sum);
    if (counts)
    {
      context.ProvideLayer(Evaluations, &in.Counts);
      context.ProvideLayer(Reaching, &in.Counts);
    }
  }
  if (wrong.empty() && context.IsAsked(this, "color") && !in.List.GetLamps().empty())
  {
    if (in.Colors.Ready(context, "deferred/lampsColorFS.glsl", { "albedo", Light }))
    {
      vtkOpenGLState* state = context.Window->GetState();
      const vtkRelievoKeptState kept(state);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
      context.DrawColor(in.Colors, false);
      ++this->DrawCalls;
    }
    wrong = in.Colors.GetWrong();
  }
  if (wrong.empty())
  {
    this->Explain("ran",
      std::to_string(this->NumberDrawn) + " of " + std::to_string(this->NumberOfLamps) +
        " lamps may light what is seen; by " + WayNames[way]);
    return;
  }
  this->Explain("failed", wrong);
  if (in.Said.insert(wrong).second)
  {
    vtkErrorMacro("No light of lamps: " << wrong << ".");
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampsStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  Internals& in = *this->Internal;
  for (const std::string& name : names)
  {
    const std::string wrong = name == Light ? in.Sum.Read(name, 3, image)
                                            : in.Counts.Read(name, 1, image, name == Reaching);
    if (!wrong.empty())
    {
      return "The layer '" + name + "' cannot be read: " + wrong + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoLampsStage::GetFacts()
{
  const Internals& in = *this->Internal;
  const auto share = [](double value) { return value < 0.0 ? vtkVariant() : vtkVariant(value); };
  return { { "lamps", vtkVariant(this->NumberOfLamps) },
    { "lamps_drawn", vtkVariant(this->NumberDrawn) },
    { "lamps_left_out", vtkVariant(in.LeftOut) },
    { "lamps_way", vtkVariant(WayNames[this->WayTaken]) },
    { "lamps_evaluated_per_pixel", share(in.Computed) },
    { "lamps_reaching_per_pixel", share(in.Reach) } };
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLampsStage::GetBytesHeld()
{
  const Internals& in = *this->Internal;
  return in.Sum.GetBytes() + in.Counts.GetBytes() + in.Lamps.GetBytes() +
    in.Attenuations.GetBytes() + in.Cells.GetBytes() + in.Lists.GetBytes() + in.Quads.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Sum.Release(window);
  in.Counts.Release(window);
  for (vtkRelievoScreenQuad* quad : { &in.Lights, &in.Counter, &in.Colors })
  {
    quad->Release(window);
  }
  for (vtkRelievoTextureBuffer* buffer : { &in.Lamps, &in.Attenuations, &in.Cells, &in.Lists })
  {
    buffer->Release(window);
  }
  in.Quads.Release(window);
  this->DrawCalls = 0;
  this->NumberOfLamps = this->NumberDrawn = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Way: " << WayNames[this->Way] << "\n";
  os << indent << "WayTaken: " << WayNames[this->WayTaken] << "\n";
  os << indent << "Floats: " << this->Floats << "\n";
  os << indent << "NumberOfLamps: " << this->NumberOfLamps << "\n";
  os << indent << "NumberDrawn: " << this->NumberDrawn << "\n";
  for (const auto& lamps : this->Internal->Sets)
  {
    os << indent << "Lamps: " << lamps.GetPointer() << "\n";
  }
}
