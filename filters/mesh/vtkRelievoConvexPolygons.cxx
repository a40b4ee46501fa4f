// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoConvexPolygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonOutline.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkRelievoConvexPolygons);

namespace
{
using Way = vtkRelievoPolygonOutline::Way;

// The polygons of the output; the first ones are those of the input.
class PolygonList
{
public:
  explicit PolygonList(vtkCellArray* before)
    : Before(before)
  {
  }

  // Starts to collect polygons after the first `unchanged` ones, which stay.
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
  std::vector<vtkIdType> Of; // input polygon of each output polygon
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
  vtkRelievoPolygonOutline outline(input->GetPoints());
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
    const Way way = outline.Look(count, ids);
    if (way != Way::AsItIs && !changed)
    {
      changed = true;
      list.Begin(polygon);
      polygons->GetCellAtId(polygon, count, ids); // the list has moved on since
    }
    if (way == Way::Turned)
    {
      ++this->NumberOfTurnedPolygons;
      std::vector<vtkIdType> turned(ids, ids + count);
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(outline.GetFirst()),
        turned.end());
      list.Add(polygon, count, turned.data());
    }
    else if (way == Way::Cut)
    {
      ++this->NumberOfCutPolygons;
      for (const vtkRelievoEarCutter::Triangle& triangle : outline.GetTriangles())
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
