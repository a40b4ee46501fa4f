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
/** Milliseconds, negative if the report has none. */
struct FrameTimes
{
  double Frame = -1.0;
  std::map<std::string, double> Stages; // of those that ran

  explicit FrameTimes(const std::string& report);

  /**
   * Checks a rule for the times of any frame: every stage that ran has one, and they add up to at
   * most the frame's time, since no work belongs to two stages. "" if valid, otherwise the problem.
   */
  std::string Judge() const;
};
}

#endif
