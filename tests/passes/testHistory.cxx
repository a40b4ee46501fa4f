// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture is a function of the scene, the camera, the lights and the settings: a random walk
// through them, with frames, screenshots, captures and selections on the way. After every tenth
// step picture, layers and bytes are those of a new renderer in a new window, bit for bit.
//
//     testHistory [STEPS [SEED]]
#include "Check.h"
#include "GLCheck.h"
#include "HistoryScene.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cstdlib>
#include <cstring>
#include <deque>
#include <iostream>

namespace testHistory
{
namespace
{
using relievoTest::HistoryScene;
using relievoTest::HistoryState;

long long CountUnlike(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues() ||
    a->GetDataType() != b->GetDataType())
  {
    return -1;
  }
  const auto size = static_cast<std::size_t>(a->GetDataTypeSize()) * a->GetNumberOfComponents();
  const auto* bytesA = static_cast<const char*>(a->GetVoidPointer(0));
  const auto* bytesB = static_cast<const char*>(b->GetVoidPointer(0));
  long long count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a->GetNumberOfTuples()); ++i)
  {
    count += std::memcmp(bytesA + i * size, bytesB + i * size, size) != 0;
  }
  return count;
}

void Compare(HistoryScene& warm, const HistoryState& state, const std::string& what)
{
  const auto picture = warm.Draw(state);
  HistoryScene cold;
  cold.Take(state);
  const auto fresh = cold.Draw(state);
  const long long unlike =
    CountUnlike(picture->GetPointData()->GetScalars(), fresh->GetPointData()->GetScalars());
  RELIEVO_CHECK_THAT(unlike == 0, what + ": " + std::to_string(unlike) + " pixels differ");
  if (unlike != 0)
  {
    HistoryState plain = state;
    plain.Attached = false;
    warm.Take(plain);
    cold.Take(plain);
    std::cout << "without Relievo: "
              << CountUnlike(warm.Draw(plain)->GetPointData()->GetScalars(),
                   cold.Draw(plain)->GetPointData()->GetScalars())
              << " pixels differ\n";
    warm.Take(state);
    cold.Take(state);
  }
  for (const std::string& name : state.Layers)
  {
    const long long count = CountUnlike(picture->GetFieldData()->GetArray(name.c_str()),
      fresh->GetFieldData()->GetArray(name.c_str()));
    RELIEVO_CHECK_THAT(!state.Attached || count == 0,
      what + ": " + std::to_string(count) + " pixels of the layer " + name + " differ");
  }
  // Data for refining depth are made once depth has been read.
  warm.Draw(state);
  cold.Draw(state);
  RELIEVO_CHECK_THAT(warm.GetBytesHeld() == cold.GetBytesHeld(),
    what + ": " + std::to_string(warm.GetBytesHeld()) + " bytes are held, " +
      std::to_string(cold.GetBytesHeld()) + " by a new renderer");
}

void Walk(int steps, unsigned int seed)
{
  std::mt19937 random(seed);
  HistoryState state;
  HistoryScene scene;
  const relievoTest::GLCheck gl(scene.Window);
  std::deque<std::string> last;
  for (int i = 1; i <= steps; ++i)
  {
    last.push_back(state.Step(random));
    scene.Take(state);
    if (random() % 3u)
    {
      last.back() += " + " + scene.Disturb(random);
      scene.Take(state);
    }
    if (i % 10 == 0)
    {
      std::string what = "seed " + std::to_string(seed) + ", step " + std::to_string(i) + " (";
      for (const std::string& step : last)
      {
        what += (&step == &last.front() ? "" : ", ") + step;
      }
      Compare(scene, state, what + ")");
      last.clear();
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testHistory)
{
  relievoTest::Session session;
  const int steps = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto seed = static_cast<unsigned int>(argc > 2 ? std::atoi(argv[2]) : 1);
  Walk(steps, seed);
  std::cout << steps << " steps from seed " << seed << "\n";
  return session.Result();
}
}
