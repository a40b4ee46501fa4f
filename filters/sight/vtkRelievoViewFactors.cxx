// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoViewFactors.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoMemory.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayScene.h"
#include "vtkTable.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

vtkStandardNewMacro(vtkRelievoViewFactors);

namespace
{
constexpr int Nothing = -1;
constexpr int Others = -2;
constexpr vtkIdType Batch = 8192; // rays at once

// The fronts of a group's cells, from which random rays begin.
struct Fronts
{
  struct Triangle
  {
    glm::dvec3 First, SideA, SideB, Normal;
  };
  std::vector<Triangle> Triangles;
  std::vector<double> Sums; // of their areas, up to and with each

  void Add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double size = glm::length(cross);
    if (size > 0.0 && std::isfinite(size))
    {
      this->Triangles.push_back({ a, b - a, c - a, cross / size });
      this->Sums.push_back(this->GetArea() + 0.5 * size);
    }
  }

  double GetArea() const { return this->Sums.empty() ? 0.0 : this->Sums.back(); }

  // A ray from a random place, by Lambert's law.
  template <typename Random>
  void Draw(Random& random, double before, glm::dvec3& origin, glm::dvec3& direction) const
  {
    // Not std::uniform_real_distribution, whose numbers depend on the library.
    const auto draw = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto at =
      std::upper_bound(this->Sums.begin(), this->Sums.end() - 1, draw() * this->GetArea());
    const Triangle& triangle = this->Triangles[static_cast<std::size_t>(at - this->Sums.begin())];
    double a = draw();
    double b = draw();
    if (a + b > 1.0)
    {
      a = 1.0 - a;
      b = 1.0 - b;
    }
    const glm::dvec3& normal = triangle.Normal;
    origin = triangle.First + a * triangle.SideA + b * triangle.SideB + before * normal;
    const glm::dvec3 across = glm::normalize(triangle.SideA);
    const glm::dvec3 along = glm::cross(normal, across);
    const double share = draw();
    const double turn = 2.0 * vtkMath::Pi() * draw();
    direction = std::sqrt(share) * (std::cos(turn) * across + std::sin(turn) * along) +
      std::sqrt(1.0 - share) * normal;
  }
};

// Wilson's interval of a share of `count` rays: half its width about its middle, and how far the
// share is from there, so that the share's error is below.
double GetBound(double share, double count)
{
  constexpr double deviations = 3.2905; // of the normal distribution, for 99.9 %
  const double scaled = deviations * deviations / count;
  const double half = deviations * std::sqrt(share * (1.0 - share) / count + 0.25 * scaled / count);
  return (half + scaled * std::abs(0.5 - share)) / (1.0 + scaled);
}
}

//------------------------------------------------------------------------------
vtkRelievoViewFactors::vtkRelievoViewFactors()
{
  this->SetNumberOfInputPorts(2);
  vtkRelievoParameterList& list = this->Parameters;
  list.AddText(
    "groups", [this] { return this->Groups; },
    [this](const std::string& name) { this->SetGroups(name.c_str()); },
    "The name of a cell array of the groups' numbers; negative: no group.");
  list.AddNumber(
    "tolerance", this->Tolerance, [this](double bound) { this->SetTolerance(bound); }, 0.0001, 0.2,
    "", "The largest bound of a factor's error.");
  list.AddWhole(
    "seed", this->Seed, [this](int seed) { this->SetSeed(seed); }, 0, VTK_INT_MAX, "",
    "Seed of the rays.");
}

//------------------------------------------------------------------------------
void vtkRelievoViewFactors::SetGroups(RELIEVO_TEXT name)
{
  const std::string text = name;
  if (text != this->Groups)
  {
    this->Groups = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoViewFactors::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoViewFactors::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkDataArray* groups = mesh->GetCellData()->GetArray(this->Groups.c_str());
  if (!groups || groups->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(
      "Groups: got " << this->Groups << ", expected the name of a cell array of one component.");
    return 1; // status 0 would make the executive print an internal error
  }
  const auto cells = static_cast<std::size_t>(mesh->GetNumberOfCells());
  const vtkIdType firstPolygon = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  std::vector<int> groupOf(cells, Others);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const double group = groups->GetComponent(static_cast<vtkIdType>(cell), 0);
    if (!(group <= VTK_INT_MAX && std::floor(group) == group))
    {
      vtkErrorMacro("Groups: got " << group << " for cell " << cell << ", expected whole numbers.");
      return 1;
    }
    groupOf[cell] = group < 0.0 ? Others : static_cast<int>(group);
  }
  std::map<int, Fronts> fronts;
  std::vector<glm::dvec3> normals(cells, glm::dvec3(0.0));
  vtkRelievoPolygonCut::ForEachTriangle(
    mesh,
    [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType polygon) {
      const auto cell = static_cast<std::size_t>(firstPolygon + polygon);
      glm::dvec3 corners[3];
      mesh->GetPoint(a, &corners[0].x);
      mesh->GetPoint(b, &corners[1].x);
      mesh->GetPoint(c, &corners[2].x);
      normals[cell] += glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      if (groupOf[cell] >= 0)
      {
        fronts[groupOf[cell]].Add(corners[0], corners[1], corners[2]);
      }
    },
    vtkRelievoPolygonCut::Rule::ByOutline);
  for (auto each = fronts.begin(); each != fronts.end();)
  {
    each = each->second.GetArea() > 0.0 ? std::next(each) : fronts.erase(each);
  }
  if (fronts.empty())
  {
    vtkErrorMacro(
      "Groups: no polygon has a group in " << this->Groups << ", expected numbers from 0.");
    return 1;
  }
  const auto pairs =
    static_cast<double>(fronts.size()) * (static_cast<double>(fronts.size()) + 2.0);
  constexpr double bytes = 2 * sizeof(int) + 3 * sizeof(double); // of a row
  const std::string lack = relievo::LackOfMemory(pairs * bytes, 0.0);
  if (!lack.empty())
  {
    vtkErrorMacro(<< fronts.size() << " groups: " << lack);
    return 1;
  }

  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(mesh);
  for (int i = 0; i < inputs[1]->GetNumberOfInformationObjects(); ++i)
  {
    scene->AddData(vtkDataSet::GetData(inputs[1], i));
  }
  scene->Update();
  const std::string fault = scene->GetFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return 1;
  }
  const double before = 1e-7 * mesh->GetLength();
  vtkNew<vtkIntArray> from, to;
  vtkNew<vtkDoubleArray> factors, bounds, areas;
  from->SetName("from");
  to->SetName("to");
  factors->SetName("factor");
  bounds->SetName("bound");
  areas->SetName("area");
  vtkNew<vtkDoubleArray> origins, directions;
  origins->SetNumberOfComponents(3);
  directions->SetNumberOfComponents(3);
  origins->SetNumberOfTuples(Batch);
  directions->SetNumberOfTuples(Batch);
  vtkNew<vtkTable> hits;
  std::size_t done = 0;
  for (const auto& [group, front] : fronts)
  {
    // A group's rays do not depend on the other groups.
    std::seed_seq seeds{ this->Seed, group };
    std::mt19937_64 random(seeds);
    std::map<int, vtkIdType> counts{ { Others, 0 }, { Nothing, 0 } };
    for (const auto& [other, unused] : fronts)
    {
      counts[other] = 0;
    }
    vtkIdType rays = 0;
    double largest = 1.0;
    while (largest > this->Tolerance)
    {
      for (vtkIdType i = 0; i < Batch; ++i)
      {
        glm::dvec3 origin, direction;
        front.Draw(random, before, origin, direction);
        origins->SetTuple(i, glm::value_ptr(origin));
        directions->SetTuple(i, glm::value_ptr(direction));
      }
      if (!scene->FindNearest(origins, directions, hits))
      {
        vtkErrorMacro("The rays were not followed; see the errors before.");
        return 1;
      }
      vtkDataArray* props = vtkDataArray::SafeDownCast(hits->GetColumnByName("prop"));
      vtkDataArray* hitCells = vtkDataArray::SafeDownCast(hits->GetColumnByName("cell"));
      for (vtkIdType i = 0; i < Batch; ++i)
      {
        const auto prop = static_cast<int>(props->GetComponent(i, 0));
        int at = prop < 0 ? Nothing : Others;
        if (prop == 0)
        {
          const auto cell = static_cast<std::size_t>(hitCells->GetComponent(i, 0));
          const glm::dvec3 direction = glm::make_vec3(directions->GetPointer(3 * i));
          at = glm::dot(direction, normals[cell]) < 0.0 ? groupOf[cell] : Others;
        }
        ++counts[at];
      }
      rays += Batch;
      largest = 0.0;
      for (const auto& [other, count] : counts)
      {
        largest = std::max(largest,
          GetBound(
            static_cast<double>(count) / static_cast<double>(rays), static_cast<double>(rays)));
      }
      // The bound falls with the root of the number of rays.
      const double share = std::min(1.0, std::pow(this->Tolerance / largest, 2.0));
      this->UpdateProgress(
        (static_cast<double>(done) + share) / static_cast<double>(fronts.size()));
      if (relievo::IsStopped(this))
      {
        relievo::Discard(outputs);
        return 1;
      }
    }
    ++done;
    for (const auto& [other, count] : counts)
    {
      const double share = static_cast<double>(count) / static_cast<double>(rays);
      from->InsertNextValue(group);
      to->InsertNextValue(other);
      factors->InsertNextValue(share);
      bounds->InsertNextValue(GetBound(share, static_cast<double>(rays)));
      areas->InsertNextValue(front.GetArea());
    }
  }
  vtkTable* output = vtkTable::GetData(outputs);
  for (vtkDataArray* column :
    std::initializer_list<vtkDataArray*>{ from, to, factors, bounds, areas })
  {
    output->AddColumn(column);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoViewFactors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
}
