// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAmbientScene.h"

#include "vtkRelievoFrameContext.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace
{
// Rounding steps of a position, from the vertex buffer through the raster and back from its depth.
constexpr double Roundings = 8.0;
constexpr double Ulp = 1.0 / (1 << 23);

// A point in the middle of the view, on a grid about as wide as the view there: the point depends
// on the camera alone, and few camera moves change it.
glm::dvec3 GetOrigin(const vtkRelievoFrameCamera& view)
{
  const glm::dmat4 viewToWorld = glm::inverse(view.WorldToView);
  const double away =
    view.Parallel ? 0.5 * (view.Near + view.Far) : std::sqrt(view.Near * view.Far);
  const glm::dvec3 middle(viewToWorld * glm::dvec4(0.0, 0.0, -away, 1.0));
  const double size = (view.Parallel ? 1.0 : away) / std::abs(view.ViewToNDC[1][1]);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return middle;
  }
  const double step = std::exp2(std::ceil(std::log2(size)));
  return step * glm::round(middle / step);
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientScene::Begin(
  const vtkRelievoFrameContext& context, const std::string& error)
{
  const glm::dvec3 origin = GetOrigin(context.SteadyView);
  vtkRelievoMeshPart part;
  part.Meshes = this->Meshes.Find(context.Renderer);
  this->Others.SetController(context.Controller);
  if (!this->Others.IsOn())
  {
    return error.empty() ? this->Update(context.Window, part.Meshes, origin) : error;
  }
  const bool ready = error.empty() && this->Tree.IsIn(context.Window, origin) && this->Tree.Bind();
  std::string fault = this->Others.Share(part, ready);
  if (!fault.empty())
  {
    return fault;
  }
  fault =
    error.empty() ? this->Update(context.Window, this->Others.GetWhole().Meshes, origin) : error;
  return this->Others.Confirm(fault);
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientScene::Update(vtkOpenGLRenderWindow* window,
  const std::vector<vtkRelievoPlacedMesh>& meshes, const glm::dvec3& origin)
{
  const std::string error = this->Tree.Update(window, meshes, origin);
  return !error.empty() ? error
    : this->Tree.Bind() ? std::string()
                        : "all texture units of this OpenGL are taken";
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientScene::SetUniforms(
  vtkShaderProgram* program, const vtkRelievoFrameContext& context, const std::string& prefix) const
{
  glm::dmat4 toTree = glm::inverse(context.View.WorldToView);
  toTree[3] = glm::dvec4(glm::dvec3(toTree[3]) - this->Tree.GetOrigin(), 1.0);
  glm::mat4 rounded(toTree);
  const double away = glm::length(glm::dvec3(toTree[3]));
  const float blur[2] = { static_cast<float>(Roundings * Ulp * away),
    static_cast<float>(Roundings * Ulp) };
  program->SetUniformMatrix4x4("ambientToLocal", &rounded[0][0]);
  program->SetUniform2f((prefix + "TreeBlur").c_str(), blur);
  program->SetUniformi((prefix + "Tree").c_str(), this->Tree.GetTextureUnit());
  program->SetUniformi((prefix + "TreeNodes").c_str(), this->Tree.GetNumberOfNodes());
  program->SetUniformi((prefix + "TreeRecords").c_str(), this->Tree.GetFirstRecord());
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientScene::Release(vtkWindow* window)
{
  this->Tree.Release(window);
  this->Meshes = vtkRelievoOpaqueMeshes();
  this->Others.Clear();
}
