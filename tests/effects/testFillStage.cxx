// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoFillStage: a sphere against the closed form of its lights' nine coefficients, without
// edges; ambient occlusion on walls, on balls above the ground and on a convex body; other lights
// as VTK draws them; lights that follow the camera; the grid of the sky.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoFillLight.h>
#include <vtkRelievoFillStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPlacedMesh.h>
#include <vtkRelievoShadowCatcher.h>
#include <vtkRelievoSkyGrid.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace testFillStage
{
namespace
{
constexpr int Size = 200;

// Seen from +z by parallel rays, 2 units high.
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame = nullptr;
  vtkRelievoFillStage* Stage = nullptr;

  explicit Scene(double occlusion)
  {
    this->Window = relievoTest::MakeWindow(Size, Size, this->Renderer);
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Stage = vtkRelievoFillStage::SafeDownCast(this->Frame->GetStage("fill"));
    this->Stage->SetOcclusion(occlusion);
    this->Look({ 0.0, 0.0, 5.0 }, { 0.0, 1.0, 0.0 });
  }

  void Look(const glm::dvec3& from, const glm::dvec3& up)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetPosition(from.x, from.y, from.z);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetClippingRange(1.0, 9.0);
  }

  void AddLight(const glm::dvec3& towards, double intensity, bool fills)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(towards.x, towards.y, towards.z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(intensity);
    if (fills)
    {
      vtkRelievoFillLight::Make(light);
    }
    this->Renderer->AddLight(light);
  }

  // The presets' lights: the corners of a regular tetrahedron.
  void AddAround(double intensity)
  {
    for (const glm::dvec3& towards : { glm::dvec3(1.0, 1.0, 1.0), glm::dvec3(1.0, -1.0, -1.0),
           glm::dvec3(-1.0, 1.0, -1.0), glm::dvec3(-1.0, -1.0, 1.0) })
    {
      this->AddLight(towards, intensity, true);
    }
  }

  vtkActor* Add(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* AddBall(double radius = 0.9)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(radius);
    ball->SetThetaResolution(200);
    ball->SetPhiResolution(200);
    return this->Add(ball);
  }

  vtkActor* AddPlate(const glm::dvec3& origin, const glm::dvec3& first, const glm::dvec3& second)
  {
    vtkNew<vtkPlaneSource> plate;
    plate->SetOrigin(origin.x, origin.y, origin.z);
    plate->SetPoint1(first.x, first.y, first.z);
    plate->SetPoint2(second.x, second.y, second.z);
    return this->Add(plate);
  }

  vtkSmartPointer<vtkImageData> Picture() { return relievoTest::Picture(this->Window); }
};

double GetGreen(vtkImageData* picture, int x, int y)
{
  return static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0))[1] / 255.0;
}

// A ball's normal at a pixel; zero outside of it and at its rim.
glm::dvec3 GetNormal(int x, int y)
{
  const double nx = ((x + 0.5) / Size * 2.0 - 1.0) / 0.9;
  const double ny = ((y + 0.5) / Size * 2.0 - 1.0) / 0.9;
  const double rest = 1.0 - nx * nx - ny * ny;
  return rest > 0.02 ? glm::dvec3(nx, ny, std::sqrt(rest)) : glm::dvec3(0.0);
}

// The irradiance of a distant light up to harmonics of l = 2, at the cosine t: by Legendre's
// polynomials, from the factors pi, 2 pi / 3 and pi / 4 of a clamped cosine.
double GetLobe(double t)
{
  return 0.25 + 0.5 * t + 5.0 / 16.0 * 0.5 * (3.0 * t * t - 1.0);
}

void TestClosedForm()
{
  Scene scene(0.0);
  relievoTest::GLCheck gl(scene.Window);
  scene.AddBall();
  const glm::dvec3 first = glm::normalize(glm::dvec3(-0.6, 0.5, 0.7));
  const glm::dvec3 second = glm::normalize(glm::dvec3(0.9, -0.3, 0.1));
  const glm::dvec3 key = glm::normalize(glm::dvec3(0.2, 0.9, 0.4));
  scene.AddLight(first, 0.5, true);
  scene.AddLight(key, 0.3, false);
  scene.AddLight(second, 0.4, true);
  vtkSmartPointer<vtkImageData> picture = scene.Picture();
  double worst = 0.0;
  int pixels = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const glm::dvec3 n = GetNormal(x, y);
      if (n != glm::dvec3(0.0))
      {
        const double fill = 0.5 * GetLobe(glm::dot(n, first)) + 0.4 * GetLobe(glm::dot(n, second));
        const double expected = std::max(0.0, fill) + 0.3 * std::max(0.0, glm::dot(n, key));
        worst = std::max(worst, std::abs(GetGreen(picture, x, y) - expected));
        ++pixels;
      }
    }
  }
  RELIEVO_CHECK(pixels > 20000);
  RELIEVO_CHECK_NEAR(worst, 0.0, 0.012, "a ball in the light of two fill lights and another");
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");

  // Lights that are marked no more are VTK's lights, until they are marked again.
  std::vector<vtkLight*> fills;
  scene.Renderer->GetLights()->InitTraversal();
  while (vtkLight* light = scene.Renderer->GetLights()->GetNextItem())
  {
    if (scene.Stage->GetLightFills(light))
    {
      fills.push_back(light);
    }
  }
  RELIEVO_CHECK(fills.size() == 2);
  for (vtkLight* light : fills)
  {
    scene.Stage->SetLightFills(light, false);
  }
  const auto unmarked = scene.Picture();
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle");
  for (vtkLight* light : fills)
  {
    scene.Stage->SetLightFills(light, true);
  }
  RELIEVO_CHECK(relievoTest::SamePicture(picture, scene.Picture(), "lights marked again"));
  {
    const relievoTest::ExpectMessage none("SetLightFills was given no light");
    scene.Stage->SetLightFills(nullptr, true);
    RELIEVO_CHECK(none.Count() == 1);
    const relievoTest::ExpectMessage positional("SetLightFills was given a positional light");
    vtkNew<vtkLight> lamp;
    lamp->PositionalOn();
    scene.Stage->SetLightFills(lamp, true);
    RELIEVO_CHECK(positional.Count() == 1 && !scene.Stage->GetLightFills(lamp));
  }

  // Off, they are VTK's lights.
  scene.Stage->EnabledOff();
  vtkSmartPointer<vtkImageData> off = scene.Picture();
  vtkRelievoPass::Detach(scene.Renderer);
  vtkSmartPointer<vtkImageData> plain = scene.Picture();
  RELIEVO_CHECK(relievoTest::SamePicture(plain, unmarked, "lights that are not marked"));
  RELIEVO_CHECK(std::memcmp(off->GetScalarPointer(), plain->GetScalarPointer(),
                  3 * static_cast<std::size_t>(plain->GetNumberOfPoints())) == 0);
  gl.Poll("end of the closed form");
}

// The largest kink along the picture's middle row: the second difference over steps of 10 pixels.
double FindKink(vtkImageData* picture)
{
  double worst = 0.0;
  for (int x = 30; x < Size - 30; ++x)
  {
    worst = std::max(worst,
      std::abs(GetGreen(picture, x - 10, 100) - 2.0 * GetGreen(picture, x, 100) +
        GetGreen(picture, x + 10, 100)));
  }
  return worst;
}

void TestSeams()
{
  Scene scene(0.0);
  scene.AddBall();
  scene.AddAround(0.6);
  vtkSmartPointer<vtkImageData> picture = scene.Picture();
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      if (GetNormal(x, y) != glm::dvec3(0.0))
      {
        RELIEVO_CHECK_NEAR(GetGreen(picture, x, y), 0.6, 0.003, "a ball in even light");
      }
    }
  }
  RELIEVO_CHECK(FindKink(picture) < 0.006);
  scene.Stage->EnabledOff(); // the measure finds the edges of VTK's lights
  RELIEVO_CHECK(FindKink(scene.Picture()) > 0.02);
}

// The mean in a square of 9 x 9 pixels.
double GetMean(vtkImageData* picture, int x, int y)
{
  double sum = 0.0;
  for (int j = -4; j <= 4; ++j)
  {
    for (int i = -4; i <= 4; ++i)
    {
      sum += GetGreen(picture, x + i, y + j);
    }
  }
  return sum / 81.0;
}

void TestOcclusion()
{
  // Convex bodies see all of their surroundings.
  Scene ball(1.0);
  ball.AddBall();
  ball.AddAround(0.6);
  vtkSmartPointer<vtkImageData> picture = ball.Picture();
  for (const int x : { 20, 60, 100, 140, 180 })
  {
    RELIEVO_CHECK_NEAR(GetMean(picture, x, 100), 0.6, 0.03, "on a ball");
  }

  // A floor at a wall: the share of the sky above a long wall of height h at the distance d is half
  // of 1 + cos(atan(h / d)).
  Scene corner(1.0);
  corner.AddPlate({ -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { -1.0, 1.0, 0.0 });
  vtkActor* wall = corner.AddPlate({ -0.9, -1.0, 0.0 }, { -0.9, 1.0, 0.0 }, { -0.9, -1.0, 0.8 });
  corner.AddAround(0.6);
  picture = corner.Picture();
  for (const int x : { 18, 30, 50, 100, 190 })
  {
    const double away = (x + 0.5) / Size * 2.0 - 1.0 + 0.9;
    const double share = 0.5 + 0.5 * std::cos(std::atan(0.8 / away));
    RELIEVO_CHECK_NEAR(GetMean(picture, x, 100), 0.6 * std::sqrt(share), 0.08,
      "on a floor at pixel " + std::to_string(x));
  }
  // Next to the wall the few directions, some of them along both planes, see 0.69 of the sky
  // instead of 0.55.
  RELIEVO_CHECK(GetMean(picture, 18, 100) < 0.9 * GetMean(picture, 190, 100));
  // Another light is not darkened.
  const auto bright = corner.Picture();
  corner.AddLight({ 0.0, 0.0, 1.0 }, 0.3, false);
  const auto lit = corner.Picture();
  RELIEVO_CHECK_NEAR(GetMean(lit, 18, 100) - GetMean(bright, 18, 100), 0.3, 0.01, "by a key light");
  // The grid follows the scene.
  wall->VisibilityOff();
  RELIEVO_CHECK_NEAR(GetMean(corner.Picture(), 18, 100), 0.9, 0.02, "without the wall");
  RELIEVO_CHECK(corner.Stage->GetBytesHeld() > 0);
  corner.Frame->ReleaseGraphicsResources(corner.Window);
  RELIEVO_CHECK(corner.Stage->GetBytesHeld() == 0);
}

// Near the ground a ball gets less light from below than without a ground.
void TestGround()
{
  std::vector<double> foot;
  for (const bool hasGround : { false, true })
  {
    Scene scene(1.0);
    scene.Look({ 0.0, -5.0, 0.0 }, { 0.0, 0.0, 1.0 });
    scene.AddBall();
    if (hasGround)
    {
      vtkActor* ground =
        scene.AddPlate({ -3.0, -3.0, -0.9 }, { 3.0, -3.0, -0.9 }, { -3.0, 3.0, -0.9 });
      ground->ForceTranslucentOn();
      vtkRelievoShadowCatcher::Make(ground);
    }
    scene.AddAround(0.6);
    const auto picture = scene.Picture();
    foot.push_back(GetMean(picture, 100, 24));
    RELIEVO_CHECK_NEAR(GetMean(picture, 100, 150), 0.6, 0.03, "the upper side of a ball");
  }
  RELIEVO_CHECK(foot[1] < foot[0] - 0.05);

  // High above the ground a ball sees all of its surroundings.
  Scene scene(1.0);
  scene.Look({ 0.0, -5.0, 0.0 }, { 0.0, 0.0, 1.0 });
  scene.AddBall();
  vtkActor* ground = scene.AddPlate({ -3.0, -3.0, -4.0 }, { 3.0, -3.0, -4.0 }, { -3.0, 3.0, -4.0 });
  ground->ForceTranslucentOn();
  vtkRelievoShadowCatcher::Make(ground);
  scene.AddAround(0.6);
  const auto picture = scene.Picture();
  for (const int y : { 40, 100, 150, 180 })
  {
    RELIEVO_CHECK_NEAR(GetMean(picture, 100, y), 0.6, 0.04, "a raised ball");
  }
  const auto tells = [&scene](const char* words) {
    return scene.Stage->GetReason().find(words) != std::string::npos;
  };
  RELIEVO_CHECK(tells("with ambient occlusion") && !tells("no sky"));
  scene.AddBall(0.5)->GetProperty()->SetRepresentationToWireframe();
  scene.Picture();
  RELIEVO_CHECK(tells("; 1 prop hides no sky"));
}

// Lights that follow the camera are where they belong in the first picture after it has moved.
void TestCamera()
{
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const bool turns : { false, true })
  {
    Scene scene(0.0);
    scene.AddBall();
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(1.0, 0.0, 1.0);
    const vtkMTimeType before = light->GetMTime();
    vtkRelievoFillLight::Make(light);
    RELIEVO_CHECK(light->GetMTime() > before); // samples of the scene are collected anew
    scene.Renderer->AddLight(light);
    if (turns)
    {
      scene.Picture();
    }
    scene.Look({ 5.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    pictures.push_back(scene.Picture());
  }
  RELIEVO_CHECK(GetMean(pictures[0], 150, 100) > GetMean(pictures[0], 50, 100) + 0.2);
  RELIEVO_CHECK(std::memcmp(pictures[0]->GetScalarPointer(), pictures[1]->GetScalarPointer(),
                  3 * static_cast<std::size_t>(Size) * Size) == 0);
}

void TestLightWithoutDirection()
{
  Scene scene(0.0);
  scene.AddBall();
  scene.AddAround(0.6);
  scene.AddLight({ 0.0, 0.0, 0.0 }, 1.0, true);
  RELIEVO_CHECK_NEAR(GetMean(scene.Picture(), 100, 100), 0.6, 0.01, "beside it");
}

vtkSmartPointer<vtkPolyData> MakeSheet(int resolution, double height)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(resolution, resolution);
  plane->SetCenter(0.0, 0.0, height);
  plane->Update();
  return plane->GetOutput();
}

vtkRelievoPlacedMesh PlaceMesh(vtkPolyData* mesh)
{
  vtkRelievoPlacedMesh placed;
  placed.Mesh = mesh;
  return placed;
}

void TestGrid()
{
  const auto sheet = MakeSheet(10, 1.0);
  const vtkRelievoSkyGrid::Ground ground{ 2, true, 0.0 };
  vtkRelievoSkyGrid grid;
  RELIEVO_CHECK(grid.Update({ PlaceMesh(sheet) }, ground));
  const std::vector<std::uint8_t> texels = grid.GetTexels();

  // Colours do not change it; points, and the places of glyphs, do.
  vtkNew<vtkFloatArray> colors;
  colors->SetNumberOfTuples(sheet->GetNumberOfPoints());
  colors->FillValue(1.F);
  sheet->GetPointData()->SetScalars(colors);
  RELIEVO_CHECK(!grid.Update({ PlaceMesh(sheet) }, ground));
  sheet->GetPoints()->Modified();
  RELIEVO_CHECK(grid.Update({ PlaceMesh(sheet) }, ground));
  vtkRelievoPlacedMesh glyphs = PlaceMesh(sheet);
  glyphs.Places = std::make_shared<std::vector<glm::dmat4>>(1, glm::dmat4(1.0));
  RELIEVO_CHECK(grid.Update({ glyphs }, ground));
  RELIEVO_CHECK(grid.GetTexels() == texels);

  // Nothing below the ground hides the sky, and no point outside of polygons does.
  const auto below = MakeSheet(10, -0.5);
  grid.Update({ PlaceMesh(sheet), PlaceMesh(below) }, ground);
  RELIEVO_CHECK(grid.GetTexels() == texels);
  sheet->GetPoints()->InsertNextPoint(0.0, 0.0, 0.5);
  sheet->GetPoints()->Modified();
  grid.Update({ PlaceMesh(sheet) }, ground);
  RELIEVO_CHECK(grid.GetTexels() == texels);

  // Of more polygons than 4 million some are left out, and are not missing.
  std::vector<std::vector<std::uint8_t>> all;
  for (const int resolution : { 101, 301 })
  {
    const auto fine = MakeSheet(resolution, 0.0);
    vtkRelievoPlacedMesh many = PlaceMesh(fine);
    auto places = std::make_shared<std::vector<glm::dmat4>>(48, glm::dmat4(1.0));
    for (std::size_t i = 0; i < places->size(); ++i)
    {
      (*places)[i][3][2] = 0.1 + 0.3 * static_cast<double>(i % 4);
    }
    many.Places = places;
    grid.Update({ many }, ground);
    all.push_back(grid.GetTexels());
  }
  RELIEVO_CHECK(all[0].size() == all[1].size());
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(all[0].size(), all[1].size()); ++i)
  {
    sum += std::abs(all[0][i] - all[1][i]);
  }
  RELIEVO_CHECK(sum < 0.5 * static_cast<double>(all[0].size()));
}
}

RELIEVO_TEST_CASE(testFillStage)
{
  relievoTest::Session session;
  TestClosedForm();
  TestSeams();
  TestOcclusion();
  TestGround();
  TestCamera();
  TestLightWithoutDirection();
  TestGrid();
  return session.Result();
}
}
