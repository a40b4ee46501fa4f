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
  const std::string error = this->Target.Prepare(context, format);
  if (error.empty())
  {
    this->Target.Begin(context, 0.0f, part);
    this->Target.End();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Find(vtkRelievoFrameContext& context, const int part[4])
{
  if (!this->Quad.Ready(context, "frame/marksFS.glsl", { vtkRelievoResources::Samples }))
  {
    return this->Quad.GetError();
  }
  this->Target.GoOn(context);
  this->Quad.Draw(context, this->Target.GetArea(), vtkRelievoScreenQuad::NO_DEPTH, part);
  this->Target.End();
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Collect(const int part[4])
{
  this->Number = 0;
  this->Marked.clear();
  vtkNew<vtkImageData> image;
  const std::string error = this->Target.Read("marks", 1, image);
  if (!error.empty())
  {
    return error;
  }
  const float* marks =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(0))->GetPointer(0);
  const int width = image->GetDimensions()[0];
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
        this->Marked.push_back({ x, y, end - x });
        this->Number += static_cast<std::size_t>(end - x);
        x = end;
      }
    }
  }
  this->Sum(image->GetDimensions());
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoSampleMarks::Sum(const int size[2])
{
  this->Across = (size[0] + Block - 1) / Block + 1;
  const int up = (size[1] + Block - 1) / Block + 1;
  this->Sums.assign(static_cast<std::size_t>(this->Across) * up, 0);
  const auto at = [this](int x, int y) -> int& {
    return this->Sums[static_cast<std::size_t>(y) * this->Across + x];
  };
  for (const Run& run : this->Marked)
  {
    for (int x = run.X / Block; x <= (run.X + run.Width - 1) / Block; ++x)
    {
      at(x + 1, run.Y / Block + 1) = 1;
    }
  }
  for (int y = 1; y < up; ++y)
  {
    for (int x = 1; x < this->Across; ++x)
    {
      at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoSampleMarks::Choose(std::array<int, 4>& part)
{
  this->Chosen.clear();
  std::array<int, 2> least{ part[0] + part[2], part[1] + part[3] };
  std::array<int, 2> most{ part[0], part[1] };
  auto run = std::lower_bound(this->Marked.begin(), this->Marked.end(), part[1],
    [](const Run& before, int y) { return before.Y < y; });
  for (; run != this->Marked.end() && run->Y < part[1] + part[3]; ++run)
  {
    const int first = std::max(run->X, part[0]);
    const int end = std::min(run->X + run->Width, part[0] + part[2]);
    if (first < end)
    {
      this->Chosen.push_back({ first, run->Y, end - first });
      least = { std::min(least[0], first), std::min(least[1], run->Y) };
      most = { std::max(most[0], end), run->Y + 1 };
    }
  }
  part = { least[0], least[1], most[0] - least[0], most[1] - least[1] };
  return !this->Chosen.empty();
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::DrawPart(
  vtkRelievoFrameContext& context, const int part[4], const glm::dmat4& toRaster)
{
  std::vector<float> rectangle;
  for (int i = 0; i < 4; ++i)
  {
    rectangle.push_back(static_cast<float>(part[i] + (i < 2 ? -Reach : 2 * Reach)));
  }
  return this->Draw(context, rectangle, toRaster);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Draw(vtkRelievoFrameContext& context, const glm::dmat4& toRaster)
{
  std::vector<float> rectangles;
  for (const Run& run : this->Chosen)
  {
    rectangles.insert(rectangles.end(),
      { static_cast<float>(run.X), static_cast<float>(run.Y), static_cast<float>(run.Width),
        1.0f });
  }
  return this->Draw(context, rectangles, toRaster);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleMarks::Draw(
  vtkRelievoFrameContext& context, const std::vector<float>& rectangles, const glm::dmat4& toRaster)
{
  const std::string error = this->Rectangles.Upload(context.Window, rectangles, 4);
  if (!error.empty())
  {
    return error;
  }
  vtkShaderProgram* program =
    this->Pixels.Ready(context, "frame/runsVS.glsl", "frame/runsFS.glsl", "");
  if (!program)
  {
    return this->Pixels.GetError();
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
  this->Rectangles.Activate(program, "relievoRuns");
  this->Pixels.Draw(static_cast<int>(rectangles.size() / 4));
  this->Rectangles.Deactivate();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoSampleMarks::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Quad.Release(window);
  this->Pixels.Release(window);
  this->Rectangles.Release(window);
}
