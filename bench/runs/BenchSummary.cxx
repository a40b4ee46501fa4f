// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchSummary.h"

#include "Renderer.h"
#include "Table.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace relievoBench
{
namespace
{
constexpr char SummaryCsv[] = "summary.csv";
constexpr char RunsCsv[] = "benches.csv";

// Names and paths of the tables in a folder and in its rooms: folders in it whose tables are of the
// same renderer.
std::map<std::string, std::string> TablesIn(const std::string& folder, bool rooms = true)
{
  vtksys::Directory directory;
  std::map<std::string, std::string> found;
  directory.Load(folder);
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    const std::string path = folder + "/" + name;
    if (vtksys::SystemTools::StringEndsWith(name, ".csv") && name != SummaryCsv && name != RunsCsv)
    {
      found[name] = path;
    }
    else if (rooms && name[0] != '.' && vtksys::SystemTools::FileIsDirectory(path) &&
      ReadRenderer(path) == ReadRenderer(folder))
    {
      found.merge(TablesIn(path, false));
    }
  }
  return found;
}

bool IsNumber(const std::string& text, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

bool Has(const std::string& name, const char* part)
{
  return name.find(part) != std::string::npos;
}

// Names such as "ms", "draw ms", "ms per million blocks", "first frame s", "encode ns"; but not
// "times ...".
bool IsTime(const std::string& column)
{
  const std::string words = " " + column + " ";
  return (Has(words, " ms ") || Has(words, " ns ") || Has(words, " s ") ||
           Has(words, "milliseconds")) &&
    !Has(words, " times ") && !Has(words, "/");
}

bool IsLeftOut(const std::string& column)
{
  return column == "load" || Has(column, "+-");
}

// The number of leading columns that distinguish all rows and are not measured.
std::size_t CountKeys(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::vector<std::string>> keys(rows.size() - 1);
  for (std::size_t column = 0; column < rows.front().size(); ++column)
  {
    if (IsTime(rows.front()[column]) || IsLeftOut(rows.front()[column]))
    {
      return column;
    }
    for (std::size_t row = 1; row < rows.size(); ++row)
    {
      keys[row - 1].push_back(rows[row][column]);
    }
    if (std::set<std::vector<std::string>>(keys.begin(), keys.end()).size() == keys.size())
    {
      return column + 1;
    }
  }
  return rows.front().size();
}

// Whether rows i of both have equal keys and texts.
bool AreAlike(
  const std::vector<std::vector<std::string>>& a, const std::vector<std::vector<std::string>>& b)
{
  if (a.size() != b.size() || a.empty() || a.front() != b.front())
  {
    return false;
  }
  const std::size_t keys = std::max(CountKeys(a), CountKeys(b));
  double number;
  for (std::size_t row = 1; row < a.size(); ++row)
  {
    for (std::size_t column = 0; column < a[row].size(); ++column)
    {
      const bool isText = !a[row][column].empty() && !IsNumber(a[row][column], number);
      if ((column < keys || isText) && a[row][column] != b[row][column])
      {
        return false;
      }
    }
  }
  return true;
}

bool CompareColumn(const std::vector<std::vector<std::string>>& a,
  const std::vector<std::vector<std::string>>& b, std::size_t column, ColumnComparison& result)
{
  bool differs = false;
  double sumA = 0.;
  double sumB = 0.;
  result.Least = std::numeric_limits<double>::infinity();
  for (std::size_t row = 1; row < a.size(); ++row)
  {
    double here = 0.;
    double there = 0.;
    differs = differs || a[row][column] != b[row][column];
    if (IsNumber(a[row][column], here) && IsNumber(b[row][column], there) && here > 0. &&
      there > 0. && std::isfinite(here) && std::isfinite(there))
    {
      ++result.Rows;
      sumA += std::log(here);
      sumB += std::log(there);
      result.Least = std::min(result.Least, there / here);
      result.Most = std::max(result.Most, there / here);
    }
  }
  const double rows = std::max<double>(1., static_cast<double>(result.Rows));
  result.Here = std::exp(sumA / rows);
  result.There = std::exp(sumB / rows);
  return differs && result.Rows > 0;
}

// Escapes a field for a table in Markdown.
std::string Cell(std::string text)
{
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
  {
    text.insert(at, "\\");
  }
  return text;
}

void WriteColumns(std::ostream& out, const std::vector<ColumnComparison>& columns, bool times)
{
  out << "| table | column | rows | here | there | there / here | least | most |\n"
         "|---|---|---|---|---|---|---|---|\n";
  for (const ColumnComparison& each : columns)
  {
    if (each.IsTime == times)
    {
      out << "| " << Cell(each.File) << " | " << Cell(each.Column) << " | " << each.Rows << " | "
          << Number(each.Here, 3) << " | " << Number(each.There, 3) << " | "
          << Number(each.There / each.Here, 3) << " | " << Number(each.Least, 3) << " | "
          << Number(each.Most, 3) << " |\n";
    }
  }
}
}

//------------------------------------------------------------------------------
bool HasTables(const std::string& folder)
{
  return !TablesIn(folder).empty();
}

//------------------------------------------------------------------------------
std::vector<ColumnComparison> CompareTables(
  const std::string& here, const std::string& there, std::vector<std::string>& differing)
{
  std::vector<ColumnComparison> found;
  const std::map<std::string, std::string> others = TablesIn(there);
  for (const auto& [name, path] : TablesIn(here))
  {
    std::vector<std::vector<std::string>> a;
    std::vector<std::vector<std::string>> b;
    const auto other = others.find(name);
    if (other == others.end())
    {
      continue;
    }
    if (!ReadRows(path, a) || !ReadRows(other->second, b) || !AreAlike(a, b))
    {
      differing.push_back(name);
      continue;
    }
    for (std::size_t column = 0; column < a.front().size(); ++column)
    {
      ColumnComparison result;
      result.File = name;
      result.Column = a.front()[column];
      result.IsTime = IsTime(result.Column);
      if (!IsLeftOut(result.Column) && CompareColumn(a, b, column, result))
      {
        found.push_back(result);
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
bool WriteSummary(const std::string& here, const std::string& there,
  const std::vector<std::string>& machine, const std::vector<BenchRun>& runs)
{
  std::vector<std::string> differing;
  std::vector<ColumnComparison> columns;
  if (!there.empty())
  {
    columns = CompareTables(here, there, differing);
  }
  Table table(
    { "table", "column", "time", "rows", "here", "there", "there / here", "least", "most" });
  for (const ColumnComparison& each : columns)
  {
    table.AddRow({ each.File, each.Column, each.IsTime ? "yes" : "no", std::to_string(each.Rows),
      Number(each.Here), Number(each.There), Number(each.There / each.Here), Number(each.Least),
      Number(each.Most) });
  }
  if (!there.empty() && !table.WriteCsv(here + "/" + SummaryCsv))
  {
    return false;
  }
  const std::string path = here + "/summary.md";
  std::ofstream out(path, std::ios::binary);
  out << "# Benches\n\n";
  for (const std::string& line : machine)
  {
    out << "- " << line.substr(std::min(line.find_first_not_of(' '), line.size())) << "\n";
  }
  out << "\n| bench | | seconds |\n|---|---|---|\n";
  for (const BenchRun& run : runs)
  {
    out << "| " << run.Name << " | " << Cell(run.Status) << " | " << Number(run.Seconds, 3)
        << " |\n";
  }
  if (!there.empty())
  {
    out << "\nBeside the tables in `" << there << "`, of " << ReadRenderer(there)
        << ", row by row; *here* and *there* are geometric means of the rows in which both are "
           "above 0, and so is their ratio, with the least and the most of a row.\n\n## Times\n\n"
           "*there / here* is how many times as fast it is here.\n\n";
    WriteColumns(out, columns, true);
    out << "\n## What else differs\n\n";
    WriteColumns(out, columns, false);
    for (const std::string& name : differing)
    {
      out << "\nNot compared, for its rows are of something else: " << name << "\n";
    }
  }
  out.close();
  if (!out)
  {
    std::cerr << "relievo: bench: cannot write " << path << "\n";
  }
  return static_cast<bool>(out);
}
}
