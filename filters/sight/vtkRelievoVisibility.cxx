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
#include "vtkRelievoFreeSight.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayScene.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkRelievoVisibility);

namespace
{
constexpr vtkIdType RaysOfABatch = 1 << 19;

// Corners of a pixel lie in it: what is beyond may belong to another face of a panorama.
constexpr double Corner = 0.5 - 1e-7;

// Points beside a cell's corners, towards its middle.
constexpr double Inwards = 0.1;

// Cells below so many pixels have the solid angle of their triangles, larger ones that of the
// pixels that show them: a few pixels may be twice as large as the cell, or half.
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

// Solid angles of pixels, of those whose four corners are seen.
class PixelAngles
{
public:
  void Take(vtkRelievoCameraModel* camera, vtkIdType row, vtkIdType end)
  {
    const double signs[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    const vtkIdType columns = camera->GetSize()[0];
    vtkNew<vtkDoubleArray> corners;
    corners->SetNumberOfComponents(2);
    corners->SetNumberOfTuples(4 * columns * (end - row));
    for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
    {
      const vtkIdType pixel = i / 4;
      const double column = static_cast<double>(pixel % columns);
      corners->SetValue(2 * i, column + signs[i % 4][0] * Corner);
      corners->SetValue(
        2 * i + 1, static_cast<double>(row + pixel / columns) + signs[i % 4][1] * Corner);
    }
    vtkNew<vtkDoubleArray> origins;
    camera->GetRays(corners, origins, this->Directions);
  }

  double Get(vtkIdType i)
  {
    const double* d = this->Directions->GetPointer(12 * i);
    const double angle = GetSolidAngle(d, d + 3, d + 6) + GetSolidAngle(d, d + 6, d + 9);
    return std::isnan(angle) ? 0.0 : angle;
  }

private:
  vtkNew<vtkDoubleArray> Directions;
};

// What one camera sees of the mesh.
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
  {
    this->Places->SetNumberOfComponents(2);
    const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    vtkRelievoPolygonCut::ForEachTriangle(
      mesh,
      [this, first](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
        this->Triangles.push_back({ first + cell, { a, b, c } });
      },
      vtkRelievoPolygonCut::Rule::ByOutline);
  }

  vtkPolyData* Mesh;
  vtkRelievoRayScene* Scene;
  std::vector<vtkIdType> Pixels;
  std::vector<double> Angles;
  std::vector<int> CellsSeen;
  std::vector<int> PointsSeen;
  vtkPolyData* Cloud = nullptr;

  bool Add(vtkRelievoCameraModel* camera, int number)
  {
    this->Camera = camera;
    this->Met.assign(this->Pixels.size(), false);
    this->Shown.assign(this->Pixels.size(), 0.0);
    this->PixelsShown = 0;
    if (!this->AddPixels(number))
    {
      return false;
    }
    this->TakeAngles();
    if (!this->AddSmallCells() || !this->AddPoints())
    {
      return false;
    }
    for (std::size_t cell = 0; cell < this->Met.size(); ++cell)
    {
      this->CellsSeen[cell] += this->Met[cell] ? 1 : 0;
      this->Angles[cell] += this->Shown[cell];
    }
    return true;
  }

private:
  static constexpr vtkIdType Samples = 4; // of a triangle

  struct Triangle
  {
    vtkIdType Cell;
    vtkIdType Points[3];
  };

  std::vector<Triangle> Triangles;
  vtkRelievoCameraModel* Camera = nullptr;
  std::vector<bool> Met;     // cells, by this camera
  std::vector<double> Shown; // solid angles of cells, for this camera
  std::vector<bool> Large;   // cells whose solid angle is that of the pixels that show them
  vtkIdType PixelsShown = 0; // of the mesh, by this camera
  double PixelAngle = 0.0;   // their mean solid angle
  vtkNew<vtkDoubleArray> Places;
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;
  vtkNew<vtkTable> Hits;

  vtkDataArray* Get(const char* column)
  {
    return vtkDataArray::SafeDownCast(this->Hits->GetColumnByName(column));
  }

  // The mesh's cell that each place's ray meets first.
  bool Trace()
  {
    this->Camera->GetRays(this->Places, this->Origins, this->Directions);
    return this->Scene->FindNearest(this->Origins, this->Directions, this->Hits);
  }

  // Of a ray that met something, or -1.
  vtkIdType GetCell(vtkIdType ray)
  {
    return this->Get("prop")->GetComponent(ray, 0) == 0.0
      ? static_cast<vtkIdType>(this->Get("cell")->GetComponent(ray, 0))
      : -1;
  }

  bool AddPixels(int number)
  {
    const vtkIdType rows = this->Camera->GetSize()[1];
    const vtkIdType rowsAtOnce = std::max<vtkIdType>(1, RaysOfABatch / this->Camera->GetSize()[0]);
    PixelAngles angles;
    for (vtkIdType row = 0; row < rows; row += rowsAtOnce)
    {
      const vtkIdType end = std::min(rows, row + rowsAtOnce);
      angles.Take(this->Camera, row, end);
      this->Camera->GetRowRays(
        static_cast<int>(row), static_cast<int>(end), this->Origins, this->Directions);
      if (!this->Scene->FindNearest(this->Origins, this->Directions, this->Hits))
      {
        return false;
      }
      const vtkIdType count = this->Origins->GetNumberOfTuples();
      for (vtkIdType i = 0; i < count; ++i)
      {
        const vtkIdType cell = this->GetCell(i);
        if (cell < 0)
        {
          continue;
        }
        const auto at = static_cast<std::size_t>(cell);
        ++this->Pixels[at];
        ++this->PixelsShown;
        this->Shown[at] += angles.Get(i);
        this->Met[at] = true;
        if (this->Cloud)
        {
          this->AddToCloud(i, cell, number);
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

  // Places of points in the picture; false where there is none within it.
  bool FindPlace(const double point[3], double place[2])
  {
    const int* size = this->Camera->GetSize();
    double found[2];
    if (!this->Camera->Project(point, found) || found[0] < -0.5 || found[1] < -0.5 ||
      found[0] > size[0] - 0.5 || found[1] > size[1] - 0.5)
    {
      return false;
    }
    std::copy_n(found, 2, place);
    return true;
  }

  // Which of the cells that pixels show keep the solid angle of these pixels: that of the others is
  // found by points of theirs, as that of cells that no pixel's centre shows.
  void TakeAngles()
  {
    const double sum = std::accumulate(this->Shown.begin(), this->Shown.end(), 0.0);
    this->PixelAngle = this->PixelsShown > 0 ? sum / static_cast<double>(this->PixelsShown) : 0.0;
    std::vector<double> whole(this->Met.size(), 0.0);
    for (const Triangle& triangle : this->Triangles)
    {
      const auto at = static_cast<std::size_t>(triangle.Cell);
      if (this->Met[at])
      {
        whole[at] += this->GetWholeAngle(triangle);
      }
    }
    this->Large.assign(this->Met.size(), false);
    for (std::size_t cell = 0; cell < this->Met.size(); ++cell)
    {
      // Without an angle: it reaches to where the camera has no rays.
      this->Large[cell] =
        this->Met[cell] && !(whole[cell] < SmallPixels * this->PixelAngle && whole[cell] > 0.0);
      this->Shown[cell] = this->Large[cell] ? this->Shown[cell] : 0.0;
    }
  }

  // Cells that no pixel's centre shows, and small ones, by points of each of their triangles.
  bool AddSmallCells()
  {
    std::vector<const Triangle*> asked; // four places each
    this->Places->Reset();
    for (const Triangle& triangle : this->Triangles)
    {
      if (!this->Large[static_cast<std::size_t>(triangle.Cell)])
      {
        asked.push_back(&triangle);
        this->AddSamples(triangle);
      }
      const bool last = &triangle == &this->Triangles.back();
      if (!asked.empty() && (last || this->Places->GetNumberOfTuples() >= RaysOfABatch))
      {
        if (!this->TraceSamples(asked))
        {
          return false;
        }
        asked.clear();
        this->Places->Reset();
      }
    }
    return true;
  }

  void AddSamples(const Triangle& triangle)
  {
    double corners[3][3];
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      this->Mesh->GetPoint(triangle.Points[k], corners[k]);
      for (int i = 0; i < 3; ++i)
      {
        middle[i] += corners[k][i] / 3.0;
      }
    }
    for (int k = -1; k < 3; ++k)
    {
      double point[3] = { middle[0], middle[1], middle[2] };
      for (int i = 0; i < 3 && k >= 0; ++i)
      {
        point[i] = corners[k][i] + Inwards * (middle[i] - corners[k][i]);
      }
      double place[2] = { vtkMath::Nan(), vtkMath::Nan() }; // no ray
      this->FindPlace(point, place);
      this->Places->InsertNextTuple(place);
    }
  }

  bool TraceSamples(const std::vector<const Triangle*>& asked)
  {
    if (!this->Trace())
    {
      return false;
    }
    for (std::size_t k = 0; k < asked.size(); ++k)
    {
      const Triangle& triangle = *asked[k];
      int seen = 0;
      for (vtkIdType i = 0; i < Samples; ++i)
      {
        seen += this->GetCell(Samples * static_cast<vtkIdType>(k) + i) == triangle.Cell ? 1 : 0;
      }
      if (seen > 0)
      {
        const auto at = static_cast<std::size_t>(triangle.Cell);
        this->Met[at] = true;
        // A large cell that no pixel's centre shows is seen in a strip narrower than a pixel.
        const double most =
          this->PixelAngle > 0.0 ? SmallPixels * this->PixelAngle : vtkMath::Inf();
        this->Shown[at] += std::min(most, this->GetWholeAngle(triangle) * seen / Samples);
      }
    }
    return true;
  }

  // From where the camera's rays to the corners begin; 0 if it has no rays to one of them.
  double GetWholeAngle(const Triangle& triangle)
  {
    double directions[3][3];
    for (int k = 0; k < 3; ++k)
    {
      double place[2];
      double origin[3];
      if (!this->Camera->Project(this->Mesh->GetPoint(triangle.Points[k]), place) ||
        !this->Camera->GetRay(place[0], place[1], origin, directions[k]))
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
    for (vtkIdType point = 0; point < this->Mesh->GetNumberOfPoints(); ++point)
    {
      double place[2];
      if (this->FindPlace(this->Mesh->GetPoint(point), place))
      {
        this->Places->InsertNextTuple(place);
        points.push_back(point);
      }
      const bool last = point + 1 == this->Mesh->GetNumberOfPoints();
      if (!points.empty() && (last || static_cast<vtkIdType>(points.size()) >= RaysOfABatch))
      {
        if (!this->Trace())
        {
          return false;
        }
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          const auto ray = static_cast<vtkIdType>(i);
          const bool free = vtkRelievoIsFree(this->Get("distance")->GetComponent(ray, 0),
            this->Origins->GetPointer(3 * ray), this->Mesh->GetPoint(points[i]));
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
    return 1; // of a 0 the executive speaks in words of code
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
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* cloud = vtkPolyData::GetData(outputs, 1);
  const vtkSmartPointer<vtkRelievoRayScene> scene = MakeScene(inputs);
  Sight sight(mesh, scene);
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
