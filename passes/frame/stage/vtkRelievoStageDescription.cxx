// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoStageDescription.h"

#include <cmath>

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
}

//------------------------------------------------------------------------------
const vtkRelievoParameter* vtkRelievoStageDescription::Find(const std::string& parameter) const
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
const char* vtkRelievoStageDescription::GetSlotName(int slot)
{
  static const char* const names[] = { "light maps", "surfaces", "shade", "composite", "display" };
  return slot >= LIGHT_MAPS && slot <= DISPLAY ? names[slot] : "none";
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddFlag(const std::string& name, const bool& value,
  std::function<void(bool)> set, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::FLAG, 0.0, 1.0, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>{ value ? 1.0 : 0.0 }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v[0] != 0.0); };
  this->Parameters.push_back(parameter);
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddWhole(const std::string& name, const int& value,
  std::function<void(int)> set, int least, int most, const std::string& unit,
  const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::WHOLE, least, most, unit, help);
  parameter.GetValues = [&value]() { return std::vector<double>{ double(value) }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(int(std::lround(v[0]))); };
  this->Parameters.push_back(parameter);
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddNumber(const std::string& name, const double& value,
  std::function<void(double)> set, double least, double most, const std::string& unit,
  const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::NUMBER, least, most, unit, help);
  parameter.GetValues = [&value]() { return std::vector<double>{ value }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v[0]); };
  this->Parameters.push_back(parameter);
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddChoice(const std::string& name, const int& value,
  std::function<void(int)> set, const std::vector<std::string>& choices, const std::string& help)
{
  vtkRelievoParameter parameter =
    Make(name, vtkRelievoParameter::CHOICE, 0.0, double(choices.size()) - 1.0, "", help);
  parameter.Choices = choices;
  parameter.GetValues = [&value]() { return std::vector<double>{ double(value) }; };
  parameter.SetValues = [set](const std::vector<double>& v) { set(int(std::lround(v[0]))); };
  this->Parameters.push_back(parameter);
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddColor(const std::string& name, const double (&value)[3],
  std::function<void(const double*)> set, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::COLOR, 0.0, 1.0, "", help);
  parameter.GetValues = [&value]() { return std::vector<double>(value, value + 3); };
  parameter.SetValues = [set](const std::vector<double>& v) { set(v.data()); };
  this->Parameters.push_back(parameter);
}

//------------------------------------------------------------------------------
void vtkRelievoStageDescription::AddText(const std::string& name, std::function<std::string()> get,
  std::function<void(const std::string&)> set, const std::string& help)
{
  vtkRelievoParameter parameter = Make(name, vtkRelievoParameter::TEXT, 0.0, 0.0, "", help);
  parameter.GetText = std::move(get);
  parameter.SetText = std::move(set);
  this->Parameters.push_back(parameter);
}
