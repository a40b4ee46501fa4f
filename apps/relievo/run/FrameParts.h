// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frames of a sequence, drawn by several processes: a folder beside the frames' files with
 * frames.json, the settings, and for each frame a record, which is written after its files.
 */
#ifndef FrameParts_h
#define FrameParts_h

#include "WorkFolder.h"

#include <memory>
#include <string>
#include <vector>

namespace scene
{
struct RenderOptions;
}

namespace cli
{
class FrameParts
{
public:
  explicit FrameParts(const std::string& folder);

  /// The folder of a sequence's parts: that of its film, or of its first output without the number:
  /// "turn.mp4.parts", "frames/turn_.png.parts". Throws UsageError if one process draws one frame,
  /// or a frame needs the frames before it, or a file would be in another folder.
  static std::string GetFolder(const scene::RenderOptions& options);

  /// Begins a part, in a folder that is new or was begun with these words and the contents of these
  /// files; otherwise throws UsageError. Returns the part's missing and damaged frames.
  std::vector<int> Begin(const std::string& words, const scene::RenderOptions& options,
    const std::vector<std::string>& inputs, const dataset::WorkPart& part);

  /// Writes the record of a frame, whose files are complete. Throws FileError.
  void Keep(int frame);

  /// The complete and the missing frames. Throws FileError.
  dataset::WorkState Verify(dataset::WorkCheck check) const;

  /// Makes the film, if the sequence has one, and returns a line for the user. Throws WorkError if
  /// frames are missing or damaged.
  std::string Merge() const;

  /// The file of a folder's settings.
  static constexpr const char* Settings = "frames.json";

private:
  std::string GetBase() const; // the folder to which names of outputs are relative
  std::string GetRecord(int frame) const;
  bool CheckFrame(int frame, const nlohmann::ordered_json& settings, const std::string& hash,
    dataset::WorkCheck check, dataset::WorkState& state) const;

  std::string Folder;
  nlohmann::ordered_json Read; // settings
  std::string Hash;            // of the settings
  std::unique_ptr<dataset::PartProgress> Shown;
  double Done = 0.0, All = 0.0, Before = 0.0; // frames of the part
};
}

#endif
