// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The outcome of work, for VTK classes, which throw no exceptions.
 */
#ifndef Outcome_h
#define Outcome_h

#include "ReadingNames.h"

#include <functional>
#include <string>

namespace reading
{
struct Outcome
{
  /// Values of vtkRelievoScene::Failures.
  enum Kinds
  {
    Done = 0,
    Usage = 1,
    File = 2,
    Draw = 3
  };
  int Kind = Done;
  std::string Text; ///< the error message
};

/// Does the work while collecting VTK's messages, with a decimal point in numbers.
Outcome Try(const std::function<void()>& work);
}

#endif
