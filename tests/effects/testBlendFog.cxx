// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fog and translucent surfaces, compared with the closed form: fog before, between and behind.
#include "BlendScene.h"
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace testBlendFog
{
namespace
{
using namespace relievoTest;

// The transmittance from the nearest pane to the eye, in parallel projection: e to the optical
// depth of the part of the sphere in front of it.
double GetPass(
  const glm::dvec3& center, double radius, double density, double x, double y, double z)
{
  const double square =
    radius * radius - (x - center.x) * (x - center.x) - (y - center.y) * (y - center.y);
  const double half = std::sqrt(std::max(0.0, square));
  const double length = std::max(0.0, center.z + half - std::max(center.z - half, z));
  return std::exp(-density * length);
}

// Panes are covered by the fog in front of them, and the background by all of it.
void TestFog()
{
  for (const bool peeling : { false, true })
  {
    for (const double z : { 0.0, 0.75, 1.5 })
    {
      const std::string what = "fog at " + std::to_string(z) + (peeling ? ", peeling" : "");
      BlendScene scene(0);
      const GLCheck gl(scene.Window);
      scene.Window->SetAlphaBitPlanes(1);
      scene.Renderer->SetUseDepthPeeling(peeling);
      scene.Lamps->EnabledOff();
      vtkNew<vtkPoints> points;
      points->InsertNextPoint(0.0, 0.0, z);
      vtkNew<vtkPolyData> places;
      places->SetPoints(points);
      vtkNew<vtkRelievoFogSpheres> fog;
      fog->SetInputData(places);
      fog->SetRadius(0.6);
      fog->SetDensity(2.0);
      scene.Frame->GetFogStage()->AddPoints(fog);
      scene.ShowPanes(false);
      const Layers behind = scene.Read({ "color", "fog" });
      scene.ShowPanes(true);
      const Layers seen = scene.Read({ "color", "fog" });
      RELIEVO_CHECK(CountDifferent(seen, behind, "fog") == 0);
      double worst = 0.0;
      int fogged = 0;
      for (int y = 0; y < seen.Height; ++y)
      {
        for (int x = 0; x < seen.Width; ++x)
        {
          glm::dvec4 blend = scene.GetBlend(x, y, peeling ? Blending::Sorted : Blending::Averaged);
          const double pass = GetPass({ 0.0, 0.0, z }, 0.6, 2.0, 0.1 * (x + 0.5 - 30.0),
            0.1 * (y + 0.5 - 20.0), scene.GetNearest(x, y));
          blend = glm::dvec4(
            pass * glm::dvec3(blend) + (1.0 - pass) * blend.a * glm::dvec3(1.0), blend.a);
          worst = std::max(worst,
            GetError(GetColor(seen, "color", x, y), Over(blend, GetColor(behind, "color", x, y))));
          fogged += blend.a > 0.0 && behind.Value("fog", x, y) < 0.7;
        }
      }
      RELIEVO_CHECK_AT_MOST(worst, peeling ? Bytes : Halves, what + ": linear colour");
      RELIEVO_CHECK(fogged > 50);
      const vtkIdType bytes = scene.Frame->GetFogStage()->GetBytesHeld();
      scene.ShowPanes(false);
      scene.Window->Render();
      RELIEVO_CHECK(scene.Frame->GetFogStage()->GetBytesHeld() == bytes - 4 * 60 * 40);
    }
  }
}
}

RELIEVO_TEST_CASE(testBlendFog)
{
  Session session;
  TestFog();
  return session.Result();
}
}
