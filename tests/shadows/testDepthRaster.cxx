// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depths that the processor draws into maps: those of the first triangle on the ray of each texel,
// found in double without a projection; one triangle for a centre on an edge; the number of threads
// makes no difference. Those of points are the least ones within the radius. Maps of whole scenes
// are those that OpenGL draws by VTK's shader, but for outlines, which OpenGL rounds to 1/256
// texel; and an actor in two windows casts in both.
#include "vtkRelievoDepthRaster.h"

#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h> // for OpenGL
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPointGroups.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoSoftwareOpenGL.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
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
    mesh.NumberOfPlaces = this->Places.size() / 3;
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
  int mismatches = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const double z = raster.GetDepths()[i];
    covered += z < 1.0 ? 1 : 0;
    sure += ranges[i].High < 1.0 && ranges[i].High - ranges[i].Low < 1e-3 ? 1 : 0;
    mismatches += z < ranges[i].Low - 1e-6 || z > ranges[i].High + 1e-6 ? 1 : 0;
  }
  RELIEVO_CHECK_THAT(
    mismatches == 0, what + ": " + std::to_string(mismatches) + " texels are wrong");
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
  int mismatches = 0;
  for (int y = 1; y < Step * Last; ++y)
  {
    for (int x = 1; x < Step * Last; ++x)
    {
      mismatches += count[static_cast<std::size_t>(y) * Size + x] == 1 ? 0 : 1;
    }
  }
  RELIEVO_CHECK_THAT(
    mismatches == 0, std::to_string(mismatches) + " centres are not in exactly one triangle");
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

// Corners that are no places, and places that are no numbers, in a chunk with a whole triangle.
void TestInvalid()
{
  Soup soup;
  for (const double z : { 0.0, std::nan(""), 0.0, HUGE_VAL })
  {
    soup.Add({ -9.0, -9.0, z });
    soup.Add({ 20.0, z, 0.0 });
    soup.Add({ -9.0, 20.0, 0.0 });
  }
  soup.Corners[7] = 4000000000u;
  vtkRelievoDepthRaster raster;
  raster.Clear(Size);
  raster.Draw(soup.GetMesh(), glm::dmat4(1.0), Whole, false);
  RELIEVO_CHECK(raster.GetDepths() == std::vector<float>(raster.GetDepths().size(), 0.5f));
}

// Many points, of which nearer ones hide most: each texel has the depth of the nearest point within
// the radius. Those in front of the near plane are cut off, or at depth 0.
void TestPoints()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> one(-1.1f, 1.1f);
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> verts;
  for (vtkIdType i = 0; i < 30000; ++i)
  {
    places->InsertNextPoint(one(random), one(random), one(random));
    verts->InsertNextCell(1, &i);
  }
  places->SetPoint(5, std::nan(""), 0.0, 0.0);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(places);
  mesh->SetVerts(verts);
  vtkRelievoPointGroups groups;
  const int part[4] = { 10, 20, 30, 25 };
  const glm::dmat4 lamp = glm::perspective(1.2, 1.0, 0.9, 4.0) *
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -1.8));
  for (const double diameter : { 1.0, 4.0, 9.5 })
  {
    for (int i = 0; i < 8; ++i)
    {
      const glm::dmat4 matrix = (i & 1) != 0 ? lamp : glm::dmat4(1.0);
      const int* region = (i & 2) != 0 ? part : Whole;
      const bool clamps = (i & 4) != 0;
      vtkRelievoDepthRaster raster;
      raster.Clear(Size);
      raster.Draw(groups.Get(mesh), diameter, matrix, region, clamps);
      std::vector<Range> ranges(static_cast<std::size_t>(Size) * Size);
      for (vtkIdType k = 0; k < places->GetNumberOfPoints(); ++k)
      {
        double place[3];
        places->GetPoint(k, place);
        const glm::dvec4 clip = matrix * glm::dvec4(place[0], place[1], place[2], 1.0);
        const glm::dvec3 at = 0.5 * glm::dvec3(clip) / clip.w + 0.5;
        if (!(clip.w > 0.0 && at.z <= 1.0 && (clamps || at.z >= 0.0)))
        {
          continue;
        }
        const glm::dvec2 texel(region[0] + at.x * region[2], region[1] + at.y * region[3]);
        for (int y = std::max(region[1], static_cast<int>(texel.y - diameter));
             y < std::min<double>(region[1] + region[3], texel.y + diameter); ++y)
        {
          for (int x = std::max(region[0], static_cast<int>(texel.x - diameter));
               x < std::min<double>(region[0] + region[2], texel.x + diameter); ++x)
          {
            Range& range = ranges[static_cast<std::size_t>(y) * Size + x];
            const double away = glm::distance(texel, glm::dvec2(x + 0.5, y + 0.5)) - diameter / 2.0;
            const double z = std::max(at.z, 0.0);
            range.Low = away < 1e-4 ? std::min(range.Low, z) : range.Low;
            range.High = away < -1e-4 ? std::min(range.High, z) : range.High;
          }
        }
      }
      int mismatches = 0;
      int covered = 0;
      for (std::size_t k = 0; k < ranges.size(); ++k)
      {
        const double depth = raster.GetDepths()[k];
        mismatches += depth < ranges[k].Low - 1e-6 || depth > ranges[k].High + 1e-6 ? 1 : 0;
        covered += depth < 1.0 ? 1 : 0;
      }
      const std::string what =
        "points of " + std::to_string(diameter) + " texels, case " + std::to_string(i);
      RELIEVO_CHECK_AT_MOST(mismatches, 0, what + ": mismatched texels");
      RELIEVO_CHECK_THAT(covered > region[2] * region[3] / 2, what + ": nothing drawn");
    }
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

using relievoTest::ShadowStage;

constexpr int MapSize = 509; // of no other texture
bool Software = false;       // OpenGL, while there is a context

// All maps of the current context.
std::vector<float> ReadMaps()
{
  std::vector<float> depths;
  for (GLuint texture = 1; texture < 1000; ++texture)
  {
    GLint width = 0;
    GLint layers = 0;
    GLint bits = 0;
    if (!glIsTexture(texture))
    {
      continue;
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    if (glGetError() == GL_NO_ERROR) // else of another target
    {
      glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &width);
      glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH, &layers);
      glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_DEPTH_SIZE, &bits);
    }
    if (width == MapSize && bits > 0)
    {
      const std::size_t before = depths.size();
      depths.resize(before + static_cast<std::size_t>(width) * width * layers);
      glPixelStorei(GL_PACK_ALIGNMENT, 4);
      glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data() + before);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  }
  return depths;
}

// Has VTK draw the actor by its own shader: the text changes nothing.
void DrawByVTK(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n", false);
}

// The maps of the first picture, and those after the light has moved.
std::vector<std::vector<float>> DrawMaps(const glm::dvec3& origin, bool point, bool byVTK)
{
  ShadowStage stage(240, 180, 1., origin);
  stage.AddGround();
  stage.AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 });
  const auto ball = relievoTest::MakeBall(0.5);
  const glm::dvec3 place = stage.Place({ 0.3, 0.6, 0.2 });
  relievoTest::AddActor(stage.Renderer, relievoTest::Moved(ball, 1., 0.7, -0.4))
    ->SetPosition(origin.x, origin.y, origin.z);
  const auto mirrored = relievoTest::AddActor(stage.Renderer, ball);
  mirrored->SetPosition(place.x, place.y, place.z);
  mirrored->SetOrientation(20., 50., 70.);
  mirrored->SetScale(-1.4, 0.6, 0.8);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.4);
  sphere->SetThetaResolution(150);
  sphere->SetPhiResolution(90);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  strips->Update();
  const glm::dvec3 other = stage.Place({ -0.5, 0.5, -1.2 });
  relievoTest::AddActor(stage.Renderer, strips->GetOutput())
    ->SetPosition(other.x, other.y, other.z);
  vtkActorCollection* actors = stage.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    // The box is never plain, beside others that are.
    if (byVTK || i == 1)
    {
      DrawByVTK(vtkActor::SafeDownCast(actors->GetItemAsObject(i)));
    }
  }
  const auto light =
    point ? stage.AddLamp({ 1., 3., 2. }, { 0., 0., 0. }, 180.) : stage.AddSun(2., 3., 1.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToMap();
  stage.GetShadows()->SetMapSize(MapSize);
  std::vector<std::vector<float>> maps;
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Window->Render();
    auto* shadows = stage.GetShadows();
    RELIEVO_CHECK(shadows->GetDrawCalls() <=
      shadows->EstimateDrawCalls(shadows->GetMethod(), shadows->GetNumberOfMaps(), 5));
    stage.Window->MakeCurrent();
    Software = vtkRelievoIsSoftwareOpenGL();
    maps.push_back(ReadMaps());
    const glm::dvec3 moved = stage.Place({ 2., 3., -0.5 });
    light->SetPosition(moved.x, moved.y, moved.z);
  }
  return maps;
}

void TestOpenGL(const std::string& what, const glm::dvec3& origin, bool point)
{
  const auto ours = DrawMaps(origin, point, false);
  const auto theirs = DrawMaps(origin, point, true);
  for (std::size_t frame = 0; frame < 2; ++frame)
  {
    const std::vector<float>& map = ours[frame];
    const std::vector<float>& truth = theirs[frame];
    const std::string where = what + ", frame " + std::to_string(frame);
    if (!RELIEVO_CHECK_THAT(map.size() == truth.size() && !map.empty(), where + ": no maps"))
    {
      continue;
    }
    const auto rows = static_cast<int>(map.size() / MapSize);
    int casters = 0;
    int others = 0;
    int outlines = 0;
    int mismatches = 0;
    for (int y = 0; y < rows; ++y)
    {
      for (int x = 0; x < MapSize; ++x)
      {
        const std::size_t at = static_cast<std::size_t>(y) * MapSize + x;
        float low = truth[at];
        float high = truth[at];
        for (int v = std::max(0, y - 1); v <= std::min(rows - 1, y + 1); ++v)
        {
          for (int u = std::max(0, x - 1); u <= std::min(MapSize - 1, x + 1); ++u)
          {
            const float near = truth[static_cast<std::size_t>(v) * MapSize + u];
            low = std::min(low, near);
            high = std::max(high, near);
          }
        }
        const float off = std::abs(map[at] - truth[at]);
        casters += truth[at] < 1.f ? 1 : 0;
        others += map[at] != truth[at] ? 1 : 0;
        const bool same = off <= 2e-6f + (high - low) / 64.f;
        outlines += same ? 0 : 1;
        mismatches += same || (map[at] >= low - 2e-6f && map[at] <= high + 2e-6f) ? 0 : 1;
      }
    }
    std::cout << where << ": " << casters << " texels, " << others << " rounded, " << outlines
              << " at outlines, " << mismatches << " wrong\n";
    RELIEVO_CHECK_THAT(
      mismatches == 0, where + ": " + std::to_string(mismatches) + " depths are wrong");
    RELIEVO_CHECK_THAT(casters > 2000 && outlines <= casters / 2000,
      where + ": " + std::to_string(outlines) + " of " + std::to_string(casters) + " differ");
    // Otherwise OpenGL has been compared with itself.
    RELIEVO_CHECK_THAT(others > 0 || !Software, where + ": all by OpenGL");
  }
}

// Actors that another window has drawn, in one with buffers of its own: as if it alone drew them.
void TestWindows()
{
  vtkSmartPointer<vtkImageData> pictures[2];
  for (int both = 0; both < 2; ++both)
  {
    ShadowStage first;
    ShadowStage second;
    for (ShadowStage* stage : { &first, &second })
    {
      stage->AddSun(2., 3., 1.);
      stage->GetFrame()->ShadowsOn();
      stage->GetShadows()->SetMapSize(MapSize);
    }
    relievoTest::AddActor(second.Renderer, relievoTest::MakeBall(0.8));
    second.Window->Render();
    first.AddThings();
    if (both)
    {
      first.Window->Render();
    }
    vtkActorCollection* actors = first.Renderer->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); ++i)
    {
      second.Renderer->AddActor(vtkActor::SafeDownCast(actors->GetItemAsObject(i)));
    }
    pictures[both] = relievoTest::Picture(second.Window);
  }
  RELIEVO_CHECK(relievoTest::CountUnlike(pictures[0], pictures[1]) == 0);
}
}

RELIEVO_TEST_CASE(testDepthRaster)
{
  relievoTest::Session session;
  TestDepths();
  TestEdges();
  TestThreads();
  TestInvalid();
  TestPoints();
  TestRegion();
  TestOpenGL("sun", glm::dvec3(0.), false);
  TestOpenGL("sun, far from the origin", glm::dvec3(1e6, 2e6, -1e6), false);
  TestOpenGL("lamp", glm::dvec3(0.), true);
  TestWindows();
  return session.Result();
}
}
