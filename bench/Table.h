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
/** A number with the given significant digits, as CSV files hold it. */
std::string Number(double value, int digits = 4);

/** Named columns and rows of as many fields. */
class Table
{
public:
  explicit Table(std::vector<std::string> columns);

  /** Adds a row; it must have one field per column. */
  void AddRow(const std::vector<std::string>& fields);

  /**
   * Writes comma-separated values, fields with commas or quotes quoted. False, with a message on
   * the standard error, when the file cannot be written.
   */
  bool WriteCsv(const std::string& path) const;

private:
  std::vector<std::vector<std::string>> Rows;
};

/** A row of a file: fields by their columns. */
using CsvRow = std::map<std::string, std::string>;

/** The number in a field; NaN, if it is empty or there is no such column. */
double NumberIn(const CsvRow& row, const std::string& column);

/**
 * Reads what Table wrote. False, with a message on the standard error, when there is no such file
 * or a line has not as many fields as there are columns.
 */
bool ReadCsv(const std::string& path, std::vector<CsvRow>& rows);

/** The table as rows of fields, the first of which are the columns. */
bool ReadRows(const std::string& path, std::vector<std::vector<std::string>>& rows);

/** Makes the folder and its parents; false, with a message on the standard error, on failure. */
bool MakeFolder(const std::string& folder);
}

#endif
