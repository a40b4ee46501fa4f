// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorWords.h"

#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <string>

namespace relievo
{
//------------------------------------------------------------------------------
bool ReadColor(const std::string& word, double color[3])
{
  if (word.size() == 7 && word[0] == '#' &&
    word.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      color[i] = std::stoi(word.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    }
    return true;
  }
  vtkNew<vtkNamedColors> names;
  if (!names->ColorExists(word))
  {
    return false;
  }
  names->GetColorRGB(word, color);
  return true;
}
}
