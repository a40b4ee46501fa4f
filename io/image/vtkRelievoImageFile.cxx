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
#include "vtkWeakPointer.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>
#include <vector>
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

// As of PNG's chunks: ISO 3309.
std::uint32_t Checksum(const std::vector<char>& bytes)
{
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t i = 0; i < 256; ++i)
    {
      made[i] = i;
      for (int bit = 0; bit < 8; ++bit)
      {
        made[i] = (made[i] >> 1) ^ (made[i] & 1 ? 0xEDB88320U : 0U);
      }
    }
    return made;
  }();
  std::uint32_t sum = ~0U;
  for (const char byte : bytes)
  {
    sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (sum >> 8);
  }
  return ~sum;
}

// What is wrong with a PNG file's chunks, empty if nothing is: VTK's reader crashes on such files.
std::string FindDamage(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  file.seekg(8);
  auto number = [&file] {
    unsigned char bytes[4] = {};
    file.read(reinterpret_cast<char*>(bytes), 4);
    return (static_cast<std::uint32_t>(bytes[0]) << 24) | (bytes[1] << 16) | (bytes[2] << 8) |
      bytes[3];
  };
  for (std::uint64_t at = 8; at + 12 <= size;)
  {
    const std::uint64_t length = number();
    at += length + 12;
    if (at > size)
    {
      break;
    }
    std::vector<char> bytes(length + 4);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::uint32_t sum = number();
    if (sum != Checksum(bytes))
    {
      return "it is damaged";
    }
    if (std::string(bytes.data(), 4) == "IEND")
    {
      return {};
    }
  }
  return "it ends too early";
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
