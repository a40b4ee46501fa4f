// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetModels.h"

#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetObjects.h"
#include "Messages.h"

#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayScene.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;
using Point = std::array<double, 3>;

double GetSquare(const Point& a, const Point& b)
{
  const double between[3] = { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  return vtkMath::Dot(between, between);
}

// The largest distance of two points, within a relative tolerance, by a tree of boxes: pairs of
// boxes closer than the largest distance so far are skipped.
class Diameter
{
public:
  explicit Diameter(const std::vector<Point>& points)
    : Points(points)
  {
    if (points.empty())
    {
      return;
    }
    // Starts with the point farthest from the point farthest from the first.
    Point from = points[0];
    for (int i = 0; i < 2; ++i)
    {
      const Point previous = from;
      from = *std::max_element(
        points.begin(), points.end(), [&previous](const Point& a, const Point& b) {
          return GetSquare(previous, a) < GetSquare(previous, b);
        });
      this->Largest = std::max(this->Largest, GetSquare(previous, from));
    }
    this->Build(0, points.size());
    this->Search(0, 0);
  }

  double Get() const { return std::sqrt(this->Largest); }

private:
  static constexpr double Share = 1e-7;
  static constexpr std::size_t Few = 8; // points in a leaf

  struct Node
  {
    std::size_t First, End;
    vtkBoundingBox Box;
    std::size_t Halves[2]; // 0: a leaf
  };

  std::size_t Build(std::size_t first, std::size_t end)
  {
    Node node{ first, end, {}, { 0, 0 } };
    for (std::size_t i = first; i < end; ++i)
    {
      node.Box.AddPoint(this->Points[i][0], this->Points[i][1], this->Points[i][2]);
    }
    const std::size_t number = this->Nodes.size();
    this->Nodes.push_back(node);
    if (end - first > Few)
    {
      double lengths[3];
      node.Box.GetLengths(lengths);
      const auto axis = static_cast<std::size_t>(std::max_element(lengths, lengths + 3) - lengths);
      const std::size_t middle = first + (end - first) / 2;
      const auto at = [this](std::size_t i) {
        return this->Points.begin() + static_cast<std::ptrdiff_t>(i);
      };
      std::nth_element(at(first), at(middle), at(end),
        [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
      const std::size_t halves[2] = { this->Build(first, middle), this->Build(middle, end) };
      std::copy_n(halves, 2, this->Nodes[number].Halves);
    }
    return number;
  }

  // Upper bound of the squared distance between points of two nodes.
  double GetReach(std::size_t one, std::size_t other) const
  {
    const vtkBoundingBox& a = this->Nodes[one].Box;
    const vtkBoundingBox& b = this->Nodes[other].Box;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double along =
        std::max(a.GetMaxPoint()[i] - b.GetMinPoint()[i], b.GetMaxPoint()[i] - a.GetMinPoint()[i]);
      sum += along * along;
    }
    return sum;
  }

  void Search(std::size_t one, std::size_t other)
  {
    if (this->GetReach(one, other) <= this->Largest * (1.0 + Share))
    {
      return;
    }
    const Node& a = this->Nodes[one];
    const Node& b = this->Nodes[other];
    if (a.Halves[0] == 0 && b.Halves[0] == 0)
    {
      for (std::size_t i = a.First; i < a.End; ++i)
      {
        for (std::size_t k = b.First; k < b.End; ++k)
        {
          this->Largest = std::max(this->Largest, GetSquare(this->Points[i], this->Points[k]));
        }
      }
    }
    else if (b.Halves[0] == 0 || (a.Halves[0] != 0 && a.End - a.First >= b.End - b.First))
    {
      this->Search(a.Halves[0], other);
      this->Search(a.Halves[1], other);
    }
    else
    {
      this->Search(one, b.Halves[0]);
      this->Search(one, b.Halves[1]);
    }
  }

  std::vector<Point> Points;
  std::vector<Node> Nodes;
  double Largest = 0.0; // squared distance
};

struct Model
{
  std::vector<Point> Points; // millimetres
  std::vector<std::array<std::int32_t, 3>> Triangles;
};

// The triangles of a mesh in the world, in an object's axes.
void AddMesh(Model& model, vtkPolyData* mesh, const DatasetObject& object, double scale)
{
  double turn[9];
  double origin[3];
  GetRigidPose(object.Pose, turn, origin);
  std::map<vtkIdType, std::int32_t> known; // points used by triangles
  const auto add = [&](vtkIdType id) {
    const auto [place, isNew] = known.emplace(id, static_cast<std::int32_t>(model.Points.size()));
    if (isNew)
    {
      double point[3];
      mesh->GetPoint(id, point);
      Point own{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        double along = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
        {
          along += turn[3 * k + i] * (point[k] - origin[k]);
        }
        own[i] = scale * along;
      }
      model.Points.push_back(own);
    }
    return place->second;
  };
  vtkRelievoPolygonCut::ForEachTriangle(
    mesh, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
      model.Triangles.push_back({ add(a), add(b), add(c) });
    });
}

void AppendBytes(std::string& bytes, const void* values, std::size_t size)
{
  bytes.append(static_cast<const char*>(values), size);
}

// A binary, little-endian PLY file: Relievo is built only for little-endian machines.
std::string EncodePLY(const Model& model)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
    std::to_string(model.Points.size()) +
    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
    std::to_string(model.Triangles.size()) +
    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& point : model.Points)
  {
    AppendBytes(bytes, point.data(), sizeof(point));
  }
  for (const std::array<std::int32_t, 3>& triangle : model.Triangles)
  {
    bytes += static_cast<char>(triangle.size());
    AppendBytes(bytes, triangle.data(), sizeof(triangle));
  }
  return bytes;
}

Json DescribeModel(const Model& model)
{
  vtkBoundingBox box;
  for (const Point& point : model.Points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  const double* low = box.GetMinPoint();
  return { { "diameter", Diameter(model.Points).Get() }, { "min_x", low[0] }, { "min_y", low[1] },
    { "min_z", low[2] }, { "size_x", box.GetLength(0) }, { "size_y", box.GetLength(1) },
    { "size_z", box.GetLength(2) } };
}
}

//------------------------------------------------------------------------------
void WriteDatasetModels(
  const DatasetStyle& style, vtkRenderer* renderer, const DatasetObjects& objects)
{
  vtkNew<vtkRelievoRayScene> scene;
  const vtkNew<vtkCallbackCommand> silent; // an object without a mesh is reported below
  scene->AddObserver(vtkCommand::WarningEvent, silent);
  scene->SetRenderer(renderer);
  scene->Update();
  std::vector<Model> models(objects.Get().size());
  for (int i = 0; i < scene->GetNumberOfMeshes(); ++i)
  {
    const int object = objects.Find(scene->GetMeshProp(i), scene->GetMeshBlock(i));
    if (object >= 0)
    {
      const auto number = static_cast<std::size_t>(object);
      vtkNew<vtkPolyData> mesh;
      scene->CopyMesh(i, mesh);
      AddMesh(models[number], mesh, objects.Get()[number], style.MillimetersPerUnit);
    }
  }
  Json infos = Json::object();
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    if (models[i].Triangles.empty())
    {
      Messages::Warn(style.Folder + ": no model of " + objects.Get()[i].Name +
        ": rays cannot trace its triangles, or it has none");
      continue;
    }
    style.Write("models/obj_" + WriteDatasetNumber(i + 1) + ".ply", EncodePLY(models[i]));
    infos[std::to_string(i + 1)] = DescribeModel(models[i]);
  }
  style.Write("models/models_info.json", WriteDatasetJson(infos));
}
}
