// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CsvFile.h
 * @brief Reads the CSV files of the benches.
 */
#ifndef relievoTestCsvFile_h
#define relievoTestCsvFile_h

#include "Check.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace relievoTest
{
/** The fields of a line by column. */
using Row = std::map<std::string, std::string>;

/** The fields of a line; quoted fields may contain commas. */
inline std::vector<std::string> Split(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (char c : line)
  {
    if (c == '"')
    {
      quoted = !quoted;
    }
    else if (c == ',' && !quoted)
    {
      fields.emplace_back();
    }
    else
    {
      fields.back() += c;
    }
  }
  return fields;
}

/** The rows of a file; none if it cannot be read. Fails at a line of the wrong length. */
inline std::vector<Row> ReadCsv(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = Split(line);
  std::vector<Row> rows;
  while (std::getline(file, line))
  {
    const std::vector<std::string> fields = Split(line);
    if (!RELIEVO_CHECK(fields.size() == columns.size()))
    {
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      rows.back()[columns[i]] = fields[i];
    }
  }
  return rows;
}

/** A field as a number; NaN if there is no such column. */
inline double Value(const Row& row, const std::string& column)
{
  const auto at = row.find(column);
  return at == row.end() ? std::strtod("nan", nullptr) : std::strtod(at->second.c_str(), nullptr);
}
}

#endif
