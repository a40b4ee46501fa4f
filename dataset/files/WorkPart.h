// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One of several equal shares of a piece of work.
 */
#ifndef WorkPart_h
#define WorkPart_h

#include "DatasetNames.h"

#include <array>
#include <cstdint>
#include <string>

namespace dataset
{
struct WorkPart
{
  int Number = 1; ///< from 1 to Count
  int Count = 1;

  /// Parses "K/N", or "slurm", which takes both from the variables of a job array. Throws
  /// UsageError.
  static WorkPart Parse(const std::string& option, const std::string& word);

  /// The share of so many items: first, and one after the last.
  std::array<std::int64_t, 2> GetRange(std::int64_t all) const;

  /// "part 3 of 8".
  std::string GetText() const;

  /// Stem of the part's files: "part-000003".
  std::string GetStem() const;
};
}

#endif
