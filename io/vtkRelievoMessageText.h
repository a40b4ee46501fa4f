// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Messages of VTK's objects without their source location.
#ifndef vtkRelievoMessageText_h
#define vtkRelievoMessageText_h

#include <string>

namespace vtkRelievoMessageText
{
// Converts "ERROR: In a.cxx, line 1
// vtkThing (0x1): text
//
// " to "text".
inline std::string OfMessage(std::string text)
{
  const std::string::size_type line = text.find(", line ");
  const std::string::size_type address = text.find("): ", line == std::string::npos ? 0 : line);
  if (line != std::string::npos && address != std::string::npos)
  {
    text.erase(0, address + 3);
  }
  text.erase(text.find_last_not_of(" \n.") + 1);
  return text;
}
}

#endif
