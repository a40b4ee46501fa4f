// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParameterList.h"

#include "vtkRelievoParameter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
vtkRelievoParameter Make(const std::string& name, vtkRelievoParameter::Types type, double least,
  double most, const std::string& unit, const std::string& help)
{
  vtkRelievoParameter parameter;
  parameter.Name = name;
  parameter.Type = type;
  parameter.Least = least;
  parameter.Most = most;
  parameter.Unit = unit;
  parameter.Help = help;
  return parameter;
}

template <int N>
void SetWholes(
  vtkRelievoParameter& parameter, const int (&value)[N], const std::function<void(const int*)>& set)
{
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + N); };
  parameter.SetValues = [set](const std::vector<double>& given) {
    int numbers[N];
    std::transform(given.begin(), given.end(), numbers,
      [](double number) { return static_cast<int>(std::lround(number)); });
    set(numbers);
  };
}
}

//------------------------------------------------------------------------------
vtkRelievoParameterList::vtkRelievoParameterList() = default;
vtkRelievoParameterList::~vtkRelievoParameterList() = default;
vtkRelievoParameterList::vtkRelievoParameterList(const vtkRelievoParameterList&) = default;
vtkRelievoParameterList::vtkRelievoParameterList(vtkRelievoParameterList&&) noexcept = default;
vtkRelievoParameterList& vtkRelievoParameterList::operator=(
  const vtkRelievoParameterList&) = default;
vtkRelievoParameterList& vtkRelievoParameterList::operator=(
  vtkRelievoParameterList&&) noexcept = default;

//------------------------------------------------------------------------------
int vtkRelievoParameterList::GetNumber() const
{
  return static_cast<int>(this->Parameters.size());
}

//------------------------------------------------------------------------------
const vtkRelievoParameter* vtkRelievoParameterList::Find(const std::string& parameter) const
{
  for (const vtkRelievoParameter& each : this->Parameters)
  {
    if (each.Name == parameter)
    {
      return &each;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetNames() const
{
  std::string names;
  for (const vtkRelievoParameter& each : this->Parameters)
  {
    names += (names.empty() ? "" : ", ") + each.Name;
  }
  return names;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetName(int i) const
{
  return i >= 0 && i < this->GetNumber() ? this->Parameters[i].Name : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetHelp(const std::string& parameter) const
{
  const vtkRelievoParameter* found = this->Find(parameter);
  return found ? found->Help + " Takes " + found->GetExpected() + "." : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetDefault(const std::string& parameter) const
{
  const vtkRelievoParameter* found = this->Find(parameter);
  return found ? found->Default : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetValue(const std::string& parameter) const
{
  const vtkRelievoParameter* found = this->Find(parameter);
  return found ? found->Format() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::GetCondition(const std::string& parameter) const
{
  const vtkRelievoParameter* found = this->Find(parameter);
  return found ? found->OnlyIf : std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoParameterList::Print(std::ostream& os, vtkIndent indent) const
{
  for (const vtkRelievoParameter& parameter : this->Parameters)
  {
    os << indent << vtkRelievoCapitalize(parameter.Name, true) << ": " << parameter.Format()
       << "\n";
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameterList::TrySet(
  const std::string& parameter, const std::string& words) const
{
  const vtkRelievoParameter* found = this->Find(parameter);
  return found ? found->Parse(words)
               : "'" + parameter + "' was given, expected one of " + this->GetNames();
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::Add(const vtkRelievoParameter& parameter)
{
  this->Parameters.push_back(parameter);
  this->Parameters.back().Default = parameter.Format();
  return this->Parameters.back();
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddFlag(const std::string& name, const bool& value,
  std::function<void(bool)> set, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::FLAG, 0.0, 1.0, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>{ value ? 1.0 : 0.0 }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v[0] != 0.0); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddWhole(const std::string& name, const int& value,
  std::function<void(int)> set, int least, int most, const std::string& unit,
  const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::WHOLE, least, most, unit, help);
  parameter.GetValues = [&value]() { return std::vector<double>{ double(value) }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(int(std::lround(v[0]))); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddWhole(const std::string& name,
  const long long& value, std::function<void(long long)> set, double least, double most,
  const std::string& unit, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::WHOLE, least, most, unit, help);
  parameter.GetValues = [&value]() { return std::vector<double>{ double(value) }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(std::llround(v[0])); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddNumber(const std::string& name,
  const double& value, std::function<void(double)> set, double least, double most,
  const std::string& unit, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::NUMBER, least, most, unit, help);
  parameter.GetValues = [&value]() { return std::vector<double>{ value }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v[0]); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddChoice(const std::string& name, const int& value,
  std::function<void(int)> set, const std::vector<std::string>& choices, const std::string& help,
  int first)
{
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::CHOICE, 0.0, double(choices.size()) - 1.0, "", help);
  parameter.Choices = choices;
  parameter.FirstChoice = first;
  parameter.GetValues = [&value, first]() { return std::vector<double>{ double(value - first) }; };
  parameter.SetValues = [set, first](const std::vector<double>& v) {
    constexpr double most = std::numeric_limits<int>::max();
    set(static_cast<int>(std::min(std::round(v[0]) + first, most)));
  };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddColor(const std::string& name,
  const double (&value)[3], std::function<void(const double*)> set, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::COLOR, 0.0, 1.0, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + 3); };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v.data()); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddPair(const std::string& name,
  const double (&value)[2], std::function<void(const double*)> set, const std::string& help)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::PAIR, -infinity, infinity, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + 2); };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v.data()); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddVector(const std::string& name,
  const double (&value)[3], std::function<void(const double*)> set, const std::string& help)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::VECTOR, -infinity, infinity, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + 3); };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v.data()); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddBox(const std::string& name,
  const double (&value)[6], std::function<void(const double*)> set, const std::string& help)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::BOX, -infinity, infinity, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + 6); };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v.data()); };
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddSize(const std::string& name,
  const int (&value)[2], std::function<void(const int*)> set, int least, const std::string& help)
{
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::SIZE, least, std::numeric_limits<int>::max(), "", help);
  SetWholes(parameter, value, set);
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddSize(const std::string& name,
  const int (&value)[3], std::function<void(const int*)> set, int least, const std::string& help)
{
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::SIZE, least, std::numeric_limits<int>::max(), "", help);
  SetWholes(parameter, value, set);
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddDate(const std::string& name,
  const int (&value)[3], std::function<void(const int*)> set, int least, int most,
  const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::DATE, least, most, "", help);
  SetWholes(parameter, value, set);
  return this->Add(parameter);
}

//------------------------------------------------------------------------------
vtkRelievoParameter& vtkRelievoParameterList::AddText(const std::string& name,
  std::function<std::string()> get, std::function<void(const std::string&)> set,
  const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::TEXT, 0.0, 0.0, "", help);
  parameter.GetText = std::move(get);
  parameter.SetText = std::move(set);
  return this->Add(parameter);
}
