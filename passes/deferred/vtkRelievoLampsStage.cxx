// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampsStage.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLampLight.h"
#include "vtkRelievoLamps.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoTellVolumes.h"
#include "vtkRelievoTranslucentLamps.h"

#include <algorithm>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkRelievoLampsStage);

namespace
{
const char* const Light = "light";
const char* const Evaluations = "lamp_evaluations";
const char* const Reaching = "lamps_reaching";
const vtkRelievoResourceName Gloss = vtkRelievoResourceName::Of("lamp gloss");
const std::vector<std::string> WayNames{ "auto", "quads", "clusters", "all" };

// Up to MostAll lamps are computed in every pixel of their common rectangle, if they cover it at
// least LeastCovered times. Up to MostQuads, rectangles are drawn: the lists of clusters cost more.
constexpr int MostAll = 4;
constexpr double LeastCovered = 0.5;
constexpr int MostQuads = 8;

// Describes the casting lamps, or the reason why none casts, as a part of a sentence.
std::string DescribeCasting(const vtkRelievoFrameContext& context)
{
  const std::size_t count = context.CastingLamps.size();
  if (count == 0)
  {
    return {};
  }
  if (!context.Find(vtkRelievoResources::LampShadows))
  {
    return "; no shadows: see the stage shadows";
  }
  std::ostringstream out;
  out << "; " << count << (count == 1 ? " casts shadows, at " : " cast shadows, at ");
  for (const vtkRelievoCastingLamp& lamp : context.CastingLamps)
  {
    out << (&lamp == context.CastingLamps.data() ? "(" : ", (") << lamp.Position.x << ", "
        << lamp.Position.y << ", " << lamp.Position.z << ")";
    if (lamp.Strength < 1.0)
    {
      out << " by " << static_cast<int>(100.0 * lamp.Strength) << " %";
    }
  }
  return out.str();
}
}

class vtkRelievoLampsStage::Internals
{
public:
  vtkRelievoLampLight Light;
  vtkRelievoScreenQuad Colors;
  vtkNew<vtkRelievoTranslucentLamps> Translucent;
  int LeftOut = 0;
  bool Any = false;      // there may be lamps in this frame; equal on all processes
  bool SomeCast = false; // some lamps always cast
  bool Adds = false;     // to the linear colour, without sums
  bool Sums = false;     // into buffers: for layers, or where it cannot add
};

//------------------------------------------------------------------------------
vtkRelievoLampsStage::vtkRelievoLampsStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoLampsStage::~vtkRelievoLampsStage() = default;

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkRelievoLampsStage::NewPoints()
{
  return vtkRelievoLamps::New();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "lamps";
  description.Label = "Lamps";
  description.Help = "Lights surfaces with lamps from data, in any number.";
  description.Slot = vtkRelievoStageDescription::SHADE;
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::Normal };
  description.Writes = { vtkRelievoResources::Color };
  description.Layers = { Light, Evaluations, Reaching };
  description.OnByDefault = true;
  description.TakesData = true;
  const auto name = [&description](const char* label, bool advanced) {
    description.Parameters.back().Label = label;
    description.Parameters.back().Advanced = advanced;
  };
  description.AddChoice(
    "way", this->Way, [this](int way) { this->SetWay(way); }, WayNames,
    "Method of finding the lamps of a pixel; the result is the same.");
  name("Lamps Found By", true);
  description.AddFlag(
    "floats", this->Floats, [this](bool on) { this->SetFloats(on); },
    "Sums light in floats instead of half floats.");
  name("Full Precision", true);
  description.AddFlag(
    "translucent", this->Translucent, [this](bool on) { this->SetTranslucent(on); },
    "Lights translucent surfaces as well, in VTK's own shaders.");
  description.AddWhole(
    "casting", this->Casting, [this](int lamps) { this->SetCasting(lamps); }, 0, 8, "lamps",
    "Number of lamps, the largest in the picture, that cast shadows; the others shine through "
    "walls.");
  name("Lamps With Shadows", false);
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Synchronize(vtkRelievoFrameContext& context)
{
  this->Superclass::Synchronize(context);
  Internals& in = *this->Internal;
  const auto sets = this->GetSets<vtkRelievoLamps>();
  in.Any = this->IsTogether() ||
    std::any_of(sets.begin(), sets.end(), [](auto* lamps) { return !lamps->GetRows().empty(); });
  int casts = in.Any && this->Casting > 0 ? 1 : 0;
  for (vtkRelievoLamps* lamps : sets)
  {
    casts = casts || lamps->GetSomeCastAlways() ? 1 : 0;
  }
  if (this->IsTogether())
  {
    const int here = casts;
    this->GetController()->AllReduce(&here, &casts, 1, vtkCommunicator::MAX_OP);
  }
  in.SomeCast = casts != 0;
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  declaration.Reason = "lights surfaces with lamps";
  if (!this->Internal->Any)
  {
    // Without lamps the layers are constant: no light.
    declaration.Writes.clear();
    declaration.ReasonCode = "idle";
    declaration.Reason = "there are no lamps";
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoResourceName> vtkRelievoLampsStage::GetReadsFor(
  const vtkRelievoFrameContext&, const std::vector<std::string>& asked) const
{
  std::vector<vtkRelievoResourceName> reads;
  if (std::find(asked.begin(), asked.end(), vtkRelievoResources::Color.Get()) != asked.end())
  {
    reads.push_back(vtkRelievoResources::Surface);
  }
  if (this->Internal->SomeCast)
  {
    reads.push_back(vtkRelievoResources::GeometricNormal);
    reads.push_back(vtkRelievoResources::LampShadows);
  }
  return reads;
}

//------------------------------------------------------------------------------
bool vtkRelievoLampsStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const auto sets = this->GetSets<vtkRelievoLamps>();
  in.Light.Take(context, sets, this->Casting);
  const auto others = static_cast<int>(in.Light.GetList().GetLamps().size());
  this->NumberCasting = static_cast<int>(in.Light.GetCasting().GetLamps().size());
  this->NumberOfLamps = in.Light.GetList().GetNumberGiven();
  this->NumberDrawn = others + this->NumberCasting;
  in.LeftOut = 0;
  for (vtkRelievoLamps* lamps : sets)
  {
    in.LeftOut += lamps->GetNumberLeftOut();
  }
  const bool counts =
    context.IsLayerAsked(this, Evaluations) || context.IsLayerAsked(this, Reaching);
  // The picture does not depend on the requested layers: these get sums of their own.
  const bool casts = this->NumberCasting > 0;
  float reached[4];
  const bool all = !casts && others <= MostAll && in.Light.FindReached(reached) >= LeastCovered;
  const int automatic = all ? ALL : others <= MostQuads ? QUADS : CLUSTERS;
  this->WayTaken = this->Way == AUTOMATIC ? automatic : this->Way;
  in.Adds = !casts && this->WayTaken != QUADS;
  const bool colors = context.IsAsked(this, vtkRelievoResources::Color);
  in.Sums = counts || context.IsLayerAsked(this, Light) || (colors && !in.Adds);
  vtkRelievoLampLight::Buffers buffers;
  buffers.Floats = this->Floats || this->WayTaken == ALL;
  buffers.Sums = in.Sums;
  buffers.Counts = counts;
  std::string error = in.Light.Prepare(context, this->WayTaken, buffers);
  if (!colors)
  {
    in.Translucent->ReleaseGraphicsResources(context.Window);
  }
  else if (error.empty())
  {
    error = in.Translucent->Begin(context, sets, this->Translucent);
  }
  if (!error.empty())
  {
    this->ReportFault(error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const bool colors = context.IsAsked(this, vtkRelievoResources::Color) && this->NumberDrawn > 0;
  const vtkRelievoResource* surface = colors ? context.Find(vtkRelievoResources::Surface) : nullptr;
  const bool glossy =
    surface && surface->GetDefines().find("RELIEVO_GLOSSY_SURFACES") != std::string::npos;
  std::string error = in.Light.Upload(context);
  if (in.Sums && error.empty())
  {
    error = in.Light.Draw(context, glossy && !in.Adds);
  }
  if (in.Adds && colors && error.empty())
  {
    error = in.Light.Add(context, glossy);
  }
  this->DrawCalls = in.Light.GetDrawCalls();
  if (error.empty() && in.Sums)
  {
    context.ProvideLayer(Light, &in.Light.GetSum());
    for (const char* name : { Evaluations, Reaching })
    {
      if (context.IsLayerAsked(this, name))
      {
        context.ProvideLayer(name, &in.Light.GetCounts());
      }
    }
  }
  if (error.empty() && colors && !in.Adds)
  {
    std::vector<vtkRelievoResourceName> reads{ vtkRelievoResources::Surface,
      vtkRelievoResourceName::Of(Light) };
    if (glossy)
    {
      context.Provide(Gloss, &in.Light.GetGloss());
      reads.push_back(Gloss);
    }
    if (in.Colors.Ready(context, "deferred/lampsColorFS.glsl", reads))
    {
      vtkOpenGLState* state = context.Window->GetState();
      const vtkRelievoScopedState kept(state);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
      context.DrawColor(in.Colors, false);
      ++this->DrawCalls;
    }
    error = in.Colors.GetError();
  }
  this->ReportFault(error);
  if (error.empty())
  {
    this->Explain("ran",
      std::to_string(this->NumberDrawn) + " of " + std::to_string(this->NumberOfLamps) +
        " lamps may light the view; by " + WayNames[this->WayTaken] + DescribeCasting(context) +
        (in.Translucent->GetNumberOfProps() > 0 ? "; " +
              std::string(
                this->Translucent ? "translucent surfaces are" : "the shadow catcher is") +
              " lit"
                                                : "") +
        vtkRelievoTellVolumes(context, "not lit"));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::Finish(vtkRelievoFrameContext&)
{
  this->Internal->Translucent->End();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampsStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  Internals& in = *this->Internal;
  for (const std::string& name : names)
  {
    const std::string error = name == Light
      ? in.Light.GetSum().Read(name, 3, image)
      : in.Light.GetCounts().Read(name, 1, image, name == Reaching ? 1 : 0);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
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
    { "lamps_drawn", vtkVariant(this->NumberDrawn) }, { "lamps_left_out", vtkVariant(in.LeftOut) },
    { "lamps_on_translucent", vtkVariant(in.Translucent->GetNumberOfProps()) },
    { "lamps_casting", vtkVariant(this->NumberCasting) },
    { "lamps_way", vtkVariant(WayNames[this->WayTaken]) },
    { "lamps_evaluated_per_pixel", share(in.Light.GetComputed()) },
    { "lamps_reaching_per_pixel", share(in.Light.GetReaching()) } };
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLampsStage::GetBytesHeld()
{
  return this->Internal->Light.GetBytes() + this->Internal->Translucent->GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Light.Release(window);
  in.Colors.Release(window);
  in.Translucent->ReleaseGraphicsResources(window);
  this->DrawCalls = 0;
  this->NumberOfLamps = this->NumberDrawn = this->NumberCasting = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoLampsStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WayTaken: " << WayNames[this->WayTaken] << "\n";
  os << indent << "NumberCasting: " << this->NumberCasting << "\n";
  os << indent << "NumberOfLamps: " << this->NumberOfLamps << "\n";
}
