// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Certificates of casters that are more than opaque meshes: panes that attenuate, by exact shadows
// and by maps, and data in blocks with attributes of their own; and the rays sent for plans, which
// most moves of a camera do not send again.
#include "Check.h"
#include "EmbreeScene.h"
#include "Props.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>

#include <cmath>
#include <iostream>
#include <set>
#include <string>

namespace testShadowCertifyCasters
{
namespace
{
using Certificate = vtkRelievoShadowCertificate;
using Pass = vtkRelievoShadowStage;
using relievoTest::ShadowStage;

constexpr int All = 1 << 30;

// Two panes out of the picture, which overlap from above.
void AddPanes(ShadowStage& stage)
{
  const double opacity[2] = { 0.3, 0.6 };
  for (int i = 0; i < 2; ++i)
  {
    const double x = -1.5 + 0.8 * i;
    const double y = 4. + i;
    const auto mesh = relievoTest::MakePolygons(
      { { x, y, -1. }, { x + 1.6, y, -1. }, { x + 1.6, y, 1. }, { x, y, 1. } });
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    const auto pane = relievoTest::AddActor(stage.Renderer, mesh);
    pane->GetProperty()->SetOpacity(opacity[i]);
    stage.GetShadows()->SetPropCasts(pane, Pass::CASTS_ALWAYS);
  }
}

// Pixels of the layer shadow_0 near a value.
int CountNear(ShadowStage& stage, double value)
{
  const auto image = relievoTest::CaptureShadow(stage, 0);
  auto* shares = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"));
  int count = 0;
  for (vtkIdType i = 0; i < shares->GetNumberOfTuples(); ++i)
  {
    count += std::abs(shares->GetValue(i) - value) < 0.005 ? 1 : 0;
  }
  return count;
}

void TestPanes()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ 1.6, 0.4, 1.2 }, { 0.5, 0.8, 0.5 });
  AddPanes(stage);
  stage.AddSun(0., 5., 0.);
  Pass* shadows = stage.GetShadows();
  stage.GetFrame()->ShadowsOn();
  shadows->SetMethodToExact();
  stage.Window->Render();
  // 1 - opacity of either, and their product where both are in the way.
  for (const double share : { 0.7, 0.4, 0.28 })
  {
    RELIEVO_CHECK_THAT(CountNear(stage, share) > 300, "panes: too few pixels of a share");
  }
  const vtkSmartPointer<Certificate> exact = shadows->Certify(All);
  std::cout << "panes: " << exact->GetWords() << "\n";
  RELIEVO_CHECK_THAT(exact->GetWrong() == 0 && exact->GetUnknown() == 0, exact->GetWords());
  RELIEVO_CHECK_THAT(exact->GetJudged() > 10000, exact->GetWords());
  // Maps know all of the light or nothing, and panes as opaque casters: judged by that, only edges
  // are wrong.
  shadows->SetMethodToMap();
  stage.Window->Render();
  RELIEVO_CHECK(CountNear(stage, 0.) > 1500);
  const vtkSmartPointer<Certificate> map = shadows->Certify(All);
  RELIEVO_CHECK_THAT(map->GetWrongShare() < 2e-3, map->GetWords());
  RELIEVO_CHECK_THAT(map->GetJudged() > 10000, map->GetWords());
  shadows->SetMapSize(32);
  stage.Window->Render();
  const vtkSmartPointer<Certificate> coarse = shadows->Certify(All);
  RELIEVO_CHECK_THAT(coarse->GetWrongShare() > 5. * map->GetWrongShare(), coarse->GetWords());
}

// Ground, and boxes in nested blocks: one hidden, one of glass, which casts or not.
struct BlockStage : ShadowStage
{
  vtkNew<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkRelievoCompositeMapper> Mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkPolyData> Boxes[4];

  BlockStage()
  {
    this->AddGround();
    vtkNew<vtkMultiBlockDataSet> inner;
    const double places[4][3] = { { -1.5, 0.4, 0.5 }, { 0., 0.6, -0.5 }, { 1.4, 0.5, 0.8 },
      { 0.3, 0.5, 1.4 } };
    for (unsigned int i = 0; i < 4; ++i)
    {
      this->Boxes[i] = relievoTest::Moved(
        relievoTest::MakeBox(0.5, 0.6, 0.5), places[i][0], places[i][1], places[i][2]);
      (i < 2 ? inner : this->Blocks)->SetBlock(i, this->Boxes[i]);
    }
    this->Blocks->SetBlock(0, inner);
    this->Mapper->SetInputDataObject(this->Blocks);
    this->Mapper->SetCompositeDataDisplayAttributes(this->Attributes);
    this->Actor = relievoTest::AddActor(this->Renderer, this->Boxes[0]);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->SetOrientation(0., 20., 0.);
    this->Actor->SetPosition(0.1, 0.1, -0.2);
    this->AddSun(-3., 4., -2.);
    this->GetFrame()->ShadowsOn();
    this->GetShadows()->SetMethodToExact();
  }

  void Hide(int box)
  {
    this->Attributes->SetBlockVisibility(this->Boxes[box], false);
    this->Mapper->Modified();
  }
};

void TestBlocks()
{
  BlockStage stage;
  const auto truth = [&stage](const std::set<int>& hidden) {
    relievoTest::EmbreeScene scene;
    scene.AddActors(stage.Renderer); // the ground
    for (int i = 0; i < 4; ++i)
    {
      if (!hidden.count(i))
      {
        scene.AddActor(stage.Boxes[i], stage.Actor->GetMatrix());
      }
    }
    return relievoTest::JudgeShadow(stage, 0, &scene);
  };
  const auto check = [&](const char* what, const relievoTest::ShadowErrors& errors) {
    std::cout << "blocks, " << what << ": " << errors.ToString() << "\n";
    RELIEVO_CHECK_THAT(errors.Compared > 10000 && errors.Dark > 500, what);
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), 1e-4, what);
    const vtkSmartPointer<Certificate> all = stage.GetShadows()->Certify(All);
    // A pixel at an edge may show a surface that a ray through its centre misses.
    RELIEVO_CHECK_THAT(all->GetWrong() == 0 && all->GetUnknown() < 5, all->GetWords());
    RELIEVO_CHECK_THAT(all->GetJudged() > 10000, all->GetWords());
    return errors.Dark;
  };
  stage.Window->Render();
  const long long all = check("all", truth({}));
  stage.Hide(1);
  stage.Window->Render();
  RELIEVO_CHECK(check("one hidden", truth({ 1 })) < all);
  // A block of glass casts nothing while only opaque geometry casts.
  stage.Attributes->SetBlockOpacity(stage.Boxes[2], 0.5);
  stage.Mapper->Modified();
  stage.Window->Render();
  const vtkSmartPointer<Certificate> glass = stage.GetShadows()->Certify(All);
  std::cout << "blocks, one of glass: " << glass->GetWords() << "\n";
  RELIEVO_CHECK_THAT(glass->GetWrong() == 0 && glass->GetJudged() > 5000, glass->GetWords());
  stage.GetShadows()->SetPropCasts(stage.Actor, Pass::CASTS_ALWAYS);
  stage.Window->Render();
  RELIEVO_CHECK(CountNear(stage, 0.25) > 100); // two walls
  const vtkSmartPointer<Certificate> casts = stage.GetShadows()->Certify(All);
  std::cout << "blocks, glass that casts: " << casts->GetWords() << "\n";
  RELIEVO_CHECK_THAT(casts->GetWrong() == 0 && casts->GetJudged() > 5000, casts->GetWords());
}

// Rays are traced again after the view has moved by some steps, and not for each frame: their
// result stays in between.
void TestProbes()
{
  ShadowStage stage(160, 120);
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  shadows->SetTolerance(1e-3);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const auto count = [&](double step, int frames) {
    std::set<double> shares;
    for (int i = 0; i < frames; ++i)
    {
      camera->Azimuth(step);
      stage.Window->Render();
      shares.insert(shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024));
    }
    return shares.size();
  };
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(count(0.02, 60)), 6., "shares in 60 frames of an orbit's degree");
  RELIEVO_CHECK_THAT(count(10., 6) >= 5, "shares in 60 degrees");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowCertifyCasters)
{
  relievoTest::Session session;
  TestPanes();
  TestBlocks();
  TestProbes();
  return session.Result();
}
}
