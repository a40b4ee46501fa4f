// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Unique names of animations, by which users choose one. */
#ifndef vtkRelievoModelNames_h
#define vtkRelievoModelNames_h

#include "vtkRelievoModel.h"

#include <algorithm>
#include <string>
#include <vector>

namespace relievo
{
/// The wanted name, "animation" if empty, with a number if it is already used.
inline std::string GetFreeName(const std::string& wanted, const std::vector<ModelAnimation>& taken)
{
  const auto isTaken = [&taken](const std::string& name) {
    return std::any_of(taken.begin(), taken.end(),
      [&name](const ModelAnimation& other) { return other.Name == name; });
  };
  const std::string plain = wanted.empty() ? "animation" : wanted;
  std::string name = plain;
  for (int i = 2; isTaken(name); ++i)
  {
    name = plain + " " + std::to_string(i);
  }
  return name;
}
}

#endif
