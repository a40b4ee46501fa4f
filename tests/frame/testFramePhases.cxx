// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The phases of a frame come in the order of CONTRIBUTING's diagram, as stages and props see them.
#include "Check.h"
#include "ColorStage.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <fstream>
#include <string>
#include <vector>

namespace testFramePhases
{
namespace
{
std::vector<std::string> Trace;
const vtkRelievoResourceName Traced = vtkRelievoResourceName::Of("trace");

void Note(const std::string& phase)
{
  if (Trace.empty() || Trace.back() != phase)
  {
    Trace.push_back(phase);
  }
}

// One stage for each slot with its own phase; the second reads the output of the first.
class TracingStage : public vtkRelievoStage
{
public:
  static TracingStage* New() { VTK_STANDARD_NEW_BODY(TracingStage); }
  vtkTypeMacro(TracingStage, vtkRelievoStage);

  int Slot = vtkRelievoStageDescription::COMPOSITE;
  std::string Phase;

protected:
  void Describe(vtkRelievoStageDescription& description) override
  {
    description.Name = "trace_" + std::to_string(this->Slot);
    description.Help = "Notes the phases.";
    description.Slot = this->Slot;
    switch (this->Slot)
    {
      case vtkRelievoStageDescription::LIGHT_MAPS:
        description.Writes = { Traced };
        break;
      case vtkRelievoStageDescription::COMPOSITE:
        description.Reads = { Traced };
        description.Writes = { vtkRelievoResources::Color };
        break;
      default:
        description.Writes = { vtkRelievoResources::Picture };
        break;
    }
  }
  void Synchronize(vtkRelievoFrameContext&) override { Note("synchronize"); }
  void Declare(const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const override
  {
    Note("declare");
    declaration.HidesColor = false;
  }
  std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext&, const std::vector<std::string>&) const override
  {
    Note("plan");
    return {};
  }
  bool Prepare(vtkRelievoFrameContext&) override
  {
    Note("prepare");
    return true;
  }
  void Execute(vtkRelievoFrameContext&) override { Note(this->Phase); }
  void BeginOpaque(vtkRelievoFrameContext&) override { Note("delegate"); }
  void EndOpaque(vtkRelievoFrameContext&) override { Note("delegate"); }
  void Finish(vtkRelievoFrameContext&) override { Note("finish"); }
};

class TracingProp : public vtkProp
{
public:
  static TracingProp* New() { VTK_STANDARD_NEW_BODY(TracingProp); }
  vtkTypeMacro(TracingProp, vtkProp);

  int RenderOpaqueGeometry(vtkViewport*) override
  {
    Note("delegate");
    return 0;
  }
  int RenderOverlay(vtkViewport*) override
  {
    Note("overlay");
    return 0;
  }
};

// The first words of the diagram's lines.
std::vector<std::string> ReadDiagram(const char* path)
{
  std::ifstream file(path);
  std::vector<std::string> phases;
  std::string line;
  bool inside = false;
  while (std::getline(file, line))
  {
    if (line == "vtkRelievoFramePass::Render")
    {
      inside = true;
    }
    else if (inside && line.rfind("  ", 0) == 0)
    {
      const std::size_t end = line.find("  ", 2);
      if (line[2] != ' ')
      {
        phases.push_back(line.substr(2, end == std::string::npos ? end : end - 2));
      }
    }
    else if (inside)
    {
      break;
    }
  }
  return phases;
}

std::string Join(const std::vector<std::string>& words)
{
  std::string all;
  for (const std::string& word : words)
  {
    all += (all.empty() ? "" : ", ") + word;
  }
  return all;
}

void TestOrder(const std::vector<std::string>& diagram)
{
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<TracingProp> prop;
  renderer->AddViewProp(prop);
  const auto window = relievoTest::MakeWindow(60, 40, renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  using Description = vtkRelievoStageDescription;
  const std::pair<int, const char*> stages[] = { { Description::LIGHT_MAPS, "light maps" },
    { Description::COMPOSITE, "stages" }, { Description::DISPLAY, "present" } };
  for (const auto& each : stages)
  {
    vtkNew<TracingStage> stage;
    stage->Slot = each.first;
    stage->Phase = each.second;
    frame->AddStage(stage);
  }
  for (int i = 0; i < 2; ++i) // a second frame is as the first
  {
    Trace.clear();
    window->Render();
    RELIEVO_CHECK_THAT(Trace == diagram, "called: " + Join(Trace) + "; drawn: " + Join(diagram));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFramePhases)
{
  relievoTest::Session session;
  RELIEVO_CHECK(argc == 2);
  const std::vector<std::string> diagram = ReadDiagram(argv[1]);
  RELIEVO_CHECK_THAT(diagram.size() == 10, "phases of the diagram: " + Join(diagram));
  TestOrder(diagram);
  return session.Result();
}
}
