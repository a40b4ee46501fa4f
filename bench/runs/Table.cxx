// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <vtksys/SystemTools.hxx>

#include <cassert>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>

namespace relievoBench
{
namespace
{
std::string Field(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + '"';
}

// The fields of a line; two quotes within quotes mean one.
std::vector<std::string> FieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
    {
      fields.back() += line[++i];
    }
    else if (line[i] == '"')
    {
      quoted = !quoted;
    }
    else if (line[i] == ',' && !quoted)
    {
      fields.emplace_back();
    }
    else
    {
      fields.back() += line[i];
    }
  }
  return fields;
}
}

//------------------------------------------------------------------------------
std::string Number(double value, int digits)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*g", digits, value);
  return text;
}

//------------------------------------------------------------------------------
Table::Table(std::vector<std::string> columns)
{
  this->Rows.push_back(std::move(columns));
}

//------------------------------------------------------------------------------
void Table::AddRow(const std::vector<std::string>& fields)
{
  assert(fields.size() == this->Rows.front().size());
  this->Rows.push_back(fields);
}

//------------------------------------------------------------------------------
bool Table::WriteCsv(const std::string& path) const
{
  std::ofstream file(path, std::ios::binary);
  for (const std::vector<std::string>& row : this->Rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      file << (i ? "," : "") << Field(row[i]);
    }
    file << '\n';
  }
  file.close();
  if (!file)
  {
    std::cerr << "relievo: bench: cannot write " << path << "\n";
  }
  return static_cast<bool>(file);
}

//------------------------------------------------------------------------------
double NumberIn(const CsvRow& row, const std::string& column)
{
  const auto at = row.find(column);
  return at == row.end() || at->second.empty() ? std::numeric_limits<double>::quiet_NaN()
                                               : std::strtod(at->second.c_str(), nullptr);
}

//------------------------------------------------------------------------------
bool ReadRows(const std::string& path, std::vector<std::vector<std::string>>& rows)
{
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line))
  {
    rows.push_back(FieldsOf(line));
    if (rows.back().size() != rows.front().size())
    {
      std::cerr << "relievo: bench: " << path << ", line " << rows.size() << ": "
                << rows.back().size() << " fields, expected " << rows.front().size() << "\n";
      return false;
    }
  }
  if (rows.empty())
  {
    std::cerr << "relievo: bench: cannot read " << path << "\n";
  }
  return !rows.empty();
}

//------------------------------------------------------------------------------
bool ReadCsv(const std::string& path, std::vector<CsvRow>& rows)
{
  std::vector<std::vector<std::string>> read;
  if (!ReadRows(path, read))
  {
    return false;
  }
  for (std::size_t i = 1; i < read.size(); ++i)
  {
    CsvRow& row = rows.emplace_back();
    for (std::size_t column = 0; column < read[i].size(); ++column)
    {
      row[read.front()[column]] = read[i][column];
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool MakeFolder(const std::string& folder)
{
  const bool made = static_cast<bool>(vtksys::SystemTools::MakeDirectory(folder));
  if (!made)
  {
    std::cerr << "relievo: bench: cannot make the folder " << folder << "\n";
  }
  return made;
}
}
