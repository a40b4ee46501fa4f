// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchOptions_h
#define BenchOptions_h

#include <string>
#include <vector>

namespace cli
{
struct BenchOptions
{
  std::vector<std::string> Names;
  std::string Folder = ".";
  std::string Beside; ///< folder of CSV files that the summary compares with; may be empty
  bool Quick = false; ///< fewer rounds of what is timed
};

/// The words after "bench". Throws scene::UsageError.
BenchOptions ParseBench(const std::vector<std::string>& words);
}

#endif
