// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * @brief Several processes that draw together, without MPI: forks of the test.
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
 * Runs `work` in so many new processes, and returns their results. Call it before anything is drawn
 * or any thread started. Checks count as usual; the test also fails if a process ends abnormally,
 * or if two processes enter different collective calls, so that one sends other data than the other
 * expects.
 */
std::vector<std::vector<float>> RunRanks(
  int ranks, const std::function<std::vector<float>(vtkMultiProcessController*)>& work);

/**
 * Runs `work`, which records `size` numbers in all, a fixed number of values per pixel, in one
 * process, in two and in four. `compare` gets the number of processes, the values of the single
 * process, and the combined values of the several: for each pixel, those of the process with the
 * smallest first value, the depth.
 */
void CompareRanks(const std::function<std::vector<float>(vtkMultiProcessController*)>& work,
  int values, std::size_t size,
  const std::function<void(int ranks, const float* one, const float* several)>& compare);

/** Total bytes that this process has sent to others. */
long long GetBytesSent();
}

#endif
