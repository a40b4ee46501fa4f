// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelTextures.h"

#include "Errors.h"
#include "Images.h"
#include "MtlLibrary.h"
#include "ReadContext.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoWrapTexture.h"
#include "vtkStringArray.h"

#include <exception>
#include <filesystem>

namespace reading
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ModelTextures::Read(const std::string& name)
{
  if (this->Reader->HasEmbeddedTexture(name.c_str()))
  {
    vtkSmartPointer<vtkImageData> image = this->Reader->GetEmbeddedTexture(name.c_str());
    this->Context.Check("in the file", !image, "expected an image");
    return image;
  }
  // Files name textures by paths of the machine that wrote them: the bare name is tried too.
  const vtkRelievoAllowedFolders allowed = this->Context.GetAllowed(this->Path);
  const std::string file =
    FindNamedFile(name, std::filesystem::path(this->Path).parent_path(), allowed);
  CheckAllowed(file, allowed);
  CheckImage("texture", file);
  return ReadImage(file, this->Context);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ModelTextures::Find(
  vtkDataSet* mesh, const char* array, const std::string& what)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(array));
  if (!names || names->GetNumberOfValues() == 0 || !mesh->GetPointData()->GetTCoords())
  {
    return nullptr;
  }
  const std::string name = names->GetValue(0);
  try
  {
    return this->Read(name);
  }
  catch (const std::exception& error)
  {
    this->Context.Note(
      this->Path + ": drawn without the " + what + " " + name + ": " + error.what());
    return nullptr;
  }
}

//------------------------------------------------------------------------------
void ModelTextures::Put(vtkActor* actor, vtkDataSet* mesh, const std::optional<double>& cutoff)
{
  MaterialMaps maps;
  maps.Cutoff = cutoff;
  if (!cutoff)
  {
    maps.Color = this->Find(mesh, "base_color_texture", "texture");
  }
  if (maps.Color)
  {
    actor->GetProperty()->SetColor(1., 1., 1.); // the texture gives the complete colour
  }
  // A sampler with settings that a map lacks: VTK's shaders draw the actor's own normal texture.
  auto* own = vtkRelievoWrapTexture::SafeDownCast(actor->GetProperty()->GetTexture("normalTex"));
  const bool isMap =
    !own || (own->GetWrapU() == own->GetWrapV() && own->GetWrapU() != vtkTexture::MirroredRepeat);
  if (isMap)
  {
    maps.Normals = this->Find(mesh, "normal_texture", "normal map");
  }
  if (vtkDataArray* strength = mesh->GetFieldData()->GetArray("normal_strength"))
  {
    maps.NormalStrength = strength->GetComponent(0, 0);
  }
  maps.NormalsRepeat = !own || own->GetWrapU() == vtkTexture::Repeat;
  this->Painter.Put(actor, maps);
}
}
