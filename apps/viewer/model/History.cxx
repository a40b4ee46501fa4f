// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "History.h"

#include <iterator>

namespace viewer
{
namespace
{
constexpr std::int64_t OneEdit = 1000; // milliseconds
constexpr std::size_t Most = 200;

std::optional<scene::Settings> Step(
  std::vector<scene::Settings>& from, std::vector<scene::Settings>& to, const scene::Settings& now)
{
  if (from.empty())
  {
    return std::nullopt;
  }
  to.push_back(now);
  const scene::Settings next = from.back();
  from.pop_back();
  return next;
}

// A stage's first parameter asks for the stage as well.
std::set<std::string> GetChanges(const scene::Settings& before, const scene::Settings& after)
{
  std::set<std::string> changes = before.GetChanges(after);
  for (auto change = changes.begin(); change != changes.end();)
  {
    const auto next = std::next(change); // parameters follow their stage
    const bool asked = change->size() > 1 && change->back() == ':' && next != changes.end() &&
      next->rfind(*change, 0) == 0;
    change = asked ? changes.erase(change) : next;
  }
  return changes;
}
}

//------------------------------------------------------------------------------
void History::Add(
  const scene::Settings& before, const scene::Settings& after, std::int64_t time, int drag)
{
  const std::set<std::string> changed = GetChanges(before, after);
  const bool played = changed == std::set<std::string>{ "--time" }; // as long as it takes
  const bool soon = changed == this->Changed && (played || time - this->Time < OneEdit);
  const bool same = !this->Past.empty() && this->Future.empty() &&
    (drag != 0 && this->Drag != 0 ? drag == this->Drag : soon);
  this->Changed = changed;
  this->Time = time;
  this->Drag = drag;
  this->Future.clear();
  if (!same)
  {
    this->Past.push_back(before);
  }
  else if (this->Past.back() == after)
  {
    this->Past.pop_back();
    this->Changed.clear();
  }
  if (this->Past.size() > Most)
  {
    this->Past.erase(this->Past.begin());
  }
}

//------------------------------------------------------------------------------
std::optional<scene::Settings> History::Undo(const scene::Settings& now)
{
  this->Changed.clear();
  return Step(this->Past, this->Future, now);
}

//------------------------------------------------------------------------------
std::optional<scene::Settings> History::Redo(const scene::Settings& now)
{
  this->Changed.clear();
  return Step(this->Future, this->Past, now);
}

//------------------------------------------------------------------------------
void History::DropUntil(const scene::Settings& settings)
{
  while (!this->Past.empty() && this->Past.back() == settings)
  {
    this->Past.pop_back();
    this->Changed.clear();
  }
}

//------------------------------------------------------------------------------
void History::Clear()
{
  this->Past.clear();
  this->Future.clear();
  this->Changed.clear();
}
}
