// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Mapped normals against those of an analytic height field: formats, frames, mirrored and seam
// texels, shading, and the unchanged parts of the picture and the other layers.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoMaterial.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>

namespace testMaterialNormals
{
namespace
{
using namespace relievoTest;

constexpr int Size = 256;
constexpr double Slope = 0.04; // heights in tiles: up to 45 degrees or so

glm::dvec3 NormalOf(const glm::dvec2& uv)
{
  return glm::normalize(glm::dvec3(-Slope * SlopeOf(Waves, uv), 1.));
}

// The field's normals at texel centres, as floats or integers.
template <typename Array>
vtkSmartPointer<vtkImageData> FormattedNormals(double scale, double offset)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Size, Size, 1);
  vtkNew<Array> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(static_cast<vtkIdType>(Size) * Size);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const glm::dvec3 n = NormalOf(glm::dvec2(i % Size + 0.5, i / Size + 0.5) / double(Size));
    for (int c = 0; c < 3; ++c)
    {
      const double value = (n[c] * 0.5 + 0.5) * scale;
      values->SetComponent(i, c, scale > 1. ? std::floor(value + 0.5) : n[c] + offset);
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

std::vector<unsigned char> Picture(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

// Straight above the plane, one texel to the pixel.
void LookDown(relievoTest::Stage& stage)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0., 0., 4.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.);
  camera->SetClippingRange(1., 9.);
}

double AngleOf(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180. / 3.14159265358979;
}

// Mean angle to `truth` of the texture coordinates that `place` gives a point of the plane.
template <typename Truth>
double MeanError(vtkRenderer* renderer, Truth truth, double* worst = nullptr)
{
  Layers layers(renderer, { "depth", "normal", "position" });
  double sum = 0.;
  int count = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (std::isfinite(layers.Value("depth", x, y)))
      {
        const glm::dvec3 seen = layers.Vector("normal", x, y);
        const double angle = AngleOf(truth(layers.Vector("position", x, y)), seen);
        sum += angle;
        ++count;
        if (worst)
        {
          *worst = std::max(*worst, angle);
        }
      }
    }
  }
  return count > 1000 ? sum / count : NAN;
}

glm::dvec3 TruthOnPlane(const glm::dvec3& place)
{
  return NormalOf((glm::dvec2(place) + 1.) / 2.);
}

struct Scene
{
  relievoTest::Stage Stage{ Size, Size };
  vtkSmartPointer<vtkPolyData> Mesh = ReliefPlane(8);
  vtkSmartPointer<vtkActor> Actor = AddActor(this->Stage.Renderer, this->Mesh);
  vtkNew<vtkRelievoMaterial> Material;
  GLCheck Watch{ this->Stage.Window };

  Scene()
  {
    LookDown(this->Stage);
    this->Material->SetNormalMap(FormattedNormals<vtkFloatArray>(1., 0.));
    this->Material->Attach(this->Actor);
  }
  ~Scene() { this->Material->Detach(this->Actor); }
};

void TestFormats()
{
  Scene scene;
  vtkRenderer* renderer = scene.Stage.Renderer;
  double worst = 0.;
  RELIEVO_CHECK_AT_MOST(MeanError(renderer, TruthOnPlane, &worst), 0.02, "float: mean, degrees");
  RELIEVO_CHECK_AT_MOST(worst, 0.3, "float: worst, degrees");
  scene.Material->SetNormalMap(FormattedNormals<vtkUnsignedCharArray>(255., 0.));
  RELIEVO_CHECK_AT_MOST(MeanError(renderer, TruthOnPlane), 0.3, "8-bit: mean, degrees");
  scene.Material->SetNormalMap(FormattedNormals<vtkUnsignedShortArray>(65535., 0.));
  RELIEVO_CHECK_AT_MOST(MeanError(renderer, TruthOnPlane), 0.02, "16-bit: mean, degrees");
  for (const auto interpolation : { VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR })
  {
    scene.Actor->GetProperty()->SetInterpolation(interpolation);
    RELIEVO_CHECK_AT_MOST(MeanError(renderer, TruthOnPlane), 0.02,
      "interpolation " + std::to_string(interpolation) + ": mean, degrees");
  }
  scene.Material->SetNormalStrength(0.);
  RELIEVO_CHECK_AT_MOST(
    MeanError(renderer, [](const glm::dvec3&) { return glm::dvec3(0., 0., 1.); }), 1e-3,
    "strength 0 is flat");
  scene.Material->SetNormalStrength(1.);
  scene.Material->FlipGreenOn();
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& place) {
                            const glm::dvec3 n = TruthOnPlane(place);
                            return glm::dvec3(n.x, -n.y, n.z);
                          }),
    0.02, "green flipped");
}

void SetTCoords(vtkPolyData* mesh, const std::function<glm::dvec2(const glm::dvec2&)>& place)
{
  vtkNew<vtkFloatArray> tcoords;
  tcoords->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    const glm::dvec2 uv = place(glm::dvec2(p[0], p[1]));
    tcoords->InsertNextTuple2(uv.x, uv.y);
  }
  mesh->GetPointData()->SetTCoords(tcoords);
}

void TestFrames()
{
  // Mirrored at x = 0: u runs to the right on the right half and to the left on the left half.
  Scene scene;
  vtkRenderer* renderer = scene.Stage.Renderer;
  SetTCoords(scene.Mesh,
    [](const glm::dvec2& p) { return glm::dvec2(std::abs(p.x) / 2., (p.y + 1.) / 2.); });
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            glm::dvec3 n = NormalOf({ std::abs(p.x) / 2., (p.y + 1.) / 2. });
                            n.x = p.x < 0. ? -n.x : n.x;
                            return n;
                          }),
    0.02, "mirrored halves");
  // Turned by 90 degrees, three tiles across, beginning within one.
  SetTCoords(scene.Mesh, [](const glm::dvec2& p) { return glm::dvec2(p.y, -p.x) / 2.; });
  scene.Material->SetTextureScale(3., 3.);
  scene.Material->SetTextureOffset(0.25, 0.125);
  scene.Stage.Renderer->GetActiveCamera()->SetParallelScale(0.3);
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            const glm::dvec3 n =
                              NormalOf(glm::dvec2(p.y, -p.x) * 1.5 + glm::dvec2(0.25, 0.125));
                            return glm::dvec3(-n.y, n.x, n.z);
                          }),
    0.1, "turned tiles, magnified");
  scene.Material->SetTextureScale(1., 1.);
  scene.Material->SetTextureOffset(0., 0.);
  scene.Stage.Renderer->GetActiveCamera()->SetParallelScale(1.);

  // The mesh's own tangents win: here at 45 degrees to u.
  SetTCoords(scene.Mesh, [](const glm::dvec2& p) { return (p + 1.) / 2.; });
  vtkNew<vtkFloatArray> tangents;
  tangents->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
  {
    tangents->InsertNextTuple3(std::sqrt(0.5), std::sqrt(0.5), 0.);
  }
  scene.Mesh->GetPointData()->SetTangents(tangents);
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            const glm::dvec3 n = TruthOnPlane(p);
                            return glm::dvec3(
                              std::sqrt(0.5) * (n.x - n.y), std::sqrt(0.5) * (n.x + n.y), n.z);
                          }),
    0.02, "the mesh's tangents");
  scene.Mesh->GetPointData()->SetTangents(nullptr);

  // A mirroring and a scaling actor, and the plane seen from behind.
  scene.Actor->SetScale(-1., 1., 1.);
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            const glm::dvec3 n = TruthOnPlane({ -p.x, p.y, 0. });
                            return glm::dvec3(-n.x, n.y, n.z);
                          }),
    0.02, "mirrored by the actor");
  scene.Actor->SetScale(0.5, 1., 3.);
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            return TruthOnPlane({ 2. * p.x, p.y, 0. });
                          }),
    0.3, "scaled unevenly, two texels to the pixel");
  scene.Actor->SetScale(1., 1., 1.);
  renderer->GetActiveCamera()->SetPosition(0., 0., -4.);
  RELIEVO_CHECK_AT_MOST(MeanError(renderer,
                          [](const glm::dvec3& p) {
                            const glm::dvec3 n = TruthOnPlane(p);
                            return glm::dvec3(n.x, n.y, -n.z);
                          }),
    0.02, "seen from behind");
}

void TestKeeps()
{
  Scene scene;
  vtkRenderer* renderer = scene.Stage.Renderer;
  scene.Material->Detach(scene.Actor);
  const Layers before(renderer, { "geometric_normal", "depth", "cell" });
  const auto picture = Picture(scene.Stage.Window);
  scene.Material->Attach(scene.Actor);
  const Layers with(renderer, { "geometric_normal", "depth", "cell" });
  double off = 0.;
  for (int y = 0; y < with.Height; ++y)
  {
    for (int x = 0; x < with.Width; ++x)
    {
      off = std::max({ off,
        AngleOf(before.Vector("geometric_normal", x, y), with.Vector("geometric_normal", x, y)),
        std::abs(before.Value("depth", x, y) - with.Value("depth", x, y)),
        std::abs(before.Value("cell", x, y) - with.Value("cell", x, y)) });
    }
  }
  RELIEVO_CHECK_AT_MOST(off, 1e-4, "the mesh's own normal, depth and cells stay");
  RELIEVO_CHECK_THAT(Picture(scene.Stage.Window) != picture, "the material is seen");
  RELIEVO_CHECK_THAT(scene.Material->GetBytesHeld() > 0, "bytes are held");
  scene.Material->EnabledOff();
  RELIEVO_CHECK_THAT(Picture(scene.Stage.Window) == picture, "disabled: the picture bit for bit");
  scene.Material->EnabledOn();
  scene.Material->Detach(scene.Actor);
  RELIEVO_CHECK(vtkRelievoMaterial::Get(scene.Actor) == nullptr);
  RELIEVO_CHECK_THAT(Picture(scene.Stage.Window) == picture, "detached: the picture bit for bit");
  scene.Material->Attach(scene.Actor);
  vtkNew<vtkRelievoMaterial> other;
  other->Attach(scene.Actor);
  RELIEVO_CHECK(vtkRelievoMaterial::Get(scene.Actor) == other);
  RELIEVO_CHECK_THAT(
    Picture(scene.Stage.Window) == picture, "a material without maps changes nothing");
  other->Detach(scene.Actor);
}
}

RELIEVO_TEST_CASE(testMaterialNormals)
{
  relievoTest::Session session;
  TestFormats();
  TestFrames();
  TestKeeps();
  return session.Result();
}
}
