// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoAmbientStage: the share of the sky against closed forms and many rays of Embree; places
// with all or none of it; occluders and props that do not occlude; and the darkened
// picture, without the light of lights that cast shadows.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkDiskSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoAmbientStage.h>
#include <vtkRelievoFillLight.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoMeshTexels.h>
#include <vtkRelievoOFFReader.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace testAmbientStage
{
namespace
{
constexpr int Size = 96;
constexpr double Bound = 1.0 / 64.0; // rms at 64 rays

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame = nullptr;
  vtkRelievoAmbientStage* Stage = nullptr;
  double Offset[3] = { 0.0, 0.0, 0.0 }; // of all that is added
  bool InPoints = false;                // the offset of plates, and not in their actors' positions

  explicit Scene(int size = Size)
  {
    this->Window = relievoTest::MakeWindow(size, size, this->Renderer);
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Frame->WaitForSamplesOn();
    this->Stage = vtkRelievoAmbientStage::SafeDownCast(this->Frame->GetStage("ambient"));
    this->Stage->SetSamples(64);
    this->Stage->SetSamplesPerFrame(16);
  }

  void Look(double x, double y, double z, double fx = 0.0, double fy = 0.0, double fz = 0.0)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double* o = this->Offset;
    camera->SetPosition(o[0] + x, o[1] + y, o[2] + z);
    camera->SetFocalPoint(o[0] + fx, o[1] + fy, o[2] + fz);
    camera->SetViewUp(0.0, 0.1, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }

  vtkActor* Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(this->Offset);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* Add(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    return this->Add(mapper);
  }

  // A rectangle by a corner and the ends of two edges.
  vtkActor* AddPlate(const glm::dvec3& corner, const glm::dvec3& first, const glm::dvec3& second)
  {
    const glm::dvec3 o(this->Offset[0], this->Offset[1], this->Offset[2]);
    const glm::dvec3 from = this->InPoints ? o : glm::dvec3(0.0);
    vtkNew<vtkPlaneSource> plate;
    plate->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    const glm::dvec3 corners[3] = { corner + from, first + from, second + from };
    plate->SetOrigin(corners[0].x, corners[0].y, corners[0].z);
    plate->SetPoint1(corners[1].x, corners[1].y, corners[1].z);
    plate->SetPoint2(corners[2].x, corners[2].y, corners[2].z);
    vtkActor* actor = this->Add(plate);
    const glm::dvec3 position = o - from;
    actor->SetPosition(position.x, position.y, position.z);
    return actor;
  }

  void AddGround(double half = 100.0)
  {
    this->AddPlate({ -half, -half, 0.0 }, { half, -half, 0.0 }, { -half, half, 0.0 });
  }

  vtkActor* AddBall(double x, double y, double z, double radius, int resolution = 200)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(x, y, z);
    ball->SetRadius(radius);
    ball->SetThetaResolution(resolution);
    ball->SetPhiResolution(resolution);
    return this->Add(ball);
  }
};

// The root mean square error of the layer on the ground, where the truth is known.
double GetError(Scene& scene, const std::function<double(double, double)>& truth,
  relievoTest::Way way = relievoTest::Way::Own, long long* count = nullptr)
{
  const relievoTest::Layers layers(
    scene.Renderer, { "ambient", "position", "geometric_normal" }, way);
  double sum = 0.0;
  long long pixels = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const glm::dvec3 place = layers.Vector("position", x, y) -
        glm::dvec3(scene.Offset[0], scene.Offset[1], scene.Offset[2]);
      const double expected = truth(place.x, place.y);
      if (std::abs(layers.Vector("geometric_normal", x, y).z) > 0.99 && std::abs(place.z) < 1e-3 &&
        std::isfinite(expected))
      {
        const double off = layers.Value("ambient", x, y) - expected;
        sum += off * off;
        ++pixels;
      }
    }
  }
  if (count)
  {
    *count = pixels;
  }
  RELIEVO_CHECK(pixels > 2000);
  return std::sqrt(sum / static_cast<double>(pixels));
}

// The layer's least and largest value where there is a surface.
void GetRange(const relievoTest::Layers& layers, double& least, double& most)
{
  least = 2.0;
  most = -1.0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (std::isfinite(layers.Value("depth", x, y)))
      {
        least = std::min(least, layers.Value("ambient", x, y));
        most = std::max(most, layers.Value("ambient", x, y));
      }
    }
  }
}

// Before an endless wall of the height 1 on level ground.
void AddWall(Scene& scene, double half = 100.0)
{
  scene.AddGround(half);
  scene.AddPlate({ 0.0, -half, 0.0 }, { 0.0, half, 0.0 }, { 0.0, -half, 1.0 });
}

double GetBehindWall(double x, double)
{
  const double k = 1.0 / x;
  return x > 0.01 ? 1.0 - 0.5 * (1.0 - 1.0 / std::sqrt(1.0 + k * k)) : std::nan("");
}

void TestClosedForms()
{
  Scene wall;
  AddWall(wall);
  wall.Look(3.0, 0.0, 2.5, 1.0);
  for (const relievoTest::Way way : relievoTest::BothWays)
  {
    RELIEVO_CHECK_AT_MOST(GetError(wall, GetBehindWall, way), Bound, "rms before a wall");
  }
  wall.Stage->SetWeightingToUniform();
  RELIEVO_CHECK_AT_MOST(GetError(wall,
                          [](double x, double) {
                            return x > 0.01 ? 1.0 - std::atan(1.0 / x) / vtkMath::Pi()
                                            : std::nan("");
                          }),
    Bound, "rms before a wall, by solid angles");
  wall.Stage->SetWeightingToCosine();
  wall.Renderer->GetActiveCamera()->ParallelProjectionOn();
  wall.Renderer->GetActiveCamera()->SetParallelScale(1.5);
  wall.Renderer->ResetCameraClippingRange();
  RELIEVO_CHECK_AT_MOST(GetError(wall, GetBehindWall), Bound, "rms in parallel projection");

  // Within the radius, a high wall covers a segment of the sky's disc.
  Scene high;
  high.AddGround();
  high.AddPlate({ 0.0, -100.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 0.0, -100.0, 50.0 });
  high.Look(3.0, 0.0, 2.5, 1.0);
  high.Stage->SetRadius(1.5);
  RELIEVO_CHECK_AT_MOST(GetError(high,
                          [](double x, double) {
                            const double c = std::min(x / 1.5, 1.0);
                            return x > 0.01
                              ? 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / vtkMath::Pi()
                              : std::nan("");
                          }),
    Bound, "rms within a radius");

  // Form factors from a small plane to a ball, and to a disk that faces it (Howell's catalogue).
  Scene ball;
  ball.AddGround();
  ball.AddBall(0.0, 0.0, 1.25, 1.0);
  ball.Look(5.0, 0.0, 2.0);
  const auto underBall = [](double x, double y) {
    return 1.0 - 1.25 / std::pow(x * x + y * y + 1.25 * 1.25, 1.5);
  };
  RELIEVO_CHECK_AT_MOST(GetError(ball, underBall), Bound, "rms under a ball");
  ball.Stage->SetSamples(256);
  RELIEVO_CHECK_AT_MOST(GetError(ball, underBall), Bound / 2.0, "rms under a ball, 256 rays");

  Scene disk;
  disk.AddGround();
  vtkNew<vtkDiskSource> source;
  source->SetInnerRadius(0.0);
  source->SetOuterRadius(1.0);
  source->SetCircumferentialResolution(400);
  vtkActor* plate = disk.Add(source);
  plate->SetPosition(0.0, 0.0, 0.7);
  disk.Look(4.0, 0.0, 0.9);
  RELIEVO_CHECK_AT_MOST(GetError(disk,
                          [](double x, double y) {
                            const double d = x * x + y * y;
                            const double s = d + 0.49 + 1.0;
                            return 1.0 - 0.5 * (1.0 - (s - 2.0) / std::sqrt(s * s - 4.0 * d));
                          }),
    Bound, "rms under a disk");
}

// The bunny on a ground, against Embree's rays at random.
void TestEmbree()
{
  vtkNew<vtkRelievoOFFReader> reader;
  const std::string file = relievoTest::DataFile("bunny.off");
  if (file.empty())
  {
    return;
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  Scene scene(32);
  scene.Add(reader);
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(bounds[0] - 1.0, bounds[2], bounds[4] - 1.0);
  ground->SetPoint1(bounds[1] + 1.0, bounds[2], bounds[4] - 1.0);
  ground->SetPoint2(bounds[0] - 1.0, bounds[2], bounds[5] + 1.0);
  scene.Add(ground);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.Renderer->ResetCamera(bounds);
  camera->Elevation(25.0);
  camera->Azimuth(20.0);
  camera->Zoom(1.3);
  scene.Renderer->ResetCameraClippingRange();

  const relievoTest::Layers layers(
    scene.Renderer, { "ambient", "depth", "position", "geometric_normal" });
  relievoTest::EmbreeScene truth;
  RELIEVO_CHECK(truth.AddActors(scene.Renderer) == 2);
  const double eye[3] = { camera->GetPosition()[0], camera->GetPosition()[1],
    camera->GetPosition()[2] };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr int strata = 32;
  double sum = 0.0;
  int pixels = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (!std::isfinite(layers.Value("depth", x, y)))
      {
        continue;
      }
      const glm::dvec3 place = layers.Vector("position", x, y);
      glm::dvec3 up = glm::normalize(layers.Vector("geometric_normal", x, y));
      up = glm::dot(up, glm::dvec3(eye[0], eye[1], eye[2]) - place) < 0.0 ? -up : up;
      const double start = 1e-5 * truth.Size();
      int open = 0;
      for (int i = 0; i < strata * strata; ++i)
      {
        // Even on a sphere about the tip of the normal: by the cosine about it.
        const double z = 2.0 * (i % strata + share(random)) / strata - 1.0;
        const double angle = 2.0 * vtkMath::Pi() * (i / strata + share(random)) / strata;
        const double r = std::sqrt(1.0 - z * z);
        const glm::dvec3 ray =
          glm::normalize(up + glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
        open += truth.Cast({ place + start * up, ray }, 0.0, 1e30).Hit ? 0 : 1;
      }
      const double off = layers.Value("ambient", x, y) - open / double(strata * strata);
      sum += off * off;
      ++pixels;
    }
  }
  RELIEVO_CHECK(pixels > 400);
  RELIEVO_CHECK_AT_MOST(std::sqrt(sum / pixels), Bound, "rms of the bunny, to Embree");
}

// All of the sky or nothing of it: no surface hides it from itself, and no gap lets it in.
void TestAllOrNothing()
{
  double least = 0.0;
  double most = 0.0;
  for (const double offset : { 0.0, 1e6 })
  {
    // A convex body seen from near, facets and grazing places included.
    Scene ball;
    ball.Offset[0] = offset;
    ball.Offset[1] = -offset;
    ball.AddBall(0.0, 0.0, 0.0, 1.0, 24);
    ball.Look(1.3, 0.9, 0.8);
    GetRange(relievoTest::Layers(ball.Renderer, { "ambient", "depth" }), least, most);
    RELIEVO_CHECK_NEAR(least, 1.0, 0.0, "the sky seen from a ball");
    ball.Window->SetMultiSamples(4);
    GetRange(relievoTest::Layers(ball.Renderer, { "ambient", "depth" }), least, most);
    RELIEVO_CHECK_NEAR(least, 1.0, 0.0, "the sky seen from a ball, with multisampling");
    ball.Window->SetMultiSamples(0);

    Scene far;
    far.Offset[0] = offset;
    far.Offset[1] = -offset;
    AddWall(far);
    far.Look(3.0, 0.0, 2.5, 1.0);
    RELIEVO_CHECK_AT_MOST(GetError(far, GetBehindWall), Bound,
      "rms before a wall, " + std::to_string(offset) + " from the origin");
  }
  const double places[3][4] = { { 5e5, 5.3e6, 200.0, 300.0 }, { 1e6, 0.0, 0.0, 100.0 },
    { 1e5, 0.0, 0.0, 20.0 } };
  for (const auto& place : places)
  {
    Scene survey;
    survey.InPoints = true;
    std::copy_n(place, 3, survey.Offset);
    AddWall(survey, place[3]);
    survey.Look(3.0, 0.0, 2.5, 1.0);
    RELIEVO_CHECK_AT_MOST(GetError(survey, GetBehindWall), Bound,
      "rms before a wall with points at " + std::to_string(place[0]));
  }
  {
    Scene formats;
    formats.AddBall(0.0, 0.0, 0.0, 1.0, 24);
    formats.Look(1.3, 0.9, 0.8);
    for (int format = vtkRelievoLayersStage::DEPTH_32F;
         format <= vtkRelievoLayersStage::DEPTH_REVERSED_32F; ++format)
    {
      GetRange(relievoTest::Layers(formats.Renderer, { "ambient", "depth" }, relievoTest::Way::Own,
                 [format](vtkRelievoLayersStage* layers) { layers->SetDepthFormat(format); }),
        least, most);
      RELIEVO_CHECK_NEAR(least, 1.0, 0.0, "from a ball, depth format " + std::to_string(format));
    }
  }
  // Within a closed box, the camera too.
  Scene box;
  vtkNew<vtkCubeSource> cube;
  box.Add(cube);
  box.Look(0.3, 0.2, 0.1, -0.5, -0.4, -0.4);
  GetRange(relievoTest::Layers(box.Renderer, { "ambient", "depth" }), least, most);
  RELIEVO_CHECK_NEAR(most, 0.0, 0.0, "the sky seen within a box");
  box.Stage->SetRadius(2.0);
  GetRange(relievoTest::Layers(box.Renderer, { "ambient", "depth" }), least, most);
  RELIEVO_CHECK_NEAR(most, 0.0, 0.0, "within a box and a radius that is larger");
  box.Stage->SetRadius(1e-6);
  GetRange(relievoTest::Layers(box.Renderer, { "ambient", "depth" }), least, most);
  RELIEVO_CHECK_AT_MOST(1.0 - least, 0.5, "hidden within a box and a radius of next to nothing");
  RELIEVO_CHECK_NEAR(most, 1.0, 0.0, "most, within a radius of next to nothing");

  // Nothing at all.
  Scene empty;
  const relievoTest::Layers layers(empty.Renderer, { "ambient", "depth" });
  RELIEVO_CHECK_NEAR(layers.Value("ambient", 5, 7), 1.0, 0.0, "background");
}

void TestWhatHides()
{
  const auto underBall = [](double x, double y) {
    return 1.0 - 1.25 / std::pow(x * x + y * y + 1.25 * 1.25, 1.5);
  };
  const auto open = [](double, double) { return 1.0; };
  // A glyph, and one far outside the view.
  Scene glyphs;
  glyphs.AddGround();
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.5);
  ball->SetThetaResolution(100);
  ball->SetPhiResolution(100);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 1.25);
  points->InsertNextPoint(90.0, 90.0, 1.25);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(ball->GetOutputPort());
  mapper->SetScaleFactor(2.0);
  vtkActor* actor = glyphs.Add(mapper);
  glyphs.Look(5.0, 0.0, 2.0);
  RELIEVO_CHECK_AT_MOST(GetError(glyphs, underBall), Bound, "rms under a glyph");
  glyphs.Renderer->RemoveActor(actor);
  RELIEVO_CHECK_NEAR(GetError(glyphs, open), 0.0, 0.0, "without it");

  // Translucent, invisible, behind the eye.
  Scene scene;
  scene.AddGround();
  actor = scene.AddBall(0.0, 0.0, 1.25, 1.0);
  scene.Look(5.0, 0.0, 2.0);
  actor->GetProperty()->SetOpacity(0.5);
  RELIEVO_CHECK_NEAR(GetError(scene, open), 0.0, 0.0, "under a translucent ball");
  actor->GetProperty()->SetOpacity(1.0);
  actor->VisibilityOff();
  RELIEVO_CHECK_NEAR(GetError(scene, open), 0.0, 0.0, "under an invisible ball");
  actor->VisibilityOn();
  scene.Look(0.0, 0.0, 0.2, 1.0, 0.0, 0.0); // below the ball, which is not in view
  scene.Stage->SetSamples(128);
  RELIEVO_CHECK_AT_MOST(GetError(scene, underBall), Bound, "rms under a ball above the eye");
  actor->GetProperty()->SetRepresentationToWireframe();
  RELIEVO_CHECK_NEAR(GetError(scene, open), 0.0, 0.0, "under a wireframe");
  RELIEVO_CHECK(
    scene.Stage->GetReason().find("1 prop that rays cannot intersect") != std::string::npos);
}

// Equal to the last byte. Props without support by rays occlude nothing, which is reported once.
void TestTooManyTriangles()
{
  const vtkIdType most = vtkRelievoMeshTexels::GetMostTriangles();
  vtkRelievoMeshTexels::SetMostTriangles(1);
  Scene scene;
  scene.AddGround();
  scene.AddBall(0.0, 0.0, 1.25, 1.0, 24);
  scene.Look(5.0, 0.0, 2.0);
  {
    const relievoTest::ExpectMessage said(
      " triangles hides no sky: ray tracing takes at most 1 per mesh. Split the mesh.");
    double least = 0.0;
    double greatest = 0.0;
    GetRange(relievoTest::Layers(scene.Renderer, { "ambient", "depth" }), least, greatest);
    scene.Window->Render();
    RELIEVO_CHECK(said.Count() == 1);
    RELIEVO_CHECK_NEAR(least, 1.0, 0.0, "the sky seen under a ball that rays cannot follow");
  }
  vtkRelievoMeshTexels::SetMostTriangles(most);
}

bool Same(vtkImageData* a, vtkImageData* b)
{
  return relievoTest::SamePicture(a, b, "pictures");
}

void TestPicture()
{
  Scene scene(96);
  relievoTest::GLCheck gl(scene.Window);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkCubeSource> cube;
  vtkActor* box = scene.Add(cube);
  box->GetProperty()->LightingOff();
  scene.Look(0.3, 0.2, 0.1, -0.5, -0.4, -0.4);
  vtkNew<vtkTextActor> text;
  text->SetInput("TEXT");
  text->SetPosition(30.0, 40.0);
  text->GetTextProperty()->SetColor(1.0, 1.0, 1.0);
  text->GetTextProperty()->SetFontSize(24);
  scene.Renderer->AddViewProp(text);
  const auto plain = relievoTest::Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->EnabledOn();
  // All of the box is black, and the text is as it was.
  const auto dark = relievoTest::Picture(scene.Window);
  const auto* bytes = static_cast<unsigned char*>(dark->GetScalarPointer());
  int black = 0;
  int white = 0;
  for (vtkIdType i = 0; i < dark->GetNumberOfPoints(); ++i)
  {
    black += bytes[3 * i] == 0 ? 1 : 0;
    white += bytes[3 * i] == 255 ? 1 : 0;
  }
  RELIEVO_CHECK(black > 96 * 96 * 8 / 10);
  RELIEVO_CHECK(white > 50);
  RELIEVO_CHECK(scene.Frame->GetSamplesLeft() == 0);
  // Half of the light, linear: 188 of 255 as sRGB.
  scene.Stage->SetStrength(0.5);
  const auto half = relievoTest::Picture(scene.Window);
  RELIEVO_CHECK_NEAR(
    static_cast<unsigned char*>(half->GetScalarPointer())[0], 188.0, 1.0, "half of white");
  // Whatever was drawn before.
  scene.Stage->SetRadius(0.3);
  const auto near = relievoTest::Picture(scene.Window);
  scene.Look(0.1, 0.2, 0.3);
  scene.Stage->SetSamples(7);
  relievoTest::Picture(scene.Window);
  scene.Stage->SetSamples(64);
  scene.Look(0.3, 0.2, 0.1, -0.5, -0.4, -0.4);
  RELIEVO_CHECK(Same(near, relievoTest::Picture(scene.Window)));
  // Successive frames give the picture of a frame that waits.
  scene.Frame->WaitForSamplesOff();
  scene.Stage->SetStrength(0.25);
  scene.Stage->SetStrength(0.5);
  int frames = 1;
  vtkSmartPointer<vtkImageData> last = relievoTest::Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetSamplesLeft() == 3);
  while (scene.Frame->GetSamplesLeft() > 0 && frames < 20)
  {
    last = relievoTest::Picture(scene.Window);
    ++frames;
  }
  RELIEVO_CHECK(frames == 4);
  RELIEVO_CHECK(Same(near, last));
  // Half of a window equals a separate window, except rays that rounded normals send past an edge.
  vtkNew<vtkRenderer> other;
  scene.Window->SetSize(192, 96);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Window->AddRenderer(other);
  scene.Frame->WaitForSamplesOn();
  const auto both = relievoTest::Picture(scene.Window);
  double largest = 0.0;
  double sum = 0.0;
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 96; ++x)
    {
      const auto* a = static_cast<unsigned char*>(both->GetScalarPointer(96 + x, y, 0));
      const auto* b = static_cast<unsigned char*>(near->GetScalarPointer(x, y, 0));
      largest = std::max(largest, std::abs(double(a[0]) - b[0]));
      sum += std::abs(double(a[0]) - b[0]);
    }
  }
  RELIEVO_CHECK_AT_MOST(largest, 8.0, "levels that a viewport is off at most");
  RELIEVO_CHECK_AT_MOST(sum / (96 * 96), 0.2, "levels that a viewport is off in the mean");
  scene.Window->RemoveRenderer(other);
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  scene.Window->SetSize(96, 96);
  // When off, the stage leaves no trace.
  scene.Stage->EnabledOff();
  RELIEVO_CHECK(Same(plain, relievoTest::Picture(scene.Window)));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "off");
  scene.Stage->EnabledOn();
  scene.Stage->SetStrength(0.0);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Stage->GetReason() == "the strength is 0");
  gl.Poll("end of the test");
}

double ToLinear(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

double GetShown(vtkImageData* picture, int x, int y)
{
  return static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0))[1] / 255.0;
}

// Below a ball the light of other lights is darkened by the closed form of the visible sky. A sun
// that shines under it is not.
void TestLights()
{
  enum Kind
  {
    Plain, // another light that casts no shadow
    Fill,
    Ambient, // VTK's ambient term
    Pbr,
    Deferred // whose lights cannot be told apart
  };
  constexpr double direct = 0.35;
  constexpr double other = 0.4;
  for (const Kind kind : { Plain, Fill, Ambient, Pbr, Deferred })
  {
    Scene scene;
    scene.Renderer->AutomaticLightCreationOff();
    vtkActor* ground = scene.AddPlate({ -9.0, -9.0, 0.0 }, { 9.0, -9.0, 0.0 }, { -9.0, 9.0, 0.0 });
    scene.AddBall(0.0, 0.0, 1.25, 1.0);
    scene.Look(5.0, 0.0, 2.0);
    const auto addLight = [&](const glm::dvec3& from, double intensity, bool fills) {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPosition(from.x, from.y, from.z);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      light->SetIntensity(intensity);
      if (fills)
      {
        vtkRelievoFillLight::Make(light);
      }
      scene.Renderer->AddLight(light);
      return light;
    };
    auto* shadows = vtkRelievoShadowStage::SafeDownCast(scene.Frame->GetStage("shadows"));
    shadows->EnabledOn();
    shadows->SetMapSize(1024);
    std::vector<vtkSmartPointer<vtkLight>> others;
    vtkSmartPointer<vtkLight> sun = addLight({ 0.0, 2.0, 1.0 }, std::sqrt(5.0) * direct, false);
    if (kind == Fill)
    {
      for (const glm::dvec3& from : { glm::dvec3(1.0, 1.0, 1.0), glm::dvec3(1.0, -1.0, -1.0),
             glm::dvec3(-1.0, 1.0, -1.0), glm::dvec3(-1.0, -1.0, 1.0) })
      {
        others.push_back(addLight(from, other, true));
      }
    }
    else if (kind != Ambient)
    {
      others.push_back(addLight({ 0.0, 0.0, 1.0 }, other, false));
    }
    for (vtkLight* light : others)
    {
      shadows->SetLightCasts(light, false);
    }
    if (kind == Ambient)
    {
      ground->GetProperty()->SetAmbient(other);
    }
    if (kind == Pbr)
    {
      ground->GetProperty()->SetInterpolationToPBR();
      ground->GetProperty()->SetRoughness(1.0);
    }
    scene.Frame->GetStage("deferred")->SetEnabled(kind == Deferred);

    // The pictures of all lights and of the sun, without occlusion.
    scene.Stage->EnabledOff();
    auto* fill = scene.Frame->GetStage("fill");
    fill->SetParameter("occlusion", "0");
    const auto all = relievoTest::Picture(scene.Window);
    for (vtkLight* light : others)
    {
      light->SwitchOff();
    }
    ground->GetProperty()->SetAmbient(0.0);
    const auto alone = relievoTest::Picture(scene.Window);
    for (vtkLight* light : others)
    {
      light->SwitchOn();
    }
    ground->GetProperty()->SetAmbient(kind == Ambient ? other : 0.0);
    fill->SetParameter("occlusion", "1"); // rays take its place
    scene.Stage->EnabledOn();
    const relievoTest::Layers layers(scene.Renderer, { "position", "geometric_normal" });
    const auto picture = relievoTest::Picture(scene.Window);
    double sum = 0.0;
    double lost = 0.0; // if all light were darkened
    int pixels = 0;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const glm::dvec3 place = layers.Vector("position", x, y);
        const double away = std::hypot(place.x, place.y);
        if (std::abs(layers.Vector("geometric_normal", x, y).z) > 0.99 &&
          std::abs(place.z) < 1e-3 && away < 8.0)
        {
          const double share = 1.0 - 1.25 / std::pow(away * away + 1.25 * 1.25, 1.5);
          const double whole = ToLinear(GetShown(all, x, y));
          const double spared = kind == Deferred ? 0.0 : ToLinear(GetShown(alone, x, y));
          const double found = ToLinear(GetShown(picture, x, y));
          sum += std::pow(found - spared - share * (whole - spared), 2.0);
          lost += std::pow(found - share * whole, 2.0);
          ++pixels;
        }
      }
    }
    RELIEVO_CHECK(pixels > 2000);
    const std::string name = "kind of light " + std::to_string(kind);
    RELIEVO_CHECK_AT_MOST(std::sqrt(sum / pixels), 0.008, "rms of the picture, " + name);
    RELIEVO_CHECK(kind == Deferred || std::sqrt(lost / pixels) > (kind == Pbr ? 0.007 : 0.015));
    if (kind == Plain || kind == Fill)
    {
      // In the sun, where the ball is far.
      RELIEVO_CHECK_NEAR(GetShown(all, layers.Width / 2, 2), direct + other, 0.01, name);
      RELIEVO_CHECK_NEAR(GetShown(alone, layers.Width / 2, 2), direct, 0.01, name);
    }
  }
}
}

RELIEVO_TEST_CASE(testAmbientStage)
{
  relievoTest::Session session;
  TestClosedForms();
  TestEmbree();
  TestAllOrNothing();
  TestWhatHides();
  TestTooManyTriangles();
  TestPicture();
  TestLights();
  return session.Result();
}
}
