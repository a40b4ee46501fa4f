// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * @brief Several processes that draw together, without MPI: each a fork of the test.
 */
#ifndef relievoTestRanks_h
#define relievoTestRanks_h

#include <cstddef>
#include <functional>
#include <vector>

class vtkMultiProcessController;

namespace relievoTest
{
/**
 * Runs `work` in so many new processes, and returns what each of them returns. Call it before
 * anything is drawn or any thread started. Checks count as everywhere; the test also fails if a
 * process ends otherwise, or if two of them meet in different collective calls: what the one sends
 * is not what the other expects.
 */
std::vector<std::vector<float>> RunRanks(
  int ranks, const std::function<std::vector<float>(vtkMultiProcessController*)>& work);

/**
 * Runs `work`, which records `size` numbers in all, so many values for each pixel, in one process,
 * in two and in four; `compare` gets how many there were, what the one has recorded, and what the
 * several have, put together: of each pixel the values of the process whose first, the depth, is
 * least.
 */
void CompareRanks(const std::function<std::vector<float>(vtkMultiProcessController*)>& work,
  int values, std::size_t size,
  const std::function<void(int ranks, const float* one, const float* several)>& compare);

/** Bytes that this process has sent to others, in all. */
long long GetBytesSent();
}

#endif
