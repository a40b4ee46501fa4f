// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectScene.h"

#include "Check.h"
#include "GLCheck.h"
#include "Props.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "Window.h"

#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
double EffectPictures::GetError(int x, int y, double passes, const glm::dvec3& added) const
{
  double most = 0.;
  for (int i = 0; i < 3; ++i)
  {
    const double before =
      LinearFromSrgb(this->Plain->GetScalarComponentAsDouble(x, y, 0, i) / 255.);
    const double after = SrgbFromLinear(std::min(before * passes + added[i], 1.));
    // One level of the plain picture is more of the shown one where that is dark.
    most =
      std::max(most, std::abs(this->Shown->GetScalarComponentAsDouble(x, y, 0, i) - 255. * after));
  }
  return most;
}

//------------------------------------------------------------------------------
EffectScene::EffectScene(int width, int height, const glm::dvec3& origin)
  : Window(MakeWindow(width, height, Renderer))
  , Frame(vtkRelievoPass::Attach(Renderer))
  , Origin(origin)
{
  this->Renderer->SetBackground(0.2, 0.3, 0.4);
  this->Renderer->SetBackgroundAlpha(1.);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> EffectScene::Add(
  vtkPolyData* mesh, const glm::dvec3& place, double red, double green, double blue)
{
  auto actor = AddActor(this->Renderer, mesh);
  const glm::dvec3 moved = this->Origin + place;
  actor->SetPosition(moved.x, moved.y, moved.z);
  actor->GetProperty()->SetColor(red, green, blue);
  return actor;
}

//------------------------------------------------------------------------------
void EffectScene::LookFrom(const glm::dvec3& place, const glm::dvec3& focus)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 from = this->Origin + place;
  const glm::dvec3 to = this->Origin + focus;
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetFocalPoint(to.x, to.y, to.z);
  camera->SetViewAngle(50.);
  camera->SetClippingRange(0.5, 12.);
}

//------------------------------------------------------------------------------
Layers EffectScene::Read(const std::vector<std::string>& names)
{
  // Depths that the stage reads are not refined: refined ones are computed for readers alone.
  this->Frame->GetLayersStage()->RefineDepthOff();
  for (const std::string& name : names)
  {
    this->Frame->RequestLayer(name);
  }
  this->Window->Render();
  vtkNew<vtkImageData> image;
  for (const std::string& name : names)
  {
    RELIEVO_CHECK(this->Frame->ReadLayer(name, image));
    this->Frame->ReleaseLayer(name);
  }
  return Layers(image);
}

//------------------------------------------------------------------------------
EffectPictures EffectScene::Draw(vtkRelievoStage* stage)
{
  EffectPictures pictures;
  stage->EnabledOff();
  pictures.Plain = Picture(this->Window);
  stage->EnabledOn();
  pictures.Shown = Picture(this->Window);
  return pictures;
}

const std::vector<Look> PlainLooks = {
  { "perspective", [](vtkCamera*) {} },
  { "parallel",
    [](vtkCamera* camera) {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.7);
    } },
  { "parallel, sheared, off-centre",
    [](vtkCamera* camera) {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(2.);
      camera->SetViewShear(0.3, 0.2, 0.9);
      camera->SetWindowCenter(-0.2, 0.1);
    } },
};

//------------------------------------------------------------------------------
void CheckSame(const Layers& expected, EffectScene& scene, const std::string& layer)
{
  const Layers found = scene.Read({ layer, "color" });
  RELIEVO_CHECK(CountDifferent(expected, found, layer) == 0);
  RELIEVO_CHECK(CountDifferent(expected, found, "color") == 0);
}

//------------------------------------------------------------------------------
void CheckBlocks(EffectScene& scene, vtkRelievoPointStage* stage, vtkRelievoPointValues* set,
  vtkPolyData* good, vtkPolyData* bad, const Layers& expected, const std::string& layer)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, good);
  blocks->SetBlock(2, bad);
  stage->AddPoints(set);
  {
    ExpectMessage expect("AddPoints was given points that were added before");
    stage->AddPoints(set);
    RELIEVO_CHECK(expect.Count() == 1 && stage->GetNumberOfPointSets() == 1);
  }
  set->SetInputData(blocks);
  RELIEVO_CHECK(CountDifferent(expected, scene.Read({ layer }), layer) == 0);
  good->GetPointData()->Initialize();
  set->SetInputData(good);
}

//------------------------------------------------------------------------------
void CheckWrongArrays(EffectScene& scene, vtkRelievoPointValues* set, vtkPolyData* points,
  const std::vector<InvalidArray>& invalid)
{
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->InsertNextTuple2(1., 2.);
  points->GetPointData()->AddArray(pairs);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->InsertNextValue("thick");
  points->GetPointData()->AddArray(words);
  set->SetInputData(points);
  for (const InvalidArray& each : invalid)
  {
    set->SetArray(each.Value, each.Array);
    ExpectMessage expect(std::string("'") + each.Array + "'");
    scene.Window->Render();
    scene.Window->Render();
    RELIEVO_CHECK_THAT(
      expect.Count() == 1 && expect.Messages()[0].find(each.Says) != std::string::npos,
      std::string(each.Array) + ": " + (expect.Count() ? expect.Messages()[0] : "said nothing"));
    set->SetArray(each.Value, each.Value);
  }
}

//------------------------------------------------------------------------------
void CheckBeside(EffectScene& alone, EffectScene& both, const std::vector<int>& columns, int row)
{
  const auto left = Picture(alone.Window);
  const auto right = Picture(both.Window);
  for (const int x : columns)
  {
    for (int i = 0; i < 3; ++i)
    {
      RELIEVO_CHECK_NEAR(right->GetScalarComponentAsDouble(60 + x, row, 0, i),
        left->GetScalarComponentAsDouble(x, row, 0, i), 1., "beside another viewport");
    }
  }
}

//------------------------------------------------------------------------------
void CheckToggles(EffectScene& scene, vtkRelievoStage* stage, vtkImageData* shown,
  const std::function<void(int)>& change)
{
  const vtkIdType held = scene.Frame->GetBytesHeld();
  const GLObjects objects = CountGLObjects(scene.Window);
  for (int i = 0; i < 200; ++i)
  {
    stage->SetEnabled(i % 2 != 0);
    if (change)
    {
      change(i);
    }
    scene.Window->Render();
    RELIEVO_CHECK(i % 2 != 0 || scene.Frame->GetBytesHeld() == 0);
  }
  RELIEVO_CHECK(SamePicture(shown, Picture(scene.Window), "after 200 times off and on"));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == held);
  RELIEVO_CHECK_THAT(CountGLObjects(scene.Window).Bytes == objects.Bytes, "OpenGL's bytes grew");
  scene.Window->SetSize(90, 70);
  scene.Window->Render();
  scene.Window->SetSize(60, 45);
  RELIEVO_CHECK(SamePicture(shown, Picture(scene.Window), "after resizing"));
}

//------------------------------------------------------------------------------
void CheckOff(EffectScene& scene, const std::string& stage, const std::string& layer)
{
  scene.Frame->GetStage(stage)->EnabledOff();
  scene.Frame->RequestLayer(layer);
  scene.Window->Render();
  vtkNew<vtkImageData> image;
  ExpectMessage expect("the stage " + stage + " would write, but does not run: switched off");
  RELIEVO_CHECK(!scene.Frame->ReadLayer(layer, image));
}
}
