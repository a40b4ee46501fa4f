// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodExact.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoShadowRegion.h"
#include "vtkRelievoShadowWork.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <sstream>

namespace
{
// The share of wrong verdicts that testShadowExact allows, whatever the maps' size.
constexpr vtkRelievoShadowErrorLaw Law = { 2e-5, 0.0 };

// Roundings on a place's way from the vertex buffer through the camera's matrix and the raster.
constexpr double Roundings = 4.0;
constexpr double Ulp = 1.0 / (1 << 23);

// Half of what the picture's height shows of the world at a point.
double GetSizeInView(const vtkRelievoView& view, const glm::dvec3& center)
{
  const double away = -(view.WorldToView * glm::dvec4(center, 1.0)).z;
  return (view.Parallel ? 1.0 : std::abs(away)) / std::abs(view.ViewToNDC[1][1]);
}

// A point near the center, of a grid about as wide as the view: few moves of the camera take
// another.
glm::dvec3 GetOrigin(const vtkRelievoView& view, const glm::dvec3& center)
{
  const double size = GetSizeInView(view, center);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return center;
  }
  const double step = std::exp2(std::ceil(std::log2(size)));
  return step * glm::round(center / step);
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowMethodExact::Prepare(vtkRelievoShadowWork& work, vtkRenderer* renderer)
{
  const glm::dvec3 center = vtkRelievoShadowRegion::GetMiddle(vtkRelievoShadowRegion::Cut(
    work.Props.GetReceiverBoxes(), work.View.ViewToNDC * work.View.WorldToView));
  std::string fault =
    this->Tree.Update(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()),
      work.Props.TakeFollowed(), GetOrigin(work.View, center));
  if (fault.empty() && !this->Tree.Bind())
  {
    fault = "all texture units of this OpenGL are taken";
  }
  if (!fault.empty())
  {
    work.Props.PutBackFollowed();
  }
  return fault;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodExact::SetFrameUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowWork& work) const
{
  // As vtkRelievoShadowUniforms hands the center to the shader.
  const glm::dvec3& center = work.Cache.GetCenter();
  const glm::dvec3 centerVC(glm::vec3(work.View.WorldToView * glm::dvec4(center, 1.0)));
  const glm::dmat4 viewToWorld = glm::inverse(work.View.WorldToView);
  glm::dmat4 toLocal{ glm::dmat3(viewToWorld) };
  toLocal[3] =
    glm::dvec4(glm::dvec3(viewToWorld * glm::dvec4(centerVC, 1.0)) - this->Tree.GetOrigin(), 1.0);
  const glm::mat4 matrix(toLocal);
  std::vector<glm::vec4> sources;
  for (const auto& entry : work.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    sources.emplace_back(light.Positional ? glm::dvec4(light.Position - this->Tree.GetOrigin(), 1.0)
                                          : glm::dvec4(-light.Direction, 0.0));
  }
  const float blur[2] = { static_cast<float>(Roundings * Ulp * GetSizeInView(work.View, center)),
    static_cast<float>(Roundings * Ulp) };
  program->SetUniformi("relievoShadowTree", this->Tree.GetTextureUnit());
  program->SetUniformi(
    "relievoShadowCasters", work.DrawingAnyMaps ? 0 : this->Tree.GetNumberOfNodes());
  program->SetUniformi("relievoShadowRecords", this->Tree.GetFirstRecord());
  program->SetUniformMatrix4x4("relievoShadowToLocal", const_cast<float*>(&matrix[0][0]));
  program->SetUniform4fv("relievoShadowSource", static_cast<int>(sources.size()),
    reinterpret_cast<const float(*)[4]>(&sources[0].x));
  program->SetUniform2f("relievoShadowBlur", blur);
}

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodExact::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  estimate.WrongShare = Law.GetShare(demand.MapSize);
  return estimate;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowMethodExact::GetReport() const
{
  std::ostringstream out;
  out << ", rays past " << this->Tree.GetNumberOfTriangles() << " triangles of "
      << this->Tree.GetNumberOfCasters()
      << (this->Tree.GetNumberOfCasters() == 1 ? " caster" : " casters");
  return out.str();
}
