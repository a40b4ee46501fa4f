// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Soft shadows where a frame is not followed by a second of the same: scenes that change by
// themselves, frames that are aborted, several views in turn; and verdicts that are kept.
#include "Check.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SoftStage.h"
#include "TestCase.h"

#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cstdlib>
#include <string>

namespace testShadowSoftViews
{
namespace
{
using relievoTest::SamePicture;

// A mesh that counts itself as changed whenever it is asked.
class UnsteadyMesh : public vtkPolyDataAlgorithm
{
public:
  static UnsteadyMesh* New();
  vtkTypeMacro(UnsteadyMesh, vtkPolyDataAlgorithm);
  vtkSmartPointer<vtkPolyData> Mesh;
  int Runs = 0;

  vtkMTimeType GetMTime() override
  {
    this->MTime.Modified();
    return this->Superclass::GetMTime();
  }

protected:
  UnsteadyMesh() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkPolyData::GetData(outputs)->ShallowCopy(this->Mesh);
    ++this->Runs;
    RELIEVO_CHECK_THAT(this->Runs < 2000, "a frame does not end");
    if (this->Runs >= 2000)
    {
      std::exit(1);
    }
    return 1;
  }
};
vtkStandardNewMacro(UnsteadyMesh);

// A scene that changes whenever it is drawn never accumulates from frame to frame, but it does
// within one.
void TestUnsteady()
{
  SoftStage stage;
  vtkNew<UnsteadyMesh> source;
  source->Mesh = vtkPolyDataMapper::SafeDownCast(stage.Box->GetMapper())->GetInput();
  stage.Box->GetMapper()->SetInputConnection(source->GetOutputPort());
  stage.GetFrame()->WaitForSamplesOn();
  const auto unsteady = Picture(stage.Window);
  RELIEVO_CHECK(stage.GetFrame()->GetSamplesLeft() == 0);
  SamePicture(unsteady, SoftStage().DrawAll(), "of what changes in every frame");
  RELIEVO_CHECK(source->Runs > 1);
}

// Aborts while that mapper draws, of all that do in the frame, one after the other: the rest draw
// nothing. Returns whether there were so many.
bool RenderAborted(ShadowStage& stage, int draw = 1)
{
  int left = draw;
  const auto count = [&]() {
    if (--left == 0)
    {
      stage.Window->SetAbortRender(1);
    }
  };
  using Count = decltype(count);
  vtkNew<vtkCallbackCommand> begin;
  begin->SetClientData(const_cast<void*>(static_cast<const void*>(&count)));
  begin->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { (*static_cast<Count*>(data))(); });
  vtkActorCollection* actors = stage.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    actor->GetMapper()->AddObserver(vtkCommand::StartEvent, begin);
  }
  stage.Window->Render();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetMapper()->RemoveObserver(begin);
  }
  return left <= 0;
}

// Nothing of a frame that was cut short is kept, by any method, wherever it was cut.
void TestAbortedMaps()
{
  for (int method = 0; method < 4; ++method)
  {
    SoftStage fresh(0);
    fresh.GetShadows()->SetMethod(method);
    const auto picture = Picture(fresh.Window);
    int draw = 1;
    bool aborted = true;
    while (aborted)
    {
      SoftStage stage(0);
      stage.GetShadows()->SetMethod(method);
      aborted = RenderAborted(stage, draw);
      RenderAborted(stage, draw);
      SamePicture(picture, Picture(stage.Window),
        "after frames aborted at " + std::to_string(draw) + ", method " + std::to_string(method));
      draw *= 2;
    }
    RELIEVO_CHECK_THAT(draw > 8, "all mappers drew before the frame was aborted at 4");
  }
}

// Their times teach the planner nothing.
void TestAbortedTimes()
{
  SoftStage stage(0);
  stage.GetShadows()->SetTimeBudget(1e6);
  for (int frame = 0; frame < 9; ++frame)
  {
    stage.Sun->SetPosition(-3. + 0.1 * frame, 4., -2.);
    RenderAborted(stage);
    RELIEVO_CHECK(stage.GetShadows()->GetMillisecondsTaken() == -1.);
  }
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetShadows()->GetMillisecondsTaken() > 0.);
}

// An aborted frame shows the mean of its samples; the next one continues.
void TestAborted()
{
  SoftStage stage;
  stage.GetFrame()->WaitForSamplesOn();
  RenderAborted(stage);
  const int left = stage.GetFrame()->GetSamplesLeft();
  RELIEVO_CHECK_THAT(left > 0, std::to_string(left) + " samples left");
  SamePicture(SoftStage().DrawAll(), stage.DrawAll(), "after an aborted frame");
}

// Two views that one frame pass draws in turn have all their samples in each.
void TestSeveralViews()
{
  SoftStage stage;
  stage.Window->SetStereoTypeToSplitViewportHorizontal();
  stage.Window->StereoRenderOn();
  const auto both = stage.DrawAll();
  RELIEVO_CHECK(stage.GetFrame()->GetSamplesLeft() == 0);
  SoftStage atOnce;
  atOnce.GetShadows()->SoftAtOnceOn();
  atOnce.Window->SetStereoTypeToSplitViewportHorizontal();
  atOnce.Window->StereoRenderOn();
  SamePicture(both, Picture(atOnce.Window), "stereo");

  SoftStage first;
  vtkNew<vtkRenderer> second;
  first.Renderer->SetViewport(0., 0., 0.5, 1.);
  second->SetViewport(0.5, 0., 1., 1.);
  second->AddActor(first.Box);
  second->AddLight(first.Sun);
  second->SetPass(first.GetFrame());
  first.Window->AddRenderer(second);
  second->ResetCamera();
  const auto twice = first.DrawAll();
  SamePicture(twice, Picture(first.Window), "two renderers with one frame");
  first.GetShadows()->SoftAtOnceOn();
  SamePicture(twice, Picture(first.Window), "two renderers at once");
}

// Verdicts of `exact` are kept in tiles of 8 x 8 pixels, of which the last are cut off here.
void TestExact()
{
  constexpr int Width = 81;
  SoftStage fresh(Samples, Width, 57);
  fresh.GetShadows()->SetMethodToExact();
  fresh.GetShadows()->SoftAtOnceOn();
  const auto first = Picture(fresh.Window);
  SoftStage warm(Samples, Width, 57);
  warm.GetShadows()->SetMethodToExact();
  const auto gathered = warm.DrawAll();
  SamePicture(first, gathered, "exact, sample by sample");
  SamePicture(first, Picture(fresh.Window), "exact, once more at once");
  warm.Renderer->GetActiveCamera()->Azimuth(5.);
  warm.DrawAll();
  warm.Renderer->GetActiveCamera()->Azimuth(-5.);
  warm.Renderer->GetActiveCamera()->DeepCopy(fresh.Renderer->GetActiveCamera());
  SamePicture(first, warm.DrawAll(), "exact, after another view");
  warm.GetShadows()->SoftAtOnceOn();
  warm.Box->Modified();
  SamePicture(first, Picture(warm.Window), "exact, warm and at once");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE_APART(testShadowSoftViews)
{
  relievoTest::Session session;
  TestUnsteady();
  TestAborted();
  TestAbortedMaps();
  TestAbortedTimes();
  TestSeveralViews();
  TestExact();
  return session.Result();
}
}
