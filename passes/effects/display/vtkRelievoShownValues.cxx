// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShownValues.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoScopedState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr int SquareSide = 16;     // pixels, as in extremesFS.glsl
constexpr double Flat = 1e-3;      // greatest height of a ground, over its longest side
constexpr double Endless = 1.5;    // least side of an endless ground, over the diagonal of the rest
constexpr double Narrowest = 1e-4; // least range, over the values: smaller differences are noise

// Each process knows only its own props.
bool IsOfSeveralProcesses(const vtkRelievoFrameContext& context)
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  return context.Nested && all && all->GetNumberOfProcesses() > 1;
}

bool IsInTiles(const vtkRelievoFrameContext& context)
{
  const int* tiles = context.Window->GetTileScale();
  return tiles[0] > 1 || tiles[1] > 1;
}

// The bounds of the opaque props, without a ground far wider than all others; `ground` receives
// whether there is one.
vtkBoundingBox FindBounds(const vtkRelievoFrameContext& context, bool& ground)
{
  std::vector<vtkBoundingBox> boxes;
  for (const vtkRelievoFrameProp& each : vtkRelievoFrameScene::FindVisible(context.Renderer))
  {
    const double* bounds = each.Prop->GetBounds();
    if (bounds && bounds[0] <= bounds[1] && each.Prop->GetUseBounds() &&
      each.Prop->HasOpaqueGeometry() != 0)
    {
      boxes.emplace_back(bounds);
    }
  }
  const auto getSides = [](const vtkBoundingBox& box) {
    std::array<double, 3> sides;
    box.GetLengths(sides.data());
    std::sort(sides.begin(), sides.end());
    return sides;
  };
  const auto isFlat = [&getSides](const vtkBoundingBox& box) {
    const std::array<double, 3> sides = getSides(box);
    return sides[0] <= Flat * sides[2];
  };
  vtkBoundingBox solid;
  for (const vtkBoundingBox& box : boxes)
  {
    if (!isFlat(box))
    {
      solid.AddBox(box);
    }
  }
  ground = false;
  vtkBoundingBox bounds;
  for (const vtkBoundingBox& box : boxes)
  {
    const bool endless =
      solid.IsValid() && isFlat(box) && getSides(box)[1] > Endless * solid.GetDiagonalLength();
    ground = ground || endless;
    if (!endless)
    {
      bounds.AddBox(box);
    }
  }
  return bounds;
}

// The nearest and the farthest value of a box, between the clipping planes.
void FindExtent(
  const vtkRelievoFrameCamera& view, const vtkBoundingBox& box, bool distance, double range[2])
{
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -range[0];
  glm::dvec3 least(range[0]);
  glm::dvec3 most(range[1]);
  for (int corner = 0; corner < 8; ++corner)
  {
    double at[3];
    box.GetCorner(corner, at);
    const glm::dvec3 seen(view.WorldToView * glm::dvec4(at[0], at[1], at[2], 1.0));
    least = glm::min(least, seen);
    most = glm::max(most, seen);
    range[1] = std::max(range[1], distance ? glm::length(seen) : -seen.z);
  }
  range[0] = distance ? glm::length(glm::clamp(glm::dvec3(0.0), least, most)) : -most.z;
  range[0] = std::max(range[0], view.Near);
  range[1] = distance ? range[1] : std::min(range[1], view.Far);
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoShownValues::Measure(
  vtkRelievoFrameContext& context, const std::string& layer, double range[2])
{
  const int size[2] = { context.View.Viewport[2], context.View.Viewport[3] };
  const int area[4] = { 0, 0, (size[0] + SquareSide - 1) / SquareSide,
    (size[1] + SquareSide - 1) / SquareSide };
  if (!this->Extremes || this->Size[0] != size[0] || this->Size[1] != size[1] ||
    this->Extremes->GetContext() != context.Window)
  {
    this->Release(context.Window);
    this->Size[0] = size[0];
    this->Size[1] = size[1];
    this->Pen = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Pen->SetContext(context.Window);
    this->Extremes = vtkSmartPointer<vtkTextureObject>::New();
    this->Extremes->SetContext(context.Window);
    this->Extremes->SetInternalFormat(GL_RGBA32F);
    this->Extremes->SetFormat(GL_RGBA);
    this->Extremes->SetDataType(GL_FLOAT);
    this->Extremes->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Extremes->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Extremes->Allocate2D(
      static_cast<unsigned int>(area[2]), static_cast<unsigned int>(area[3]), 4, VTK_FLOAT);
  }
  vtkShaderProgram* program =
    this->Quad.Ready(context, "display/extremesFS.glsl", { vtkRelievoResourceName::Of(layer) },
      "#define RELIEVO_SHOW_" + vtkRelievoLayerCatalogue::Find(layer).Shader + "\n");
  if (!program)
  {
    return this->Quad.GetError();
  }
  const float squares[2] = { static_cast<float>(area[2]), static_cast<float>(area[3]) };
  program->SetUniform2f("relievoSquares", squares);
  std::vector<float> texels(4 * static_cast<std::size_t>(area[2]) * area[3]);
  {
    vtkOpenGLState* state = context.Window->GetState();
    const vtkRelievoScopedState kept(state);
    state->vtkglDisable(GL_BLEND);
    this->Pen->Bind();
    this->Pen->AddColorAttachment(0, this->Extremes);
    this->Pen->ActivateDrawBuffer(0);
    this->Quad.Draw(context, area);
    this->Pen->ActivateReadBuffer(0);
    state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, area[2], area[3], GL_RGBA, GL_FLOAT, texels.data());
  }
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -range[0];
  for (std::size_t i = 0; i < texels.size(); i += 4)
  {
    if (texels[i] <= texels[i + 1])
    {
      range[0] = std::min<double>(range[0], texels[i]);
      range[1] = std::max<double>(range[1], texels[i + 1]);
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShownValues::Find(
  vtkRelievoFrameContext& context, const std::string& layer, double range[2])
{
  const vtkRelievoFrameCamera& view = context.View;
  if (IsOfSeveralProcesses(context)) // only the clipping planes are common to all
  {
    range[0] = view.Near;
    range[1] = view.Far;
    return std::string();
  }
  // Volumes are not among the opaque props whose bounds tell how far a ground counts.
  bool ground = false;
  const vtkBoundingBox box =
    layer == "volume_depth" ? vtkBoundingBox() : FindBounds(context, ground);
  double extent[2] = { view.Near, view.Far };
  if (box.IsValid())
  {
    FindExtent(view, box, layer == "range", extent);
  }
  if (IsInTiles(context)) // each tile shows a part
  {
    std::copy(extent, extent + 2, range);
  }
  else
  {
    const std::string error = this->Measure(context, layer, range);
    if (!error.empty() || !std::isfinite(range[0]))
    {
      return error;
    }
    // If only the ground is in sight, its whole range counts.
    if (ground && extent[0] < range[1] && extent[1] > range[0])
    {
      range[0] = std::max(range[0], extent[0]);
      range[1] = std::min(range[1], extent[1]);
    }
  }
  const double least = Narrowest * std::max(std::abs(range[0]), std::abs(range[1]));
  range[1] = std::max(range[1], range[0] + least);
  return std::string();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShownValues::GetBytes() const
{
  return this->Extremes ? vtkIdType(16) * this->Extremes->GetWidth() * this->Extremes->GetHeight()
                        : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoShownValues::Release(vtkWindow* window)
{
  this->Quad.Release(window);
  if (this->Extremes)
  {
    this->Extremes->ReleaseGraphicsResources(window);
    this->Extremes = nullptr;
  }
  if (this->Pen)
  {
    this->Pen->ReleaseGraphicsResources(window);
    this->Pen = nullptr;
  }
}
