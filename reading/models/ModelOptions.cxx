// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelOptions.h"

#include "Errors.h"
#include "Values.h"

#include <cmath>

namespace reading
{
namespace
{
void CheckOneTime(const ModelChoice& model)
{
  if (model.Time)
  {
    throw UsageError("--time and --times: give one of them");
  }
}
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetModelOptions()
{
  static const std::vector<std::string> names = { "--time", "--times", "--animation", "--blend",
    "--loop", "--skin", "--skeleton", "--bone-weight" };
  return names;
}

//------------------------------------------------------------------------------
void TakeTime(ModelChoice& model, const std::string& word)
{
  CheckOneTime(model);
  model.Time = ParseNumbers("--time", word, 1, "seconds").front();
  model.Given = true;
}

//------------------------------------------------------------------------------
void TakeAnimation(ModelChoice& model, const std::string& word)
{
  model.Animation = word;
  model.Given = true;
}

//------------------------------------------------------------------------------
void TakeTimes(ModelChoice& model, const std::string& word)
{
  CheckOneTime(model);
  constexpr double most = 1e6; // frames
  const std::vector<std::string> parts = Split(word, ':');
  const std::string form = "START:END:STEP in seconds, such as 0:2:0.1";
  if (parts.size() != 3)
  {
    RefuseValue("--times", word, form);
  }
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    numbers[i] = ParseNumbers("--times " + word, parts[i], 1, form).front();
  }
  const auto [start, end, step] = numbers;
  // Includes the end despite rounding of the steps.
  const double frames = step > 0.0 ? std::floor((end - start) / step * (1.0 + 1e-12) + 1e-9) : -1.0;
  if (!(frames >= 0.0) || frames >= most)
  {
    RefuseValue("--times", word,
      "START:END:STEP with START <= END, STEP > 0 and at most " +
        std::to_string(static_cast<int>(most)) + " frames");
  }
  model.Times.clear();
  for (int i = 0; i <= static_cast<int>(frames); ++i)
  {
    model.Times.push_back(start + i * step);
  }
  model.Time = start;
  model.Given = true;
}

//------------------------------------------------------------------------------
void TakeBlend(ModelChoice& model, const std::string& word)
{
  const std::size_t at = word.rfind('=');
  const std::string form = "NAME=WEIGHT with a weight from 0 to 1, such as run=0.3";
  if (at == std::string::npos || at == 0)
  {
    RefuseValue("--blend", word, form);
  }
  model.Blend = word.substr(0, at);
  model.BlendWeight = ParseNumbers("--blend " + word, word.substr(at + 1), 1, form).front();
  if (model.BlendWeight < 0.0 || model.BlendWeight > 1.0)
  {
    RefuseValue("--blend", word, form);
  }
  model.Given = true;
}

//------------------------------------------------------------------------------
void TakeLoop(ModelChoice& model, const std::string&)
{
  model.Loop = model.Given = true;
}

//------------------------------------------------------------------------------
void TakeSkeleton(ModelChoice& model, const std::string&)
{
  model.Skeleton = model.Given = true;
}

//------------------------------------------------------------------------------
void TakeBoneWeight(ModelChoice& model, const std::string& word)
{
  model.BoneWeight = word;
  model.Given = true;
}
}
