// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDrawnPart.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
bool HasUsualBackground(vtkRenderer* renderer)
{
  return renderer->GetLayer() == 0 && renderer->GetErase() && !renderer->GetPreserveColorBuffer() &&
    !renderer->GetGradientBackground() && !renderer->GetTexturedBackground() &&
    !renderer->GetUseFXAA() && !renderer->GetUseSSAO();
}

// Whether the actor stays within its box, widened by its lines and points. Classes are compared by
// name: subclasses may draw anything.
bool IsWithinBox(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || std::string(actor->GetClassName()) != "vtkOpenGLActor")
  {
    return false;
  }
#ifdef RELIEVO_VTK_COORDINATE_SYSTEMS
  if (actor->GetCoordinateSystem() != vtkProp3D::WORLD)
  {
    return false;
  }
#endif
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  if (shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->GetNumberOfShaderReplacements() > 0)
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> matrix;
  actor->GetMatrix(matrix);
  if (matrix->Element[3][0] != 0.0 || matrix->Element[3][1] != 0.0 ||
    matrix->Element[3][2] != 0.0 || matrix->Element[3][3] != 1.0)
  {
    return false; // a projected point may leave the projected corners' box
  }
  // Not for composite data: VTK's mappers may return an outdated box after a change of a block.
  const std::string name = mapper->GetClassName();
  auto* lines = vtkPolyDataMapper::SafeDownCast(mapper);
  return (name == "vtkOpenGLPolyDataMapper" && lines->GetNumberOfSubPieces() <= 1) ||
    name == "vtkDataSetMapper";
}

// Whether VTK shifts the actor's surfaces in z: coincident surfaces, and surfaces below their
// edges.
bool IsMovedInDepth(vtkProperty* property)
{
  return vtkMapper::GetResolveCoincidentTopology() != VTK_RESOLVE_OFF ||
    property->GetEdgeVisibility() || property->GetVertexVisibility();
}

// A rectangle in NDC, with depths, enlarged by float rounding.
struct Extent
{
  glm::dvec3 Least = glm::dvec3(VTK_DOUBLE_MAX);
  glm::dvec3 Most = glm::dvec3(-VTK_DOUBLE_MAX);

  // False if a corner of the box is not in front of the eye.
  bool Add(const glm::dmat4& toClip, const double bounds[6])
  {
    glm::dmat4 sizes;
    for (int column = 0; column < 4; ++column)
    {
      sizes[column] = glm::abs(toClip[column]);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec4 place(
        bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)], 1.0);
      const glm::dvec4 clip = toClip * place;
      // VTK's shaders compute this in floats: each of four products has the rounding of its factors
      // and its own, and the sum three more, 2^-24 each.
      const glm::dvec4 rounding = std::ldexp(6.0, -24) * (sizes * glm::abs(place));
      const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
      if (!(clip.w > 2.0 * rounding.w) || !std::isfinite(ndc.x + ndc.y + ndc.z))
      {
        return false;
      }
      const glm::dvec3 slack =
        (glm::dvec3(rounding) + glm::abs(ndc) * rounding.w) / (clip.w - rounding.w);
      this->Least = glm::min(this->Least, ndc - slack);
      this->Most = glm::max(this->Most, ndc + slack);
    }
    return true;
  }
};

glm::dmat4 GetMatrix(vtkActor* actor)
{
  vtkNew<vtkMatrix4x4> rows;
  actor->GetMatrix(rows);
  return glm::transpose(glm::make_mat4(rows->GetData()));
}
}

//------------------------------------------------------------------------------
void vtkRelievoDrawnPart::Find(const vtkRelievoFrameContext& context)
{
  const int* size = context.View.Viewport + 2;
  this->Part[0] = this->Part[1] = 0;
  this->Part[2] = size[0];
  this->Part[3] = size[1];
  this->TellsByDepth = false;
  if (!context.OwnSteps || context.Nested || !HasUsualBackground(context.Renderer))
  {
    return;
  }
  const glm::dmat4 toClip = context.View.ViewToNDC * context.View.WorldToView;
  Extent extent;
  double wide = 0.0; // width of the widest line or point
  bool tells = true;
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    if (props[i]->IsA("vtkActor2D") && !props[i]->IsA("vtkCaptionActor2D"))
    {
      continue; // drawn over the finished picture, unlike leaders of captions
    }
    auto* actor = vtkActor::SafeDownCast(props[i]);
    if (!actor || !IsWithinBox(actor))
    {
      return;
    }
    const double* bounds = actor->GetMapper()->GetBounds();
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      continue; // draws nothing
    }
    if (!extent.Add(toClip * GetMatrix(actor), bounds))
    {
      return;
    }
    vtkProperty* property = actor->GetProperty();
    wide = std::max({ wide, static_cast<double>(property->GetLineWidth()),
      static_cast<double>(property->GetPointSize()) });
    tells = tells && !actor->HasTranslucentPolygonalGeometry() && !IsMovedInDepth(property);
  }
  // One pixel for the rasteriser, and one for samples offset within the pixel.
  const double margin = std::ceil(wide) + 2.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double half = 0.5 * size[axis];
    const double from = std::floor(half * (extent.Least[axis] + 1.0) - margin);
    const double to = std::ceil(half * (extent.Most[axis] + 1.0) + margin);
    this->Part[axis] = static_cast<int>(std::clamp(from, 0.0, 2.0 * half));
    this->Part[axis + 2] = static_cast<int>(std::clamp(to, 0.0, 2.0 * half)) - this->Part[axis];
  }
  if (this->Part[2] <= 0 || this->Part[3] <= 0)
  {
    std::fill_n(this->Part, 4, 0);
  }
  // The farthest point must be distinguishable from the far plane in z, with 16 bits too, of which
  // half a step is 2^-16 in NDC, and after the rasteriser's rounding. Surfaces shifted by VTK may
  // have any z.
  this->TellsByDepth = tells && extent.Most.z < 1.0 - std::ldexp(1.0, -14);
}
