// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of blocks: distance and normals on balls against the sphere, topology against counts of
// blocks, edges and seams on random volumes, checkerboards and walls, geometry of images.
#include "BlockScenes.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoSmoothBlocks.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace testSmoothBlocks
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoSmoothBlocks;

struct BallErrors
{
  double Distance = 0.; // rms
  double Largest = 0.;
  double Normal = 0.; // rms, degrees
  double Cubes = 0.;  // of the faces of the cubes
};

BallErrors Measure(const Place& center)
{
  constexpr double Radius = 12.7;
  BallErrors errors;
  for (const double strength : { 0., 0.125 })
  {
    vtkNew<Filter> filter;
    filter->SetStrength(strength);
    filter->SetTextureCoordinates(strength == 0.); // a point for each corner of each face
    vtkPolyData* surface = Run(filter, MakeBlocks({ 32, 32, 32 }, BallOf(Radius, center)));
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    double squares = 0.;
    double angles = 0.;
    vtkIdType count = 0;
    const vtkIdType size =
      strength == 0. ? surface->GetNumberOfPolys() : surface->GetNumberOfPoints();
    for (vtkIdType i = 0; i < size; ++i)
    {
      Place place;
      double normal[3];
      if (strength == 0.)
      {
        // The face itself: its middle and its direction.
        vtkCell* cell = surface->GetCell(i);
        Place corners[3];
        for (int c = 0; c < 3; ++c)
        {
          surface->GetPoint(cell->GetPointId(c), corners[c].data());
        }
        double sides[2][3];
        for (int c = 0; c < 3; ++c)
        {
          place[c] = (corners[0][c] + corners[1][c] + corners[2][c]) / 3.;
          sides[0][c] = corners[1][c] - corners[0][c];
          sides[1][c] = corners[2][c] - corners[0][c];
        }
        vtkMath::Cross(sides[0], sides[1], normal);
      }
      else
      {
        surface->GetPoint(i, place.data());
        normals->GetTuple(i, normal);
      }
      double out[3];
      vtkMath::Subtract(place.data(), center.data(), out);
      const double distance = std::abs(vtkMath::Norm(out) - Radius);
      const double angle = vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(out, normal));
      squares += distance * distance;
      angles += angle * angle;
      errors.Largest = std::max(errors.Largest, strength == 0. ? 0. : distance);
      ++count;
    }
    if (strength == 0.)
    {
      errors.Cubes = std::sqrt(angles / static_cast<double>(count));
    }
    else
    {
      errors.Distance = std::sqrt(squares / static_cast<double>(count));
      errors.Normal = std::sqrt(angles / static_cast<double>(count));
    }
  }
  return errors;
}

void TestBall()
{
  const BallErrors errors = Measure({ 16.31, 15.87, 16.12 });
  RELIEVO_CHECK_AT_MOST(errors.Distance, 0.14, "rms distance to the sphere, blocks");
  RELIEVO_CHECK_AT_MOST(errors.Largest, 0.45, "largest distance to the sphere, blocks");
  RELIEVO_CHECK_AT_MOST(
    errors.Normal / errors.Cubes, 0.25, "error of normals, as part of that of cubes");
}

// For any position of the ball among the blocks. Flat surroundings leave half a block undetermined.
void TestBallAnywhere()
{
  constexpr double Radius = 12.7;
  double sum = 0.;
  double worst = 0.;
  double largest = 0.;
  constexpr int Balls = 12;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(15.5, 16.5);
  for (int ball = 0; ball < Balls; ++ball)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    const Place center = { x, y, uniform(random) };
    vtkNew<Filter> filter;
    vtkPolyData* surface = Run(filter, MakeBlocks({ 32, 32, 32 }, BallOf(Radius, center)));
    double squares = 0.;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      Place place;
      surface->GetPoint(i, place.data());
      const double distance =
        std::abs(std::sqrt(vtkMath::Distance2BetweenPoints(place.data(), center.data())) - Radius);
      squares += distance * distance;
      largest = std::max(largest, distance);
    }
    const double rms = std::sqrt(squares / static_cast<double>(surface->GetNumberOfPoints()));
    worst = std::max(worst, rms);
    sum += rms;
  }
  RELIEVO_CHECK_AT_MOST(sum / Balls, 0.14, "rms distance, mean of balls anywhere");
  RELIEVO_CHECK_AT_MOST(worst, 0.15, "rms distance, the worst of them");
  RELIEVO_CHECK_AT_MOST(largest, 0.5, "largest distance of all");
}

// Faces, orientation, and edges of any volume: counts come from the labels.
void TestVolume(const std::string& name, const std::array<int, 3>& size, const LabelOf& label,
  bool between, double strength)
{
  vtkNew<Filter> filter;
  filter->SetStrength(strength);
  filter->SetSurface(between ? Filter::BETWEEN_LABELS : Filter::OUTSIDE);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkSmartPointer<vtkImageData> image = MakeBlocks(size, label);
  vtkPolyData* surface = Run(filter, image);
  vtkIdType faces = 0;
  double volume = 0.;
  const auto at = [&](int i, int j, int k) {
    const bool inside = i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
    const vtkTypeInt64 value = inside ? label(i, j, k) : 0;
    return between ? value : vtkTypeInt64(value != 0);
  };
  for (int k = -1; k < size[2]; ++k)
  {
    for (int j = -1; j < size[1]; ++j)
    {
      for (int i = -1; i < size[0]; ++i)
      {
        faces += at(i, j, k) != at(i + 1, j, k);
        faces += at(i, j, k) != at(i, j + 1, k);
        faces += at(i, j, k) != at(i, j, k + 1);
        volume += at(i, j, k) != 0;
      }
    }
  }
  RELIEVO_CHECK_THAT(surface->GetNumberOfPolys() == 2 * faces,
    name + ": " + std::to_string(surface->GetNumberOfPolys()) + " triangles, not " +
      std::to_string(2 * faces));
  if (strength == 0. && !between)
  {
    RELIEVO_CHECK_NEAR(VolumeOf(surface), volume, 1e-9 * volume + 1e-12, name + ": volume inside");
  }
  RELIEVO_CHECK_AT_MOST(
    -SmallestArea(surface), faces ? -0.031 : 0., name + ": smallest area, negative");
  const int unlisted = UnlistedEdges(surface, filter->GetOutput(1));
  RELIEVO_CHECK_THAT(
    unlisted == 0, name + ": " + std::to_string(unlisted) + " edges are not as listed");
  vtkDataArray* materials = surface->GetCellData()->GetArray("material");
  RELIEVO_CHECK(materials && materials->GetDataType() == VTK_INT);
  RELIEVO_CHECK((surface->GetCellData()->GetArray("neighbor") != nullptr) == between);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  double worst = 0.;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    worst = std::max(worst, std::abs(vtkMath::Norm(normal) - 1.));
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-6, name + ": lengths of normals");
}

void TestVolumes()
{
  const auto solid = [](int, int, int) { return vtkTypeInt64(3); };
  const auto empty = [](int, int, int) { return vtkTypeInt64(0); };
  const auto checkers = [](int i, int j, int k) { return vtkTypeInt64((i + j + k) & 1); };
  const auto wall = [](int i, int, int) { return vtkTypeInt64(i == 3); };
  for (const double strength : { 0., 0.125, 0.25 })
  {
    TestVolume("one block", { 1, 1, 1 }, solid, false, strength);
    TestVolume("a row", { 1, 1, 9 }, solid, false, strength);
    TestVolume("all solid", { 5, 4, 3 }, solid, false, strength);
    TestVolume("empty", { 5, 4, 3 }, empty, false, strength);
    TestVolume("checkers", { 6, 6, 6 }, checkers, false, strength);
    TestVolume("wall", { 7, 6, 5 }, wall, false, strength);
    TestVolume("random", { 70, 9, 19 }, AnyOf(1, 2), false, strength);
    TestVolume(
      "sparse", { 9, 67, 18 },
      [](int i, int j, int k) { return vtkTypeInt64(AnyOf(2, 7)(i, j, k) == 1); }, false, strength);
    TestVolume("labels", { 12, 9, 21 }, AnyOf(3, 5), true, strength);
    TestVolume("two labels", { 66, 5, 7 }, AnyOf(4, 3), true, strength);
    TestVolume("labels from outside", { 10, 11, 9 }, AnyOf(4, 3), false, strength);
  }
  // A ball is a sphere, and a ring of blocks a torus.
  vtkNew<Filter> filter;
  RELIEVO_CHECK(
    EulerNumber(Run(filter, MakeBlocks({ 20, 20, 20 }, BallOf(8., { 10., 10., 10. })))) == 2);
  const auto ring = [](int i, int j, int k) {
    const double around = std::hypot(i - 9.5, j - 9.5) - 6.;
    return vtkTypeInt64(around * around + (k - 4.5) * (k - 4.5) < 9.);
  };
  RELIEVO_CHECK(EulerNumber(Run(filter, MakeBlocks({ 20, 20, 10 }, ring))) == 0);
}

// An image with a direction, negative spacing and another origin moves the surface of blocks; it
// faces outwards, and labels on points give it, too, half a block away.
void TestGeometry()
{
  vtkNew<Filter> filter;
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<Filter> moved;
  moved->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  const LabelOf label = BallOf(5.3, { 6.2, 7.1, 5.9 });
  vtkPolyData* plain = Run(filter, MakeBlocks({ 13, 14, 12 }, label));
  for (const bool onPoints : { false, true })
  {
    vtkSmartPointer<vtkImageData> image = MakeBlocks({ 13, 14, 12 }, label, VTK_SHORT, onPoints);
    image->SetSpacing(-2., 3., 0.5);
    image->SetOrigin(100., -50., 7.);
    image->SetDirectionMatrix(0., 0., 1., 1., 0., 0., 0., 1., 0.);
    vtkPolyData* surface = Run(moved, image);
    RELIEVO_CHECK(surface->GetNumberOfPoints() == plain->GetNumberOfPoints());
    double worst = 0.;
    double normalWorst = 0.;
    for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
    {
      Place from;
      Place to;
      plain->GetPoint(i, from.data());
      surface->GetPoint(i, to.data());
      const double shift = onPoints ? 0.5 : 0.;
      const double expected[] = { 100. + 0.5 * (from[2] - shift), -50. - 2. * (from[0] - shift),
        7. + 3. * (from[1] - shift) };
      Place normal;
      plain->GetPointData()->GetNormals()->GetTuple(i, normal.data());
      double turned[] = { normal[2] / 0.5, normal[0] / -2., normal[1] / 3. };
      vtkMath::Normalize(turned);
      double given[3];
      surface->GetPointData()->GetNormals()->GetTuple(i, given);
      for (int c = 0; c < 3; ++c)
      {
        worst = std::max(worst, std::abs(to[c] - expected[c]));
        normalWorst = std::max(normalWorst, std::abs(given[c] - turned[c]));
      }
    }
    RELIEVO_CHECK_AT_MOST(worst, 1e-12, "places in a turned image");
    RELIEVO_CHECK_AT_MOST(normalWorst, 1e-6, "normals in a turned image");
    // Not the same: the shorter diagonals are others.
    const double volume = 3. * VolumeOf(plain);
    RELIEVO_CHECK_NEAR(VolumeOf(surface), volume, 0.002 * volume, "volume, so outwards");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocks)
{
  relievoTest::Session session;
  TestBall();
  TestBallAnywhere();
  TestVolumes();
  TestGeometry();
  return session.Result();
}
}
