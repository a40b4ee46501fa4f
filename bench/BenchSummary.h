// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchSummary.h
 * @brief What several benches measured on one machine, beside the tables of another.
 */
#ifndef relievoBenchSummary_h
#define relievoBenchSummary_h

#include <string>
#include <vector>

namespace relievoBench
{
/** How a bench ended: "done", or what went wrong. */
struct BenchRun
{
  std::string Name;
  std::string Status;
  double Seconds = 0.;
};

/** A column of a table that is not the same in both folders. */
struct ColumnComparison
{
  std::string File, Column;
  bool IsTime = false;          ///< by the column's name: ms, ns, seconds
  std::size_t Rows = 0;         ///< in which both have a number above 0
  double Here = 0., There = 0.; ///< geometric means over these rows
  double Least = 0., Most = 0.; ///< of there / here
};

/** Whether the folder has a table (CSV) to compare with. */
bool HasTables(const std::string& folder);

/**
 * Compares the tables (CSV) that both folders have, row by row, where both have the same columns,
 * and in the same rows the same texts and the same keys: the first columns by which all rows
 * differ. Loads and half widths of intervals are left out, and columns that are equal. Files that
 * cannot be compared are named in `differing`.
 */
std::vector<ColumnComparison> CompareTables(
  const std::string& here, const std::string& there, std::vector<std::string>& differing);

/**
 * Writes summary.md and summary.csv into the folder `here`. machine: lines that say what was
 * measured on. there: the other folder; empty: none. False, with a message on the standard error,
 * when they cannot be written.
 */
bool WriteSummary(const std::string& here, const std::string& there,
  const std::vector<std::string>& machine, const std::vector<BenchRun>& runs);
}

#endif
