// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuCases.h"

// The files of cases and of a tree's indices, once in each number type, as vtkRelievoFormulas.h
// takes in the formulas.
namespace relievo
{
namespace f32
{
namespace
{
#include "rays/leaves.glsl"

#include "cases.glsl"
}
}

namespace f64
{
namespace
{
#define float double
#include "rays/leaves.glsl"

#include "cases.glsl"
#undef float
}
}
}

namespace relievoTest
{
//------------------------------------------------------------------------------
std::vector<glm::uvec4> RunFloat(int which, const std::vector<CaseInput>& inputs)
{
  std::vector<glm::uvec4> results;
  results.reserve(inputs.size());
  for (const CaseInput& input : inputs)
  {
    results.push_back(relievo::f32::relievoTestCase(which, input.A, input.B));
  }
  return results;
}

//------------------------------------------------------------------------------
std::vector<glm::uvec4> RunDouble(int which, const std::vector<CaseInput>& inputs)
{
  std::vector<glm::uvec4> results;
  results.reserve(inputs.size());
  for (const CaseInput& input : inputs)
  {
    results.push_back(relievo::f64::relievoTestCase(which, input.A, input.B));
  }
  return results;
}
}
