// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters by name, of a stage or of points: each is described once, by the class that has it.
#ifndef vtkRelievoParameterList_h
#define vtkRelievoParameterList_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoParameter.h"

#include <functional>
#include <string>
#include <vector>

struct VTKRELIEVOFRAME_EXPORT vtkRelievoParameterList
{
  std::vector<vtkRelievoParameter> Parameters;

  const vtkRelievoParameter* Find(const std::string& parameter) const;

  // The names, with commas between them.
  std::string GetNames() const;

  // Adds a parameter, whose value now is its default.
  vtkRelievoParameter& Add(const vtkRelievoParameter& parameter);

  ///@{
  // Adds a parameter: the member that holds its value, and the function that sets it.
  void AddFlag(const std::string& name, const bool& value, std::function<void(bool)> set,
    const std::string& help);
  void AddWhole(const std::string& name, const int& value, std::function<void(int)> set, int least,
    int most, const std::string& unit, const std::string& help);
  void AddNumber(const std::string& name, const double& value, std::function<void(double)> set,
    double least, double most, const std::string& unit, const std::string& help);
  void AddChoice(const std::string& name, const int& value, std::function<void(int)> set,
    const std::vector<std::string>& choices, const std::string& help);
  void AddColor(const std::string& name, const double (&value)[3],
    std::function<void(const double*)> set, const std::string& help);
  vtkRelievoParameter& AddVector(const std::string& name, const double (&value)[3],
    std::function<void(const double*)> set, const std::string& help);
  void AddText(const std::string& name, std::function<std::string()> get,
    std::function<void(const std::string&)> set, const std::string& help);
  ///@}
};

#endif
