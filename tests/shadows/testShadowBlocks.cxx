// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Glyphs of blocks within blocks: when one is taken out or exchanged for an older one, its shadow
// follows, though no data that is left has changed. (VTK's composite meshes do not follow that
// themselves.)
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <string>

namespace testShadowBlocks
{
namespace
{
using relievoTest::Picture;
using relievoTest::SamePicture;

vtkSmartPointer<vtkPolyData> MakeBlock(double x)
{
  auto block = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, 0.8, 0.);
  block->SetPoints(points);
  return block;
}

// Three blocks, the oldest in no picture at first.
struct Scene : relievoTest::ShadowStage
{
  vtkSmartPointer<vtkPolyData> Oldest;
  vtkNew<vtkMultiBlockDataSet> Outer;
  vtkNew<vtkMultiBlockDataSet> Inner;

  explicit Scene(int method)
    : ShadowStage(120, 90)
  {
    this->AddGround();
    this->AddSun(-3., 4., -2.);
    this->Oldest = MakeBlock(0.2);
    this->Inner->SetBlock(0, MakeBlock(-1.));
    this->Inner->SetBlock(1, MakeBlock(1.4));
    this->Outer->SetBlock(0, this->Inner);
    vtkNew<vtkActor> actor;
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputDataObject(this->Outer);
    mapper->SetSourceConnection(cube->GetOutputPort());
    mapper->SetScaleFactor(0.5);
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->GetShadows()->SetMethod(method);
    this->GetFrame()->ShadowsOn();
  }
};

void TestChanges(int method)
{
  const std::string what = "method " + std::to_string(method);
  Scene scene(method);
  const relievoTest::GLCheck gl(scene.Window);
  const auto before = Picture(scene.Window);
  scene.Inner->SetBlock(0, nullptr);
  const auto fewer = Picture(scene.Window);
  scene.Inner->SetBlock(0, scene.Oldest);
  const auto other = Picture(scene.Window);
  RELIEVO_CHECK(relievoTest::CountUnlike(before, fewer, 8) > 100);
  RELIEVO_CHECK(relievoTest::CountUnlike(fewer, other, 8) > 100);
  Scene fresh(method);
  fresh.Inner->SetBlock(0, nullptr);
  RELIEVO_CHECK(SamePicture(Picture(fresh.Window), fewer, what + ": taken out"));
  Scene late(method);
  late.Inner->SetBlock(0, late.Oldest);
  RELIEVO_CHECK(SamePicture(Picture(late.Window), other, what + ": an older one"));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowBlocks)
{
  relievoTest::Session session;
  TestChanges(vtkRelievoShadowStage::METHOD_MAP);
  TestChanges(vtkRelievoShadowStage::METHOD_EXACT);
  return session.Result();
}
}
