// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What lamps make of the picture: its linear colour plus their light times the surface's colour and
// the share that its material gives back.
#include "Check.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkProperty.h>

#include <cmath>
#include <functional>
#include <string>

namespace
{
using namespace relievoTest;

// IEC 61966-2-1.
double LinearFromSrgb(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// The largest error of the linear colour against the picture without lamps and their layer.
void CheckColor(const std::function<void(vtkProperty*)>& set,
  const std::function<double(int)>& share, const std::string& what)
{
  LampScene scene(120, 90);
  const GLCheck gl(scene.Window);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkProperty* property = vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty();
    property->SetColor(0.3 + 0.2 * i, 0.9 - 0.2 * i, 0.5);
    if (i == 2)
    {
      set(property);
    }
  }
  const Layers plain(scene.Read({ "color" }));
  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(ToPolyData(RandomLamps(60, 1.5, false)));
  scene.Stage->AddLamps(lamps);
  const Layers lit(scene.Read({ "color", "light", "albedo", "actor", "depth" }));
  double worst = 0.0;
  double most = 0.0;
  for (int y = 0; y < lit.Height; ++y)
  {
    for (int x = 0; x < lit.Width; ++x)
    {
      const int actor = lit.Id("actor", x, y);
      for (int c = 0; c < 3; ++c)
      {
        const double albedo = LinearFromSrgb(lit.Value("albedo", x, y, c) / 255.0);
        const double added =
          actor < 0 ? 0.0 : (actor == 2 ? share(c) : 1.0) * albedo * lit.Value("light", x, y, c);
        const double expected = plain.Value("color", x, y, c) + added;
        worst =
          std::max(worst, std::abs(lit.Value("color", x, y, c) - expected) / (expected + 0.01));
        most = std::max(most, actor == 2 ? added : 0.0);
      }
      RELIEVO_CHECK(lit.Value("color", x, y, 3) == plain.Value("color", x, y, 3));
    }
  }
  // Two roundings to half floats, which Mesa's software cuts, and a share of 8 bits.
  RELIEVO_CHECK_AT_MOST(worst, 4.0 / 1024.0, what + ": linear colour");
  RELIEVO_CHECK(most > 0.05 || share(0) == 0.0);
}

void TestMaterials()
{
  CheckColor([](vtkProperty*) {}, [](int) { return 1.0; }, "plain surfaces");
  CheckColor([](vtkProperty* property) { property->SetDiffuse(0.6); }, [](int) { return 0.6; },
    "diffuse 0.6");
  CheckColor(
    [](vtkProperty* property) { property->LightingOff(); }, [](int) { return 0.0; }, "no lighting");
  CheckColor(
    [](vtkProperty* property) {
      property->SetInterpolationToPBR();
      property->SetMetallic(0.4);
    },
    [](int) { return 0.6; }, "PBR, metallic 0.4");
}

// Words alone are wanted of the frame where it has no light to add.
void TestCost()
{
  LampScene scene(64, 48);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "not_asked");
  vtkNew<vtkRelievoLamps> lamps;
  scene.Stage->AddLamps(lamps);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  lamps->SetInputData(ToPolyData(RandomLamps(3, 1.0, true)));
  scene.Window->Render();
  const long long pixels = 64 * 48;
  // The linear colour with its depth, three words of the G-buffer in four, and a sum of one float
  // with a depth.
  const long long color = (8 + 4) + 2 * 8;
  const long long lists = 3 * 8 * 4 + 4 * 4 + 3 * 4 * 4;
  RELIEVO_CHECK_NEAR(static_cast<double>(scene.Frame->GetBytesHeld()),
    static_cast<double>(pixels * (color + 16 + 4 + 4) + lists), 0.0, "bytes");
}
}

int main()
{
  relievoTest::Session session;
  TestMaterials();
  TestCost();
  return session.Result();
}
