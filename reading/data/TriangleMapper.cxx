// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleMapper.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace reading
{
vtkStandardNewMacro(TriangleMapper);

namespace
{
template <typename Value>
Value* GetValues(vtkDataArray* array)
{
  auto* plain = vtkAOSDataArrayTemplate<Value>::FastDownCast(array);
  return plain ? plain->GetPointer(0) : nullptr;
}

// Calls `visit` with the points' coordinates and the polygons' corners. False: VTK must draw them.
template <typename Visit>
bool VisitCorners(vtkPolyData* mesh, const Visit& visit)
{
  if (!mesh || !mesh->GetPoints() || mesh->GetNumberOfPolys() == 0 ||
    mesh->GetNumberOfPolys() != mesh->GetNumberOfCells())
  {
    return false;
  }
  vtkDataArray* const corners = mesh->GetPolys()->GetConnectivityArray();
  const auto visitPoints = [&](auto* places) {
    if (auto* small = GetValues<vtkTypeInt32>(corners))
    {
      return visit(places, small);
    }
    auto* large = GetValues<vtkTypeInt64>(corners);
    return large && visit(places, large);
  };
  vtkDataArray* const points = mesh->GetPoints()->GetData();
  if (auto* floats = GetValues<float>(points))
  {
    return visitPoints(floats);
  }
  auto* doubles = GetValues<double>(points);
  return doubles && visitPoints(doubles);
}

// Whether each triangle has three distinct places, so that VTK draws all of them.
template <typename Real, typename Id>
bool HaveAreas(const Real* places, const Id* corners, vtkIdType count)
{
  const auto differ = [](const Real* a, const Real* b) {
    return a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
  };
  for (vtkIdType i = 0; i < count; i += 3)
  {
    const Real* const a = places + 3 * static_cast<vtkIdType>(corners[i]);
    const Real* const b = places + 3 * static_cast<vtkIdType>(corners[i + 1]);
    const Real* const c = places + 3 * static_cast<vtkIdType>(corners[i + 2]);
    if (!differ(a, b) || !differ(b, c) || !differ(c, a))
    {
      return false;
    }
  }
  return true;
}

bool Upload(vtkOpenGLIndexBufferObject* to, const vtkTypeInt32* corners, std::size_t count)
{
  return to->Upload(corners, count, vtkOpenGLBufferObject::ElementArrayBuffer);
}

bool Upload(vtkOpenGLIndexBufferObject* to, const vtkTypeInt64* corners, std::size_t count)
{
  std::vector<unsigned int> numbers(count);
  std::transform(corners, corners + count, numbers.begin(),
    [](vtkTypeInt64 corner) { return static_cast<unsigned int>(corner); });
  return to->Upload(numbers, vtkOpenGLBufferObject::ElementArrayBuffer);
}

bool IsPlainSurface(vtkProperty* property, vtkPolyData* mesh)
{
  return property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() &&
    !mesh->GetPointData()->GetAttribute(vtkDataSetAttributes::EDGEFLAG);
}
}

//------------------------------------------------------------------------------
void TriangleMapper::SetInputConnection(int port, vtkAlgorithmOutput* input)
{
  this->Superclass::SetInputConnection(port, input);
  this->SetStatic(input && vtkTrivialProducer::SafeDownCast(input->GetProducer()));
}

//------------------------------------------------------------------------------
void TriangleMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Uploaded = {};
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void TriangleMapper::ComputeBounds()
{
  vtkPolyData* const mesh = this->GetInput();
  const vtkMTimeType time = mesh ? mesh->GetMTime() : 0;
  if (time == 0 || time != this->BoundsTime)
  {
    const bool found = VisitCorners(mesh, [&](const auto* places, const auto* corners) {
      using Real = std::decay_t<decltype(*places)>;
      Real least[3], most[3];
      std::fill_n(least, 3, std::numeric_limits<Real>::max());
      std::fill_n(most, 3, std::numeric_limits<Real>::lowest());
      const vtkIdType count = mesh->GetPolys()->GetNumberOfConnectivityIds();
      for (vtkIdType i = 0; i < count; ++i)
      {
        const Real* const place = places + 3 * static_cast<vtkIdType>(corners[i]);
        for (int axis = 0; axis < 3; ++axis)
        {
          least[axis] = std::min(least[axis], place[axis]);
          most[axis] = std::max(most[axis], place[axis]);
        }
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Bounds[2 * axis] = static_cast<double>(least[axis]);
        this->Bounds[2 * axis + 1] = static_cast<double>(most[axis]);
      }
      return count > 0;
    });
    if (!found)
    {
      this->Superclass::ComputeBounds();
    }
    std::copy_n(this->Bounds, 6, this->KnownBounds.begin());
    this->BoundsTime = time;
  }
  std::copy(this->KnownBounds.begin(), this->KnownBounds.end(), this->Bounds);
}

//------------------------------------------------------------------------------
void TriangleMapper::BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* mesh)
{
  vtkOpenGLIndexBufferObject* const buffer = this->Primitives[PrimitiveTris].IBO;
  const std::array<vtkMTimeType, 2> now = { mesh->GetPolys()->GetMTime(),
    mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0 };
  const vtkIdType corners = mesh->GetPolys()->GetNumberOfConnectivityIds();
  const bool done = IsPlainSurface(actor->GetProperty(), mesh) &&
    (now == this->Uploaded || VisitCorners(mesh, [&](const auto* places, const auto* numbers) {
      return mesh->GetPolys()->IsHomogeneous() == 3 && HaveAreas(places, numbers, corners) &&
        Upload(buffer, numbers, static_cast<std::size_t>(corners));
    }));
  this->Uploaded = done ? now : std::array<vtkMTimeType, 2>{};
  if (!done)
  {
    this->Superclass::BuildIBO(renderer, actor, mesh);
    return;
  }
  vtkNew<vtkPolyData> rest;
  rest->SetPoints(mesh->GetPoints());
  this->Superclass::BuildIBO(renderer, actor, rest); // leaves buffers without cells unchanged
  buffer->IndexCount = static_cast<std::size_t>(corners);
}
}
