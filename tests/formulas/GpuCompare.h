// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GpuCompare.h
 * @brief Compares the results of a case on the GPU and in C++ (float).
 */
#ifndef relievoTestGpuCompare_h
#define relievoTestGpuCompare_h

#include "GpuCases.h"

#include <vector>

namespace relievoTest
{
/**
 * How a component of a result is compared: as a number with tolerances, or as a word of codes of
 * `Bits` bits each that may differ by `Codes`.
 */
struct Rule
{
  int Bits;
  int Codes;
  double Relative;
  double Absolute;
};

constexpr Rule Same = { 32, 0, 0., 0. };

inline Rule Codes(int bits)
{
  return { bits, 1, 0., 0. };
}

inline Rule Number(double relative, double absolute)
{
  return { 0, 0, relative, absolute };
}

struct Case
{
  int Which;
  const char* Name;
  Rule Rules[4];
};

/** Runs a case both ways; fails at a component outside its rule and prints the worst. */
void Compare(GpuCases& gpu, const Case& one, const std::vector<CaseInput>& inputs);

/** A case's input of three numbers. */
CaseInput Input(double x, double y, double z, const glm::uvec4& b = glm::uvec4(0));

/** Triples of numbers in [0, 1], with those where a formula may turn. */
std::vector<CaseInput> UnitInputs();
}

#endif
