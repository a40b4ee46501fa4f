// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleOffset.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRenderer.h"

namespace
{
// The number's digits in a base, mirrored at the radix point (van der Corput).
double GetRadicalInverse(int number, int base)
{
  double inverse = 0.0;
  for (double place = 1.0 / base; number > 0; place /= base, number /= base)
  {
    inverse += place * (number % base);
  }
  return inverse;
}

// Starts in the middle of the sequence's range.
double GetPlace(int sample, int base)
{
  const double place = GetRadicalInverse(sample, base) + 0.5;
  return place < 1.0 ? place : place - 1.0;
}

double GetOffset(int sample, int samples, int base)
{
  double sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    sum += GetPlace(i, base);
  }
  return GetPlace(sample, base) - sum / samples;
}
}

//------------------------------------------------------------------------------
vtkRelievoSampleOffset::vtkRelievoSampleOffset(vtkRelievoFrameContext& context)
{
  const int* viewport = context.View.Viewport;
  if (!context.OffsetsSamples || context.Lattice || viewport[2] <= 0 || viewport[3] <= 0)
  {
    return;
  }
  const glm::dvec2 offset = Get(context.Sample, context.Samples);
  glm::dmat4 move(1.0);
  move[3] = glm::dvec4(-2.0 * offset.x / viewport[2], -2.0 * offset.y / viewport[3], 0.0, 1.0);
  context.View.ViewToNDC = move * context.View.ViewToNDC;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, context.View.ViewToNDC[column][row]);
    }
  }
  this->Projection.emplace(context.Renderer->GetActiveCamera(), matrix);
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoSampleOffset::Get(int sample, int samples)
{
  return { GetOffset(sample, samples, 2), GetOffset(sample, samples, 3) };
}
