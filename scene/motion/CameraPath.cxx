// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPath.h"

#include "Errors.h"
#include "Numbers.h"
#include "Readers.h"
#include "Triples.h"
#include "Values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace scene
{
namespace
{
using Three = std::array<double, 3>;

constexpr int MostFrames = 1000000;

constexpr const char* Names[] = { "position", "focal_point", "view_up" };
constexpr const char* Columns = "time,px,py,pz,fx,fy,fz,ux,uy,uz";

Three Scaled(const Three& v, double factor)
{
  return { factor * v[0], factor * v[1], factor * v[2] };
}

Three Plus(const Three& a, const Three& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Three Unit(const Three& v)
{
  return Scaled(v, 1.0 / Length(v));
}

bool AreOpposite(const Three& a, const Three& b)
{
  return Length(Plus(Unit(a), Unit(b))) < 1e-6;
}

bool AreSame(const CameraPlace& a, const CameraPlace& b)
{
  return a.Position == b.Position && a.FocalPoint == b.FocalPoint && a.ViewUp == b.ViewUp;
}

//------------------------------------------------------------------------------
// Values at four keys around a time, the middle two being its neighbours, and the lengths of the
// three spans between them; an outer span of 0 does not exist.
struct Around
{
  std::array<double, 4> Values;
  std::array<double, 3> Spans;
  std::array<bool, 3> Rests; // whether the whole view stays the same in the span
};

// The derivative at the second of three keys: of the parabola through them.
double FindSlope(double before, double after, double spanBefore, double spanAfter)
{
  return (before * spanAfter + after * spanBefore) / (spanBefore + spanAfter);
}

// A derivative with which the curve stays between the keys' values: F. N. Fritsch and J. Butland, A
// method for constructing local monotone piecewise cubic interpolants, 1984.
double FindMonotoneSlope(double before, double after, double spanBefore, double spanAfter)
{
  if (before * after <= 0.0)
  {
    return 0.0;
  }
  const double weight = (2.0 * spanAfter + spanBefore) / (3.0 * (spanBefore + spanAfter));
  return before * after / (weight * after + (1.0 - weight) * before);
}

// Hermite's cubic in the middle span, at its share t.
double Interpolate(const Around& at, double t, double (*slopeOf)(double, double, double, double))
{
  std::array<double, 3> rises{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    rises[i] = at.Spans[i] > 0.0 ? (at.Values[i + 1] - at.Values[i]) / at.Spans[i] : 0.0;
  }
  const double span = at.Spans[1];
  const double first = at.Rests[0] ? 0.0
    : at.Spans[0] > 0.0            ? slopeOf(rises[0], rises[1], at.Spans[0], span)
                                   : rises[1];
  const double last = at.Rests[2] ? 0.0
    : at.Spans[2] > 0.0           ? slopeOf(rises[1], rises[2], span, at.Spans[2])
                                  : rises[1];
  const double left = 1.0 - t;
  return left * left * (1.0 + 2.0 * t) * at.Values[1] + t * t * (3.0 - 2.0 * t) * at.Values[2] +
    span * t * left * (left * first - t * last);
}

//------------------------------------------------------------------------------
[[noreturn]] void RefuseForm(const std::string& name)
{
  throw UsageError(name +
    ": expected {\"keys\": [{\"time\": 0, \"position\": [x, y, z], \"focal_point\": [x, y, z], "
    "\"view_up\": [x, y, z]}, ...]}, or CSV with the columns " +
    Columns);
}

CameraKey MakeKey(const std::vector<double>& numbers)
{
  return { numbers[0], { Triple(numbers, 1), Triple(numbers, 4), Triple(numbers, 7) } };
}

std::vector<CameraKey> ParseJson(const std::string& text, const std::string& name)
{
  const auto all = nlohmann::json::parse(text, nullptr, false);
  if (!all.is_object() || !all.contains("keys") || !all["keys"].is_array())
  {
    RefuseForm(name);
  }
  std::vector<CameraKey> keys;
  for (const auto& one : all["keys"])
  {
    std::vector<double> numbers;
    const auto take = [&](const nlohmann::json& number) {
      if (!number.is_number())
      {
        RefuseForm(name);
      }
      numbers.push_back(number.get<double>());
    };
    take(one.is_object() ? one.value("time", nlohmann::json()) : nlohmann::json());
    for (const char* each : Names)
    {
      const auto triple = one.value(each, nlohmann::json());
      if (!triple.is_array() || triple.size() != 3)
      {
        RefuseForm(name);
      }
      std::for_each(triple.begin(), triple.end(), take);
    }
    keys.push_back(MakeKey(numbers));
  }
  return keys;
}

std::vector<CameraKey> ParseTable(const std::string& text, const std::string& name)
{
  std::istringstream lines(text);
  std::string line;
  std::vector<CameraKey> keys;
  bool isFirst = true;
  while (std::getline(lines, line))
  {
    line.erase(std::remove_if(line.begin(), line.end(),
                 [](unsigned char c) { return std::isspace(c) != 0 || c == '"'; }),
      line.end());
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    if (isFirst && line != Columns)
    {
      RefuseForm(name);
    }
    if (!isFirst)
    {
      keys.push_back(MakeKey(ParseNumbers(name, line, 10, Columns)));
    }
    isFirst = false;
  }
  return keys;
}
}

//------------------------------------------------------------------------------
CameraPath::CameraPath(const std::vector<CameraKey>& keys, const std::string& name)
  : Keys(keys)
{
  if (keys.size() < 2)
  {
    throw UsageError(name + ": has " + std::to_string(keys.size()) +
      " keys, expected at least two, each a view and its time");
  }
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const std::string key = name + ": key " + std::to_string(i + 1);
    const std::string error = CheckPlace(keys[i].Place);
    if (!error.empty() || !std::isfinite(keys[i].Time))
    {
      throw UsageError(key + ": expected " + (error.empty() ? "a finite time" : error));
    }
    if (i == 0)
    {
      continue;
    }
    const CameraPlace& place = keys[i].Place;
    const CameraPlace& before = keys[i - 1].Place;
    if (!(keys[i].Time > keys[i - 1].Time))
    {
      throw UsageError(key + ": its time " + WriteNumber(keys[i].Time) +
        " is not after that of the key before, " + WriteNumber(keys[i - 1].Time));
    }
    if (AreOpposite(
          Minus(place.Position, place.FocalPoint), Minus(before.Position, before.FocalPoint)) ||
      AreOpposite(place.ViewUp, before.ViewUp))
    {
      throw UsageError(key +
        ": the camera, or its up direction, turns by 180 degrees since the key before; give a key "
        "between them, which says to which side");
    }
  }
}

//------------------------------------------------------------------------------
CameraPath CameraPath::Read(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  if (!stream.is_open() || stream.bad())
  {
    throw FileError(file + ": cannot be read");
  }
  const std::string name = "--camera-path " + file;
  return { ExtensionOf(file) == ".csv" ? ParseTable(text, name) : ParseJson(text, name), name };
}

//------------------------------------------------------------------------------
bool CameraPath::IsClosed() const
{
  return this->Keys.size() > 2 && AreSame(this->Keys.front().Place, this->Keys.back().Place);
}

//------------------------------------------------------------------------------
CameraPlace CameraPath::Find(double time) const
{
  const auto after = std::upper_bound(this->Keys.begin(), this->Keys.end(), time,
    [](double at, const CameraKey& key) { return at < key.Time; });
  if (after == this->Keys.begin() || after == this->Keys.end())
  {
    return (after == this->Keys.begin() ? this->Keys.front() : this->Keys.back()).Place;
  }
  const auto last = static_cast<std::ptrdiff_t>(this->Keys.size()) - 1;
  const std::ptrdiff_t here = std::distance(this->Keys.begin(), after) - 1;
  const auto get = [this](std::ptrdiff_t i) -> const CameraKey& {
    return this->Keys[static_cast<std::size_t>(i)];
  };
  if (time == get(here).Time)
  {
    return get(here).Place;
  }
  // The neighbours; beyond the ends of a closed path its other end.
  std::array<const CameraPlace*, 4> places{};
  std::array<double, 3> spans{};
  const bool closed = this->IsClosed();
  for (std::ptrdiff_t i = 0; i < 4; ++i)
  {
    const std::ptrdiff_t key = here - 1 + i;
    const bool beyond = key < 0 || key > last;
    const std::ptrdiff_t wrapped = key < 0 ? last - 1 : 1;
    places[static_cast<std::size_t>(i)] = &get(!beyond ? key
        : closed                                       ? wrapped
                                                       : std::clamp<std::ptrdiff_t>(key, 0, last))
                                             .Place;
    if (i > 0)
    {
      const bool isBefore = key - 1 < 0;
      spans[static_cast<std::size_t>(i - 1)] = !isBefore && !beyond
        ? get(key).Time - get(key - 1).Time
        : !closed  ? 0.0
        : isBefore ? get(last).Time - get(last - 1).Time
                   : get(1).Time - get(0).Time;
    }
  }
  std::array<bool, 3> rests{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    rests[i] = spans[i] > 0.0 && AreSame(*places[i], *places[i + 1]);
  }
  if (rests[1])
  {
    return *places[1];
  }
  const double t = (time - get(here).Time) / spans[1];
  const auto interpolate = [&](auto&& valueOf, auto* slopeOf) {
    Around around{ {}, spans, rests };
    for (std::size_t i = 0; i < 4; ++i)
    {
      around.Values[i] = valueOf(*places[i]);
    }
    return Interpolate(around, t, slopeOf);
  };
  const auto direction = [](const CameraPlace& place) {
    return Unit(Minus(place.Position, place.FocalPoint));
  };
  CameraPlace view{};
  Three towards{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    view.FocalPoint[axis] =
      interpolate([axis](const CameraPlace& p) { return p.FocalPoint[axis]; }, FindSlope);
    towards[axis] =
      interpolate([&](const CameraPlace& p) { return direction(p)[axis]; }, FindSlope);
    view.ViewUp[axis] =
      interpolate([axis](const CameraPlace& p) { return Unit(p.ViewUp)[axis]; }, FindMonotoneSlope);
  }
  const double distance = std::exp(interpolate(
    [](const CameraPlace& p) { return std::log(Length(Minus(p.Position, p.FocalPoint))); },
    FindMonotoneSlope));
  view.Position = Plus(view.FocalPoint, Scaled(Unit(towards), distance));
  view.ViewUp = Unit(view.ViewUp);
  return view;
}

//------------------------------------------------------------------------------
std::vector<double> CameraPath::GetTimes(double framesPerSecond) const
{
  const double first = this->Keys.front().Time;
  const double length = (this->Keys.back().Time - first) * framesPerSecond;
  // Includes the end despite rounding; on a closed path it is the first view again.
  const double frames =
    this->IsClosed() ? std::ceil(length - 1e-9) : std::floor(length + 1e-9) + 1.0;
  if (!(frames >= 1.0 && frames <= MostFrames))
  {
    throw UsageError("--camera-path: the views' times, in seconds, and --fps give " +
      WriteNumber(frames) + " frames, expected 1 to " + std::to_string(MostFrames));
  }
  std::vector<double> times;
  for (int i = 0; i < frames; ++i)
  {
    times.push_back(first + i / framesPerSecond);
  }
  return times;
}

//------------------------------------------------------------------------------
std::string WriteTable(const std::vector<CameraKey>& keys)
{
  std::string table = std::string(Columns) + "\n";
  for (const CameraKey& key : keys)
  {
    std::vector<double> numbers = { key.Time };
    for (const Three& place : { key.Place.Position, key.Place.FocalPoint, key.Place.ViewUp })
    {
      numbers.insert(numbers.end(), place.begin(), place.end());
    }
    table += words::WriteNumbers(numbers) + "\n";
  }
  return table;
}
}
