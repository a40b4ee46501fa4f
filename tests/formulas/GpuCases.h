// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GpuCases.h
 * @brief Runs cases.glsl on the GPU and in C++, float and double, on the same words.
 */
#ifndef relievoTestGpuCases_h
#define relievoTestGpuCases_h

#include "vtkRelievoFormulas.h"

#include <memory>
#include <vector>

namespace relievoTest
{
/** Two words of four per evaluation of a case. */
struct CaseInput
{
  glm::uvec4 A;
  glm::uvec4 B;
};

/** The case in C++: float, or double with its results rounded to float. */
std::vector<glm::uvec4> RunFloat(int which, const std::vector<CaseInput>& inputs);
std::vector<glm::uvec4> RunDouble(int which, const std::vector<CaseInput>& inputs);

/** An off-screen OpenGL context that runs cases. */
class GpuCases
{
public:
  /** Builds context and program; IsValid() is false, with a counted failure, if either fails. */
  GpuCases();
  ~GpuCases();
  bool IsValid() const;

  /** The case for every input; empty, with a counted failure, after an OpenGL error. */
  std::vector<glm::uvec4> Run(int which, const std::vector<CaseInput>& inputs);

  GpuCases(const GpuCases&) = delete;
  void operator=(const GpuCases&) = delete;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
