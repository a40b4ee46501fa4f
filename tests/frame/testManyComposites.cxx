// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// With more actors of composite data than a window has texture units, tone and shadows equal those
// of the surfaces drawn by the plain mapper, from the first frame on, for any first frame: since
// 9.6 VTK leaves a unit in use for each.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "ToneScene.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoToneStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <string>
#include <vector>

namespace testManyComposites
{
namespace
{
const int SIDE = 9; // 81 actors; there are 16 to 32 units

struct Boxes
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit Boxes(bool composite)
  {
    for (int i = 0; i < SIDE * SIDE; ++i)
    {
      vtkNew<vtkCubeSource> box;
      box->SetCenter(i % SIDE, i / SIDE, 0.1 * (i % 5));
      box->SetXLength(0.7);
      box->SetYLength(0.7);
      box->Update();
      vtkSmartPointer<vtkMapper> mapper;
      if (composite)
      {
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, box->GetOutput());
        auto drawn = vtkSmartPointer<vtkRelievoCompositeMapper>::New();
        drawn->SetInputDataObject(blocks);
        mapper = drawn;
      }
      else
      {
        auto drawn = vtkSmartPointer<vtkPolyDataMapper>::New();
        drawn->SetInputData(box->GetOutput());
        mapper = drawn;
      }
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.9, 0.1 * (i % 10), 0.3);
      this->Renderer->AddActor(actor);
    }
    vtkNew<vtkLight> sun;
    sun->SetPosition(1.0, 2.0, 2.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    sun->SetIntensity(2.0);
    this->Renderer->AddLight(sun);
    this->Window = relievoTest::MakeWindow(160, 120, this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(-4.0, -6.0, 12.0);
    this->Renderer->GetActiveCamera()->SetFocalPoint(4.0, 4.0, 0.0);
    this->Renderer->ResetCamera();
  }

  void Attach()
  {
    vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Renderer);
    frame->GetStage("tone")->EnabledOn();
    frame->GetStage("shadows")->EnabledOn();
  }
};

void TestPictures(bool drawnBefore)
{
  const std::string who = drawnBefore ? "VTK's first" : "ours first";
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  for (const bool composite : { false, true })
  {
    Boxes boxes(composite);
    const auto plain = drawnBefore ? relievoTest::Picture(boxes.Window) : nullptr;
    boxes.Attach();
    for (int frame = 0; frame < 2; ++frame)
    {
      pictures.push_back(relievoTest::Picture(boxes.Window));
    }
    RELIEVO_CHECK_THAT(!plain || !relievoTest::IsSame(plain, pictures.back()), who + ": toned");
  }
  RELIEVO_CHECK_THAT(relievoTest::IsSame(pictures[0], pictures[2]), who + ": first frame");
  RELIEVO_CHECK_THAT(relievoTest::IsSame(pictures[1], pictures[3]), who + ": second frame");
}
}

RELIEVO_TEST_CASE(testManyComposites)
{
  relievoTest::Session session;
  session.Allow("Hardware does not support the number of textures"); // of VTK's first frame
  TestPictures(false);
  TestPictures(true);
  return session.Result();
}
}
