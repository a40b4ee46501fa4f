// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How work ended, for classes of VTK, which throw nothing.
 */
#ifndef Outcome_h
#define Outcome_h

#include <functional>
#include <string>

namespace scene
{
struct Outcome
{
  /// Those of vtkRelievoScene::Failures.
  enum Kinds
  {
    Done = 0,
    Usage = 1,
    File = 2,
    Draw = 3
  };
  int Kind = Done;
  std::string Text; ///< what is wrong
};

/// Does the work, while VTK's messages are collected and numbers have a decimal point.
Outcome Try(const std::function<void()>& work);
}

#endif
