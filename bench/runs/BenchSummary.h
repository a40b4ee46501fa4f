// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchSummary.h
 * @brief Compares several benches on one machine with the tables of another.
 */
#ifndef relievoBenchSummary_h
#define relievoBenchSummary_h

#include <string>
#include <vector>

namespace relievoBench
{
/** The status of a bench: "done", or the failure. */
struct BenchRun
{
  std::string Name;
  std::string Status;
  double Seconds = 0.;
};

/** A column of a table that differs between both folders. */
struct ColumnComparison
{
  std::string File, Column;
  bool IsTime = false;          ///< by the column's name: ms, ns, seconds
  std::size_t Rows = 0;         ///< rows in which both have a number above 0
  double Here = 0., There = 0.; ///< geometric means over these rows
  double Least = 0., Most = 0.; ///< of there / here
};

/** Whether the folder, or one of its rooms, has a table (CSV) to compare with. */
bool HasTables(const std::string& folder);

/**
 * Compares the tables (CSV) of both folders, and of folders in them with the same renderer, row by
 * row, if they have equal columns, and equal texts and keys in each row; keys are the leading
 * columns by which all rows differ. Loads, half widths of intervals and equal columns are left out.
 * Files that cannot be compared are named in `differing`.
 */
std::vector<ColumnComparison> CompareTables(
  const std::string& here, const std::string& there, std::vector<std::string>& differing);

/**
 * Writes summary.md and summary.csv into the folder `here`. machine: lines that describe the
 * machine. there: the other folder; empty: none. False, with a message on the standard error, if
 * they cannot be written.
 */
bool WriteSummary(const std::string& here, const std::string& there,
  const std::vector<std::string>& machine, const std::vector<BenchRun>& runs);
}

#endif
