// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reflections if the eye is not at the camera: in stereo and in sheared views.
#include "Check.h"
#include "MirrorScene.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <string>

namespace testMaterialEyes
{
namespace
{
using namespace relievoTest;

// The greatest difference from the truth, in 255ths, for a view whose rays only the camera's
// matrices know; else MirrorScene::Worst gives it.
double WorstThrough(vtkRenderer* renderer, const Light& truth)
{
  const Photo photo(renderer->GetRenderWindow());
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> toWorld;
  // Not the composite matrix: it ignores stereo.
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.),
    camera->GetModelViewTransformMatrix(), toWorld);
  toWorld->Invert();
  double worst = 0.;
  for (int y = 0; y < photo.Height; ++y)
  {
    for (int x = 0; x < photo.Width; ++x)
    {
      double ends[2][4];
      for (int end = 0; end < 2; ++end)
      {
        const double place[4] = { 2. * (x + 0.5) / photo.Width - 1.,
          2. * (y + 0.5) / photo.Height - 1., end - 0.5, 1. };
        toWorld->MultiplyPoint(place, ends[end]);
      }
      const auto at = [&ends](int end) {
        return glm::dvec3(ends[end][0], ends[end][1], ends[end][2]) / ends[end][3];
      };
      const glm::dvec3 off = glm::abs(truth(glm::normalize(at(1) - at(0))) - photo.At(x, y));
      worst = std::max({ worst, off.x, off.y, off.z });
    }
  }
  return 255. * worst;
}

// Each eye of a stereo picture, and sheared views, mirror along their own rays.
void TestEyes()
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.1, 1.));
  const Light truth = [&normal](const glm::dvec3& d) { return Smooth(glm::reflect(d, normal)); };
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    MirrorScene scene(Smooth, Cube, 256, Wall(normal));
    scene.LookAt({ 0.3, -0.2, 1. }, 40.);
    scene.Renderer->GetActiveCamera()->SetEyeAngle(20.);
    scene.Renderer->GetRenderWindow()->StereoRenderOn();
    scene.Renderer->GetRenderWindow()->SetStereoType(type);
    RELIEVO_CHECK_AT_MOST(
      WorstThrough(scene.Renderer, truth), 1., "stereo " + std::to_string(type) + ", 255ths");
  }
  for (const bool parallel : { false, true })
  {
    MirrorScene scene(Smooth, Cube, 256, Wall(normal));
    scene.LookAt({ 0.3, -0.2, 1. }, 40.);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetViewShear(0.3, -0.2, 1.);
    RELIEVO_CHECK_AT_MOST(WorstThrough(scene.Renderer, truth), 1.,
      parallel ? "parallel and sheared, 255ths" : "sheared, 255ths");
  }
}
}

RELIEVO_TEST_CASE(testMaterialEyes)
{
  relievoTest::Session session;
  TestEyes();
  return session.Result();
}
}
