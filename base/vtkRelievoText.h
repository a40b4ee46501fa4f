// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Type of text arguments of wrapped methods: a std::string in C++, a `const char*` for VTK's
 * wrapping. VTK's wrapping ends the program if Python passes text that is not Unicode, such as a
 * lone surrogate, for a std::string; for a `const char*` it raises an error. None is the empty
 * text.
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
