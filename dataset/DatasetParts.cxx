// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetParts.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "FileHash.h"
#include "TarArchive.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

namespace fs = std::filesystem;

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// The settings that a data set's folder was begun with, and its complete records.
struct Dataset
{
  DatasetStyle Style;
  std::vector<std::string> Objects;
  std::vector<Json> Records;
  WorkState State;
};

std::vector<std::string> GetPaths(const DatasetStyle& style, const DatasetArchive& archive)
{
  std::vector<std::string> paths;
  for (const std::string& file : archive.Files)
  {
    paths.push_back(style.Folder + "/" + file);
  }
  return paths;
}

template <typename Is>
const Json& Need(const Json& settings, const std::string& path, const char* name, const Is& is)
{
  const auto found = settings.is_object() ? settings.find(name) : settings.end();
  if (found == settings.end() || !is(*found))
  {
    throw FileError(path + ": has no valid " + name + "; expected the settings of a data set");
  }
  return *found;
}

//------------------------------------------------------------------------------
Dataset ReadDataset(const std::string& folder, WorkCheck check)
{
  const std::string path = folder + "/" + DatasetSettings;
  const Json settings = ReadWorkJson(path);
  const auto isNumber = [](const Json& json) { return json.is_number(); };
  const auto isText = [](const Json& json) { return json.is_string(); };
  const auto isTexts = [&isText](const Json& json) {
    return json.is_array() && std::all_of(json.begin(), json.end(), isText);
  };
  Dataset set;
  set.Style.Folder = folder;
  const std::string format = Need(settings, path, "format", isText);
  for (const auto& each : GetDatasetFormats())
  {
    set.Style.Format = each->Name == format ? each.get() : set.Style.Format;
  }
  if (!set.Style.Format)
  {
    throw FileError(path + ": has the format '" + format + "', which this version does not have");
  }
  set.Style.DepthStep = Need(settings, path, "depth_step", isNumber);
  set.Style.MillimetersPerUnit = Need(settings, path, "mm_per_unit", isNumber);
  set.Objects = Need(settings, path, "objects", isTexts).get<std::vector<std::string>>();
  std::vector<std::string> categories = set.Objects;
  if (settings.contains("categories")) // else an earlier version has begun the folder
  {
    categories = Need(settings, path, "categories", [&](const Json& json) {
      return isTexts(json) && json.size() == set.Objects.size();
    }).get<std::vector<std::string>>();
  }
  set.Style.SetCategories(categories);
  if (settings.contains("validation"))
  {
    set.Style.Validation = Need(settings, path, "validation", isNumber);
  }
  if (settings.contains("shard_size"))
  {
    set.Style.ShardBytes =
      BytesOfMegabyte * Need(settings, path, "shard_size", isNumber).get<double>();
  }
  set.State.Items = "views";
  set.State.All = Need(settings, path, "views", [](const Json& json) {
    return json.is_number_unsigned() && json <= std::numeric_limits<int>::max();
  }).get<std::size_t>();
  const Json& version = Need(settings, path, "version", isText);
  const std::string hash = FileHash::OfFile(path);
  for (std::size_t view = 0; view < set.State.All; ++view)
  {
    const std::string name = std::to_string(view);
    const std::string file = GetDatasetRecord(folder, view);
    std::error_code trouble;
    if (!fs::exists(file, trouble))
    {
      set.State.Missing.push_back(name);
      continue;
    }
    Json record = Json::parse(ReadWhole(file), nullptr, false);
    if (record.is_discarded() || !IsDatasetRecord(*set.Style.Format, record, set.Objects.size()) ||
      record["view"] != view)
    {
      set.State.Damaged.push_back(name + " (its record)");
      continue;
    }
    const std::string damaged =
      check == WorkCheck::Files ? FindDamage(folder, record) : std::string();
    if (!damaged.empty())
    {
      set.State.Damaged.push_back(name + " (" + damaged + ")");
    }
    else if (record.value("version", Json()) != version || record.value("settings", Json()) != hash)
    {
      set.State.Foreign.push_back(name);
    }
    set.Records.push_back(std::move(record));
  }
  return set;
}
}

//------------------------------------------------------------------------------
std::string GetDatasetRecord(const std::string& folder, std::size_t view)
{
  return folder + "/views/" + WriteDatasetNumber(view) + ".json";
}

//------------------------------------------------------------------------------
void WriteDatasetIndex(const DatasetStyle& style, const std::vector<std::string>& objects,
  const std::vector<Json>& records)
{
  for (const DatasetArchive& archive : style.Format->GetArchives(style, records))
  {
    WriteWhole(style.Folder + "/" + archive.Name, [&](const std::string& name) {
      std::ofstream out(name, std::ios::binary);
      JoinTars(GetPaths(style, archive), [&out](const std::string& bytes) {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      });
      out.close();
      return out.good();
    });
  }
  for (const auto& [name, content] : style.Format->MakeIndex(style, objects, records))
  {
    WriteWhole(style.Folder + "/" + name, content);
  }
}

//------------------------------------------------------------------------------
WorkState VerifyDataset(const std::string& folder, WorkCheck check)
{
  Dataset set = ReadDataset(folder, check);
  WorkState& state = set.State;
  if (check == WorkCheck::Records)
  {
    return state;
  }
  const auto compare = [&](const std::string& name, const auto& hash) {
    std::error_code trouble;
    const std::string path = folder + "/" + name;
    const bool exists = fs::exists(path, trouble);
    if (state.Result.empty() && !(exists && FileHash::OfFile(path) == hash()))
    {
      state.Result = name + (exists ? " is not that of these views" : " is missing") +
        ": relievo merge " + folder + " writes the indices";
    }
  };
  if (state.IsWhole())
  {
    for (const DatasetArchive& archive : set.Style.Format->GetArchives(set.Style, set.Records))
    {
      compare(archive.Name, [&] {
        FileHash joined;
        JoinTars(GetPaths(set.Style, archive),
          [&joined](const std::string& bytes) { joined.Add(bytes.data(), bytes.size()); });
        return joined.Finish();
      });
    }
  }
  for (const auto& [name, content] :
    set.Style.Format->MakeIndex(set.Style, set.Objects, set.Records))
  {
    compare(name, [&bytes = content] { return FileHash::Of(bytes); });
  }
  return state;
}

//------------------------------------------------------------------------------
void MergeDataset(const std::string& folder)
{
  const Dataset set = ReadDataset(folder, WorkCheck::Files);
  if (!set.State.IsWhole())
  {
    throw WorkError(set.State.GetText(folder) + "run the parts that draw these views, then merge");
  }
  WriteDatasetIndex(set.Style, set.Objects, set.Records);
  PartProgress::Remove(folder);
  RemoveTemporaryFiles(folder);
}
}
