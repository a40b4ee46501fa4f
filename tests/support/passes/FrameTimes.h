// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameTimes.h
 * @brief The times of a frame report.
 */
#ifndef relievoTestFrameTimes_h
#define relievoTestFrameTimes_h

#include <map>
#include <string>

namespace relievoTest
{
/** Milliseconds, negative where the report has none. */
struct FrameTimes
{
  double Frame = -1.0;
  std::map<std::string, double> Stages; // of those that ran

  explicit FrameTimes(const std::string& report);

  /**
   * What holds for the times of any frame: every stage that ran has one, and, since no work is two
   * stages', they add up to no more than the frame's. "" if so, else what is wrong.
   */
  std::string Judge() const;
};
}

#endif
