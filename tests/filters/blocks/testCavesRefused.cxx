// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Caves that are refused, empty or aborted: a message, and an output without points or arrays.
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoCaveFunction.h"
#include "vtkRelievoCaves.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTransform.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace testCavesRefused
{
namespace
{
using relievoTest::ExpectMessage;
using Caves = vtkRelievoCaves;

void TestRefusals()
{
  const auto refuses = [](const std::string& words, const std::function<void(Caves*)>& setUp) {
    vtkNew<Caves> caves;
    setUp(caves);
    relievoTest::CheckRefused(caves.Get(), words);
  };
  refuses("Size is 0 5 5", [](Caves* caves) { caves->SetSize(0, 5, 5); });
  refuses("expected at most 32, half of Scale", [](Caves* caves) { caves->SetTunnelWidth(33.); });
  refuses("expected at most 5e+08", [](Caves* caves) { caves->SetOrigin(0., 1e12, 0.); });
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      refuses("not finite", [&](Caves* caves) {
        double origin[3] = { 0., 0., 0. };
        origin[axis] = bad;
        caves->SetOrigin(origin);
      });
      refuses("not finite", [&](Caves* caves) {
        double spacing[3] = { 1., 1., 1. };
        spacing[axis] = bad;
        caves->SetSpacing(spacing);
      });
    }
  }
  refuses("not finite", [](Caves* caves) {
    caves->SetSize(5, 1, 5);
    caves->SetSpacing(1., std::nan(""), 1.);
  });
  refuses("The function has a Transform", [](Caves* caves) {
    vtkNew<vtkTransform> transform;
    transform->Translate(1., 2., 3.);
    caves->GetFunction()->SetTransform(transform);
  });
  refuses("it would take 1000000000 bytes (953.7 MiB), and MemoryLimit is 1000000 bytes",
    [](Caves* caves) {
      caves->SetSize(1000, 1000, 1000);
      caves->SetMemoryLimit(1e6);
    });
  refuses("the machine has", [](Caves* caves) { caves->SetSize(2000000, 2000000, 2000000); });
  // Values that make no sense are refused where they are set.
  vtkNew<Caves> caves;
  const auto stays = [&](const std::string& words, const std::function<void()>& set) {
    const vtkMTimeType before = caves->GetMTime();
    ExpectMessage expect(words);
    set();
    RELIEVO_CHECK_THAT(expect.Count() == 1 && caves->GetMTime() == before, words);
  };
  stays("Shell is nan 0.1", [&]() { caves->SetShell(std::nan(""), 0.1); });
  stays("the lower first", [&]() { caves->SetShell(0.2, 0.1); });
  stays("Scale is 0", [&]() { caves->SetScale(0.); });
  stays("VerticalScale is nan", [&]() { caves->SetVerticalScale(std::nan("")); });
  stays("TunnelWidth is -1", [&]() { caves->SetTunnelWidth(-1.); });
}

// Nothing of an earlier update is left where the next has nothing.
void TestNothing()
{
  for (const bool refused : { true, false })
  {
    vtkNew<Caves> caves;
    caves->SetSize(5, 4, 3);
    caves->Update();
    RELIEVO_CHECK(caves->GetOutput()->GetPointData()->GetNumberOfArrays() == 1);
    if (refused)
    {
      caves->SetTunnelWidth(1000.);
      ExpectMessage expect("expected at most 32");
      caves->Update();
      RELIEVO_CHECK(expect.Count() == 1);
    }
    else
    {
      caves->UpdatePiece(999, 1000, 0);
    }
    const std::string name = refused ? "refused" : "an empty piece";
    vtkImageData* image = caves->GetOutput();
    RELIEVO_CHECK_THAT(image->GetNumberOfPoints() == 0, name);
    RELIEVO_CHECK_THAT(image->GetPointData()->GetNumberOfArrays() == 0, name + " has arrays");
  }
}

void TestAbort()
{
  vtkNew<Caves> caves;
  caves->SetSize(120, 120, 120);
  const unsigned long tag =
    caves->AddObserver(vtkCommand::ProgressEvent, caves.Get(), &Caves::AbortExecuteOn);
  caves->Update();
  RELIEVO_CHECK(caves->GetOutput()->GetNumberOfPoints() == 0);
  caves->RemoveObserver(tag);
  caves->AbortExecuteOff();
  caves->Update();
  RELIEVO_CHECK(caves->GetOutput()->GetNumberOfPoints() == 1728000);
  RELIEVO_CHECK(caves->GetProgress() == 1.);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testCavesRefused)
{
  relievoTest::Session session;
  TestRefusals();
  TestNothing();
  TestAbort();
  return session.Result();
}
}
