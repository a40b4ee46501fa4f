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
std::vector<vtkPVRelievoMaterial*>& GetAllMaterials()
{
  // Never destroyed: ParaView may delete its proxies' objects after this library's statics.
  static auto* all = new std::vector<vtkPVRelievoMaterial*>;
  return *all;
}
}

class vtkPVRelievoMaterial::Internals
{
public:
  // A file named by a property, and its contents.
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

  bool ColorsInterpolated = false; // set by this object, not by the representation's own setting
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
  GetAllMaterials().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoMaterial::~vtkPVRelievoMaterial()
{
  GetAllMaterials().erase(
    std::remove(GetAllMaterials().begin(), GetAllMaterials().end(), this), GetAllMaterials().end());
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
  for (Internals::Map* map : { &in.Normals, &in.Heights })
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
      return; // coarse data during interaction has no coordinates
    }
    words.replace(
      found, name.size(), "the filter Texture Coordinates (menu Filters, Relievo) makes");
  }
  // Users do not choose the mapper's class.
  const std::string::size_type drawn = words.find(" on geometry drawn by vtk");
  const std::string::size_type end = words.find(": ", drawn);
  if (drawn != std::string::npos && end != std::string::npos)
  {
    words.replace(drawn, end - drawn, " on this surface");
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
bool vtkPVRelievoMaterial::IsMirrored(vtkPVView* view, bool rough)
{
  return std::any_of(
    GetAllMaterials().begin(), GetAllMaterials().end(), [view, rough](vtkPVRelievoMaterial* each) {
      return each->IsMirroring(view) && (!rough || each->GetMaterial()->GetRoughness() > 0.0);
    });
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::Prepare(vtkPVView* view, vtkRelievoEnvironment* environment)
{
  for (vtkPVRelievoMaterial* each : GetAllMaterials())
  {
    Internals& in = *each->Internal;
    each->KeepCoordinates(); // the representation may have applied its own setting since
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
  for (vtkPVRelievoMaterial* each : GetAllMaterials())
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
void vtkPVRelievoMaterial::SetValue(const char* parameter, double value)
{
  vtkPVRelievoSet(this, this->Internal->Material->GetDescription(), parameter, { value });
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkPVRelievoMaterial::SetValue(const char* parameter, double first, double second)
{
  vtkPVRelievoSet(this, this->Internal->Material->GetDescription(), parameter, { first, second });
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
