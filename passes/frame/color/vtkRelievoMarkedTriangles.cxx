// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkedTriangles.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoSampleMarks.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

namespace
{
using Access = vtkRelievoAccess::Mapper;

// Of positions, in pixels: the rasteriser's grid is finer.
constexpr double Slack = 0.02;
constexpr double MostSlack = 0.5;

// Whether the last drawing moved no vertex, and used no primitive's number.
bool IsIndependentOfOthers(vtkShaderProgram* program)
{
  if (!program)
  {
    return false;
  }
  const auto has = [](vtkShader* shader, const char* section) {
    std::istringstream lines(vtkRelievoShaderLibrary::GetSection("frame/triangles.glsl", section));
    std::string text;
    std::getline(lines, text);
    return shader && shader->GetSource().find(text) != std::string::npos;
  };
  return has(program->GetVertexShader(), "Position") && !has(program->GetVertexShader(), "Moved") &&
    !has(program->GetFragmentShader(), "Number") && !has(program->GetGeometryShader(), "Number");
}

bool HasUsualPlaces(vtkPolyData* mesh)
{
  vtkDataArray* places = mesh->GetPoints()->GetData();
  return vtkFloatArray::FastDownCast(places) || vtkDoubleArray::FastDownCast(places);
}

// The mapper, if VTK's own code draws nothing but triangles, from existing buffers.
vtkOpenGLPolyDataMapper* GetMapper(vtkActor* actor)
{
  vtkMapper* any = actor->GetMapper();
  if (!any || std::strcmp(any->GetClassName(), "vtkOpenGLPolyDataMapper") != 0 ||
    !vtkRelievoPlainActor::IsOfClass(actor) || vtkRelievoPlainActor::HasOwnShaders(actor))
  {
    return nullptr;
  }
#ifdef RELIEVO_VTK_COORDINATE_SYSTEMS
  if (actor->GetCoordinateSystem() != vtkProp3D::WORLD)
  {
    return nullptr;
  }
#endif
  auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(any);
  vtkPolyData* mesh = mapper->GetInput();
  const bool current = mesh && mesh->GetPoints() && HasUsualPlaces(mesh) &&
    mapper->CurrentInput == mesh && Access::BuildTime(mapper) >= mesh->GetMTime() &&
    Access::BuildTime(mapper) >= mapper->GetMTime() && Access::AreBuffersOf(mapper, actor);
  return current && mesh->GetNumberOfStrips() == 0 && !Access::HasCellColors(mapper) &&
      IsIndependentOfOthers(Access::Program(mapper, vtkOpenGLPolyDataMapper::PrimitiveTris))
    ? mapper
    : nullptr;
}
}

//------------------------------------------------------------------------------
vtkRelievoMarkedTriangles::vtkRelievoMarkedTriangles(vtkActor* actor)
  : Actor(actor)
  , Mapper(vtkRelievoIsSoftwareOpenGL() ? GetMapper(actor) : nullptr)
{
}

//------------------------------------------------------------------------------
vtkRelievoMarkedTriangles::~vtkRelievoMarkedTriangles()
{
  this->End();
  this->Used->ReleaseGraphicsResources();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkedTriangles::Project(const vtkRelievoFrameContext& context)
{
  vtkPoints* points = this->Mapper->GetInput()->GetPoints();
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  const int* viewport = context.View.Viewport;
  const glm::dvec2 half(0.5 * viewport[2], 0.5 * viewport[3]);
  vtkNew<vtkMatrix4x4> rows;
  this->Actor->GetMatrix(rows);
  const glm::dmat4 toClip = context.View.ViewToNDC * context.View.WorldToView *
    glm::transpose(glm::make_mat4(rows->GetData()));
  // VTK's shaders compute this in floats, of coordinates relative to an origin: each of four
  // products has the rounding of its factors and its own, and the sum three more, 2^-24 each.
  vtkOpenGLVertexBufferObject* vertices = Access::Buffers(this->Mapper)->GetVBO("vertexMC");
  glm::dvec3 origin(0.0);
  if (vertices && vertices->GetCoordShiftAndScaleEnabled())
  {
    std::copy_n(vertices->GetShift().data(), 3, glm::value_ptr(origin));
  }
  double bounds[6];
  points->GetBounds(bounds);
  glm::dvec4 rounding = glm::abs(toClip * glm::dvec4(origin, 1.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    const double farthest = std::max(
      std::abs(bounds[2 * axis] - origin[axis]), std::abs(bounds[2 * axis + 1] - origin[axis]));
    rounding += glm::abs(toClip[axis]) * farthest;
  }
  rounding *= std::ldexp(6.0, -24);
  this->Places.resize(count);
  double slack = 0.0;
  const auto project = [&](const auto* from) {
    for (std::size_t i = 0; i < count; ++i, from += 3)
    {
      const glm::dvec4 clip =
        toClip * glm::dvec4(static_cast<double>(from[0]), from[1], from[2], 1.0);
      const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
      const glm::dvec2 own =
        half * (glm::dvec2(rounding) + glm::abs(ndc) * rounding.w) / (clip.w - rounding.w);
      const double most = own.x + own.y; // the raster is rotated
      const bool known = clip.w > 2.0 * rounding.w && most < MostSlack;
      slack = known ? std::max(slack, most) : slack;
      this->Places[i] = glm::vec2(
        known ? half * (ndc + 1.0) : glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
    }
  };
  if (auto* floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    project(floats->GetPointer(0));
  }
  else
  {
    project(vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0));
  }
  this->Around = static_cast<float>(slack + Slack);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkedTriangles::Find(const vtkRelievoFrameContext& context,
  const vtkRelievoSampleMarks& marks, const std::vector<std::array<int, 4>>& parts)
{
  if (!this->Mapper)
  {
    return;
  }
  this->Project(context);
  this->Touching.resize(parts.size());
  vtkOpenGLIndexBufferObject* indices =
    Access::Indices(this->Mapper, vtkOpenGLPolyDataMapper::PrimitiveTris);
  std::vector<unsigned int> corners(indices->IndexCount);
  indices->Bind();
  glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0,
    static_cast<GLsizeiptr>(corners.size() * sizeof(unsigned int)), corners.data());
  indices->Release();
  const glm::vec2 last(context.View.Viewport[2] - 1, context.View.Viewport[3] - 1);
  // For each row of pixels, the first part that reaches it or a higher one, and the end of those
  // that begin there or lower.
  const auto rows = static_cast<std::size_t>(context.View.Viewport[3]);
  std::vector<std::size_t> firstFrom(rows, parts.size());
  std::vector<std::size_t> endTo(rows, 0);
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const int y = parts[part][1];
    for (std::size_t row = 0; row < rows; ++row)
    {
      if (static_cast<int>(row) < y + parts[part][3])
      {
        firstFrom[row] = std::min(firstFrom[row], part);
      }
      if (static_cast<int>(row) >= y)
      {
        endTo[row] = part + 1;
      }
    }
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    const glm::vec2& a = this->Places[corners[i]];
    const glm::vec2& b = this->Places[corners[i + 1]];
    const glm::vec2& c = this->Places[corners[i + 2]];
    const bool known = !std::isnan(a.x + b.x + c.x);
    const glm::vec2 low = known ? glm::min(glm::min(a, b), c) - this->Around : glm::vec2(0.0f);
    const glm::vec2 high = known ? glm::max(glm::max(a, b), c) + this->Around : last;
    if (high.x < 0.0f || high.y < 0.0f || low.x >= last.x + 1.0f || low.y >= last.y + 1.0f)
    {
      continue;
    }
    const glm::ivec2 from(glm::max(low, glm::vec2(0.0f)));
    const glm::ivec2 to(glm::min(high, last));
    if (!marks.HasAny(from, to))
    {
      continue;
    }
    for (std::size_t part = firstFrom[from.y]; part < endTo[to.y]; ++part)
    {
      const glm::ivec2 corner(parts[part][0], parts[part][1]);
      const glm::ivec2 least = glm::max(from, corner);
      const glm::ivec2 most = glm::min(to, corner + glm::ivec2(parts[part][2], parts[part][3]) - 1);
      if (least.x <= most.x && least.y <= most.y && marks.HasAny(least, most))
      {
        this->Touching[part].insert(
          this->Touching[part].end(), { corners[i], corners[i + 1], corners[i + 2] });
      }
    }
  }
  this->Places = {};
}

//------------------------------------------------------------------------------
bool vtkRelievoMarkedTriangles::Begin(std::size_t part)
{
  // Another actor may have made VTK build the mapper's buffers again.
  if (!this->Mapper || !Access::AreBuffersOf(this->Mapper, this->Actor))
  {
    return true;
  }
  const std::vector<unsigned int>& corners = this->Touching[part];
  if (!corners.empty() && this->Used->Upload(corners, vtkOpenGLBufferObject::ElementArrayBuffer))
  {
    this->Used->IndexCount = corners.size();
    vtkOpenGLIndexBufferObject*& used =
      Access::IndicesInUse(this->Mapper, vtkOpenGLPolyDataMapper::PrimitiveTris);
    this->All = used;
    used = this->Used;
  }
  return !corners.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkedTriangles::End()
{
  if (this->All)
  {
    Access::IndicesInUse(this->Mapper, vtkOpenGLPolyDataMapper::PrimitiveTris) = this->All;
    this->All = nullptr;
  }
}
