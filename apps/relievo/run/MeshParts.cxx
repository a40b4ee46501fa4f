// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshParts.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "FileHash.h"
#include "Outputs.h"
#include "Progress.h"
#include "SightFiles.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoFileKind.h"
#include "vtkRelievoSightAlgorithm.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace cli
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char* MeshFile = "mesh.vtp";
constexpr const char* MergedFile = "merged.json"; // the hash of the result

// The kinds of arrays, by their name in a record.
constexpr const char* Kinds[] = { "cell", "point", "field" };

vtkFieldData* GetArrays(vtkPolyData* mesh, const std::string& kind)
{
  return kind == Kinds[0] ? mesh->GetCellData()
    : kind == Kinds[1]    ? static_cast<vtkFieldData*>(mesh->GetPointData())
                          : mesh->GetFieldData();
}

vtkIdType GetLength(vtkPolyData* mesh, const std::string& kind)
{
  return kind == Kinds[0] ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
}

// A mesh's shape: its points, cells and normals, not its other arrays.
void AddMesh(dataset::FileHash& hash, vtkPolyData* mesh)
{
  const auto add = [&hash](const std::vector<double>& values) {
    hash.Add(values.data(), values.size() * sizeof(double));
  };
  add({ static_cast<double>(mesh->GetNumberOfPoints()),
    static_cast<double>(mesh->GetNumberOfCells()) });
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType i = 0; normals && i < normals->GetNumberOfTuples(); ++i)
  {
    const double* normal = normals->GetTuple3(i);
    add({ normal[0], normal[1], normal[2] });
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    add({ point[0], point[1], point[2] });
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, points);
    std::vector<double> numbers = { static_cast<double>(mesh->GetCellType(i)) };
    numbers.insert(numbers.end(), points->begin(), points->end());
    add(numbers);
  }
}

// The share of an array of an output: of so many tuples, the first and the one after the last.
std::array<std::int64_t, 2> GetShare(
  const dataset::WorkPart& part, vtkPolyData* mesh, const std::string& kind, vtkDataArray* array)
{
  return kind == Kinds[2] ? std::array<std::int64_t, 2>{ 0, array->GetNumberOfTuples() }
                          : part.GetRange(GetLength(mesh, kind));
}

// Whether a record describes arrays of a part.
bool IsRecord(const Json& record, const dataset::WorkPart& part)
{
  const auto isNumber = [](const Json& json, const char* name) {
    return json.contains(name) && json[name].is_number_unsigned();
  };
  if (!record.is_object() || record.value("part", Json()) != part.Number ||
    record.value("of", Json()) != part.Count || !record.contains("arrays") ||
    !record["arrays"].is_array() || !record.contains("active") || !record["active"].is_object() ||
    !std::all_of(record["active"].begin(), record["active"].end(),
      [](const Json& name) { return name.is_string(); }))
  {
    return false;
  }
  const std::set<std::string> kinds(std::begin(Kinds), std::end(Kinds));
  const std::set<int> types = { VTK_UNSIGNED_CHAR, VTK_INT, VTK_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT,
    VTK_DOUBLE };
  constexpr int mostComponents = 9;
  return std::all_of(record["arrays"].begin(), record["arrays"].end(), [&](const Json& array) {
    return array.is_object() && array.contains("name") && array["name"].is_string() &&
      array.contains("of") && array["of"].is_string() && kinds.count(array["of"]) > 0 &&
      isNumber(array, "type") && types.count(array["type"]) > 0 && isNumber(array, "components") &&
      array["components"] >= 1 && array["components"] <= mostComponents &&
      isNumber(array, "tuples");
  });
}
}

//------------------------------------------------------------------------------
MeshParts::MeshParts(const std::string& folder)
  : Folder(folder)
{
}

//------------------------------------------------------------------------------
std::string MeshParts::GetPath(const dataset::WorkPart& part, const char* extension) const
{
  return this->Folder + "/" + part.GetStem() + extension;
}

//------------------------------------------------------------------------------
std::string MeshParts::GetFile() const
{
  return this->Folder.substr(0, this->Folder.size() - GetFolder("").size());
}

//------------------------------------------------------------------------------
bool MeshParts::Begin(const std::string& command, const std::string& words,
  vtkRelievoSightAlgorithm* filter, const dataset::WorkPart& part)
{
  dataset::FileHash hash;
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      AddMesh(hash, vtkPolyData::SafeDownCast(filter->GetInputDataObject(port, i)));
    }
  }
  this->Hash = dataset::OpenWorkFolder(this->Folder, Settings,
    { { "version", RELIEVO_VERSION }, { "command", command }, { "words", words },
      { "meshes", hash.Finish() }, { "parts", part.Count } });
  if (this->Has(part))
  {
    std::printf("%s: %s is complete\n", this->Folder.c_str(), part.GetText().c_str());
    return false;
  }
  filter->SetPart(part.Number, part.Count);
  this->Shown = std::make_unique<dataset::PartProgress>(this->Folder, part, "%");
  filter->AddObserver(vtkCommand::ProgressEvent, this, &MeshParts::TakeProgress);
  return true;
}

//------------------------------------------------------------------------------
void MeshParts::TakeProgress(vtkObject*, unsigned long, void* share)
{
  constexpr double all = 100.0;
  this->Shown->Update(all * *static_cast<double*>(share), all);
}

//------------------------------------------------------------------------------
void MeshParts::End(vtkRelievoSightAlgorithm* filter, const dataset::WorkPart& part,
  reading::Progress& progress) const
{
  this->Write(part, vtkPolyData::SafeDownCast(filter->GetInput()), filter->GetOutput(), progress);
  progress.End();
  std::printf("%s: %s written; relievo merge %s joins all parts\n", this->Folder.c_str(),
    part.GetText().c_str(), this->Folder.c_str());
}

//------------------------------------------------------------------------------
bool MeshParts::Has(const dataset::WorkPart& part) const
{
  const std::string path = this->GetPath(part, ".json");
  std::error_code trouble;
  if (!fs::exists(path, trouble))
  {
    return false;
  }
  const Json record = Json::parse(dataset::ReadWhole(path), nullptr, false);
  return IsRecord(record, part) && record.value("settings", Json()) == this->Hash &&
    dataset::FindDamage(this->Folder, record).empty();
}

//------------------------------------------------------------------------------
void MeshParts::Write(const dataset::WorkPart& part, vtkPolyData* mesh, vtkPolyData* result,
  reading::Progress& progress) const
{
  Json record = { { "part", part.Number }, { "of", part.Count }, { "version", RELIEVO_VERSION },
    { "settings", this->Hash }, { "arrays", Json::array() }, { "active", Json::object() } };
  std::string bytes;
  for (const char* kind : Kinds)
  {
    vtkFieldData* arrays = GetArrays(result, kind);
    vtkFieldData* before = GetArrays(mesh, kind);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      if (!array || before->GetAbstractArray(array->GetName()) == array)
      {
        continue;
      }
      const auto share = GetShare(part, result, kind, array);
      const auto size = static_cast<std::size_t>(array->GetNumberOfComponents()) *
        static_cast<std::size_t>(array->GetDataTypeSize());
      const auto tuples = static_cast<std::size_t>(share[1] - share[0]);
      if (tuples > 0)
      {
        bytes.append(static_cast<const char*>(
                       array->GetVoidPointer(share[0] * array->GetNumberOfComponents())),
          tuples * size);
      }
      record["arrays"].push_back({ { "name", array->GetName() }, { "of", kind },
        { "type", static_cast<unsigned>(array->GetDataType()) },
        { "components", static_cast<unsigned>(array->GetNumberOfComponents()) },
        { "tuples", tuples } });
    }
    auto* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
    if (attributes && attributes->GetScalars())
    {
      record["active"][kind] = attributes->GetScalars()->GetName();
    }
  }
  const std::string values = part.GetStem() + ".bin";
  dataset::WriteWhole(this->Folder + "/" + values, bytes);
  record["files"][values] = dataset::FileHash::Of(bytes);
  if (part.Number == 1)
  {
    const std::string path = this->Folder + "/" + MeshFile;
    reading::Outputs outputs;
    outputs.Add("-o", path, {});
    WriteMesh(mesh, "-o", path, outputs, progress);
    outputs.Commit();
    record["files"][MeshFile] = dataset::FileHash::OfFile(path);
  }
  dataset::CheckSettings(this->Folder, Settings, this->Hash);
  dataset::WriteWhole(this->GetPath(part, ".json"), dataset::WriteDatasetJson(record));
}

//------------------------------------------------------------------------------
dataset::WorkState MeshParts::Verify(dataset::WorkCheck check) const
{
  const std::string path = this->Folder + "/" + Settings;
  const Json settings = dataset::ReadWorkJson(path);
  if (!settings.is_object() || !settings.contains("parts") ||
    !settings["parts"].is_number_unsigned() || settings["parts"] < 1 ||
    settings["parts"] > std::numeric_limits<int>::max())
  {
    throw words::FileError(path + ": has no valid number of parts");
  }
  const std::string hash = dataset::FileHash::OfFile(path);
  dataset::WorkState state;
  state.Items = "parts";
  state.All = settings["parts"].get<std::size_t>();
  dataset::WorkPart part;
  part.Count = static_cast<int>(state.All);
  for (part.Number = 1; part.Number <= part.Count; ++part.Number)
  {
    const std::string name = std::to_string(part.Number);
    const std::string file = this->GetPath(part, ".json");
    std::error_code trouble;
    if (!fs::exists(file, trouble))
    {
      state.Missing.push_back(name);
      continue;
    }
    const Json record = Json::parse(dataset::ReadWhole(file), nullptr, false);
    const std::string damage = !IsRecord(record, part) ? "its record"
      : check == dataset::WorkCheck::Files             ? dataset::FindDamage(this->Folder, record)
                                                       : "";
    if (!damage.empty())
    {
      state.Damaged.push_back(name + " (" + damage + ")");
    }
    else if (record.value("version", Json()) != settings.value("version", Json()) ||
      record.value("settings", Json()) != hash)
    {
      state.Foreign.push_back(name);
    }
  }
  if (check == dataset::WorkCheck::Records)
  {
    return state;
  }
  const std::string file = this->GetFile();
  const std::string merged = this->Folder + "/" + MergedFile;
  std::error_code trouble;
  const bool exists = fs::exists(file, trouble);
  if (!exists || !fs::exists(merged, trouble) ||
    Json::parse(dataset::ReadWhole(merged), nullptr, false) !=
      Json({ { "hash", dataset::FileHash::OfFile(file) } }))
  {
    state.Result = file + (exists ? " is not that of these parts" : " is missing") +
      ": relievo merge " + this->Folder + " writes it";
  }
  return state;
}

//------------------------------------------------------------------------------
std::string MeshParts::Merge(reading::Progress& progress) const
{
  dataset::WorkState state = this->Verify(dataset::WorkCheck::Files);
  state.Result.clear();
  if (!state.IsWhole())
  {
    throw words::WorkError(state.GetText(this->Folder) + "run these parts, then merge");
  }
  const std::string file = this->GetFile();
  reading::Outputs outputs;
  outputs.Add("-o", file, {});
  const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(this->Folder + "/" + MeshFile, {}, progress);
  dataset::WorkPart part;
  part.Count = static_cast<int>(state.All);
  // Arrays of all parts; the arrays of fields are equal in all of them.
  std::map<std::pair<std::string, std::string>, vtkSmartPointer<vtkDataArray>> arrays;
  Json active;
  for (part.Number = 1; part.Number <= part.Count; ++part.Number)
  {
    const std::string path = this->GetPath(part, ".bin");
    const Json record = dataset::ReadWorkJson(this->GetPath(part, ".json"));
    std::string bytes;
    const std::string error =
      vtkRelievoFileKind::ReadWhole(path, std::numeric_limits<std::size_t>::max(), bytes);
    if (!error.empty())
    {
      throw words::FileError(path + ": " + error);
    }
    std::size_t at = 0;
    for (const Json& description : record["arrays"])
    {
      const std::string kind = description["of"];
      const std::string name = description["name"];
      const auto components = description["components"].get<int>();
      const auto tuples = description["tuples"].get<vtkIdType>();
      const int type = description["type"];
      const std::size_t size = static_cast<std::size_t>(components) *
        static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type));
      const auto refuse = [&] {
        throw words::FileError(
          path + ": its values do not fit the mesh; remove " + this->Folder + " and begin anew");
      };
      if (static_cast<std::size_t>(tuples) > (bytes.size() - at) / size)
      {
        refuse();
      }
      vtkSmartPointer<vtkDataArray>& array = arrays[{ kind, name }];
      if (!array)
      {
        array.TakeReference(vtkDataArray::CreateDataArray(type));
        array->SetName(name.c_str());
        array->SetNumberOfComponents(components);
        array->SetNumberOfTuples(kind == Kinds[2] ? tuples : GetLength(mesh, kind));
        GetArrays(mesh, kind)->AddArray(array);
      }
      const auto share = GetShare(part, mesh, kind, array);
      if (share[1] - share[0] != tuples || components != array->GetNumberOfComponents() ||
        type != array->GetDataType())
      {
        refuse();
      }
      const std::size_t length = size * static_cast<std::size_t>(tuples);
      if (length > 0)
      {
        std::memcpy(array->GetVoidPointer(share[0] * components), bytes.data() + at, length);
      }
      at += length;
    }
    active = record["active"];
  }
  for (const auto& [kind, name] : active.items())
  {
    if (auto* attributes = vtkDataSetAttributes::SafeDownCast(GetArrays(mesh, kind)))
    {
      attributes->SetActiveScalars(name.get<std::string>().c_str());
    }
  }
  WriteMesh(mesh, "-o", file, outputs, progress);
  outputs.Commit();
  dataset::WriteWhole(this->Folder + "/" + MergedFile,
    dataset::WriteDatasetJson({ { "hash", dataset::FileHash::OfFile(file) } }));
  dataset::PartProgress::Remove(this->Folder);
  dataset::RemoveTemporaryFiles(this->Folder);
  return file;
}
}
