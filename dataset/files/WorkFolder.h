// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A folder in which several processes, or one that was interrupted, do one piece of work: its
 * settings, the progress of its parts, and its complete items.
 */
#ifndef WorkFolder_h
#define WorkFolder_h

#include "DatasetNames.h"
#include "WorkPart.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace dataset
{
/// Begins a folder, made if missing, by writing its settings to a file in it. Throws UsageError
/// unless it is empty or was begun with these settings. A folder with nothing but settings, left by
/// a refused or interrupted call, is begun anew. Returns the hash of the settings, which records
/// contain.
std::string OpenWorkFolder(
  const std::string& folder, const std::string& file, const nlohmann::ordered_json& settings);

/// Throws WorkError if another call has begun the folder anew since OpenWorkFolder().
void CheckSettings(const std::string& folder, const std::string& file, const std::string& hash);

/// Parses a JSON file. Throws FileError.
nlohmann::ordered_json ReadWorkJson(const std::string& path);

/// Finds a file of a record ("files": hashes by path in the folder) that has changed since it was
/// written. Returns its name; empty: none has.
std::string FindDamage(const std::string& folder, const nlohmann::ordered_json& record);

/// Whether to read all files, or only the records.
enum class WorkCheck
{
  Files,
  Records
};

/// The complete and the missing items of a folder.
struct WorkState
{
  std::string Items;                ///< their name, in the plural: "views", "parts"
  std::size_t All = 0;              ///< number of items
  std::vector<std::string> Missing; ///< items without a record
  std::vector<std::string> Damaged; ///< items with a damaged file, each with its name
  std::vector<std::string> Foreign; ///< items by another version or with other settings
  std::string Result;               ///< fault of the merged files; empty: none

  bool IsWhole() const;
  /// A line for each kind of items.
  std::string GetText(const std::string& folder) const;
};

/// Removes the temporary files of parts that were killed while they wrote. All parts must be
/// complete.
void RemoveTemporaryFiles(const std::string& folder);

/// How far a part is, in a file of the folder, for `relievo status`. It is written at most every
/// two seconds; a problem with it does not end the work.
class PartProgress
{
public:
  PartProgress(const std::string& folder, const WorkPart& part, const std::string& items);

  /// `done` of `all` items, of which `before` were there at the start.
  void Update(double done, double all, double before = 0.0);

  /// Lines about all parts in the folder; empty if there are none.
  static std::string GetText(const std::string& folder);

  /// Removes the files about progress.
  static void Remove(const std::string& folder);

private:
  using Clock = std::chrono::steady_clock;
  std::string Folder, Items;
  WorkPart Part;
  Clock::time_point Began = Clock::now(), Written = Clock::time_point::min();
};
}

#endif
