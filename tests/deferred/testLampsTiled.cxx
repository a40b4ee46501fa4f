// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps that cast in a picture that is drawn in tiles: the same in each, and the same picture.
#include "Check.h"
#include "LampScenes.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testLampsTiled
{
namespace
{
using namespace relievoTest;

constexpr int Width = 100;
constexpr int Height = 80;
constexpr int Scale = 2;

// Two that are larger in the picture than the others, in its left half; one that only the upper
// right tile sees all of; one cut by the picture's edge, which would be large if it were not.
void AddLamps(LampScene& scene)
{
  const glm::dvec3 white(1.0);
  const std::vector<Lamp> lamps{ { { -1.9, 1.3, 0.9 }, 2.0, 0.8, white },
    { { 0.2, 0.6, 1.4 }, 1.6, 1.2, white }, { { 2.0, 1.2, -1.2 }, 1.5, 0.8, white },
    { { 1.9, 0.5, 1.2 }, 1.3, 0.8, white }, { { -0.4, 2.0, -1.6 }, 1.3, 0.8, white },
    { { 3.6, 0.5, 2.4 }, 1.7, 0.8, white } };
  scene.AddLamps(lamps);
  scene.Stage->SetCasting(2);
}

// Where the lamps are that cast, in words, after each frame that a window draws.
class CastingSeen
{
public:
  explicit CastingSeen(LampScene& scene)
    : Stage(scene.Stage)
  {
    vtkNew<vtkCallbackCommand> seen;
    seen->SetClientData(this);
    seen->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      auto* self = static_cast<CastingSeen*>(data);
      const std::string reason = self->Stage->GetReason();
      const auto at = reason.find(" shadows, at ");
      self->All.push_back(at == std::string::npos ? "none: " + reason : reason.substr(at));
    });
    scene.Window->AddObserver(vtkCommand::EndEvent, seen);
  }

  std::vector<std::string> All;

private:
  vtkRelievoLampsStage* Stage;
};

void CheckTiles(bool parallel, int way)
{
  const std::string what =
    std::string(parallel ? "parallel" : "perspective") + ", way " + std::to_string(way);
  LampScene whole(Scale * Width, Scale * Height);
  LampScene tiled(Width, Height);
  for (LampScene* scene : { &whole, &tiled })
  {
    vtkCamera* camera = scene->Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(2.2);
    scene->Stage->SetWay(way);
    scene->Renderer->AutomaticLightCreationOff(); // lit by lamps alone
    AddLamps(*scene);
  }
  tiled.Window->Render();
  CastingSeen inTiles(tiled);
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(tiled.Window);
  filter->SetScale(Scale);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData* found = filter->GetOutput();
  CastingSeen inWhole(whole);
  vtkSmartPointer<vtkImageData> expected = Picture(whole.Window);

  RELIEVO_CHECK(!inWhole.All.empty());
  RELIEVO_CHECK(inTiles.All.size() >= Scale * Scale);
  std::cout << what << ": whole" << inWhole.All.back() << "\n";
  for (const std::string& each : inTiles.All)
  {
    std::cout << "  a tile" << each << "\n";
    RELIEVO_CHECK(each == inWhole.All.back());
  }
  int other = 0;
  for (int y = 0; y < Scale * Height; ++y)
  {
    for (int x = 0; x < Scale * Width; ++x)
    {
      double difference = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        difference = std::max(difference,
          std::abs(expected->GetScalarComponentAsDouble(x, y, 0, c) -
            found->GetScalarComponentAsDouble(x, y, 0, c)));
      }
      other += difference > 2.0 ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(static_cast<double>(other) / (Scale * Scale * Width * Height), 0.002,
    what + ", share of pixels that differ by more than 2 levels");
}
}

RELIEVO_TEST_CASE(testLampsTiled)
{
  relievoTest::Session session;
  CheckTiles(true, vtkRelievoLampsStage::QUADS);
  CheckTiles(false, vtkRelievoLampsStage::QUADS);
  CheckTiles(false, vtkRelievoLampsStage::CLUSTERS);
  return session.Result();
}
}
