// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers of the real meshes against Embree: perspective and parallel, far / near from 10 to
// 1e7, near the origin and far from it, any window shape.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "LayerErrors.h"
#include "Scenes.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cmath>
#include <iostream>

namespace testLayersOfMeshes
{
namespace
{
using relievoTest::LayerErrors;

struct Case
{
  const char* Name;
  int Width;
  int Height;
  double Near;
  double Far;
  double ParallelScale; // 0: perspective
  double Offset[3];     // of the whole scene
};

const Case Cases[] = {
  { "reference", 600, 600, 2., 14., 0., { 0., 0., 0. } },
  { "wide window, far / near 1e3", 800, 450, 0.1, 100., 0., { 0., 0., 0. } },
  { "tall window, far / near 1e5", 300, 700, 0.01, 1000., 0., { 0., 0., 0. } },
  { "far / near 1e7", 600, 600, 0.001, 10000., 0., { 0., 0., 0. } },
  { "parallel", 600, 450, 2., 14., 1.6, { 0., 0., 0. } },
  { "at (5e5, 5e6, 0)", 600, 450, 2., 14., 0., { 5e5, 5e6, 0. } },
  { "parallel at (5e5, 5e6, 0)", 600, 450, 2., 14., 1.6, { 5e5, 5e6, 0. } },
};

void Move(const relievoTest::ReferenceScene& scene, const Case& c)
{
  for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
  {
    actor->SetPosition(c.Offset[0], c.Offset[1], c.Offset[2]);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(2.5 + c.Offset[0], 3. + c.Offset[1], 6. + c.Offset[2]);
  camera->SetFocalPoint(c.Offset[0], 0.5 + c.Offset[1], c.Offset[2]);
  camera->SetParallelProjection(c.ParallelScale > 0.);
  camera->SetParallelScale(c.ParallelScale > 0. ? c.ParallelScale : 1.);
  camera->SetClippingRange(c.Near, c.Far);
}

void Judge(const std::string& what, const LayerErrors& e)
{
  std::cout << what << ": " << e.ToString() << "\n";
  RELIEVO_CHECK_THAT(e.Compared > 10000, what + ": the scene is not in the picture");
  RELIEVO_CHECK_AT_MOST(e.Coverage, 0.001, what + ": share of pixels with other coverage");
  RELIEVO_CHECK_AT_MOST(e.DepthMax, 1e-6, what + ": relative error of the depth");
  RELIEVO_CHECK_AT_MOST(e.RangeMax, 1e-6, what + ": relative error of the range");
  RELIEVO_CHECK_AT_MOST(e.FaceNormalMax, 0.1, what + ": angle of the geometric normal");
  RELIEVO_CHECK_AT_MOST(e.NormalMax, 0.1, what + ": angle of the normal, flat shading");
  RELIEVO_CHECK_AT_MOST(e.PositionMax, 0.01, what + ": position, in pixels");
  RELIEVO_CHECK_AT_MOST(e.WrongActors, 0, what + ": pixels with the wrong actor");
  RELIEVO_CHECK_AT_MOST(e.WrongCells, 0, what + ": pixels with the wrong cell");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersOfMeshes)
{
  relievoTest::Session session;
  for (const std::string& mesh : relievoTest::ReferenceMeshes())
  {
    const auto scene = relievoTest::MakeReferenceScene(mesh);
    if (!scene.IsValid())
    {
      continue;
    }
    auto window = relievoTest::MakeWindow(600, 600, scene.Renderer);
    relievoTest::GLCheck gl(window);
    for (const Case& c : Cases)
    {
      window->SetSize(c.Width, c.Height);
      Move(scene, c);
      relievoTest::EmbreeScene truth;
      truth.AddActors(scene.Renderer);
      const auto layers = relievoTest::CaptureLayers(scene.Renderer,
        { "depth", "range", "normal", "geometric_normal", "position", "actor", "cell" });
      Judge(mesh + ", " + c.Name, relievoTest::CompareLayers(layers, truth, scene.Renderer));
    }
    gl.Poll(mesh);
  }
  return session.Result();
}
}
