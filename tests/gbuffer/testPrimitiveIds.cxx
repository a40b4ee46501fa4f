// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers of primitives: the probe of an OpenGL that gives wrong ones, its judgement, and the
// ways out, forced here, which give the same ids.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "View.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPrimitiveIds.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <cstdio>

namespace testPrimitiveIds
{
namespace
{
using relievoTest::ExpectMessage;
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;

const std::vector<std::string> Ids = { "actor", "block", "cell" };

void TestJudgement()
{
  using namespace vtkRelievoPrimitiveIds;
  std::vector<std::uint32_t> words(Rows * Columns);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    words[i] = static_cast<std::uint32_t>(i / Columns);
  }
  RELIEVO_CHECK(vtkRelievoPrimitiveIds::Check(words));
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    for (const std::uint32_t invalid : { 0u, 1u, 7u, 77u, 0x3f000000u, 0xffffffffu })
    {
      auto broken = words;
      broken[i] = invalid;
      RELIEVO_CHECK(vtkRelievoPrimitiveIds::Check(broken) == (invalid == words[i]));
    }
  }
  RELIEVO_CHECK(!vtkRelievoPrimitiveIds::Check({}));
  RELIEVO_CHECK(!vtkRelievoPrimitiveIds::Check(std::vector<std::uint32_t>(Rows * Columns, 0u)));
}

void TestGeometryShader()
{
  std::string vertex = "out vec4 vertexVCVSOutput;\n  flat out int partVSOutput; // a comment\n"
                       "out vec2 plain;\nout float fewVSOutput[6];\nin vec3 plainer;\n"
                       "void main() { plain = plainer.xy; }\n";
  const std::string geometry = vtkRelievoPrimitiveIds::MakeGeometryShader(vertex, 2);
  for (const char* line : { "in vec4 vertexVCVSOutput[];", "out vec4 vertexVCGSOutput;",
         "flat in int partVSOutput[];", "flat out int partGSOutput;", "in vec2 plainVSOutput[];",
         "out vec2 plain;", "in float fewVSOutput[][6];", "out float fewGSOutput[6];",
         "fewGSOutput = fewVSOutput[i];", "gl_PrimitiveID = gl_PrimitiveIDIn;", "layout(lines) in;",
         "layout(line_strip, max_vertices = 2) out;" })
  {
    RELIEVO_CHECK_THAT(
      geometry.find(line) != std::string::npos, std::string("no ") + line + " in\n" + geometry);
  }
  RELIEVO_CHECK(vertex.find("{ plainVSOutput = plainer.xy; }") != std::string::npos);
  for (const char* other : { "out vec2 one, two;\n", "out Block { vec2 one; };\n", "out vec2\n" })
  {
    std::string source = other;
    RELIEVO_CHECK(vtkRelievoPrimitiveIds::MakeGeometryShader(source, 3).empty());
  }
}

vtkSmartPointer<vtkActor> Fill(vtkRenderer* renderer)
{
  auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.7));
  ball->SetPosition(0., 0.7, 0.);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  relievoTest::AddActor(renderer, relievoTest::MakeBox(2., 0.2, 2.));
  return ball;
}

// How far the pixel is from the nearest edge, as it is drawn, of an actor's cell.
double GetDistance(
  const relievoTest::View& view, vtkActor* actor, int cell, const glm::dvec2& pixel)
{
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
  double least = 1e9;
  if (cell < 0 || cell >= mesh->GetNumberOfCells())
  {
    return least;
  }
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  const glm::dvec3 origin(
    actor->GetPosition()[0], actor->GetPosition()[1], actor->GetPosition()[2]);
  const vtkIdType count = ids->GetNumberOfIds();
  for (vtkIdType i = 0; i < count; ++i)
  {
    glm::dvec3 ends[2];
    glm::dvec2 seen[2];
    for (int end = 0; end < 2; ++end)
    {
      mesh->GetPoint(ids->GetId((i + end) % count), &ends[end][0]);
      RELIEVO_CHECK(view.Project(origin + ends[end], seen[end]));
    }
    const glm::dvec2 along = seen[1] - seen[0];
    const double t = glm::clamp(
      glm::dot(pixel - seen[0], along) / std::max(1e-12, glm::dot(along, along)), 0., 1.);
    least = std::min(least, glm::distance(pixel, seen[0] + t * along));
  }
  return least;
}

// Mesa's software OpenGL cuts lines that come from a geometry shader up to 0.2 pixels elsewhere. So
// where lines of two cells cross or coincide another one may be seen, but only one that is there.
long long CountOthers(
  const Layers& a, const Layers& b, vtkActor* wires, const relievoTest::View& view)
{
  long long others = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      if (a.Id("cell", x, y) != b.Id("cell", x, y))
      {
        const glm::dvec2 pixel(x + 0.5, y + 0.5);
        const double farther = std::max(GetDistance(view, wires, a.Id("cell", x, y), pixel),
          GetDistance(view, wires, b.Id("cell", x, y), pixel));
        others += a.Id("actor", x, y) == 0 && b.Id("actor", x, y) == 0 && farther < 0.91 ? 0 : 1;
      }
    }
  }
  return others;
}

// Shares the layers' two ways with the picture as it is without.
void TestRoutes()
{
  using namespace vtkRelievoPrimitiveIds;
  const Stage stage(200, 140);
  const auto ball = Fill(stage.Renderer);
  const relievoTest::GLCheck gl(stage.Window);
  for (const int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    ball->GetProperty()->SetRepresentation(representation);
    ball->GetProperty()->SetPointSize(3.);
    const std::string what = ball->GetProperty()->GetRepresentationAsString();
    Force(-1);
    const Layers written(stage.Renderer, Ids);
    Force(ThroughGeometryShader);
    const Layers through(stage.Renderer, Ids);
    for (const std::string& name : Ids)
    {
      const bool crossing = representation == VTK_WIREFRAME && name == "cell";
      RELIEVO_CHECK_AT_MOST(crossing
          ? CountOthers(written, through, ball, relievoTest::View(stage.Renderer))
          : relievoTest::CountDifferent(written, through, name),
        0, what + ": pixels of " + name + " through a geometry shader");
    }
    Force(Unreliable);
    {
      ExpectMessage expect("wrong numbers of primitives");
      const Layers without(stage.Renderer, Ids);
      RELIEVO_CHECK_AT_MOST(
        relievoTest::CountDifferent(written, without, "actor"), 0, what + ": actors without cells");
      RELIEVO_CHECK(without.CountId("cell", -1) == 200 * 140);
    }
    Force(-1);
    const Layers again(stage.Renderer, Ids);
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(written, again, "cell"), 0, what + ": cells as before");
  }
}

std::string GetReported(vtkRelievoPass* frame)
{
  const std::string report = frame->GetFrameReport();
  const std::string key = "\"primitive_ids\": ";
  const std::size_t at = report.find(key);
  return at == std::string::npos ? "" : report.substr(at + key.size(), 15);
}

void TestReport()
{
  using namespace vtkRelievoPrimitiveIds;
  const Stage stage(100, 70);
  Fill(stage.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->GetLayersStage()->RefineDepthOff();
  frame->RequestLayer("normal");
  stage.Window->Render();
  RELIEVO_CHECK(GetReported(frame).rfind("null", 0) == 0);
  frame->RequestLayer("cell");
  stage.Window->Render();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(stage.Window.GetPointer());
  const std::string words = vtkRelievoLayersStage::ProbePrimitiveIds(window);
  RELIEVO_CHECK(GetReported(frame).substr(1, 5) == words.substr(0, 5));
  std::printf("this OpenGL's primitives: %s\n", words.c_str());
  Force(ThroughGeometryShader);
  stage.Window->Render();
  RELIEVO_CHECK(GetReported(frame).rfind("\"through a geo", 0) == 0);
  Force(Unreliable);
  {
    ExpectMessage expect("wrong numbers of primitives");
    stage.Window->Render();
    stage.Window->Render();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(GetReported(frame).rfind("\"unreliable: ", 0) == 0);
  Force(-1);
  stage.Window->Render();
  RELIEVO_CHECK(GetReported(frame).substr(1, 5) == words.substr(0, 5));
  vtkRelievoPass::Detach(stage.Renderer);
}

// A vertex shader of the user's whose outputs cannot be handed on: everything but the cells.
void TestUnknownOutputs()
{
  using namespace vtkRelievoPrimitiveIds;
  const Stage stage(200, 140);
  const auto ball = Fill(stage.Renderer);
  ball->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\nout float one, two;\n", false);
  ball->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n one = 1.0; two = 2.0;\n", false);
  const Layers written(stage.Renderer, Ids);
  Force(ThroughGeometryShader);
  ExpectMessage expect("No cell ids of geometry drawn by ");
  const Layers through(stage.Renderer, Ids);
  RELIEVO_CHECK(expect.Count() == 1);
  Force(-1);
  RELIEVO_CHECK(written.CountId("actor", 0) > 1000);
  long long cells = 0;
  for (int y = 0; y < through.Height; ++y)
  {
    for (int x = 0; x < through.Width; ++x)
    {
      cells += through.Id("actor", x, y) == 0 && through.Id("cell", x, y) != -1;
    }
  }
  RELIEVO_CHECK_AT_MOST(cells, 0, "cells of what has none");
  RELIEVO_CHECK(through.CountId("actor", 0) > 1000);
}

// The picture beside a probe is the one without.
void TestQuiet()
{
  const Stage stage(200, 140);
  Fill(stage.Renderer);
  const auto before = Picture(stage.Window);
  const relievoTest::GLCheck gl(stage.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->RequestLayer("cell"); // the first of this window
  relievoTest::SamePicture(before, Picture(stage.Window), "with the probe");
  vtkRelievoPass::Detach(stage.Renderer);
  relievoTest::SamePicture(before, Picture(stage.Window), "after the probe");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testPrimitiveIds)
{
  relievoTest::Session session;
  TestJudgement();
  TestGeometryShader();
  TestRoutes();
  TestReport();
  TestUnknownOutputs();
  TestQuiet();
  return session.Result();
}
}
