// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPixelCauses.h"

#include "vtkMath.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace relievo::compare
{
namespace
{
// Maximum cells that a finding lists by number.
constexpr std::size_t MostCells = 100;

// The angle between normals, in degrees, from which they belong to two faces.
constexpr double CreaseAngle = 20.0;

// The part of a pixel's size by which rounding may shift the depth of a volume.
constexpr double OfVolumes = 0.25;

// The setting with the number of samples per pixel.
const std::string Multisamples = "multisamples";

int GetSamples(const Frame& frame)
{
  const auto found = frame.Settings.find(Multisamples);
  return found == frame.Settings.end() ? -1 : std::atoi(found->second.c_str());
}

bool IsEqual(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

double AngleBetween(const float* a, const float* b)
{
  const double u[3] = { a[0], a[1], a[2] };
  const double v[3] = { b[0], b[1], b[2] };
  double cross[3];
  vtkMath::Cross(u, v, cross);
  return vtkMath::DegreesFromRadians(std::atan2(vtkMath::Norm(cross), vtkMath::Dot(u, v)));
}

const Layer* Find(const std::map<std::string, Layer>& layers, const std::string& name)
{
  const auto found = layers.find(name);
  return found == layers.end() ? nullptr : &found->second;
}
}

//------------------------------------------------------------------------------
PixelCauses::PixelCauses(const Frame& before, const Frame& after, const Limits& limits,
  const ObjectChanges& objects, CauseList& list)
  : A(before)
  , B(after)
  , Bounds(limits)
  , Objects(objects)
  , List(list)
  , VolumesChanged(before, after, list)
  , Causes(before.Pixels, Alike)
{
  const int samples[2] = { GetSamples(before), GetSamples(after) };
  if (samples[0] >= 0 && samples[1] >= 0 && samples[0] != samples[1])
  {
    this->Smoother = samples[0] > samples[1] ? &this->A : &this->B;
  }
  this->PairLights();
  this->CompareSettings();
  this->PairLayers();
  this->ProjectTranslucent();
  for (const VolumeChanges::Region& region : this->VolumesChanged.GetRegions())
  {
    this->Volumes.push_back(
      { static_cast<std::size_t>(region.Finding), this->ProjectBox(region.Bounds) });
  }
  this->BorderStep = this->FindStep("shadows:soft_samples");
  this->AmbientStep = this->FindStep("ambient:samples");
  for (std::size_t i = 0; i < before.Pixels; ++i)
  {
    if (this->IsEqualInAll(i))
    {
      continue;
    }
    this->IsDifferent = false;
    this->Loose = 0.0;
    this->Ambient = std::nullopt;
    const int cause = this->JudgeLayers(i);
    const int found = this->JudgePicture(i);
    const bool isWithin = found == Pending &&
      ((this->Loose > 0.0 && this->IsOfNormal(i)) || (this->Ambient && this->IsOfAmbient(i)));
    const int picture = isWithin ? WithinRounding : found;
    this->Causes[i] = cause != Alike ? cause
      : picture != Alike             ? picture
      : this->IsDifferent            ? WithinRounding
                                     : Alike;
  }
  // Pixels beside a changed pixel may show a part of its surface, by samples off the pixel's centre
  // or smooth edges.
  const std::vector<int> first = this->Causes;
  for (std::size_t i = 0; i < before.Pixels; ++i)
  {
    if (first[i] == Pending)
    {
      const int neighbour = this->GetNeighbourCause(i, first);
      this->Causes[i] = neighbour >= 0 ? neighbour : this->Explain(i, first);
    }
  }
  for (const int cause : this->Causes)
  {
    if (cause >= 0)
    {
      ++this->List.At(cause).Pixels;
    }
  }
  for (const auto& [finding, cells] : this->Cells)
  {
    this->List.At(finding).More["cells"] =
      std::vector<int>(cells.begin(), std::next(cells.begin(), std::min(cells.size(), MostCells)));
    this->List.At(finding).More["number_of_cells"] = cells.size();
  }
}

//------------------------------------------------------------------------------
void PixelCauses::PairLayers()
{
  const auto add = [this](
                     const std::vector<float>& a, const std::vector<float>& b, int components) {
    this->HasOtherForms = this->HasOtherForms || a.empty() != b.empty() || a.size() != b.size();
    if (!a.empty() && a.size() == b.size())
    {
      this->Layers.push_back({ a.data(), b.data(), static_cast<std::size_t>(components) });
    }
  };
  add(this->A.Picture.Values, this->B.Picture.Values, this->A.Picture.Components);
  add(this->A.Depth, this->B.Depth, 1);
  for (const auto& [from, to] :
    { std::pair(&this->A.Surface, &this->B.Surface), std::pair(&this->A.Stages, &this->B.Stages) })
  {
    for (const auto& [name, layer] : *from)
    {
      if (const Layer* other = Find(*to, name))
      {
        add(layer.Values, other->Values, layer.Components);
      }
    }
  }
  add(this->A.VolumeDepth, this->B.VolumeDepth, 1);
  add(this->A.VolumeOpacity, this->B.VolumeOpacity, 1);
  for (const LightPair& pair : this->Lights)
  {
    if (pair.Before >= 0 && pair.After >= 0)
    {
      const auto from =
        this->A.Shadow.find(this->A.Lights[static_cast<std::size_t>(pair.Before)].Layer);
      const auto to =
        this->B.Shadow.find(this->B.Lights[static_cast<std::size_t>(pair.After)].Layer);
      if (from != this->A.Shadow.end() && to != this->B.Shadow.end())
      {
        add(from->second, to->second, 1);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Whether all values are bitwise equal, as at most pixels.
bool PixelCauses::IsEqualInAll(std::size_t pixel) const
{
  const bool isJudged = this->Lights.empty() && !this->A.Shadow.empty();
  const bool isElsewhere = this->A.Depth.empty() || this->B.Depth.empty() || this->HasOtherForms ||
    this->A.IsLinear != this->B.IsLinear;
  const auto isSame = [pixel](const std::vector<int>& a, const std::vector<int>& b) {
    return a.empty() || b.empty() || a[pixel] == b[pixel];
  };
  if (isJudged || isElsewhere || !isSame(this->A.Cell, this->B.Cell) ||
    !isSame(this->A.Block, this->B.Block) || !isSame(this->A.VolumeId, this->B.VolumeId))
  {
    return false;
  }
  if (!this->A.Actor.empty() && !this->B.Actor.empty())
  {
    const int a = this->A.Actor[pixel];
    const int b = this->B.Actor[pixel];
    if (a < 0 ? b >= 0 : this->Objects.GetAfter(a) != b)
    {
      return false;
    }
  }
  return std::all_of(this->Layers.begin(), this->Layers.end(), [pixel](const Values& values) {
    return std::memcmp(values.Before + pixel * values.Components,
             values.After + pixel * values.Components, values.Components * sizeof(float)) == 0;
  });
}

//------------------------------------------------------------------------------
std::size_t PixelCauses::Count(int code) const
{
  return static_cast<std::size_t>(std::count(this->Causes.begin(), this->Causes.end(), code));
}

//------------------------------------------------------------------------------
template <typename Visit>
void PixelCauses::ForNeighbours(std::size_t pixel, Visit visit, int reach) const
{
  const auto width = static_cast<std::ptrdiff_t>(this->A.Size[0]);
  const auto x = static_cast<std::ptrdiff_t>(pixel) % width;
  const auto y = static_cast<std::ptrdiff_t>(pixel) / width;
  for (std::ptrdiff_t v = std::max<std::ptrdiff_t>(0, y - reach);
       v <= std::min<std::ptrdiff_t>(this->A.Size[1] - 1, y + reach); ++v)
  {
    for (std::ptrdiff_t u = std::max<std::ptrdiff_t>(0, x - reach);
         u <= std::min<std::ptrdiff_t>(width - 1, x + reach); ++u)
    {
      visit(static_cast<std::size_t>(v * width + u));
    }
  }
}

//------------------------------------------------------------------------------
template <typename Value>
bool PixelCauses::IsBetween(std::size_t pixel, double limit, Value value) const
{
  return this->IsBetween(this->A, this->B, pixel, limit, value) &&
    this->IsBetween(this->B, this->A, pixel, limit, value);
}

//------------------------------------------------------------------------------
template <typename Value>
bool PixelCauses::IsBetween(const Frame& own, const Frame& other, std::size_t pixel, double limit,
  Value value, double widening, int reach) const
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  const auto take = [&](std::size_t near) {
    least = std::min(least, double(value(other, near)));
    most = std::max(most, double(value(other, near)));
  };
  this->ForNeighbours(pixel, take, reach);
  const double here = value(own, pixel);
  const double around = limit + (widening > 0.0 ? widening * (most - least) : 0.0);
  return here >= least - around && here <= most + around;
}

//------------------------------------------------------------------------------
// Pairs lights by name, otherwise by number.
void PixelCauses::PairLights()
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
    LightPair pair;
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
    this->Lights.push_back(pair);
  }
  for (std::size_t j = 0; j < this->B.Lights.size(); ++j)
  {
    if (!taken[j])
    {
      LightPair pair;
      pair.After = static_cast<int>(j);
      this->Lights.push_back(pair);
    }
  }
  for (LightPair& pair : this->Lights)
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
      pair.Finding = this->FindLight(pair, Cause::Light);
      this->List.At(pair.Finding).Words = "light: " + words;
      this->List.At(pair.Finding).More["changed"] = words;
    }
  }
}

//------------------------------------------------------------------------------
int PixelCauses::FindLight(const LightPair& pair, Cause cause)
{
  const bool isOld = pair.Before >= 0;
  const int number = isOld ? pair.Before : pair.After;
  const Light& light = (isOld ? this->A : this->B).Lights[static_cast<std::size_t>(number)];
  return this->List.Find(cause, "light", light.Name, number);
}

//------------------------------------------------------------------------------
int PixelCauses::NameActor(Cause cause, int object)
{
  return object < 0 ? this->List.Find(cause, "picture")
                    : this->List.Find(cause, "actor", this->Objects.GetName(object), object);
}

//------------------------------------------------------------------------------
void PixelCauses::CompareSettings()
{
  if (!this->A.HasRecord || !this->B.HasRecord)
  {
    return;
  }
  if (this->A.Overlays != this->B.Overlays)
  {
    std::set<std::string> kinds;
    for (const auto& [own, others] : { std::pair(&this->A.Overlays, &this->B.Overlays),
           std::pair(&this->B.Overlays, &this->A.Overlays) })
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
    this->Overlay = this->List.Find(Cause::Overlay, "picture");
    this->List.At(this->Overlay).Words = "overlay: " + (names.empty() ? "order" : names);
  }
  const std::string tone = "tone:";
  std::map<std::string, std::string> all = this->A.Settings;
  all.insert(this->B.Settings.begin(), this->B.Settings.end());
  for (const auto& [name, value] : all)
  {
    if (name == Multisamples)
    {
      continue; // innocent
    }
    const auto valueIn = [&name = name](const std::map<std::string, std::string>& settings) {
      const auto found = settings.find(name);
      return found == settings.end() ? std::string("not set") : found->second;
    };
    const std::string from = valueIn(this->A.Settings);
    const std::string to = valueIn(this->B.Settings);
    if (from != to)
    {
      const bool isTone = name.compare(0, tone.size(), tone) == 0;
      const int place = this->List.Find(isTone ? Cause::Tone : Cause::Settings, "setting", name);
      this->List.At(place).Words = (isTone ? "tone: " : "settings: ") + from + ", now " + to;
      int& first = isTone ? this->Tone : this->Settings;
      first = first < 0 ? place : first;
    }
  }
}

//------------------------------------------------------------------------------
int PixelCauses::CountLevels() const
{
  const bool hasPictures = this->A.Picture.Components > 0 && this->B.Picture.Components > 0;
  return !hasPictures ? 0 : this->A.HasAlpha() && this->B.HasAlpha() ? 4 : 3;
}

//------------------------------------------------------------------------------
int PixelCauses::JudgePicture(std::size_t pixel) const
{
  const auto components = static_cast<std::size_t>(this->A.Picture.Components);
  bool isEqual = this->A.IsLinear == this->B.IsLinear &&
    this->A.Picture.Components == this->B.Picture.Components;
  for (std::size_t i = pixel * components; i < (pixel + 1) * components && isEqual; ++i)
  {
    isEqual = IsEqual(this->A.Picture.Values[i], this->B.Picture.Values[i]);
  }
  int found = Alike;
  for (int c = 0; c < this->CountLevels() && !isEqual; ++c)
  {
    const float a = this->A.Level(pixel, c);
    const float b = this->B.Level(pixel, c);
    if (!IsEqual(a, b))
    {
      found = found == Pending || !(std::abs(a - b) <= this->Bounds.ColorLevels) ? Pending
                                                                                 : WithinRounding;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
int PixelCauses::JudgeLayers(std::size_t pixel)
{
  int actor = -1;
  bool isTie = false;
  if (!this->A.Actor.empty() && !this->B.Actor.empty())
  {
    const int a = this->A.Actor[pixel];
    const int b = this->B.Actor[pixel];
    if ((a >= 0 || b >= 0) && (a < 0 || b < 0 || this->Objects.GetAfter(a) != b))
    {
      return this->JudgeGeometry(pixel, a, b);
    }
    actor = a;
  }
  const bool hasSurface = actor >= 0 || this->A.Actor.empty() || this->B.Actor.empty();
  if (hasSurface)
  {
    const auto isSame = [pixel](const std::vector<int>& a, const std::vector<int>& b) {
      return a.empty() || b.empty() || a[pixel] == b[pixel];
    };
    const bool sameCell =
      isSame(this->A.Cell, this->B.Cell) && isSame(this->A.Block, this->B.Block);
    const int cause = this->JudgeSurface(pixel, actor, sameCell);
    if (cause >= 0)
    {
      return cause;
    }
    isTie = cause == WithinEdge;
    const int light = this->JudgeLights(pixel);
    if (light >= 0)
    {
      return light;
    }
  }
  const int stage = this->JudgeStages(pixel);
  return stage >= 0 ? stage : isTie ? WithinEdge : Alike;
}

//------------------------------------------------------------------------------
// The tolerance for shares of samples: if the records are equal, only rounding changes them, and
// values stay between the neighbours' values, to within one of the averaged samples.
std::optional<double> PixelCauses::FindStep(const std::string& samples) const
{
  const bool isSame = this->A.HasRecord && this->B.HasRecord && !this->Objects.AnyChanged() &&
    this->Settings < 0 && this->Tone < 0 &&
    std::all_of(this->Lights.begin(), this->Lights.end(),
      [](const LightPair& pair) { return pair.Finding < 0; });
  const auto setting = this->A.Settings.find(samples);
  const int count = setting == this->A.Settings.end() ? 0 : std::atoi(setting->second.c_str());
  const double step = count > 1 ? 1.001 / count : 0.0;
  return isSame ? std::optional<double>(step) : std::nullopt;
}

//------------------------------------------------------------------------------
// Whether the pixel's centre is on a border between unchanged cells: each frame shows the other's
// object or cell in a neighbouring pixel. Cells may also be smaller than pixels, or coincide; so
// with records it is enough that each frame's depth lies between the other frame's depths around
// the pixel.
bool PixelCauses::IsTie(std::size_t pixel) const
{
  bool hasBefore = false, hasAfter = false;
  const bool hasActors = !this->A.Actor.empty() && !this->B.Actor.empty();
  const auto isSame = [this, hasActors](std::size_t a, std::size_t b) {
    const int object = hasActors ? this->A.Actor[a] : -1;
    const int other = hasActors ? this->B.Actor[b] : -1;
    return (object < 0 ? other < 0 : this->Objects.GetAfter(object) == other) &&
      (this->A.Cell.empty() || this->B.Cell.empty() || this->A.Cell[a] == this->B.Cell[b]) &&
      (this->A.Block.empty() || this->B.Block.empty() || this->A.Block[a] == this->B.Block[b]);
  };
  this->ForNeighbours(pixel, [&](std::size_t other) {
    hasBefore = hasBefore || isSame(pixel, other);
    hasAfter = hasAfter || isSame(other, pixel);
  });
  return (hasBefore && hasAfter) ||
    (this->A.HasRecord && this->B.HasRecord &&
      this->IsBetween(
        pixel, 0.0, [](const Frame& frame, std::size_t at) { return frame.GetDepth(at); }));
}

//------------------------------------------------------------------------------
// Explains a pixel with a different object: the nearer of the two objects was removed or added
// there, unless that object is unchanged.
int PixelCauses::JudgeGeometry(std::size_t pixel, int a, int b)
{
  const double before = this->A.GetDepth(pixel);
  const double after = this->B.GetDepth(pixel);
  const Change& gone = this->Objects.OfBefore(a);
  const Change& come = this->Objects.OfAfter(b);
  const bool isGone = b < 0 || (a >= 0 && !(after < before));
  for (const Change* change : { isGone ? &gone : &come, isGone ? &come : &gone })
  {
    if (!change->IsSame || change->Coverage >= 0)
    {
      return change->IsSame ? change->Coverage : change->Finding;
    }
  }
  const int own = this->Objects.GetBefore(b); // its number in the frame before
  const bool hasRange = this->B.HasCamera && this->B.Near < this->B.Far;
  if (isGone && hasRange && (before < this->B.Near || before > this->B.Far))
  {
    const int place = this->NameActor(Cause::Visibility, a);
    this->List.At(place).Words = "visibility: clipped";
    return place;
  }
  if (this->IsTie(pixel))
  {
    return WithinEdge;
  }
  return this->NameActor(Cause::Visibility, isGone || own < 0 ? a : own);
}

//------------------------------------------------------------------------------
// Whether an object of the frame before has the same normal map in both frames.
bool PixelCauses::IsMapped(int a) const
{
  const int b = this->Objects.GetAfter(a);
  const auto find = [](const Frame& frame, int object) {
    return object >= 0 && object < static_cast<int>(frame.Objects.size())
      ? &frame.Objects[static_cast<std::size_t>(object)]
      : nullptr;
  };
  const Object* from = find(this->A, a);
  const Object* to = find(this->B, b);
  return from && to && from->HasNormalMap && to->HasNormalMap &&
    (from->NormalMap == to->NormalMap || from->NormalMap.empty() || to->NormalMap.empty());
}

//------------------------------------------------------------------------------
// Whether the filtering of a normal map explains the angle between the pixel's normals: OpenGL may
// blend texels by weights of 8 bits and round the three components of the result to 8 bits. The
// result then lies between the texels around, which the neighbours show, but for the rounding.
bool PixelCauses::IsTexelRounded(std::size_t pixel, double angle) const
{
  const double step = this->Bounds.ColorLevels / 127.5; // components are from -1 to 1
  if (angle > vtkMath::DegreesFromRadians(std::sqrt(3.0) * step))
  {
    return false;
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    if (!this->IsBetween(pixel, step, [c](const Frame& frame, std::size_t at) {
          return frame.Surface.at("normal").Values[3 * at + c];
        }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the angle between the pixel's normals explains its colours: these lie between the colours
// around it, extended by twice as much as they change towards those for such an angle.
bool PixelCauses::IsOfNormal(std::size_t pixel) const
{
  for (int c = 0; c < this->CountLevels(); ++c)
  {
    double most = 0.0;
    for (const Frame* frame : { &this->A, &this->B })
    {
      const float* normals = frame->Surface.at("normal").Values.data();
      this->ForNeighbours(pixel, [&](std::size_t near) {
        const double angle = AngleBetween(normals + 3 * pixel, normals + 3 * near);
        const double change =
          std::abs(double(frame->Level(near, c)) - double(frame->Level(pixel, c)));
        most = std::max(most, change * this->Loose / std::max(this->Loose, angle));
      });
    }
    if (!this->IsBetween(pixel, this->Bounds.ColorLevels + 2.0 * most,
          [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double PixelCauses::GetAngle(std::size_t pixel) const
{
  const Layer* before = Find(this->A.Surface, "normal");
  const Layer* after = Find(this->B.Surface, "normal");
  if (!before || !after || before->Components != 3 || after->Components != 3)
  {
    return 0.0;
  }
  const float* a = before->Values.data() + 3 * pixel;
  const float* b = after->Values.data() + 3 * pixel;
  const bool isEqual = IsEqual(a[0], b[0]) && IsEqual(a[1], b[1]) && IsEqual(a[2], b[2]);
  const double angle = isEqual ? 0.0 : AngleBetween(a, b);
  const auto isZero = [](const float* v) { return v[0] == 0.f && v[1] == 0.f && v[2] == 0.f; };
  return std::isnan(angle) || isZero(a) != isZero(b) ? 180.0 : angle;
}

//------------------------------------------------------------------------------
bool PixelCauses::DiffersInLayer(
  const Layer& a, const Layer& b, std::size_t pixel, double limit) const
{
  if (a.Components != b.Components)
  {
    return true;
  }
  const auto components = static_cast<std::size_t>(a.Components);
  for (std::size_t i = pixel * components; i < (pixel + 1) * components; ++i)
  {
    if (!IsEqual(a.Values[i], b.Values[i]) &&
      !(std::abs(double(a.Values[i]) - double(b.Values[i])) <=
        limit * std::max(1.0, std::abs(double(a.Values[i])))))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
int PixelCauses::JudgeSurface(std::size_t pixel, int a, bool sameCell)
{
  const Change& change = this->Objects.OfBefore(a);
  const bool isElsewhere = ObjectChanges::DiffersInDepth(this->A, this->B, pixel, this->Bounds);
  const double angle = sameCell ? this->GetAngle(pixel) : 0.0;
  const bool isLoose = angle > this->Bounds.NormalAngle;
  const bool isTurned = isLoose && !(this->IsMapped(a) && this->IsTexelRounded(pixel, angle));
  this->IsDifferent = this->IsDifferent || angle > 0.0;
  this->Loose = isLoose && !isTurned ? angle : 0.0;
  const bool isTie = !sameCell && change.IsSame && change.Coverage < 0 && this->IsTie(pixel);
  if ((isElsewhere && !isTie) || (!sameCell && !isTie) || (isTurned && !change.IsSame))
  {
    int place = change.Finding;
    if (change.IsSame)
    {
      place = change.Coverage >= 0 ? change.Coverage : this->NameActor(Cause::Shape, a);
    }
    if (this->List.At(place).Is == Cause::Shape && !this->A.Cell.empty())
    {
      this->Cells[place].insert(this->A.Cell[pixel]);
    }
    return place;
  }
  if (isTie)
  {
    return WithinEdge;
  }
  if (isTurned)
  {
    const int place = this->NameActor(Cause::Normal, a);
    nlohmann::ordered_json& more = this->List.At(place).More;
    more["largest"] = std::max(angle, more.value("largest", 0.0));
    return place;
  }
  for (const auto& [name, layer] : this->A.Surface)
  {
    const Layer* other = Find(this->B.Surface, name);
    if (!other || name == "normal" || name == "albedo")
    {
      continue;
    }
    this->IsDifferent = this->IsDifferent || this->DiffersInLayer(layer, *other, pixel, 0.0);
    // Interpolated values have the rounding error of floats.
    if (this->DiffersInLayer(layer, *other, pixel,
          layer.IsBytes ? this->Bounds.ColorLevels : 4.0 * std::numeric_limits<float>::epsilon()))
    {
      const int place = this->List.Find(
        Cause::Array, a < 0 ? "picture" : "actor", a < 0 ? name : this->Objects.GetName(a), a);
      this->List.At(place).Words = "array " + name;
      this->List.At(place).More["array"] = name;
      return place;
    }
  }
  const Layer* albedo = Find(this->A.Surface, "albedo");
  const Layer* other = Find(this->B.Surface, "albedo");
  if (albedo && other && albedo->Components == other->Components)
  {
    double largest = 0.0;
    const auto components = static_cast<std::size_t>(albedo->Components);
    for (std::size_t i = pixel * components; i < (pixel + 1) * components; ++i)
    {
      const auto level = [i](const Layer& layer) {
        return (layer.IsBytes ? 1.f : 255.f) * layer.Values[i]; // files store 0 to 1
      };
      const float before = level(*albedo);
      const float after = level(*other);
      const double off = IsEqual(before, after) ? 0.0 : std::abs(double(before) - double(after));
      largest = std::max(largest, std::isfinite(off) ? off : 255.0);
    }
    this->IsDifferent = this->IsDifferent || largest > 0.0;
    if (largest > this->Bounds.ColorLevels)
    {
      const int place = this->NameActor(Cause::Color, a);
      nlohmann::ordered_json& more = this->List.At(place).More;
      more["largest"] = std::max(largest, more.value("largest", 0.0));
      this->List.At(place).Words =
        "color, at most " + WriteShort(more["largest"].get<double>()) + " of 255";
      return place;
    }
  }
  return Alike;
}

//------------------------------------------------------------------------------
int PixelCauses::JudgeLights(std::size_t pixel)
{
  const double limit = this->Bounds.ColorLevels / 255.0;
  const auto differ = [&](const std::vector<float>& from, const std::vector<float>& to) {
    this->IsDifferent = this->IsDifferent || !IsEqual(from[pixel], to[pixel]);
    return !IsEqual(from[pixel], to[pixel]) && !(std::abs(from[pixel] - to[pixel]) <= limit) &&
      !(this->BorderStep &&
        this->IsBetween(pixel, *this->BorderStep, [&](const Frame& frame, std::size_t at) {
          return (&frame == &this->A ? from : to)[at];
        }));
  };
  if (this->Lights.empty()) // no record of lights
  {
    for (const auto& [name, shadow] : this->A.Shadow)
    {
      const auto other = this->B.Shadow.find(name);
      if (other != this->B.Shadow.end() && differ(shadow, other->second))
      {
        return this->List.Find(Cause::Shadow, "light", name);
      }
    }
    return Alike;
  }
  for (const LightPair& pair : this->Lights)
  {
    if (pair.Before < 0 || pair.After < 0)
    {
      continue;
    }
    const auto from =
      this->A.Shadow.find(this->A.Lights[static_cast<std::size_t>(pair.Before)].Layer);
    const auto to = this->B.Shadow.find(this->B.Lights[static_cast<std::size_t>(pair.After)].Layer);
    if (from != this->A.Shadow.end() && to != this->B.Shadow.end() &&
      differ(from->second, to->second))
    {
      return pair.Finding >= 0 ? pair.Finding : this->FindLight(pair, Cause::Shadow);
    }
  }
  return Alike;
}

//------------------------------------------------------------------------------
int PixelCauses::JudgeStages(std::size_t pixel)
{
  static const std::pair<const char*, Cause> stages[] = { { "light", Cause::Lamps },
    { "fog", Cause::Fog }, { "ambient", Cause::Ambient }, { "marker", Cause::Markers },
    { "blend", Cause::Translucent } };
  const int volume = this->JudgeVolumes(pixel);
  if (volume >= 0)
  {
    return volume;
  }
  for (const auto& [name, cause] : stages)
  {
    const Layer* from = Find(this->A.Stages, name);
    const Layer* to = Find(this->B.Stages, name);
    if (!from || !to)
    {
      continue;
    }
    this->IsDifferent = this->IsDifferent || this->DiffersInLayer(*from, *to, pixel, 0.0);
    if (this->DiffersInLayer(*from, *to, pixel, this->Bounds.ColorLevels / 255.0))
    {
      const bool isSample = cause == Cause::Ambient && this->AmbientStep && from->Components == 1 &&
        to->Components == 1 &&
        this->IsBetween(
          pixel, *this->AmbientStep, [&, a = from, b = to](const Frame& frame, std::size_t at) {
            return (&frame == &this->A ? a : b)->Values[at];
          });
      if (!isSample)
      {
        return this->List.Find(cause, "picture");
      }
      this->Ambient = { from->Values[pixel], to->Values[pixel] };
    }
  }
  return Alike;
}

//------------------------------------------------------------------------------
// Whether the picture differs by no more than the samples of ambient occlusion by which the layers
// differ. Occlusion multiplies linear light, all of it at most: the light without it is at most the
// quotient of both.
bool PixelCauses::IsOfAmbient(std::size_t pixel) const
{
  const std::array<double, 2>& share = *this->Ambient;
  const double samples = std::abs(share[0] - share[1]);
  for (int c = 0; c < this->CountLevels(); ++c)
  {
    const double levels[2] = { this->A.Level(pixel, c), this->B.Level(pixel, c) };
    double without = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double light =
        f64::relievoLinearFromSrgb((levels[i] + 0.5) / 255.0); // not rounded down
      without = share[i] > 0.0 ? std::max(without, light / share[i]) : without;
    }
    const double least = std::min(levels[0], levels[1]);
    const double most = 255.0 *
      f64::relievoSrgbFromLinear(f64::relievoLinearFromSrgb(least / 255.0) + samples * without);
    if (!(std::max(levels[0], levels[1]) <= (c == 3 ? least : most) + this->Bounds.ColorLevels))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The cause of a difference within the limits, which bright light can enlarge in the picture.
int PixelCauses::JudgeWithinLimits(std::size_t pixel)
{
  const double levels = this->Bounds.ColorLevels;
  this->Bounds.ColorLevels = 0.0;
  const int cause = this->JudgeLayers(pixel);
  this->Bounds.ColorLevels = levels;
  return cause;
}

//------------------------------------------------------------------------------
int PixelCauses::GetNeighbourCause(std::size_t pixel, const std::vector<int>& causes) const
{
  int found = -1;
  this->ForNeighbours(pixel, [&](std::size_t other) {
    const int cause = causes[other];
    if (cause >= 0 &&
      (found < 0 ||
        this->List.Get()[static_cast<std::size_t>(cause)].Is <
          this->List.Get()[static_cast<std::size_t>(found)].Is))
    {
      found = cause;
    }
  });
  return found;
}

//------------------------------------------------------------------------------
bool PixelCauses::IsEdge(std::size_t pixel) const
{
  bool found = false;
  const Layer* normals = Find(this->A.Surface, "normal");
  const Layer* albedo = Find(this->A.Surface, "albedo");
  for (const Frame* frame : { &this->A, &this->B })
  {
    const double depth = frame->GetDepth(pixel);
    const double footprint = frame->GetFootprint(pixel);
    this->ForNeighbours(pixel, [&](std::size_t other) {
      const auto differs = [&](const std::vector<int>& ids) {
        return !ids.empty() && ids[pixel] != ids[other];
      };
      found = found || differs(frame->Actor) || differs(frame->Block);
      found = found || std::abs(frame->GetDepth(other) - depth) > 4.0 * footprint;
      for (const auto& [light, shadow] : frame->Shadow)
      {
        found = found || shadow[pixel] != shadow[other];
      }
    });
  }
  if (normals && normals->Components == 3)
  {
    this->ForNeighbours(pixel, [&](std::size_t other) {
      found = found ||
        AngleBetween(normals->Values.data() + 3 * pixel, normals->Values.data() + 3 * other) >
          CreaseAngle;
    });
  }
  if (albedo)
  {
    const auto components = static_cast<std::size_t>(albedo->Components);
    const float most = albedo->IsBytes ? 8.f : 8.f / 255.f;
    this->ForNeighbours(pixel, [&](std::size_t other) {
      for (std::size_t c = 0; c < components; ++c)
      {
        found = found ||
          std::abs(
            albedo->Values[pixel * components + c] - albedo->Values[other * components + c]) > most;
      }
    });
  }
  return found;
}

//------------------------------------------------------------------------------
bool PixelCauses::IsBetweenNeighbours(std::size_t pixel, double widening) const
{
  for (int c = 0; c < this->CountLevels(); ++c)
  {
    const auto value = [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); };
    // Pixels of several samples are mixtures of the surfaces that other frames show unmixed.
    if (!(this->Smoother
            ? this->IsBetween(*this->Smoother, this->Smoother == &this->A ? this->B : this->A,
                pixel, this->Bounds.ColorLevels, value, widening)
            : this->IsBetween(pixel, this->Bounds.ColorLevels, value)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the smoother frame's colours may be a mixture of surfaces in the other frame, of which a
// narrow one shows in a pixel beside the neighbours only, with values that are extrapolated by as
// much as those around differ.
bool PixelCauses::IsMixture(std::size_t pixel) const
{
  const Frame& other = this->Smoother == &this->A ? this->B : this->A;
  for (int c = 0; c < this->CountLevels(); ++c)
  {
    const auto value = [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); };
    if (!this->IsBetween(*this->Smoother, other, pixel, this->Bounds.ColorLevels, value, 1.0, 2))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the pixel shows a point or a line, which have no normals: OpenGL smooths their shapes in
// frames of several samples, so that what they hide in the other frame may appear.
bool PixelCauses::IsThin(std::size_t pixel) const
{
  const auto isThin = [pixel](const Frame& frame) {
    const Layer* normals = Find(frame.Surface, "normal");
    const float* n =
      normals && normals->Components == 3 ? normals->Values.data() + 3 * pixel : nullptr;
    return n && frame.Actor[pixel] >= 0 && n[0] == 0.f && n[1] == 0.f && n[2] == 0.f;
  };
  return isThin(this->A) || isThin(this->B);
}

//------------------------------------------------------------------------------
// Only frames of several samples extrapolate.
bool PixelCauses::IsDarkerInSamples(std::size_t pixel) const
{
  const auto isDarker = [&](const Frame& own, const Frame& other) {
    bool isDark = GetSamples(own) > 1;
    for (int c = 0; c < this->CountLevels(); ++c)
    {
      isDark = isDark && own.Level(pixel, c) <= other.Level(pixel, c) + this->Bounds.ColorLevels;
    }
    return isDark;
  };
  return isDarker(this->A, this->B) || isDarker(this->B, this->A);
}

//------------------------------------------------------------------------------
// Projects the boxes around translucent objects to the picture, once for all pixels.
void PixelCauses::ProjectTranslucent()
{
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<Change>& changes =
      side == 0 ? this->Objects.GetBeforeChanges() : this->Objects.GetAfterChanges();
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      if (changes[i].IsTranslucent)
      {
        this->Translucent[side].push_back({ i, this->ProjectBox(changes[i].Bounds) });
      }
    }
  }
}

//------------------------------------------------------------------------------
// Explains other layers of volumes. Their places are where a march along the ray ends, which
// rounding shifts within what the neighbours show.
int PixelCauses::JudgeVolumes(std::size_t pixel)
{
  const auto isBoth = [](const auto& a, const auto& b) { return !a.empty() && !b.empty(); };
  bool differs = false;
  if (isBoth(this->A.VolumeOpacity, this->B.VolumeOpacity))
  {
    const float a = this->A.VolumeOpacity[pixel];
    const float b = this->B.VolumeOpacity[pixel];
    this->IsDifferent = this->IsDifferent || !IsEqual(a, b);
    differs = !IsEqual(a, b) && !(std::abs(a - b) <= this->Bounds.ColorLevels / 255.0);
  }
  if (isBoth(this->A.VolumeDepth, this->B.VolumeDepth))
  {
    const float a = this->A.VolumeDepth[pixel];
    const float b = this->B.VolumeDepth[pixel];
    this->IsDifferent = this->IsDifferent || !IsEqual(a, b);
    const double footprint = this->A.GetFootprintAt(std::isfinite(a) ? a : b);
    differs = differs ||
      (!IsEqual(a, b) &&
        !this->IsBetween(pixel, OfVolumes * footprint,
          [](const Frame& frame, std::size_t at) { return frame.VolumeDepth[at]; }));
  }
  const int ids[2] = { this->A.VolumeId.empty() ? -1 : this->A.VolumeId[pixel],
    this->B.VolumeId.empty() ? -1 : this->B.VolumeId[pixel] };
  if (!differs)
  {
    return Alike;
  }
  for (std::size_t side = 0; side < 2; ++side)
  {
    const int finding = this->VolumesChanged.GetFinding(side, ids[side]);
    if (finding >= 0)
    {
      return finding;
    }
  }
  for (const Cover& cover : this->Volumes)
  {
    if (this->Covers(cover, pixel))
    {
      return static_cast<int>(cover.Object);
    }
  }
  return this->List.Find(Cause::Translucent, "volume", "", std::max(ids[0], ids[1]));
}

//------------------------------------------------------------------------------
std::array<double, 4> PixelCauses::ProjectBox(const std::array<double, 6>& bounds) const
{
  constexpr double Most = 1e300;
  std::array<double, 4> range = { Most, -Most, Most, -Most };
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
      bounds[4 + (corner >> 2)] };
    double place[2];
    if (!this->A.Project(point, place))
    {
      return { -Most, Most, -Most, Most }; // the box reaches behind the camera
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      range[2 * i] = std::min(range[2 * i], place[i]);
      range[2 * i + 1] = std::max(range[2 * i + 1], place[i]);
    }
  }
  return range;
}

//------------------------------------------------------------------------------
bool PixelCauses::Covers(const Cover& cover, std::size_t pixel) const
{
  const double x = static_cast<double>(pixel % static_cast<std::size_t>(this->A.Size[0])) + 0.5;
  const double y = static_cast<double>(pixel / static_cast<std::size_t>(this->A.Size[0])) + 0.5;
  const std::array<double, 4>& range = cover.Range;
  return x >= range[0] - 1. && x <= range[1] + 1. && y >= range[2] - 1. && y <= range[3] + 1.;
}

//------------------------------------------------------------------------------
// Explains a pixel where only the picture differs. `causes` are those found before, or Pending.
int PixelCauses::Explain(std::size_t pixel, const std::vector<int>& causes)
{
  const bool hasLayers = !this->A.Actor.empty() && !this->B.Actor.empty();
  const int actor = hasLayers ? this->A.Actor[pixel] : -1;
  // A surface that catches shadows is translucent, and appears in no layer.
  const std::vector<Cover>& covers = this->Translucent[0];
  const auto catcher =
    actor >= 0 ? covers.end() : std::find_if(covers.begin(), covers.end(), [&](const Cover& cover) {
      return this->Objects.GetBeforeChanges()[cover.Object].IsSame && this->Covers(cover, pixel);
    });
  for (const LightPair& pair : this->Lights)
  {
    if (pair.Finding >= 0 && (actor >= 0 || !hasLayers || catcher != covers.end()))
    {
      return pair.Finding;
    }
  }
  const Change& own = this->Objects.OfBefore(actor);
  for (const int found : { own.Color, own.Settings })
  {
    if (found >= 0)
    {
      return found;
    }
  }
  bool isEdge = hasLayers && this->IsEdge(pixel);
  if ((isEdge || this->Smoother) && this->IsBetweenNeighbours(pixel, 0.0))
  {
    return WithinEdge;
  }
  if (hasLayers && this->Smoother)
  {
    // With other numbers of samples, pixels near edges mix surfaces, and pixels at borders of cells
    // show cells whose values were extrapolated to the pixel's centre, from at most a pixel away:
    // by as much as the neighbours' values differ. A place that is extrapolated into the surface
    // is dark, in a single pixel.
    bool isBorder = false;
    bool isThin = false;
    int different = 0;
    this->ForNeighbours(pixel, [&](std::size_t near) {
      isThin = isThin || this->IsThin(near);
      isEdge = isEdge || this->IsEdge(near);
      isBorder = isBorder || (!this->A.Cell.empty() && this->A.Cell[near] != this->A.Cell[pixel]);
      different += causes[near] == Pending ? 1 : 0;
    });
    const bool isOneShadow = different == 1 && !this->A.Shadow.empty() && !this->B.Shadow.empty() &&
      this->IsDarkerInSamples(pixel);
    if ((isEdge && (isThin || this->IsMixture(pixel))) ||
      (isBorder && (isOneShadow || this->IsBetweenNeighbours(pixel, 1.0))))
    {
      return WithinEdge;
    }
  }
  const int layer = this->JudgeWithinLimits(pixel);
  if (layer >= 0)
  {
    return layer;
  }
  for (const Cover& cover : this->Volumes)
  {
    if (this->Covers(cover, pixel))
    {
      return static_cast<int>(cover.Object);
    }
  }
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<Change>& changes =
      side == 0 ? this->Objects.GetBeforeChanges() : this->Objects.GetAfterChanges();
    for (const Cover& cover : this->Translucent[side])
    {
      const Change& change = changes[cover.Object];
      const int found = !change.IsSame ? change.Finding
        : change.Color >= 0            ? change.Color
                                       : change.Settings;
      if (found >= 0 && this->Covers(cover, pixel))
      {
        const Finding& of = this->List.Get()[static_cast<std::size_t>(found)];
        return this->List.Find(Cause::Translucent, of.Kind, of.Name, of.Id);
      }
    }
  }
  if (this->Overlay >= 0)
  {
    return this->Overlay;
  }
  if (catcher != covers.end() && this->Objects.AnyChanged())
  {
    return this->NameActor(Cause::Shadow, static_cast<int>(catcher->Object));
  }
  for (const int found : { this->Tone, this->Settings })
  {
    if (found >= 0)
    {
      return found;
    }
  }
  // Single samples of occlusion by a changed object, which the layer can show otherwise than the
  // picture does.
  for (const Frame* frame : { &this->A, &this->B })
  {
    const Layer* ambient = Find(frame->Stages, "ambient");
    if (ambient && ambient->Components == 1 && ambient->Values[pixel] < 1.f &&
      this->Objects.AnyChanged())
    {
      return this->List.Find(Cause::Ambient, "picture");
    }
  }
  return Unexplained;
}
}
