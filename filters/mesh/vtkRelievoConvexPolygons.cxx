// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoConvexPolygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoEarCutter.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkRelievoConvexPolygons);

namespace
{
using Vector = std::array<double, 3>;

// How a polygon is drawn without a fold.
enum class Way
{
  AsItIs,
  Turned,
  Cut
};

// Looks at one polygon after the other.
class PolygonJudge
{
public:
  explicit PolygonJudge(vtkPoints* points)
    : Points(points)
    , Tolerance(points->GetDataType() == VTK_FLOAT ? 1e-6 : 1e-12)
  {
  }

  Way Judge(vtkIdType count, const vtkIdType* ids)
  {
    if (count < 4)
    {
      return Way::AsItIs;
    }
    this->Corners.resize(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Points->GetPoint(ids[i], this->Corners[static_cast<std::size_t>(i)].data());
    }
    this->Normal = {};
    for (std::size_t i = 2; i < this->Corners.size(); ++i)
    {
      const Vector cross = this->Cross(0, i - 1, i);
      vtkMath::Add(this->Normal.data(), cross.data(), this->Normal.data());
    }
    const double square = vtkMath::Dot(this->Normal.data(), this->Normal.data());
    this->Least = -this->Tolerance * square;
    const bool backwards = this->LooksBackwards();
    if (!(square > 0.) || !std::isfinite(square) || !(backwards || this->Folds(0)))
    {
      return Way::AsItIs;
    }
    // Whoever sees all corners is found early or late; a large outline has hardly one.
    const std::size_t most = backwards ? 0 : std::min<std::size_t>(this->Corners.size(), 1000);
    for (this->First = 1; this->First < most; ++this->First)
    {
      if (!this->Folds(this->First))
      {
        return Way::Turned;
      }
    }
    return this->Cut() ? Way::Cut : Way::AsItIs;
  }

  std::size_t GetFirst() const { return this->First; }
  const std::vector<vtkRelievoEarCutter::Triangle>& GetTriangles() const { return this->Triangles; }

private:
  // Twice the triangle's area along its normal.
  Vector Cross(std::size_t a, std::size_t b, std::size_t c) const
  {
    Vector ab, ac, cross;
    vtkMath::Subtract(this->Corners[b].data(), this->Corners[a].data(), ab.data());
    vtkMath::Subtract(this->Corners[c].data(), this->Corners[a].data(), ac.data());
    vtkMath::Cross(ab.data(), ac.data(), cross.data());
    return cross;
  }

  bool Folds(std::size_t first) const
  {
    const std::size_t count = this->Corners.size();
    const auto wrap = [count](std::size_t i) { return i < count ? i : i - count; };
    for (std::size_t i = 2; i < count; ++i)
    {
      const Vector cross = this->Cross(first, wrap(first + i - 1), wrap(first + i));
      if (vtkMath::Dot(cross.data(), this->Normal.data()) < this->Least)
      {
        return true;
      }
    }
    return false;
  }

  // VTK sums up the triangles at the corners, of which those that turn in may weigh more. Four
  // corners sum up to twice the area.
  bool LooksBackwards() const
  {
    const std::size_t count = this->Corners.size();
    Vector sum = {};
    for (std::size_t i = 0; count > 4 && i < count; ++i)
    {
      const Vector cross = this->Cross(i, (i + 1) % count, (i + 2) % count);
      vtkMath::Add(sum.data(), cross.data(), sum.data());
    }
    return vtkMath::Dot(sum.data(), this->Normal.data()) < 0.;
  }

  // Without the axis that is next to the normal.
  bool Cut()
  {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = std::abs(this->Normal[i]) > std::abs(this->Normal[axis]) ? i : axis;
    }
    const bool above = this->Normal[axis] > 0.;
    const int u = (axis + (above ? 1 : 2)) % 3;
    const int v = (axis + (above ? 2 : 1)) % 3;
    this->Flat.clear();
    for (const Vector& corner : this->Corners)
    {
      this->Flat.push_back({ corner[u], corner[v] });
    }
    this->Triangles.clear();
    return this->Cutter.Cut(this->Flat, this->Triangles);
  }

  vtkPoints* const Points;
  const double Tolerance;
  double Least = 0.;
  std::size_t First = 0;
  Vector Normal = {};
  std::vector<Vector> Corners;
  std::vector<vtkRelievoEarCutter::Point> Flat;
  std::vector<vtkRelievoEarCutter::Triangle> Triangles;
  vtkRelievoEarCutter Cutter;
};

// The polygons of the output, of which the first ones are those of the input.
class PolygonList
{
public:
  explicit PolygonList(vtkCellArray* before)
    : Before(before)
  {
  }

  // All but the polygons so far, which stay.
  void Begin(vtkIdType unchanged)
  {
    this->Cells->AllocateExact(
      this->Before->GetNumberOfCells(), this->Before->GetNumberOfConnectivityIds());
    for (vtkIdType polygon = 0; polygon < unchanged; ++polygon)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      this->Before->GetCellAtId(polygon, count, ids);
      this->Add(polygon, count, ids);
    }
  }

  void Add(vtkIdType polygon, vtkIdType count, const vtkIdType* ids)
  {
    this->Cells->InsertNextCell(count, ids);
    this->Of.push_back(polygon);
  }

  vtkCellArray* GetCells() const { return this->Cells; }
  const std::vector<vtkIdType>& GetPolygons() const { return this->Of; }

private:
  vtkCellArray* const Before;
  vtkNew<vtkCellArray> Cells;
  std::vector<vtkIdType> Of; // the input, for each polygon
};

//------------------------------------------------------------------------------
// Cell data follow VTK's order: vertices, lines, polygons, strips.
void CopyCellData(vtkPolyData* from, const std::vector<vtkIdType>& polygons, vtkPolyData* to)
{
  const vtkIdType before = from->GetNumberOfVerts() + from->GetNumberOfLines();
  const vtkIdType behind = before + from->GetNumberOfPolys();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkRelievoPolygonIds");
  const auto size = static_cast<vtkIdType>(polygons.size());
  ids->SetNumberOfValues(before + size + from->GetNumberOfStrips());
  vtkIdType next = 0;
  for (; next < before; ++next)
  {
    ids->SetValue(next, next);
  }
  for (const vtkIdType polygon : polygons)
  {
    ids->SetValue(next++, before + polygon);
  }
  for (vtkIdType strip = 0; strip < from->GetNumberOfStrips(); ++strip)
  {
    ids->SetValue(next++, behind + strip);
  }
  vtkCellData* data = to->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(from->GetCellData(), ids->GetNumberOfValues());
  for (vtkIdType cell = 0; cell < ids->GetNumberOfValues(); ++cell)
  {
    data->CopyData(from->GetCellData(), ids->GetValue(cell), cell);
  }
  data->AddArray(ids);
}
}

//------------------------------------------------------------------------------
int vtkRelievoConvexPolygons::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  this->NumberOfTurnedPolygons = this->NumberOfCutPolygons = 0;
  vtkCellArray* polygons = input->GetPolys();
  if (!input->GetPoints() || polygons->IsHomogeneous() == 3)
  {
    return 1;
  }
  PolygonJudge judge(input->GetPoints());
  PolygonList list(polygons);
  bool changed = false;
  for (vtkIdType polygon = 0; polygon < polygons->GetNumberOfCells(); ++polygon)
  {
    if (polygon % 65536 == 0)
    {
      this->UpdateProgress(
        static_cast<double>(polygon) / static_cast<double>(polygons->GetNumberOfCells()));
      if (this->GetAbortExecute())
      {
        return 1;
      }
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(polygon, count, ids);
    const Way way = judge.Judge(count, ids);
    if (way != Way::AsItIs && !changed)
    {
      changed = true;
      list.Begin(polygon);
      polygons->GetCellAtId(polygon, count, ids); // which the list has gone on from
    }
    if (way == Way::Turned)
    {
      ++this->NumberOfTurnedPolygons;
      std::vector<vtkIdType> turned(ids, ids + count);
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(judge.GetFirst()),
        turned.end());
      list.Add(polygon, count, turned.data());
    }
    else if (way == Way::Cut)
    {
      ++this->NumberOfCutPolygons;
      for (const vtkRelievoEarCutter::Triangle& triangle : judge.GetTriangles())
      {
        const vtkIdType corners[3] = { ids[triangle[0]], ids[triangle[1]], ids[triangle[2]] };
        list.Add(polygon, 3, corners);
      }
    }
    else if (changed)
    {
      list.Add(polygon, count, ids);
    }
  }
  if (changed)
  {
    output->SetPolys(list.GetCells());
  }
  if (this->NumberOfCutPolygons > 0)
  {
    output->GetCellData()->Initialize();
    CopyCellData(input, list.GetPolygons(), output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoConvexPolygons::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTurnedPolygons: " << this->NumberOfTurnedPolygons << "\n";
  os << indent << "NumberOfCutPolygons: " << this->NumberOfCutPolygons << "\n";
}
