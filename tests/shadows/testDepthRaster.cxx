// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depths that the processor draws into maps: those of the first triangle on the ray of each texel,
// found in double without a projection; one triangle for a centre on an edge; the number of threads
// makes no difference.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoDepthRaster.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testDepthRaster
{
namespace
{
constexpr int Size = 64;
const int Whole[4] = { 0, 0, Size, Size };

struct Soup
{
  std::vector<float> Places;
  std::vector<unsigned int> Corners;

  void Add(const glm::dvec3& place)
  {
    this->Corners.push_back(static_cast<unsigned int>(this->Places.size() / 3));
    this->Places.insert(this->Places.end(),
      { static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z) });
  }
  glm::dvec3 Get(std::size_t corner) const
  {
    const float* place = this->Places.data() + 3 * this->Corners[corner];
    return glm::dvec3(place[0], place[1], place[2]);
  }
  vtkRelievoDepthRaster::Mesh GetMesh(std::size_t first, std::size_t triangles) const
  {
    vtkRelievoDepthRaster::Mesh mesh;
    mesh.Places = this->Places.data();
    mesh.Corners = this->Corners.data() + 3 * first;
    mesh.Triangles = triangles;
    return mesh;
  }
  vtkRelievoDepthRaster::Mesh GetMesh() const { return this->GetMesh(0, this->Corners.size() / 3); }
};

// Triangles around a place, with edges of about this length.
Soup MakeSoup(int triangles, double length, double spread, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  auto vector = [&]() { return glm::dvec3(one(random), one(random), one(random)); };
  Soup soup;
  for (int i = 0; i < triangles; ++i)
  {
    const glm::dvec3 center = spread * vector();
    for (int k = 0; k < 3; ++k)
    {
      soup.Add(center + length * vector());
    }
  }
  return soup;
}

// The least depth and the greatest one that a texel may have, if its ray may be off by `blur`
// texels.
struct Range
{
  double Low = 1.0;
  double High = 1.0;
};

void Narrow(Range& range, const glm::dvec4 corners[3], double x, double y, bool clamps)
{
  constexpr double Blur = 1.0 / 2000.0;
  glm::dmat3 homogeneous;
  for (int k = 0; k < 3; ++k)
  {
    homogeneous[k] = glm::dvec3(corners[k].x, corners[k].y, corners[k].w);
  }
  if (glm::determinant(homogeneous) == 0.0)
  {
    return;
  }
  const glm::dmat3 inverse = glm::inverse(homogeneous);
  int hits = 0;
  double low = 1e300;
  double high = -1e300;
  for (int i = 0; i < 5; ++i)
  {
    const double dx = i == 4 ? 0.0 : (i % 2 ? Blur : -Blur);
    const double dy = i == 4 ? 0.0 : (i / 2 ? Blur : -Blur);
    const glm::dvec3 shares =
      inverse * glm::dvec3(2.0 * (x + dx) / Size - 1.0, 2.0 * (y + dy) / Size - 1.0, 1.0);
    const double ndc = shares.x * corners[0].z + shares.y * corners[1].z + shares.z * corners[2].z;
    low = std::min(low, 0.5 * ndc + 0.5);
    high = std::max(high, 0.5 * ndc + 0.5);
    hits += glm::all(glm::greaterThanEqual(shares, glm::dvec3(0.0))) ? 1 : 0;
  }
  if (hits == 0 || (!clamps && high < 0.0))
  {
    return;
  }
  range.Low = std::min(range.Low, std::max(0.0, low));
  if (hits == 5 && (clamps || low >= 0.0))
  {
    range.High = std::min(range.High, std::max(0.0, high));
  }
}

void Compare(const std::string& what, const Soup& soup, const glm::dmat4& matrix, bool clamps)
{
  vtkRelievoDepthRaster raster;
  raster.Clear(Size);
  raster.Draw(soup.GetMesh(), matrix, Whole, clamps);
  std::vector<Range> ranges(static_cast<std::size_t>(Size) * Size);
  for (std::size_t i = 0; i < soup.Corners.size(); i += 3)
  {
    glm::dvec4 corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = matrix * glm::dvec4(soup.Get(i + k), 1.0);
    }
    int low[2] = { 0, 0 };
    int high[2] = { Size - 1, Size - 1 };
    for (int axis = 0; axis < 2 && corners[0].w > 0 && corners[1].w > 0 && corners[2].w > 0; ++axis)
    {
      double place[3];
      for (int k = 0; k < 3; ++k)
      {
        place[k] = std::clamp(0.5 * corners[k][axis] / corners[k].w + 0.5, -1.0, 2.0) * Size;
      }
      low[axis] = std::max(0, static_cast<int>(std::min({ place[0], place[1], place[2] })) - 2);
      high[axis] =
        std::min(Size - 1, static_cast<int>(std::max({ place[0], place[1], place[2] })) + 2);
    }
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        Narrow(ranges[static_cast<std::size_t>(y) * Size + x], corners, x + 0.5, y + 0.5, clamps);
      }
    }
  }
  int covered = 0;
  int sure = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const double z = raster.GetDepths()[i];
    covered += z < 1.0 ? 1 : 0;
    sure += ranges[i].High < 1.0 && ranges[i].High - ranges[i].Low < 1e-3 ? 1 : 0;
    wrong += z < ranges[i].Low - 1e-6 || z > ranges[i].High + 1e-6 ? 1 : 0;
  }
  RELIEVO_CHECK_THAT(wrong == 0, what + ": " + std::to_string(wrong) + " texels are wrong");
  RELIEVO_CHECK_THAT(covered > 200 && sure > covered / 2,
    what + ": says little, " + std::to_string(sure) + " of " + std::to_string(covered));
}

glm::dmat4 MakePerspective(double nearest)
{
  glm::dmat4 matrix(0.0); // at (0, 0, 2), looks along -z
  matrix[0].x = matrix[1].y = 2.0;
  matrix[2].z = -(8.0 + nearest) / (8.0 - nearest);
  matrix[2].w = -1.0;
  matrix[3].z = -2.0 * 8.0 * nearest / (8.0 - nearest) - 2.0 * matrix[2].z;
  matrix[3].w = 2.0;
  return matrix;
}

void TestDepths()
{
  glm::dmat4 parallel(0.7);
  parallel[3].w = 1.0;
  parallel[0].y = 0.2;
  parallel[2].x = -0.3;
  glm::dmat4 flat = parallel;
  flat[2].z = 1e-6;
  for (const bool clamps : { false, true })
  {
    const std::string way = clamps ? ", clamped" : ", cut";
    Compare("smaller than a texel" + way, MakeSoup(20000, 0.02, 1.5, 1), parallel, clamps);
    Compare("some texels" + way, MakeSoup(500, 0.1, 1.5, 2), parallel, clamps);
    Compare("large" + way, MakeSoup(12, 2.0, 1.0, 3), parallel, clamps);
    Compare("huge" + way, MakeSoup(20, 1e5, 1.0, 4), flat, clamps);
    Compare("perspective" + way, MakeSoup(300, 0.3, 1.0, 5), MakePerspective(0.5), clamps);
    Compare("around the eye" + way, MakeSoup(60, 2.5, 2.0, 6), MakePerspective(0.5), clamps);
  }
}

// A grid of squares with corners at texels' centres, cut along either diagonal.
void TestEdges()
{
  Soup soup;
  std::mt19937 random(7);
  constexpr int Step = 3;
  constexpr int Last = Size / Step - 1;
  auto place = [](int x, int y) {
    return glm::dvec3(
      2.0 * (Step * x + 0.5) / Size - 1.0, 2.0 * (Step * y + 0.5) / Size - 1.0, 0.0);
  };
  for (int y = 0; y < Last; ++y)
  {
    for (int x = 0; x < Last; ++x)
    {
      const glm::dvec3 corners[4] = { place(x, y), place(x + 1, y), place(x + 1, y + 1),
        place(x, y + 1) };
      const unsigned int first = random() % 2;
      for (const unsigned int k : { 0u, 1u, 2u, 0u, 2u, 3u })
      {
        soup.Add(corners[(first + k) % 4]);
      }
    }
  }
  std::vector<int> count(static_cast<std::size_t>(Size) * Size, 0);
  for (std::size_t i = 0; i < soup.Corners.size() / 3; ++i)
  {
    vtkRelievoDepthRaster raster;
    raster.Clear(Size);
    raster.Draw(soup.GetMesh(i, 1), glm::dmat4(1.0), Whole, false);
    std::transform(count.begin(), count.end(), raster.GetDepths().begin(), count.begin(),
      [](int before, float z) { return before + (z < 1.f ? 1 : 0); });
  }
  int wrong = 0;
  for (int y = 1; y < Step * Last; ++y)
  {
    for (int x = 1; x < Step * Last; ++x)
    {
      wrong += count[static_cast<std::size_t>(y) * Size + x] == 1 ? 0 : 1;
    }
  }
  RELIEVO_CHECK_THAT(
    wrong == 0, std::to_string(wrong) + " centres are not in exactly one triangle");
}

// Triangle by triangle, without threads, in any order; and corners in an order that no cache helps.
void TestThreads()
{
  for (const double length : { 0.02, 1.0 })
  {
    Soup soup = MakeSoup(20000, length, 1.0, 8);
    vtkRelievoDepthRaster together;
    together.Clear(256);
    const int region[4] = { 0, 0, 256, 256 };
    together.Draw(soup.GetMesh(), glm::dmat4(1.0), region, true);
    vtkRelievoDepthRaster alone;
    alone.Clear(256);
    for (std::size_t i = soup.Corners.size() / 3; i-- > 0;)
    {
      alone.Draw(soup.GetMesh(i, 1), glm::dmat4(1.0), region, true);
    }
    RELIEVO_CHECK(together.GetDepths() == alone.GetDepths());
    Soup mixed;
    mixed.Places = soup.Places;
    for (std::size_t i = 0; i < 20000; ++i)
    {
      const std::size_t triangle = i * 7919 % 20000;
      mixed.Corners.insert(mixed.Corners.end(), soup.Corners.begin() + 3 * triangle,
        soup.Corners.begin() + 3 * triangle + 3);
    }
    alone.Clear(256);
    alone.Draw(mixed.GetMesh(), glm::dmat4(1.0), region, true);
    RELIEVO_CHECK(together.GetDepths() == alone.GetDepths());
  }
}

// A part of the map, as for uneven maps: nothing beside it changes.
void TestRegion()
{
  Soup soup;
  soup.Add({ -9.0, -9.0, 0.0 });
  soup.Add({ 20.0, -9.0, 0.0 });
  soup.Add({ -9.0, 20.0, 0.0 });
  vtkRelievoDepthRaster raster;
  raster.Clear(Size);
  const int region[4] = { 10, 20, 30, 5 };
  raster.Draw(soup.GetMesh(), glm::dmat4(1.0), region, false);
  for (int i = 0; i < Size * Size; ++i)
  {
    const int x = i % Size;
    const int y = i / Size;
    const bool within = x >= 10 && x < 40 && y >= 20 && y < 25;
    RELIEVO_CHECK((raster.GetDepths()[static_cast<std::size_t>(i)] == 0.5f) == within);
  }
}
}

RELIEVO_TEST_CASE(testDepthRaster)
{
  relievoTest::Session session;
  TestDepths();
  TestEdges();
  TestThreads();
  TestRegion();
  return session.Result();
}
}
