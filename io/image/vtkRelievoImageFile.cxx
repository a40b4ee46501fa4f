// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoImageFile.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoMessageText.h"
#include "vtkRelievoPngDamage.h"
#include "vtkWeakPointer.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>
#include <vtksys/SystemTools.hxx>

namespace
{
using Time = std::filesystem::file_time_type;

// Images that are in use, and when their files were written.
std::map<std::string, std::pair<Time, vtkWeakPointer<vtkImageData>>>& Held()
{
  static std::map<std::string, std::pair<Time, vtkWeakPointer<vtkImageData>>> held;
  return held;
}

// The first thing that a reader has to say against a file; it is not printed.
void Keep(vtkObject*, unsigned long, void* words, void* text)
{
  auto* kept = static_cast<std::string*>(words);
  if (kept->empty() && text)
  {
    *kept = vtkRelievoMessageText::OfMessage(static_cast<const char*>(text));
  }
}

// What is wrong with a PNG file, empty if nothing is.
std::string FindDamage(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return vtkRelievoFindPngDamage(file);
}

vtkSmartPointer<vtkImageAlgorithm> MakeReader(const std::string& path)
{
  vtkNew<vtkRelievoEXRReader> exr;
  if (exr->CanReadFile(path.c_str()))
  {
    exr->SetFileName(path.c_str());
    return exr;
  }
  // By its name first: asked about any file, some readers have something to print.
  const std::string ending =
    vtksys::SystemTools::LowerCase(std::filesystem::path(path).extension().string());
  auto reader =
    vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2FromExtension(ending.c_str()));
  if (ending.empty() || !reader || !reader->CanReadFile(path.c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(path.c_str());
  return reader;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkRelievoImageFile::Read(
  const std::string& path, std::string& failure, const std::function<void(vtkAlgorithm*)>& watch)
{
  std::error_code error;
  const Time written = std::filesystem::last_write_time(path, error);
  if (error || std::filesystem::is_directory(path, error))
  {
    failure = error ? "an image, but there is no such file" : "an image, but it is a folder";
    return nullptr;
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    failure = std::string("an image, but it cannot be opened: ") + std::strerror(errno);
    return nullptr;
  }
  auto& held = Held()[path];
  if (held.second && held.first == written)
  {
    return held.second.GetPointer();
  }
  const vtkSmartPointer<vtkImageAlgorithm> reader = MakeReader(path);
  if (!reader)
  {
    failure =
      "an image (png, jpg, tif, bmp, hdr, exr), but its name or its first bytes are of none";
    return nullptr;
  }
  std::string said = reader->IsA("vtkPNGReader") ? FindDamage(path) : std::string();
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(Keep);
  keep->SetClientData(&said);
  for (vtkObject* speaker :
    { static_cast<vtkObject*>(reader), static_cast<vtkObject*>(reader->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, keep);
    speaker->AddObserver(vtkCommand::WarningEvent, keep);
  }
  if (watch)
  {
    watch(reader);
  }
  if (said.empty())
  {
    try
    {
      reader->Update();
    }
    catch (const std::exception& thrown) // for a header's sizes that there is no memory for
    {
      said = thrown.what();
    }
  }
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (!said.empty() || !image || !image->GetPointData()->GetScalars() ||
    image->GetNumberOfPoints() == 0 || reader->GetErrorCode() != 0)
  {
    failure = "an image, but it cannot be read" + (said.empty() ? said : ": " + said);
    return nullptr;
  }
  vtkNew<vtkImageData> alone; // which does not hold the reader
  alone->ShallowCopy(image);
  held = { written, alone.Get() };
  return alone;
}
