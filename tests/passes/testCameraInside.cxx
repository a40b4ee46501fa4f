// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A camera inside bodies of blocks, caves and cubes, in their air, in their rock, and with walls
// that the near plane cuts: walls are drawn, depth, normals and shadows are those of rays.
#include "BlockScenes.h"
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "LayerErrors.h"
#include "Props.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "Solids.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoCaves.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoSmoothBlocks.h>
#include <vtkRelievoVoxelCubes.h>
#include <vtkRelievoVoxelCubesActor.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testCameraInside
{
namespace
{
using relievoTest::EmbreeScene;
using relievoTest::ShadowStage;

struct Eye
{
  glm::dvec3 Place;
  glm::dvec3 Focus;
  double Near;
  double Far;
};

void Look(ShadowStage& stage, const Eye& eye)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(eye.Place.x, eye.Place.y, eye.Place.z);
  camera->SetFocalPoint(eye.Focus.x, eye.Focus.y, eye.Focus.z);
  camera->SetViewUp(0., 0., 1.);
  camera->SetViewAngle(75.);
  camera->SetClippingRange(eye.Near, eye.Far);
  stage.Renderer->SetBackground(1., 0., 1.);
}

// Limits: share of pixels, shown or not against the truth; relative error of depth and range; share
// of pixels facing the light with another verdict by exact shadows and by maps.
struct Limits
{
  double Coverage = 0.;
  double Depth = 1e-6;
  double Exact = 2e-5;
  double Map = 5e-3;
};

void Check(ShadowStage& stage, const EmbreeScene& truth, const std::string& what,
  const Limits& limits = Limits())
{
  const relievoTest::GLCheck gl(stage.Window);
  const auto layers = relievoTest::CaptureLayers(
    stage.Renderer, { "depth", "range", "geometric_normal", "position" });
  const auto errors = relievoTest::CompareLayers(layers, truth, stage.Renderer);
  std::cout << what << ": " << errors.ToString() << "\n";
  const relievoTest::TruthImage view = truth.Trace(relievoTest::View(stage.Renderer));
  const auto pixels = static_cast<double>(view.Pixels.size());
  RELIEVO_CHECK_THAT(static_cast<double>(view.NumberOfHits()) > 0.75 * pixels &&
      static_cast<double>(view.NumberOfInner()) > 0.2 * pixels,
    what + ": few walls");
  RELIEVO_CHECK_AT_MOST(errors.Coverage, limits.Coverage, what + ": pixels shown, or not");
  RELIEVO_CHECK_AT_MOST(errors.DepthP99, 2e-6, what + ": relative error of the depth, p99");
  RELIEVO_CHECK_AT_MOST(errors.DepthMax, limits.Depth, what + ": relative error of the depth");
  RELIEVO_CHECK_AT_MOST(errors.RangeMax, limits.Depth, what + ": relative error of the range");
  RELIEVO_CHECK_AT_MOST(errors.FaceNormalMax, 0.5, what + ": degrees of the normal");
  RELIEVO_CHECK_AT_MOST(errors.PositionMax, 0.05, what + ": pixels of the position");
  // A pixel whose centre is on an edge may show the triangle beside, which may face away.
  auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  const auto shadow = relievoTest::WithoutEdges(relievoTest::TraceShadow(truth, view, light), view);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  for (const bool exact : { true, false })
  {
    shadows->SetMethod(
      exact ? vtkRelievoShadowStage::METHOD_EXACT : vtkRelievoShadowStage::METHOD_MAP);
    const auto image = relievoTest::CaptureShadow(stage, 0);
    const auto verdicts = relievoTest::CompareShadow(shadow,
      vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0));
    const std::string which = what + (exact ? ", exact" : ", map");
    std::cout << which << ": " << verdicts.ToString() << "\n";
    RELIEVO_CHECK_THAT(static_cast<double>(verdicts.Compared) > 0.26 * pixels &&
        static_cast<double>(verdicts.Dark) > 0.0065 * pixels,
      which + ": too little");
    RELIEVO_CHECK_AT_MOST(
      verdicts.Wrong(), exact ? limits.Exact : limits.Map, which + ": share of wrong verdicts");
  }
  // The picture has walls wherever the truth has.
  stage.GetFrame()->ShadowsOn();
  const auto picture = relievoTest::Picture(stage.Window);
  const auto* colors = static_cast<unsigned char*>(picture->GetScalarPointer());
  long long bare = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    const unsigned char* color = colors + 3 * i;
    bare += view.Pixels[i].Inner && color[0] > 250 && color[1] < 5 && color[2] > 250 ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(bare, 0, what + ": pixels of walls that show the background");
  std::string name = what;
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((relievoTest::OutputFolder() + "/" + name + ".png").c_str());
  writer->SetInputData(picture);
  writer->Write();
}

// A hall in a block of rock: two balls of air and a pillar.
vtkTypeInt64 GetHall(int i, int j, int k)
{
  const auto ball = [&](double x, double y, double z, double radius) {
    const glm::dvec3 d(i + 0.5 - x, j + 0.5 - y, k + 0.5 - z);
    return glm::dot(d, d) <= radius * radius;
  };
  const bool pillar = i >= 9 && i <= 10 && j >= 9 && j <= 10;
  return !pillar && (ball(7.3, 8., 7., 5.2) || ball(13.5, 12., 7., 4.6)) ? 0 : 1;
}

void TestBlocks()
{
  vtkNew<vtkRelievoSmoothBlocks> blocks;
  blocks->SetStrength(0.2);
  vtkPolyData* surface = relievoTest::Run(blocks, relievoTest::MakeBlocks({ 20, 20, 14 }, GetHall));
  const glm::dvec3 lamp(12., 9., 8.5);
  struct
  {
    const char* What;
    Eye View;
    glm::dvec3 Lamp;
  } const cases[] = {
    { "hall", { { 5., 6., 7. }, { 13., 11., 6.5 }, 0.05, 60. }, lamp },
    { "hall, looking up", { { 5., 6., 7. }, { 8., 9., 11. }, 0.05, 60. }, lamp },
    { "hall, a pillar cut open", { { 8., 8.2, 7. }, { 13., 12.5, 6.5 }, 2.6, 60. }, lamp },
    { "inside the rock", { { 1.2, 1.3, 7.4 }, { 9., 10., 6.8 }, 0.05, 60. }, { 2., 1.1, 8. } },
    { "inside the rock, lamp in the hall", { { 1.2, 1.3, 7.4 }, { 9., 10., 6.8 }, 0.05, 60. },
      lamp },
    { "on a wall", { { 0.1, 10., 7. }, { 20., 11., 7. }, 1e-3, 60. }, { 0.4, 8., 9. } },
  };
  // One window, whose shaders are those of all cases.
  ShadowStage stage(320, 240);
  const auto actor = relievoTest::AddActor(stage.Renderer, surface);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(0.8, 0.75, 0.6);
  const auto light = stage.AddLamp(lamp, { 10., 10., 7. }, 90.);
  EmbreeScene truth;
  truth.AddActors(stage.Renderer);
  for (const auto& one : cases)
  {
    light->SetPosition(one.Lamp.x, one.Lamp.y, one.Lamp.z);
    Look(stage, one.View);
    Check(stage, truth, one.What);
  }
}

// The place of a cave's sample from which the nearest rock along the axes is farthest.
glm::ivec3 FindRoom(vtkImageData* caves, glm::ivec3& farthest)
{
  const int* size = caves->GetDimensions();
  vtkDataArray* labels = caves->GetPointData()->GetScalars();
  const auto isAir = [&](glm::ivec3 p) {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (p[axis] < 0 || p[axis] >= size[axis])
      {
        return false;
      }
    }
    return labels->GetComponent((static_cast<vtkIdType>(p.z) * size[1] + p.y) * size[0] + p.x, 0) ==
      0.;
  };
  glm::ivec3 best(0);
  int most = -1;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const glm::ivec3 place(i, j, k);
        int least = 1000;
        int far = -1;
        glm::ivec3 end(0);
        for (int side = 0; side < 6; ++side)
        {
          glm::ivec3 step(0);
          step[side / 2] = side % 2 ? 1 : -1;
          int count = 0;
          while (isAir(place + count * step))
          {
            ++count;
          }
          least = std::min(least, count);
          if (count > far)
          {
            far = count;
            end = place + (count - 1) * step;
          }
        }
        if (16 * least + far > most && least > 2)
        {
          most = 16 * least + far;
          best = place;
          farthest = end;
        }
      }
    }
  }
  RELIEVO_CHECK_THAT(most > 0, "no room in the cave");
  return best;
}

void TestCaves()
{
  vtkNew<vtkRelievoCaves> caves;
  caves->SetSize(96, 96, 64);
  caves->SetSeed(7);
  caves->SetTunnelWidth(12.);
  caves->SetContent(vtkRelievoCaves::LABELS);
  caves->Update();
  glm::ivec3 end(0);
  const glm::dvec3 room(FindRoom(caves->GetOutput(), end));
  vtkNew<vtkRelievoSmoothBlocks> blocks;
  blocks->SetInputConnection(caves->GetOutputPort());
  blocks->SetNoiseAmplitude(0.4);
  blocks->SetNoiseDimensions(3);
  blocks->Update();
  const glm::dvec3 way = glm::dvec3(end) - room;
  std::cout << "the cave's room is at " << room.x << " " << room.y << " " << room.z
            << ", one looks " << glm::length(way) << " far\n";
  // One window, whose shaders are those of both views.
  ShadowStage stage(320, 240);
  relievoTest::AddActor(stage.Renderer, blocks->GetOutput())->GetMapper()->ScalarVisibilityOff();
  const glm::dvec3 aside(0.7, -0.4, 0.3);
  const auto light = stage.AddLamp(room, room + way, 90.);
  stage.AddBox(room + 0.3 * way + 0.3 * aside, { 0.6, 0.6, 0.6 });
  EmbreeScene truth;
  truth.AddActors(stage.Renderer);
  for (const bool back : { false, true })
  {
    const glm::dvec3 lamp = room + (back ? 0.35 : -0.05) * way + aside;
    light->SetPosition(lamp.x, lamp.y, lamp.z);
    light->SetFocalPoint(room.x, room.y, room.z);
    const glm::dvec3 ahead = way + 0.4 * aside;
    Look(stage, { room, room + (back ? -ahead : ahead), 0.02, 200. });
    Check(stage, truth, back ? "cave, looking back" : "cave");
  }
}

// The cubes as the filter computes them, in double.
vtkSmartPointer<vtkPolyData> MakeCubes(vtkPolyData* centers)
{
  std::vector<glm::dvec3> corners;
  vtkNew<vtkCellArray> quads;
  vtkDataArray* scales = centers->GetPointData()->GetArray("scale");
  for (vtkIdType cube = 0; cube < centers->GetNumberOfPoints(); ++cube)
  {
    glm::dvec3 center;
    glm::dvec3 scale;
    centers->GetPoint(cube, &center.x);
    scales->GetTuple(cube, &scale.x);
    const auto first = static_cast<vtkIdType>(corners.size());
    for (int i = 0; i < 8; ++i)
    {
      corners.push_back(
        center + scale * (glm::dvec3(i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0.) - 0.5));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType u = 1 << axis;
      const vtkIdType v = 1 << (axis + 1) % 3;
      const vtkIdType w = 7 - u - v;
      quads->InsertNextCell({ first, first + u, first + u + v, first + v });
      quads->InsertNextCell({ first + w, first + w + u, first + w + u + v, first + w + v });
    }
  }
  auto mesh = relievoTest::MakePolygons(corners);
  mesh->SetPolys(quads);
  return mesh;
}

// A hollow ball of cubes around the camera, with and without smaller cubes that reach into the
// hollow. Props moved in the shader cast by maps, for any method.
void TestCubes()
{
  const relievoTest::Solid ball = relievoTest::MakeHollowBall();
  for (const double transition : { 0., 0.16 })
  {
    vtkNew<vtkRelievoVoxelShell> shell;
    shell->SetInputData(ball.Mesh);
    shell->SetResolution(26);
    shell->SetPadding(2);
    vtkNew<vtkRelievoVoxelCubes> cubes[2];
    for (int i = 0; i < 2; ++i)
    {
      cubes[i]->SetInputConnection(shell->GetOutputPort());
      cubes[i]->SetTransition(transition);
      cubes[i]->SetRestSize(0.2);
      cubes[i]->SetInstanced(i == 1);
      cubes[i]->Update();
    }
    ShadowStage stage(160, 120); // their layers take long
    vtkNew<vtkRelievoVoxelCubesActor> actor;
    actor->SetInputConnection(cubes[1]->GetOutputPort());
    actor->SetCellSize(shell->GetOutput()->GetSpacing());
    actor->SetTransition(transition);
    actor->SetRestSize(0.2);
    stage.Renderer->AddActor(actor);
    const auto box = stage.AddBox({ 0.12, 0.08, 0.02 }, { 0.07, 0.05, 0.06 });
    stage.AddLamp({ -0.1, 0.05, 0.16 }, { 0., 0., 0. }, 90.);
    stage.GetShadows()->SetMapSize(transition > 0. ? 1024 : 640); // cubes fill it many times over
    Look(stage, { { -0.12, -0.16, 0.04 }, { 0.3, 0.15, 0. }, 5e-3, 4. });
    EmbreeScene truth;
    truth.AddActor(MakeCubes(cubes[0]->GetOutput()));
    truth.AddActor(vtkPolyData::SafeDownCast(box->GetMapper()->GetInput()));
    Limits limits;
    limits.Coverage = 1e-3;
    limits.Depth = 2e-4; // of sides seen nearly edge-on: the shader places cubes in float
    limits.Exact = limits.Map;
    Check(stage, truth, transition > 0. ? "growing cubes" : "cubes", limits);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testCameraInside)
{
  relievoTest::Session session;
  TestBlocks();
  TestCaves();
  TestCubes();
  return session.Result();
}
}
