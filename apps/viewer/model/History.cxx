// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "History.h"

namespace viewer
{
namespace
{
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
}

//------------------------------------------------------------------------------
void History::Add(const scene::Settings& before, const scene::Settings& after, int number)
{
  const bool same = number != 0 && number == this->Number && !this->Past.empty();
  this->Number = number;
  this->Future.clear();
  if (!same)
  {
    this->Past.push_back(before);
  }
  else if (this->Past.back() == after)
  {
    this->Past.pop_back();
    this->Number = 0; // the next change begins a new edit
  }
  if (this->Past.size() > Most)
  {
    this->Past.erase(this->Past.begin());
  }
}

//------------------------------------------------------------------------------
std::optional<scene::Settings> History::Undo(const scene::Settings& now)
{
  this->Number = 0;
  return Step(this->Past, this->Future, now);
}

//------------------------------------------------------------------------------
std::optional<scene::Settings> History::Redo(const scene::Settings& now)
{
  this->Number = 0;
  return Step(this->Future, this->Past, now);
}

//------------------------------------------------------------------------------
const scene::Settings& History::GetPast(const scene::Settings& now) const
{
  return this->Past.empty() ? now : this->Past.back();
}

//------------------------------------------------------------------------------
const scene::Settings& History::GetFuture(const scene::Settings& now) const
{
  return this->Future.empty() ? now : this->Future.back();
}

//------------------------------------------------------------------------------
void History::DropUntil(const scene::Settings& settings)
{
  while (!this->Past.empty() && this->Past.back() == settings)
  {
    this->Past.pop_back();
    this->Number = 0;
  }
}

//------------------------------------------------------------------------------
void History::Clear()
{
  this->Past.clear();
  this->Future.clear();
  this->Number = 0;
}
}
