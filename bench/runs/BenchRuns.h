// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchRuns.h
 * @brief Several benches, each in its own process, so that a failure or crash stops no other.
 */
#ifndef relievoBenchRuns_h
#define relievoBenchRuns_h

#include <string>
#include <vector>

namespace relievoBench
{
/**
 * Runs `program bench NAME --out FOLDER` for each name, with its output in FOLDER/logs/NAME.txt,
 * and writes FOLDER/benches.csv and the summary (BenchSummary.h) after each. Benches done according
 * to benches.csv are not run again; those done quickly are, unless `quick` requests that again
 * (`bench --quick`). Returns 0; 1 if a bench has failed; 2, before any run, if `beside` has no
 * tables or benches.csv is another table.
 */
int RunBenches(const std::string& program, const std::vector<std::string>& names,
  const std::string& folder, const std::string& beside, std::vector<std::string> machine,
  bool quick = false);
}

#endif
