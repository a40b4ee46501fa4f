// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVisibility.h"

#include "vtkCellArray.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoCubeFaces.h"
#include "vtkRelievoFreeSight.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoReturns.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoTriangleSight.h"
#include "vtkTable.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

vtkStandardNewMacro(vtkRelievoVisibility);

namespace
{
constexpr vtkIdType RaysOfABatch = 1 << 15; // their hits fit into caches, and memory is reused
constexpr vtkIdType TrianglesOfAThread = 1024;

// A pixel's corners are moved slightly inwards: the corner itself may belong to another face of a
// panorama.
constexpr double Corner = 0.5 - 1e-7;

// Distance of sample points from a cell's corners, towards its middle.
constexpr double Inwards = 0.1;

// Cells smaller than this many pixels have the solid angle of their triangles, larger ones that of
// their pixels: a few pixels may be twice or half as large as the cell.
constexpr double SmallPixels = 8.0;

// The solid angle of three unit directions.
double GetSolidAngle(const double a[3], const double b[3], const double c[3])
{
  double cross[3];
  vtkMath::Cross(b, c, cross);
  const double volume = std::abs(vtkMath::Dot(a, cross));
  return 2.0 *
    std::atan2(volume, 1.0 + vtkMath::Dot(a, b) + vtkMath::Dot(b, c) + vtkMath::Dot(c, a));
}

// Solid angles of pixels whose four corners have rays.
class PixelAngles
{
public:
  // For pixels with these numbers, counted from the left of the row.
  void Take(vtkRelievoCameraModel* camera, vtkIdType row, const std::vector<vtkIdType>& pixels)
  {
    const double signs[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    const vtkIdType columns = camera->GetSize()[0];
    this->Corners->SetNumberOfComponents(2);
    this->Corners->SetNumberOfTuples(4 * static_cast<vtkIdType>(pixels.size()));
    double* corner = this->Corners->GetPointer(0);
    for (const vtkIdType pixel : pixels)
    {
      for (const auto& sign : signs)
      {
        *corner++ = static_cast<double>(pixel % columns) + sign[0] * Corner;
        *corner++ = static_cast<double>(row + pixel / columns) + sign[1] * Corner;
      }
    }
    camera->GetRays(this->Corners, this->Origins, this->Directions);
  }

  double Get(std::size_t i)
  {
    const double* d = this->Directions->GetPointer(12 * static_cast<vtkIdType>(i));
    const double angle = GetSolidAngle(d, d + 3, d + 6) + GetSolidAngle(d, d + 6, d + 9);
    return std::isnan(angle) ? 0.0 : angle;
  }

private:
  vtkNew<vtkDoubleArray> Corners;
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;
};

// The views of a central camera that are evaluated without rays: its picture, or all directions.
std::vector<vtkRelievoTriangleSight::View> GetViews(
  vtkRelievoCameraModel* camera, const glm::dvec3& sceneCenter)
{
  constexpr int steps = 64; // of each side of the picture
  constexpr double narrow =
    0.3; // cosine between the viewing direction and the farthest visible one
  constexpr double beyond = 1.01; // margin around the visible part
  const double* rotation = camera->GetRotation();
  const glm::dmat3 axes = glm::make_mat3(rotation); // columns: right, down and ahead
  const glm::dvec3 from = -(axes * glm::make_vec3(camera->GetTranslation()));
  vtkRelievoTriangleSight::View view;
  view.From = from - sceneCenter;
  std::copy_n(&axes[0], 3, view.Axes);
  view.Low = glm::dvec2(std::numeric_limits<double>::max());
  view.High = -view.Low;
  double ahead = 1.0;
  const double columns = camera->GetSize()[0];
  const double rows = camera->GetSize()[1];
  for (int i = 0; i <= steps; ++i)
  {
    const double u = columns * i / steps - 0.5;
    const double v = rows * i / steps - 0.5;
    const double places[4][2] = { { u, -0.5 }, { u, rows - 0.5 }, { -0.5, v },
      { columns - 0.5, v } };
    for (const auto& place : places)
    {
      double origin[3];
      glm::dvec3 d;
      const bool isSeen = camera->GetCameraRay(place[0], place[1], origin, &d.x);
      ahead = isSeen ? std::min(ahead, d.z) : -1.0;
      view.Low = glm::min(view.Low, glm::dvec2(d) / d.z);
      view.High = glm::max(view.High, glm::dvec2(d) / d.z);
    }
  }
  const glm::dvec2 middle = 0.5 * (view.Low + view.High);
  if (ahead > narrow && vtkRelievoLensCamera::SafeDownCast(camera))
  {
    view.Low = middle + beyond * (view.Low - middle);
    view.High = middle + beyond * (view.High - middle);
    return { view };
  }
  std::vector<vtkRelievoTriangleSight::View> views;
  view.Low = glm::dvec2(-beyond);
  view.High = glm::dvec2(beyond);
  for (const auto& face : relievo::CubeAxes)
  {
    for (int i = 0; i < 3; ++i)
    {
      view.Axes[i] = glm::dvec3(face[i][0], face[i][1], face[i][2]);
    }
    views.push_back(view);
  }
  return views;
}

// The part of the mesh that one camera sees.
class Sight
{
public:
  Sight(vtkPolyData* mesh, vtkRelievoRayScene* scene)
    : Mesh(mesh)
    , Scene(scene)
    , Pixels(static_cast<std::size_t>(mesh->GetNumberOfCells()))
    , Angles(Pixels.size())
    , CellsSeen(Pixels.size())
    , PointsSeen(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
    , Hit(Pixels.size(), 0)
    , Large(Pixels.size(), 0)
    , Shown(Pixels.size(), 0.0)
  {
    this->Places->SetNumberOfComponents(2);
    const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    vtkRelievoPolygonCut::ForEachTriangle(
      mesh,
      [this, first](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
        this->Triangles.push_back({ first + cell, { a, b, c } });
      },
      vtkRelievoPolygonCut::Rule::ByOutline);
    this->Points->SetNumberOfComponents(3);
    this->Points->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      mesh->GetPoint(i, this->Points->GetPointer(3 * i));
    }
  }

  vtkPolyData* Mesh;
  vtkRelievoRayScene* Scene;
  std::vector<vtkIdType> Pixels;
  std::vector<double> Angles;
  std::vector<int> CellsSeen;
  std::vector<int> PointsSeen;
  vtkPolyData* Cloud = nullptr;

  // The cells and points that are computed, others stay 0; by default all. Pixels' rays hit all
  // cells nevertheless: a pixel's mean solid angle needs them.
  std::array<std::size_t, 2> CellShare = { 0, Pixels.size() };
  std::array<std::size_t, 2> PointShare = { 0, PointsSeen.size() };

  bool Add(vtkRelievoCameraModel* camera, int number)
  {
    this->Camera = camera;
    auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
    this->IsPinhole = lens && lens->GetLens() == vtkRelievoLensCamera::PINHOLE;
    this->Returns.emplace(this->Scene, camera);
    this->PixelsShown = 0;
    this->ForgetCells(); // of a camera that failed
    if (!this->AddPixels(number))
    {
      return false;
    }
    this->Look();
    this->TakeCorners();
    this->TakeAngles();
    if (!this->AddSmallCells() || !this->AddPoints())
    {
      return false;
    }
    for (const std::size_t cell : this->CellsHit)
    {
      if (this->IsInShare(cell))
      {
        ++this->CellsSeen[cell];
        this->Angles[cell] += this->Shown[cell];
      }
    }
    this->ForgetCells();
    return true;
  }

private:
  using State = vtkRelievoTriangleSight::State;
  static constexpr int Samples = vtkRelievoTriangleSight::Samples;

  struct Triangle
  {
    vtkIdType Cell;
    vtkIdType Points[3];
  };

  std::vector<Triangle> Triangles;
  vtkNew<vtkDoubleArray> Points;                  // of the mesh
  std::unique_ptr<vtkRelievoTriangleSight> Quick; // finds visible parts without rays
  std::vector<int> QuickTriangles;                // index in Quick, by Triangles; -1: none
  std::vector<std::int64_t> QuickCorners;         // index in Quick, by the mesh's points; -1: none
  bool IsQuick = false;                           // for this camera
  vtkRelievoCameraModel* Camera = nullptr;
  bool IsPinhole = false;
  std::optional<vtkRelievoReturns> Returns; // of this camera
  std::vector<char> Hit;                    // whether cells are, by this camera
  std::vector<std::size_t> CellsHit;        // those that are
  std::vector<char> Large;                  // whether cells' solid angle is that of their pixels
  std::vector<double> Shown;                // solid angles of cells, for this camera
  vtkIdType PixelsShown = 0;                // of the mesh, by this camera
  double PixelAngle = 0.0;                  // mean solid angle of these pixels
  // Of the mesh's points: places in the picture and directions of rays; no values for hidden ones.
  enum class Corner : char
  {
    Outside, // the picture, or close to its border
    Within,
    Hidden
  };
  std::vector<Corner> Corners = std::vector<Corner>(PointsSeen.size());
  std::vector<double> PointPlaces = std::vector<double>(2 * PointsSeen.size());
  std::vector<double> PointDirections = std::vector<double>(3 * PointsSeen.size());
  vtkNew<vtkDoubleArray> Places;
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;
  vtkNew<vtkTable> Hits;

  void ForgetCells()
  {
    for (const std::size_t cell : this->CellsHit)
    {
      this->Hit[cell] = 0;
      this->Large[cell] = 0;
      this->Shown[cell] = 0.0;
    }
    this->CellsHit.clear();
  }

  vtkDataArray* Get(const char* column)
  {
    return vtkDataArray::SafeDownCast(this->Hits->GetColumnByName(column));
  }

  // The mesh's cells hit by rays; -1: none.
  class Cells
  {
  public:
    explicit Cells(vtkTable* hits)
      : Prop(vtkIntArray::SafeDownCast(hits->GetColumnByName("prop"))->GetPointer(0))
      , Cell(vtkIdTypeArray::SafeDownCast(hits->GetColumnByName("cell"))->GetPointer(0))
    {
    }
    vtkIdType Get(vtkIdType ray) const { return this->Prop[ray] == 0 ? this->Cell[ray] : -1; }

  private:
    const int* Prop;
    const vtkIdType* Cell;
  };

  bool FindHits()
  {
    if (!this->Scene->FindNearest(this->Origins, this->Directions, this->Hits))
    {
      return false;
    }
    this->Returns->LimitRange(this->Hits);
    return true;
  }

  // Finds the first hit of each position's ray.
  bool Trace()
  {
    this->Camera->GetRays(this->Places, this->Origins, this->Directions);
    return this->FindHits();
  }

  bool IsInShare(std::size_t cell) const
  {
    return cell >= this->CellShare[0] && cell < this->CellShare[1];
  }

  void AddHit(std::size_t cell)
  {
    if (!this->Hit[cell])
    {
      this->Hit[cell] = 1;
      this->CellsHit.push_back(cell);
    }
  }

  // The first of a cell's triangles, or one of a later cell, or the end.
  std::vector<Triangle>::const_iterator FindTriangles(vtkIdType cell) const
  {
    const auto begin = this->Triangles.begin();
    const auto end = this->Triangles.end();
    // If all polygons are triangles, the cell's triangle has its number.
    const vtkIdType last = static_cast<vtkIdType>(this->Triangles.size()) - 1;
    const auto it = begin + std::clamp<vtkIdType>(cell - begin->Cell, 0, last);
    if (it->Cell == cell && (it == begin || (it - 1)->Cell != cell))
    {
      return it;
    }
    return std::lower_bound(
      begin, end, cell, [](const Triangle& triangle, vtkIdType of) { return triangle.Cell < of; });
  }

  bool AddPixels(int number)
  {
    const vtkIdType rows = this->Camera->GetSize()[1];
    const vtkIdType rowsAtOnce = std::max<vtkIdType>(1, RaysOfABatch / this->Camera->GetSize()[0]);
    PixelAngles angles;
    std::vector<vtkIdType> shown; // rays that hit the mesh
    for (vtkIdType row = 0; row < rows; row += rowsAtOnce)
    {
      const vtkIdType end = std::min(rows, row + rowsAtOnce);
      this->Camera->GetRowRays(
        static_cast<int>(row), static_cast<int>(end), this->Origins, this->Directions);
      if (!this->FindHits())
      {
        return false;
      }
      const vtkIdType count = this->Origins->GetNumberOfTuples();
      const Cells cells(this->Hits);
      shown.clear();
      for (vtkIdType i = 0; i < count; ++i)
      {
        if (cells.Get(i) >= 0)
        {
          shown.push_back(i);
        }
      }
      angles.Take(this->Camera, row, shown);
      for (std::size_t i = 0; i < shown.size(); ++i)
      {
        const vtkIdType cell = cells.Get(shown[i]);
        const auto at = static_cast<std::size_t>(cell);
        this->Pixels[at] += this->IsInShare(at) ? 1 : 0;
        ++this->PixelsShown;
        this->Shown[at] += angles.Get(i);
        this->AddHit(at);
        if (this->Cloud)
        {
          this->AddToCloud(shown[i], cell, number);
        }
      }
    }
    return true;
  }

  void AddToCloud(vtkIdType ray, vtkIdType cell, int number)
  {
    vtkPointData* data = this->Cloud->GetPointData();
    this->Cloud->GetPoints()->InsertNextPoint(this->Get("position")->GetTuple(ray));
    vtkIntArray::SafeDownCast(data->GetArray("cell"))->InsertNextValue(static_cast<int>(cell));
    vtkIntArray::SafeDownCast(data->GetArray("camera"))->InsertNextValue(number);
    data->GetArray("normal")->InsertNextTuple(this->Get("geometric_normal")->GetTuple(ray));
  }

  // False for NaN; `room` is the distance in pixels from the border.
  bool IsInPicture(const double place[2], double room = 0.0) const
  {
    const int* size = this->Camera->GetSize();
    return place[0] >= room - 0.5 && place[1] >= room - 0.5 && place[0] <= size[0] - 0.5 - room &&
      place[1] <= size[1] - 0.5 - room;
  }

  // Computes the picture positions of the mesh's points, and the directions of their rays, except
  // those of points known to be hidden: few triangles at these need them.
  void TakeCorners()
  {
    constexpr double room = 1e-6; // of pixels, for rounding
    vtkRelievoForAll(this->Points->GetNumberOfTuples(), [this](vtkIdType i) {
      const auto at = static_cast<std::size_t>(i);
      this->Corners[at] = Corner::Hidden;
      if (this->GetState(i) != State::Hidden)
      {
        double* place = this->PointPlaces.data() + 2 * at;
        this->ComputeCorner(i, place, this->PointDirections.data() + 3 * at);
        this->Corners[at] = this->IsInPicture(place, room) ? Corner::Within : Corner::Outside;
      }
    });
  }

  void ComputeCorner(vtkIdType point, double place[2], double direction[3]) const
  {
    double origin[3];
    this->Camera->Project(this->Points->GetPointer(3 * point), place);
    this->Camera->GetRay(place[0], place[1], origin, direction);
  }

  void GetDirection(vtkIdType point, double direction[3]) const
  {
    const auto at = static_cast<std::size_t>(point);
    if (this->Corners[at] == Corner::Hidden)
    {
      double place[2];
      this->ComputeCorner(point, place, direction);
      return;
    }
    std::copy_n(this->PointDirections.data() + 3 * at, 3, direction);
  }

  // Selects the cells that keep the solid angle of their pixels. The solid angles of other cells
  // are computed from sample points, as for cells that no pixel's centre hits.
  void TakeAngles()
  {
    // In the order of cells, on which the rounding of the sum depends.
    std::sort(this->CellsHit.begin(), this->CellsHit.end());
    const double sum = std::accumulate(this->CellsHit.begin(), this->CellsHit.end(), 0.0,
      [this](double before, std::size_t cell) { return before + this->Shown[cell]; });
    this->PixelAngle = this->PixelsShown > 0 ? sum / static_cast<double>(this->PixelsShown) : 0.0;
    for (const std::size_t cell : this->CellsHit)
    {
      const auto number = static_cast<vtkIdType>(cell);
      double whole = 0.0;
      for (auto it = this->FindTriangles(number); it != this->Triangles.end() && it->Cell == number;
           ++it)
      {
        whole += this->GetWholeAngle(*it);
      }
      // A whole angle of 0 means that the cell reaches to where the camera has no rays.
      this->Large[cell] = !(whole < SmallPixels * this->PixelAngle && whole > 0.0);
      this->Shown[cell] = this->Large[cell] ? this->Shown[cell] : 0.0;
    }
  }

  // Sample points of a triangle: its middle, and one near each corner.
  static vtkRelievoTriangleSight::Weights GetWeights()
  {
    vtkRelievoTriangleSight::Weights weights;
    weights.fill(glm::dvec3(Inwards / 3.0));
    weights[0] = glm::dvec3(1.0 / 3.0);
    for (int k = 0; k < 3; ++k)
    {
      weights[static_cast<std::size_t>(k) + 1][k] += 1.0 - Inwards;
    }
    return weights;
  }

  // Prepares the search without rays; false if it is not possible.
  bool PrepareQuick()
  {
    if (this->Quick)
    {
      return true;
    }
    this->Scene->Update();
    const vtkRelievoRayTree& tree = this->Scene->GetTree();
    if (tree.GetNumberOfPlaces() == 0 || tree.GetMesh(0) != 0 || this->Triangles.empty())
    {
      return false; // no triangle of the mesh is in the tree
    }
    this->Quick = std::make_unique<vtkRelievoTriangleSight>(tree, 0, GetWeights());
    const vtkRelievoMeshTree& mesh = tree.GetMeshTree(0);
    this->QuickTriangles.assign(this->Triangles.size(), -1);
    for (int i = 0; i < mesh.GetNumberOfTriangles(); ++i)
    {
      const vtkIdType cell = mesh.GetCell(i);
      auto it = this->FindTriangles(cell);
      for (; it != this->Triangles.end() && it->Cell == cell; ++it)
      {
        if (it->Points[0] == mesh.GetPoint(i, 0) && it->Points[1] == mesh.GetPoint(i, 1) &&
          it->Points[2] == mesh.GetPoint(i, 2))
        {
          this->QuickTriangles[static_cast<std::size_t>(it - this->Triangles.begin())] = i;
        }
      }
    }
    const vtkRelievoStoredArray<std::uint32_t>& points = mesh.GetPoints();
    this->QuickCorners.assign(this->PointsSeen.size(), -1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->QuickCorners[points[i]] = static_cast<std::int64_t>(i);
    }
    return true;
  }

  // Finds everything that needs no rays.
  void Look()
  {
    this->IsQuick = this->Camera->IsCentral() && this->PrepareQuick();
    if (!this->IsQuick)
    {
      return;
    }
    double largest = 0.0;
    for (const double* values : { this->Mesh->GetBounds(), this->Camera->GetTranslation() })
    {
      const int count = values == this->Camera->GetTranslation() ? 3 : 6;
      for (int i = 0; i < count; ++i)
      {
        largest = std::max(largest, std::abs(values[i]));
      }
    }
    this->Quick->Clear();
    for (auto& view : GetViews(this->Camera, this->Scene->GetTree().GetCenter()))
    {
      view.Rounding = std::numeric_limits<double>::epsilon() * largest;
      this->Quick->Look(view);
    }
  }

  // Bits of a triangle's points known to be in this state.
  unsigned GetSamples(std::size_t triangle, State state) const
  {
    const int quick = this->IsQuick ? this->QuickTriangles[triangle] : -1;
    return quick < 0 ? 0 : this->Quick->GetSamples(quick, state);
  }

  State GetState(vtkIdType point) const
  {
    const std::int64_t quick =
      this->IsQuick ? this->QuickCorners[static_cast<std::size_t>(point)] : -1;
    return quick < 0 ? State::Unknown : this->Quick->GetCorner(static_cast<std::size_t>(quick));
  }

  // Adds small cells, and those that no pixel's centre hits, by sample points of their triangles.
  bool AddSmallCells()
  {
    const auto count = static_cast<vtkIdType>(this->Triangles.size());
    std::vector<unsigned char> seen(this->Triangles.size(), 0);  // number of points per triangle
    std::vector<unsigned char> asked(this->Triangles.size(), 0); // bits
    vtkRelievoWithThreads([&] {
      vtkSMPTools::For(0, count, TrianglesOfAThread, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->JudgeSamples(static_cast<std::size_t>(i), seen, asked);
        }
      });
    });
    std::vector<std::size_t> triangles; // of Places
    this->Places->Reset();
    const auto trace = [&] {
      if (!triangles.empty() && !this->Trace())
      {
        return false;
      }
      for (std::size_t k = 0; k < triangles.size(); ++k)
      {
        const vtkIdType hit = Cells(this->Hits).Get(static_cast<vtkIdType>(k));
        seen[triangles[k]] += hit == this->Triangles[triangles[k]].Cell ? 1 : 0;
      }
      triangles.clear();
      this->Places->Reset();
      return true;
    };
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      for (unsigned bits = asked[i]; bits != 0; bits &= bits - 1)
      {
        double place[2];
        if (this->FindPlace(this->Triangles[i], vtkRelievoGetLowest(bits), place))
        {
          this->Places->InsertNextTuple(place);
          triangles.push_back(i);
        }
      }
      if (this->Places->GetNumberOfTuples() >= RaysOfABatch && !trace())
      {
        return false;
      }
    }
    if (!trace())
    {
      return false;
    }
    // A large cell that no pixel's centre hits is visible in a strip narrower than a pixel.
    const double most = this->PixelAngle > 0.0 ? SmallPixels * this->PixelAngle : vtkMath::Inf();
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      if (seen[i] > 0)
      {
        const auto at = static_cast<std::size_t>(this->Triangles[i].Cell);
        this->AddHit(at);
        this->Shown[at] +=
          std::min(most, this->GetWholeAngle(this->Triangles[i]) * seen[i] / Samples);
      }
    }
    return true;
  }

  // Counts a triangle's visible sample points, and marks those that need rays.
  void JudgeSamples(
    std::size_t number, std::vector<unsigned char>& seen, std::vector<unsigned char>& asked)
  {
    const Triangle& triangle = this->Triangles[number];
    const auto cell = static_cast<std::size_t>(triangle.Cell);
    if (this->Large[cell] || !this->IsInShare(cell))
    {
      return;
    }
    const unsigned all = (1u << Samples) - 1u;
    const unsigned known = this->GetSamples(number, State::Seen);
    asked[number] =
      static_cast<unsigned char>(all & ~(known | this->GetSamples(number, State::Hidden)));
    if (known == 0)
    {
      return;
    }
    if (known == all && this->IsWithin(triangle))
    {
      seen[number] = Samples;
      return;
    }
    for (int sample = 0; sample < Samples; ++sample)
    {
      double place[2];
      seen[number] += (known >> sample & 1) && this->FindPlace(triangle, sample, place) ? 1 : 0;
    }
  }

  // Whether a triangle's points are in the picture because its corners are, which holds for a
  // pinhole camera.
  bool IsWithin(const Triangle& triangle) const
  {
    return this->IsPinhole &&
      std::all_of(triangle.Points, triangle.Points + 3, [this](vtkIdType point) {
        return this->Corners[static_cast<std::size_t>(point)] == Corner::Within;
      });
  }

  // The picture position of a triangle's sample point; false if it is outside the picture.
  bool FindPlace(const Triangle& triangle, int sample, double place[2])
  {
    const double* corners[3];
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Points->GetPointer(3 * triangle.Points[k]);
      for (int i = 0; i < 3; ++i)
      {
        middle[i] += corners[k][i] / 3.0;
      }
    }
    double point[3] = { middle[0], middle[1], middle[2] };
    for (int i = 0; i < 3 && sample > 0; ++i)
    {
      const double corner = corners[sample - 1][i];
      point[i] = corner + Inwards * (middle[i] - corner);
    }
    return this->Camera->Project(point, place) && this->IsInPicture(place);
  }

  // The solid angle spanned by the rays to the corners; 0 if a corner has no ray.
  double GetWholeAngle(const Triangle& triangle)
  {
    double directions[3][3];
    for (int k = 0; k < 3; ++k)
    {
      this->GetDirection(triangle.Points[k], directions[k]);
      if (std::isnan(directions[k][0]))
      {
        return 0.0;
      }
    }
    return GetSolidAngle(directions[0], directions[1], directions[2]);
  }

  bool AddPoints()
  {
    std::vector<vtkIdType> points; // of Places
    this->Places->Reset();
    const auto end = static_cast<vtkIdType>(this->PointShare[1]);
    for (auto point = static_cast<vtkIdType>(this->PointShare[0]); point < end; ++point)
    {
      const double* place = this->PointPlaces.data() + 2 * static_cast<std::size_t>(point);
      if (this->Corners[static_cast<std::size_t>(point)] != Corner::Hidden &&
        this->IsInPicture(place))
      {
        if (this->GetState(point) == State::Seen)
        {
          ++this->PointsSeen[static_cast<std::size_t>(point)];
        }
        else
        {
          this->Places->InsertNextTuple(place);
          points.push_back(point);
        }
      }
      const bool last = point + 1 == end;
      if (!points.empty() && (last || static_cast<vtkIdType>(points.size()) >= RaysOfABatch))
      {
        if (!this->Trace())
        {
          return false;
        }
        vtkDataArray* distances = this->Get("distance");
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          const auto ray = static_cast<vtkIdType>(i);
          const double* origin = this->Origins->GetPointer(3 * ray);
          const double* corner = this->Points->GetPointer(3 * points[i]);
          const bool free = vtkRelievoIsFree(distances->GetComponent(ray, 0), origin, corner) &&
            this->Returns->IsInRange(std::sqrt(vtkMath::Distance2BetweenPoints(origin, corner)));
          this->PointsSeen[static_cast<std::size_t>(points[i])] += free ? 1 : 0;
        }
        points.clear();
        this->Places->Reset();
      }
    }
    return true;
  }
};

template <typename Array, typename Values>
void AddArray(vtkFieldData* data, const char* name, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

void PrepareCloud(vtkPolyData* cloud)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  cloud->SetPoints(points);
  for (const char* name : { "cell", "camera" })
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    cloud->GetPointData()->AddArray(array);
  }
  vtkNew<vtkFloatArray> normals;
  normals->SetName("normal");
  normals->SetNumberOfComponents(3);
  cloud->GetPointData()->AddArray(normals);
}

void AddVertices(vtkPolyData* cloud)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  cloud->SetVerts(vertices);
}
}

//------------------------------------------------------------------------------
vtkRelievoVisibility::vtkRelievoVisibility()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkRelievoVisibility::~vtkRelievoVisibility() = default;

//------------------------------------------------------------------------------
void vtkRelievoVisibility::AddCamera(vtkRelievoCameraModel* camera)
{
  if (!camera)
  {
    vtkErrorMacro("AddCamera was given no camera; give it a vtkRelievoCameraModel.");
    return;
  }
  this->Cameras.emplace_back(camera);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoVisibility::RemoveAllCameras()
{
  this->Cameras.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoVisibility::GetCamera(int i)
{
  return i < 0 || i >= this->GetNumberOfCameras()
    ? nullptr
    : this->Cameras[static_cast<std::size_t>(i)].Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoVisibility::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkRelievoCameraModel* camera : this->Cameras)
  {
    time = std::max(time, camera->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkRelievoVisibility::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  if (this->Cameras.empty())
  {
    vtkErrorMacro("There are no cameras; give it some by AddCamera.");
    return 1; // status 0 would make the executive print an internal error
  }
  for (vtkRelievoCameraModel* camera : this->Cameras)
  {
    if (!camera->HasPlaces())
    {
      vtkErrorMacro("A " << camera->GetClassName()
                         << " has no places for points in its picture; give cameras that have.");
      return 1;
    }
  }
  if (this->Cloud && this->GetNumberOfParts() > 1)
  {
    vtkErrorMacro(
      "The cloud has no parts, because its points belong to pixels; expected Cloud off.");
    return 1;
  }
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* cloud = vtkPolyData::GetData(outputs, 1);
  const vtkSmartPointer<vtkRelievoRayScene> scene = this->MakeScene(inputs);
  if (!scene)
  {
    return 1;
  }
  Sight sight(mesh, scene);
  sight.CellShare = this->GetShare(sight.Pixels.size());
  sight.PointShare = this->GetShare(sight.PointsSeen.size());
  if (this->Cloud)
  {
    PrepareCloud(cloud);
    sight.Cloud = cloud;
  }
  for (std::size_t i = 0; i < this->Cameras.size(); ++i)
  {
    if (!sight.Add(this->Cameras[i], static_cast<int>(i)))
    {
      vtkErrorMacro("The rays of camera " << i << " were not followed; see the errors before.");
      return 1;
    }
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(this->Cameras.size()));
    if (relievo::IsStopped(this))
    {
      relievo::Discard(outputs);
      return 1;
    }
  }
  output->ShallowCopy(mesh);
  AddArray<vtkIntArray>(output->GetCellData(), "seen", sight.CellsSeen);
  output->GetCellData()->SetActiveScalars("seen");
  AddArray<vtkIdTypeArray>(output->GetCellData(), "pixels", sight.Pixels);
  AddArray<vtkDoubleArray>(output->GetCellData(), "solid_angle", sight.Angles);
  AddArray<vtkIntArray>(output->GetPointData(), "seen", sight.PointsSeen);
  if (this->Cloud)
  {
    AddVertices(cloud);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cameras: " << this->Cameras.size() << "\n";
  os << indent << "Cloud: " << (this->Cloud ? "on" : "off") << "\n";
}
