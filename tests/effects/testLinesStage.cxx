// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoLinesStage: where lines are, against silhouettes and edges in double; that there are
// none where nothing ends; that switched off it leaves no trace.
#include "Check.h"
#include "GLCheck.h"
#include "LinesScene.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkAppendPolyData.h>
#include <vtkCell.h>
#include <vtkCubeSource.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoTextureBuffer.h>
#include <vtkSphereSource.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace testLinesStage
{
using namespace linesTest;

namespace
{
// The middle of the coverage by lines in a row between two columns; NaN without any.
double Middle(const std::vector<double>& cover, int row, int first, int last)
{
  double sum = 0.0;
  double moment = 0.0;
  for (int x = first; x <= last; ++x)
  {
    const double each = cover[static_cast<std::size_t>(row * Size + x)];
    sum += each;
    moment += each * x;
  }
  return sum > 0.5 ? moment / sum : std::nan("");
}

// A ball's silhouette is a circle in double; within the ball nothing is drawn.
void TestSilhouette()
{
  Scene scene;
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(300);
  ball->SetPhiResolution(300);
  ball->SetRadius(1.0);
  scene.Add(ball);
  const std::vector<double> cover = scene.Cover();
  const double distance = 5.0;
  const double focal =
    0.5 * Size / std::tan(0.5 * scene.Renderer->GetActiveCamera()->GetViewAngle() * M_PI / 180.0);
  const double radius = focal / std::sqrt(distance * distance - 1.0);
  const double center = 0.5 * (Size - 1);
  int rows = 0;
  double most = 0.0;
  for (int y = 0; y < Size; ++y)
  {
    const double off = std::abs(y - center);
    if (off > 0.6 * radius)
    {
      continue;
    }
    ++rows;
    const double side = std::sqrt(radius * radius - off * off);
    // Across the line: an offset along the row is smaller across a slanted edge.
    const double slant = side / radius;
    const int middle = Size / 2;
    const double right = Middle(cover, y, middle, Size - 1) - (center + side);
    const double left = Middle(cover, y, 0, middle) - (center - side);
    RELIEVO_CHECK(std::isfinite(right) && std::isfinite(left));
    most = std::max({ most, std::abs(right) * slant, std::abs(left) * slant });
  }
  RELIEVO_CHECK(rows > 50);
  RELIEVO_CHECK_AT_MOST(most, 0.5, "pixels from the ball's silhouette");
  double within = 0.0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const double r = std::hypot(x - center, y - center);
      within +=
        r < radius - 2.0 || r > radius + 2.0 ? cover[static_cast<std::size_t>(y * Size + x)] : 0.0;
    }
  }
  RELIEVO_CHECK_NEAR(within, 0.0, 1e-9, "lines that are no silhouette");
}

// A cube's nine visible edges, six outlines and three creases, where they are projected.
void CheckCube(Scene& scene, double half, const char* what)
{
  const std::vector<double> cover = scene.Cover();
  const double eye[3] = { 3.0, 2.0, 4.0 };
  double worst = 0.0;
  int places = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      double ends[2][3];
      bool seen = false;
      for (int end = 0; end < 2; ++end)
      {
        ends[end][axis] = end == 0 ? -half : half;
        for (int k = 1; k < 3; ++k)
        {
          const int other = (axis + k) % 3;
          const bool positive = (corner >> (k - 1)) % 2 == 1;
          ends[end][other] = positive ? half : -half;
          seen = seen || (positive && eye[other] > half);
        }
      }
      if (!seen)
      {
        continue;
      }
      for (double t = 0.1; t < 0.95; t += 0.1)
      {
        const double point[3] = { ends[0][0] + t * (ends[1][0] - ends[0][0]),
          ends[0][1] + t * (ends[1][1] - ends[0][1]), ends[0][2] + t * (ends[1][2] - ends[0][2]) };
        double pixel[2];
        scene.Project(point, pixel);
        // The nearest pixel that is at least half covered.
        double nearest = 10.0;
        for (int y = static_cast<int>(pixel[1]) - 3; y <= static_cast<int>(pixel[1]) + 4; ++y)
        {
          for (int x = static_cast<int>(pixel[0]) - 3; x <= static_cast<int>(pixel[0]) + 4; ++x)
          {
            if (cover[static_cast<std::size_t>(y * Size + x)] > 0.45)
            {
              nearest = std::min(nearest, std::hypot(x - pixel[0], y - pixel[1]));
            }
          }
        }
        worst = std::max(worst, nearest);
        ++places;
      }
    }
  }
  RELIEVO_CHECK(places == 81);
  // Half a pixel to the line, half a pixel from there to a pixel's centre, each slanting.
  RELIEVO_CHECK_AT_MOST(worst, 1.0, std::string("pixels from the edges of ") + what);
}

void TestCreases()
{
  Scene scene;
  scene.Look(3.0, 2.0, 4.0);
  vtkNew<vtkCubeSource> cube;
  scene.Add(cube);
  CheckCube(scene, 0.5, "a cube");
  const double all = Total(scene.Cover());
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.2);
  CheckCube(scene, 0.5, "a cube in parallel projection");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Stage->SetCreaseAngle(91.0);
  const double outlines = Total(scene.Cover());
  RELIEVO_CHECK(outlines < 0.8 * all && outlines > 0.5 * all);
  scene.Stage->CreasesOff();
  RELIEVO_CHECK_NEAR(Total(scene.Cover()), outlines, 1e-9, "without creases");
  scene.Stage->OutlinesOff();
  RELIEVO_CHECK_NEAR(Total(scene.Cover()), 0.0, 1e-9, "a convex body has no folds");
}

// A plate of one mesh before another one of it: its edge is a fold.
void TestFolds()
{
  Scene scene;
  vtkNew<vtkPlaneSource> back;
  back->SetOrigin(-3.0, -3.0, 0.0);
  back->SetPoint1(3.0, -3.0, 0.0);
  back->SetPoint2(-3.0, 3.0, 0.0);
  vtkNew<vtkPlaneSource> front;
  front->SetOrigin(-3.0, -3.0, 1.0);
  front->SetPoint1(0.3, -3.0, 1.0);
  front->SetPoint2(-3.0, 3.0, 1.0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(back->GetOutputPort());
  both->AddInputConnection(front->GetOutputPort());
  scene.Add(both);
  const double edge[3] = { 0.3, 0.0, 1.0 };
  double pixel[2];
  scene.Project(edge, pixel);
  const std::vector<double> cover = scene.Cover();
  for (int y = 5; y < Size - 5; ++y)
  {
    RELIEVO_CHECK_NEAR(Middle(cover, y, 3, Size - 4), pixel[0], 0.5, "the fold");
  }
  scene.Stage->FoldsOff();
  RELIEVO_CHECK_NEAR(Total(scene.Cover()), 0.0, 1e-9, "without folds");
}

// Smooth waves seen at grazing angles up to the horizon: steep in the picture, and no lines.
void TestGround()
{
  for (const double height : { 0.3, 1.0, 3.0 })
  {
    Scene scene(101);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-60.0, 0.0, 60.0);
    plane->SetPoint1(60.0, 0.0, 60.0);
    plane->SetPoint2(-60.0, 0.0, -60.0);
    plane->SetResolution(400, 400);
    plane->Update();
    vtkNew<vtkPolyData> waves;
    waves->DeepCopy(plane->GetOutput());
    vtkPoints* points = waves->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      // Flatter than the flattest ray that meets it, so that no wave hides another one.
      p[1] = 0.2 * height / 60.0 * std::sin(p[0]) * std::sin(p[2]);
      points->SetPoint(i, p);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(waves);
    scene.Add(mapper);
    scene.Look(0.0, height, 55.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -300.0);
    scene.Stage->OutlinesOff();
    RELIEVO_CHECK_NEAR(
      Total(scene.Cover()), 0.0, 1e-9, "speckle from the height " + std::to_string(height));
  }
}

// The edges of a mesh of triangles, as they are projected, in double. Creases: of the angle, and
// seen from outside. Lines: all where there may be one, with silhouettes and angles a little less.
struct ProjectedEdges
{
  using Edge = std::array<glm::dvec2, 2>;
  std::vector<Edge> Creases;
  std::vector<Edge> Lines;

  ProjectedEdges(Scene& scene, vtkPolyData* mesh, double angle)
  {
    struct Face
    {
      glm::dvec3 Normal;
      bool Front;
    };
    glm::dvec3 eye;
    scene.Renderer->GetActiveCamera()->GetPosition(&eye.x);
    std::map<std::pair<vtkIdType, vtkIdType>, std::vector<Face>> edges;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdList* ids = mesh->GetCell(cell)->GetPointIds();
      RELIEVO_CHECK(ids->GetNumberOfIds() == 3);
      glm::dvec3 corners[3];
      for (int i = 0; i < 3; ++i)
      {
        mesh->GetPoint(ids->GetId(i), &corners[i].x);
      }
      Face face;
      face.Normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
      face.Front = glm::dot(face.Normal, eye - corners[0]) > 0.0;
      for (int i = 0; i < 3; ++i)
      {
        edges[std::minmax(ids->GetId(i), ids->GetId((i + 1) % 3))].push_back(face);
      }
    }
    for (const auto& edge : edges)
    {
      const Face& one = edge.second.front();
      const Face& other = edge.second.back();
      RELIEVO_CHECK(edge.second.size() == 2);
      const double between = std::acos(std::min(1.0, glm::dot(one.Normal, other.Normal)));
      const double degrees = between * 180.0 / M_PI;
      Edge projected;
      const vtkIdType ends[2] = { edge.first.first, edge.first.second };
      for (int i = 0; i < 2; ++i)
      {
        scene.Project(mesh->GetPoint(ends[i]), &projected[static_cast<std::size_t>(i)].x);
      }
      if (one.Front && other.Front && degrees > angle + 0.5)
      {
        this->Creases.push_back(projected);
      }
      if (one.Front != other.Front || degrees > angle - 0.5)
      {
        this->Lines.push_back(projected);
      }
    }
  }

  static double GetDistance(const glm::dvec2& point, const Edge& edge)
  {
    const glm::dvec2 along = edge[1] - edge[0];
    const double t = glm::dot(point - edge[0], along) / std::max(1e-12, glm::dot(along, along));
    return glm::length(point - edge[0] - glm::clamp(t, 0.0, 1.0) * along);
  }
};

// On balls of facets: dark pixels are within `limit` pixels of creases and silhouettes, none where
// triangles touch in a corner alone, and creases are covered but for their last pixels.
void TestFacets(
  int theta, int phi, double angle, const glm::dvec3& eye, int size, double limit = 2.5)
{
  const std::string what = std::to_string(theta) + " x " + std::to_string(phi) + " from " +
    std::to_string(eye.x) + " in " + std::to_string(size) + " pixels";
  Scene scene;
  scene.Window->SetSize(size, size);
  scene.Look(eye.x, eye.y, eye.z);
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(theta);
  ball->SetPhiResolution(phi);
  scene.Add(ball);
  scene.Stage->SetCreaseAngle(angle);
  const std::vector<double> cover = scene.Cover();
  const ProjectedEdges edges(scene, ball->GetOutput(), angle);
  std::vector<glm::dvec2> dark;
  double farthest = 0.0;
  for (int i = 0; i < size * size; ++i)
  {
    if (cover[static_cast<std::size_t>(i)] > 0.3)
    {
      const glm::dvec2 pixel(i % size, i / size);
      double nearest = HUGE_VAL;
      for (const ProjectedEdges::Edge& edge : edges.Lines)
      {
        nearest = std::min(nearest, ProjectedEdges::GetDistance(pixel, edge));
      }
      farthest = std::max(farthest, nearest);
      dark.push_back(pixel);
    }
  }
  RELIEVO_CHECK(dark.size() > 300);
  RELIEVO_CHECK_AT_MOST(farthest, limit, "pixels from creases and silhouettes, " + what);
  double worst = 0.0;
  for (const ProjectedEdges::Edge& edge : edges.Creases)
  {
    const double length = glm::length(edge[1] - edge[0]);
    for (double at = 3.5; at < length - 3.5; at += 1.0)
    {
      const glm::dvec2 point = edge[0] + at / length * (edge[1] - edge[0]);
      double nearest = HUGE_VAL;
      for (const glm::dvec2& pixel : dark)
      {
        nearest = std::min(nearest, glm::length(pixel - point));
      }
      worst = std::max(worst, nearest);
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1.0, "pixels from lines on creases, " + what);
}

void TestFacets()
{
  for (const int size : { 201, 403 })
  {
    for (const glm::dvec3& eye :
      { glm::dvec3(0.0, 0.0, 2.0), glm::dvec3(0.6, 0.4, 1.9), glm::dvec3(1.4, -1.1, 1.0) })
    {
      TestFacets(8, 8, 30.0, eye, size);
      TestFacets(12, 12, 30.0, eye, size);
      TestFacets(16, 16, 20.0, eye, size);
      // Where facets are slivers, beside the silhouette, their corners are several pixels long.
      TestFacets(40, 35, 10.0, eye, size, 10.0);
    }
  }
}

// Parts: actors, glyphs and blocks side by side in one plane have lines between them; pieces of one
// actor have none.
void TestParts()
{
  const auto plate = [](double left) {
    auto source = vtkSmartPointer<vtkPlaneSource>::New();
    source->SetOrigin(left, -1.0, 0.0);
    source->SetPoint1(left + 0.5, -1.0, 0.0);
    source->SetPoint2(left, 1.0, 0.0);
    return source;
  };
  const auto between = [](Scene& scene) {
    const std::vector<double> cover = scene.Cover();
    double sum = 0.0;
    for (int x = Size / 2 - 3; x <= Size / 2 + 3; ++x)
    {
      sum += cover[static_cast<std::size_t>(Size / 2 * Size + x)];
    }
    return sum;
  };
  {
    Scene scene;
    scene.Add(plate(-0.5));
    scene.Add(plate(0.0));
    RELIEVO_CHECK_NEAR(between(scene), 1.0, 0.02, "between actors");
  }
  {
    Scene scene;
    vtkNew<vtkAppendPolyData> one;
    one->AddInputConnection(plate(-0.5)->GetOutputPort());
    one->AddInputConnection(plate(0.0)->GetOutputPort());
    scene.Add(one);
    RELIEVO_CHECK_NEAR(between(scene), 0.0, 1e-9, "within an actor");
  }
  {
    Scene scene;
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (int i = 0; i < 2; ++i)
    {
      auto source = plate(0.5 * i - 0.5);
      source->Update();
      blocks->SetBlock(static_cast<unsigned int>(i), source->GetOutput());
    }
    vtkNew<vtkRelievoCompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    scene.Add(mapper);
    // More parts than OpenGL's list can hold count as one.
    const relievoTest::GLCheck gl(scene.Window);
    vtkRelievoTextureBuffer::SetMostTexels(1);
    RELIEVO_CHECK_NEAR(between(scene), 0.0, 1e-9, "between too many blocks");
    vtkRelievoTextureBuffer::SetMostTexels(0);
    RELIEVO_CHECK_NEAR(between(scene), 1.0, 0.02, "between blocks");
  }
  {
    Scene scene;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-0.5, 0.0, 0.0);
    points->InsertNextPoint(0.0, 0.0, 0.0);
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(places);
    mapper->SetSourceConnection(plate(0.0)->GetOutputPort());
    mapper->ScalingOff();
    scene.Add(mapper);
    RELIEVO_CHECK_NEAR(between(scene), 1.0, 0.02, "between glyphs");
  }
}

void TestSettings()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  scene.Stage->EnabledOff();
  vtkNew<vtkCubeSource> cube;
  scene.Add(cube);
  vtkSmartPointer<vtkImageData> plain = scene.Picture();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->EnabledOn();
  const double one = Total(scene.Cover());
  RELIEVO_CHECK(scene.Stage->GetBytesHeld() == 4 * Size * Size);
  // An axis-aligned square of whole pixels or not: its lines cover width times length.
  scene.Stage->SetWidth(3.0);
  const double three = Total(scene.Cover());
  RELIEVO_CHECK_NEAR(three / one, 3.0, 0.06, "cover of the width 3");
  RELIEVO_CHECK(scene.Stage->TrySetParameter("color", "1,0,0").empty());
  const double red = Total(scene.Cover());
  RELIEVO_CHECK_NEAR(red, 0.0, 1e-9, "red lines in the red channel");
  scene.Stage->SetWidth(0.0);
  RELIEVO_CHECK(SamePicture(plain, scene.Picture()));
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle");
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(vtkRelievoPass::Detach(scene.Renderer));
  RELIEVO_CHECK(SamePicture(plain, scene.Picture()));
  gl.Poll("end of the test");
}
}

RELIEVO_TEST_CASE(testLinesStage)
{
  relievoTest::Session session;
  TestSilhouette();
  TestCreases();
  TestFolds();
  TestGround();
  TestFacets();
  TestParts();
  TestSettings();
  return session.Result();
}
}
