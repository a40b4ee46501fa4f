// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRecordChanges.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace relievo::compare
{
//------------------------------------------------------------------------------
RecordChanges::RecordChanges(const Frame& before, const Frame& after, CauseList& list)
{
  if (!before.HasRecord || !after.HasRecord)
  {
    return;
  }
  if (before.Overlays != after.Overlays)
  {
    std::set<std::string> kinds;
    for (const auto& [own, others] : { std::pair(&before.Overlays, &after.Overlays),
           std::pair(&after.Overlays, &before.Overlays) })
    {
      for (const nlohmann::json& overlay : *own)
      {
        const auto found = overlay.find("kind"); // of any type in files
        const std::string kind = found != overlay.end() && found->is_string()
          ? found->get<std::string>()
          : std::string("overlay");
        if (std::find(others->begin(), others->end(), overlay) == others->end())
        {
          kinds.insert(kind);
        }
      }
    }
    const std::string names = Join({ kinds.begin(), kinds.end() });
    this->Overlay = list.Find(Cause::Overlay, "picture");
    list.At(this->Overlay).Words = "overlay: " + (names.empty() ? "order" : names);
  }
  const std::string tone = "tone:";
  std::map<std::string, std::string> all = before.Settings;
  all.insert(after.Settings.begin(), after.Settings.end());
  for (const auto& [name, value] : all)
  {
    if (name == Frame::SamplesSetting)
    {
      continue; // innocent
    }
    const auto valueIn = [&name = name](const std::map<std::string, std::string>& settings) {
      const auto found = settings.find(name);
      return found == settings.end() ? std::string("not set") : found->second;
    };
    const std::string from = valueIn(before.Settings);
    const std::string to = valueIn(after.Settings);
    if (from != to)
    {
      const bool isTone = name.compare(0, tone.size(), tone) == 0;
      const int place = list.Find(isTone ? Cause::Tone : Cause::Settings, "setting", name);
      list.At(place).Words = (isTone ? "tone: " : "settings: ") + from + ", now " + to;
      int& first = isTone ? this->Tone : this->Settings;
      first = first < 0 ? place : first;
    }
  }
}
}
