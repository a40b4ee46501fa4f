// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRFailure.h
 * @brief The exception used inside the EXR reader and writer.
 *
 * It never leaves the two classes: they turn it into one vtkErrorMacro and an error code.
 */
#ifndef vtkRelievoEXRFailure_h
#define vtkRelievoEXRFailure_h

#include <stdexcept>
#include <string>

namespace relievo::exr
{
class Failure : public std::runtime_error
{
public:
  /**
   * `code` is one of vtkErrorCode::ErrorIds; `what` names the problem and a remedy. `system` is the
   * errno of a failed system call, or 0.
   */
  Failure(unsigned long code, const std::string& what, int system = 0)
    : std::runtime_error(what)
    , Code(code)
    , System(system)
  {
  }

  unsigned long Code;
  int System;
};

/** The user asked to stop (AbortExecute): no message, and nothing is left behind. */
class Aborted : public std::exception
{
};

/** A name from a file, safe to show: control characters become '?', long text is cut. */
inline std::string Shown(const std::string& text)
{
  const std::size_t longest = 80;
  std::string shown = text.substr(0, longest);
  for (char& c : shown)
  {
    c = static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  }
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}
}

#endif
