// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorkFolder.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "FileHash.h"
#include "Values.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace fs = std::filesystem;

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char* ProgressFolder = "progress";

// The first file in the folder other than its settings, its progress and temporary files; empty:
// none.
std::string FindOther(const std::string& folder, const std::string& file)
{
  std::error_code trouble;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, trouble))
  {
    const std::string name = entry.path().filename().string();
    if (name.rfind(".relievo-", 0) != 0 && name != file && name != ProgressFolder)
    {
      return name;
    }
  }
  return "";
}

// "3, 5 and 7 more" for a long list.
std::string Shorten(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 8;
  std::vector<std::string> shown(
    names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  return Join(shown, ", ") +
    (names.size() > most ? " and " + std::to_string(names.size() - most) + " more" : "");
}

std::string WriteSeconds(double seconds)
{
  constexpr double minute = 60.0;
  constexpr double hour = 3600.0;
  char text[32];
  if (seconds < 2.0 * minute)
  {
    std::snprintf(text, sizeof(text), "%.0f s", seconds);
  }
  else if (seconds < 2.0 * hour)
  {
    std::snprintf(text, sizeof(text), "%.0f min", seconds / minute);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f h", seconds / hour);
  }
  return text;
}
}

//------------------------------------------------------------------------------
Json ReadWorkJson(const std::string& path)
{
  Json json = Json::parse(ReadWhole(path), nullptr, false);
  if (json.is_discarded())
  {
    throw FileError(path + ": is not JSON; remove it, or give another folder");
  }
  return json;
}

//------------------------------------------------------------------------------
std::string OpenWorkFolder(const std::string& folder, const std::string& file, const Json& settings)
{
  const std::string path = folder + "/" + file;
  const std::string hash = FileHash::Of(WriteDatasetJson(settings));
  std::error_code trouble;
  if (!fs::exists(path, trouble))
  {
    MakeFolder(folder);
    const std::string other = FindOther(folder, file);
    if (other.empty())
    {
      WriteWhole(path, WriteDatasetJson(settings));
      return hash;
    }
    if (!fs::exists(path, trouble)) // another process may have created it meanwhile
    {
      throw UsageError(folder + ": contains other files, such as " + other +
        "; give a folder that is empty or not there");
    }
  }
  const Json before = ReadWorkJson(path);
  const Json now = Json::parse(WriteDatasetJson(settings)); // as in the file
  // A computed depth step depends on all settings, so the message names the differing setting.
  std::vector<std::string> names;
  for (const auto& [name, value] : now.items())
  {
    names.push_back(name);
  }
  std::stable_partition(
    names.begin(), names.end(), [](const std::string& name) { return name != "depth_step"; });
  for (const std::string& name : names)
  {
    const Json& value = now[name];
    if (!before.contains(name) || before[name] != value)
    {
      if (FindOther(folder, file).empty())
      {
        WriteWhole(path, WriteDatasetJson(settings));
        return hash;
      }
      throw UsageError(folder + ": was begun " +
        (before.contains(name) ? "with " + name + " " + before[name].dump() : "without " + name) +
        ", now it is " + value.dump() + "; give another folder, or the settings of before");
    }
  }
  return hash;
}

//------------------------------------------------------------------------------
void CheckSettings(const std::string& folder, const std::string& file, const std::string& hash)
{
  if (FileHash::OfFile(folder + "/" + file) != hash)
  {
    throw WorkError(folder + ": another call has begun it anew; give each its own folder");
  }
}

//------------------------------------------------------------------------------
std::string FindDamage(const std::string& folder, const Json& record)
{
  const auto files = record.find("files");
  if (files == record.end() || !files->is_object())
  {
    return "files";
  }
  for (const auto& [name, hash] : files->items())
  {
    // A path that leaves the folder was not written by us.
    const fs::path path = fs::path(name).lexically_normal();
    if (path.is_absolute() || path.begin() == path.end() || *path.begin() == ".." ||
      !hash.is_string() || FileHash::OfFile(folder + "/" + path.string()) != hash)
    {
      return name.empty() ? "files" : name;
    }
  }
  return "";
}

//------------------------------------------------------------------------------
bool WorkState::IsWhole() const
{
  return this->Missing.empty() && this->Damaged.empty() && this->Foreign.empty() &&
    this->Result.empty();
}

//------------------------------------------------------------------------------
std::string WorkState::GetText(const std::string& folder) const
{
  const std::size_t incomplete = this->Missing.size() + this->Damaged.size() + this->Foreign.size();
  std::string text = folder + ": " + std::to_string(this->All - incomplete) + " of " +
    std::to_string(this->All) + " " + this->Items + " complete\n";
  const auto add = [&text](const char* kind, const std::vector<std::string>& names) {
    if (!names.empty())
    {
      text += "  " + std::to_string(names.size()) + " " + kind + ": " + Shorten(names) + "\n";
    }
  };
  add("missing", this->Missing);
  add("damaged", this->Damaged);
  add("of another version or other settings", this->Foreign);
  if (!this->Result.empty())
  {
    text += "  " + this->Result + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
PartProgress::PartProgress(
  const std::string& folder, const WorkPart& part, const std::string& items)
  : Folder(folder)
  , Items(items)
  , Part(part)
{
}

//------------------------------------------------------------------------------
void PartProgress::Update(double done, double all, double before)
{
  constexpr std::chrono::seconds pause(2);
  const Clock::time_point now = Clock::now();
  if (done < all && this->Written != Clock::time_point::min() && now - this->Written < pause)
  {
    return;
  }
  this->Written = now;
  const double seconds = std::chrono::duration<double>(now - this->Began).count();
  const Json json = { { "part", this->Part.Number }, { "of", this->Part.Count },
    { "items", this->Items }, { "done", done }, { "all", all }, { "before", before },
    { "seconds", seconds } };
  try
  {
    WriteWhole(this->Folder + "/" + ProgressFolder + "/" + this->Part.GetStem() + ".json",
      WriteDatasetJson(json));
  }
  catch (const WorkError&)
  {
    // A full disk ends the work itself, with a message.
  }
}

//------------------------------------------------------------------------------
std::string PartProgress::GetText(const std::string& folder)
{
  std::vector<std::string> paths;
  std::error_code trouble;
  for (const auto& entry : fs::directory_iterator(folder + "/" + ProgressFolder, trouble))
  {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  std::string text;
  for (const std::string& path : paths)
  {
    if (fs::path(path).filename().string().rfind("part-", 0) != 0)
    {
      continue;
    }
    Json json;
    try
    {
      json = ReadWorkJson(path);
    }
    catch (const WorkError&) // removed meanwhile, by merge
    {
      continue;
    }
    if (!json.is_object())
    {
      continue;
    }
    const auto number = [&json](const char* name) {
      const auto found = json.find(name);
      return found != json.end() && found->is_number() ? found->get<double>() : 0.0;
    };
    const double done = number("done");
    const double all = number("all");
    const double seconds = number("seconds");
    const double made = done - number("before");
    char line[256];
    std::snprintf(line, sizeof(line), "part %.0f of %.0f: %.0f of %.0f %s", number("part"),
      number("of"), done, all,
      json.value("items", Json()) == "%"          ? "%"
        : json.value("items", Json()) == "frames" ? "frames"
                                                  : "views");
    text += line;
    if (done >= all)
    {
      text += ", done";
    }
    else if (made > 0.0 && seconds > 0.0)
    {
      std::snprintf(line, sizeof(line), ", %.3g a second, ", made / seconds);
      text += line + WriteSeconds((all - done) * seconds / made) + " left";
    }
    text += "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
void PartProgress::Remove(const std::string& folder)
{
  std::error_code trouble;
  fs::remove_all(fs::path(folder) / ProgressFolder, trouble);
}

//------------------------------------------------------------------------------
void RemoveTemporaryFiles(const std::string& folder)
{
  std::error_code trouble;
  std::vector<fs::path> left; // by parts that were killed while they wrote a file
  for (fs::recursive_directory_iterator at(folder, trouble), end; !trouble && at != end;
       at.increment(trouble))
  {
    const std::string name = at->path().filename().string();
    if (name.rfind(".relievo-", 0) == 0 && at->path().extension() == ".tmp")
    {
      left.push_back(at->path());
    }
  }
  for (const fs::path& path : left)
  {
    fs::remove(path, trouble);
  }
}
}
