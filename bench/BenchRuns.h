// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchRuns.h
 * @brief Several benches, each in a process of its own: one that fails or crashes stops no other.
 */
#ifndef relievoBenchRuns_h
#define relievoBenchRuns_h

#include <string>
#include <vector>

namespace relievoBench
{
/**
 * Runs `program bench NAME --out FOLDER` for each name, with what it says in FOLDER/logs/NAME.txt,
 * and writes FOLDER/benches.csv and the summary (BenchSummary.h) after each. Benches that
 * benches.csv says are done are not run again; those done quickly are, unless `quick` asks for that
 * again (`bench --quick`). Returns 0; 1 if one has failed; 2, before anything is run, if `beside`
 * has no tables or benches.csv is none of ours.
 */
int RunBenches(const std::string& program, const std::vector<std::string>& names,
  const std::string& folder, const std::string& beside, std::vector<std::string> machine,
  bool quick = false);
}

#endif
