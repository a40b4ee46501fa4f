// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoImageFile.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRImage.h"
#include "vtkRelievoFileKind.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoImageBytes.h"
#include "vtkRelievoReaderProcess.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <system_error>
#include <utility>
#include <vector>
#include <vtksys/SystemTools.hxx>

namespace
{
using relievo::image::Bytes;
using relievo::image::Failure;
using Time = std::filesystem::file_time_type;

// Images in use, and when their files were last written.
std::map<std::string, std::pair<Time, vtkWeakPointer<vtkImageData>>>& Cache()
{
  static std::map<std::string, std::pair<Time, vtkWeakPointer<vtkImageData>>> cache;
  return cache;
}

using Decoder = vtkSmartPointer<vtkImageData> (*)(const Bytes&);

struct Format
{
  std::vector<std::string> Extensions;
  std::vector<std::string> Begins;     // first bytes; empty: detected by its name, or by Ends
  Decoder Decode;                      // nullptr: only read from files
  std::vector<std::string> Types = {}; // MIME types, for formats detected by name
  std::string Ends = {};
};

const std::vector<Format>& GetFormats()
{
  using namespace relievo::image;
  using std::string;
  static const std::vector<Format> formats = {
    { { "png" }, { "\x89PNG\r\n\x1a\n" }, DecodePNG },
    { { "jpg", "jpeg" }, { "\xff\xd8\xff" }, DecodeJPEG },
    { { "tif", "tiff" },
      { string("II*\0", 4), string("MM\0*", 4), string("II+\0", 4), string("MM\0+", 4) },
      DecodeTIFF },
    { { "bmp" }, { "BM" }, DecodeBMP },
    { { "tga" }, {}, DecodeTGA, { "image/tga", "image/x-tga", "image/x-targa" },
      string("TRUEVISION-XFILE.\0", 18) },
    { { "hdr" }, { "#?RADIANCE", "#?RGBE" }, DecodeHDR },
    { { "exr" }, { "\x76\x2f\x31\x01" }, nullptr },
  };
  return formats;
}

bool IsOf(const Format& format, const Bytes& bytes, const std::string& name)
{
  if (!format.Begins.empty())
  {
    return std::any_of(format.Begins.begin(), format.Begins.end(),
      [&bytes](const std::string& begin) { return bytes.BeginsWith(begin); });
  }
  const std::size_t size = format.Ends.size();
  if (bytes.Size() > size && bytes.From(bytes.Size() - size).BeginsWith(format.Ends))
  {
    return true;
  }
  const std::string low = vtksys::SystemTools::LowerCase(name);
  const auto isNamed = [&low](const std::string& extension) {
    return low == extension || vtksys::SystemTools::StringEndsWith(low, ("." + extension).c_str());
  };
  return std::any_of(format.Extensions.begin(), format.Extensions.end(), isNamed) ||
    std::any_of(format.Types.begin(), format.Types.end(), [&low](const std::string& type) {
      return vtksys::SystemTools::StringEndsWith(low, type.c_str());
    });
}

// The first bytes take precedence over the name.
const Format* FindFormat(const Bytes& bytes, const std::string& name)
{
  const Format* named = nullptr;
  for (const Format& format : GetFormats())
  {
    if (IsOf(format, bytes, name))
    {
      if (!format.Begins.empty())
      {
        return &format;
      }
      named = &format;
    }
  }
  return named;
}

std::string GetExpected()
{
  std::string names;
  for (const Format& format : GetFormats())
  {
    names += (names.empty() ? "" : ", ") + format.Extensions.front();
  }
  return "an image (" + names + "), but its first bytes are of none";
}

// Exceptions become the failure's text.
vtkSmartPointer<vtkImageData> Attempt(
  const std::function<vtkSmartPointer<vtkImageData>()>& read, std::string& failure)
{
  std::string error;
  try
  {
    return read();
  }
  catch (const Failure& thrown)
  {
    error = thrown.what();
  }
  catch (const std::exception&) // out of memory
  {
    error = "there is no memory for it";
  }
  // Parts of the text may come from the file.
  std::replace_if(
    error.begin(), error.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  failure = "an image, but it cannot be read: " + error;
  return nullptr;
}

vtkSmartPointer<vtkImageData> DecodeBytes(
  const Bytes& bytes, const std::string& name, std::string& failure)
{
  const Format* format = bytes.Size() > 0 ? FindFormat(bytes, name) : nullptr;
  if (!format || !format->Decode)
  {
    failure = bytes.Size() == 0 ? "an image, but it is empty"
      : format                  ? "an image, but OpenEXR is read from files of its own alone"
                                : GetExpected();
    return nullptr;
  }
  return Attempt([&] { return format->Decode(bytes); }, failure);
}

using Share = std::function<bool(double)>;

void Watch(vtkAlgorithm* reader, const Share& progress)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(const_cast<Share*>(&progress));
  command->SetCallback([](vtkObject* caller, unsigned long, void* client, void* share) {
    if (share && !(*static_cast<const Share*>(client))(*static_cast<double*>(share)))
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  });
  reader->AddObserver(vtkCommand::ProgressEvent, command);
}

vtkSmartPointer<vtkImageData> ReadFile(
  const std::string& path, std::string& failure, std::string& note, const Share& progress)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    failure = std::string("an image, but it cannot be opened: ") + std::strerror(errno);
    return nullptr;
  }
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::vector<unsigned char> bytes(4);
  file.read(reinterpret_cast<char*>(bytes.data()), 4);
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  const Format* format = FindFormat({ bytes.data(), bytes.size() }, "");
  if (format && !format->Decode)
  {
    const auto watch = [&progress](vtkAlgorithm* reader) { Watch(reader, progress); };
    return Attempt([&] { return relievo::image::ReadEXR(path, note, watch); }, failure);
  }
  if (error || size > vtkRelievoImageFile::MostBytes)
  {
    failure = "an image of at most " + std::to_string(vtkRelievoImageFile::MostBytes >> 30) +
      " GiB, but the file has " + std::to_string(size) + " bytes";
    return nullptr;
  }
  try
  {
    bytes.resize(size);
  }
  catch (const std::exception&)
  {
    failure = "an image, but there is no memory for it";
    return nullptr;
  }
  file.clear();
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  return DecodeBytes({ bytes.data(), static_cast<std::size_t>(file.gcount()) }, path, failure);
}

//------------------------------------------------------------------------------
struct Answer
{
  std::string Failure, Note;
  vtkSmartPointer<vtkImageData> Image;
};

template <typename Visit>
void VisitFields(Answer& answer, Visit&& visit)
{
  visit(answer.Failure, answer.Note, answer.Image);
}

struct NamedBytes
{
  std::string Name;
  relievo::ByteSpan Content;
};

template <typename Visit>
void VisitFields(NamedBytes& bytes, Visit&& visit)
{
  visit(bytes.Name, bytes.Content);
}

// Both run in the process of the image.
void AnswerFile(const std::string& path, const vtkRelievoReaderProcess::Say& say, Answer& made)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  vtkRelievoReaderProcess::Allow(error ? 0 : size);
  made.Image =
    ReadFile(path, made.Failure, made.Note, [&say](double share) { return say("", share); });
}

void AnswerBytes(const NamedBytes& asked, const vtkRelievoReaderProcess::Say&, Answer& made)
{
  const auto& [name, content] = asked;
  vtkRelievoReaderProcess::Allow(content.Size);
  made.Image = DecodeBytes(
    { reinterpret_cast<const unsigned char*>(content.Data), content.Size }, name, made.Failure);
}

template <auto work, typename Asked>
vtkSmartPointer<vtkImageData> Do(
  const Asked& asked, std::string& failure, std::string* note, const Share& progress)
{
  Answer made;
  const std::string end = vtkRelievoReaderProcess::Do<work>(
    asked, [&progress](const std::string&, double share) { return !progress || progress(share); },
    made);
  failure = end.empty() ? made.Failure : "an image, but its reader " + end;
  if (failure.empty() && (!made.Image || !made.Image->GetPointData()->GetScalars()))
  {
    failure = "an image, but its reader crashed: its result is damaged";
  }
  if (note)
  {
    *note = made.Note;
  }
  return failure.empty() ? made.Image : nullptr;
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoImageFile::ListExtensions(
  const std::string& before, const std::string& between)
{
  std::string list;
  for (const Format& format : GetFormats())
  {
    for (const std::string& extension : format.Extensions)
    {
      list += (list.empty() ? "" : between) + before + extension;
    }
  }
  return list;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkRelievoImageFile::Read(const std::string& path,
  std::string& failure, const std::function<bool(double)>& progress, std::string* note)
{
  std::error_code error;
  const Time written = std::filesystem::last_write_time(path, error);
  if (error)
  {
    failure = "an image, but there is no such file";
    return nullptr;
  }
  const std::string instead = vtkRelievoFileKind::FindInstead(path);
  if (!instead.empty())
  {
    failure = "an image, but " + instead;
    return nullptr;
  }
  auto& cached = Cache()[path];
  if (cached.second && cached.first == written)
  {
    return cached.second.GetPointer();
  }
  const vtkSmartPointer<vtkImageData> image = Do<AnswerFile>(path, failure, note, progress);
  cached = { written, image.Get() };
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkRelievoImageFile::Decode(
  const void* bytes, std::size_t size, const std::string& name, std::string& failure)
{
  return Do<AnswerBytes>(
    NamedBytes{ name, { static_cast<const char*>(bytes), size } }, failure, nullptr, nullptr);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkRelievoImageFile::ToColors(vtkImageData* image)
{
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return image;
  }
  const bool whole = values->GetDataType() == VTK_UNSIGNED_SHORT;
  const int components = std::min(4, values->GetNumberOfComponents());
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName(values->GetName());
  bytes->SetNumberOfComponents(components);
  bytes->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = values->GetComponent(i, c) / (whole ? 65535. : 1.);
      const double kept = std::isnan(value) ? 0. : std::clamp(value, 0., 1.);
      const bool alpha = components % 2 == 0 && c == components - 1;
      const double shown = whole || alpha ? kept : relievo::f64::relievoSrgbFromLinear(kept);
      bytes->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(255. * shown)));
    }
  }
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(image->GetDimensions());
  made->GetPointData()->SetScalars(bytes);
  return made;
}

//------------------------------------------------------------------------------
bool vtkRelievoImageFile::IsCutOut(vtkImageData* image)
{
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  const int components = values ? values->GetNumberOfComponents() : 1;
  if (components != 2 && components != 4)
  {
    return false;
  }
  const int type = values->GetDataType();
  const double most = type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : values->GetDataTypeMax();
  bool cuts = false;
  bool shows = false;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double alpha = values->GetComponent(i, components - 1);
    if (alpha != 0.0 && alpha != most)
    {
      return false;
    }
    cuts = cuts || alpha == 0.0;
    shows = shows || alpha == most;
  }
  return cuts && shows;
}
