// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCauseList.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace relievo::compare
{
//------------------------------------------------------------------------------
std::string Finding::GetLabel() const
{
  const std::string number = this->Id < 0 ? "" : this->Kind + " " + std::to_string(this->Id);
  if (number.empty())
  {
    return this->Name.empty() ? this->Kind : this->Name;
  }
  return this->Name.empty() || this->Name == number ? number : this->Name + " (" + number + ")";
}

//------------------------------------------------------------------------------
int CauseList::Find(Cause cause, const std::string& kind, const std::string& name, int id)
{
  const std::string key =
    CauseWords[static_cast<std::size_t>(cause)] + std::string("\n") + kind + "\n" + name;
  const auto found = this->Places.find({ key, id });
  if (found != this->Places.end())
  {
    return found->second;
  }
  Finding finding;
  finding.Is = cause;
  finding.Kind = kind;
  finding.Name = name;
  finding.Id = id;
  this->Findings.push_back(finding);
  return this->Places[{ key, id }] = static_cast<int>(this->Findings.size()) - 1;
}

//------------------------------------------------------------------------------
const std::map<std::string, std::string>& GetColors()
{
  static const std::map<std::string, std::string> colors = { { "removed", "#e5484d" },
    { "added", "#2fb56a" }, { "moved", "#f5a00b" }, { "shape", "#a65cf0" },
    { "visibility", "#b8860b" }, { "normal", "#5b9df5" }, { "array", "#12b5a5" },
    { "color", "#f2dc3c" }, { "light", "#ffc9a3" }, { "shadow", "#5f62ea" }, { "lamps", "#ff7f50" },
    { "fog", "#b7c4d6" }, { "ambient", "#9bd52f" }, { "markers", "#d946ef" },
    { "translucent", "#22c7e6" }, { "overlay", "#c4622d" }, { "tone", "#7d8f3c" },
    { "settings", "#a58f7c" }, { "size", "#888888" }, { "camera", "#888888" },
    { "unexplained", "#ff2bb0" }, { "edge", "#7b8798" }, { "rounding", "#5b6472" } };
  return colors;
}

//------------------------------------------------------------------------------
std::string WriteShort(double number)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(3);
  out << number + 0.0; // no -0
  return out.str();
}

//------------------------------------------------------------------------------
std::string WriteVector(const std::array<double, 3>& v)
{
  const double least = 1e-6 * std::hypot(v[0], v[1], v[2]);
  std::string words;
  for (const double each : v)
  {
    words += (words.empty() ? "" : ", ") + WriteShort(std::abs(each) < least ? 0.0 : each);
  }
  return "(" + words + ")";
}

//------------------------------------------------------------------------------
std::string WriteCount(std::size_t count)
{
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3;)
  {
    at -= 3;
    digits.insert(at, " ");
  }
  return digits;
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}
}
