// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoMaterial.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoClamped.h"
#include "vtkPVView.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoMessageText.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPVRelievoMaterial);

namespace
{
constexpr double Huge = 1e30;

std::vector<vtkPVRelievoMaterial*>& GetAll()
{
  // Never destroyed: ParaView may delete its proxies' objects after this library's statics.
  static auto* all = new std::vector<vtkPVRelievoMaterial*>;
  return *all;
}

// A file that a property names, and what is in it.
struct Map
{
  std::string Property;
  std::string Path;
  bool Read = false;
  vtkSmartPointer<vtkImageData> Image;

  void Name(const char* file)
  {
    const std::string path = file ? file : "";
    if (path != this->Path)
    {
      this->Path = path;
      this->Read = false;
      this->Image = nullptr;
    }
  }
};
}

class vtkPVRelievoMaterial::Internals
{
public:
  bool ColorsInterpolated = false; // by this object, not by the representation's own setting
  vtkWeakPointer<vtkGeometryRepresentation> Representation;
  vtkNew<vtkRelievoMaterial> Material;
  Map Normals{ "NormalMap", {}, false, nullptr };
  Map Heights{ "HeightMap", {}, false, nullptr };
};

//------------------------------------------------------------------------------
vtkPVRelievoMaterial::vtkPVRelievoMaterial()
  : Internal(new Internals)
{
  this->Internal->Material->AddObserver(vtkCommand::ErrorEvent, this, &vtkPVRelievoMaterial::Say);
  GetAll().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoMaterial::~vtkPVRelievoMaterial()
{
  GetAll().erase(std::remove(GetAll().begin(), GetAll().end(), this), GetAll().end());
  vtkGeometryRepresentation* surface = this->Internal->Representation;
  using Actors = std::vector<vtkActor*>;
  for (vtkActor* actor : surface ? vtkPVRelievoAccess::Surface::Actors(surface) : Actors())
  {
    this->Internal->Material->Detach(actor);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetRepresentation(vtkPVDataRepresentation* representation)
{
  auto* surface = vtkGeometryRepresentation::SafeDownCast(representation);
  if (!surface || this->Internal->Representation)
  {
    vtkErrorMacro("SetRepresentation was given " << (surface ? "a second one" : "no surface")
                                                 << "; give it one vtkGeometryRepresentation, "
                                                    "once.");
    return;
  }
  this->Internal->Representation = surface;
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::Apply()
{
  Internals& in = *this->Internal;
  if (!in.Representation)
  {
    return;
  }
  for (Map* map : { &in.Normals, &in.Heights })
  {
    if (!this->Enabled || map->Read || map->Path.empty())
    {
      continue;
    }
    map->Read = true;
    std::string failure;
    map->Image = vtkRelievoImageFile::Read(map->Path, failure);
    if (!map->Image && vtkPVRelievoReports())
    {
      vtkErrorMacro("Relievo" << map->Property << " was given '" << map->Path << "', expected "
                              << failure << ". The surface is shown without it.");
    }
  }
  in.Material->SetNormalMap(in.Normals.Image);
  in.Material->SetHeightMap(in.Heights.Image);
  if (!this->Mirror)
  {
    in.Material->SetEnvironment(nullptr);
  }
  const bool on = this->Enabled &&
    (in.Normals.Image || in.Heights.Image || in.Material->GetEnvironment() ||
      in.Material->GetAlphaCutoff() > 0.0);
  this->KeepCoordinates();
  for (vtkActor* actor : vtkPVRelievoAccess::Surface::Actors(in.Representation))
  {
    if (on)
    {
      in.Material->Attach(actor);
    }
    else
    {
      in.Material->Detach(actor);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::KeepCoordinates()
{
  Internals& in = *this->Internal;
  const bool maps = this->Enabled && (in.Normals.Image || in.Heights.Image);
  if (in.Representation && (maps || in.ColorsInterpolated))
  {
    in.Representation->SetInterpolateScalarsBeforeMapping(!maps && this->InterpolateScalars);
    in.ColorsInterpolated = maps;
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::Say(vtkObject*, unsigned long, void* text)
{
  std::string words = vtkRelievoMessageText::OfMessage(static_cast<const char*>(text));
  const std::string name = "vtkRelievoTextureCoordinates makes";
  const std::string::size_type found = words.find(name);
  if (found != std::string::npos)
  {
    Internals& in = *this->Internal;
    if (in.Representation && in.Representation->GetActor()->GetEnableLOD())
    {
      return; // coarse data while the camera moves have none
    }
    words.replace(
      found, name.size(), "the filter Texture Coordinates (menu Filters, Relievo) makes");
  }
  vtkErrorMacro(<< words << ".");
}

//------------------------------------------------------------------------------
bool vtkPVRelievoMaterial::IsMirroring(vtkPVView* view)
{
  return this->Enabled && this->Mirror && this->Internal->Representation &&
    this->Internal->Representation->GetView() == view;
}

//------------------------------------------------------------------------------
bool vtkPVRelievoMaterial::IsMirrored(vtkPVView* view)
{
  return std::any_of(GetAll().begin(), GetAll().end(),
    [view](vtkPVRelievoMaterial* each) { return each->IsMirroring(view); });
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::Prepare(vtkPVView* view, vtkRelievoEnvironment* environment)
{
  for (vtkPVRelievoMaterial* each : GetAll())
  {
    Internals& in = *each->Internal;
    each->KeepCoordinates(); // the representation may have got its own setting after this did
    if (each->IsMirroring(view) && in.Material->GetEnvironment() != environment)
    {
      in.Material->SetEnvironment(environment);
      each->Apply();
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::Forget(vtkRelievoEnvironment* environment)
{
  for (vtkPVRelievoMaterial* each : GetAll())
  {
    vtkRelievoMaterial* material = each->Internal->Material;
    vtkRelievoEnvironment* own = material->GetEnvironment();
    material->SetEnvironment(own == environment ? nullptr : own);
  }
}

//------------------------------------------------------------------------------
vtkRelievoMaterial* vtkPVRelievoMaterial::GetMaterial()
{
  return this->Internal->Material;
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetEnabled(bool on)
{
  this->Enabled = on;
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetNormalMap(const char* file)
{
  this->Internal->Normals.Name(file);
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetHeightMap(const char* file)
{
  this->Internal->Heights.Name(file);
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetMirror(bool on)
{
  this->Mirror = on;
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetInterpolateScalarsBeforeMapping(bool on)
{
  this->InterpolateScalars = on;
  this->KeepCoordinates();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetNormalStrength(double factor)
{
  this->Internal->Material->SetNormalStrength(
    vtkPVRelievoClamped(this, "NormalStrength", factor, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetFlipGreen(bool on)
{
  this->Internal->Material->SetFlipGreen(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetHeightScale(double depth)
{
  this->Internal->Material->SetHeightScale(
    vtkPVRelievoClamped(this, "HeightScale", depth, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetHeightRange(double ground, double top)
{
  this->Internal->Material->SetHeightRange(
    vtkPVRelievoClamped(this, "HeightRange", ground, -Huge, Huge),
    vtkPVRelievoClamped(this, "HeightRange", top, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetReliefMethod(int method)
{
  this->Internal->Material->SetMethod(vtkPVRelievoClamped<int>(this, "ReliefMethod", method,
    vtkRelievoMaterial::METHOD_OFF, vtkRelievoMaterial::METHOD_RELIEF));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetSelfShadow(bool on)
{
  this->Internal->Material->SetSelfShadow(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetDepthCorrection(bool on)
{
  this->Internal->Material->SetDepthCorrection(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetClipAtBorders(bool on)
{
  this->Internal->Material->SetClipAtBorders(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetStepsPerTexel(double steps)
{
  this->Internal->Material->SetStepsPerTexel(
    vtkPVRelievoClamped(this, "StepsPerTexel", steps, 0.01, 16.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetMinimumSteps(int steps)
{
  this->Internal->Material->SetMinimumSteps(
    vtkPVRelievoClamped(this, "MinimumSteps", steps, 1, 4096));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetMaximumSteps(int steps)
{
  this->Internal->Material->SetMaximumSteps(
    vtkPVRelievoClamped(this, "MaximumSteps", steps, 1, 4096));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetBisections(int count)
{
  this->Internal->Material->SetBisections(vtkPVRelievoClamped(this, "Bisections", count, 0, 32));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetTextureScale(double u, double v)
{
  this->Internal->Material->SetTextureScale(
    vtkPVRelievoClamped(this, "TextureScale", u, -Huge, Huge),
    vtkPVRelievoClamped(this, "TextureScale", v, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetTextureOffset(double u, double v)
{
  this->Internal->Material->SetTextureOffset(
    vtkPVRelievoClamped(this, "TextureOffset", u, -Huge, Huge),
    vtkPVRelievoClamped(this, "TextureOffset", v, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetRepeat(bool on)
{
  this->Internal->Material->SetRepeat(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetAlphaCutoff(double cutoff)
{
  this->Internal->Material->SetAlphaCutoff(
    vtkPVRelievoClamped(this, "AlphaCutoff", cutoff, 0.0, 1.0));
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetReflectivity(double share)
{
  this->Internal->Material->SetReflectivity(
    vtkPVRelievoClamped(this, "Reflectivity", share, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetRoughness(double roughness)
{
  this->Internal->Material->SetRoughness(
    vtkPVRelievoClamped(this, "Roughness", roughness, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetReflectionWeight(double factor)
{
  this->Internal->Material->SetReflectionWeight(
    vtkPVRelievoClamped(this, "ReflectionWeight", factor, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetIrradianceWeight(double factor)
{
  this->Internal->Material->SetIrradianceWeight(
    vtkPVRelievoClamped(this, "IrradianceWeight", factor, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Representation: " << this->Internal->Representation.GetPointer() << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "NormalMap: " << this->Internal->Normals.Path << "\n";
  os << indent << "HeightMap: " << this->Internal->Heights.Path << "\n";
  os << indent << "Mirror: " << this->Mirror << "\n";
  os << indent << "InterpolateScalars: " << this->InterpolateScalars << "\n";
  os << indent << "Material:\n";
  this->Internal->Material->PrintSelf(os, indent.GetNextIndent());
}
