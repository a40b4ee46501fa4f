// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Text that wrapped methods are given: a std::string to C++, a `const char*` to VTK's wrapping.
 * VTK's wrapping ends the program where Python gives a std::string text that is not Unicode, such
 * as a lone surrogate; for a `const char*` it raises. None is the empty text.
 */
#ifndef vtkRelievoText_h
#define vtkRelievoText_h

#ifdef __VTK_WRAP__

#define RELIEVO_TEXT const char*

#else

#include <string>

class vtkRelievoText : public std::string
{
public:
  vtkRelievoText() = default;
  vtkRelievoText(const char* text)
    : std::string(text ? text : "")
  {
  }
  vtkRelievoText(const std::string& text)
    : std::string(text)
  {
  }
};

#define RELIEVO_TEXT const vtkRelievoText&

#endif
#endif
