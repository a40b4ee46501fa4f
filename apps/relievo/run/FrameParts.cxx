// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameParts.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "FileHash.h"
#include "FrameList.h"
#include "Options.h"
#include "SequenceOptions.h"
#include "VideoFile.h"
#include "WriteOutputs.h"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace fs = std::filesystem;

namespace cli
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char* MergedFilm = "merged.json"; // the hash of the film

std::vector<std::string> GetOutputs(const scene::RenderOptions& options)
{
  std::vector<std::string> outputs;
  for (const std::string& name :
    { options.PNG, options.EXR, options.Baseline, options.Gltf, options.Report })
  {
    if (!name.empty())
    {
      outputs.push_back(name);
    }
  }
  return outputs;
}

bool IsBelow(const fs::path& path)
{
  return !path.empty() && *path.begin() != ".." && !path.is_absolute();
}

// Whether settings are those that Begin() writes in a folder. Files of a folder from elsewhere may
// name no file that is not beside the folder or below.
bool IsSettings(const Json& json, const fs::path& folder)
{
  const auto isOutput = [](const Json& value) {
    return value.is_string() && IsBelow(fs::path(value.get<std::string>()).lexically_normal());
  };
  if (!json.is_object() || !json.value("version", Json()).is_string() ||
    !json.value("frames", Json()).is_number_unsigned() || json["frames"] > 100000000 ||
    !json.value("outputs", Json()).is_array() || json["outputs"].empty() ||
    !std::all_of(json["outputs"].begin(), json["outputs"].end(), isOutput) ||
    !json.value("film", Json()).is_string() ||
    (json["film"] != "" &&
      json["film"].get<std::string>() + ".parts" != folder.filename().string()))
  {
    return false;
  }
  const Json size = json.value("size", Json());
  return size.is_array() && size.size() == 2 && size[0].is_number_unsigned() &&
    size[1].is_number_unsigned() && json.value("fps", Json()).is_number();
}
}

//------------------------------------------------------------------------------
FrameParts::FrameParts(const std::string& folder)
  : Folder(folder)
{
}

//------------------------------------------------------------------------------
std::string FrameParts::GetFolder(const scene::RenderOptions& options)
{
  if (!scene::IsSequence(options))
  {
    throw words::UsageError("--part: there is one frame: give --turntable N, --camera-path F or "
                            "--times START:END:STEP as well");
  }
  if (options.Motion.Resume)
  {
    throw words::UsageError("--part and --resume: give one of them; a part draws only the frames "
                            "that are missing or damaged");
  }
  scene::CheckFramesAlone(options, "--part");
  const std::vector<std::string> outputs = GetOutputs(options);
  const std::string& film = options.Motion.Video;
  if (outputs.empty() || (!film.empty() && options.PNG.empty()))
  {
    throw words::UsageError(
      "--part: frames are kept in files, of which merge makes a film: give --png F as well");
  }
  static const std::regex number("%[0-9]*d");
  const std::string folder =
    (film.empty() ? std::regex_replace(outputs.front(), number, "") : film) + ".parts";
  const fs::path base = fs::absolute(folder).lexically_normal().parent_path();
  for (const std::string& output : outputs)
  {
    if (!IsBelow(fs::absolute(output).lexically_normal().lexically_relative(base)))
    {
      throw words::UsageError("--part: got the output " + output + ", expected one in " +
        base.string() + " or below, where the parts are");
    }
  }
  return folder;
}

//------------------------------------------------------------------------------
std::string FrameParts::GetBase() const
{
  const fs::path base = fs::path(this->Folder).parent_path();
  return base.empty() ? "." : base.string();
}

//------------------------------------------------------------------------------
std::string FrameParts::GetRecord(int frame) const
{
  return this->Folder + "/frame-" + dataset::WriteDatasetNumber(static_cast<std::size_t>(frame)) +
    ".json";
}

//------------------------------------------------------------------------------
std::vector<int> FrameParts::Begin(const std::string& words, const scene::RenderOptions& options,
  const std::vector<std::string>& inputs, const dataset::WorkPart& part)
{
  const fs::path base = fs::absolute(this->GetBase()).lexically_normal();
  const auto relate = [&base](const std::string& name) {
    return fs::absolute(name).lexically_normal().lexically_relative(base).string();
  };
  Json outputs = Json::array();
  for (const std::string& output : GetOutputs(options))
  {
    outputs.push_back(relate(output));
  }
  dataset::FileHash files;
  for (const std::string& input : inputs)
  {
    const std::string hash = dataset::FileHash::OfFile(input);
    files.Add(hash.data(), hash.size());
  }
  const int frames = scene::CountFrames(options);
  const std::string& film = options.Motion.Video;
  this->Read = { { "version", RELIEVO_VERSION }, { "words", words }, { "preset", options.Preset },
    { "files", files.Finish() }, { "frames", static_cast<unsigned>(frames) },
    { "outputs", outputs }, { "film", film.empty() ? "" : relate(film) },
    { "size", { static_cast<unsigned>(options.Size[0]), static_cast<unsigned>(options.Size[1]) } },
    { "fps", options.Motion.FramesPerSecond } };
  this->Hash = dataset::OpenWorkFolder(this->Folder, Settings, this->Read);
  std::vector<int> left;
  dataset::WorkState state;
  const auto range = part.GetRange(frames);
  for (auto frame = static_cast<int>(range[0]); frame < static_cast<int>(range[1]); ++frame)
  {
    if (!this->CheckFrame(frame, this->Read, this->Hash, dataset::WorkCheck::Files, state))
    {
      left.push_back(frame);
    }
  }
  this->All = static_cast<double>(range[1] - range[0]);
  this->Before = this->All - static_cast<double>(left.size());
  this->Done = this->Before;
  this->Shown = std::make_unique<dataset::PartProgress>(this->Folder, part, "frames");
  this->Shown->Update(this->Done, this->All, this->Before);
  return left;
}

//------------------------------------------------------------------------------
void FrameParts::Keep(int frame)
{
  Json record = { { "frame", frame }, { "version", RELIEVO_VERSION }, { "settings", this->Hash },
    { "files", Json::object() } };
  for (const Json& output : this->Read["outputs"])
  {
    const std::string name = scene::GetFrameName(output, frame);
    record["files"][name] = dataset::FileHash::OfFile(this->GetBase() + "/" + name);
  }
  dataset::CheckSettings(this->Folder, Settings, this->Hash);
  dataset::WriteWhole(this->GetRecord(frame), dataset::WriteDatasetJson(record));
  this->Shown->Update(++this->Done, this->All, this->Before);
}

//------------------------------------------------------------------------------
// Whether a frame is complete; otherwise adds it to the state. `hash`: of the settings.
bool FrameParts::CheckFrame(int frame, const Json& settings, const std::string& hash,
  dataset::WorkCheck check, dataset::WorkState& state) const
{
  const std::string name = std::to_string(frame);
  const std::string file = this->GetRecord(frame);
  std::error_code trouble;
  if (!fs::exists(file, trouble))
  {
    state.Missing.push_back(name);
    return false;
  }
  const Json record = Json::parse(dataset::ReadWhole(file), nullptr, false);
  bool isRecord = record.is_object() && record.value("frame", Json()) == frame &&
    record.value("files", Json()).is_object();
  for (const Json& output : settings["outputs"])
  {
    isRecord = isRecord && record["files"].contains(scene::GetFrameName(output, frame));
  }
  const std::string damage = !isRecord   ? "its record"
    : check == dataset::WorkCheck::Files ? dataset::FindDamage(this->GetBase(), record)
                                         : "";
  if (!damage.empty())
  {
    state.Damaged.push_back(name + " (" + damage + ")");
    return false;
  }
  if (record.value("version", Json()) != settings["version"] ||
    record.value("settings", Json()) != hash)
  {
    state.Foreign.push_back(name);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
dataset::WorkState FrameParts::Verify(dataset::WorkCheck check) const
{
  const std::string path = this->Folder + "/" + Settings;
  const Json settings = dataset::ReadWorkJson(path);
  if (!IsSettings(settings, this->Folder))
  {
    throw words::FileError(path + ": does not describe frames");
  }
  const std::string hash = dataset::FileHash::OfFile(path);
  dataset::WorkState state;
  state.Items = "frames";
  state.All = settings["frames"].get<std::size_t>();
  for (int frame = 0; frame < static_cast<int>(state.All); ++frame)
  {
    this->CheckFrame(frame, settings, hash, check, state);
  }
  const std::string film = settings["film"];
  if (check == dataset::WorkCheck::Records || film.empty())
  {
    return state;
  }
  const std::string file = this->GetBase() + "/" + film;
  const std::string merged = this->Folder + "/" + MergedFilm;
  std::error_code trouble;
  const bool exists = fs::exists(file, trouble);
  if (!exists || !fs::exists(merged, trouble) ||
    Json::parse(dataset::ReadWhole(merged), nullptr, false) !=
      Json({ { "hash", dataset::FileHash::OfFile(file) } }))
  {
    state.Result = file + (exists ? " is not that of these frames" : " is missing") +
      ": relievo merge " + this->Folder + " makes it";
  }
  return state;
}

//------------------------------------------------------------------------------
std::string FrameParts::Merge() const
{
  dataset::WorkState state = this->Verify(dataset::WorkCheck::Files);
  state.Result.clear();
  if (!state.IsWhole())
  {
    throw words::WorkError(
      state.GetText(this->Folder) + "run the parts that draw these frames, then merge");
  }
  const Json settings = dataset::ReadWorkJson(this->Folder + "/" + Settings);
  const std::string film = settings["film"];
  std::string text = this->Folder + ": all " + std::to_string(state.All) + " frames are there";
  if (!film.empty())
  {
    const std::string file = this->GetBase() + "/" + film;
    if (!scene::VideoFile::HasProgram())
    {
      throw words::WorkError(
        file + ": the program ffmpeg, which makes films, is not installed; install it, then merge");
    }
    std::vector<std::string> pictures;
    for (int frame = 0; frame < static_cast<int>(state.All); ++frame)
    {
      pictures.push_back(
        this->GetBase() + "/" + scene::GetFrameName(settings["outputs"].front(), frame));
    }
    scene::WriteFilm(file, pictures,
      { settings["size"][0].get<int>(), settings["size"][1].get<int>() },
      settings["fps"].get<double>());
    dataset::WriteWhole(this->Folder + "/" + MergedFilm,
      dataset::WriteDatasetJson({ { "hash", dataset::FileHash::OfFile(file) } }));
    text = file + ": made of " + std::to_string(state.All) + " frames";
  }
  dataset::PartProgress::Remove(this->Folder);
  dataset::RemoveTemporaryFiles(this->Folder);
  return text;
}
}
