// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A surface and its wire frame that share a mapper have the same layers as with a mapper each, in
// either drawing order, and after any earlier drawing: both, one of them, other widths. So have
// thin lines and wide ones of the same blocks of composite data.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>

#include <cmath>
#include <string>
#include <vector>

namespace testLayersSharedMappers
{
namespace
{
using relievoTest::Layers;
using relievoTest::Stage;

const std::vector<std::string> Names = { "depth", "normal", "geometric_normal", "actor", "cell" };

struct Step
{
  const char* Name;
  bool Surface;
  bool Wires;
  float Width;
};

const Step Steps[] = {
  { "both", true, true, 3.F },
  { "both again", true, true, 3.F },
  { "the surface alone", true, false, 3.F },
  { "the wires alone", false, true, 3.F },
  { "the surface alone after the wires", true, false, 3.F },
  { "thin lines", true, true, 1.F },
  { "wide lines again", true, true, 3.F },
  { "in the end the surface alone", true, false, 3.F },
};

enum class Kind
{
  SurfaceAndWires,
  LinesOfBlocks
};

// Circles of latitude with normals, in a block of a block.
vtkSmartPointer<vtkMultiBlockDataSet> MakeLines()
{
  constexpr int corners = 24;
  auto circles = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> lines;
  for (int row = -3; row <= 3; ++row)
  {
    lines->InsertNextCell(corners + 1);
    for (int i = 0; i <= corners; ++i)
    {
      const double up = 0.3 * row;
      const double turn = 2. * vtkMath::Pi() * i / corners;
      const double normal[] = { std::cos(up) * std::cos(turn), std::sin(up),
        std::cos(up) * std::sin(turn) };
      lines->InsertCellPoint(points->InsertNextPoint(normal));
      normals->InsertNextTuple(normal);
    }
  }
  circles->SetPoints(points);
  circles->SetLines(lines);
  circles->GetPointData()->SetNormals(normals);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, circles);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, inner);
  return blocks;
}

vtkSmartPointer<vtkActor> AddLines(vtkRenderer* renderer, vtkMultiBlockDataSet* blocks)
{
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

struct Scene
{
  Stage Shown{ 240, 200 };
  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkActor> Wires;
  vtkRelievoPass* Frame;

  Scene(Kind kind, bool shared, bool wiresFirst)
  {
    vtkRenderer* renderer = this->Shown.Renderer;
    const auto ball = relievoTest::MakeBall(1.);
    const auto lines = MakeLines();
    const auto add = [&] {
      return kind == Kind::LinesOfBlocks ? AddLines(renderer, lines)
                                         : relievoTest::AddActor(renderer, ball);
    };
    const auto first = add();
    const auto second = add();
    if (shared)
    {
      second->SetMapper(first->GetMapper());
    }
    this->Wires = wiresFirst ? first : second;
    this->Surface = wiresFirst ? second : first;
    if (kind == Kind::LinesOfBlocks)
    {
      this->Wires->SetPosition(0.3, 0.1, 0.2);
    }
    else
    {
      this->Wires->GetProperty()->SetRepresentationToWireframe();
    }
    renderer->GetActiveCamera()->SetFocalPoint(0., 0., 0.);
    renderer->GetActiveCamera()->SetPosition(2.5, 2., 3.5);
    renderer->ResetCameraClippingRange();
    this->Frame = vtkRelievoPass::Attach(renderer);
    for (const std::string& name : Names)
    {
      this->Frame->RequestLayer(name);
    }
  }

  Layers Draw(const Step& step)
  {
    this->Surface->SetVisibility(step.Surface);
    this->Wires->SetVisibility(step.Wires);
    this->Wires->GetProperty()->SetLineWidth(step.Width);
    this->Shown.Window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(this->Frame->ReadLayers(Names, image));
    return Layers(image);
  }
};

void Test(Kind kind, bool wiresFirst)
{
  Scene shared(kind, true, wiresFirst);
  const relievoTest::GLCheck gl(shared.Shown.Window);
  for (const Step& step : Steps)
  {
    const Layers found = shared.Draw(step);
    Scene apart(kind, false, wiresFirst);
    const Layers expected = apart.Draw(step);
    const std::string what = (kind == Kind::LinesOfBlocks ? "blocks, " : "surface, ") +
      std::string(step.Name) + (wiresFirst ? ", wires first: " : ", wires last: ");
    for (const std::string& name : Names)
    {
      RELIEVO_CHECK_AT_MOST(
        relievoTest::CountDifferent(expected, found, name), 0, what + "pixels of " + name);
    }
    const vtkIdType wires = wiresFirst ? 0 : 1;
    RELIEVO_CHECK((found.CountId("actor", wires) > 500) == step.Wires);
    RELIEVO_CHECK((found.CountId("actor", 1 - wires) > 500) == step.Surface);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersSharedMappers)
{
  relievoTest::Session session;
  for (const Kind kind : { Kind::SurfaceAndWires, Kind::LinesOfBlocks })
  {
    Test(kind, false);
    Test(kind, true);
  }
  return session.Result();
}
}
