// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of a volume of which each process holds a brick, on surfaces that others hold: they equal
// those of one process with the whole volume, after changes in one process alone.
#include "Check.h"
#include "RankScene.h"
#include "Ranks.h"
#include "Session.h"
#include "TestCase.h"
#include "VolumeScene.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testVolumeRanks
{
namespace
{
using relievoTest::Pixels;
using relievoTest::Values;
using volumeScene::Volume;

constexpr int Side = 33; // points of the whole image along each axis

double GetValue(int x, int y, int z)
{
  return 0.5 + 0.4 * std::sin(0.4 * x) * std::sin(0.5 * y + 1.0) * std::sin(0.3 * z);
}

// A process's brick along x; neighbours share a layer of points. The third of four has none.
struct Part : relievoTest::RankScene
{
  explicit Part(vtkMultiProcessController* controller)
    : RankScene(controller)
    , Cloud(2, volumeScene::Constant(0.5))
  {
    const int bricks = this->Ranks > 2 ? this->Ranks - 1 : this->Ranks;
    const int brick = this->Ranks > 2 && this->Rank == 3 ? 2 : this->Rank;
    const int pieces = Side - 1;
    const int first = pieces * brick / bricks;
    const int last = pieces * (brick + 1) / bricks;
    this->Cloud.Image->SetExtent(first, last, 0, pieces, 0, pieces);
    this->Cloud.Image->SetSpacing(2.0 / pieces, 2.0 / pieces, 2.0 / pieces);
    this->Cloud.Image->AllocateScalars(VTK_FLOAT, 1);
    auto* value = static_cast<float*>(this->Cloud.Image->GetScalarPointer());
    for (int z = 0; z <= pieces; ++z)
    {
      for (int y = 0; y <= pieces; ++y)
      {
        for (int x = first; x <= last; ++x)
        {
          *value++ = static_cast<float>(GetValue(x, y, z));
        }
      }
    }
    // Functions of one value range, as ParaView has them, whatever the brick's own range is.
    this->Cloud.Opacity->RemoveAllPoints();
    this->Cloud.Opacity->AddPoint(0.0, 0.0);
    this->Cloud.Opacity->AddPoint(1.0, 0.6);
    this->Cloud.Prop->SetPosition(-7.5, 9.0, -5.6); // towards the sun, out of view
    this->Shadows->SetMethodToMap();
    if (this->Ranks < 3 || this->Rank != 2)
    {
      this->Stage.Renderer->AddVolume(this->Cloud.Prop);
    }
  }

  Volume Cloud;
};

struct Step
{
  std::string Name;
  std::function<void(Part&)> Do;
  bool Colors = true;   // the volume is out of view
  double Unlike = 2e-4; // share of pixels
};

const std::vector<Step> Steps = {
  { "first", [](Part&) {} },
  { "still", [](Part&) {} },
  { "less opacity on the first", // in one process of the whole volume
    [](Part& part) {
      if (part.Rank == 0 && part.Ranks > 1)
      {
        part.Cloud.Prop->GetProperty()->SetScalarOpacityUnitDistance(3.0);
      }
      part.Stage.Window->Render();
      part.Cloud.Prop->GetProperty()->SetScalarOpacityUnitDistance(1.5);
    } },
  { "coloured",
    [](Part& part) {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
      part.Cloud.Prop->GetProperty()->SetColor(color);
      part.Shadows->ColoredShadowsOn();
    } },
  { "terms of a series",
    [](Part& part) {
      part.Shadows->ColoredShadowsOff();
      part.Shadows->SetVolumeHarmonics(7);
    } },
  { "released on the last",
    [](Part& part) {
      part.Shadows->SetVolumeHarmonics(0);
      if (part.Rank == part.Ranks - 1)
      {
        part.Shadows->ReleaseGraphicsResources(part.Stage.Window);
      }
    } },
  { "rays", [](Part& part) { part.Shadows->SetMethodToExact(); } },
  { "below the lamp",
    [](Part& part) {
      part.Shadows->SetMethodToMap();
      part.Cloud.Prop->SetPosition(0.3, 1.9, 0.3);
      part.Cloud.Prop->SetScale(0.4);
    },
    false },
  { "around the lamp", [](Part& part) { part.Cloud.Prop->SetPosition(1.0, 2.5, 1.1); }, false },
  // Maps of surfaces have another size, too.
  { "for a tolerance", [](Part& part) { part.Shadows->SetTolerance(0.02); }, false, 2e-3 },
};

std::vector<float> DrawAll(vtkMultiProcessController* controller)
{
  std::vector<float> numbers;
  Part part(controller);
  for (const Step& step : Steps)
  {
    step.Do(part);
    const long long before = relievoTest::GetBytesSent();
    part.Record(numbers);
    if (step.Name == "still")
    {
      RELIEVO_CHECK_AT_MOST(
        relievoTest::GetBytesSent() - before, 20000, "bytes of frames in which nothing moves");
    }
    RELIEVO_CHECK_THAT(part.Shadows->GetReason().find("depths of volumes in") != std::string::npos,
      step.Name + ": " + part.Shadows->GetReason());
  }
  // Rays of a certificate do not reach the values of other processes' bricks.
  part.Shadows->SetTolerance(0.0);
  part.Shadows->SetMethodToExact();
  part.Stage.Window->Render();
  vtkRelievoShadowCertificate* proof = part.Shadows->Certify(400);
  if (RELIEVO_CHECK(proof))
  {
    const bool ground = part.Rank == part.Ranks - 1;
    RELIEVO_CHECK_AT_MOST(proof->GetWrong(), 4, "wrong verdicts");
    RELIEVO_CHECK(!ground || (proof->GetUnknown() > 20) == (part.Ranks > 1));
  }
  return numbers;
}
}

RELIEVO_TEST_CASE_APART(testVolumeRanks)
{
  relievoTest::Session session;
  const auto compare = [](int ranks, const float* one, const float* several) {
    for (const Step& step : Steps)
    {
      double worst = 0.0;
      int unlike = 0;
      int shaded = 0;
      for (int pixel = 0; pixel < Pixels; ++pixel, one += Values, several += Values)
      {
        double off = 0.0;
        for (int i = 1; i < (step.Colors ? Values : 3); ++i)
        {
          const bool none = std::isnan(one[i]) && std::isnan(several[i]);
          off = std::max(off, none ? 0.0 : std::abs(one[i] - several[i]) / (i < 3 ? 1.0 : 255.0));
        }
        unlike += off <= 0.01 ? 0 : 1;
        worst = relievoTest::Larger(worst, off);
        // Neither lit nor in the shade of a surface.
        for (const int i : { 1, 2 })
        {
          shaded += one[i] > 0.05f && one[i] < 0.95f ? 1 : 0;
        }
      }
      const std::string what = step.Name + ", " + std::to_string(ranks) + " processes";
      RELIEVO_CHECK_AT_MOST(unlike, step.Unlike * Pixels,
        what + ": pixels that differ, by up to " + std::to_string(worst));
      RELIEVO_CHECK_THAT(
        shaded > Pixels / 20, what + ": " + std::to_string(shaded) + " pixels in the shade");
    }
  };
  relievoTest::CompareRanks(DrawAll, Values, Steps.size() * Pixels * Values, compare);
  return session.Result();
}
}
