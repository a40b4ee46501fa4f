// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Methods for scripts in a class that describes its parameters in the member Parameters. The class
// must include vtkRelievoText.h as well. vtkRelievoMember expands to a member and its Set method,
// for Add....
#ifndef vtkRelievoParametersMacro_h
#define vtkRelievoParametersMacro_h

#include "vtkRelievoParameterList.h"

#define vtkRelievoMember(Name) this->Name, [this](auto value) { this->Set##Name(value); }

#define vtkRelievoParametersMacro()                                                                \
  int GetNumberOfParameters()                                                                      \
  {                                                                                                \
    return this->Parameters.GetNumber();                                                           \
  }                                                                                                \
  std::string GetParameterName(int i)                                                              \
  {                                                                                                \
    return this->Parameters.GetName(i);                                                            \
  }                                                                                                \
  std::string GetParameterHelp(RELIEVO_TEXT name)                                                  \
  {                                                                                                \
    return this->Parameters.GetHelp(name);                                                         \
  }                                                                                                \
  std::string GetParameterDefault(RELIEVO_TEXT name)                                               \
  {                                                                                                \
    return this->Parameters.GetDefault(name);                                                      \
  }                                                                                                \
  std::string GetParameter(RELIEVO_TEXT name)                                                      \
  {                                                                                                \
    return this->Parameters.GetValue(name);                                                        \
  }                                                                                                \
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)                               \
  {                                                                                                \
    return this->Parameters.TrySet(name, words);                                                   \
  }                                                                                                \
  const vtkRelievoParameterList& GetParameters() const                                             \
  {                                                                                                \
    return this->Parameters;                                                                       \
  }

#endif
