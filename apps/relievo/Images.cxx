// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"

#include "CrashGuard.h"
#include "Failure.h"
#include "Messages.h"
#include "Progress.h"
#include "Readers.h"
#include "Values.h"

#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkRelievoEXRReader.h"

#include <algorithm>
#include <exception>

namespace cli
{
//------------------------------------------------------------------------------
void CheckImage(
  const std::string& option, const std::string& path, const std::vector<std::string>& extensions)
{
  if (std::find(extensions.begin(), extensions.end(), ExtensionOf(path)) == extensions.end())
  {
    RefuseValue(option, path, "an image: " + Join(extensions, " "));
  }
  CheckReadable(path);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, Progress& progress)
{
  progress.Begin("reading " + path);
  vtkSmartPointer<vtkImageAlgorithm> reader;
  if (ExtensionOf(path) == ".exr")
  {
    auto exr = vtkSmartPointer<vtkRelievoEXRReader>::New();
    exr->SetFileName(path.c_str());
    reader = exr;
  }
  else if (auto* image = vtkImageReader2Factory::CreateImageReader2(path.c_str()))
  {
    reader.TakeReference(image);
    image->SetFileName(path.c_str());
  }
  if (reader)
  {
    progress.Observe(reader);
    try
    {
      const CrashGuard guard(path);
      reader->Update();
    }
    catch (const std::exception& error) // for a header's sizes that there is no memory for
    {
      throw WorkError(path + ": " + NotAsNamed(path) + " (" + error.what() + ")");
    }
  }
  progress.End();
  vtkSmartPointer<vtkImageData> image = reader ? reader->GetOutput() : nullptr;
  Messages::Check(path, !image || image->GetNumberOfPoints() == 0 || reader->GetErrorCode() != 0,
    NotAsNamed(path));
  return image;
}
}
