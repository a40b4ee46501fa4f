// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShaderLibrary.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoShaderTable.h"

#include <map>
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

const char* FindQuietly(const std::string& name)
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

const char* Find(const std::string& name)
{
  if (const char* text = FindQuietly(name))
  {
    return text;
  }
  vtkGenericWarningMacro("No GLSL source named '" << name << "' is embedded in Relievo.");
  return nullptr;
}

bool Append(const std::string& name, std::set<std::string>& seen, std::ostream& out)
{
  if (!seen.insert(name).second)
  {
    return true;
  }
  const char* text = Find(name);
  if (!text)
  {
    return false;
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
    if (!Append(line.substr(from, line.find(')', from) - from), seen, out))
    {
      return false;
    }
  }
  return true;
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
  std::ostringstream out;
  std::set<std::string> seen;
  return Append(name, seen, out) ? out.str() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShaderLibrary::GetSection(const std::string& name, const std::string& section)
{
  const std::string source = Get(name);
  static const std::string directive = "//RELIEVO::Section(";
  const std::string opening = directive + section + ")\n";
  std::size_t from = source.find(opening);
  if (from == std::string::npos)
  {
    vtkGenericWarningMacro(
      "The GLSL source '" << name << "' has no section named '" << section << "'.");
    return std::string();
  }
  from += opening.size();
  const std::size_t to = source.find(directive, from);
  return source.substr(from, to == std::string::npos ? to : to - from);
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
  if (FindQuietly(name))
  {
    vtkGenericWarningMacro(
      "A GLSL source named '" << name << "' exists already; choose another name.");
    return false;
  }
  GetAdded()[name] = text;
  return true;
}
