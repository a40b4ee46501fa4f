// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Table.h
 * @brief Rows of measured values, written as CSV and read again.
 */
#ifndef relievoBenchTable_h
#define relievoBenchTable_h

#include <map>
#include <string>
#include <vector>

namespace relievoBench
{
/** A number with the given significant digits, as in CSV files. */
std::string Number(double value, int digits = 4);

/** Rows with named columns. */
class Table
{
public:
  explicit Table(std::vector<std::string> columns);

  /** Adds a row; it must have one field per column. */
  void AddRow(const std::vector<std::string>& fields);

  /**
   * Writes comma-separated values; fields with commas or quotes are quoted. False, with a message
   * on the standard error, if the file cannot be written.
   */
  bool WriteCsv(const std::string& path) const;

private:
  std::vector<std::vector<std::string>> Rows;
};

/** A row of a file: fields by column. */
using CsvRow = std::map<std::string, std::string>;

/** The number in a field; NaN if the field is empty or there is no such column. */
double NumberIn(const CsvRow& row, const std::string& column);

/**
 * Reads a file of Table. False, with a message on the standard error, if it is missing or a line
 * does not have one field per column.
 */
bool ReadCsv(const std::string& path, std::vector<CsvRow>& rows);

/** The table as rows of fields; the first row names the columns. */
bool ReadRows(const std::string& path, std::vector<std::vector<std::string>>& rows);

/** Makes the folder and its parents; false, with a message on the standard error, on failure. */
bool MakeFolder(const std::string& folder);
}

#endif
