// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Statistics.h
 * @brief Mean, quantiles and maximum of many errors.
 */
#ifndef relievoBenchStatistics_h
#define relievoBenchStatistics_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace relievoBench
{
struct Statistics
{
  double Mean = 0.;
  double Median = 0.;
  double P99 = 0.;
  double Max = 0.;
};

/** Statistics of errors, which are reordered. NaN counts as the largest. */
inline Statistics Summarize(std::vector<float>& errors)
{
  Statistics result;
  if (errors.empty())
  {
    return result;
  }
  double sum = 0.;
  for (float error : errors)
  {
    sum += error;
  }
  result.Mean = sum / static_cast<double>(errors.size());
  const auto less = [](float a, float b) { return a < b || (a == a && b != b); };
  const auto quantile = [&errors, &less](double share) {
    const auto place =
      errors.begin() + static_cast<std::ptrdiff_t>(share * double(errors.size() - 1));
    std::nth_element(errors.begin(), place, errors.end(), less);
    return static_cast<double>(*place);
  };
  result.Median = quantile(0.5);
  result.P99 = quantile(0.99);
  result.Max = quantile(1.);
  return result;
}
}

#endif
