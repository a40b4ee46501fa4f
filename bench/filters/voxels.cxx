// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells inside bodies: excess and missed cells, against a formula, or against Embree by a vote of
// three rays, and their time, in turn with VTK's own methods.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "EmbreeScene.h"
#include "FrameBench.h"
#include "Solids.h"
#include "Table.h"
#include "VoxelTruth.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoDepthViews.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSelectEnclosedPoints.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#if __has_include(<vtkVoxelModeller.h>)
#include <vtkVoxelModeller.h>
#define RELIEVO_BENCH_MODELLER 1
#endif
#if __has_include(<vtkPolyDataToImageStencil.h>)
#include <vtkImageStencilToImage.h>
#include <vtkPolyDataToImageStencil.h>
#define RELIEVO_BENCH_STENCIL 1
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::InsideFunction;
using relievoTest::Solid;
using relievoTest::Timed;
using relievoTest::Timing;
using Shell = vtkRelievoVoxelShell;

struct Body
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh;
  InsideFunction IsInside;
};

// A method of converting the mesh to cells.
struct Way
{
  std::string Name;
  std::function<void()> Run;
  std::function<vtkDataArray*()> Cells; // not 0 inside, in the order of the grid's cells
};

// The grid shared by all methods.
struct Grid
{
  int Cells[3];
  double Origin[3];
  double Spacing = 0.;
  double Bounds[6];

  Grid(vtkPolyData* mesh, int longest)
  {
    mesh->GetBounds(this->Bounds);
    double length = 0.;
    for (int axis = 0; axis < 3; ++axis)
    {
      length = std::max(length, this->Bounds[2 * axis + 1] - this->Bounds[2 * axis]);
    }
    // Avoids the body's own symmetry planes.
    this->Spacing = 1.013 * length / longest;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Bounds[2 * axis];
      const double high = this->Bounds[2 * axis + 1];
      this->Cells[axis] = static_cast<int>(std::ceil((high - low) / this->Spacing));
      const double width = this->Cells[axis] * this->Spacing;
      this->Origin[axis] = (low + high - width) / 2.;
      this->Bounds[2 * axis] = this->Origin[axis];
      this->Bounds[2 * axis + 1] = this->Origin[axis] + width;
    }
  }
};

Way ShellWay(const std::string& name, vtkPolyData* mesh, const Grid& grid, int method)
{
  auto shell = vtkSmartPointer<Shell>::New();
  shell->SetInputData(mesh);
  shell->SetMethod(method);
  shell->SetBounds(grid.Bounds);
  shell->SetDimensions(grid.Cells);
  return { name,
    [shell]() {
      shell->Modified();
      shell->Update();
    },
    [shell]() { return shell->GetOutput()->GetCellData()->GetArray("mask"); } };
}

// The frame's view of the mesh as an actor.
Way DrawnWay(vtkPolyData* mesh, const Grid& grid)
{
  struct Scene
  {
    vtkNew<vtkRenderer> Renderer;
    vtkSmartPointer<vtkRenderWindow> Window;
    vtkNew<vtkRelievoDepthViews> Views;
    vtkNew<Shell> Cells;
  };
  auto scene = std::make_shared<Scene>();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene->Renderer->AddActor(actor);
  scene->Window = relievoTest::MakeWindow(320, 320, scene->Renderer);
  scene->Views->SetRenderer(scene->Renderer);
  scene->Views->SetBounds(grid.Bounds);
  scene->Views->SetTexelSize(grid.Spacing);
  scene->Cells->SetInputConnection(1, scene->Views->GetOutputPort());
  scene->Cells->SetBounds(grid.Bounds);
  scene->Cells->SetDimensions(grid.Cells);
  return { "six views, drawn", [scene]() { scene->Cells->Update(); },
    [scene]() { return scene->Cells->GetOutput()->GetCellData()->GetArray("mask"); } };
}

#ifdef RELIEVO_BENCH_STENCIL
Way StencilWay(vtkPolyData* mesh, const Grid& grid)
{
  auto stencil = vtkSmartPointer<vtkPolyDataToImageStencil>::New();
  stencil->SetInputData(mesh);
  const double half = grid.Spacing / 2.;
  stencil->SetOutputOrigin(grid.Origin[0] + half, grid.Origin[1] + half, grid.Origin[2] + half);
  stencil->SetOutputSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
  stencil->SetOutputWholeExtent(0, grid.Cells[0] - 1, 0, grid.Cells[1] - 1, 0, grid.Cells[2] - 1);
  stencil->SetTolerance(0.);
  auto image = vtkSmartPointer<vtkImageStencilToImage>::New();
  image->SetInputConnection(stencil->GetOutputPort());
  image->SetOutputScalarTypeToUnsignedChar();
  image->SetInsideValue(1.);
  image->SetOutsideValue(0.);
  return { "vtkPolyDataToImageStencil",
    [stencil, image]() {
      stencil->Modified();
      image->Update();
    },
    [image]() { return image->GetOutput()->GetPointData()->GetScalars(); } };
}
#endif

// Tests each cell's centre with a ray.
Way EnclosedWay(vtkPolyData* mesh, const Grid& grid)
{
  vtkNew<vtkImageData> centers;
  const double half = grid.Spacing / 2.;
  centers->SetDimensions(grid.Cells);
  centers->SetOrigin(grid.Origin[0] + half, grid.Origin[1] + half, grid.Origin[2] + half);
  centers->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
  auto enclosed = vtkSmartPointer<vtkSelectEnclosedPoints>::New();
  enclosed->SetInputData(centers);
  enclosed->SetSurfaceData(mesh);
  enclosed->SetTolerance(1e-9);
  return { "vtkSelectEnclosedPoints",
    [enclosed]() {
      enclosed->Modified();
      enclosed->Update();
    },
    [enclosed]() { return enclosed->GetOutput()->GetPointData()->GetArray("SelectedPoints"); } };
}

#ifdef RELIEVO_BENCH_MODELLER
Way ModellerWay(vtkPolyData* mesh, const Grid& grid)
{
  auto modeller = vtkSmartPointer<vtkVoxelModeller>::New();
  modeller->SetInputData(mesh);
  const double half = grid.Spacing / 2.;
  modeller->SetModelBounds(grid.Bounds[0] + half, grid.Bounds[1] - half, grid.Bounds[2] + half,
    grid.Bounds[3] - half, grid.Bounds[4] + half, grid.Bounds[5] - half);
  modeller->SetSampleDimensions(grid.Cells[0], grid.Cells[1], grid.Cells[2]);
  // By default, each triangle visits all cells.
  modeller->SetMaximumDistance(0.9 / *std::max_element(grid.Cells, grid.Cells + 3));
  modeller->SetScalarTypeToUnsignedChar();
  return { "vtkVoxelModeller",
    [modeller]() {
      modeller->Modified();
      modeller->Update();
    },
    [modeller]() { return modeller->GetOutput()->GetPointData()->GetScalars(); } };
}
#endif

struct Errors
{
  double Excess = 0.; // share of the cells that are inside
  double Missed = 0.;
};

Errors Compare(const std::vector<unsigned char>& truth, vtkDataArray* cells)
{
  double inside = 0.;
  double excess = 0.;
  double missed = 0.;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const bool found = cells->GetComponent(static_cast<vtkIdType>(i), 0) != 0.;
    inside += truth[i];
    excess += found && !truth[i] ? 1. : 0.;
    missed += !found && truth[i] ? 1. : 0.;
  }
  return { excess / inside, missed / inside };
}

std::vector<Body> Bodies(const std::vector<std::string>& meshes, double chord)
{
  const glm::dmat3 tilted = relievoTest::Turn({ 1., 0.3, 0.2 }, 37.);
  const glm::dmat3 onEdge = relievoTest::Turn({ 1., 0.02, 0.03 }, 90.);
  std::vector<Body> bodies;
  for (const Solid& solid : { relievoTest::MakeBall(chord), relievoTest::MakeTorus(chord, onEdge),
         relievoTest::MakeHollowBall(chord), relievoTest::MakeBowl(chord, tilted) })
  {
    const auto distance = solid.DistanceAt;
    bodies.push_back({ solid.Name, solid.Mesh,
      [distance](const glm::dvec3& place) { return distance(place) < 0.; } });
  }
  for (const std::string& name : meshes)
  {
    if (const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name))
    {
      auto scene = std::make_shared<relievoTest::EmbreeScene>();
      scene->AddActor(mesh);
      bodies.push_back({ name, mesh,
        [scene](const glm::dvec3& place) { return relievoTest::IsInsideByVote(*scene, place); } });
    }
  }
  return bodies;
}

void Measure(const Body& body, int size, int rounds, bool compare, bool withSlow, Table& table)
{
  const Grid grid(body.Mesh, size);
  std::vector<Way> ways = { ShellWay("two views", body.Mesh, grid, Shell::TWO_VIEWS),
    ShellWay("six views", body.Mesh, grid, Shell::SIX_VIEWS), DrawnWay(body.Mesh, grid),
    ShellWay("parity", body.Mesh, grid, Shell::PARITY) };
#ifdef RELIEVO_BENCH_STENCIL
  ways.push_back(StencilWay(body.Mesh, grid));
#endif
  if (withSlow) // a ray per cell: minutes for large grids
  {
    ways.push_back(EnclosedWay(body.Mesh, grid));
  }
#ifdef RELIEVO_BENCH_MODELLER
  if (compare)
  {
    ways.push_back(ModellerWay(body.Mesh, grid));
  }
#endif
  std::vector<Timed> works(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    works[i].Work = ways[i].Run;
  }
  const std::vector<Timing> times = TimeInTurn(works, rounds, 1);
  std::vector<unsigned char> truth;
  if (compare)
  {
    truth =
      relievoTest::CellsInside(body.IsInside, grid.Cells, grid.Origin, glm::dvec3(grid.Spacing));
  }
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const Errors errors = compare ? Compare(truth, ways[i].Cells()) : Errors();
    const double milliseconds = 1e3 * times[i].Median();
    table.AddRow({ body.Name, std::to_string(body.Mesh->GetNumberOfPolys()), std::to_string(size),
      ways[i].Name, Number(milliseconds), compare ? Number(100. * errors.Excess) : "",
      compare ? Number(100. * errors.Missed) : "", Number(LoadAverage(), 2) });
    std::cout << body.Name << ' ' << size << ", " << ways[i].Name << ": " << Number(milliseconds)
              << " ms";
    if (compare)
    {
      std::cout << ", excess " << Number(100. * errors.Excess) << " %, missed "
                << Number(100. * errors.Missed) << " %";
    }
    std::cout << std::endl;
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchVoxels(const std::string& outDir, const VoxelSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "body", "triangles", "cells", "method", "milliseconds", "excess percent",
    "missed percent", "load" });
  for (const Body& body : Bodies(sizes.Meshes, sizes.Chord))
  {
    for (const int size : sizes.Sizes)
    {
      Measure(body, size, sizes.Rounds, true, size <= sizes.Slow, table);
    }
  }
  if (sizes.Large > 0)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(806);
    sphere->SetPhiResolution(806);
    sphere->Update();
    Measure(
      { "sphere", sphere->GetOutput(), InsideFunction() }, sizes.Large, 3, false, false, table);
  }
  return table.WriteCsv(outDir + "/voxels.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchVoxels(const std::string& outDir)
{
  return relievoBench::BenchVoxels(outDir, {});
}
