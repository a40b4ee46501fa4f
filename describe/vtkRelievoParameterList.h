// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters by name, of a stage, of points, of a material or of an environment, each described
// once by the class that has it.
#ifndef vtkRelievoParameterList_h
#define vtkRelievoParameterList_h

#include "vtkIndent.h"
#include "vtkRelievoDescribeModule.h" // for the export macro

#include <functional>
#include <ostream>
#include <string>
#include <vector>

struct vtkRelievoParameter;

struct VTKRELIEVODESCRIBE_EXPORT vtkRelievoParameterList
{
  ///@{
  // Not in this header, which most files include: there vtkRelievoParameter is incomplete.
  vtkRelievoParameterList();
  ~vtkRelievoParameterList();
  vtkRelievoParameterList(const vtkRelievoParameterList&);
  vtkRelievoParameterList(vtkRelievoParameterList&&) noexcept;
  vtkRelievoParameterList& operator=(const vtkRelievoParameterList&);
  vtkRelievoParameterList& operator=(vtkRelievoParameterList&&) noexcept;
  ///@}

  std::vector<vtkRelievoParameter> Parameters;

  const vtkRelievoParameter* Find(const std::string& parameter) const;

  ///@{
  // For scripts: the number of parameters, and the name, help with valid values, default, value in
  // words and OnlyIf of each. "" for an unknown one.
  int GetNumber() const;
  std::string GetName(int i) const;
  std::string GetHelp(const std::string& parameter) const;
  std::string GetDefault(const std::string& parameter) const;
  std::string GetValue(const std::string& parameter) const;
  std::string GetCondition(const std::string& parameter) const;
  ///@}

  // The values, a line each, for PrintSelf.
  void Print(std::ostream& os, vtkIndent indent) const;

  // Sets a value from words. Returns an error and sets nothing if they are invalid; otherwise "".
  std::string TrySet(const std::string& parameter, const std::string& words) const;

  // The names, with commas between them.
  std::string GetNames() const;

  // Adds a parameter whose present value is its default.
  vtkRelievoParameter& Add(const vtkRelievoParameter& parameter);

  ///@{
  // Adds a parameter by the member with its value and the function that sets it.
  vtkRelievoParameter& AddFlag(const std::string& name, const bool& value,
    std::function<void(bool)> set, const std::string& help);
  vtkRelievoParameter& AddWhole(const std::string& name, const int& value,
    std::function<void(int)> set, int least, int most, const std::string& unit,
    const std::string& help);
  vtkRelievoParameter& AddWhole(const std::string& name, const long long& value,
    std::function<void(long long)> set, double least, double most, const std::string& unit,
    const std::string& help);
  vtkRelievoParameter& AddNumber(const std::string& name, const double& value,
    std::function<void(double)> set, double least, double most, const std::string& unit,
    const std::string& help);
  vtkRelievoParameter& AddChoice(const std::string& name, const int& value,
    std::function<void(int)> set, const std::vector<std::string>& choices, const std::string& help,
    int first = 0); // the number of the first choice
  vtkRelievoParameter& AddColor(const std::string& name, const double (&value)[3],
    std::function<void(const double*)> set, const std::string& help);
  vtkRelievoParameter& AddPair(const std::string& name, const double (&value)[2],
    std::function<void(const double*)> set, const std::string& help);
  vtkRelievoParameter& AddVector(const std::string& name, const double (&value)[3],
    std::function<void(const double*)> set, const std::string& help);
  vtkRelievoParameter& AddBox(const std::string& name, const double (&value)[6],
    std::function<void(const double*)> set, const std::string& help);
  vtkRelievoParameter& AddSize(const std::string& name, const int (&value)[2],
    std::function<void(const int*)> set, int least, const std::string& help);
  vtkRelievoParameter& AddSize(const std::string& name, const int (&value)[3],
    std::function<void(const int*)> set, int least, const std::string& help);
  vtkRelievoParameter& AddDate(const std::string& name, const int (&value)[3],
    std::function<void(const int*)> set, int least, int most, const std::string& help);
  vtkRelievoParameter& AddText(const std::string& name, std::function<std::string()> get,
    std::function<void(const std::string&)> set, const std::string& help);
  ///@}
};

#endif
