// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPixelCauses.h"

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

// The part of a pixel's size by which rounding may shift the depth of a volume.
constexpr double OfVolumes = 0.25;
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
  , Frames(before, after)
  , Lights(before, after, list)
  , Records(before, after, list)
  , Boxes(before, objects, this->VolumesChanged)
  , Normals(this->Frames, objects, this->Bounds)
  , Mixtures(this->Frames, limits)
  , Causes(before.Pixels, Alike)
{
  this->PairLayers();
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
      ((this->Loose > 0.0 && this->Normals.Explains(i, this->Loose)) ||
        (this->Ambient && this->IsOfAmbient(i)));
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
      if (const Layer* other = FramePair::Find(*to, name))
      {
        add(layer.Values, other->Values, layer.Components);
      }
    }
  }
  add(this->A.VolumeDepth, this->B.VolumeDepth, 1);
  add(this->A.VolumeOpacity, this->B.VolumeOpacity, 1);
  for (const LightPairs::Pair& pair : this->Lights.Get())
  {
    const auto [from, to] = this->Lights.GetVisibility(pair);
    if (from && to)
    {
      add(*from, *to, 1);
    }
  }
}

//------------------------------------------------------------------------------
// Whether all values are bitwise equal, as at most pixels.
bool PixelCauses::IsEqualInAll(std::size_t pixel) const
{
  const bool isJudged = this->Lights.Get().empty() && !this->A.Shadow.empty();
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
int PixelCauses::NameActor(Cause cause, int object)
{
  return object < 0 ? this->List.Find(cause, "picture")
                    : this->List.Find(cause, "actor", this->Objects.GetName(object), object);
}

//------------------------------------------------------------------------------
int PixelCauses::JudgePicture(std::size_t pixel) const
{
  const auto components = static_cast<std::size_t>(this->A.Picture.Components);
  bool isEqual = this->A.IsLinear == this->B.IsLinear &&
    this->A.Picture.Components == this->B.Picture.Components;
  for (std::size_t i = pixel * components; i < (pixel + 1) * components && isEqual; ++i)
  {
    isEqual = FramePair::IsEqual(this->A.Picture.Values[i], this->B.Picture.Values[i]);
  }
  int found = Alike;
  for (int c = 0; c < this->Frames.CountLevels() && !isEqual; ++c)
  {
    const float a = this->A.Level(pixel, c);
    const float b = this->B.Level(pixel, c);
    if (!FramePair::IsEqual(a, b))
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
    this->Records.GetSettings() < 0 && this->Records.GetTone() < 0 && !this->Lights.AnyChanged();
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
  this->Frames.ForNeighbours(pixel, [&](std::size_t other) {
    hasBefore = hasBefore || isSame(pixel, other);
    hasAfter = hasAfter || isSame(other, pixel);
  });
  return (hasBefore && hasAfter) ||
    (this->A.HasRecord && this->B.HasRecord &&
      this->Frames.IsBetween(
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
    if (!FramePair::IsEqual(a.Values[i], b.Values[i]) &&
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
  const double angle = sameCell ? this->Normals.Get(pixel) : 0.0;
  const bool isLoose = angle > this->Bounds.NormalAngle;
  const bool isTurned =
    isLoose && !(this->Normals.IsMapped(a) && this->Normals.IsTexelRounded(pixel, angle));
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
    const Layer* other = FramePair::Find(this->B.Surface, name);
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
  const Layer* albedo = FramePair::Find(this->A.Surface, "albedo");
  const Layer* other = FramePair::Find(this->B.Surface, "albedo");
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
      const double off =
        FramePair::IsEqual(before, after) ? 0.0 : std::abs(double(before) - double(after));
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
    this->IsDifferent = this->IsDifferent || !FramePair::IsEqual(from[pixel], to[pixel]);
    return !FramePair::IsEqual(from[pixel], to[pixel]) &&
      !(std::abs(from[pixel] - to[pixel]) <= limit) &&
      !(this->BorderStep &&
        this->Frames.IsBetween(pixel, *this->BorderStep, [&](const Frame& frame, std::size_t at) {
          return (&frame == &this->A ? from : to)[at];
        }));
  };
  if (this->Lights.Get().empty()) // no record of lights
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
  for (const LightPairs::Pair& pair : this->Lights.Get())
  {
    const auto [from, to] = this->Lights.GetVisibility(pair);
    if (from && to && differ(*from, *to))
    {
      return pair.Finding >= 0 ? pair.Finding : this->Lights.Find(pair, Cause::Shadow);
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
    const Layer* from = FramePair::Find(this->A.Stages, name);
    const Layer* to = FramePair::Find(this->B.Stages, name);
    if (!from || !to)
    {
      continue;
    }
    this->IsDifferent = this->IsDifferent || this->DiffersInLayer(*from, *to, pixel, 0.0);
    if (this->DiffersInLayer(*from, *to, pixel, this->Bounds.ColorLevels / 255.0))
    {
      const bool isSample = cause == Cause::Ambient && this->AmbientStep && from->Components == 1 &&
        to->Components == 1 &&
        this->Frames.IsBetween(
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
  for (int c = 0; c < this->Frames.CountLevels(); ++c)
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
  this->Frames.ForNeighbours(pixel, [&](std::size_t other) {
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
// Explains other layers of volumes. Their places are where a march along the ray ends, which
// rounding shifts within the neighbours' values.
int PixelCauses::JudgeVolumes(std::size_t pixel)
{
  const auto isBoth = [](const auto& a, const auto& b) { return !a.empty() && !b.empty(); };
  bool differs = false;
  if (isBoth(this->A.VolumeOpacity, this->B.VolumeOpacity))
  {
    const float a = this->A.VolumeOpacity[pixel];
    const float b = this->B.VolumeOpacity[pixel];
    this->IsDifferent = this->IsDifferent || !FramePair::IsEqual(a, b);
    differs = !FramePair::IsEqual(a, b) && !(std::abs(a - b) <= this->Bounds.ColorLevels / 255.0);
  }
  if (isBoth(this->A.VolumeDepth, this->B.VolumeDepth))
  {
    const float a = this->A.VolumeDepth[pixel];
    const float b = this->B.VolumeDepth[pixel];
    this->IsDifferent = this->IsDifferent || !FramePair::IsEqual(a, b);
    const double footprint = this->A.GetFootprintAt(std::isfinite(a) ? a : b);
    differs = differs ||
      (!FramePair::IsEqual(a, b) &&
        !this->Frames.IsBetween(pixel, OfVolumes * footprint,
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
  const int covering = this->Boxes.FindVolume(pixel);
  return covering >= 0
    ? covering
    : this->List.Find(Cause::Translucent, "volume", "", std::max(ids[0], ids[1]));
}

//------------------------------------------------------------------------------
// Explains a pixel where only the picture differs. `causes` are those found before, or Pending.
int PixelCauses::Explain(std::size_t pixel, const std::vector<int>& causes)
{
  const bool hasLayers = !this->A.Actor.empty() && !this->B.Actor.empty();
  const int actor = hasLayers ? this->A.Actor[pixel] : -1;
  // A surface that catches shadows is translucent, and appears in no layer.
  const std::vector<PictureBoxes::Cover>& covers = this->Boxes.GetTranslucent(0);
  const auto catcher = actor >= 0
    ? covers.end()
    : std::find_if(covers.begin(), covers.end(), [&](const PictureBoxes::Cover& cover) {
        return this->Objects.GetBeforeChanges()[cover.Object].IsSame &&
          this->Boxes.Covers(cover, pixel);
      });
  for (const LightPairs::Pair& pair : this->Lights.Get())
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
  if (this->Mixtures.Explain(
        pixel, [&causes](std::size_t near) { return causes[near] == Pending; }))
  {
    return WithinEdge;
  }
  const int layer = this->JudgeWithinLimits(pixel);
  if (layer >= 0)
  {
    return layer;
  }
  const int volume = this->Boxes.FindVolume(pixel);
  if (volume >= 0)
  {
    return volume;
  }
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<Change>& changes =
      side == 0 ? this->Objects.GetBeforeChanges() : this->Objects.GetAfterChanges();
    for (const PictureBoxes::Cover& cover : this->Boxes.GetTranslucent(side))
    {
      const Change& change = changes[cover.Object];
      const int found = !change.IsSame ? change.Finding
        : change.Color >= 0            ? change.Color
                                       : change.Settings;
      if (found >= 0 && this->Boxes.Covers(cover, pixel))
      {
        const Finding& of = this->List.Get()[static_cast<std::size_t>(found)];
        return this->List.Find(Cause::Translucent, of.Kind, of.Name, of.Id);
      }
    }
  }
  if (this->Records.GetOverlay() >= 0)
  {
    return this->Records.GetOverlay();
  }
  if (catcher != covers.end() && this->Objects.AnyChanged())
  {
    return this->NameActor(Cause::Shadow, static_cast<int>(catcher->Object));
  }
  for (const int found : { this->Records.GetTone(), this->Records.GetSettings() })
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
    const Layer* ambient = FramePair::Find(frame->Stages, "ambient");
    if (ambient && ambient->Components == 1 && ambient->Values[pixel] < 1.f &&
      this->Objects.AnyChanged())
    {
      return this->List.Find(Cause::Ambient, "picture");
    }
  }
  return Unexplained;
}
}
