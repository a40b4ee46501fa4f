// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The differences between two frames by cause, and how many pixels each cause explains.
#ifndef vtkRelievoCauseList_h
#define vtkRelievoCauseList_h

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace relievo::compare
{
enum class Cause
{
  Size,
  Camera,
  Removed,
  Added,
  Moved,
  Shape,
  Visibility,
  Normal,
  Array,
  Color,
  Light,
  Shadow,
  Lamps,
  Fog,
  Ambient,
  Markers,
  Translucent,
  Overlay,
  Tone,
  Settings
};

// The words of the causes, in the order of precedence.
constexpr std::array<const char*, 20> CauseWords = { "size", "camera", "removed", "added", "moved",
  "shape", "visibility", "normal", "array", "color", "light", "shadow", "lamps", "fog", "ambient",
  "markers", "translucent", "overlay", "tone", "settings" };

struct Finding
{
  Cause Is = Cause::Size;
  std::string Kind; // actor, light, setting, picture
  std::string Name; // empty: none
  int Id = -1;      // -1: none
  std::size_t Pixels = 0;
  std::string Words; // shown to users; empty: the cause's word
  nlohmann::ordered_json More = nlohmann::ordered_json::object(); // further entries of the JSON

  // The object's label, such as "wheel (actor 3)".
  std::string GetLabel() const;
};

class CauseList
{
public:
  // The index of the finding of this cause, kind, name and id; adds a missing one.
  int Find(Cause cause, const std::string& kind, const std::string& name = {}, int id = -1);

  Finding& At(int place) { return this->Findings[static_cast<std::size_t>(place)]; }
  const std::vector<Finding>& Get() const { return this->Findings; }

private:
  std::vector<Finding> Findings;
  std::map<std::pair<std::string, int>, int> Places;
};

// The colours of causes and other kinds of pixels in reports, as "#rrggbb". Causes that often occur
// together have very different colours.
const std::map<std::string, std::string>& GetColors();

// A number with three significant digits, independent of the locale: "0.02".
std::string WriteShort(double number);

// "(0.02, 0, 0)"; components within the rounding error of the largest become 0.
std::string WriteVector(const std::array<double, 3>& v);

// A count with grouped digits: "2 031".
std::string WriteCount(std::size_t count);

// Words separated by commas.
std::string Join(const std::vector<std::string>& words);
}

#endif
