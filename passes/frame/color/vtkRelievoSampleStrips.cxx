// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleStrips.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
constexpr double Target = 40.0; // milliseconds per strip

void DrawOpaque(const vtkRelievoFrameContext& context)
{
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    if (vtkActor::SafeDownCast(props[i]))
    {
      props[i]->RenderOpaqueGeometry(context.Renderer);
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStrips::Limit(const vtkRelievoFrameContext& context, int rows)
{
  const int* viewport = context.View.Viewport;
  this->Rows = std::clamp(rows, 1, viewport[3] - this->First);
  context.Window->GetState()->vtkglScissor(
    viewport[0], viewport[1] + this->First, viewport[2], this->Rows);
  this->Begun = std::chrono::steady_clock::now();
}

//------------------------------------------------------------------------------
// Returns the milliseconds that the strip took.
double vtkRelievoSampleStrips::Wait(const vtkRelievoFrameContext& context)
{
  context.Window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - this->Begun)
    .count();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStrips::Begin(const vtkRelievoFrameContext& context)
{
  this->First = 0;
  context.Window->WaitForCompletion(); // earlier work is none of the strip's
  this->Limit(context, context.View.Viewport[3] / 32);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStrips::End(const vtkRelievoFrameContext& context)
{
  const int* viewport = context.View.Viewport;
  double ofMeshes = this->Wait(context); // and of a few rows
  int rows = viewport[3] / 16;
  while (this->First + this->Rows < viewport[3] && !context.IsAborted())
  {
    this->First += this->Rows;
    this->Limit(context, ofMeshes < 0.5 * Target ? rows : viewport[3]);
    DrawOpaque(context);
    const double milliseconds = this->Wait(context);
    ofMeshes = std::min(ofMeshes, milliseconds);
    const double ofRow = std::max(milliseconds - ofMeshes, 1e-3) / this->Rows;
    rows = static_cast<int>(
      std::min((Target - ofMeshes) / ofRow, std::min(2.0 * this->Rows, 1.0 * viewport[3])));
  }
  context.Window->GetState()->vtkglScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
}
