// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterial.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoMaterialAccess.h"
#include "vtkRelievoMaterialMap.h"
#include "vtkRelievoMaterialSplice.h"
#include "vtkRelievoReflection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"
#include "vtkWeakPointer.h"

#include <cmath>
#include <set>

vtkStandardNewMacro(vtkRelievoMaterial);

namespace
{
// VTK's composite mappers hand on texture coordinates only to who has a texture. By this name the
// shaders look at none.
constexpr const char* Carrier = "colortexture";

void AddCarrier(vtkActor* actor)
{
  if (actor->GetMapper() && actor->GetMapper()->IsA("vtkCompositePolyDataMapper2") &&
    !actor->GetProperty()->GetTexture(Carrier))
  {
    vtkNew<vtkImageData> texel;
    texel->SetDimensions(1, 1, 1);
    texel->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    texel->SetScalarComponentFromDouble(0, 0, 0, 0, 255.0);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(texel);
    actor->GetProperty()->SetTexture(Carrier, texture);
  }
}

void RemoveCarrier(vtkActor* actor)
{
  if (actor->GetMapper() && actor->GetMapper()->IsA("vtkCompositePolyDataMapper2"))
  {
    actor->GetProperty()->RemoveTexture(Carrier);
  }
}

// The window that a prop is being drawn in: what it belongs to, up to a renderer, knows it.
vtkOpenGLRenderWindow* FindWindow(vtkProp* prop)
{
  for (int i = 0; prop && i < prop->GetNumberOfConsumers(); ++i)
  {
    vtkObject* consumer = prop->GetConsumer(i);
    vtkOpenGLRenderWindow* window = FindWindow(vtkProp::SafeDownCast(consumer));
    if (auto* renderer = vtkRenderer::SafeDownCast(consumer))
    {
      window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    }
    if (window && window->IsCurrent())
    {
      return window;
    }
  }
  return nullptr;
}
}

class vtkRelievoMaterial::Internals
{
public:
  vtkRelievoMaterialMap Normals;
  vtkRelievoMaterialMap Heights;
  vtkRelievoMaterialSplice::Structure Structure;
  vtkTimeStamp StructureTime;
  vtkSmartPointer<vtkRelievoEnvironment> Environment;
  vtkRelievoEnvironmentTextures::Structure EnvironmentStructure;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // drawn in last
  std::set<std::string> Said;
  vtkSmartPointer<vtkImageData> Broken; // a map that made no texture

  // Units are few: they are given back when the next material, on any actor, is drawn.
  static Internals*& GetInUse()
  {
    static Internals* inUse = nullptr;
    return inUse;
  }
  void Use()
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
    inUse = this;
  }
  ~Internals()
  {
    if (GetInUse() == this)
    {
      GetInUse() = nullptr;
    }
  }
};

//------------------------------------------------------------------------------
vtkRelievoMaterial::vtkRelievoMaterial()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoMaterial::~vtkRelievoMaterial() = default;

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
  actor->GetPropertyKeys()->Append(vtkOpenGLRenderPass::RenderPasses(), this);
  AddCarrier(actor);
  actor->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Detach(vtkActor* actor)
{
  if (vtkRelievoMaterial::Get(actor) == this)
  {
    vtkInformation* keys = actor->GetPropertyKeys();
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
    RemoveCarrier(actor);
    actor->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::Restructure()
{
  Internals& in = *this->Internal;
  vtkRelievoMaterialSplice::Structure structure;
  vtkImageData* normals = in.Normals.GetImage();
  vtkImageData* heights = in.Heights.GetImage();
  structure.NormalMap = this->Enabled && normals && normals != in.Broken;
  const bool hasHeights = this->Enabled && heights && heights != in.Broken;
  structure.Method = hasHeights ? this->Method : 0;
  structure.HeightMap = hasHeights && (this->Method != METHOD_OFF || !structure.NormalMap);
  structure.SelfShadow = structure.Method && this->SelfShadow;
  structure.DepthCorrection = structure.Method && this->DepthCorrection;
  structure.Clip = structure.Method && this->ClipAtBorders;
  if (!(structure == in.Structure))
  {
    in.Structure = structure;
    in.StructureTime.Modified();
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetEnabled(bool enabled)
{
  this->Enabled = enabled;
  this->Restructure();
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetMethod(int method)
{
  if (method < METHOD_OFF || method > METHOD_RELIEF)
  {
    vtkErrorMacro("SetMethod was given " << method << "; give it one from " << METHOD_OFF
                                         << " (off) to " << METHOD_RELIEF << " (relief).");
    return;
  }
  this->Method = method;
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
bool vtkRelievoMaterial::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->GetShaderStageMTime(); // a mapper's first shader is made without asking
    vtkRelievoMaterialSplice::Mark(vertexShader, geometryShader, fragmentShader);
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
  if (!mapper || !actor || (!maps && !mirrors) ||
    !vtkRelievoMaterialAccess::DrawsTriangles(mapper) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return true;
  }
  auto say = [&](const char* what, const std::string& missing) {
    if (!missing.empty() && in.Said.insert(mapper->GetClassName() + missing).second)
    {
      vtkErrorMacro(
        "No " << what << " on what " << mapper->GetClassName() << " draws: " << missing << ".");
    }
  };
  std::string missing;
  if (vtkOpenGLGlyph3DHelper::SafeDownCast(mapper))
  {
    missing = "glyphs carry no maps";
  }
  else if (vtkRelievoMaterialAccess::GetComponents(mapper, "tcoord") < 2)
  {
    missing = "its mesh has no texture coordinates of two components; vtkRelievoTextureCoordinates "
              "makes some";
  }
  else if (vtkRelievoMaterialAccess::ColorsByTexture(mapper))
  {
    missing = "InterpolateScalarsBeforeMapping takes the texture coordinates for colours; switch "
              "it off";
  }
  if (maps && missing.empty())
  {
    missing = vtkRelievoMaterialSplice::Fill(vertexShader, geometryShader, fragmentShader,
      in.Structure, vtkRelievoMaterialAccess::GetComponents(mapper, "tangentMC") == 3);
  }
  if (maps)
  {
    say("maps", missing);
  }
  if (mirrors)
  {
    say("environment",
      vtkRelievoReflection::Fill(
        vertexShader, geometryShader, fragmentShader, in.EnvironmentStructure));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoMaterial::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper);
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool maps = program->IsUniformUsed("relievoTextureTransform");
  const bool mirrors = in.Environment && vtkRelievoReflection::IsIn(program);
  if (!mapper || !actor || (!maps && !mirrors))
  {
    return true;
  }
  // A level of detail is drawn by an actor that belongs to nothing: in the window of the last one.
  if (vtkOpenGLRenderWindow* window = FindWindow(prop))
  {
    in.Window = window;
  }
  in.Use();
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
  struct Use
  {
    vtkRelievoMaterialMap& Map;
    const char* Sampler;
    const char* Name;
    int LeastComponents;
  };
  for (const Use& use : { Use{ in.Normals, "relievoNormalMap", "normal map", 3 },
         Use{ in.Heights, "relievoHeightMap", "height map", 1 } })
  {
    if (!program->IsUniformUsed(use.Sampler))
    {
      continue;
    }
    std::string failure;
    std::string remark;
    if (!use.Map.Load(in.Window, use.LeastComponents, this->Repeat, failure, remark))
    {
      vtkErrorMacro("No " << use.Name << ": " << failure << ".");
      // From the next picture on without it; this one shows the mesh as if the map were flat.
      in.Broken = use.Map.GetImage();
      this->Restructure();
      continue;
    }
    if (!remark.empty())
    {
      vtkWarningMacro("The " << use.Name << ": " << remark << ".");
    }
    program->SetUniformi(use.Sampler, use.Map.Activate());
  }
  const float flip = this->FlipGreen ? -1.f : 1.f;
  const float strength = static_cast<float>(this->NormalStrength);
  const float weight[2] = { strength, flip * strength };
  program->SetUniform2f("relievoNormalWeight", weight);
  const float decode[2][2] = { { 2.f, -1.f }, { 1.f, 0.f } };
  program->SetUniform2f("relievoNormalDecode", decode[in.Normals.IsFloat() ? 1 : 0]);
  if (program->IsUniformUsed("relievoHeightMap"))
  {
    this->SetHeightParameters(program, actor);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::SetHeightParameters(vtkShaderProgram* program, vtkActor* actor)
{
  Internals& in = *this->Internal;
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
  // VTK asks before each drawing: images of the environment may be others than before.
  Internals& in = *this->Internal;
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

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMaterial::GetBytesHeld()
{
  return this->Internal->Normals.GetBytes() + this->Internal->Heights.GetBytes();
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
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "NormalMap: " << this->GetNormalMap() << "\n";
  os << indent << "NormalStrength: " << this->NormalStrength << "\n";
  os << indent << "FlipGreen: " << this->FlipGreen << "\n";
  os << indent << "HeightMap: " << this->GetHeightMap() << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << " " << this->HeightRange[1] << "\n";
  os << indent << "HeightScale: " << this->HeightScale << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "StepsPerTexel: " << this->StepsPerTexel << "\n";
  os << indent << "MinimumSteps: " << this->MinimumSteps << "\n";
  os << indent << "MaximumSteps: " << this->MaximumSteps << "\n";
  os << indent << "Bisections: " << this->Bisections << "\n";
  os << indent << "SelfShadow: " << this->SelfShadow << "\n";
  os << indent << "DepthCorrection: " << this->DepthCorrection << "\n";
  os << indent << "ClipAtBorders: " << this->ClipAtBorders << "\n";
  os << indent << "TextureScale: " << this->TextureScale[0] << " " << this->TextureScale[1] << "\n";
  os << indent << "TextureOffset: " << this->TextureOffset[0] << " " << this->TextureOffset[1]
     << "\n";
  os << indent << "Repeat: " << this->Repeat << "\n";
  os << indent << "Environment: " << this->GetEnvironment() << "\n";
  os << indent << "Reflectivity: " << this->Reflectivity << "\n";
  os << indent << "Roughness: " << this->Roughness << "\n";
  os << indent << "ReflectionWeight: " << this->ReflectionWeight << "\n";
  os << indent << "IrradianceWeight: " << this->IrradianceWeight << "\n";
}
