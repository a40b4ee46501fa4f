// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLightPairs.h"

#include <algorithm>
#include <string>

namespace relievo::compare
{
//------------------------------------------------------------------------------
LightPairs::LightPairs(const Frame& before, const Frame& after, CauseList& list)
  : A(before)
  , B(after)
  , List(list)
{
  if (!this->A.HasLights || !this->B.HasLights)
  {
    return;
  }
  const auto countName = [](const Frame& frame, const std::string& name) {
    return std::count_if(frame.Lights.begin(), frame.Lights.end(),
      [&](const Light& light) { return light.Name == name; });
  };
  std::vector<bool> taken(this->B.Lights.size(), false);
  for (std::size_t i = 0; i < this->A.Lights.size(); ++i)
  {
    Pair pair;
    pair.Before = static_cast<int>(i);
    const Light& from = this->A.Lights[i];
    const bool isNamed = !from.Name.empty() && countName(this->A, from.Name) == 1 &&
      countName(this->B, from.Name) == 1;
    for (std::size_t j = 0; j < this->B.Lights.size() && pair.After < 0; ++j)
    {
      const Light& to = this->B.Lights[j];
      if (!taken[j] && (isNamed ? from.Name == to.Name : i == j))
      {
        pair.After = static_cast<int>(j);
        taken[j] = true;
      }
    }
    this->Pairs.push_back(pair);
  }
  for (std::size_t j = 0; j < this->B.Lights.size(); ++j)
  {
    if (!taken[j])
    {
      Pair pair;
      pair.After = static_cast<int>(j);
      this->Pairs.push_back(pair);
    }
  }
  for (Pair& pair : this->Pairs)
  {
    std::string words;
    if (pair.Before < 0 || pair.After < 0)
    {
      words = pair.Before < 0 ? "added" : "removed";
    }
    else
    {
      words = Join(ListChanges(this->A.Lights[static_cast<std::size_t>(pair.Before)].Values,
        this->B.Lights[static_cast<std::size_t>(pair.After)].Values));
      std::replace(words.begin(), words.end(), '_', ' ');
    }
    if (!words.empty())
    {
      pair.Finding = this->Find(pair, Cause::Light);
      this->List.At(pair.Finding).Words = "light: " + words;
      this->List.At(pair.Finding).More["changed"] = words;
    }
  }
}

//------------------------------------------------------------------------------
std::pair<LightPairs::Visibility, LightPairs::Visibility> LightPairs::GetVisibility(
  const Pair& pair) const
{
  if (pair.Before < 0 || pair.After < 0)
  {
    return { nullptr, nullptr };
  }
  const auto from =
    this->A.Shadow.find(this->A.Lights[static_cast<std::size_t>(pair.Before)].Layer);
  const auto to = this->B.Shadow.find(this->B.Lights[static_cast<std::size_t>(pair.After)].Layer);
  const bool isBoth = from != this->A.Shadow.end() && to != this->B.Shadow.end();
  return { isBoth ? &from->second : nullptr, isBoth ? &to->second : nullptr };
}

//------------------------------------------------------------------------------
bool LightPairs::AnyChanged() const
{
  return std::any_of(
    this->Pairs.begin(), this->Pairs.end(), [](const Pair& pair) { return pair.Finding >= 0; });
}

//------------------------------------------------------------------------------
int LightPairs::Find(const Pair& pair, Cause cause)
{
  const bool isOld = pair.Before >= 0;
  const int number = isOld ? pair.Before : pair.After;
  const Light& light = (isOld ? this->A : this->B).Lights[static_cast<std::size_t>(number)];
  return this->List.Find(cause, "light", light.Name, number);
}
}
