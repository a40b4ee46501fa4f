// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Actors.h"
#include "Apart.h"
#include "BinarySTL.h"
#include "DataSets.h"
#include "Errors.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Validate.h"
#include "Values.h"
#include "VolumeImages.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoFileKind.h"
#include "vtkRelievoGeoTIFFReader.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoOBJReader.h"
#include "vtkRelievoOFFReader.h"
#include "vtkRelievoPLYReader.h"
#include "vtkRelievoTerrain.h"
#include "vtkSTLReader.h"
#include "vtkTypeInt32Array.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace reading
{
namespace
{
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> Open(const std::string& path, ReadContext&)
{
  vtkSmartPointer<Reader> reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

// VTK's reader reads to the end of the file, whatever count the header gives, and takes text for
// binary by the share of non-ASCII bytes among the first 256.
vtkSmartPointer<vtkAlgorithm> OpenSTL(const std::string& path, ReadContext& context)
{
  std::ifstream file(path, std::ios::binary);
  std::string head(1024, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  const auto read = static_cast<std::size_t>(file.gcount());
  const auto byte = [&head](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  const double size = static_cast<double>(std::filesystem::file_size(path));
  const double held = std::max(0., std::floor((size - 84.) / 50.));
  const double said = byte(80) + 256. * (byte(81) + 256. * (byte(82) + 256. * byte(83)));
  const bool hasZeros = head.find('\0') < read;
  if (head.compare(0, 3, "\xef\xbb\xbf") == 0 ||
    (hasZeros && head.find(std::string("s\0o\0l", 5)) < 4))
  {
    throw WorkError(path +
      ": expected text that begins with the word solid, and it begins with a byte order mark: save "
      "it as ASCII");
  }
  const auto looked = std::min<std::ptrdiff_t>(256, static_cast<std::ptrdiff_t>(read));
  const auto foreign = std::count_if(head.begin(), head.begin() + looked,
    [](char letter) { return static_cast<unsigned char>(letter) > 127; });
  const bool isText = !hasZeros && size != 84. + 50. * said;
  if (isText && 20 * foreign >= looked && looked > 0)
  {
    throw WorkError(path + ": expected ASCII, and " + std::to_string(foreign) +
      " of its first bytes are not: give the solid another name");
  }
  if (!isText)
  {
    const std::string counts = path + ": declares " + std::to_string(static_cast<long long>(said)) +
      " triangles, and has " + std::to_string(static_cast<long long>(held));
    if (held < said)
    {
      throw WorkError(counts + "; is it complete?");
    }
    if (held > said && said > 0.) // some writers leave the count at 0
    {
      context.Note(counts + ", which are drawn");
    }
  }
  return isText || held < 1. || held > BinarySTL::MostTriangles ? Open<vtkSTLReader>(path, context)
                                                                : Open<BinarySTL>(path, context);
}

// VTK's message about unknown legacy files says only that it cannot read them.
vtkSmartPointer<vtkAlgorithm> OpenLegacy(const std::string& path, ReadContext& context)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  const vtkNew<vtkCallbackCommand> nothing;
  reader->AddObserver(vtkCommand::ErrorEvent, nothing);
  const bool isKnown = reader->ReadOutputType() >= 0;
  if (!isKnown)
  {
    throw WorkError(path +
      ": expected DATASET with a mesh or a grid, such as POLYDATA or UNSTRUCTURED_GRID, "
      "after the three lines of the header; is the file complete, and does it contain "
      "geometry?");
  }
  return Open<vtkGenericDataObjectReader>(path, context);
}

// Lists pieces with VTK's own XML parser, which accepts unusual forms too.
void ListPieces(vtkXMLDataElement* element, std::vector<std::string>& pieces)
{
  for (const char* attribute : { "Source", "file" })
  {
    if (const char* name = element->GetAttribute(attribute))
    {
      pieces.emplace_back(name);
    }
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    ListPieces(element->GetNestedElement(i), pieces);
  }
}

// VTK's number for the type of the file's first element; negative: unknown type.
int FindKind(const std::string& path, bool& isParallel)
{
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  const vtkNew<vtkCallbackCommand> nothing; // VTK's message adds nothing
  reader->AddObserver(vtkCommand::ErrorEvent, nothing);
  return reader->ReadOutputType(path.c_str(), isParallel);
}

vtkSmartPointer<vtkAlgorithm> OpenXML(const std::string& path, ReadContext& context)
{
  bool isParallel = false;
  if (FindKind(path, isParallel) < 0)
  {
    throw WorkError(path + ": " + NotAsNamed(path));
  }
  return Open<vtkXMLGenericDataObjectReader>(path, context);
}

// The heights of a GeoTIFF as a mesh.
vtkSmartPointer<vtkAlgorithm> OpenTerrain(const std::string& path, ReadContext&)
{
  vtkNew<vtkRelievoGeoTIFFReader> reader;
  reader->SetFileName(path.c_str());
  auto terrain = vtkSmartPointer<vtkRelievoTerrain>::New();
  terrain->SetInputConnection(reader->GetOutputPort());
  return terrain;
}

// Whether VTK opens further files for this one: by its name or by its first element.
bool HasPieces(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  bool isParallel = false;
  const int kind = FindKind(path, isParallel);
  return isParallel || extension.rfind(".pvt", 0) == 0 || extension.rfind(".vtm", 0) == 0 ||
    !vtkDataObjectTypes::TypeIdIsA(kind, VTK_DATA_SET);
}

// VTK opens the pieces that a file names without any check. Throws WorkError for pieces outside the
// allowed folders.
void AddPieces(const std::string& path, ReadContext& context)
{
  const vtkRelievoAllowedFolders allowed = context.GetAllowed(path);
  std::vector<std::string> files = { path };
  std::set<std::string> known = { path };
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const std::string of = files[i];
    context.AddFile(of);
    std::vector<std::string> pieces;
    if (HasPieces(of))
    {
      vtkNew<vtkXMLDataParser> parser;
      vtkNew<vtkCallbackCommand> nothing; // the reader reports errors
      parser->AddObserver(vtkCommand::ErrorEvent, nothing);
      parser->SetFileName(of.c_str());
      parser->Parse();
      if (vtkXMLDataElement* root = parser->GetRootElement())
      {
        ListPieces(root, pieces);
      }
    }
    for (const std::string& name : pieces)
    {
      // VTK takes a name that begins like a drive for an absolute path.
      const std::filesystem::path folder = std::filesystem::path(of).parent_path();
      const bool isWhole = name.size() > 1 && name[1] == ':';
      const std::string piece = isWhole ? name : (folder / name).string();
      std::string error = allowed.FindObstacle(piece);
      if (error.empty())
      {
        error = vtkRelievoFileKind::FindInstead(piece);
      }
      if (!error.empty())
      {
        throw WorkError(of + ": names the piece " + name + ": " + error);
      }
      if (known.insert(piece).second)
      {
        files.push_back(piece);
      }
    }
  }
}

// Data files only; models belong to vtkRelievoModelReader.
struct Format
{
  std::vector<std::string> Extensions;
  vtkSmartPointer<vtkAlgorithm> (*Open)(const std::string& path, ReadContext& context);
  std::string Reader;  // name of the reader's owner, for messages
  bool HasZUp = false; // custom of CAD, printing and spatial grids
};

const std::vector<Format>& GetFormats()
{
  static const std::vector<Format> formats = {
    { { "vtp" }, OpenXML, "VTK" },
    { { "vtu", "vti", "vtr", "vts" }, OpenXML, "VTK", true },
    { { "vtm", "vtmb", "pvtp" }, OpenXML, "VTK" },
    { { "pvtu", "pvti", "pvtr", "pvts" }, OpenXML, "VTK", true },
    { { "vtk" }, OpenLegacy, "VTK" },
    { { "stl" }, OpenSTL, "VTK", true },
    { { "ply" }, Open<vtkRelievoPLYReader>, "ply" },
    { { "obj" }, Open<vtkRelievoOBJReader>, "obj" },
    { { "off" }, Open<vtkRelievoOFFReader>, "off" },
    { { "tif", "tiff" }, OpenTerrain, "tif", true },
  };
  return formats;
}

// nullptr: a model, or an unknown format.
const Format* FindFormat(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  for (const Format& format : GetFormats())
  {
    for (const std::string& each : format.Extensions)
    {
      if (extension == "." + each)
      {
        return &format;
      }
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
std::string ExtensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter; });
  return extension;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetDataExtensions()
{
  std::vector<std::string> all;
  for (const Format& format : GetFormats())
  {
    all.insert(all.end(), format.Extensions.begin(), format.Extensions.end());
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetModelExtensions()
{
  return Split(vtkRelievoModelReader::GetExtensions(), ' ');
}

//------------------------------------------------------------------------------
std::vector<std::string> GetExtensions()
{
  std::vector<std::string> all = GetDataExtensions();
  const std::vector<std::string> ofModels = GetModelExtensions();
  all.insert(all.end(), ofModels.begin(), ofModels.end());
  return all;
}

//------------------------------------------------------------------------------
void CheckExtension(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  if (extension == ".exr" || extension == ".hdr")
  {
    throw UsageError(path + ": is an image, no scene: --environment FILE lights a scene with it");
  }
  if (!HasReader(path))
  {
    throw UsageError(
      path + ": no reader for this extension; expected one of ." + Join(GetExtensions(), " ."));
  }
}

//------------------------------------------------------------------------------
bool HasReader(const std::string& path)
{
  return FindFormat(path) || IsModel(path);
}

//------------------------------------------------------------------------------
bool IsRaster(const std::string& path)
{
  const Format* format = FindFormat(path);
  return format && format->Open == OpenTerrain;
}

//------------------------------------------------------------------------------
bool IsGLTF(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  return extension == ".gltf" || extension == ".glb";
}

//------------------------------------------------------------------------------
bool IsModel(const std::string& path)
{
  const std::vector<std::string> known = GetModelExtensions();
  return std::any_of(known.begin(), known.end(),
    [extension = ExtensionOf(path)](const std::string& each) { return extension == "." + each; });
}

//------------------------------------------------------------------------------
bool HasZUp(const std::string& path)
{
  const Format* format = FindFormat(path);
  return format && format->HasZUp;
}

//------------------------------------------------------------------------------
std::string GetReaderName(const std::string& path)
{
  const Format* format = FindFormat(path);
  return format ? format->Reader : "VTK";
}

//------------------------------------------------------------------------------
void CheckReadable(const std::string& path)
{
  const std::string instead = vtkRelievoFileKind::FindInstead(path);
  if (!instead.empty())
  {
    throw WorkError(path + ": expected a file, but " + instead);
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file)
  {
    throw WorkError(path + ": " + std::strerror(errno));
  }
  std::fclose(file);
}

//------------------------------------------------------------------------------
void CheckFolder(const std::string& path)
{
  std::error_code trouble;
  if (!std::filesystem::is_directory(path, trouble))
  {
    throw WorkError("--allow-folder " + path + ": expected a folder that is there");
  }
}

//------------------------------------------------------------------------------
std::string NotAsNamed(const std::string& path)
{
  return "cannot be read as " + ExtensionOf(path) +
    "; does its content match its name, and is it complete?";
}

namespace
{
//------------------------------------------------------------------------------
// Numbers small enough for 32 bits; none otherwise.
vtkSmartPointer<vtkTypeInt32Array> Shrink(vtkDataArray* numbers)
{
  auto* large = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(numbers);
  if (!large)
  {
    return nullptr;
  }
  auto small = vtkSmartPointer<vtkTypeInt32Array>::New();
  small->SetNumberOfValues(large->GetNumberOfValues());
  std::transform(large->GetPointer(0), large->GetPointer(0) + large->GetNumberOfValues(),
    small->GetPointer(0), [](vtkTypeInt64 number) { return static_cast<vtkTypeInt32>(number); });
  return small;
}

//------------------------------------------------------------------------------
// Halves the memory for cells' corners if their numbers are small enough. VTK's own
// ConvertTo32BitStorage() takes longer than reading the cells.
void ShrinkCells(vtkDataObject* data)
{
  constexpr vtkIdType most = std::numeric_limits<vtkTypeInt32>::max();
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfPoints() > most)
  {
    return;
  }
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    if (cells->GetNumberOfCells() > 0 && cells->GetNumberOfConnectivityIds() <= most)
    {
      const auto starts = Shrink(cells->GetOffsetsArray());
      const auto corners = Shrink(cells->GetConnectivityArray());
      if (starts && corners)
      {
        cells->SetData(starts.Get(), corners.Get());
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadData(const std::string& path, ReadContext& context)
{
  Progress& progress = context.GetProgress();
  progress.Begin("reading " + path);
  const auto make = FindFormat(path)->Open;
  make == OpenXML ? AddPieces(path, context) : context.AddFile(path);
  const vtkSmartPointer<vtkAlgorithm> reader = make(path, context);
  progress.Observe(reader);
  reader->Update();
  const vtkSmartPointer<vtkDataObject> data = reader->GetOutputDataObject(0);
  progress.End();
  context.Check(path, !data || reader->GetErrorCode() != 0, NotAsNamed(path));
  if (auto* obj = vtkRelievoOBJReader::SafeDownCast(reader))
  {
    for (int i = 0; i < obj->GetNumberOfNotes(); ++i)
    {
      context.Note(path + ": " + obj->GetNote(i));
    }
  }
  CheckCells(data, path);
  ShrinkCells(data);
  return data;
}

template <bool Smooth, bool Images>
vtkSmartPointer<vtkDataObject> ReadShown(const std::string& path, ReadContext& context)
{
  const vtkSmartPointer<vtkDataObject> data = ReadData(path, context);
  vtkSmartPointer<vtkDataObject> image;
  if (Images)
  {
    image = GetVolumeImage(data);
  }
  return image ? image : MakeSurface(data, Smooth, path, context);
}

vtkSmartPointer<vtkDataObject> ReadBare(const std::string& path, ReadContext& context)
{
  return KeepPoints(ReadData(path, context));
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadSurface(
  const std::string& path, bool smooth, bool images, ReadContext& context)
{
  const ReadingWork works[2][2] = { { ReadShown<false, false>, ReadShown<false, true> },
    { ReadShown<true, false>, ReadShown<true, true> } };
  return ReadApart(works[smooth][images], path, context);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadPoints(const std::string& path, ReadContext& context)
{
  return ReadApart(ReadBare, path, context);
}
}
