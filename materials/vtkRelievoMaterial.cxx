// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterial.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoCutoff.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentTextures.h"
#include "vtkRelievoMaterialEye.h"
#include "vtkRelievoMaterialMap.h"
#include "vtkRelievoMaterialSplice.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPassKeys.h"
#include "vtkRelievoReflection.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoTrialSplice.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

class vtkRelievoMaterial::Internals
{
public:
  vtkRelievoMaterialMap Normals{ "normal map", 3 };
  vtkRelievoMaterialMap Heights{ "height map", 1 };
  vtkRelievoMaterialSplice::Structure Structure;
  vtkTimeStamp StructureTime;
  vtkSmartPointer<vtkRelievoEnvironment> Environment;
  vtkRelievoEnvironmentTextures::Structure EnvironmentStructure;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last drawing
  std::vector<vtkWeakPointer<vtkActor>> Actors; // attached actors
  vtkRelievoReportOnce Reported;
  vtkRelievoParameterList Description;

  // Texture units are few, so a material releases its units when the next one is drawn.
  static Internals*& GetInUse()
  {
    static Internals* inUse = nullptr;
    return inUse;
  }
  static void GiveBack()
  {
    Internals*& inUse = GetInUse();
    if (inUse)
    {
      inUse->Normals.Deactivate();
      inUse->Heights.Deactivate();
      if (inUse->Environment)
      {
        vtkRelievoEnvironmentTextures::Of(inUse->Environment).Deactivate(inUse->Window);
      }
    }
    inUse = nullptr;
  }
  void Use()
  {
    GiveBack();
    GetInUse() = this;
  }
  ~Internals()
  {
    if (GetInUse() == this)
    {
      GetInUse() = nullptr;
    }
  }
};

vtkStandardNewMacro(vtkRelievoMaterial);

namespace
{
// Access to protected members of VTK's mappers, through a derived class that is never instantiated.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  using Self = MapperAccess;

  static bool DrawsTriangles(vtkOpenGLPolyDataMapper* mapper)
  {
    vtkOpenGLHelper* bound = mapper->*(&Self::LastBoundBO);
    return bound &&
      (bound->PrimitiveType == PrimitiveTris || bound->PrimitiveType == PrimitiveTriStrips);
  }
  // Components of a vertex attribute; 0 if the mesh has none.
  static int GetComponents(vtkOpenGLPolyDataMapper* mapper, const char* attribute)
  {
    return (mapper->*(&Self::VBOs))->GetNumberOfComponents(attribute);
  }
  // Whether texture coordinates are those of a colour table.
  static bool ColorsByTexture(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Self::InterpolateScalarsBeforeMapping) && mapper->*(&Self::ColorCoordinates);
  }
};

// VTK's composite mappers pass texture coordinates on only for actors with a texture. VTK's shaders
// declare this texture, and sample none that is a cube.
constexpr const char* Carrier = "relievoCarrier";

void AddCarrier(vtkActor* actor)
{
  if (vtkRelievoCompositeMapper::SafeDownCast(actor->GetMapper()) &&
    !actor->GetProperty()->GetTexture(Carrier))
  {
    vtkNew<vtkImageData> texel;
    texel->SetDimensions(1, 1, 1);
    // Three bytes, which VTK uses unmapped: a texture that it maps first has only one face.
    texel->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::fill_n(static_cast<unsigned char*>(texel->GetScalarPointer()), 3, 255);
    vtkNew<vtkTexture> texture;
    texture->CubeMapOn();
    for (int face = 0; face < 6; ++face)
    {
      texture->SetInputDataObject(face, texel);
    }
    actor->GetProperty()->SetTexture(Carrier, texture);
  }
}

void RemoveCarrier(vtkActor* actor)
{
  if (vtkRelievoCompositeMapper::SafeDownCast(actor->GetMapper()))
  {
    actor->GetProperty()->RemoveTexture(Carrier);
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoMaterial::vtkRelievoMaterial()
  : Internal(new Internals)
{
  this->Describe();
}

//------------------------------------------------------------------------------
vtkRelievoMaterial::~vtkRelievoMaterial() = default;

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Describe()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Internal->Description;
  const auto behindGear = [&list](const char* onlyIf) {
    list.Parameters.back().Advanced = true;
    list.Parameters.back().OnlyIf = onlyIf;
  };
  list
    .AddNumber(
      "normal_strength", this->NormalStrength,
      [this](double factor) { this->SetNormalStrength(factor); }, -infinity, infinity, "",
      "Factor of the slope of a normal map: 0 is flat, 1 leaves it unchanged.")
    .Usual = 4.0;
  list
    .AddFlag(
      "flip_green", this->FlipGreen, [this](bool on) { this->SetFlipGreen(on); },
      "For normal maps whose green points down, as in DirectX.")
    .Advanced = true;
  list
    .AddNumber(
      "height_scale", this->HeightScale, [this](double depth) { this->SetHeightScale(depth); }, 0.0,
      infinity, "units of the mesh", "Depth of the relief's ground below the mesh.")
    .OnlyIf = "height_map";
  list.Parameters.back().Label = "Relief Depth";
  list
    .AddChoice(
      "relief_method", this->ReliefMethod, [this](int method) { this->SetReliefMethod(method); },
      { "off", "parallax", "steep", "occlusion", "relief" },
      "Method of tracing the relief: one sample of the heights (parallax), equal steps (steep), "
      "linear interpolation of the last two (occlusion), or bisections before it (relief), which "
      "is "
      "the most accurate. Off displaces nothing: heights only give normals.")
    .OnlyIf = "height_map";
  list
    .AddFlag(
      "self_shadow", this->SelfShadow, [this](bool on) { this->SetSelfShadow(on); },
      "Whether the relief casts shadows on itself, from every light that is on.")
    .OnlyIf = "height_map,relief_method!=off";
  list.AddPair(
    "height_range", this->HeightRange, [this](const double* range) { this->SetHeightRange(range); },
    "The map's values at the ground and at the level of the mesh. 0,0 chooses: 0 to 1 for 8- and "
    "16-bit images, which are scaled to that range; otherwise the least and the greatest value.");
  behindGear("height_map");
  list.AddFlag(
    "depth_correction", this->DepthCorrection, [this](bool on) { this->SetDepthCorrection(on); },
    "Whether depth follows the relief, in intersections with other objects and in layers.");
  behindGear("height_map,relief_method!=off");
  list.AddFlag(
    "clip_at_borders", this->ClipAtBorders, [this](bool on) { this->SetClipAtBorders(on); },
    "Whether pixels are discarded where a ray leaves the texture, 0 to 1 in u and v, which gives "
    "a single tile its outline.");
  behindGear("height_map,relief_method!=off");
  list.AddNumber(
    "steps_per_texel", this->StepsPerTexel, [this](double steps) { this->SetStepsPerTexel(steps); },
    0.01, 16.0, "",
    "Steps along a ray per texel of the heights below it. Features thinner than a step "
    "may be missed.");
  behindGear("height_map,relief_method!=off");
  list.AddWhole(
    "minimum_steps", this->MinimumSteps, [this](int steps) { this->SetMinimumSteps(steps); }, 1,
    4096, "", "Minimum number of steps along a ray.");
  behindGear("height_map,relief_method!=off");
  list.AddWhole(
    "maximum_steps", this->MaximumSteps, [this](int steps) { this->SetMaximumSteps(steps); }, 1,
    4096, "", "Maximum number of steps along a ray.");
  behindGear("height_map,relief_method!=off");
  list.AddWhole(
    "bisections", this->Bisections, [this](int count) { this->SetBisections(count); }, 0, 32, "",
    "Bisections of the last step, for the method relief.");
  behindGear("height_map,relief_method=relief");
  list.AddPair(
    "texture_scale", this->TextureScale,
    [this](const double* tiles) { this->SetTextureScale(tiles); },
    "Tiles of the maps per unit of the texture coordinates, along u and v.");
  behindGear("");
  list.AddPair(
    "texture_offset", this->TextureOffset,
    [this](const double* offset) { this->SetTextureOffset(offset); },
    "Offset of the first tile in u and v, in tiles.");
  behindGear("");
  list.AddFlag(
    "repeat", this->Repeat, [this](bool on) { this->SetRepeat(on); },
    "Whether maps repeat beyond 0 to 1; if not, their edges extend.");
  behindGear("");
  list.AddNumber(
    "alpha_cutoff", this->AlphaCutoff, [this](double cutoff) { this->SetAlphaCutoff(cutoff); }, 0.0,
    1.0, "",
    "Opacity below which pixels are discarded; all others are opaque, in the picture, in layers "
    "and "
    "as a caster of shadows. The opacity is that of the surface, its colours and its texture. 0: "
    "off.");
  behindGear("");
  list
    .AddNumber(
      "reflectivity", this->Reflectivity, [this](double share) { this->SetReflectivity(share); },
      0.0, 1.0, "",
      "Share of the environment reflected at normal incidence, growing to all of it at grazing "
      "angles. 0.04 for glass, plastic and paint, 0.5 to 1 for metals; for coloured metals PBR "
      "with "
      "Metallic 1.")
    .OnlyIf = "environment";
  list
    .AddNumber(
      "roughness", this->Roughness, [this](double roughness) { this->SetRoughness(roughness); },
      0.0, 1.0, "",
      "Roughness of the mirror; 0 is sharp. It is separate from the roughness of VTK's PBR "
      "shading, "
      "which applies to lights.")
    .OnlyIf = "environment";
  list.AddNumber(
    "reflection_weight", this->ReflectionWeight,
    [this](double factor) { this->SetReflectionWeight(factor); }, 0.0, 1.0, "",
    "Factor of the reflected light.");
  behindGear("environment");
  list
    .AddNumber(
      "irradiance_weight", this->IrradianceWeight,
      [this](double factor) { this->SetIrradianceWeight(factor); }, 0.0, infinity, "",
      "Factor of the environment's light on the surface's own colour.")
    .Usual = 4.0;
  behindGear("environment");
}

//------------------------------------------------------------------------------
const vtkRelievoParameterList& vtkRelievoMaterial::GetDescription() const
{
  return this->Internal->Description;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const std::string error = this->TrySetParameter(name, words);
  if (!error.empty())
  {
    vtkErrorMacro(<< name << ": " << error << ".");
  }
  return error.empty();
}

//------------------------------------------------------------------------------
vtkRelievoMaterial* vtkRelievoMaterial::Get(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  const int passes = keys ? keys->Length(vtkOpenGLRenderPass::RenderPasses()) : 0;
  for (int i = 0; i < passes; ++i)
  {
    if (auto* material =
          vtkRelievoMaterial::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      return material;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Attach(vtkActor* actor)
{
  if (!actor)
  {
    vtkErrorMacro("Attach was given no actor; give it a vtkActor.");
    return;
  }
  vtkRelievoMaterial* former = vtkRelievoMaterial::Get(actor);
  if (former == this)
  {
    return;
  }
  if (former)
  {
    former->Detach(actor);
  }
  if (!actor->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    actor->SetPropertyKeys(keys);
  }
  vtkRelievoPassKeys::Add(actor->GetPropertyKeys(), this);
  AddCarrier(actor);
  this->Internal->Actors.emplace_back(actor);
  vtkRelievoCutoff::Tell(actor, this->Enabled ? this->AlphaCutoff : 0.0);
  actor->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Detach(vtkActor* actor)
{
  if (vtkRelievoMaterial::Get(actor) == this)
  {
    vtkRelievoPassKeys::Remove(actor->GetPropertyKeys(), this);
    RemoveCarrier(actor);
    vtkRelievoCutoff::Tell(actor, 0.0);
    auto& actors = this->Internal->Actors;
    actors.erase(std::remove_if(actors.begin(), actors.end(),
                   [actor](vtkActor* each) { return !each || each == actor; }),
      actors.end());
    actor->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::UpdateStructure()
{
  Internals& in = *this->Internal;
  vtkRelievoMaterialSplice::Structure structure;
  structure.NormalMap = this->Enabled && in.Normals.IsUsable();
  const bool hasHeights = this->Enabled && in.Heights.IsUsable();
  structure.Method = hasHeights ? this->ReliefMethod : 0;
  structure.HeightMap = hasHeights && (this->ReliefMethod != METHOD_OFF || !structure.NormalMap);
  structure.SelfShadow = structure.Method && this->SelfShadow;
  structure.DepthCorrection = structure.Method && this->DepthCorrection;
  structure.Clip = structure.Method && this->ClipAtBorders;
  structure.Cut = this->Enabled && this->AlphaCutoff > 0.0;
  if (!(structure == in.Structure))
  {
    in.Structure = structure;
    in.StructureTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Restructure()
{
  this->UpdateStructure();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetEnabled(bool enabled)
{
  this->Enabled = enabled;
  this->TellCutoff();
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetAlphaCutoff(double cutoff)
{
  const double clamped = std::clamp(cutoff, 0.0, 1.0);
  if (clamped != this->AlphaCutoff)
  {
    this->AlphaCutoff = clamped;
    this->TellCutoff();
    this->Restructure();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::TellCutoff()
{
  for (const vtkWeakPointer<vtkActor>& actor : this->Internal->Actors)
  {
    if (actor)
    {
      vtkRelievoCutoff::Tell(actor, this->Enabled ? this->AlphaCutoff : 0.0);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetReliefMethod(int method)
{
  if (method < METHOD_OFF || method > METHOD_RELIEF)
  {
    vtkErrorMacro("SetReliefMethod was given " << method << "; give it one from " << METHOD_OFF
                                               << " (off) to " << METHOD_RELIEF << " (relief).");
    return;
  }
  this->ReliefMethod = method;
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetSelfShadow(bool on)
{
  this->SelfShadow = on;
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetDepthCorrection(bool on)
{
  this->DepthCorrection = on;
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetClipAtBorders(bool on)
{
  this->ClipAtBorders = on;
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetNormalMap(vtkImageData* image)
{
  this->Internal->Normals.SetImage(image);
  this->Restructure();
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoMaterial::GetNormalMap()
{
  return this->Internal->Normals.GetImage();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetHeightMap(vtkImageData* image)
{
  this->Internal->Heights.SetImage(image);
  this->Restructure();
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoMaterial::GetHeightMap()
{
  return this->Internal->Heights.GetImage();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetEnvironment(vtkRelievoEnvironment* environment)
{
  Internals& in = *this->Internal;
  if (in.Environment && in.Environment != environment)
  {
    vtkRelievoEnvironmentTextures::Of(in.Environment).Deactivate(in.Window);
  }
  in.Environment = environment;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoEnvironment* vtkRelievoMaterial::GetEnvironment()
{
  return this->Internal->Environment;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMaterial::GetBytesHeld()
{
  return this->Internal->Normals.GetBytes() + this->Internal->Heights.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::ReleaseTextureUnits()
{
  Internals::GiveBack();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Render(const vtkRenderState*) {}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Normals.Release(window);
  this->Internal->Heights.Release(window);
  if (this->Internal->Environment)
  {
    this->Internal->Environment->ReleaseGraphicsResources(window);
  }
  if (window) // VTK's own method crashes without a window
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "NormalMap: " << this->GetNormalMap() << "\n";
  os << indent << "HeightMap: " << this->GetHeightMap() << "\n";
  os << indent << "Environment: " << this->GetEnvironment() << "\n";
  this->GetDescription().Print(os, indent);
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->GetShaderStageMTime(); // a mapper builds its first shader without asking
    vtkRelievoMaterialSplice::Mark(vertexShader, geometryShader, fragmentShader);
    // Before the reflection, which covers everything behind it.
    vtkRelievoCutoff::Mark(fragmentShader);
    vtkRelievoReflection::Mark(fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* abstractMapper,
  vtkProp* prop)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool maps = in.Structure.NormalMap || in.Structure.HeightMap;
  const bool mirrors = in.EnvironmentStructure.Projection != 0;
  if (!mapper || !actor)
  {
    return true;
  }
  const auto report = [&](const char* what, const vtkRelievoTrialSplice::Outcome& outcome) {
    if (!outcome.Error.empty() && in.Reported.IsNew(outcome.GetKey(mapper)))
    {
      vtkErrorMacro("No " << what << " on geometry drawn by " << mapper->GetClassName() << ": "
                          << outcome.Error << ".");
    }
  };
  if (in.Structure.Cut)
  {
    report("cutoff", { vtkRelievoCutoff::Fill(fragmentShader) });
  }
  if ((!maps && !mirrors) || !MapperAccess::DrawsTriangles(mapper) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return true;
  }
  // Maps and environment work independently of each other.
  const auto fill = [&]() {
    if (maps)
    {
      std::string missing;
      if (vtkOpenGLGlyph3DHelper::SafeDownCast(mapper))
      {
        missing = "glyphs do not support maps";
      }
      else if (MapperAccess::GetComponents(mapper, "tcoord") < 2)
      {
        missing = "its mesh has no texture coordinates of two components; "
                  "vtkRelievoTextureCoordinates makes some";
      }
      else if (MapperAccess::ColorsByTexture(mapper))
      {
        missing = "InterpolateScalarsBeforeMapping uses the texture coordinates for colours; "
                  "switch it off";
      }
      else
      {
        missing = vtkRelievoMaterialSplice::Fill(vertexShader, geometryShader, fragmentShader,
          in.Structure, MapperAccess::GetComponents(mapper, "tangentMC") == 3);
      }
      report("maps", { missing });
    }
    if (mirrors)
    {
      report("environment",
        { vtkRelievoReflection::Fill(
          vertexShader, geometryShader, fragmentShader, in.EnvironmentStructure) });
    }
    return std::string();
  };
  vtkRenderer* renderer = this->FindRenderer(prop);
  auto* window =
    renderer ? static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()) : nullptr;
  report(maps ? "maps" : "environment",
    vtkRelievoTrialSplice::Try(
      { vertexShader, geometryShader, fragmentShader }, window, actor->GetShaderProperty(), fill));
  return true;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoMaterial::FindRenderer(vtkProp* prop)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = vtkRelievoMaterialEye::FindRenderer(prop);
  // Levels of detail (vtkLODActor, ParaView) are drawn by an actor that is in no renderer.
  for (std::size_t i = 0; !renderer && i < in.Actors.size(); ++i)
  {
    renderer = vtkRelievoMaterialEye::FindRenderer(in.Actors[i]);
  }
  return renderer;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool maps = program && program->IsUniformUsed("relievoTextureTransform");
  const bool mirrors = program && in.Environment && vtkRelievoReflection::IsIn(program);
  if (program && program->IsUniformUsed("relievoAlphaCutoff"))
  {
    program->SetUniformf("relievoAlphaCutoff", static_cast<float>(this->AlphaCutoff));
  }
  if (!mapper || !actor || (!maps && !mirrors))
  {
    return true;
  }
  vtkRenderer* renderer = this->FindRenderer(prop);
  if (renderer)
  {
    in.Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  }
  in.Use();
  vtkRelievoMaterialEye::SetParameters(program, renderer);
  if (maps)
  {
    this->SetMapParameters(program, actor);
  }
  if (mirrors)
  {
    vtkRelievoReflection::SetParameters(program, in.Window, in.Environment,
      { this->Reflectivity, this->Roughness, this->ReflectionWeight, this->IrradianceWeight });
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetMapParameters(vtkShaderProgram* program, vtkActor* actor)
{
  Internals& in = *this->Internal;
  const float transform[4] = { static_cast<float>(this->TextureScale[0]),
    static_cast<float>(this->TextureScale[1]), static_cast<float>(this->TextureOffset[0]),
    static_cast<float>(this->TextureOffset[1]) };
  program->SetUniform4f("relievoTextureTransform", transform);
  const bool normals = this->ActivateMap(program, in.Normals, "relievoNormalMap");
  const bool heights = this->ActivateMap(program, in.Heights, "relievoHeightMap");
  const float flip = this->FlipGreen ? -1.f : 1.f;
  const float strength = normals ? static_cast<float>(this->NormalStrength) : 0.f;
  const float weight[2] = { strength, flip * strength };
  program->SetUniform2f("relievoNormalWeight", weight);
  const float decode[3][2] = { { 2.f, -1.f }, { 1.f, 0.f }, { 0.f, 1.f } };
  program->SetUniform2f(
    "relievoNormalDecode", decode[normals ? (in.Normals.IsFloat() ? 1 : 0) : 2]);
  if (program->IsUniformUsed("relievoHeightMap"))
  {
    this->SetHeightParameters(program, actor, heights);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::ActivateMap(
  vtkShaderProgram* program, vtkRelievoMaterialMap& map, const char* sampler)
{
  Internals& in = *this->Internal;
  if (!program->IsUniformUsed(sampler))
  {
    return false;
  }
  std::string remark;
  const bool there = map.Load(in.Window, this->Repeat, remark);
  if (there)
  {
    program->SetUniformi(sampler, map.Activate());
  }
  else
  {
    // The sampler reads a flat map from an otherwise unused unit: samplers of two kinds on one unit
    // are an error.
    GLint units = 0;
    glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    program->SetUniformi(sampler, units - 1);
    if (!in.Window && in.Reported.IsNew(map.GetName()))
    {
      vtkWarningMacro("A picture without the "
        << map.GetName() << ": no renderer that is being drawn has the actor.");
    }
  }
  if (!remark.empty())
  {
    vtkWarningMacro("The " << map.GetName() << ": " << remark << ".");
  }
  this->TellFaults();
  return there;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::TellFaults()
{
  Internals& in = *this->Internal;
  for (vtkRelievoMaterialMap* map : { &in.Normals, &in.Heights })
  {
    const std::string fault = this->Enabled ? map->TakeFault() : std::string();
    if (!fault.empty())
    {
      vtkErrorMacro("No " << map->GetName() << ": " << fault << ".");
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetHeightParameters(vtkShaderProgram* program, vtkActor* actor, bool there)
{
  Internals& in = *this->Internal;
  if (!there)
  {
    const float flat[2] = { 0.f, 1.f };
    const float texel[2] = { 1.f, 1.f };
    program->SetUniform2f("relievoHeightDecode", flat);
    program->SetUniform2f("relievoHeightSize", texel);
    return;
  }
  double range[2] = { this->HeightRange[0], this->HeightRange[1] };
  if (range[0] == range[1])
  {
    in.Heights.GetRange(range);
  }
  const double span = range[1] != range[0] ? range[1] - range[0] : 1.0;
  const float decode[2] = { static_cast<float>(1.0 / span), static_cast<float>(-range[0] / span) };
  program->SetUniform2f("relievoHeightDecode", decode);
  const float size[2] = { static_cast<float>(in.Heights.GetWidth()),
    static_cast<float>(in.Heights.GetHeight()) };
  program->SetUniform2f("relievoHeightSize", size);
  const double scale = std::cbrt(std::abs(actor->GetMatrix()->Determinant()));
  program->SetUniformf("relievoHeightScale", static_cast<float>(this->HeightScale * scale));
  const float steps[4] = { static_cast<float>(this->StepsPerTexel),
    static_cast<float>(this->MinimumSteps), static_cast<float>(this->MaximumSteps),
    static_cast<float>(this->Bisections) };
  program->SetUniform4f("relievoSteps", steps);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoMaterial::GetShaderStageMTime()
{
  // VTK asks before each drawing: images may have changed.
  Internals& in = *this->Internal;
  this->UpdateStructure();
  this->TellFaults();
  vtkRelievoEnvironmentTextures::Structure structure;
  if (this->Enabled && in.Environment)
  {
    structure = vtkRelievoEnvironmentTextures::Of(in.Environment).GetStructure();
  }
  structure = structure.Projection ? structure : vtkRelievoEnvironmentTextures::Structure();
  if (!(structure == in.EnvironmentStructure))
  {
    in.EnvironmentStructure = structure;
    in.StructureTime.Modified();
  }
  return in.StructureTime.GetMTime();
}
