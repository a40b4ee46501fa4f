// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthRaster.h"

#include "vtkRelievoThreads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>

namespace
{
// Places are rounded to 1/4096 texel, and texels' centres are multiples of 4096: products of two
// differences fit 64 bits, so that the sides of edges are exact.
constexpr int Digits = 12;
constexpr std::int32_t One = 1 << Digits;
// Farther places, in texels from the map's origin, are cut off: then 29 bits suffice.
constexpr double Farthest = 1 << 17;
constexpr std::int32_t Outside = std::numeric_limits<std::int32_t>::min();

// Triangles that a thread takes at once: their corners stay in its cache.
constexpr std::size_t ChunkSize = 4096;
// Corners that are read ahead, of 16 triangles.
constexpr std::ptrdiff_t Ahead = 48;
// Triangles whose texels are read ahead, and rows of each: most texels of a map are not in the
// cache. Triangles with smaller boxes wait for too few texels to gain from it.
constexpr std::size_t Waiting = 16;
constexpr int RowsAhead = 16;
constexpr std::int64_t SmallBox = 9;
// Groups of points that a thread takes at once.
constexpr std::size_t GroupsAtOnce = 64;
// Below, starting threads takes longer than they save.
constexpr std::size_t FewestChunks = 4;
// Texels of a triangle's box from which threads share it, by rows.
constexpr std::int64_t LargeBox = 4096;
constexpr int BandHeight = 64;
// Width in texels from which the ends of a row are computed.
constexpr int WideRow = 8;

struct Corner
{
  std::int32_t X; // Outside: to be cut first
  std::int32_t Y;
  float Z;
};

struct Edge
{
  std::int64_t Value; // at the box's lowest left centre, below 0 outside
  std::int64_t Right; // change to the next texel
  std::int64_t Up;
  std::int64_t Open; // 1: centres on the edge belong to the neighbour, and Value is less by 1

  Edge(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y)
  {
    const std::int64_t dx = static_cast<std::int64_t>(b.X) - a.X;
    const std::int64_t dy = static_cast<std::int64_t>(b.Y) - a.Y;
    this->Open = dy < 0 || (dy == 0 && dx < 0) ? 0 : 1;
    this->Value = dx * (y - a.Y) - dy * (x - a.X) - this->Open;
    this->Right = -dy * One;
    this->Up = dx * One;
  }
};

// The texels whose centres are in a triangle's box.
struct Box
{
  int Left;
  int Right;
  int Low;
  int High;
};

struct Triangle
{
  std::array<Corner, 3> Corners; // counter-clockwise
  std::int64_t Area;             // twice, in (1/4096 texel)^2
  Box Texels;
};

// The part of the map that is drawn to.
struct Target
{
  float* Depths;
  std::size_t Size;
  Box Texels;
  float Least; // of a depth, before those below 0 are left out

  float Limit(double z) const { return std::max(static_cast<float>(z), this->Least); }
};

Target MakeTarget(float* depths, int size, const int region[4], bool clamps)
{
  return { depths, static_cast<std::size_t>(size),
    { region[0], region[0] + region[2] - 1, region[1], region[1] + region[3] - 1 },
    clamps ? 0.f : -std::numeric_limits<float>::infinity() };
}

static_assert(sizeof(std::atomic<std::uint32_t>) == sizeof(float), "a depth is 32 bits");

// Lowers a depth: alone, or while other threads do.
struct Alone
{
  static void Lower(float& depth, float z)
  {
    if (z >= 0.f && z < depth)
    {
      depth = z;
    }
  }
};
struct Together
{
  static float Get(float& depth)
  {
    const std::uint32_t bits =
      reinterpret_cast<std::atomic<std::uint32_t>&>(depth).load(std::memory_order_relaxed);
    float now;
    std::memcpy(&now, &bits, sizeof(now));
    return now;
  }
  static void Lower(float& depth, float z)
  {
    auto& shared = reinterpret_cast<std::atomic<std::uint32_t>&>(depth);
    std::uint32_t bits = shared.load(std::memory_order_relaxed);
    std::uint32_t wanted;
    std::memcpy(&wanted, &z, sizeof(z));
    float now;
    std::memcpy(&now, &bits, sizeof(now));
    while (
      z >= 0.f && z < now && !shared.compare_exchange_weak(bits, wanted, std::memory_order_relaxed))
    {
      std::memcpy(&now, &bits, sizeof(now));
    }
  }
};

// Limits [from, to] to the steps k at which value + k * step is not negative.
void Limit(std::int64_t value, std::int64_t step, std::int64_t& from, std::int64_t& to)
{
  if (step > 0)
  {
    from = value < 0 ? std::max(from, (-value + step - 1) / step) : from;
  }
  else if (value < 0)
  {
    to = -1;
  }
  else if (step < 0)
  {
    to = std::min(to, value / -step);
  }
}

// Draws the triangle's texels within the box.
template <typename Way>
void Fill(const Target& target, const Triangle& triangle, const Box& box)
{
  const auto& [a, b, c] = triangle.Corners;
  const std::int64_t x = static_cast<std::int64_t>(box.Left) * One;
  const std::int64_t y = static_cast<std::int64_t>(box.Low) * One;
  Edge ab(a, b, x, y);
  Edge bc(b, c, x, y);
  Edge ca(c, a, x, y);
  // Depth from the values of two edges: at each centre, the three add up to twice the area.
  double toB = 0.0;
  double toC = 0.0;
  auto divide = [&]() {
    const double scale = 1.0 / static_cast<double>(triangle.Area);
    toB = (static_cast<double>(b.Z) - a.Z) * scale;
    toC = (static_cast<double>(c.Z) - a.Z) * scale;
    return true;
  };
  auto getDepth = [&](std::int64_t inCA, std::int64_t inAB) {
    return a.Z + toB * static_cast<double>(inCA + ca.Open) +
      toC * static_cast<double>(inAB + ab.Open);
  };
  const int width = box.Right - box.Left;
  const bool wide = width >= WideRow;
  bool divided = wide && divide(); // most of the smallest triangles contain no centre
  for (int row = box.Low; row <= box.High; ++row)
  {
    float* const depths = target.Depths + row * target.Size + box.Left;
    if (wide)
    {
      std::int64_t from = 0;
      std::int64_t to = width;
      Limit(ab.Value, ab.Right, from, to);
      Limit(bc.Value, bc.Right, from, to);
      Limit(ca.Value, ca.Right, from, to);
      if (from <= to)
      {
        const double z = getDepth(ca.Value + from * ca.Right, ab.Value + from * ab.Right);
        const double step =
          toB * static_cast<double>(ca.Right) + toC * static_cast<double>(ab.Right);
        const int count = static_cast<int>(to - from + 1);
        for (int k = 0; k < count; ++k)
        {
          Way::Lower(depths[from + k], target.Limit(z + k * step));
        }
      }
    }
    else
    {
      std::int64_t inAB = ab.Value;
      std::int64_t inBC = bc.Value;
      std::int64_t inCA = ca.Value;
      for (int k = 0; k <= width; ++k)
      {
        if ((inAB | inBC | inCA) >= 0)
        {
          divided = divided || divide();
          Way::Lower(depths[k], target.Limit(getDepth(inCA, inAB)));
        }
        inAB += ab.Right;
        inBC += bc.Right;
        inCA += ca.Right;
      }
    }
    ab.Value += ab.Up;
    bc.Value += bc.Up;
    ca.Value += ca.Up;
  }
}

// Has memory read into the cache while the processor works on.
void Fetch(const void* place)
{
#ifdef __GNUC__
  __builtin_prefetch(place);
#else
  (void)place;
#endif
}

// Triangles that wait for their texels to be read into the cache.
template <typename Way>
class Queue
{
public:
  explicit Queue(const Target& target)
    : To(target)
  {
  }

  // Where the next triangle is placed.
  Triangle& GetNext() { return this->Triangles[this->Count % Waiting]; }

  // Adds that triangle, and draws the one that has waited longest.
  void Add()
  {
    const Box& box = this->GetNext().Texels;
    for (int row = box.Low; row <= std::min(box.High, box.Low + RowsAhead - 1); ++row)
    {
      const float* const depths = this->To.Depths + row * this->To.Size;
      Fetch(depths + box.Left);
      Fetch(depths + box.Right);
    }
    ++this->Count;
    if (this->Count >= Waiting)
    {
      this->Draw(this->Count - Waiting);
    }
  }

  void DrawRest() const
  {
    for (std::size_t i = this->Count - std::min(this->Count, Waiting - 1); i < this->Count; ++i)
    {
      this->Draw(i);
    }
  }

private:
  void Draw(std::size_t i) const
  {
    const Triangle& triangle = this->Triangles[i % Waiting];
    Fill<Way>(this->To, triangle, triangle.Texels);
  }

  const Target& To;
  std::array<Triangle, Waiting> Triangles;
  std::size_t Count = 0;
};

// From a mesh's coordinates to the target's: texels from the lowest left centre, and depth in
// [0, 1], times w.
class Transform
{
public:
  Transform(const glm::dmat4& modelToNDC, const int region[4])
  {
    glm::dmat4 ndcToMap(0.5);
    ndcToMap[0].x = 0.5 * region[2];
    ndcToMap[1].y = 0.5 * region[3];
    ndcToMap[3] =
      glm::dvec4(region[0] + 0.5 * region[2] - 0.5, region[1] + 0.5 * region[3] - 0.5, 0.5, 1.0);
    this->Matrix = ndcToMap * modelToNDC;
    const glm::dmat4 rows = glm::transpose(this->Matrix);
    this->Affine = rows[3] == glm::dvec4(0.0, 0.0, 0.0, 1.0);
  }

  const glm::dmat4& Get() const { return this->Matrix; }

  glm::dvec4 Move(const float* place) const
  {
    return this->Matrix * glm::dvec4(place[0], place[1], place[2], 1.0);
  }

  Corner Get(const float* place) const
  {
    glm::dvec4 p = this->Move(place);
    if (!this->Affine)
    {
      if (!(p.w > 0.0))
      {
        return { Outside, 0, 0.f };
      }
      p /= p.w;
    }
    return Round(p);
  }

  // Outside: too far for the digits, or not a number.
  static Corner Round(const glm::dvec4& p)
  {
    if (!(std::abs(p.x) <= Farthest && std::abs(p.y) <= Farthest))
    {
      return { Outside, 0, 0.f };
    }
    // Conversions round towards zero, so numbers are made positive.
    constexpr std::int32_t Shift = 1 << 30;
    return { static_cast<std::int32_t>(p.x * One + (Shift + 0.5)) - Shift,
      static_cast<std::int32_t>(p.y * One + (Shift + 0.5)) - Shift, static_cast<float>(p.z) };
  }

private:
  glm::dmat4 Matrix;
  bool Affine;
};

// std::floor is a function call for most builds; for numbers of a map.
int Floor(double value)
{
  constexpr int Shift = 1 << 20;
  return static_cast<int>(value + Shift) - Shift;
}
int Ceil(double value)
{
  return -Floor(-value);
}

// A group of points: no point is nearer than Z, or beside the texels, which are none outside of
// the map.
struct Cover
{
  std::size_t Group;
  float Z;
  Box Texels;
};

Cover GetCover(const Target& target, const vtkRelievoPointGroups::Mesh& points, std::size_t number,
  double radius, const glm::dmat4& toMap)
{
  const vtkRelievoPointGroups::Group& group = points.Groups[number];
  Cover cover{ number, -1.0f, target.Texels };
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-low);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 p = toMap *
      glm::dvec4((corner & 1) != 0 ? group.High.x : group.Low.x,
        (corner & 2) != 0 ? group.High.y : group.Low.y,
        (corner & 4) != 0 ? group.High.z : group.Low.z, 1.0);
    if (!(p.w > 0.0))
    {
      return cover; // anywhere
    }
    low = glm::min(low, glm::dvec3(p) / p.w);
    high = glm::max(high, glm::dvec3(p) / p.w);
  }
  const double reach = radius + 1.0;
  const auto limit = [](double value) { return Floor(std::clamp(value, -1e5, 1e5)); };
  cover.Z = static_cast<float>(low.z - 1e-5); // floats round
  cover.Texels = { std::max(target.Texels.Left, limit(low.x - reach)),
    std::min(target.Texels.Right, limit(high.x + reach)),
    std::max(target.Texels.Low, limit(low.y - reach)),
    std::min(target.Texels.High, limit(high.y + reach)) };
  return cover;
}

// Whether the map has nothing farther than the group.
bool IsHidden(const Target& target, const Cover& cover)
{
  for (int row = cover.Texels.Low; row <= cover.Texels.High; ++row)
  {
    float* const depths = target.Depths + row * target.Size;
    for (int column = cover.Texels.Left; column <= cover.Texels.Right; ++column)
    {
      if (Together::Get(depths[column]) > cover.Z)
      {
        return false;
      }
    }
  }
  return true;
}

// Draws discs around the points of a group.
void DrawDiscs(const Target& target, const vtkRelievoPointGroups::Mesh& points, std::size_t number,
  double radius, const glm::dmat4& toMap)
{
  const vtkRelievoPointGroups::Group& group = points.Groups[number];
  const glm::dvec4 low = toMap * glm::dvec4(group.Low, 1.0);
  const Box& box = target.Texels;
  for (std::size_t i = number > 0 ? points.Groups[number - 1].End : 0; i < group.End; ++i)
  {
    const glm::dvec3 place(points.Places[i]);
    glm::dvec4 p = low + place.x * toMap[0] + place.y * toMap[1] + place.z * toMap[2];
    if (!(p.w > 0.0))
    {
      continue;
    }
    p /= p.w;
    const float z = target.Limit(p.z);
    // False also if the point is no place.
    if (!(z < 1.0f && p.x > box.Left - radius && p.x < box.Right + radius &&
          p.y > box.Low - radius && p.y < box.High + radius))
    {
      continue;
    }
    const int highest = std::min(box.High, Floor(p.y + radius));
    for (int row = std::max(box.Low, Ceil(p.y - radius)); row <= highest; ++row)
    {
      const double up = row - p.y;
      const double half = std::sqrt(std::max(0.0, radius * radius - up * up));
      const int right = std::min(box.Right, Floor(p.x + half));
      float* const depths = target.Depths + row * target.Size;
      for (int column = std::max(box.Left, Ceil(p.x - half)); column <= right; ++column)
      {
        Together::Lower(depths[column], z);
      }
    }
  }
}

// A triangle's texels, with its corners counter-clockwise; false if it contains no centre, or is
// seen edge-on.
bool Place(
  const Target& target, const Corner& a, const Corner& b, const Corner& c, Triangle& triangle)
{
  Box& box = triangle.Texels;
  box.Left = std::max(target.Texels.Left, (std::min({ a.X, b.X, c.X }) + One - 1) >> Digits);
  box.Right = std::min(target.Texels.Right, std::max({ a.X, b.X, c.X }) >> Digits);
  box.Low = std::max(target.Texels.Low, (std::min({ a.Y, b.Y, c.Y }) + One - 1) >> Digits);
  box.High = std::min(target.Texels.High, std::max({ a.Y, b.Y, c.Y }) >> Digits);
  if (box.Left > box.Right || box.Low > box.High)
  {
    return false;
  }
  const std::int64_t area =
    (static_cast<std::int64_t>(b.X) - a.X) * (static_cast<std::int64_t>(c.Y) - a.Y) -
    (static_cast<std::int64_t>(c.X) - a.X) * (static_cast<std::int64_t>(b.Y) - a.Y);
  triangle.Corners = area > 0 ? std::array<Corner, 3>{ a, b, c } : std::array<Corner, 3>{ a, c, b };
  triangle.Area = std::abs(area);
  return area != 0;
}

// The part of a triangle near the map, and so before the eye: w is above 0.
std::vector<glm::dvec4> Cut(const std::array<glm::dvec4, 3>& corners)
{
  std::vector<glm::dvec4> polygon(corners.begin(), corners.end());
  const double reach = 0.5 * Farthest;
  const glm::dvec4 planes[] = { { 1.0, 0.0, 0.0, reach }, { -1.0, 0.0, 0.0, reach },
    { 0.0, 1.0, 0.0, reach }, { 0.0, -1.0, 0.0, reach } };
  for (const glm::dvec4& plane : planes)
  {
    std::vector<glm::dvec4> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const glm::dvec4& p = polygon[i];
      const glm::dvec4& q = polygon[(i + 1) % polygon.size()];
      const double ofP = glm::dot(plane, p);
      const double ofQ = glm::dot(plane, q);
      if (ofP >= 0.0)
      {
        kept.push_back(p);
      }
      if ((ofP >= 0.0) != (ofQ >= 0.0))
      {
        // From the kept end in both triangles of an edge.
        const double along = ofP >= 0.0 ? ofP / (ofP - ofQ) : ofQ / (ofQ - ofP);
        kept.push_back(ofP >= 0.0 ? p + along * (q - p) : q + along * (p - q));
      }
    }
    polygon.swap(kept);
  }
  return polygon;
}

// Draws a mesh's triangles chunk by chunk. Large ones are kept for the end.
class Drawing
{
public:
  Drawing(const vtkRelievoDepthRaster::Mesh& mesh, const Transform& toMap, const Target& target)
    : Mesh(mesh)
    , ToMap(toMap)
    , To(target)
  {
  }

  std::size_t GetNumberOfChunks() const
  {
    return (this->Mesh.Triangles + ChunkSize - 1) / ChunkSize;
  }

  // The large triangles' rows, BandHeight of them.
  bool HasLarge() const { return !this->Large.empty(); }
  int GetNumberOfBands() const
  {
    return (this->To.Texels.High - this->To.Texels.Low + BandHeight) / BandHeight;
  }
  void DrawBand(int band) const
  {
    const int low = this->To.Texels.Low + band * BandHeight;
    for (const Triangle& triangle : this->Large)
    {
      Box box = triangle.Texels;
      box.Low = std::max(box.Low, low);
      box.High = std::min(box.High, low + BandHeight - 1);
      if (box.Low <= box.High)
      {
        Fill<Alone>(this->To, triangle, box);
      }
    }
  }

  template <typename Way>
  void DrawTriangles(std::size_t chunk)
  {
    const std::size_t first = chunk * ChunkSize;
    const std::size_t last = std::min(this->Mesh.Triangles, first + ChunkSize);
    const unsigned int* const begin = this->Mesh.Corners + 3 * first;
    const unsigned int* const end = this->Mesh.Corners + 3 * last;
    const auto ends = std::minmax_element(begin, end);
    const std::size_t lowest = *ends.first;
    const std::size_t count = *ends.second - lowest + 1;
    const bool valid = *ends.second < this->Mesh.NumberOfPlaces;
    // Neighbours share corners, unless their order is random.
    const bool shared = valid && count <= static_cast<std::size_t>(end - begin);
    std::vector<Corner> corners(shared ? count : 0);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      corners[i] = this->ToMap.Get(this->GetPlace(lowest + i));
    }
    Queue<Way> waiting(this->To);
    std::vector<Triangle> large;
    for (const unsigned int* at = begin; at != end; at += 3)
    {
      if (shared)
      {
        this->Draw(at, corners[at[0] - lowest], corners[at[1] - lowest], corners[at[2] - lowest],
          waiting, large);
      }
      else if (valid || *std::max_element(at, at + 3) < this->Mesh.NumberOfPlaces)
      {
        // Most corners are not in the cache.
        for (int i = 0; i < 3; ++i)
        {
          Fetch(this->GetPlace(at[std::min(Ahead, end - 3 - at) + i]));
        }
        this->Draw(at, this->ToMap.Get(this->GetPlace(at[0])),
          this->ToMap.Get(this->GetPlace(at[1])), this->ToMap.Get(this->GetPlace(at[2])), waiting,
          large);
      }
    }
    waiting.DrawRest();
    if (!large.empty())
    {
      const std::lock_guard<std::mutex> lock(this->Adding);
      this->Large.insert(this->Large.end(), large.begin(), large.end());
    }
  }

private:
  const float* GetPlace(std::size_t corner) const
  {
    return this->Mesh.Places + corner * this->Mesh.Step;
  }

  template <typename Way>
  void Draw(const unsigned int* at, const Corner& a, const Corner& b, const Corner& c,
    Queue<Way>& waiting, std::vector<Triangle>& large) const
  {
    if (a.X != Outside && b.X != Outside && c.X != Outside)
    {
      this->Draw(a, b, c, waiting, large);
      return;
    }
    const std::vector<glm::dvec4> polygon = Cut({ this->ToMap.Move(this->GetPlace(at[0])),
      this->ToMap.Move(this->GetPlace(at[1])), this->ToMap.Move(this->GetPlace(at[2])) });
    std::vector<Corner> corners;
    for (const glm::dvec4& p : polygon)
    {
      corners.push_back(Transform::Round(p / p.w));
      if (corners.back().X == Outside)
      {
        return; // not a number, or seen edge-on from a corner in the eye
      }
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->Draw(corners[0], corners[i - 1], corners[i], waiting, large);
    }
  }

  template <typename Way>
  void Draw(const Corner& a, const Corner& b, const Corner& c, Queue<Way>& waiting,
    std::vector<Triangle>& large) const
  {
    Triangle& triangle = waiting.GetNext();
    if (!Place(this->To, a, b, c, triangle))
    {
      return;
    }
    const Box& box = triangle.Texels;
    const std::int64_t texels =
      (box.Right - box.Left + 1) * static_cast<std::int64_t>(box.High - box.Low + 1);
    if (texels < SmallBox)
    {
      Fill<Way>(this->To, triangle, box);
    }
    else if (texels < LargeBox)
    {
      waiting.Add();
    }
    else
    {
      large.push_back(triangle);
    }
  }

  const vtkRelievoDepthRaster::Mesh& Mesh;
  const Transform& ToMap;
  const Target& To;
  std::mutex Adding;
  std::vector<Triangle> Large;
};
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRaster::Clear(int size)
{
  this->Size = size;
  this->Depths.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRaster::Allocate()
{
  if (this->Depths.empty())
  {
    this->Depths.assign(static_cast<std::size_t>(this->Size) * this->Size, 1.f);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRaster::Draw(const vtkRelievoPointGroups::Mesh& points, double diameter,
  const glm::dmat4& modelToNDC, const int region[4], bool clamps)
{
  this->Allocate();
  const glm::dmat4 toMap = Transform(modelToNDC, region).Get();
  const Target target = MakeTarget(this->Depths.data(), this->Size, region, clamps);
  const double radius = 0.5 * std::max(diameter, 1.0);
  std::vector<Cover> covers;
  covers.reserve(points.Groups.size());
  for (std::size_t i = 0; i < points.Groups.size(); ++i)
  {
    covers.push_back(GetCover(target, points, i, radius, toMap));
  }
  // From the front to the back: most groups behind others need no look at their points.
  std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return a.Z < b.Z; });
  const std::size_t chunks = (covers.size() + GroupsAtOnce - 1) / GroupsAtOnce;
  vtkRelievoForAll(static_cast<vtkIdType>(chunks), [&](vtkIdType chunk) {
    const std::size_t first = static_cast<std::size_t>(chunk) * GroupsAtOnce;
    for (std::size_t i = first; i < std::min(first + GroupsAtOnce, covers.size()); ++i)
    {
      if (!IsHidden(target, covers[i]))
      {
        DrawDiscs(target, points, covers[i].Group, radius, toMap);
      }
    }
  });
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRaster::Draw(
  const Mesh& mesh, const glm::dmat4& modelToNDC, const int region[4], bool clamps)
{
  this->Allocate();
  const Transform toMap(modelToNDC, region);
  const Target target = MakeTarget(this->Depths.data(), this->Size, region, clamps);
  Drawing drawing(mesh, toMap, target);
  const std::size_t chunks = drawing.GetNumberOfChunks();
  if (chunks < FewestChunks)
  {
    for (std::size_t i = 0; i < chunks; ++i)
    {
      drawing.DrawTriangles<Alone>(i);
    }
    for (int i = 0; i < drawing.GetNumberOfBands() && drawing.HasLarge(); ++i)
    {
      drawing.DrawBand(i);
    }
  }
  else
  {
    vtkRelievoForAll(static_cast<vtkIdType>(chunks),
      [&drawing](vtkIdType i) { drawing.DrawTriangles<Together>(static_cast<std::size_t>(i)); });
    if (drawing.HasLarge())
    {
      vtkRelievoForAll(drawing.GetNumberOfBands(),
        [&drawing](vtkIdType i) { drawing.DrawBand(static_cast<int>(i)); });
    }
  }
}
