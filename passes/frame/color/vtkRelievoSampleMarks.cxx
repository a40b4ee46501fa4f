// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleMarks.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <vector>

namespace
{
// Pixels around a part whose samples frame/marksFS.glsl reads.
constexpr int Reach = 2;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Begin(vtkRelievoFrameContext& context, const int part[4])
{
  vtkRelievoScreenTarget::Format format;
  format.Channels = 1;
  const std::string wrong = this->Target.Prepare(context, format);
  if (wrong.empty())
  {
    this->Target.Begin(context, 0.0f, part);
    this->Target.End();
  }
  return wrong;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Find(vtkRelievoFrameContext& context, const int part[4])
{
  if (!this->Quad.Ready(context, "frame/marksFS.glsl", { vtkRelievoResources::Samples }))
  {
    return this->Quad.GetWrong();
  }
  this->Target.GoOn(context);
  this->Quad.Draw(context, this->Target.GetArea(), vtkRelievoScreenQuad::NO_DEPTH, part);
  this->Target.End();
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Collect(vtkRelievoFrameContext& context, const int part[4])
{
  this->Number = 0;
  vtkNew<vtkImageData> image;
  const std::string wrong = this->Target.Read("marks", 1, image);
  if (!wrong.empty())
  {
    return wrong;
  }
  const float* marks =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(0))->GetPointer(0);
  const int width = image->GetDimensions()[0];
  std::vector<float> runs;
  int least[2] = { part[0] + part[2], part[1] + part[3] };
  int most[2] = { part[0], part[1] };
  for (int y = part[1]; y < part[1] + part[3]; ++y)
  {
    const float* row = marks + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = part[0]; x < part[0] + part[2]; ++x)
    {
      int end = x;
      while (end < part[0] + part[2] && row[end] > 0.f)
      {
        ++end;
      }
      if (end > x)
      {
        runs.insert(runs.end(),
          { static_cast<float>(x), static_cast<float>(y), static_cast<float>(end - x), 1.f });
        this->Number += static_cast<std::size_t>(end - x);
        least[0] = std::min(least[0], x);
        least[1] = std::min(least[1], y);
        most[0] = std::max(most[0], end);
        most[1] = y + 1;
        x = end;
      }
    }
  }
  this->Part = { least[0], least[1], most[0] - least[0], most[1] - least[1] };
  this->NumberOfRuns = runs.size() / 4;
  return runs.empty() ? std::string() : this->Runs.Upload(context.Window, runs, 4);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::DrawPart(
  vtkRelievoFrameContext& context, const int part[4], const glm::dmat4& toRaster)
{
  std::vector<float> runs;
  for (int i = 0; i < 4; ++i)
  {
    runs.push_back(static_cast<float>(part[i] + (i < 2 ? -Reach : 2 * Reach)));
  }
  this->NumberOfRuns = 1;
  const std::string wrong = this->Runs.Upload(context.Window, runs, 4);
  return wrong.empty() ? this->Draw(context, toRaster) : wrong;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Draw(vtkRelievoFrameContext& context, const glm::dmat4& toRaster)
{
  vtkShaderProgram* program =
    this->Pixels.Ready(context, "frame/runsVS.glsl", "frame/runsFS.glsl", "");
  if (!program)
  {
    return this->Pixels.GetWrong();
  }
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glm::mat4 matrix(toRaster);
  program->SetUniformMatrix4x4("relievoToRaster", &matrix[0][0]);
  this->Runs.Activate(program, "relievoRuns");
  this->Pixels.Draw(static_cast<int>(this->NumberOfRuns));
  this->Runs.Deactivate();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoSampleMarks::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Quad.Release(window);
  this->Pixels.Release(window);
  this->Runs.Release(window);
}
