// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeChanges.h"

#include <algorithm>
#include <map>
#include <string>

namespace relievo::compare
{
namespace
{
// Whether two recorded matrices differ in more than their translations.
bool IsTurned(const nlohmann::json& from, const nlohmann::json& to)
{
  if (!from.is_array() || !to.is_array() || from.size() != 16 || to.size() != 16)
  {
    return false;
  }
  for (std::size_t i = 0; i < 12; ++i)
  {
    if (i % 4 != 3 && from[i] != to[i])
    {
      return true;
    }
  }
  return false;
}

bool IsValid(const std::array<double, 6>& bounds)
{
  return bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}
}

//------------------------------------------------------------------------------
VolumeChanges::VolumeChanges(const Frame& before, const Frame& after, CauseList& list)
  : A(before)
  , B(after)
  , List(list)
{
  if (before.HasVolumes && after.HasVolumes)
  {
    this->Match();
  }
}

//------------------------------------------------------------------------------
int VolumeChanges::GetFinding(std::size_t side, int volume) const
{
  const std::vector<int>& findings = this->Findings[side];
  return volume >= 0 && volume < static_cast<int>(findings.size())
    ? findings[static_cast<std::size_t>(volume)]
    : -1;
}

//------------------------------------------------------------------------------
void VolumeChanges::Match()
{
  const std::vector<Volume>& from = this->A.Volumes;
  const std::vector<Volume>& to = this->B.Volumes;
  const auto data = [](const Volume& volume) {
    return volume.Values.value("data", nlohmann::json())
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  };
  std::vector<int> partners(from.size(), -1);
  std::vector<bool> taken(to.size(), false);
  const auto pair = [&](std::size_t i, std::size_t j) {
    partners[i] = static_cast<int>(j);
    taken[j] = true;
  };
  std::map<std::string, std::vector<std::size_t>> equal; // numbers in `to`, the last first
  for (std::size_t j = to.size(); j-- > 0;)
  {
    equal[data(to[j])].push_back(j);
  }
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    std::vector<std::size_t>& those = equal[data(from[i])];
    if (!those.empty())
    {
      pair(i, those.back());
      those.pop_back();
    }
  }
  for (std::size_t i = 0, j = 0; i < from.size(); ++i)
  {
    while (j < to.size() && taken[j])
    {
      ++j;
    }
    if (partners[i] < 0 && j < to.size())
    {
      pair(i, j);
    }
  }
  this->Findings[0].assign(from.size(), -1);
  this->Findings[1].assign(to.size(), -1);
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const int number = static_cast<int>(i);
    const int finding = partners[i] < 0 ? this->List.Find(Cause::Removed, "volume", "", number)
                                        : this->Compare(number, partners[i]);
    this->Add(0, i, finding);
    if (partners[i] >= 0)
    {
      this->Add(1, static_cast<std::size_t>(partners[i]), finding);
    }
  }
  for (std::size_t j = 0; j < to.size(); ++j)
  {
    if (!taken[j])
    {
      this->Add(1, j, this->List.Find(Cause::Added, "volume", "", static_cast<int>(j)));
    }
  }
}

//------------------------------------------------------------------------------
void VolumeChanges::Add(std::size_t side, std::size_t volume, int finding)
{
  this->Findings[side][volume] = finding;
  const std::array<double, 6>& bounds = (side == 0 ? this->A : this->B).Volumes[volume].Bounds;
  if (finding >= 0 && IsValid(bounds))
  {
    this->Regions.push_back({ finding, bounds });
  }
}

//------------------------------------------------------------------------------
// Lists the changes of a volume's record by cause, and returns the first, to which its pixels
// belong; -1: none.
int VolumeChanges::Compare(int before, int after)
{
  static const std::map<std::string, Cause> causes = { { "matrix", Cause::Moved },
    { "points", Cause::Shape }, { "visible", Cause::Visibility }, { "clipping", Cause::Visibility },
    { "data", Cause::Array }, { "array", Cause::Array }, { "colors", Cause::Color },
    { "opacity", Cause::Color }, { "gradient_opacity", Cause::Color } };
  const Volume& from = this->A.Volumes[static_cast<std::size_t>(before)];
  const Volume& to = this->B.Volumes[static_cast<std::size_t>(after)];
  std::map<Cause, std::vector<std::string>> changes; // in the order of precedence
  for (std::string name : ListChanges(from.Values, to.Values))
  {
    const auto cause = causes.find(name);
    const Cause is = cause == causes.end() ? Cause::Settings : cause->second;
    std::replace(name.begin(), name.end(), '_', ' ');
    changes[is].push_back(name);
  }
  int first = -1;
  for (const auto& [cause, names] : changes)
  {
    const int place = this->List.Find(cause, "volume", "", before);
    first = first < 0 ? place : first;
    Finding& finding = this->List.At(place);
    const std::string word = CauseWords[static_cast<std::size_t>(cause)];
    finding.Words = word + ": " + Join(names);
    if (cause == Cause::Moved)
    {
      finding.Words = "moved";
      if (IsValid(from.Bounds) && IsValid(to.Bounds))
      {
        std::array<double, 3> by{};
        for (std::size_t i = 0; i < 3; ++i)
        {
          by[i] = 0.5 *
            (to.Bounds[2 * i] + to.Bounds[2 * i + 1] - from.Bounds[2 * i] - from.Bounds[2 * i + 1]);
        }
        finding.Words += " by " + WriteVector(by);
        finding.More["displacement"] = by;
      }
      const nlohmann::json none;
      const bool isTurned =
        IsTurned(from.Values.value("matrix", none), to.Values.value("matrix", none));
      finding.Words += isTurned ? ", turned" : "";
    }
    else if (cause == Cause::Visibility)
    {
      const bool isHidden = to.Values.value("visible", nlohmann::json(true)) == false;
      finding.Words = names.back() != "visible" ? "visibility: clipping planes"
        : isHidden                              ? "hidden"
                                                : "shown";
    }
    else if (cause == Cause::Array)
    {
      const nlohmann::json name = to.Values.value("array", nlohmann::json());
      const std::string array = name.is_string() ? name.get<std::string>() : std::string();
      finding.Words = "array " + (array.empty() ? "of values" : array);
      finding.More["array"] = array;
    }
  }
  return first;
}
}
