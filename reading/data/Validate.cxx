// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Validate.h"

#include "DataSets.h"
#include "Errors.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace reading
{
namespace
{
// Limits for a structured grid and its surface, which need several gigabytes here: VTK numbers all
// points to find those of the surface.
constexpr double MostPoints = 1.2e9;
constexpr double MostFaces = 1e8;

std::string Count(double count, const std::string& noun)
{
  return std::to_string(static_cast<long long>(count)) + " " + noun + (count == 1. ? "" : "s");
}

//------------------------------------------------------------------------------
template <typename Integer>
bool FindRange(vtkDataArray* integers, std::array<double, 2>& range)
{
  auto* plain = vtkAOSDataArrayTemplate<Integer>::FastDownCast(integers);
  if (!plain)
  {
    return false;
  }
  const Integer* const first = plain->GetPointer(0);
  Integer least = *first;
  Integer most = *first;
  for (vtkIdType i = 0; i < plain->GetNumberOfValues(); ++i) // a form that compilers vectorize
  {
    least = std::min(least, first[i]);
    most = std::max(most, first[i]);
  }
  range = { static_cast<double>(least), static_cast<double>(most) };
  return true;
}

// The range of a non-empty array. VTK's own function takes ten times as long.
std::array<double, 2> GetRange(vtkDataArray* integers)
{
  std::array<double, 2> range;
  if (!FindRange<vtkTypeInt32>(integers, range) && !FindRange<vtkTypeInt64>(integers, range))
  {
    integers->GetRange(range.data(), 0);
  }
  return range;
}

//------------------------------------------------------------------------------
void CheckCellArray(vtkCellArray* cells, vtkIdType numberOfPoints, const std::string& path,
  const std::string& noun = "point")
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  if (!cells->IsValid())
  {
    throw WorkError(path + ": its cells are broken: the places where they begin are out of order");
  }
  vtkDataArray* points = cells->GetConnectivityArray();
  if (points->GetNumberOfTuples() == 0)
  {
    return;
  }
  const std::array<double, 2> range = GetRange(points);
  if (range[0] < 0 || range[1] >= static_cast<double>(numberOfPoints))
  {
    const double index = range[0] < 0 ? range[0] : range[1];
    throw WorkError(path + ": a cell uses " + noun + " " +
      std::to_string(static_cast<long long>(index)) + ", but there are " + noun + "s 0 to " +
      std::to_string(numberOfPoints - 1) + " only; is the file complete?");
  }
}

//------------------------------------------------------------------------------
// Number of points in a cell of each type.
struct CellRow
{
  int Type;
  const char* Name;
  int Least;
  bool Exact; // false: Least or more
};
const CellRow CellRows[] = {
  { VTK_EMPTY_CELL, "empty cell", 0, false },
  { VTK_VERTEX, "vertex", 1, true },
  { VTK_POLY_VERTEX, "poly-vertex", 1, false },
  { VTK_LINE, "line", 2, true },
  { VTK_POLY_LINE, "poly-line", 2, false },
  { VTK_TRIANGLE, "triangle", 3, true },
  { VTK_TRIANGLE_STRIP, "triangle strip", 3, false },
  { VTK_POLYGON, "polygon", 3, false },
  { VTK_PIXEL, "pixel", 4, true },
  { VTK_QUAD, "quad", 4, true },
  { VTK_TETRA, "tetrahedron", 4, true },
  { VTK_VOXEL, "voxel", 8, true },
  { VTK_HEXAHEDRON, "hexahedron", 8, true },
  { VTK_WEDGE, "wedge", 6, true },
  { VTK_PYRAMID, "pyramid", 5, true },
  { VTK_PENTAGONAL_PRISM, "pentagonal prism", 10, true },
  { VTK_HEXAGONAL_PRISM, "hexagonal prism", 12, true },
  { VTK_QUADRATIC_EDGE, "quadratic edge", 3, true },
  { VTK_QUADRATIC_TRIANGLE, "quadratic triangle", 6, true },
  { VTK_QUADRATIC_QUAD, "quadratic quad", 8, true },
  { VTK_QUADRATIC_POLYGON, "quadratic polygon", 6, false },
  { VTK_QUADRATIC_TETRA, "quadratic tetrahedron", 10, true },
  { VTK_QUADRATIC_HEXAHEDRON, "quadratic hexahedron", 20, true },
  { VTK_QUADRATIC_WEDGE, "quadratic wedge", 15, true },
  { VTK_QUADRATIC_PYRAMID, "quadratic pyramid", 13, true },
  { VTK_BIQUADRATIC_QUAD, "biquadratic quad", 9, true },
  { VTK_TRIQUADRATIC_HEXAHEDRON, "triquadratic hexahedron", 27, true },
  { VTK_TRIQUADRATIC_PYRAMID, "triquadratic pyramid", 19, true },
  { VTK_QUADRATIC_LINEAR_QUAD, "quadratic linear quad", 6, true },
  { VTK_QUADRATIC_LINEAR_WEDGE, "quadratic linear wedge", 12, true },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, "biquadratic quadratic wedge", 18, true },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, "biquadratic quadratic hexahedron", 24, true },
  { VTK_BIQUADRATIC_TRIANGLE, "biquadratic triangle", 7, true },
  { VTK_CUBIC_LINE, "cubic line", 4, true },
  { VTK_CONVEX_POINT_SET, "convex point set", 4, false },
  { VTK_POLYHEDRON, "polyhedron", 4, false },
};

// Cells of any order.
struct OrderRow
{
  int Types[2]; // Lagrange and Bezier
  const char* Name;
  double (*CountFor)(double order);
  double (*CountForOrders)(const double* orders); // per direction; nullptr: always one
  int Other;                                      // another allowed number of points; 0: none
};
const OrderRow OrderRows[] = {
  { { VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE }, "curve", [](double n) { return n + 1.; }, nullptr,
    0 },
  { { VTK_LAGRANGE_TRIANGLE, VTK_BEZIER_TRIANGLE }, "triangle",
    [](double n) { return (n + 1.) * (n + 2.) / 2.; }, nullptr, 7 },
  { { VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_QUADRILATERAL }, "quadrilateral",
    [](double n) { return (n + 1.) * (n + 1.); },
    [](const double* n) { return (n[0] + 1.) * (n[1] + 1.); }, 0 },
  { { VTK_LAGRANGE_TETRAHEDRON, VTK_BEZIER_TETRAHEDRON }, "tetrahedron",
    [](double n) { return (n + 1.) * (n + 2.) * (n + 3.) / 6.; }, nullptr, 15 },
  { { VTK_LAGRANGE_HEXAHEDRON, VTK_BEZIER_HEXAHEDRON }, "hexahedron",
    [](double n) { return (n + 1.) * (n + 1.) * (n + 1.); },
    [](const double* n) { return (n[0] + 1.) * (n[1] + 1.) * (n[2] + 1.); }, 0 },
  { { VTK_LAGRANGE_WEDGE, VTK_BEZIER_WEDGE }, "wedge",
    [](double n) { return (n + 1.) * (n + 1.) * (n + 2.) / 2.; },
    [](const double* n) { return (n[0] + 1.) * (n[0] + 2.) * (n[2] + 1.) / 2.; }, 21 },
};

//------------------------------------------------------------------------------
// The error in a cell of a grid.
class CellJudge
{
public:
  explicit CellJudge(vtkUnstructuredGrid* grid)
    : Orders(grid->GetCellData()->GetHigherOrderDegrees())
  {
    for (const CellRow& row : CellRows)
    {
      this->CellRowOf[row.Type] = &row;
    }
    for (const OrderRow& row : OrderRows)
    {
      for (const int type : row.Types)
      {
        this->OrderCellRowOf[type] = &row;
      }
    }
  }

  std::string Judge(vtkIdType cell, int type, vtkIdType size) const
  {
    if (const CellRow* row = this->CellRowOf[type])
    {
      const bool even = type != VTK_QUADRATIC_POLYGON || size % 2 == 0;
      const bool fits = row->Exact ? size == row->Least : size >= row->Least;
      return fits && even
        ? ""
        : Name(row->Name, size) + ", expected " + (row->Exact ? "" : "at least ") +
          std::to_string(row->Least) + (even ? "" : ", an even number");
    }
    const OrderRow* row = this->OrderCellRowOf[type];
    if (!row)
    {
      return "of type " + std::to_string(type) + ", which VTK does not draw";
    }
    const std::string name =
      std::string(type == row->Types[0] ? "Lagrange " : "Bezier ") + row->Name;
    if (this->Orders && this->Orders->GetNumberOfComponents() == 3 && row->CountForOrders)
    {
      double orders[3];
      this->Orders->GetTuple(cell, orders);
      const double count = row->CountForOrders(orders);
      const bool fits = *std::min_element(orders, orders + 3) >= 0. && count >= 2. &&
        static_cast<double>(size) == count;
      return fits ? "" : Name(name, size) + ", expected those of its orders";
    }
    double order = 1.;
    while (row->CountFor(order) < static_cast<double>(size))
    {
      ++order;
    }
    return row->CountFor(order) == static_cast<double>(size) || (size > 0 && size == row->Other)
      ? ""
      : Name(name, size) +
        ", expected those of an order: " + std::to_string(static_cast<int>(row->CountFor(1.))) +
        ", " + std::to_string(static_cast<int>(row->CountFor(2.))) + ", " +
        std::to_string(static_cast<int>(row->CountFor(3.))) + ", ...";
  }

private:
  static std::string Name(const std::string& name, vtkIdType size)
  {
    return "a " + name + " of " + Count(static_cast<double>(size), "point");
  }

  vtkDataArray* const Orders;
  const CellRow* CellRowOf[256] = {};
  const OrderRow* OrderCellRowOf[256] = {};
};

//------------------------------------------------------------------------------
// The error in a polyhedron's faces, or "".
#ifdef RELIEVO_VTK_POLYHEDRON_CELL_ARRAYS
std::string JudgeFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkCellArray* faces = grid->GetPolyhedronFaces();
  vtkCellArray* ofCells = grid->GetPolyhedronFaceLocations();
  if (!faces || !ofCells || cell >= ofCells->GetNumberOfCells() || ofCells->GetCellSize(cell) < 4)
  {
    return "a polyhedron without four faces";
  }
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  ofCells->GetCellAtId(cell, count, ids);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (faces->GetCellSize(ids[i]) < 3)
    {
      return "a polyhedron with a face of fewer than 3 points";
    }
  }
  return "";
}

void CheckFaces(vtkUnstructuredGrid* grid, const std::string& path)
{
  vtkCellArray* faces = grid->GetPolyhedronFaces();
  CheckCellArray(faces, grid->GetNumberOfPoints(), path);
  CheckCellArray(
    grid->GetPolyhedronFaceLocations(), faces ? faces->GetNumberOfCells() : 0, path, "face");
}
#else
std::string JudgeFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdTypeArray* faces = grid->GetFaces();
  vtkIdTypeArray* places = grid->GetFaceLocations();
  const std::string without = "a polyhedron without four faces";
  if (!faces || !places || cell >= places->GetNumberOfValues())
  {
    return without;
  }
  const vtkIdType end = faces->GetNumberOfValues();
  vtkIdType place = places->GetValue(cell);
  const auto take = [&] { return place >= 0 && place < end ? faces->GetValue(place++) : -1; };
  const vtkIdType count = take();
  if (count < 4)
  {
    return without;
  }
  for (vtkIdType face = 0; face < count; ++face)
  {
    const vtkIdType size = take();
    if (size < 3)
    {
      return "a polyhedron with a face of fewer than 3 points";
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType point = take();
      if (point < 0 || point >= grid->GetNumberOfPoints())
      {
        return "a polyhedron with a face that uses a point which is not there";
      }
    }
  }
  return "";
}

void CheckFaces(vtkUnstructuredGrid*, const std::string&) {}
#endif

//------------------------------------------------------------------------------
void CheckGrid(vtkUnstructuredGrid* grid, const std::string& path)
{
  CheckCellArray(grid->GetCells(), grid->GetNumberOfPoints(), path);
  CheckFaces(grid, path);
  if (!grid->GetCells())
  {
    return;
  }
  const CellJudge judge(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    std::string error = judge.Judge(cell, type, grid->GetCells()->GetCellSize(cell));
    if (error.empty() && type == VTK_POLYHEDRON)
    {
      error = JudgeFaces(grid, cell);
    }
    if (!error.empty())
    {
      throw WorkError(path + ": cell " + std::to_string(cell) + " is " + error);
    }
  }
}

//------------------------------------------------------------------------------
void CheckPolygons(vtkPolyData* mesh, const std::string& path)
{
  const struct
  {
    vtkCellArray* Cells;
    const char* Name;
    vtkIdType Least;
  } kinds[] = { { mesh->GetVerts(), "vertex", 1 }, { mesh->GetLines(), "line", 2 },
    { mesh->GetPolys(), "polygon", 3 }, { mesh->GetStrips(), "triangle strip", 3 } };
  vtkIdType before = 0;
  for (const auto& [cells, name, least] : kinds)
  {
    CheckCellArray(cells, mesh->GetNumberOfPoints(), path);
    const vtkIdType count = cells->GetNumberOfCells();
    const bool uniform = cells->IsHomogeneous() >= least;
    for (vtkIdType i = 0; i < count && !uniform; ++i)
    {
      if (const vtkIdType size = cells->GetCellSize(i); size < least)
      {
        throw WorkError(path + ": cell " + std::to_string(before + i) + " is a " + name + " of " +
          Count(static_cast<double>(size), "point") + ", expected at least " +
          std::to_string(least));
      }
    }
    before += count;
  }
}

//------------------------------------------------------------------------------
// Points or coordinates, and the size of the surface.
void CheckStructure(const int extent[6], const std::function<std::string(const double*)>& find,
  const std::string& path)
{
  double sizes[3];
  for (int i = 0; i < 3; ++i)
  {
    sizes[i] = std::max(0., 1. + extent[2 * i + 1] - static_cast<double>(extent[2 * i]));
  }
  const std::string error = find(sizes);
  const std::string grid = std::to_string(static_cast<long long>(sizes[0])) + " x " +
    std::to_string(static_cast<long long>(sizes[1])) + " x " +
    std::to_string(static_cast<long long>(sizes[2])) + " points";
  if (!error.empty())
  {
    throw WorkError(path + ": its grid of " + grid + " " + error);
  }
  const double cells[3] = { sizes[0] - 1., sizes[1] - 1., sizes[2] - 1. };
  const bool flat = *std::min_element(cells, cells + 3) <= 0.;
  const double faces =
    (flat ? 1. : 2.) * (cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]);
  if (sizes[0] * sizes[1] * sizes[2] > MostPoints || faces > MostFaces)
  {
    throw WorkError(path + ": its grid of " + grid +
      " is too large: surfaces are drawn of at most 1200 million points, with at most 100 million "
      "faces; extract a part, or every second point");
  }
}

std::string CheckPoints(vtkStructuredGrid* grid, const double* sizes)
{
  const auto points = static_cast<double>(grid->GetPoints() ? grid->GetNumberOfPoints() : 0);
  const auto held =
    static_cast<double>(grid->GetPoints() ? grid->GetPoints()->GetNumberOfPoints() : 0);
  return points == held && held == sizes[0] * sizes[1] * sizes[2]
    ? ""
    : "comes with " + Count(held, "point");
}

std::string CheckCoordinates(vtkRectilinearGrid* grid, const double* sizes)
{
  vtkDataArray* const all[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (int i = 0; i < 3; ++i)
  {
    const auto held = static_cast<double>(all[i] ? all[i]->GetNumberOfTuples() : 0);
    if (held != sizes[i])
    {
      return "comes with " + Count(held, "coordinate") + " along " + "xyz"[i];
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void CheckArrays(
  vtkFieldData* data, vtkIdType count, const std::string& noun, const std::string& path)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() < count)
    {
      throw WorkError(path + ": its array '" + (array->GetName() ? array->GetName() : "") +
        "' has " + Count(static_cast<double>(array->GetNumberOfTuples()), "value") + " for " +
        Count(static_cast<double>(count), noun) + "; is the file complete?");
    }
  }
}
}

//------------------------------------------------------------------------------
void CheckCells(vtkDataObject* data, const std::string& path)
{
  ForEachDataSet(data, [&path](vtkDataSet* block) {
    if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(block))
    {
      CheckPolygons(mesh, path);
    }
    else if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(block))
    {
      CheckGrid(grid, path);
    }
    else if (vtkStructuredGrid* curved = vtkStructuredGrid::SafeDownCast(block))
    {
      CheckStructure(
        curved->GetExtent(), [&](const double* sizes) { return CheckPoints(curved, sizes); }, path);
    }
    else if (vtkRectilinearGrid* straight = vtkRectilinearGrid::SafeDownCast(block))
    {
      CheckStructure(
        straight->GetExtent(),
        [&](const double* sizes) { return CheckCoordinates(straight, sizes); }, path);
    }
    else if (vtkImageData* image = vtkImageData::SafeDownCast(block))
    {
      CheckStructure(
        image->GetExtent(), [](const double*) { return std::string(); }, path);
    }
    CheckArrays(block->GetPointData(), block->GetNumberOfPoints(), "point", path);
    CheckArrays(block->GetCellData(), block->GetNumberOfCells(), "cell", path);
  });
}
}
