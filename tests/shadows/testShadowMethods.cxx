// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The methods behind vtkRelievoShadowStage::SetMethod: how wrong each is against rays, where warped
// maps win, first frames, back to the first method, and VTK's own shadows beside ours.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLightsPass.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoMeshTexels.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

#include <iostream>
#include <string>
#include <vector>

namespace testShadowMethods
{
namespace
{
using relievoTest::ShadowStage;
using Pass = vtkRelievoShadowStage;

const char* const Names[] = { "map", "forward", "warped" };

bool SameLayer(vtkImageData* a, vtkImageData* b)
{
  return relievoTest::CountDifferent(relievoTest::Layers(a), relievoTest::Layers(b), "shadow_0") ==
    0;
}

// Sun and lamps on plain things. Forward has no filter, so its edges are a texel and a pixel wide.
void TestErrors()
{
  for (const int method : { Pass::METHOD_MAP, Pass::METHOD_FORWARD, Pass::METHOD_WARPED })
  {
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.AddThings();
    stage.AddSun(-3., 4., -2.);
    stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.);
    stage.AddLamp({ 0.2, 2.5, 1.5 }, { 0.3, 0., 0.3 }, 90.); // several maps
    stage.GetShadows()->SetMethod(method);
    stage.GetShadows()->SetMapSize(512);
    const double limit = method == Pass::METHOD_FORWARD ? 0.02 : 0.005;
    for (int light = 0; light < 3; ++light)
    {
      relievoTest::CheckShadow(
        stage, light, limit, std::string(Names[method]) + ", light " + std::to_string(light));
    }
  }
}

// The far poles take most of an even map for nothing.
void TestHorizon()
{
  double error[3] = { 0., 0., 0. };
  for (const int method : { Pass::METHOD_MAP, Pass::METHOD_WARPED })
  {
    ShadowStage stage(400, 300);
    stage.AddPolesToHorizon();
    stage.GetShadows()->SetMethod(method);
    stage.GetShadows()->SetMapSize(1024);
    const auto errors = relievoTest::JudgeShadow(stage, 0);
    std::cout << "horizon, " << Names[method] << ": " << errors.ToString() << "\n";
    RELIEVO_CHECK(errors.Dark > 1000);
    error[method] = errors.Wrong();
  }
  RELIEVO_CHECK_AT_MOST(
    error[Pass::METHOD_WARPED] / error[Pass::METHOD_MAP], 0.75, "horizon, warped over map");
}

// The caster is out of the view, and the receiver is flat: the map's near plane is at the receiver.
void TestFlatReceiver()
{
  for (const int method : { Pass::METHOD_MAP, Pass::METHOD_WARPED })
  {
    for (const double bias : { 1.5, 50. })
    {
      ShadowStage stage;
      stage.AddGround();
      stage.AddBox({ 0., 5., 0. }, { 1.5, 0.01, 1.5 });
      stage.Renderer->GetActiveCamera()->SetPosition(0., 2., 0.01);
      stage.Renderer->GetActiveCamera()->SetFocalPoint(0., 0., 0.);
      stage.Renderer->GetActiveCamera()->SetViewAngle(80.);
      stage.Renderer->GetActiveCamera()->SetClippingRange(0.1, 10.);
      stage.AddSun(0.3, 5., 0.2);
      stage.GetShadows()->SetMethod(method);
      stage.GetShadows()->SetBias(bias);
      relievoTest::CheckShadow(stage, 0, 0.002,
        std::string("flat ground, ") + Names[method] + ", bias " + std::to_string(bias));
    }
  }
}

// The first frame of a renderer is as right as the next ones, and methods leave nothing behind.
void TestChanges()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  vtkRelievoPass* frame = stage.GetFrame();
  vtkSmartPointer<vtkImageData> first[3];
  vtkIdType bytes[3] = { 0, 0, 0 };
  for (const bool again : { false, true })
  {
    for (const int method : { Pass::METHOD_MAP, Pass::METHOD_FORWARD, Pass::METHOD_WARPED })
    {
      stage.GetShadows()->SetMethod(method);
      stage.GetShadows()->SetMapSize(512);
      frame->ShadowsOn();
      frame->RequestLayer("shadow_0");
      for (int i = 0; i < 2; ++i)
      {
        stage.Window->Render();
        vtkNew<vtkImageData> image;
        RELIEVO_CHECK(frame->ReadLayer("shadow_0", image));
        const std::string what = std::string(Names[method]) + (again ? ", again" : "");
        if (!first[method])
        {
          first[method] = image;
          bytes[method] = frame->GetBytesHeld();
        }
        RELIEVO_CHECK_THAT(SameLayer(first[method], image), what + ": another picture");
        RELIEVO_CHECK_THAT(bytes[method] == frame->GetBytesHeld(), what + ": other bytes");
      }
    }
  }
  RELIEVO_CHECK_THAT(
    !SameLayer(first[0], first[1]), "methods that make the same picture are one method");
  RELIEVO_CHECK_THAT(SameLayer(first[0], first[2]),
    "warped is map where the farthest is hardly farther than the nearest");
}

// Props that draw themselves are counted wherever they are drawn, and a static picture redraws
// neither maps nor masks, even if its mappers count as modified when they draw.
void TestDraws()
{
  int first[2] = { 0, 0 };
  for (const int method : { Pass::METHOD_MAP, Pass::METHOD_FORWARD })
  {
    ShadowStage stage;
    stage.AddGround();
    stage.AddSun(-3., 4., -2.);
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputData(relievoTest::MakePolygons({ { -1., 0.6, 0. }, { 1., 0.6, 0. } }));
    glyphs->SetSourceData(relievoTest::MakeBox(0.5, 0.5, 0.5));
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, relievoTest::MakeBox(0.2, 2., 0.2));
    vtkNew<vtkRelievoCompositeMapper> composite;
    composite->SetInputDataObject(blocks);
    vtkNew<vtkDataSetMapper> data;
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    image->SetSpacing(0.2, 0.2, 0.2);
    image->SetOrigin(0.3, 0.3, 0.6);
    data->SetInputData(image);
    for (vtkMapper* mapper : { static_cast<vtkMapper*>(glyphs), static_cast<vtkMapper*>(composite),
           static_cast<vtkMapper*>(data) })
    {
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      stage.Renderer->AddActor(actor);
    }
    stage.GetShadows()->SetMethod(method);
    stage.GetFrame()->ShadowsOn();
    stage.Window->Render();
    const std::string what = std::string("draws, ") + Names[method];
    first[method] = stage.GetShadows()->GetDrawCalls();
    for (int frame = 2; frame <= 4; ++frame)
    {
      stage.Window->Render();
      RELIEVO_CHECK_THAT(
        stage.GetShadows()->GetDrawCalls() == 0 && stage.GetShadows()->GetNumberOfMapsDrawn() == 0,
        what + ", frame " + std::to_string(frame) + ": " +
          std::to_string(stage.GetShadows()->GetDrawCalls()) + " draw calls");
    }
    stage.GetFrame()->ShadowsOff();
    stage.Window->Render();
    RELIEVO_CHECK_THAT(
      stage.GetShadows()->GetDrawCalls() == 0 && stage.GetShadows()->GetNumberOfMaps() == 0,
      what + ": counts of a frame without shadows");
  }
  // The map's draws once more, as the camera sees them, and the map's samples.
  RELIEVO_CHECK_THAT(
    first[Pass::METHOD_MAP] > 3 && first[Pass::METHOD_FORWARD] == 2 * first[Pass::METHOD_MAP] + 1,
    "draws: " + std::to_string(first[Pass::METHOD_MAP]) + " and " +
      std::to_string(first[Pass::METHOD_FORWARD]));
}

// VTK's own shadow pass as the delegate: light would be taken twice. Ours says so and leaves it.
void TestPeer()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  vtkNew<vtkShadowMapBakerPass> baker;
  vtkNew<vtkShadowMapPass> peer;
  vtkNew<vtkSequencePass> opaque;
  vtkNew<vtkRenderPassCollection> steps;
  steps->AddItem(vtkNew<vtkLightsPass>());
  steps->AddItem(vtkNew<vtkOpaquePass>());
  opaque->SetPasses(steps);
  baker->SetOpaqueSequence(opaque);
  peer->SetShadowMapBakerPass(baker);
  peer->SetOpaqueSequence(opaque);
  vtkRelievoPass* frame = stage.GetFrame();
  vtkNew<vtkSequencePass> both;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(peer);
  both->SetPasses(passes);
  frame->SetDelegatePass(both);
  stage.Window->Render();
  std::vector<std::string> said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* list, void* text) {
    static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text));
  });
  stage.GetShadows()->AddObserver(vtkCommand::ErrorEvent, listen);
  frame->ShadowsOn();
  stage.Window->Render();
  stage.Window->Render();
  RELIEVO_CHECK_THAT(said.size() == 1 && said[0].find("vtkShadowMapPass") != std::string::npos,
    "VTK's own shadows beside ours: said " + (said.empty() ? "nothing" : said[0]) + ", times " +
      std::to_string(said.size()));
}

// A mesh of more triangles than rays follow casts by a map, which is said once.
void TestTooManyTriangles()
{
  const vtkIdType most = vtkRelievoMeshTexels::GetMostTriangles();
  vtkRelievoMeshTexels::SetMostTriangles(11); // of a box's 12
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  {
    const relievoTest::ExpectMessage said(
      "A mesh of 12 triangles casts its shadow by a map: rays follow at most 11 of a mesh.");
    const relievoTest::ShadowErrors errors = relievoTest::JudgeShadow(stage, 0);
    relievoTest::CaptureShadow(stage, 0);
    RELIEVO_CHECK(said.Count() == 1);
    RELIEVO_CHECK(errors.Dark > 500);
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), 1e-3, "boxes that are not followed: wrong pixels");
  }
  vtkRelievoMeshTexels::SetMostTriangles(most);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowMethods)
{
  relievoTest::Session session;
  TestErrors();
  TestHorizon();
  TestFlatReceiver();
  TestChanges();
  TestDraws();
  TestPeer();
  TestTooManyTriangles();
  return session.Result();
}
}
