// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <vtksys/SystemTools.hxx>

#include <cassert>
#include <cstdio>
#include <fstream>
#include <iostream>

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
    std::cerr << "bench: cannot write " << path << "\n";
  }
  return static_cast<bool>(file);
}

//------------------------------------------------------------------------------
bool MakeFolder(const std::string& folder)
{
  const bool made = static_cast<bool>(vtksys::SystemTools::MakeDirectory(folder));
  if (!made)
  {
    std::cerr << "bench: cannot make the folder " << folder << "\n";
  }
  return made;
}
}
