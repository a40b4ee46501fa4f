// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"

#include "Errors.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"
#include "Values.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkProperty.h"
#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoImageFile.h"

#include <algorithm>

namespace reading
{
namespace
{
vtkInformationStringKey* FileKey()
{
  static vtkInformationStringKey* const key = vtkInformationStringKey::MakeKey("FILE", "cliImages");
  return key;
}
}

//------------------------------------------------------------------------------
void CheckImage(const std::string& option, const std::string& path)
{
  const std::string extensions = vtkRelievoImageFile::ListExtensions(".");
  const std::vector<std::string> known = Split(extensions, ' ');
  if (std::find(known.begin(), known.end(), ExtensionOf(path)) == known.end())
  {
    RefuseValue(option, path, "an image: " + extensions);
  }
  CheckReadable(path);
}

//------------------------------------------------------------------------------
void CheckAllowed(const std::string& path, const vtkRelievoAllowedFolders& allowed)
{
  const std::string obstacle = allowed.FindObstacle(path);
  if (!obstacle.empty())
  {
    throw WorkError(path + ": " + obstacle);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, ReadContext& context)
{
  context.AddFile(path);
  Progress& progress = context.GetProgress();
  progress.Begin("reading " + path);
  std::string failure;
  std::string note;
  const auto show = [&progress](double share) {
    progress.Update(share);
    return !progress.IsStopped();
  };
  const vtkSmartPointer<vtkImageData> image = vtkRelievoImageFile::Read(path, failure, show, &note);
  progress.End();
  context.Check(path, !image, "expected " + failure);
  if (!note.empty())
  {
    context.Note(path + ": " + note);
  }
  image->GetInformation()->Set(FileKey(), path);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(vtkRelievoImageFile::ToColors(image));
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}

//------------------------------------------------------------------------------
double FindCutoff(vtkImageData* image, vtkActor* actor)
{
  const bool whole = actor->GetProperty()->GetOpacity() >= 1.0;
  return whole && vtkRelievoImageFile::IsCutOut(image) ? 0.5 : 0.0;
}

//------------------------------------------------------------------------------
std::string GetImageFile(vtkImageData* image)
{
  const char* path = image ? image->GetInformation()->Get(FileKey()) : nullptr;
  return path ? path : "";
}
}
