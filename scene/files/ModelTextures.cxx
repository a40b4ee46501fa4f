// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelTextures.h"

#include "Errors.h"
#include "Images.h"
#include "Messages.h"
#include "MtlLibrary.h"
#include "Progress.h"

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

namespace scene
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ModelTextures::Read(const std::string& name, Progress& progress)
{
  if (this->Reader->HasEmbeddedTexture(name.c_str()))
  {
    vtkSmartPointer<vtkImageData> image = this->Reader->GetEmbeddedTexture(name.c_str());
    Messages::Check("in the file", !image, "expected an image");
    return image;
  }
  // Files name textures by paths of the machine that wrote them: the bare name is tried too.
  const std::string file =
    FindNamedFile(name, std::filesystem::path(this->Path).parent_path(), this->Allowed);
  CheckAllowed(file, this->Allowed);
  CheckImage("texture", file);
  return ReadImage(file, progress);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ModelTextures::Find(
  vtkDataSet* mesh, const char* array, const std::string& what, Progress& progress)
{
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(array));
  if (!names || names->GetNumberOfValues() == 0 || !mesh->GetPointData()->GetTCoords())
  {
    return nullptr;
  }
  const std::string name = names->GetValue(0);
  try
  {
    return this->Read(name, progress);
  }
  catch (const std::exception& error)
  {
    Messages::Note(this->Path + ": drawn without the " + what + " " + name + ": " + error.what());
    return nullptr;
  }
}

//------------------------------------------------------------------------------
double ModelTextures::PutColor(vtkActor* actor, vtkDataSet* mesh, Progress& progress)
{
  const auto image = this->Find(mesh, "base_color_texture", "texture", progress);
  if (!image)
  {
    return 0.;
  }
  vtkSmartPointer<vtkTexture>& texture = this->Textures[image];
  if (!texture)
  {
    texture = MakeTexture(image);
  }
  const double cutoff = FindCutoff(image, actor);
  actor->SetTexture(texture);
  actor->GetProperty()->SetColor(1., 1., 1.); // the texture gives the complete colour
  return cutoff;
}

//------------------------------------------------------------------------------
void ModelTextures::PutMaterial(
  vtkActor* actor, vtkDataSet* mesh, double cutoff, Progress& progress)
{
  // A sampler with settings that a map lacks: VTK's shaders draw the actor's own normal texture.
  auto* own = vtkRelievoWrapTexture::SafeDownCast(actor->GetProperty()->GetTexture("normalTex"));
  const bool isMap =
    !own || (own->GetWrapU() == own->GetWrapV() && own->GetWrapU() != vtkTexture::MirroredRepeat);
  const bool repeats = !own || own->GetWrapU() == vtkTexture::Repeat;
  const auto normals = isMap ? this->Find(mesh, "normal_texture", "normal map", progress) : nullptr;
  if (normals || cutoff > 0.)
  {
    vtkDataArray* given = mesh->GetFieldData()->GetArray("normal_strength");
    const double strength = given ? given->GetComponent(0, 0) : 1.;
    vtkSmartPointer<vtkRelievoMaterial>& material =
      this->Materials[{ normals.Get(), strength, cutoff, repeats }];
    if (!material)
    {
      material = vtkSmartPointer<vtkRelievoMaterial>::New();
      material->SetNormalMap(normals);
      material->SetNormalStrength(strength);
      material->SetRepeat(repeats);
      material->SetAlphaCutoff(cutoff);
    }
    material->Attach(actor);
  }
}
}
