// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hidden lines of vtkRelievoLinesStage: dashes against projected edges, rims and silhouettes in
// double, and how much of them is dash; that there are none if nothing is hidden; scenes in
// which they could fail; that switched off they leave no trace.
#include "Check.h"
#include "GLCheck.h"
#include "LinesScene.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkActorCollection.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace testDashedLines
{
using namespace linesTest;

namespace
{
using Point = std::array<double, 3>;
using Line = std::vector<Point>;

// The contribution of dashes to the visible lines.
std::vector<double> Dashes(Scene& scene)
{
  scene.Stage->SetHiddenToOff();
  const std::vector<double> seen = scene.Cover();
  scene.Stage->SetHiddenToDashed();
  std::vector<double> cover = scene.Cover();
  for (std::size_t i = 0; i < cover.size(); ++i)
  {
    cover[i] -= seen[i];
    RELIEVO_CHECK_THAT(cover[i] >= 0.0, "dashes take nothing away");
  }
  return cover;
}

// Lines in the picture, in steps of less than a pixel.
struct Places
{
  std::vector<std::array<double, 2>> At;
  double Length = 0.0;

  Places(Scene& scene, const std::vector<Line>& lines)
  {
    for (const Line& line : lines)
    {
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        double a[2];
        double b[2];
        scene.Project(line[i - 1].data(), a);
        scene.Project(line[i].data(), b);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const int steps = static_cast<int>(20.0 * length) + 1;
        for (int k = 0; k <= steps; ++k)
        {
          const double t = static_cast<double>(k) / steps;
          this->At.push_back({ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) });
        }
        this->Length += length;
      }
    }
  }

  // From a pixel's centre, with the nearest place.
  double GetDistance(double x, double y, std::array<double, 2>& nearest) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& each : this->At)
    {
      const double distance = std::hypot(each[0] - x, each[1] - y);
      if (distance < least)
      {
        least = distance;
        nearest = each;
      }
    }
    return least;
  }
};

// Every dash lies on one of the lines, with its middle within half a pixel of it, and together they
// cover that share of the lines' lengths, except for ends before a silhouette.
void CheckDashes(
  Scene& scene, const std::vector<Line>& lines, const std::string& what, double room = 0.06)
{
  const std::vector<double> cover = Dashes(scene);
  const Places places(scene, lines);
  const double width = scene.Stage->GetWidth();
  const int columns = scene.Window->GetSize()[0];
  double farthest = 0.0;
  // Across the line, in cells of the picture of four pixels' width.
  struct Cell
  {
    double Cover = 0.0;
    double X = 0.0;
    double Y = 0.0;
    double LineX = 0.0;
    double LineY = 0.0;
  };
  std::vector<Cell> cells(cover.size());
  for (std::size_t i = 0; i < cover.size(); ++i)
  {
    if (cover[i] < 0.02)
    {
      continue;
    }
    const int row = static_cast<int>(i) / columns;
    const double x = static_cast<int>(i) - row * columns;
    const double y = row;
    std::array<double, 2> nearest{};
    farthest = std::max(farthest, places.GetDistance(x, y, nearest));
    const auto at =
      static_cast<std::size_t>(static_cast<int>(std::max(0.0, nearest[1]) / 4) * columns +
        static_cast<int>(std::max(0.0, nearest[0]) / 4));
    Cell& cell = cells[at];
    cell.Cover += cover[i];
    cell.X += cover[i] * x;
    cell.Y += cover[i] * y;
    cell.LineX += cover[i] * nearest[0];
    cell.LineY += cover[i] * nearest[1];
  }
  double off = 0.0;
  for (const Cell& cell : cells)
  {
    if (cell.Cover > 2.0 * width)
    {
      off = std::max(off, std::hypot(cell.X - cell.LineX, cell.Y - cell.LineY) / cell.Cover);
    }
  }
  RELIEVO_CHECK_AT_MOST(
    farthest, 0.5 * width + 0.75, "pixels from a hidden line to what is drawn, " + what);
  RELIEVO_CHECK_AT_MOST(off, 0.5, "pixels that dashes are beside their line, " + what);
  RELIEVO_CHECK_NEAR(
    Total(cover) / width / places.Length, 2.0 / 3.0, room, "share of dashes, " + what);
}

std::vector<Line> HiddenEdges(double half)
{
  const Point corner = { -half, -half, -half };
  std::vector<Line> edges;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Point end = corner;
    end[axis] = half;
    edges.push_back({ corner, end });
  }
  return edges;
}

// Three edges of a cube are hidden, and they meet in a corner; however its triangles share points.
void TestCube()
{
  for (const bool shared : { false, true })
  {
    Scene scene;
    scene.Look(1.8, 1.2, 2.4);
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(cube->GetOutputPort());
    vtkAlgorithm* source = triangles;
    scene.Add(shared ? cube : source);
    const std::string what = shared ? "a cube" : "a cube of triangles";
    for (const double width : { 1.0, 2.5 })
    {
      scene.Stage->SetWidth(width);
      CheckDashes(scene, HiddenEdges(0.5), what + ", width " + std::to_string(width));
    }
    scene.Stage->SetDash(15.0);
    CheckDashes(scene, HiddenEdges(0.5), what + " with long dashes");
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(0.8);
    CheckDashes(scene, HiddenEdges(0.5), what + " in parallel projection");
    // A convex body hides none of its silhouette.
    scene.Stage->CreasesOff();
    RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "a cube's silhouette");
    scene.Stage->CreasesOn();
    scene.Stage->SetCreaseAngle(91.0);
    RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "edges below the crease angle");
  }
}

// A scaled, turned and mirrored actor, and one far from the origin.
void TestPlaced()
{
  Scene scene;
  vtkNew<vtkCubeSource> cube;
  scene.Add(cube);
  vtkActor* actor = scene.Renderer->GetActors()->GetLastActor();
  vtkNew<vtkTransform> transform;
  transform->Translate(1e4, -2e4, 3e4);
  transform->RotateWXYZ(25.0, 1.0, 2.0, 0.5);
  transform->Scale(-0.8, 1.1, 0.6);
  actor->SetUserTransform(transform);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(1e4 + 1.8, -2e4 + 1.2, 3e4 + 2.4);
  camera->SetFocalPoint(1e4, -2e4, 3e4);
  // The corner that is farthest away is the one whose three edges are hidden.
  Point hidden{};
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point at = { corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5 };
    double placed[3];
    transform->TransformPoint(at.data(), placed);
    const double* eye = camera->GetPosition();
    const double away =
      std::hypot(std::hypot(placed[0] - eye[0], placed[1] - eye[1]), placed[2] - eye[2]);
    if (away > most)
    {
      most = away;
      hidden = at;
    }
  }
  std::vector<Line> edges;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Point end = hidden;
    end[axis] = -end[axis];
    Line edge(2);
    transform->TransformPoint(hidden.data(), edge[0].data());
    transform->TransformPoint(end.data(), edge[1].data());
    edges.push_back(edge);
  }
  CheckDashes(scene, edges, "a mirrored box far from the origin");
}

// The far half of a cylinder's lower rim.
void TestCylinder()
{
  Scene scene;
  scene.Look(0.0, 1.5, 3.2);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(180);
  cylinder->SetRadius(0.6);
  cylinder->SetHeight(1.0);
  scene.Add(cylinder);
  // A wall of the normal n faces away where n * eye < radius.
  const double limit = std::acos(0.6 / 3.2);
  Line rim;
  for (int i = 0; i <= 400; ++i)
  {
    const double angle = limit + i / 400.0 * (2.0 * M_PI - 2.0 * limit);
    rim.push_back({ 0.6 * std::sin(angle), -0.5, 0.6 * std::cos(angle) });
  }
  CheckDashes(scene, { rim }, "a cylinder's rim");
}

// The silhouette of a ball behind a plate: a circle in double, whose small edges are one line.
void TestBall()
{
  Scene scene;
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(300);
  ball->SetPhiResolution(300);
  ball->SetRadius(0.8);
  scene.Add(ball);
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(-3.0, -3.0, 1.5);
  plate->SetPoint1(3.0, -3.0, 1.5);
  plate->SetPoint2(-3.0, 3.0, 1.5);
  scene.Add(plate);
  // Where rays from the eye touch the ball.
  const double z = 0.8 * 0.8 / 5.0;
  const double radius = std::sqrt(0.8 * 0.8 - z * z);
  Line circle;
  for (int i = 0; i <= 720; ++i)
  {
    const double angle = i * M_PI / 360.0;
    circle.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
  }
  CheckDashes(scene, { circle }, "a ball behind a plate");
  // Edges of the plate itself are out of the picture; the ball alone hides nothing.
  scene.Renderer->RemoveActor(scene.Renderer->GetActors()->GetLastActor());
  RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "a ball alone");
}

// The border of a plate behind another one, part by part: parts that extend beyond it are not
// dashed.
void TestPlates()
{
  Scene scene;
  vtkNew<vtkPlaneSource> front;
  front->SetOrigin(-0.5, -0.5, 1.0);
  front->SetPoint1(0.5, -0.5, 1.0);
  front->SetPoint2(-0.5, 0.5, 1.0);
  front->SetResolution(7, 5);
  scene.Add(front);
  vtkNew<vtkPlaneSource> back;
  back->SetOrigin(-0.4, -0.4, 0.0);
  back->SetPoint1(1.2, -0.4, 0.0);
  back->SetPoint2(-0.4, 0.4, 0.0);
  back->SetResolution(3, 1);
  scene.Add(back);
  const double end = 0.5 * 5.0 / 4.0; // of the front plate's shadow from the eye
  CheckDashes(scene,
    { { { end, -0.4, 0.0 }, { -0.4, -0.4, 0.0 }, { -0.4, 0.4, 0.0 }, { end, 0.4, 0.0 } } },
    "a plate behind another one");
  // Without outlines and folds there are no borders.
  scene.Stage->OutlinesOff();
  scene.Stage->FoldsOff();
  RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "without outlines and folds");
}

// Nothing is hidden: open ground up to the horizon, a steep valley, plates that meet in a room.
void TestSeen()
{
  Scene scene;
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-60.0, 0.0, 60.0);
  ground->SetPoint1(60.0, 0.0, 60.0);
  ground->SetPoint2(-60.0, 0.0, -60.0);
  ground->SetResolution(50, 50);
  scene.Add(ground);
  for (const double height : { 0.05, 0.5, 5.0 })
  {
    scene.Look(0.0, height, 55.0);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -300.0);
    RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "ground, from " + std::to_string(height));
  }
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-60.0, 0.0, -60.0);
  wall->SetPoint1(60.0, 0.0, -60.0);
  wall->SetPoint2(-60.0, 60.0, -60.0);
  scene.Add(wall);
  scene.Look(3.0, 4.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -60.0);
  RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "wall and ground");
  vtkNew<vtkPoints> points;
  for (const double x : { -1.0, 0.0, 1.0 })
  {
    points->InsertNextPoint(x, -1.0, x == 0.0 ? -2.0 : 0.0);
    points->InsertNextPoint(x, 1.0, x == 0.0 ? -2.0 : 0.0);
  }
  vtkNew<vtkPolyData> valley;
  valley->SetPoints(points);
  valley->AllocateExact(2, 8);
  for (vtkIdType first : { 0, 2 })
  {
    const vtkIdType ids[4] = { first, first + 2, first + 3, first + 1 };
    valley->InsertNextCell(VTK_QUAD, 4, ids);
  }
  Scene steep;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(valley);
  steep.Add(mapper);
  for (const double x : { 0.0, 0.3, 0.6 })
  {
    steep.Look(x, 0.2, 5.0);
    RELIEVO_CHECK_NEAR(Total(Dashes(steep)), 0.0, 1e-9, "a valley, from " + std::to_string(x));
  }
}

// Scenes in which edges could go wrong.
void TestStability()
{
  {
    Scene scene; // empty
    RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "nothing");
  }
  {
    Scene scene; // from within; edges run past the eye and behind it
    scene.Look(0.1, 0.2, 0.3);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -1.0);
    vtkNew<vtkCubeSource> cube;
    scene.Add(cube);
    RELIEVO_CHECK_NEAR(Total(Dashes(scene)), 0.0, 1e-9, "from within a cube");
    // A small one behind its wall, and a long one from behind the eye to the horizon below it.
    vtkNew<vtkCubeSource> more;
    more->SetCenter(0.0, 0.0, -1.5);
    more->SetXLength(0.4);
    more->SetYLength(0.4);
    scene.Add(more);
    const double far = Total(Dashes(scene));
    RELIEVO_CHECK(far > 100.0);
    more->SetBounds(-0.2, 0.2, -0.9, -0.8, -1e6, 1e6);
    scene.Renderer->GetActiveCamera()->SetClippingRange(0.05, 1e4);
    const double dashes = Total(Dashes(scene));
    RELIEVO_CHECK_THAT(std::isfinite(dashes) && dashes > 20.0,
      "dashes of a beam below the floor: " + std::to_string(dashes));
  }
  {
    // Points that are nowhere, a triangle without an area, one that is there twice.
    vtkNew<vtkCubeSource> cube;
    cube->Update();
    vtkNew<vtkPolyData> broken;
    broken->DeepCopy(cube->GetOutput());
    const vtkIdType nowhere = broken->GetPoints()->InsertNextPoint(std::nan(""), 0.0, std::nan(""));
    broken->GetPointData()->Initialize();
    const vtkIdType triangles[3][3] = { { 0, 1, nowhere }, { 0, 0, 1 }, { 2, 2, 2 } };
    for (const auto& ids : triangles)
    {
      broken->GetPolys()->InsertNextCell(3, ids);
    }
    broken->Modified();
    Scene scene;
    scene.Look(1.8, 1.2, 2.4);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(broken);
    scene.Add(mapper);
    scene.Stage->FoldsOff();
    CheckDashes(scene, HiddenEdges(0.5), "a cube with broken triangles", 0.08);
  }
  {
    // Glyphs are placed where VTK draws them; unsupported props are reported.
    Scene scene;
    scene.Look(1.8, 1.2, 2.4);
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(places);
    mapper->SetSourceConnection(cube->GetOutputPort());
    mapper->SetScaleFactor(0.8);
    scene.Add(mapper);
    CheckDashes(scene, HiddenEdges(0.4), "a glyph");
    scene.Renderer->GetActors()->GetLastActor()->GetProperty()->SetRepresentationToWireframe();
    scene.Window->Render();
    RELIEVO_CHECK_THAT(
      scene.Stage->GetReason() == "1 prop without readable triangles has no hidden lines",
      scene.Stage->GetReason());
  }
  {
    Scene scene(1);
    scene.Window->SetSize(1, 1);
    vtkNew<vtkCubeSource> cube;
    scene.Add(cube);
    RELIEVO_CHECK(std::isfinite(Total(Dashes(scene))));
  }
}

// The picture depends on the scene and not on earlier drawings; moved points count.
void TestSettings()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  scene.Look(1.8, 1.2, 2.4);
  vtkNew<vtkCubeSource> cube;
  scene.Add(cube);
  vtkSmartPointer<vtkImageData> off = scene.Picture();
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  RELIEVO_CHECK(scene.Stage->TrySetParameter("hidden", "dashed").empty());
  RELIEVO_CHECK(scene.Stage->TrySetParameter("dash", "8").empty());
  vtkSmartPointer<vtkImageData> dashed = scene.Picture();
  RELIEVO_CHECK(!SamePicture(off, dashed));
  RELIEVO_CHECK(SamePicture(dashed, scene.Picture()));
  scene.Look(-2.0, 2.0, 2.0);
  scene.Picture();
  cube->SetXLength(1.4);
  scene.Look(1.8, 1.2, 2.4);
  RELIEVO_CHECK(!SamePicture(dashed, scene.Picture()));
  cube->SetXLength(1.0);
  RELIEVO_CHECK(SamePicture(dashed, scene.Picture()));
  RELIEVO_CHECK(scene.Stage->TrySetParameter("hidden", "dotted") != "");
  scene.Stage->SetHiddenToOff();
  RELIEVO_CHECK(SamePicture(off, scene.Picture()));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == bytes);
  gl.Poll("end of the test");
}
}

RELIEVO_TEST_CASE(testDashedLines)
{
  relievoTest::Session session;
  TestCube();
  TestPlaced();
  TestCylinder();
  TestBall();
  TestPlates();
  TestSeen();
  TestStability();
  TestSettings();
  return session.Result();
}
}
