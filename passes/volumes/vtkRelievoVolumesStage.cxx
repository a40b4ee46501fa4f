// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumesStage.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRectilinearGrid.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoVolumeImages.h"
#include "vtkRelievoVolumeReader.h"
#include "vtkRelievoVolumeSettings.h"
#include "vtkRelievoVolumeSplice.h"
#include "vtkRelievoVolumeTarget.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkStringArray.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <limits>

namespace
{
const vtkRelievoResourceName VolumeDepth = vtkRelievoResourceName::Of("volume_depth");

// A part that is drawn by itself: a volume, one in an assembly, or the level of detail that VTK
// chooses.
struct Drawn
{
  vtkProp* Prop = nullptr;
  vtkProp* Part = nullptr;
  vtkMatrix4x4* Matrix = nullptr; // of the part in its assembly
  std::vector<vtkVolume*> Volumes;
};

std::vector<Drawn> FindVolumes(const vtkRelievoFrameContext& context)
{
  std::vector<Drawn> drawn;
  for (const vtkRelievoFrameProp& each : context.Scene.Props)
  {
    vtkNew<vtkPropCollection> volumes;
    each.Prop->GetVolumes(volumes);
    if (volumes->GetNumberOfItems() == 0)
    {
      continue;
    }
    if (each.Prop->IsA("vtkLODProp3D"))
    {
      drawn.push_back({ each.Prop, each.Prop, nullptr, {} });
      for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
      {
        drawn.back().Volumes.push_back(vtkVolume::SafeDownCast(volumes->GetItemAsObject(i)));
      }
      continue;
    }
    for (const vtkRelievoPropParts::Part& part : each.Parts)
    {
      if (auto* volume = vtkVolume::SafeDownCast(part.Prop))
      {
        drawn.push_back({ each.Prop, volume, part.Matrix, { volume } });
      }
    }
  }
  return drawn;
}

// The reason why layers of a volume cannot be made, or an empty string.
std::string WhyNot(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (volume->IsA("vtkMultiVolume"))
  {
    return "a vtkMultiVolume mixes its volumes; add each as a vtkVolume of its own";
  }
  if (!mapper || !volume->GetProperty() ||
    !(mapper->IsA("vtkGPUVolumeRayCastMapper") || mapper->IsA("vtkSmartVolumeMapper") ||
      mapper->IsA("vtkMultiBlockVolumeMapper") || mapper->IsA("vtkAMRVolumeMapper")))
  {
    return std::string("a ") + (mapper ? mapper->GetClassName() : "vtkVolume without a mapper") +
      " does not march along rays on the GPU; take a vtkGPUVolumeRayCastMapper or a "
      "vtkSmartVolumeMapper";
  }
  auto* blended = vtkVolumeMapper::SafeDownCast(mapper);
  const int mode = blended ? blended->GetBlendMode() : vtkVolumeMapper::COMPOSITE_BLEND;
  switch (mode)
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return {};
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return "the blend modes average and additive have no depth; take composite, maximum or "
             "minimum intensity";
    default:
      return "the blend modes isosurface and slice are not composited along the ray; take "
             "composite, or the surface of vtkFlyingEdges3D or vtkCutter";
  }
}

// The reason why VTK leaves out all of a volume's images, or "".
std::string FindWhyNotDrawn(vtkVolume* volume)
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  bool others = false;
  std::string why;
  for (vtkImageData* image : mapper
      ? vtkRelievoVolumeImages::Find(mapper->GetDataObjectInput(), others)
      : std::vector<vtkImageData*>())
  {
    int cells = 0;
    vtkDataArray* values = vtkRelievoVolumeImages::GetScalars(mapper, image, cells);
    why = values ? vtkRelievoVolumeImages::FindWhyNotDrawn(volume, image, values, cells != 0)
                 : std::string();
    if (why.empty())
    {
      break;
    }
  }
  return why;
}

// Index of the component that gives a sample's value, as GLSL: the one with the greatest weight, or
// the one that gives the opacity.
std::string GetComponent(const std::string& fragment, vtkVolumeMapper* mapper, vtkVolume* volume)
{
  if (!vtkRelievoSpliceText::Has(fragment, "in_componentWeight"))
  {
    return "(in_noOfComponents - 1)";
  }
  int cells = 0;
  vtkDataArray* values =
    vtkAbstractMapper::GetScalars(mapper->GetDataSetInput(), mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
  vtkVolumeProperty* property = volume->GetProperty();
  int heaviest = 0;
  for (int i = 1; values && i < std::min(4, values->GetNumberOfComponents()); ++i)
  {
    heaviest =
      property->GetComponentWeight(i) > property->GetComponentWeight(heaviest) ? i : heaviest;
  }
  return std::to_string(heaviest);
}

void AddText(vtkImageData* image, const char* name, const std::string& words)
{
  vtkNew<vtkStringArray> text;
  text->SetName(name);
  text->InsertNextValue(words);
  image->GetFieldData()->AddArray(text);
}

const std::string Declared = "//RELIEVO::Volumes::Dec";
const std::string Sampled = "//RELIEVO::Volumes::Sample";
const std::string Ended = "//RELIEVO::Volumes::Exit";

void Mark(std::string& fragment)
{
  using namespace vtkRelievoSpliceText;
  FillMark(fragment, "//VTK::DepthPeeling::Dec", Declared + "\n//VTK::DepthPeeling::Dec");
  MarkBehind(fragment, "//VTK::DepthPass::Impl", Sampled);
  MarkBehind(fragment, "//VTK::DepthPass::Exit", Ended);
}

std::string Fill(std::string& fragment, vtkVolumeMapper* mapper, vtkVolume* volume)
{
  using namespace vtkRelievoSpliceText;
  const auto section = [](const char* name) {
    return vtkRelievoShaderLibrary::GetSection("volumes/layers.glsl", name);
  };
  std::string local = section("Local");
  local.erase(local.find_last_not_of(" \n") + 1);
  for (const std::string& place : { Declared, Sampled, Ended, local })
  {
    if (!Has(fragment, place))
    {
      return "its shader has no place '" + place + "'";
    }
  }
  const int mode = mapper->GetBlendMode();
  std::string defines =
    "#define RELIEVO_VOLUME_COMPONENT " + GetComponent(fragment, mapper, volume) + "\n";
  defines += mode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND
    ? "#define RELIEVO_VOLUME_EXTREME 1.0\n"
    : mode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? "#define RELIEVO_VOLUME_EXTREME -1.0\n"
                                                       : "";
  defines += vtkRectilinearGrid::SafeDownCast(mapper->GetDataSetInput())
    ? "#define RELIEVO_VOLUME_GRID\n"
    : "";
  defines += Has(fragment, "clip_numPlanes") ? "#define RELIEVO_VOLUME_CLIPPED\n" : "";
  FillMark(fragment, local, "");
  FillWord(fragment, "g_dirStep * jitterValue", "g_dirStep");
  FillMark(
    fragment, Declared, vtkRelievoVolumeSplice::GetNames(fragment) + defines + section("Dec"));
  FillMark(fragment, Sampled, section("Sample"));
  FillMark(fragment, Ended, section("Exit"));
  return {};
}
}

class vtkRelievoVolumesStage::Internals
{
public:
  // Layers other than volume_depth are merged when they are read: no shader reads these.
  class Merged : public vtkRelievoResource
  {
  public:
    void Activate(vtkShaderProgram*) override {}
    void Deactivate() override {}
  };

  Merged Layers;
  vtkNew<vtkRelievoVolumeSplice> Splice;
  vtkRelievoVolumeTarget Target;
  vtkRelievoScreenQuad Quad;
  vtkRelievoScreenTarget Depth{ "relievoVolumeDepths" }; // the nearest
  vtkRelievoScreenQuad Nearest;
  std::vector<vtkRelievoDrawnVolume> Volumes;     // in the target
  std::unique_ptr<vtkRelievoVolumeReader> Reader; // of the last frame, once layers are read
  bool InFrame = false; // stages may read layers, as the GPU has found them
  vtkRelievoFrameCamera View;
  int Rule = OPACITY; // of the last frame
  double Threshold = 0.5;
  std::string RuleWords; // for files
  std::string Error;     // why volumes lack layers
  vtkRelievoReportOnce Reported;
};

vtkStandardNewMacro(vtkRelievoVolumesStage);

//------------------------------------------------------------------------------
vtkRelievoVolumesStage::vtkRelievoVolumesStage()
  : Internal(new Internals)
{
  vtkRelievoVolumeSplice* splice = this->Internal->Splice;
  this->Internal->Depth.SetDefines("#define RELIEVO_VOLUME_DEPTH\n");
  splice->Mark = Mark;
  splice->Fill = Fill;
  splice->Report = [this](const std::string& message) {
    vtkErrorMacro("Volumes lack layers: " << message << ".");
  };
}

//------------------------------------------------------------------------------
vtkRelievoVolumesStage::~vtkRelievoVolumesStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoVolumesStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "volumes";
  description.Label = "Volume Layers";
  description.Help = "Makes the layers of volumes: depth, position, value, normal, opacity, id.";
  description.Slot = vtkRelievoStageDescription::SHADE;
  description.OnByDefault = true;
  description.Reads = { vtkRelievoResources::Depth };
  for (const vtkRelievoLayer& layer : vtkRelievoLayerCatalogue::GetAll())
  {
    if (layer.Name.compare(0, 6, "volume") == 0)
    {
      description.Layers.push_back(layer.Name);
    }
  }
  description
    .AddChoice(
      "rule", this->Rule, [this](int rule) { this->SetRule(rule); },
      { "first", "opacity", "strongest" },
      "The place that stands for a volume: first, the first visible sample; opacity, where the "
      "accumulated opacity reaches a threshold; strongest, the sample that contributes most.")
    .Label = "Depth Of Volumes";
  description
    .AddNumber(
      "opacity", this->Opacity, [this](double opacity) { this->SetOpacity(opacity); }, 0.001, 0.99,
      "", "Accumulated opacity at the depth of a volume.")
    .OnlyIf = "rule=opacity";
  description
    .AddFlag(
      "solid", this->Solid, [this](bool on) { this->SetSolid(on); },
      "Volumes count as surfaces: depth, range and position are those of the surface or the volume "
      "in front, and volumes are objects of data sets.")
    .Label = "Volumes Are Solid";
}

//------------------------------------------------------------------------------
void vtkRelievoVolumesStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.OptionalWrites = { VolumeDepth };
  if (this->Solid && context.Renderer->GetVolumes()->GetNumberOfItems() > 0)
  {
    declaration.Amends = { "depth", "range", "position" };
    declaration.AmendsBy = VolumeDepth.Get();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVolumesStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  in.Reader.reset();
  in.InFrame = true;
  in.Volumes.clear();
  in.Error.clear();
  in.View = context.View;
  in.Rule = this->Rule;
  in.Threshold = this->Opacity;
  in.RuleWords = this->GetParameter("rule");
  in.RuleWords += this->Rule == OPACITY ? "=" + this->GetParameter("opacity") : std::string();
  for (const std::string& layer : context.GetAsked(this))
  {
    if (layer != VolumeDepth.Get())
    {
      context.ProvideLayer(layer, &in.Layers);
    }
  }
  const bool hasDepth = context.IsAsked(this, VolumeDepth);
  if (hasDepth)
  {
    vtkRelievoScreenTarget::Format format;
    format.Channels = 1;
    format.Halves = false;
    const std::string fault = in.Depth.Prepare(context, format);
    if (!fault.empty())
    {
      in.Error = fault;
      this->Explain("failed", fault);
      return;
    }
    in.Depth.Begin(context, std::numeric_limits<float>::infinity());
    in.Depth.End();
    context.ProvideLayer(VolumeDepth.Get(), &in.Depth);
  }
  std::vector<Drawn> volumes;
  std::string error;
  vtkVolumeCollection* all = context.Renderer->GetVolumes();
  const auto reject = [this, &in, all](const Drawn& each, const std::string& why) {
    const int index = all->IsItemPresent(each.Volumes.front()) - 1;
    const std::string words = "Volume " + std::to_string(index) + " lacks layers: " + why + ".";
    in.Error += (in.Error.empty() ? "" : " ") + words;
    if (in.Reported.IsNew(words))
    {
      vtkErrorMacro(<< words);
    }
  };
  for (const Drawn& each : FindVolumes(context))
  {
    std::string why;
    for (vtkVolume* volume : each.Volumes)
    {
      why = why.empty() ? WhyNot(volume) : why;
    }
    why.empty() ? volumes.push_back(each) : reject(each, why);
  }
  if (volumes.empty())
  {
    in.Target.Release(context.Window);
    this->Explain("ran", "there are no volumes");
    return;
  }
  error = in.Target.Prepare(context, static_cast<int>(volumes.size()));
  if (error.empty() &&
    !in.Quad.Ready(context, "volumes/depthFS.glsl", { vtkRelievoResources::Depth }))
  {
    error = in.Quad.GetError();
  }
  if (!error.empty())
  {
    in.Target.Release(context.Window);
    this->Explain("failed", error);
    reject(volumes.front(), error);
    return;
  }
  in.Target.Begin(context);
  in.Target.Select(0);
  in.Quad.Draw(context, in.Target.GetArea(), vtkRelievoScreenQuad::WRITES_DEPTH);
  ++this->DrawCalls;
  std::string missing;
  const int longest = std::max(1024, vtkTextureObject::GetMaximumTextureSize(context.Window));
  for (const Drawn& each : volumes)
  {
    vtkRelievoDrawnVolume drawn;
    in.Splice->Set = [this, all, longest, &each, &drawn](
                       vtkShaderProgram* program, vtkVolumeMapper* mapper, vtkVolume* volume) {
      if (!program->IsUniformUsed("relievoVolumePoints"))
      {
        return; // drawn without the splice, whose error is reported
      }
      drawn.Take(vtkGPUVolumeRayCastMapper::SafeDownCast(mapper), volume, longest);
      // A prop of levels of detail, as ParaView has it, holds the volume that draws.
      const int place = all->IsItemPresent(volume);
      drawn.Index = (place > 0 ? place : all->IsItemPresent(each.Volumes.front())) - 1;
      program->SetUniformi("relievoVolumeRule", this->Rule);
      program->SetUniformf("relievoVolumeThreshold", static_cast<float>(this->Opacity));
      program->SetUniformi("relievoVolumeLinear",
        volume->GetProperty()->GetInterpolationType() != VTK_NEAREST_INTERPOLATION);
      const glm::vec3 points(drawn.Points);
      program->SetUniform3f("relievoVolumePoints", &points[0]);
    };
    const std::string why = FindWhyNotDrawn(each.Volumes.front());
    missing += why.empty() ? "" : "; a volume is not drawn: " + why;
    in.Target.Select(static_cast<int>(in.Volumes.size()));
    in.Splice->Begin({ each.Prop }, context.Window);
    {
      const vtkRelievoVolumeSettings still(each.Volumes, context.Window);
      if (each.Part != each.Prop)
      {
        each.Part->SetPropertyKeys(each.Prop->GetPropertyKeys());
        each.Part->PokeMatrix(each.Matrix);
        each.Part->RenderVolumetricGeometry(context.Renderer);
        each.Part->PokeMatrix(nullptr);
      }
      else
      {
        each.Prop->RenderVolumetricGeometry(context.Renderer);
      }
    }
    in.Splice->End();
    this->DrawCalls += drawn.Draws;
    if (drawn.Draws > 1 && (this->Rule != FIRST || drawn.IsExtreme))
    {
      drawn.HasDepth = false;
      reject(each,
        "data drawn in several blocks has only 'volume_opacity' and, composited, the layers of the "
        "rule 'first'; set that rule, or make one image of the blocks");
    }
    auto* smart = vtkSmartVolumeMapper::SafeDownCast(each.Volumes.front()->GetMapper());
    if (smart && smart->GetLastUsedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode)
    {
      reject(each,
        "its vtkSmartVolumeMapper marches along rays on the CPU; call "
        "SetRequestedRenderModeToGPU()");
    }
    if (drawn.Draws > 0)
    {
      in.Volumes.push_back(drawn);
    }
  }
  in.Splice->Set = nullptr;
  in.Target.End();
  if (hasDepth)
  {
    const std::string fault = this->FindNearest(context);
    if (!fault.empty())
    {
      this->Explain("failed", fault);
      return;
    }
  }
  this->Explain("ran", "draws " + std::to_string(in.Volumes.size()) + " volumes" + missing);
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumesStage::FindNearest(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkShaderProgram* program = in.Nearest.Ready(context, "volumes/nearestFS.glsl", {});
  if (!program)
  {
    return in.Nearest.GetError();
  }
  vtkOpenGLState* state = context.Window->GetState();
  in.Depth.GoOn(context);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MIN);
  for (std::size_t i = 0; i < in.Volumes.size(); ++i)
  {
    if (in.Volumes[i].HasDepth)
    {
      vtkTextureObject* texels = in.Target.GetPlaces(static_cast<int>(i));
      texels->Activate();
      program->SetUniformi("relievoVolumeTexels", texels->GetTextureUnit());
      in.Nearest.Draw(context, in.Depth.GetArea());
      texels->Deactivate();
      ++this->DrawCalls;
    }
  }
  state->vtkglBlendEquation(GL_FUNC_ADD);
  in.Depth.End();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoVolumesStage::Finish(vtkRelievoFrameContext&)
{
  this->Internal->InFrame = false;
  this->Internal->Reader.reset();
}

//------------------------------------------------------------------------------
// Makes the reader, if the layer can be read; otherwise returns an error message.
std::string vtkRelievoVolumesStage::Open(const std::string& layer)
{
  Internals& in = *this->Internal;
  if (in.Volumes.empty() && !in.Error.empty())
  {
    return in.Error;
  }
  if (!in.Reader)
  {
    in.Reader.reset(new vtkRelievoVolumeReader(
      in.Target, in.Volumes, in.View, in.Rule, in.Threshold, !in.InFrame));
  }
  return layer != "volume_opacity" && in.Reader->HasLostBricks() ? "The layer '" + layer +
      "' cannot be read: a volume is drawn in bricks (SetPartitions), which only the rule 'first' "
      "combines, of composited volumes. Set that rule, or call SetPartitions(1, 1, 1)."
                                                                 : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumesStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  Internals& in = *this->Internal;
  for (const std::string& name : names)
  {
    const bool isOwn = name.compare(0, 6, "volume") == 0;
    if (!isOwn && in.Volumes.empty())
    {
      return {}; // layers of surfaces alone
    }
    const std::string error = this->Open(name);
    if (!error.empty())
    {
      return error;
    }
    isOwn ? in.Reader->Read(name, image) : in.Reader->Amend(name, image);
    if (!isOwn)
    {
      AddText(
        image, "depthOf", in.Error.empty() ? "surfaces and volumes" : "surfaces and some volumes");
    }
  }
  AddText(image, "volumeRule", in.RuleWords);
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVolumesStage::GetBytesHeld()
{
  return this->Internal->Target.GetBytes() + this->Internal->Depth.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoVolumesStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Target.Release(window);
  this->Internal->Depth.Release(window);
  this->Internal->Quad.Release(window);
  this->Internal->Nearest.Release(window);
  this->Internal->Reader.reset();
  this->Internal->Volumes.clear();
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
