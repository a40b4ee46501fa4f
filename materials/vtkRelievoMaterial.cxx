// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterial.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoMaterialInternals.h"
#include "vtkTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoMaterial);

namespace
{
// VTK's composite mappers hand on texture coordinates only to who has a texture. Its shaders
// declare this one and look at none that is a cube.
constexpr const char* Carrier = "relievoCarrier";

void AddCarrier(vtkActor* actor)
{
  if (vtkRelievoCompositeMapper::SafeDownCast(actor->GetMapper()) &&
    !actor->GetProperty()->GetTexture(Carrier))
  {
    vtkNew<vtkImageData> texel;
    texel->SetDimensions(1, 1, 1);
    // Three bytes, which VTK takes as they are: what it maps first is gone for all faces but one.
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
  this->Internal->Actors.emplace_back(actor);
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
