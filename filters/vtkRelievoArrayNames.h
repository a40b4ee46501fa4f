// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoArrayNames.h
 * @brief Lists the names of existing arrays, for messages of filters.
 */
#ifndef vtkRelievoArrayNames_h
#define vtkRelievoArrayNames_h

#include "vtkFieldData.h"

#include <string>

namespace relievo
{
/// "depth, id, (unnamed)", or "none".
inline std::string ArrayNames(vtkFieldData* fields)
{
  std::string names;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    const char* name = fields->GetArrayName(i);
    names += (i ? ", " : "") + std::string(name ? name : "(unnamed)");
  }
  return names.empty() ? "none" : names;
}
}

#endif
