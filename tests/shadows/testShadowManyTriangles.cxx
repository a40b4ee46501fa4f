// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of ten million triangles (of the number that is given; with a second argument, in
// one mesh): verdicts in closed form, and the graphics memory that the frame report states.
//
// Eight sheets over the ground are made of large squares, each finely cut. Corners are moved along
// the sun's rays, by any amount, which moves no shadow: the truth is that of the flat squares.
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace testShadowManyTriangles
{
namespace
{
using relievoTest::ShadowStage;

constexpr int Sheets = 8;
constexpr int Squares = 64;  // along a sheet
constexpr int Spread = 12;   // one of so many squares is there
constexpr double Width = 8.; // of a sheet
constexpr double Square = Width / Squares;
constexpr double Lowest = 4.; // above all that the camera sees

const glm::dvec3 ToSun(0.25, 1., -0.125);

glm::dvec3 GetCenter(int sheet)
{
  const double height = Lowest + 0.25 * sheet;
  // Each somewhat aside, so that their squares do not lie over each other.
  return height * ToSun + glm::dvec3(0.31 * Square * sheet, 0., 0.17 * Square * sheet);
}

bool IsThere(int sheet, int i, int j)
{
  const auto lot = static_cast<std::uint64_t>((sheet * Squares + i) * Squares + j + 1);
  return (lot * 6364136223846793005ull >> 33) % Spread == 0;
}

double GetBump(vtkIdType corner)
{
  const auto lot = static_cast<std::uint64_t>(corner + 1) * 2862933555777941757ull;
  return 0.02 * static_cast<double>(lot >> 40) / (1 << 24);
}

// Adds all squares of a sheet, `cells` x `cells` quads of two triangles each.
void AddSheet(int sheet, int cells, vtkPolyData* mesh)
{
  vtkPoints* points = mesh->GetPoints();
  vtkCellArray* triangles = mesh->GetPolys();
  const glm::dvec3 middle = GetCenter(sheet);
  for (int square = 0; square < Squares * Squares; ++square)
  {
    const int i = square / Squares;
    const int j = square % Squares;
    if (!IsThere(sheet, i, j))
    {
      continue;
    }
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k <= cells; ++k)
    {
      for (int l = 0; l <= cells; ++l)
      {
        const glm::dvec3 flat = middle +
          glm::dvec3((i + static_cast<double>(k) / cells) * Square - 0.5 * Width, 0.,
            (j + static_cast<double>(l) / cells) * Square - 0.5 * Width);
        const glm::dvec3 p = flat + GetBump(points->GetNumberOfPoints()) * ToSun;
        points->InsertNextPoint(p.x, p.y, p.z);
      }
    }
    for (int k = 0; k < cells; ++k)
    {
      for (int l = 0; l < cells; ++l)
      {
        const vtkIdType p = first + k * (cells + 1) + l;
        triangles->InsertNextCell({ p, p + 1, p + cells + 1 });
        triangles->InsertNextCell({ p + 1, p + cells + 2, p + cells + 1 });
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> NewMesh()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(vtkNew<vtkPoints>()); // floats, as they are drawn
  mesh->SetPolys(vtkNew<vtkCellArray>());
  return mesh;
}

// 0 or 1; -1 next to a rim, where rounding decides.
double GetTruth(const glm::dvec3& onGround)
{
  constexpr double Rounding = 2e-5;
  bool tie = false;
  for (int sheet = 0; sheet < Sheets; ++sheet)
  {
    const glm::dvec3 middle = GetCenter(sheet);
    const glm::dvec3 p = onGround + middle.y * ToSun - middle;
    bool sure = true;
    bool any = false;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = p.x + (corner & 1 ? Rounding : -Rounding);
      const double z = p.z + (corner & 2 ? Rounding : -Rounding);
      const int i = static_cast<int>(std::floor((x + 0.5 * Width) / Square));
      const int j = static_cast<int>(std::floor((z + 0.5 * Width) / Square));
      const bool covered = i >= 0 && i < Squares && j >= 0 && j < Squares && IsThere(sheet, i, j);
      sure = sure && covered;
      any = any || covered;
    }
    // Next to the border of two squares that are both there, nothing joins them.
    const double inX = std::remainder(p.x + 0.5 * Width, Square);
    const double inZ = std::remainder(p.z + 0.5 * Width, Square);
    const bool between = std::abs(inX) < Rounding || std::abs(inZ) < Rounding;
    if (sure && !between)
    {
      return 0.;
    }
    tie = tie || any;
  }
  return tie ? -1. : 1.;
}

// Memory of this process, in MiB: now, or the maximum so far.
double GetMemory(const std::string& which)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == which + ":")
    {
      double kibibytes = 0.;
      status >> kibibytes;
      return kibibytes / 1024.;
    }
  }
  return 0.;
}

void Test(double wanted, bool oneMesh)
{
  constexpr int Columns = 400;
  constexpr int Rows = 300;
  ShadowStage stage(Columns, Rows);
  stage.AddGround();
  long long squares = 0;
  for (int square = 0; square < Sheets * Squares * Squares; ++square)
  {
    const int sheet = square / (Squares * Squares);
    squares += IsThere(sheet, square / Squares % Squares, square % Squares) ? 1 : 0;
  }
  const int cells =
    static_cast<int>(std::ceil(std::sqrt(0.5 * wanted / static_cast<double>(squares))));
  long long triangles = 2;
  vtkSmartPointer<vtkPolyData> mesh = NewMesh();
  for (int sheet = 0; sheet < Sheets; ++sheet)
  {
    AddSheet(sheet, cells, mesh);
    if (!oneMesh || sheet == Sheets - 1)
    {
      triangles += mesh->GetNumberOfPolys();
      relievoTest::AddActor(stage.Renderer, mesh);
      mesh = NewMesh();
    }
  }
  RELIEVO_CHECK(static_cast<double>(triangles) >= wanted);
  stage.AddSun(ToSun.x, ToSun.y, ToSun.z);
  stage.GetShadows()->SetMethodToExact();
  const double before = GetMemory("VmRSS");
  for (int frame = 0; frame < 2; ++frame) // the tree is built, and kept
  {
    const auto began = std::chrono::steady_clock::now();
    const auto image = relievoTest::CaptureShadow(stage, 0);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    const float* drawn =
      vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
    RELIEVO_CHECK(stage.GetShadows()->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT);
    const relievoTest::View view(stage.Renderer);
    long long seen[3] = { 0, 0, 0 }; // ties, dark, lit
    long long mismatches[3] = { 0, 0, 0 };
    for (int pixel = 0; pixel < Columns * Rows; ++pixel)
    {
      const relievoTest::Ray ray = view.PixelRay(pixel % Columns + 0.5, pixel / Columns + 0.5);
      const glm::dvec3 place = ray.At(-ray.Origin.y / ray.Direction.y);
      if (!(ray.Direction.y < 0.) || std::max(std::abs(place.x), std::abs(place.z)) > 2.99)
      {
        continue;
      }
      const double truth = GetTruth(place);
      const int kind = 1 + static_cast<int>(truth);
      ++seen[kind];
      mismatches[kind] += std::abs(drawn[pixel] - truth) > 0.5 ? 1 : 0;
    }
    const std::string what = std::to_string(triangles) + " triangles";
    std::cout << what << ", frame " << frame << ": " << seen[1] << " pixels dark, " << seen[2]
              << " lit, " << seen[0] << " at rims; " << took.count() << " s; "
              << GetMemory("VmRSS") - before << " MiB more than their data, at most "
              << GetMemory("VmHWM") << " MiB in all\n";
    RELIEVO_CHECK_THAT(seen[1] > 10000 && seen[2] > 10000, what + ": too little is judged");
    RELIEVO_CHECK_AT_MOST(static_cast<double>(seen[0]), 0.02 * Columns * Rows, what + ": at rims");
    RELIEVO_CHECK_AT_MOST(mismatches[1], 0, what + ": dark pixels that are lit");
    RELIEVO_CHECK_AT_MOST(mismatches[2], 0, what + ": lit pixels that are dark");
    RELIEVO_CHECK_AT_MOST(static_cast<double>(stage.GetShadows()->GetBytesHeld()),
      64. * static_cast<double>(triangles) + 4096. + (16. + 4. / 64.) * (Columns + 7) * (Rows + 7),
      what + ": bytes held");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowManyTriangles)
{
  relievoTest::Session session;
  Test(argc > 1 ? std::atof(argv[1]) : 1e7, argc > 2);
  return session.Result();
}
}
