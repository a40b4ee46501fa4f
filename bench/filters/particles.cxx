// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles on surfaces: time of a step by their number, and distance to the surface, held by depth
// maps, by the closest point (vtkStaticCellLocator), or not at all.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "FrameBench.h"
#include "Solids.h"
#include "Table.h"

#include <vtkDoubleArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoSurfaceParticles.h>
#include <vtkRelievoThreads.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;
using Particles = vtkRelievoSurfaceParticles;
using Places = std::vector<glm::dvec3>;

constexpr const char* Held = "depth maps";
constexpr const char* Peer = "closest point";
constexpr const char* Free = "not held";

struct Body
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh; // with the array "field"
};

// A rotation about a tilted axis through the middle; the fastest places move half a texel per step.
struct Field
{
  glm::dvec3 Middle;
  glm::dvec3 Turn;

  Field(vtkPolyData* mesh, int resolution)
  {
    double box[6];
    mesh->GetBounds(box);
    const double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
    this->Middle = { (box[0] + box[1]) / 2., (box[2] + box[3]) / 2., (box[4] + box[5]) / 2. };
    this->Turn = glm::normalize(glm::dvec3(0.4, 0.9, 0.3)) / static_cast<double>(resolution);
    this->Turn *= longest / glm::distance(glm::dvec3(box[0], box[2], box[4]), this->Middle) / 2.;
  }

  glm::dvec3 At(const glm::dvec3& place) const
  {
    return glm::cross(this->Turn, place - this->Middle);
  }
};

Body MakeBody(const std::string& name, vtkPolyData* mesh, int resolution)
{
  const Field field(mesh, resolution);
  vtkNew<vtkDoubleArray> array;
  array->SetName("field");
  array->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    mesh->GetPoint(i, &place.x);
    const glm::dvec3 value = field.At(place);
    array->InsertNextTuple(&value.x);
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  copy->GetPointData()->AddArray(array);
  return { name, copy };
}

vtkSmartPointer<Particles> MakeFilter(vtkPolyData* mesh, int count, int resolution)
{
  auto filter = vtkSmartPointer<Particles>::New();
  filter->SetInputData(mesh);
  filter->SetNumberOfParticles(count);
  filter->SetResolution(resolution);
  filter->SetFieldArray("field");
  filter->SetNumberOfSteps(1000000);
  filter->SetCheckpoints(0);
  filter->UpdateTimeStep(0.);
  return filter;
}

Places PlacesOf(Particles* filter)
{
  vtkPolyData* output = filter->GetOutput();
  Places places(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    output->GetPoint(static_cast<vtkIdType>(i), &places[i].x);
  }
  return places;
}

// Holds particles at the closest point of the mesh, with the field from its formula.
class ClosestPoints
{
public:
  ClosestPoints(const Body& body, int resolution)
    : Flow(body.Mesh, resolution)
  {
    // The farthest distance of a step.
    this->Near = 1.001 * 0.5 * body.Mesh->GetLength() / resolution;
    this->Locator->SetDataSet(body.Mesh);
    this->Locator->BuildLocator();
  }

  // One step; `distances`, if given, gets those of the positions before holding.
  void Step(Places& places, bool hold, std::vector<double>* distances = nullptr)
  {
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(
        0, static_cast<vtkIdType>(places.size()), 1024, [&](vtkIdType begin, vtkIdType end) {
          vtkNew<vtkGenericCell> cell;
          for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          {
            const glm::dvec3 from = places[i];
            if (distances)
            {
              (*distances)[i] = glm::distance(this->Closest(from, cell), from);
              continue;
            }
            const glm::dvec3 half = from + 0.5 * this->Flow.At(from);
            const glm::dvec3 to = from + this->Flow.At(hold ? this->Closest(half, cell) : half);
            places[i] = hold ? this->Closest(to, cell) : to;
          }
        });
    });
  }

private:
  glm::dvec3 Closest(const glm::dvec3& place, vtkGenericCell* cell)
  {
    glm::dvec3 closest(0.);
    glm::dvec3 from = place; // VTK takes no const pointer
    vtkIdType id = -1;
    int part = 0;
    int inside = 0;
    double distance2 = 0.;
    // Much faster than a global search, which is left for distant positions.
    if (!this->Locator->FindClosestPointWithinRadius(
          &from.x, this->Near, &closest.x, cell, id, part, distance2, inside))
    {
      this->Locator->FindClosestPoint(&from.x, &closest.x, cell, id, part, distance2);
    }
    return closest;
  }

  Field Flow;
  double Near = 0.;
  vtkNew<vtkStaticCellLocator> Locator;
};

void MeasureTimes(const Body& body, const ParticleSizes& sizes, Table& table)
{
  ClosestPoints peer(body, sizes.Resolution);
  for (const int count : sizes.Numbers)
  {
    const auto filter = MakeFilter(body.Mesh, count, sizes.Resolution);
    Places places = PlacesOf(filter);
    int step = 0;
    std::vector<Timed> works(count <= sizes.MostPeer ? 2 : 1);
    works[0].Work = [&]() { filter->UpdateTimeStep(++step); };
    if (works.size() > 1)
    {
      works[1].Work = [&]() { peer.Step(places, true); };
    }
    const std::vector<Timing> times = TimeInTurn(works, sizes.Rounds, 1);
    for (std::size_t i = 0; i < works.size(); ++i)
    {
      const double milliseconds = 1e3 * times[i].Median();
      // Core time, which other work on the machine changes less.
      constexpr int Again = 3;
      const std::clock_t begin = std::clock();
      for (int n = 0; n < Again; ++n)
      {
        works[i].Work();
      }
      const double cores = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / Again;
      const char* name = i == 0 ? Held : Peer;
      table.AddRow({ body.Name, std::to_string(body.Mesh->GetNumberOfPolys()), name,
        std::to_string(count), Number(milliseconds), Number(cores), Number(LoadAverage(), 2) });
      std::cout << body.Name << ", " << count << " particles, " << name << ": "
                << Number(milliseconds) << " ms a step, " << Number(cores) << " ms of cores"
                << std::endl;
    }
  }
}

void MeasureDrift(const Body& body, const ParticleSizes& sizes, Table& table)
{
  ClosestPoints peer(body, sizes.Resolution);
  const auto filter = MakeFilter(body.Mesh, sizes.DriftNumber, sizes.Resolution);
  const double texel = filter->GetUsedTexelSize();
  Places free = PlacesOf(filter);
  int step = 0;
  for (const int steps : sizes.Steps)
  {
    for (; step < steps; ++step)
    {
      peer.Step(free, false);
    }
    filter->UpdateTimeStep(step);
    for (const char* name : { Held, Free })
    {
      Places places = name == Held ? PlacesOf(filter) : free;
      std::vector<double> distances(places.size());
      peer.Step(places, true, &distances);
      double squares = 0.;
      for (const double distance : distances)
      {
        squares += distance * distance;
      }
      const double largest = *std::max_element(distances.begin(), distances.end()) / texel;
      const double rms = std::sqrt(squares / static_cast<double>(places.size())) / texel;
      table.AddRow({ body.Name, name, std::to_string(steps), std::to_string(places.size()),
        Number(largest), Number(rms) });
      std::cout << body.Name << ", " << steps << " steps, " << name << ": " << Number(largest)
                << " texels from the surface at most, rms " << Number(rms) << std::endl;
    }
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchParticles(const std::string& outDir, const ParticleSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table times(
    { "body", "triangles", "method", "particles", "milliseconds", "core milliseconds", "load" });
  Table drift({ "body", "method", "steps", "particles", "largest texels", "rms texels" });
  const relievoTest::Solid torus =
    relievoTest::MakeTorus(sizes.Chord, relievoTest::Turn({ 1., 0.3, 0.2 }, 37.));
  std::vector<Body> bodies = { MakeBody("torus", torus.Mesh, sizes.Resolution) };
  for (const std::string& name : sizes.Meshes)
  {
    if (const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name))
    {
      bodies.push_back(MakeBody(name, mesh, sizes.Resolution));
    }
  }
  for (const Body& body : bodies)
  {
    MeasureTimes(body, sizes, times);
    MeasureDrift(body, sizes, drift);
  }
  const bool written =
    times.WriteCsv(outDir + "/particles.csv") && drift.WriteCsv(outDir + "/particles-drift.csv");
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchParticles(const std::string& outDir)
{
  return relievoBench::BenchParticles(outDir, {});
}
