// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of several processes that each hold a part of the scene: their merged pictures and
// layers equal those of one process, after motion, removal and lack of memory.
#include "Check.h"
#include "RankScene.h"
#include "Ranks.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoTextureBuffer.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace testShadowRanks
{
namespace
{
using relievoTest::Pixels;
using relievoTest::Values;
using Part = relievoTest::RankScene;

// How a step's picture equals that of one process.
enum Likeness
{
  Same,    // in every bit
  Rounded, // if a mesh is shared, or transmittances of several surfaces are multiplied
  Mapped   // maps are merged, not their every bit
};

struct Step
{
  std::string Name;
  Likeness Like;
  std::function<void(Part&)> Do;
  bool Exact = true; // by rays, in all processes
  int Message = 0;   // that the first process says: 1 always, 2 if there are others
};

bool IsLast(const Part& part)
{
  return part.Rank == part.Ranks - 1;
}

const std::vector<Step> Steps = {
  { "first", Same, [](Part&) {} },
  { "still", Same, [](Part&) {} },
  { "an actor turned", Same, [](Part& part) { part.Tall->RotateY(25.); } },
  { "points moved", Same,
    [](Part& part) {
      vtkPoints* points = Part::GetMesh(part.Low)->GetPoints();
      for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
      {
        const double* p = points->GetPoint(i);
        points->SetPoint(i, p[0] + 0.3, p[1] + 0.2 * p[0], p[2]);
      }
      if (points)
      {
        points->Modified();
        Part::GetMesh(part.Low)->Modified();
      }
    } },
  { "points moved within their bounds", Same,
    [](Part& part) {
      vtkPoints* points = Part::GetMesh(part.Low)->GetPoints();
      for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
      {
        const double* p = points->GetPoint(i);
        points->SetPoint(i, p[0], p[1], p[0] > -1. && p[2] > 1. ? 0.6 : p[2]);
      }
      if (points)
      {
        points->Modified();
        Part::GetMesh(part.Low)->Modified();
      }
    } },
  { "hidden", Same, [](Part& part) { part.Tall->VisibilityOff(); } },
  { "shown", Same, [](Part& part) { part.Tall->VisibilityOn(); } },
  { "glyphs", Same, [](Part& part) { part.Glyphs->VisibilityOn(); } },
  { "camera", Same,
    [](Part& part) { part.Stage.Renderer->GetActiveCamera()->SetPosition(1.5, 3.2, 6.2); } },
  { "far camera", Same,
    [](Part& part) {
      part.Stage.Renderer->GetActiveCamera()->SetPosition(4., 6., 9.);
      part.Stage.Renderer->GetActiveCamera()->SetClippingRange(4., 20.);
    } },
  { "a shared ball", Rounded, [](Part& part) { part.Ball->VisibilityOn(); } },
  { "panes", Rounded,
    [](Part& part) {
      part.Ball->VisibilityOff();
      part.Stage.Renderer->GetActiveCamera()->SetPosition(2.5, 3., 6.);
      part.Stage.Renderer->GetActiveCamera()->SetClippingRange(2., 14.);
      for (const auto& pane : part.Panes)
      {
        pane->VisibilityOn();
      }
    } },
  { "colours", Rounded, [](Part& part) { part.Shadows->ColoredShadowsOn(); } },
  { "no colours", Rounded, [](Part& part) { part.Shadows->ColoredShadowsOff(); } },
  { "no panes", Same,
    [](Part& part) {
      for (const auto& pane : part.Panes)
      {
        pane->VisibilityOff();
      }
    } },
  { "wires", Mapped, [](Part& part) { part.Tall->GetProperty()->SetRepresentationToWireframe(); } },
  { "no wires", Same, [](Part& part) { part.Tall->GetProperty()->SetRepresentationToSurface(); } },
  { "released", Same,
    [](Part& part) {
      if (part.Rank == 0)
      {
        part.Shadows->ReleaseGraphicsResources(part.Stage.Window);
      }
    } },
  { "no room on the last", Mapped,
    [](Part& part) {
      if (IsLast(part))
      {
        vtkRelievoTextureBuffer::SetMostTexels(64);
      }
      part.Tall->RotateY(10.);
    },
    false, 1 },
  { "still none", Mapped, [](Part&) {}, false },
  { "room, and something has changed on the first", Same,
    [](Part& part) {
      vtkRelievoTextureBuffer::SetMostTexels(0);
      if (part.Rank == 0)
      {
        part.Tall->RotateY(10.);
      }
    } },
  { "another method on the last", Mapped,
    [](Part& part) {
      if (IsLast(part))
      {
        part.Shadows->SetMethodToMap();
      }
    },
    false, 2 },
  { "the same method again", Same, [](Part& part) { part.Shadows->SetMethodToExact(); } },
};

std::vector<float> DrawAll(vtkMultiProcessController* controller)
{
  std::vector<float> numbers;
  Part part(controller);
  for (const Step& step : Steps)
  {
    step.Do(part);
    const bool says =
      part.Rank == 0 && (step.Message == 1 || (step.Message == 2 && part.Ranks > 1));
    std::unique_ptr<relievoTest::ExpectMessage> expected(
      says ? new relievoTest::ExpectMessage("Shadows are made with maps") : nullptr);
    const long long before = relievoTest::GetBytesSent();
    part.Record(numbers);
    const long long sent = relievoTest::GetBytesSent() - before;
    RELIEVO_CHECK_THAT(!says || expected->Count() == 1, step.Name + ": one message");
    const int method = part.Shadows->GetMethodUsed();
    RELIEVO_CHECK_THAT((method == vtkRelievoShadowStage::METHOD_EXACT) == step.Exact,
      step.Name + ": method " + std::to_string(method));
    if (step.Name == "still")
    {
      std::cout << "bytes sent for two frames in which nothing moves: " << sent << "\n";
      RELIEVO_CHECK_AT_MOST(sent, part.Ranks > 1 ? 20000 : 0, "bytes of still frames");
    }
  }
  const std::size_t drawn = numbers.size();
  vtkRelievoShadowCertificate* proof = part.Shadows->Certify(400);
  if (RELIEVO_CHECK(proof))
  {
    std::cout << "judged by process " << part.Rank << ": " << proof->GetJudged() << ", wrong "
              << proof->GetWrong() << "\n";
    RELIEVO_CHECK(proof->GetWrong() == 0);
    RELIEVO_CHECK(proof->GetJudged() > 0 || (part.Ranks == 4 && part.Rank == 2));
  }
  // Casters of other processes are casters with maps as well. Maps are wrong at outlines.
  part.Shadows->SetMethodToMap();
  part.Record(numbers);
  numbers.resize(drawn);
  proof = part.Shadows->Certify(400);
  if (RELIEVO_CHECK(proof))
  {
    std::cout << "maps judged by process " << part.Rank << ": " << proof->GetWords() << "\n";
    RELIEVO_CHECK(proof->GetWrong() <= proof->GetJudged() / 50);
  }
  part.Shadows->SetMethodToExact();
  // All draw together again, though only one has a volume.
  if (IsLast(part))
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    image->AllocateScalars(VTK_FLOAT, 1);
    image->GetPointData()->GetScalars()->FillComponent(0, 1.0);
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(image);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    part.Stage.Renderer->AddVolume(volume);
  }
  RELIEVO_CHECK(part.Shadows->Certify(50));
  return numbers;
}

std::string Describe(const float* pixel)
{
  std::string words;
  for (int i = 0; i < Values; ++i)
  {
    words += (i ? " " : "(") + std::to_string(pixel[i]);
  }
  return words + ")";
}

// Whether two pixels differ, but for rounding: of a verdict's 256 levels, and the picture's.
bool AreUnlike(const float* a, const float* b, Likeness like)
{
  const float level = like == Same ? 0.f : 1.01f / 255.f;
  bool unlike = a[0] != b[0] && !(std::isinf(a[0]) && std::isinf(b[0]));
  for (int i = 1; i < Values; ++i)
  {
    const bool none = std::isnan(a[i]) && std::isnan(b[i]);
    unlike = unlike || (!none && !(std::abs(a[i] - b[i]) <= (i < 3 ? level : 255.f * level)));
  }
  return unlike;
}
}

RELIEVO_TEST_CASE_APART(testShadowRanks)
{
  relievoTest::Session session;
  const auto compare = [](int ranks, const float* one, const float* several) {
    for (const auto& step : Steps)
    {
      int unlike = 0;
      std::string first;
      int dark = 0;
      int covered = 0;
      for (int pixel = 0; pixel < Pixels; ++pixel, one += Values, several += Values)
      {
        if (AreUnlike(one, several, step.Like) && unlike++ == 0)
        {
          first = Describe(one) + " and " + Describe(several);
        }
        covered += std::isfinite(one[0]) ? 1 : 0;
        dark += one[1] < 1.f || one[2] < 1.f ? 1 : 0;
      }
      const std::string what = step.Name + ", " + std::to_string(ranks) + " processes";
      RELIEVO_CHECK_AT_MOST(
        unlike, step.Like == Same ? 0 : 2e-4 * Pixels, what + ": pixels that differ " + first);
      RELIEVO_CHECK_THAT(covered > Pixels / 4 && dark > covered / 20,
        what + ": " + std::to_string(covered) + " pixels, " + std::to_string(dark) + " dark");
    }
  };
  relievoTest::CompareRanks(DrawAll, Values, Steps.size() * Pixels * Values, compare);
  return session.Result();
}
}
