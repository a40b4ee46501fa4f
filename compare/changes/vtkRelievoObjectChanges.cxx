// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoObjectChanges.h"

#include "vtkRelievoNearestPoints.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace relievo::compare
{
namespace
{
using Vector = std::array<double, 3>;

// For an object that has changed or moved, the number of near objects of the other frame that are
// tried: trying all would take the square of their number.
constexpr std::size_t MostTries = 32;

// The number of translations after which objects that have moved are looked for, and the number of
// objects that are tried there.
constexpr std::size_t MostTranslations = 8;
constexpr std::size_t TriesThere = 4;

Vector Minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Plus(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

double Length(const Vector& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::size_t CountObjects(const Frame& frame)
{
  const auto most = std::max_element(frame.Actor.begin(), frame.Actor.end());
  return frame.HasRecord                     ? frame.Objects.size()
    : most == frame.Actor.end() || *most < 0 ? 0
                                             : static_cast<std::size_t>(*most) + 1;
}

std::int64_t GetKey(const Frame& frame, std::size_t pixel)
{
  const std::int64_t block = frame.Block.empty() ? 0 : frame.Block[pixel];
  const int cell = frame.Cell.empty() ? 0 : frame.Cell[pixel];
  return block * (std::int64_t(1) << 32) + static_cast<std::uint32_t>(cell);
}

// Whether points have the same spread around moved centres, except for the rounding of floats. If
// only one of many points moves, the spread changes more than the centre.
bool IsSpreadAlike(const Object& a, const Object& b)
{
  const double size = std::sqrt(a.Spread[0] + a.Spread[4] + a.Spread[8]);
  const double most = 1e-6 * size * (size + Length(a.Center) + Length(b.Center));
  const double moved = Length(Minus(a.Center, b.Center));
  bool isAlike = size > 0.0 && moved > 1e-4 * size;
  for (std::size_t i = 0; i < 9; ++i)
  {
    isAlike = isAlike && std::abs(a.Spread[i] - b.Spread[i]) <= most;
  }
  return isAlike;
}

// The shared part of two boxes, as a fraction of the larger one's size in each direction.
double GetSharedBox(const std::array<double, 6>& a, const std::array<double, 6>& b)
{
  double shared = 1.0;
  for (std::size_t i = 0; i < 6; i += 2)
  {
    const double both = std::min(a[i + 1], b[i + 1]) - std::max(a[i], b[i]);
    const double most = std::max(a[i + 1] - a[i], b[i + 1] - b[i]);
    shared *= both < 0.0 ? 0.0 : most > 0.0 ? both / most : 1.0;
  }
  return shared;
}

// The blocks of a record by number; damaged entries are left out.
std::map<int, nlohmann::json> ListBlocks(const nlohmann::json& blocks)
{
  std::map<int, nlohmann::json> found;
  for (std::size_t i = 0; blocks.is_array() && i < blocks.size(); ++i)
  {
    const auto number = blocks[i].is_object() ? blocks[i].find("block") : blocks[i].end();
    if (blocks[i].is_object() && number != blocks[i].end() && number->is_number_integer())
    {
      found[number->get<int>()] = blocks[i];
    }
  }
  return found;
}

struct BlockChanges
{
  std::vector<std::string> Visibility; // "block 3 (wing) hidden"
  bool Color = false, Opacity = false;
};

// Blocks without an attribute have that of the object.
BlockChanges CompareBlocks(const nlohmann::json& before, const nlohmann::json& after)
{
  BlockChanges changes;
  if (before.is_null() || after.is_null() || before == after)
  {
    return changes;
  }
  const std::map<int, nlohmann::json> from = ListBlocks(before), to = ListBlocks(after);
  std::map<int, nlohmann::json> all = from;
  all.insert(to.begin(), to.end());
  for (const auto& [number, block] : all)
  {
    const auto get = [number = number](const std::map<int, nlohmann::json>& blocks,
                       const char* name, const nlohmann::json& otherwise) {
      const auto found = blocks.find(number);
      return found == blocks.end() ? otherwise : found->second.value(name, otherwise);
    };
    const nlohmann::json shown = get(to, "visible", true);
    if (get(from, "visible", true) != shown)
    {
      const auto name = block.find("name");
      const bool isNamed = name != block.end() && name->is_string();
      changes.Visibility.push_back("block " + std::to_string(number) +
        (isNamed ? " (" + name->get<std::string>() + ")" : "") +
        (shown == false ? " hidden" : " shown"));
    }
    changes.Color = changes.Color || get(from, "color", nullptr) != get(to, "color", nullptr);
    changes.Opacity =
      changes.Opacity || get(from, "opacity", nullptr) != get(to, "opacity", nullptr);
  }
  return changes;
}

std::array<double, 16> Translation(const Vector& t)
{
  return { 1., 0., 0., t[0], 0., 1., 0., t[1], 0., 0., 1., t[2], 0., 0., 0., 1. };
}
}

//------------------------------------------------------------------------------
ObjectChanges::ObjectChanges(
  const Frame& before, const Frame& after, const Limits& limits, CauseList& list)
  : A(before)
  , B(after)
  , Bounds(limits)
  , List(list)
{
  const std::size_t counts[2] = { CountObjects(before), CountObjects(after) };
  this->After.assign(counts[0], -1);
  this->Before.assign(counts[1], -1);
  this->BeforeChanges.resize(counts[0]);
  this->AfterChanges.resize(counts[1]);
  for (int side = 0; side < 2; ++side)
  {
    this->Seen[side].resize(counts[side]);
    this->AllPatches[side].resize(counts[side]);
    const std::vector<int>& actors = (side == 0 ? before : after).Actor;
    for (std::size_t i = 0; i < actors.size(); ++i)
    {
      if (actors[i] >= 0)
      {
        this->Seen[side][static_cast<std::size_t>(actors[i])].push_back(i);
      }
    }
  }
  if (before.HasRecord && after.HasRecord)
  {
    this->MatchByRecord();
    this->MatchByBounds();
    this->ChangeByRecord();
  }
  else if (!before.Actor.empty() && !after.Actor.empty())
  {
    this->MatchBySight();
    this->ChangeBySight();
  }
}

//------------------------------------------------------------------------------
void ObjectChanges::Pair(int before, int after)
{
  this->After[static_cast<std::size_t>(before)] = after;
  this->Before[static_cast<std::size_t>(after)] = before;
}

//------------------------------------------------------------------------------
bool ObjectChanges::AnyChanged() const
{
  const auto changed = [](const Change& each) { return !each.IsSame; };
  return std::any_of(this->BeforeChanges.begin(), this->BeforeChanges.end(), changed) ||
    std::any_of(this->AfterChanges.begin(), this->AfterChanges.end(), changed);
}

//------------------------------------------------------------------------------
std::string ObjectChanges::GetName(int object) const
{
  const auto nameOf = [](const Frame& frame, int number) {
    return number >= 0 && number < static_cast<int>(frame.Objects.size())
      ? frame.Objects[static_cast<std::size_t>(number)].Name
      : std::string();
  };
  const std::string name = nameOf(this->A, object);
  return name.empty() ? nameOf(this->B, this->GetAfter(object)) : name;
}

//------------------------------------------------------------------------------
// Matches by the most reliable keys first, and among objects with equal keys the nearest ones.
void ObjectChanges::MatchByRecord()
{
  using Text = std::function<std::string(const Object& object)>;
  const auto place = [](const Object& object) {
    std::string text;
    for (const double each : object.Matrix)
    {
      text += std::to_string(each) + " ";
    }
    return text;
  };
  const auto mesh = [](const Object& o) { return o.Points + " " + o.Cells; };
  // The last three keys are for pairs with an unnamed object, which may have moved: equal meshes
  // with different names in different places are different objects.
  const std::pair<Text, bool> keys[] = { { [&](const Object& o) {
                                            return o.Name.empty()
                                              ? ""
                                              : o.Name + "\n" + mesh(o) + "\n" + place(o);
                                          },
                                           true },
    { [&](const Object& o) { return o.Name.empty() ? "" : o.Name + "\n" + mesh(o); }, true },
    { [](const Object& o) { return o.Name; }, true },
    { [&](const Object& o) { return mesh(o) + "\n" + place(o); }, true }, { mesh, false },
    { [](const Object& o) { return o.Cells; }, false },
    { [](const Object& o) { return o.Points; }, false } };
  for (const auto& [key, takesNames] : keys)
  {
    std::map<std::string, std::pair<std::vector<int>, std::vector<int>>> groups;
    for (std::size_t i = 0; i < this->A.Objects.size(); ++i)
    {
      if (this->After[i] < 0)
      {
        groups[key(this->A.Objects[i])].first.push_back(static_cast<int>(i));
      }
    }
    for (std::size_t i = 0; i < this->B.Objects.size(); ++i)
    {
      if (this->Before[i] < 0)
      {
        groups[key(this->B.Objects[i])].second.push_back(static_cast<int>(i));
      }
    }
    for (const auto& [text, members] : groups)
    {
      if (text.empty())
      {
        continue;
      }
      for (const bool isNamed : { false, true }) // in the frame before
      {
        if (isNamed && takesNames)
        {
          continue; // done with the unnamed ones
        }
        std::vector<int> numbers[2];
        std::vector<Vector> centers[2];
        for (std::size_t side = 0; side < 2; ++side)
        {
          for (const int number : side == 0 ? members.first : members.second)
          {
            const auto object = static_cast<std::size_t>(number);
            const Object& of = (side == 0 ? this->A : this->B).Objects[object];
            const bool isFree = (side == 0 ? this->After : this->Before)[object] < 0;
            const bool fits =
              takesNames || (side == 0 ? of.Name.empty() != isNamed : !isNamed || of.Name.empty());
            if (isFree && fits)
            {
              numbers[side].push_back(number);
              centers[side].push_back(of.Center);
            }
          }
        }
        PairNearest(centers[0], centers[1], 1, [&](std::size_t a, std::size_t b) {
          this->Pair(numbers[0][a], numbers[1][b]);
          return true;
        });
      }
    }
  }
}

//------------------------------------------------------------------------------
// Matches unnamed objects whose meshes have changed, if their boxes overlap by more than half,
// those with the nearest bounds first: nested surfaces have one centre.
void ObjectChanges::MatchByBounds()
{
  std::vector<int> left[2];
  std::vector<std::array<double, 6>> boxes[2];
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<int>& matches = side == 0 ? this->After : this->Before;
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
      if (matches[i] < 0)
      {
        left[side].push_back(static_cast<int>(i));
        boxes[side].push_back((side == 0 ? this->A : this->B).Objects[i].Bounds);
      }
    }
  }
  PairNearest(boxes[0], boxes[1], MostTries, [&](std::size_t i, std::size_t j) {
    const Object& from = this->A.Objects[static_cast<std::size_t>(left[0][i])];
    const Object& to = this->B.Objects[static_cast<std::size_t>(left[1][j])];
    const bool fits =
      GetSharedBox(from.Bounds, to.Bounds) > 0.5 && (from.Name.empty() || to.Name.empty());
    if (fits)
    {
      this->Pair(left[0][i], left[1][j]);
    }
    return fits;
  });
}

//------------------------------------------------------------------------------
void ObjectChanges::AddChange(int before, int after, Cause cause, const std::string& words)
{
  const bool isNew = before < 0;
  const std::string name = isNew
    ? this->B.Objects.empty() ? "" : this->B.Objects[static_cast<std::size_t>(after)].Name
    : this->GetName(before);
  const int place = this->List.Find(cause, "actor", name, isNew ? after : before);
  if (!words.empty())
  {
    this->List.At(place).Words = words;
  }
  for (Change* change : { isNew ? nullptr : &this->BeforeChanges[static_cast<std::size_t>(before)],
         after < 0 ? nullptr : &this->AfterChanges[static_cast<std::size_t>(after)] })
  {
    if (change)
    {
      change->IsSame = false;
      change->Finding = place;
    }
  }
}

//------------------------------------------------------------------------------
void ObjectChanges::AddMove(
  int object, const std::array<double, 16>& transform, const Vector& displacement)
{
  double largest = -1.0;
  for (const std::size_t i : this->Seen[0][static_cast<std::size_t>(object)])
  {
    if (!this->A.HasPositions())
    {
      break;
    }
    const Vector from = this->A.GetPosition(i);
    Vector to{};
    for (std::size_t r = 0; r < 3; ++r)
    {
      to[r] = transform[4 * r] * from[0] + transform[4 * r + 1] * from[1] +
        transform[4 * r + 2] * from[2] + transform[4 * r + 3];
    }
    double places[2][2];
    if (this->A.Project(from.data(), places[0]) && this->A.Project(to.data(), places[1]))
    {
      largest =
        std::max(largest, std::hypot(places[1][0] - places[0][0], places[1][1] - places[0][1]));
    }
  }
  const bool turns = std::any_of(transform.begin(), transform.begin() + 12, [&](const double& v) {
    const auto at = static_cast<std::size_t>(&v - transform.data());
    return at % 4 != 3 && std::abs(v - (at % 5 == 0 ? 1.0 : 0.0)) > 1e-12;
  });
  std::string words = "moved by " + WriteVector(displacement) + (turns ? ", turned" : "");
  if (largest >= 0.0)
  {
    words += ", at most " + WriteShort(largest) + " pixels";
  }
  this->AddChange(object, this->GetAfter(object), Cause::Moved, words);
  Finding& finding = this->List.At(this->BeforeChanges[static_cast<std::size_t>(object)].Finding);
  finding.More["displacement"] = displacement;
  if (largest >= 0.0)
  {
    finding.More["largest"] = largest;
  }
}

//------------------------------------------------------------------------------
void ObjectChanges::CompareSettings(int before, int after)
{
  constexpr char OfBlocks[] = "opacity of blocks";
  static const std::set<std::string> coverage = { "representation", "opacity", "edges",
    "line_width", "point_size", "frontface_culling", "backface_culling", OfBlocks };
  const Object& from = this->A.Objects[static_cast<std::size_t>(before)];
  const Object& to = this->B.Objects[static_cast<std::size_t>(after)];
  Change* changes[2] = { &this->BeforeChanges[static_cast<std::size_t>(before)],
    &this->AfterChanges[static_cast<std::size_t>(after)] };
  const BlockChanges blocks = CompareBlocks(from.Blocks, to.Blocks);
  if (blocks.Color || (!from.Color.is_null() && !to.Color.is_null() && from.Color != to.Color))
  {
    changes[0]->Color = changes[1]->Color =
      this->List.Find(Cause::Color, "actor", this->GetName(before), before);
  }
  std::vector<std::string> names = ListChanges(from.Settings, to.Settings);
  if (blocks.Opacity)
  {
    names.emplace_back(OfBlocks);
  }
  const bool affectsCoverage = std::any_of(
    names.begin(), names.end(), [](const std::string& name) { return coverage.count(name) != 0; });
  if (!names.empty())
  {
    const int place = this->List.Find(Cause::Settings, "actor", this->GetName(before), before);
    this->List.At(place).Words = "settings: " + Join(names);
    this->List.At(place).More["settings"] = Join(names);
    for (Change* change : changes)
    {
      change->Settings = place;
      change->Coverage = affectsCoverage ? place : -1;
    }
  }
}

//------------------------------------------------------------------------------
void ObjectChanges::ChangeByRecord()
{
  for (int a = 0; a < static_cast<int>(this->After.size()); ++a)
  {
    const Object& from = this->A.Objects[static_cast<std::size_t>(a)];
    const int b = this->GetAfter(a);
    Change& change = this->BeforeChanges[static_cast<std::size_t>(a)];
    change.IsTranslucent = from.Translucent;
    change.Bounds = from.Bounds;
    if (b < 0)
    {
      this->AddChange(a, -1, Cause::Removed, "");
      continue;
    }
    const Object& to = this->B.Objects[static_cast<std::size_t>(b)];
    this->AfterChanges[static_cast<std::size_t>(b)].IsTranslucent = to.Translucent;
    this->AfterChanges[static_cast<std::size_t>(b)].Bounds = to.Bounds;
    this->CompareSettings(a, b);
    if (from.Visible != to.Visible)
    {
      this->AddChange(a, b, Cause::Visibility, from.Visible ? "hidden" : "shown");
    }
    else if (!from.Glyphs.empty() && !to.Glyphs.empty() && from.Glyphs != to.Glyphs)
    {
      this->AddChange(a, b, Cause::Shape, "shape: other glyphs");
    }
    else if (from.Points == to.Points && from.Cells == to.Cells)
    {
      if (from.Matrix != to.Matrix)
      {
        std::array<double, 16> back{}, transform{};
        vtkMatrix4x4::Invert(from.Matrix.data(), back.data());
        vtkMatrix4x4::Multiply4x4(to.Matrix.data(), back.data(), transform.data());
        this->AddMove(a, transform, Minus(to.Center, from.Center));
      }
      else if (!from.Clipping.is_null() && !to.Clipping.is_null() && from.Clipping != to.Clipping)
      {
        this->AddChange(a, b, Cause::Visibility, "visibility: clipping planes");
      }
      else if (const BlockChanges blocks = CompareBlocks(from.Blocks, to.Blocks);
               !blocks.Visibility.empty())
      {
        this->AddChange(a, b, Cause::Visibility, "visibility: " + Join(blocks.Visibility));
      }
    }
    else
    {
      // Moving all points by one vector equals a change of the matrix.
      const Vector displacement = Minus(to.Center, from.Center);
      if (from.Cells == to.Cells && IsSpreadAlike(from, to) && from.Matrix == to.Matrix)
      {
        this->AddMove(a, Translation(displacement), displacement);
      }
      else
      {
        this->AddChange(a, b, Cause::Shape,
          from.Cells == to.Cells ? "shape: other points" : "shape: other cells");
      }
    }
  }
  for (int b = 0; b < static_cast<int>(this->Before.size()); ++b)
  {
    if (this->GetBefore(b) < 0)
    {
      const Object& object = this->B.Objects[static_cast<std::size_t>(b)];
      this->AfterChanges[static_cast<std::size_t>(b)].IsTranslucent = object.Translucent;
      this->AfterChanges[static_cast<std::size_t>(b)].Bounds = object.Bounds;
      this->AddChange(-1, b, Cause::Added, "");
    }
  }
}

//------------------------------------------------------------------------------
bool ObjectChanges::DiffersInDepth(
  const Frame& before, const Frame& after, std::size_t pixel, const Limits& limits)
{
  if (!before.HasDepths() || !after.HasDepths())
  {
    return false;
  }
  const double a = before.GetDepth(pixel);
  const double b = after.GetDepth(pixel);
  const double difference = std::abs(a - b);
  // The difference is NaN if a depth is NaN, or both are infinite.
  if (a == b || !(difference > 4.0 * std::numeric_limits<float>::epsilon() * std::abs(a)))
  {
    return std::isnan(a) != std::isnan(b);
  }
  const auto width = static_cast<std::size_t>(before.Size[0]);
  double slope = 0.0;
  for (const std::size_t step : { std::size_t(1), width })
  {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t column = pixel % width;
    const bool isBelow = step == 1 ? column > 0 : pixel >= width;
    const bool isAbove = step == 1 ? column + 1 < width : pixel + width < before.Pixels;
    for (const std::size_t other :
      { isBelow ? pixel - step : pixel, isAbove ? pixel + step : pixel })
    {
      if (other != pixel && (before.Actor.empty() || before.Actor[other] == before.Actor[pixel]))
      {
        least = std::min(least, std::abs(before.GetDepth(other) - a));
      }
    }
    slope += std::isfinite(least) ? least : 0.0;
  }
  return difference >
    4.0 * std::numeric_limits<float>::epsilon() * std::abs(a) + limits.DepthPixels * slope;
}

//------------------------------------------------------------------------------
const ObjectChanges::Patches& ObjectChanges::GetPatches(int object, bool isBefore) const
{
  const Frame& frame = isBefore ? this->A : this->B;
  Patches& patches = this->AllPatches[isBefore ? 0 : 1][static_cast<std::size_t>(object)];
  if (!patches.empty() || !frame.HasPositions())
  {
    return patches;
  }
  const auto width = static_cast<std::size_t>(frame.Size[0]);
  for (const std::size_t i : this->Seen[isBefore ? 0 : 1][static_cast<std::size_t>(object)])
  {
    const std::int64_t key = GetKey(frame, i);
    const Vector place = frame.GetPosition(i);
    Patch& patch = patches[key];
    ++patch.Pixels;
    for (std::size_t c = 0; c < 3; ++c)
    {
      patch.Sum[c] += place[c];
    }
    const auto isSame = [&](std::size_t other) {
      return frame.Actor[other] == object && GetKey(frame, other) == key;
    };
    const std::size_t column = i % width;
    patch.IsWhole =
      patch.IsWhole && column > 0 && column + 1 < width && i >= width && i + width < frame.Pixels;
    for (const std::size_t other :
      { i - 1, i + 1, i - width, i + width }) // inside the picture while IsWhole
    {
      const bool isOwn = patch.IsWhole && frame.Actor[other] == object;
      const double nearer = isOwn ? 4.0 * frame.GetFootprint(i) : 0.0;
      patch.IsWhole = patch.IsWhole &&
        (isOwn && GetKey(frame, other) == key
            ? true
            : !(frame.GetDepth(other) < frame.GetDepth(i) - nearer));
    }
    if ((i + 1) % width != 0 && i + width < frame.Pixels && isSame(i + 1) && isSame(i + width))
    {
      const Vector right = Minus(frame.GetPosition(i + 1), place);
      const Vector up = Minus(frame.GetPosition(i + width), place);
      double normal[3];
      vtkMath::Cross(right.data(), up.data(), normal);
      for (std::size_t c = 0; c < 3; ++c)
      {
        patch.Normal[c] += normal[c];
      }
    }
  }
  return patches;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> ObjectChanges::FindTranslation(int before, int after) const
{
  struct Pairing
  {
    Vector Offset, Normal;
    double Weight;
    bool IsPlane, IsWhole;
  };
  std::vector<Pairing> pairings;
  const Patches& from = this->GetPatches(before, true);
  const Patches& to = this->GetPatches(after, false);
  double matrix[3][3] = {}, right[3] = {};
  constexpr double OfCenters = 1e-6; // weight of centres, which are accurate to a pixel only
  for (const auto& [key, patch] : from)
  {
    const auto found = to.find(key);
    if (found == to.end())
    {
      continue;
    }
    Pairing pairing{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      pairing.Offset[c] = found->second.Sum[c] / found->second.Pixels - patch.Sum[c] / patch.Pixels;
      pairing.Normal[c] = patch.Normal[c];
    }
    pairing.Weight = std::min(patch.Pixels, found->second.Pixels);
    const double length = Length(pairing.Normal);
    pairing.IsPlane = length > 0.0;
    pairing.IsWhole = patch.IsWhole && found->second.IsWhole;
    for (std::size_t r = 0; r < 3; ++r)
    {
      pairing.Normal[r] /= pairing.IsPlane ? length : 1.0;
    }
    for (std::size_t r = 0; r < 3; ++r)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double plane = pairing.IsPlane ? pairing.Normal[r] * pairing.Normal[c] : 0.0;
        matrix[r][c] += pairing.Weight * (plane + (r == c ? OfCenters : 0.0));
        right[r] += pairing.Weight * (plane + (r == c ? OfCenters : 0.0)) * pairing.Offset[c];
      }
    }
    pairings.push_back(pairing);
  }
  // Some of the object's cells may be hidden, but not most.
  if (pairings.empty() || 2 * pairings.size() < std::min(from.size(), to.size()))
  {
    return std::nullopt;
  }
  Vector found{};
  vtkMath::LinearSolve3x3(matrix, right, found.data());
  double planes = 0.0, ofPlanes = 0.0, centers = 0.0, ofCenters = 0.0, all = 0.0, near = 0.0;
  const double footprint =
    this->A.GetFootprint(this->Seen[0][static_cast<std::size_t>(before)].front());
  for (const Pairing& pairing : pairings)
  {
    const Vector off = Minus(pairing.Offset, found);
    (pairing.IsPlane ? planes : centers) +=
      pairing.Weight * (pairing.IsPlane ? std::pow(Dot(off, pairing.Normal), 2.0) : Dot(off, off));
    (pairing.IsPlane ? ofPlanes : ofCenters) += pairing.Weight;
    // The planes of two different boxes coincide after a translation, but the centres of their
    // cells do not. Centres of partly hidden cells are less accurate.
    const double most = pairing.IsWhole ? 0.6 : 1.0 + 0.25 * std::sqrt(pairing.Weight);
    all += pairing.Weight;
    near += Length(off) <= most * footprint ? pairing.Weight : 0.0;
  }
  const double most = 0.05 * footprint + 1e-6 * Length(found);
  const bool fits = near >= 0.8 * all &&
    (ofPlanes == 0.0 || std::sqrt(planes / ofPlanes) <= most) &&
    (ofCenters == 0.0 || std::sqrt(centers / ofCenters) <= footprint);
  return fits ? std::optional<Vector>(found) : std::nullopt;
}

//------------------------------------------------------------------------------
// Pixels that show the same cell at the same place vote for a pair of objects; objects without
// votes match if a translation moves the cells of one to those of the other.
void ObjectChanges::MatchBySight()
{
  std::map<std::pair<int, int>, std::size_t> votes;
  for (std::size_t i = 0; i < this->A.Actor.size(); ++i)
  {
    if (this->A.Actor[i] >= 0 && this->B.Actor[i] >= 0 &&
      GetKey(this->A, i) == GetKey(this->B, i) &&
      !DiffersInDepth(this->A, this->B, i, this->Bounds))
    {
      ++votes[{ this->A.Actor[i], this->B.Actor[i] }];
    }
  }
  std::vector<std::tuple<std::size_t, int, int>> pairs;
  for (const auto& [pair, count] : votes)
  {
    pairs.emplace_back(count, pair.first, pair.second);
  }
  std::sort(pairs.rbegin(), pairs.rend());
  for (const auto& [count, a, b] : pairs)
  {
    if (this->GetAfter(a) < 0 && this->GetBefore(b) < 0)
    {
      this->Pair(a, b);
    }
  }
  this->MatchMoved();
  // An object that deforms keeps its number, if both frames still have that number free.
  for (int a = 0; a < static_cast<int>(std::min(this->After.size(), this->Before.size())); ++a)
  {
    const auto object = static_cast<std::size_t>(a);
    const bool isFree = this->After[object] < 0 && this->Before[object] < 0;
    const bool isSeen = !this->Seen[0][object].empty() && !this->Seen[1][object].empty();
    if (isFree && isSeen)
    {
      const Patches& from = this->GetPatches(a, true);
      const Patches& to = this->GetPatches(a, false);
      const auto shared = std::count_if(
        from.begin(), from.end(), [&](const auto& each) { return to.count(each.first) != 0; });
      if (2 * static_cast<std::size_t>(shared) >= std::max(from.size(), to.size()))
      {
        this->Pair(a, a);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Visible objects without a match may have moved: pairs the nearest ones that a translation moves
// onto each other. Between the places of an assembly's part, before and after, can be many other
// parts: then the nearest ones after the translations that are found for most objects.
void ObjectChanges::MatchMoved()
{
  std::vector<int> left[2];
  std::vector<Vector> centers[2];
  double footprint = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<int>& matches = side == 0 ? this->After : this->Before;
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
      const std::vector<std::size_t>& pixels = this->Seen[side][i];
      if (matches[i] < 0 && !pixels.empty())
      {
        left[side].push_back(static_cast<int>(i));
        Vector sum{};
        for (const auto& [key, patch] : this->GetPatches(static_cast<int>(i), side == 0))
        {
          std::transform(sum.begin(), sum.end(), patch.Sum.begin(), sum.begin(), std::plus<>());
        }
        const auto count = static_cast<double>(pixels.size());
        centers[side].push_back({ sum[0] / count, sum[1] / count, sum[2] / count });
        footprint =
          std::max(footprint, (side == 0 ? this->A : this->B).GetFootprint(pixels.front()));
      }
    }
  }
  const auto isFree = [&](std::size_t side, int object) {
    return (side == 0 ? this->GetAfter(object) : this->GetBefore(object)) < 0;
  };
  // The numbers of objects with equal translations, up to a few pixels, and one of these.
  std::map<Vector, std::pair<std::size_t, Vector>> translations;
  const auto count = [&](const Vector& translation) {
    Vector key{};
    for (std::size_t c = 0; c < 3 && footprint > 0.0; ++c)
    {
      key[c] = std::round(translation[c] / (4.0 * footprint));
    }
    ++translations.emplace(key, std::pair(std::size_t(0), translation)).first->second.first;
  };
  const auto pairNearest = [&](const Vector& shift, std::size_t tries) {
    std::vector<int> objects[2];
    std::vector<Vector> places[2];
    for (std::size_t side = 0; side < 2; ++side)
    {
      for (std::size_t i = 0; i < left[side].size(); ++i)
      {
        if (isFree(side, left[side][i]))
        {
          objects[side].push_back(left[side][i]);
          places[side].push_back(side == 0 ? Plus(centers[0][i], shift) : centers[1][i]);
        }
      }
    }
    PairNearest(places[0], places[1], tries, [&](std::size_t a, std::size_t b) {
      const auto translation = this->FindTranslation(objects[0][a], objects[1][b]);
      if (translation)
      {
        this->Pair(objects[0][a], objects[1][b]);
        count(*translation);
      }
      return translation.has_value();
    });
  };
  pairNearest({}, MostTries);
  for (const int object : left[0])
  {
    // Most objects keep their numbers.
    const auto number = static_cast<std::size_t>(object);
    const bool isSeen = number < this->Before.size() && !this->Seen[1][number].empty();
    if (isSeen && isFree(0, object) && isFree(1, object))
    {
      if (const auto translation = this->FindTranslation(object, object))
      {
        count(*translation);
      }
    }
  }
  std::vector<std::pair<std::size_t, Vector>> common;
  for (const auto& [key, each] : translations)
  {
    common.push_back(each);
  }
  std::sort(common.rbegin(), common.rend());
  for (std::size_t i = 0; i < std::min(common.size(), MostTranslations); ++i)
  {
    pairNearest(common[i].second, TriesThere);
  }
}

//------------------------------------------------------------------------------
// Whether all pixels of an object in one frame are behind the other frame's surfaces there.
bool ObjectChanges::IsHidden(int object, bool isBefore) const
{
  const Frame& own = isBefore ? this->A : this->B;
  const Frame& other = isBefore ? this->B : this->A;
  const std::vector<std::size_t>& pixels =
    this->Seen[isBefore ? 0 : 1][static_cast<std::size_t>(object)];
  return std::all_of(pixels.begin(), pixels.end(),
    [&](std::size_t i) { return other.GetDepth(i) < own.GetDepth(i); });
}

//------------------------------------------------------------------------------
void ObjectChanges::ChangeBySight()
{
  // Counts for each object: pixels with another depth, pixels that show it in one frame only, and
  // unchanged pixels.
  std::vector<std::size_t> elsewhere(this->After.size()), others(this->After.size()),
    there(this->After.size());
  for (std::size_t i = 0; i < this->A.Actor.size(); ++i)
  {
    const int a = this->A.Actor[i];
    const int b = this->B.Actor[i];
    if (a >= 0 && this->GetAfter(a) == b && b >= 0)
    {
      const bool differs = DiffersInDepth(this->A, this->B, i, this->Bounds);
      ++(differs ? elsewhere : there)[static_cast<std::size_t>(a)];
    }
    else
    {
      for (const int each : { a, this->GetBefore(b) })
      {
        if (each >= 0)
        {
          ++others[static_cast<std::size_t>(each)];
        }
      }
    }
  }
  for (int a = 0; a < static_cast<int>(this->After.size()); ++a)
  {
    const auto object = static_cast<std::size_t>(a);
    const int b = this->GetAfter(a);
    if (this->Seen[0][object].empty())
    {
      continue;
    }
    if (b < 0)
    {
      if (!this->IsHidden(a, true))
      {
        this->AddChange(a, -1, Cause::Removed, "");
      }
      continue;
    }
    if (elsewhere[object] + others[object] == 0)
    {
      continue;
    }
    const std::optional<Vector> translation = this->FindTranslation(a, b);
    double places[2][2] = {};
    if (translation)
    {
      const Vector from = this->A.GetPosition(this->Seen[0][object].front());
      const Vector to = { from[0] + (*translation)[0], from[1] + (*translation)[1],
        from[2] + (*translation)[2] };
      this->A.Project(from.data(), places[0]);
      this->A.Project(to.data(), places[1]);
    }
    const double shift = std::hypot(places[1][0] - places[0][0], places[1][1] - places[0][1]);
    const double grown = static_cast<double>(this->Seen[1][static_cast<std::size_t>(b)].size()) /
      static_cast<double>(this->Seen[0][object].size());
    if (translation && elsewhere[object] > 0)
    {
      this->AddMove(a, Translation(*translation), *translation);
    }
    else if (elsewhere[object] > 0 || (there[object] == 0 && !translation))
    {
      this->AddChange(a, b, Cause::Shape, "");
    }
    else if (translation && shift > 0.5 && grown > 0.9 && grown < 1.1)
    {
      this->AddMove(a, Translation(*translation), *translation); // a shift within its own plane
    }
  }
  for (int b = 0; b < static_cast<int>(this->Before.size()); ++b)
  {
    if (this->GetBefore(b) < 0 && !this->Seen[1][static_cast<std::size_t>(b)].empty() &&
      !this->IsHidden(b, false))
    {
      this->AddChange(-1, b, Cause::Added, "");
    }
  }
}
}
