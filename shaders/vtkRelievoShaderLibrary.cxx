// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShaderLibrary.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoShaderTable.h"

#include <map>
#include <mutex>
#include <set>
#include <sstream>

vtkStandardNewMacro(vtkRelievoShaderLibrary);

namespace
{
// Sources added by other libraries, by name.
std::map<std::string, std::string>& GetAdded()
{
  static std::map<std::string, std::string> added;
  return added;
}

const char* Find(const std::string& name)
{
  for (const vtkRelievoShaderTableEntry* entry = vtkRelievoShaderTable; entry->Name; ++entry)
  {
    if (name == entry->Name)
    {
      return entry->Text;
    }
  }
  const auto added = GetAdded().find(name);
  return added == GetAdded().end() ? nullptr : added->second.c_str();
}

// Returns the name of a source that is not embedded; empty if none is missing.
std::string Append(const std::string& name, std::set<std::string>& seen, std::ostream& out)
{
  if (!seen.insert(name).second)
  {
    return {};
  }
  const char* text = Find(name);
  if (!text)
  {
    return name;
  }
  static const std::string directive = "//RELIEVO::Include(";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t at = line.find(directive);
    if (at == std::string::npos)
    {
      out << line << '\n';
      continue;
    }
    const std::size_t from = at + directive.size();
    const std::string missing = Append(line.substr(from, line.find(')', from) - from), seen, out);
    if (!missing.empty())
    {
      return missing;
    }
  }
  return {};
}

// A source with its includes, and its sections that have been asked for. Neither changes once it is
// known: a name is added once. The shaders of every actor ask for the same ones.
struct Source
{
  std::string Text;
  std::map<std::string, std::string> Sections;
};

std::mutex& GetMutex()
{
  static std::mutex mutex;
  return mutex;
}

// Null if the source, or one that it includes, is missing. Needs the mutex.
Source* Compose(const std::string& name, std::string& missing)
{
  static std::map<std::string, Source> known;
  const auto found = known.find(name);
  if (found != known.end())
  {
    return &found->second;
  }
  std::ostringstream out;
  std::set<std::string> seen;
  missing = Append(name, seen, out);
  if (!missing.empty())
  {
    return nullptr;
  }
  Source& source = known[name];
  source.Text = out.str();
  return &source;
}

// Null if the source has no such section. Needs the mutex.
const std::string* FindSection(Source& source, const std::string& section)
{
  const auto known = source.Sections.find(section);
  if (known != source.Sections.end())
  {
    return &known->second;
  }
  static const std::string directive = "//RELIEVO::Section(";
  const std::string opening = directive + section + ")\n";
  std::size_t from = source.Text.find(opening);
  if (from == std::string::npos)
  {
    return nullptr;
  }
  from += opening.size();
  const std::size_t to = source.Text.find(directive, from);
  std::string& text = source.Sections[section];
  text = source.Text.substr(from, to == std::string::npos ? to : to - from);
  return &text;
}

// The mutex is released before: observers of warnings may use the library.
void WarnOfMissing(const std::string& name)
{
  if (!name.empty())
  {
    vtkGenericWarningMacro("No GLSL source named '" << name << "' is embedded in Relievo.");
  }
}
}

//------------------------------------------------------------------------------
int vtkRelievoShaderLibrary::GetNumberOfSources()
{
  int count = 0;
  while (vtkRelievoShaderTable[count].Name)
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
const char* vtkRelievoShaderLibrary::GetName(int i)
{
  return i >= 0 && i < GetNumberOfSources() ? vtkRelievoShaderTable[i].Name : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShaderLibrary::Get(const std::string& name)
{
  std::string missing;
  {
    const std::lock_guard<std::mutex> lock(GetMutex());
    if (const Source* source = Compose(name, missing))
    {
      return source->Text;
    }
  }
  WarnOfMissing(missing);
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShaderLibrary::GetSection(const std::string& name, const std::string& section)
{
  std::string missing;
  {
    const std::lock_guard<std::mutex> lock(GetMutex());
    Source* const source = Compose(name, missing);
    if (const std::string* text = source ? FindSection(*source, section) : nullptr)
    {
      return *text;
    }
  }
  WarnOfMissing(missing);
  vtkGenericWarningMacro(
    "The GLSL source '" << name << "' has no section named '" << section << "'.");
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoShaderLibrary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSources: " << GetNumberOfSources() << "\n";
}

//------------------------------------------------------------------------------
bool vtkRelievoShaderLibrary::Add(const std::string& name, const std::string& text)
{
  bool added = false;
  {
    const std::lock_guard<std::mutex> lock(GetMutex());
    added = !Find(name) && GetAdded().emplace(name, text).second;
  }
  if (!added)
  {
    vtkGenericWarningMacro(
      "A GLSL source named '" << name << "' exists already; choose another name.");
  }
  return added;
}
