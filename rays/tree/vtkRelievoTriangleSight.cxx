// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTriangleSight.h"

#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace
{
constexpr double Least = 1e-11;     // least error of positions, as a share of the view
constexpr double LeastDepth = 1e-8; // relative error of distances
// Limit of X and Y: triangles that extend further are not projected.
constexpr double Farthest = 64.0;
constexpr std::size_t MostWild = 64; // triangles: with more all points stay Unknown
constexpr vtkIdType ChunksOfAThread = 256;
constexpr unsigned All = 15; // four bits
constexpr double FloatError = 4e-6;
constexpr double RoomOfDepth = 1e-6;
constexpr double MostAtCorners = 1e-11; // limit for corners: relative error of distances
// Least area of a triangle not seen edge-on, over its squared size.
constexpr double LeastArea = 1e-5;
constexpr double LeastShare = 1e2; // least area in units of its error

float Below(double x)
{
  return static_cast<float>(x - vtkRelievoWideTree::Room * std::max(1.0, std::abs(x)));
}
float Above(double x)
{
  return static_cast<float>(x + vtkRelievoWideTree::Room * std::max(1.0, std::abs(x)));
}
float BelowDepth(double q)
{
  return static_cast<float>(q * (1.0 - RoomOfDepth));
}
float AboveDepth(double q)
{
  return static_cast<float>(q * (1.0 + RoomOfDepth));
}

bool IsInView(const vtkRelievoWideTree::Box& box)
{
  return box.Min.x <= box.Max.x; // others are nowhere
}
double GetSize(const vtkRelievoWideTree::Box& box)
{
  return std::max(box.Max.x - box.Min.x, box.Max.y - box.Min.y);
}

// A number for a corner in sums (S. Vigna, SplitMix64).
std::uint64_t GetSign(std::uint64_t corner)
{
  std::uint64_t x = (corner + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Corners surrounded by triangles without a gap: the set of next corners in the triangles equals
// the set of previous ones.
std::vector<char> FindClosed(const vtkRelievoMeshTree& mesh)
{
  std::vector<std::uint64_t> sums(mesh.GetPlaces().size(), 0);
  for (int i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const std::uint32_t* corners = mesh.GetCorners(i);
    std::uint64_t signs[3];
    for (int k = 0; k < 3; ++k)
    {
      signs[k] = GetSign(corners[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      sums[corners[k]] += signs[(k + 1) % 3] - signs[(k + 2) % 3];
    }
  }
  std::vector<char> closed(sums.size());
  std::transform(
    sums.begin(), sums.end(), closed.begin(), [](std::uint64_t sum) { return sum == 0 ? 1 : 0; });
  return closed;
}
}

// Four points compared with triangles at once: those of a triangle, or corners.
struct vtkRelievoTriangleSight::Quad
{
  double X[4];
  double Y[4];
  double Q[4];
  alignas(16) float LocalX[4]; // relative to the group's centre
  alignas(16) float LocalY[4];
  double Size = 0.0;
  int Triangle = -1; // -1 for corners
  vtkIdType Cell = -1;
  std::uint32_t Corners[4] = { 0, 0, 0, 0 }; // indices of corners
  unsigned Valid = 0;                        // bits
  unsigned Open = 0;                         // points that further triangles may change
  unsigned Hidden = 0;
  unsigned Doubtful = 0;
};

// A triangle that may hide points.
struct vtkRelievoTriangleSight::Facing
{
  int Mesh;
  int Triangle;
  const Vertex* Corners[3];
  float X[3]; // relative to the centre of the points that it may hide
  float Y[3];
  double Size;
  double Error; // of twice the areas of triangles, per length of their sides
};

// Bits of the points that the triangle may hide: it is not clearly beside them.
inline unsigned vtkRelievoTriangleSight::MayHide(
  const Facing& facing, const Quad& quad, double reach)
{
  using Four = vtkRelievoFour;
  // Rounding of differences up to `size` between coordinates up to reach + size, and of their
  // products.
  const double size = facing.Size + quad.Size;
  const auto margin = static_cast<float>(size * (facing.Error + FloatError * (reach + size)));
  const Four x = Four::Load(quad.LocalX);
  const Four y = Four::Load(quad.LocalY);
  const Four ax = Four(facing.X[0]) - x;
  const Four ay = Four(facing.Y[0]) - y;
  const Four bx = Four(facing.X[1]) - x;
  const Four by = Four(facing.Y[1]) - y;
  const Four cx = Four(facing.X[2]) - x;
  const Four cy = Four(facing.Y[2]) - y;
  const Four u = bx * cy - cx * by;
  const Four v = cx * ay - ax * cy;
  const Four w = ax * by - bx * ay;
  const Four least = vtkRelievoMin(vtkRelievoMin(u, v), w);
  const Four greatest = vtkRelievoMax(vtkRelievoMax(u, v), w);
  const Four isBeside = (least <= Four(-margin)) & (Four(margin) <= greatest);
  return ~vtkRelievoGetBits(isBeside) & All;
}

struct vtkRelievoTriangleSight::Group
{
  Quad Quads[MostQuads];
  int Count = 0;
  alignas(16) float Low[3][MostQuads]; // by quad, of X, Y and Q
  alignas(16) float High[2][MostQuads];
  Box All = vtkRelievoWideTree::Nowhere();
  double Center[2];
  double Reach; // largest distance from the group's centre
};

//------------------------------------------------------------------------------
vtkRelievoTriangleSight::vtkRelievoTriangleSight(
  const vtkRelievoRayTree& scene, int place, const Weights& weights)
  : Meshes(static_cast<std::size_t>(scene.GetNumberOfPlaces()))
  , Target(place)
  , PointWeights(weights)
{
  for (int i = 0; i < scene.GetNumberOfPlaces(); ++i)
  {
    Projected& mesh = this->Meshes[static_cast<std::size_t>(i)];
    mesh.Mesh = &scene.GetMeshTree(i);
    mesh.ToScene = scene.GetToScene(i);
    mesh.Tree = mesh.Mesh->GetTree();
    mesh.Vertices.resize(mesh.Mesh->GetPlaces().size());
    mesh.Boxes.resize(static_cast<std::size_t>(mesh.Mesh->GetNumberOfTriangles()));
    mesh.Sides.resize(mesh.Boxes.size());
    mesh.CornerSides.resize(mesh.Vertices.size());
    mesh.IsClosed = FindClosed(*mesh.Mesh);
  }
  const vtkRelievoMeshTree& target = scene.GetMeshTree(place);
  const int triangles = target.GetNumberOfTriangles();
  this->SampleStates.resize(static_cast<std::size_t>(triangles));
  this->CornerStates.resize(target.GetPlaces().size());
  std::size_t next = 0;
  std::vector<bool> hasTriangle;
  for (int i = 0; i < triangles; ++i)
  {
    if (i % Chunk == 0)
    {
      this->Firsts.push_back(next);
    }
    for (int k = 0; k < 3; ++k)
    {
      next = std::max<std::size_t>(next, target.GetCorners(i)[k] + std::size_t(1));
    }
    const auto cell = static_cast<std::size_t>(target.GetCell(i));
    hasTriangle.resize(std::max(hasTriangle.size(), cell + 1));
    this->HasManyToACell = this->HasManyToACell || hasTriangle[cell];
    hasTriangle[cell] = true;
  }
  this->CellSides.resize(this->HasManyToACell ? hasTriangle.size() : 0);
  this->HiddenChunks.resize(this->Firsts.size());
  this->Firsts.push_back(next);
  this->Clear();
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Clear()
{
  std::fill(this->SampleStates.begin(), this->SampleStates.end(), std::uint8_t(0));
  std::fill(this->CornerStates.begin(), this->CornerStates.end(), State::Unknown);
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Look(const View& view)
{
  const glm::dvec2 half = 0.5 * (view.High - view.Low);
  this->Error = Least;
  this->ErrorByQ = 16.0 * view.Rounding / std::min(half.x, half.y);
  this->DepthErrorByQ = 16.0 * view.Rounding;
  this->Wilds.clear();
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    this->Project(static_cast<int>(i), view);
  }
  if (this->Wilds.size() > MostWild)
  {
    return;
  }
  this->FillLayers();
  const auto chunks = static_cast<vtkIdType>(this->Firsts.size()) - 1;
  vtkRelievoForAll(
    chunks, [&](vtkIdType i) { this->LookAtChunk(static_cast<int>(i), view); }, ChunksOfAThread);
}

//------------------------------------------------------------------------------
inline vtkRelievoTriangleSight::Side vtkRelievoTriangleSight::GetSide(
  const Vertex& a, const Vertex& b, const Vertex& c, const Box& box) const
{
  const double error = this->GetError(box);
  const double size = GetSize(box);
  const double area = (b.X - a.X) * (c.Y - a.Y) - (c.X - a.X) * (b.Y - a.Y);
  const bool isClear = std::abs(area) > LeastArea * size * size &&
    std::abs(area) > LeastShare * error * size && error < vtkRelievoWideTree::Room &&
    this->DepthErrorByQ * box.Max.z < 0.1 * RoomOfDepth;
  return !isClear ? Side::Unclear : area > 0.0 ? Side::Front : Side::Back;
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Project(int number, const View& view)
{
  Projected& mesh = this->Meshes[static_cast<std::size_t>(number)];
  const glm::dmat3 turn =
    glm::transpose(glm::dmat3(view.Axes[0], view.Axes[1], view.Axes[2])) * glm::dmat3(mesh.ToScene);
  const glm::dvec3 move = glm::transpose(glm::dmat3(view.Axes[0], view.Axes[1], view.Axes[2])) *
    (glm::dvec3(mesh.ToScene[3]) - view.From);
  const glm::dvec2 center = 0.5 * (view.Low + view.High);
  const glm::dvec2 scale = 2.0 / (view.High - view.Low);
  const vtkRelievoStoredArray<glm::dvec3>& places = mesh.Mesh->GetPlaces();
  const auto project = [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const glm::dvec3 p = turn * places[at] + move;
      const double q = 1.0 / p.z;
      mesh.Vertices[at] = { (p.x * q - center.x) * scale.x, (p.y * q - center.y) * scale.y,
        p.z > 0.0 ? q : -1.0, p.z };
    }
  };
  std::mutex wilds;
  const auto enclose = [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      const std::uint32_t* corners = mesh.Mesh->GetCorners(static_cast<int>(i));
      const Vertex& a = mesh.Vertices[corners[0]];
      const Vertex& b = mesh.Vertices[corners[1]];
      const Vertex& c = mesh.Vertices[corners[2]];
      const double low[3] = { std::min(std::min(a.X, b.X), c.X), std::min(std::min(a.Y, b.Y), c.Y),
        std::min(std::min(a.Q, b.Q), c.Q) };
      const double high[3] = { std::max(std::max(a.X, b.X), c.X), std::max(std::max(a.Y, b.Y), c.Y),
        std::max(std::max(a.Q, b.Q), c.Q) };
      Box& box = mesh.Boxes[static_cast<std::size_t>(i)];
      box = vtkRelievoWideTree::Nowhere();
      Side& side = mesh.Sides[static_cast<std::size_t>(i)];
      side = Side::Unclear;
      const bool isAhead = low[2] > 0.0;
      if (isAhead && std::max({ -low[0], -low[1], high[0], high[1] }) < Farthest) // false for NaN
      {
        const Box around{ glm::vec3(Below(low[0]), Below(low[1]), BelowDepth(low[2])),
          glm::vec3(Above(high[0]), Above(high[1]), AboveDepth(high[2])) };
        side = this->GetSide(a, b, c, around);
        if (low[0] <= 1.0 && low[1] <= 1.0 && high[0] >= -1.0 && high[1] >= -1.0)
        {
          box = around;
        }
        continue;
      }
      Wild wild{ number, static_cast<int>(i), {} };
      bool outside[5] = { true, true, true, true, true }; // of the view's sides
      bool isPlace = true;
      for (int k = 0; k < 3; ++k)
      {
        const glm::dvec3 p = turn * places[corners[k]] + move;
        wild.Corners[k] = p;
        outside[0] = outside[0] && p.x < view.Low.x * p.z;
        outside[1] = outside[1] && p.x > view.High.x * p.z;
        outside[2] = outside[2] && p.y < view.Low.y * p.z;
        outside[3] = outside[3] && p.y > view.High.y * p.z;
        outside[4] = outside[4] && p.z < 0.0;
        isPlace = isPlace && std::isfinite(p.x + p.y + p.z);
      }
      if (isPlace && std::none_of(outside, outside + 5, [](bool each) { return each; }))
      {
        const std::lock_guard<std::mutex> lock(wilds);
        this->Wilds.push_back(wild);
      }
    }
  };
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()), project);
    vtkSMPTools::For(0, mesh.Mesh->GetNumberOfTriangles(), enclose);
  });
  mesh.Tree.Refit(mesh.Boxes);
}

//------------------------------------------------------------------------------
// The sides of the triangles at corners and in cells, and the side of each mesh that is nearer.
void vtkRelievoTriangleSight::GatherSides()
{
  std::fill(this->CellSides.begin(), this->CellSides.end(), std::uint8_t(0));
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    Projected& mesh = this->Meshes[m];
    const bool isCellTaken = static_cast<int>(m) == this->Target && this->HasManyToACell;
    std::fill(mesh.CornerSides.begin(), mesh.CornerSides.end(), std::uint8_t(0));
    double reach[2] = { 0.0, 0.0 }; // of fronts and backs
    double count[2] = { 0.0, 0.0 };
    for (std::size_t i = 0; i < mesh.Sides.size(); ++i)
    {
      const Side side = mesh.Sides[i];
      const std::uint32_t* corners = mesh.Mesh->GetCorners(static_cast<int>(i));
      for (int k = 0; k < 3; ++k)
      {
        mesh.CornerSides[corners[k]] |= side;
      }
      if (isCellTaken)
      {
        const vtkIdType cell = mesh.Mesh->GetCell(static_cast<int>(i));
        this->CellSides[static_cast<std::size_t>(cell)] |= side;
      }
      if (side != Side::Unclear && IsInView(mesh.Boxes[i]))
      {
        reach[side == Side::Back] += mesh.Boxes[i].Max.z;
        count[side == Side::Back] += 1.0;
      }
    }
    mesh.Nearer = reach[0] * count[1] >= reach[1] * count[0] ? Side::Front : Side::Back;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::FillLayers()
{
  std::size_t triangles = 0;
  double sizes = 0.0;
  for (const Projected& mesh : this->Meshes)
  {
    for (const Box& box : mesh.Boxes)
    {
      if (IsInView(box))
      {
        ++triangles;
        sizes += GetSize(box);
      }
    }
  }
  this->Layers.Clear(triangles, sizes / static_cast<double>(std::max<std::size_t>(triangles, 1)));
  this->GatherSides();
  // Those of the nearer side come first: they hide most of the others, which are then in no layer.
  for (const Projected& mesh : this->Meshes)
  {
    for (std::size_t i = 0; i < mesh.Sides.size(); ++i)
    {
      if (!IsInView(mesh.Boxes[i]))
      {
        continue;
      }
      if (mesh.Sides[i] == Side::Unclear)
      {
        this->Layers.Block(mesh.Boxes[i]);
      }
      else if (mesh.Sides[i] == mesh.Nearer)
      {
        this->AddToLayers(mesh, i);
      }
    }
  }
  this->Layers.Finish();
  std::fill(this->HiddenChunks.begin(), this->HiddenChunks.end(), char(0));
  for (std::size_t m = 0; m < this->Meshes.size(); ++m)
  {
    const Projected& mesh = this->Meshes[m];
    for (std::size_t first = 0; first < mesh.Sides.size(); first += Chunk)
    {
      Box around = vtkRelievoWideTree::Nowhere();
      unsigned farther = 0; // bits
      bool isAll = true;
      const std::size_t end = std::min(first + Chunk, mesh.Sides.size());
      for (std::size_t i = first; i < end; ++i)
      {
        const Box& box = mesh.Boxes[i];
        const bool isFarther = mesh.Sides[i] != Side::Unclear && mesh.Sides[i] != mesh.Nearer;
        if (isFarther && IsInView(box))
        {
          around = { glm::min(around.Min, box.Min), glm::max(around.Max, box.Max) };
          farther |= 1u << (i - first);
        }
        isAll = isAll && isFarther;
      }
      if (farther != 0 && this->Layers.IsHidden(around))
      {
        if (static_cast<int>(m) == this->Target)
        {
          this->HiddenChunks[first / Chunk] = isAll ? 1 : 0;
        }
        continue;
      }
      for (; farther != 0; farther &= farther - 1)
      {
        this->AddToLayers(mesh, first + static_cast<std::size_t>(vtkRelievoGetLowest(farther)));
      }
    }
  }
  this->Layers.Finish();
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::AddToLayers(const Projected& mesh, std::size_t triangle)
{
  const Box& box = mesh.Boxes[triangle];
  const std::uint32_t* corners = mesh.Mesh->GetCorners(static_cast<int>(triangle));
  glm::dvec2 p[3];
  bool ends[3];
  for (int k = 0; k < 3; ++k)
  {
    const Vertex& vertex = mesh.Vertices[corners[k]];
    p[k] = glm::dvec2(vertex.X, vertex.Y);
    // An edge is on no outline if triangles of one side surround one of its ends without a gap.
    const std::uint8_t sides = mesh.CornerSides[corners[k]];
    ends[k] = !mesh.IsClosed[corners[k]] || (sides != Side::Front && sides != Side::Back);
  }
  this->Layers.Add(mesh.Sides[triangle] == Side::Front, p, box, this->GetError(box) * GetSize(box));
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (ends[k] && ends[next])
    {
      this->Layers.AddOutline(p[k], p[next], box);
    }
  }
}

//------------------------------------------------------------------------------
// State of everything in a box by the layers; Unknown if these do not suffice.
vtkRelievoTriangleSight::State vtkRelievoTriangleSight::Judge(const Box& box) const
{
  return this->Wilds.empty() && this->Layers.IsFirst(box) ? State::Seen
    : this->Layers.IsHidden(box)                          ? State::Hidden
                                                          : State::Unknown;
}

//------------------------------------------------------------------------------
// Whether the layers may determine the state of a triangle's points.
inline bool vtkRelievoTriangleSight::HasLayer(const Projected& mesh, int triangle) const
{
  const auto at = static_cast<std::size_t>(triangle);
  return mesh.Sides[at] != Side::Unclear && this->SampleStates[at] == 0 && IsInView(mesh.Boxes[at]);
}

//------------------------------------------------------------------------------
// `state`: that of a box around the triangle.
void vtkRelievoTriangleSight::JudgeTriangle(int triangle, State state)
{
  const Projected& mesh = this->Meshes[static_cast<std::size_t>(this->Target)];
  const auto at = static_cast<std::size_t>(triangle);
  state = state == State::Unknown ? this->Judge(mesh.Boxes[at]) : state;
  // A hiding triangle may belong to the same cell, if the cell shows both sides.
  const bool isOfOneSide = !this->HasManyToACell ||
    this->CellSides[static_cast<std::size_t>(mesh.Mesh->GetCell(triangle))] == mesh.Sides[at];
  if (state == State::Seen)
  {
    this->SampleStates[at] = All;
  }
  else if (isOfOneSide && state == State::Hidden)
  {
    this->SampleStates[at] = All << Samples;
  }
}

//------------------------------------------------------------------------------
// Whether the state of a corner in the view is still to be determined. Excludes coordinates so
// large that rounding moves the hit of a ray with the corner's own triangles.
inline bool vtkRelievoTriangleSight::IsOpen(const Projected& mesh, std::size_t corner) const
{
  const Vertex& vertex = mesh.Vertices[corner];
  return this->CornerStates[corner] == State::Unknown && vertex.Q > 0.0 &&
    this->DepthErrorByQ * vertex.Q < MostAtCorners && std::abs(vertex.X) <= 1.0 &&
    std::abs(vertex.Y) <= 1.0;
}

//------------------------------------------------------------------------------
// `state`: that of the box `around`, in which the corner may lie.
void vtkRelievoTriangleSight::JudgeCorner(std::size_t corner, const Box& around, State state)
{
  const Projected& mesh = this->Meshes[static_cast<std::size_t>(this->Target)];
  const Vertex& vertex = mesh.Vertices[corner];
  if (!this->IsOpen(mesh, corner))
  {
    return;
  }
  const Box box{ glm::vec3(Below(vertex.X), Below(vertex.Y), BelowDepth(vertex.Q)),
    glm::vec3(Above(vertex.X), Above(vertex.Y), AboveDepth(vertex.Q)) };
  const bool isWithin = glm::all(glm::lessThanEqual(around.Min, box.Min)) &&
    glm::all(glm::lessThanEqual(box.Max, around.Max));
  state = isWithin && state != State::Unknown ? state : this->Judge(box);
  const std::uint8_t sides = mesh.CornerSides[corner];
  const bool isOfOneSide = mesh.IsClosed[corner] && (sides == Side::Front || sides == Side::Back);
  if (state == State::Hidden || (state == State::Seen && isOfOneSide))
  {
    this->CornerStates[corner] = state;
  }
}

//------------------------------------------------------------------------------
// Computes the bounds of the points, for the group.
void vtkRelievoTriangleSight::FillQuad(Quad& quad, int count) const
{
  double low[2] = { quad.X[0], quad.Y[0] };
  double high[2] = { quad.X[0], quad.Y[0] };
  for (int i = 0; i < count; ++i)
  {
    low[0] = std::min(low[0], quad.X[i]);
    low[1] = std::min(low[1], quad.Y[i]);
    high[0] = std::max(high[0], quad.X[i]);
    high[1] = std::max(high[1], quad.Y[i]);
    const bool valid = quad.X[i] >= -1.0 && quad.X[i] <= 1.0 && quad.Y[i] >= -1.0 &&
      quad.Y[i] <= 1.0 && quad.Q[i] > 0.0;
    quad.Valid |= valid ? 1u << i : 0u;
  }
  for (int i = count; i < 4; ++i)
  {
    quad.X[i] = quad.X[0];
    quad.Y[i] = quad.Y[0];
    quad.Q[i] = quad.Q[0];
  }
  quad.Open = quad.Valid;
  quad.Size = std::max(high[0] - low[0], high[1] - low[1]);
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Fill(Group& group, int chunk) const
{
  const Projected& mesh = this->Meshes[static_cast<std::size_t>(this->Target)];
  const int first = Chunk * chunk;
  const int end = std::min(first + Chunk, mesh.Mesh->GetNumberOfTriangles());
  const auto add = [&group](const Quad& quad) {
    if (quad.Valid == 0)
    {
      --group.Count;
      return;
    }
    const int at = group.Count - 1;
    const auto x = std::minmax_element(quad.X, quad.X + 4);
    const auto y = std::minmax_element(quad.Y, quad.Y + 4);
    group.Low[0][at] = Below(*x.first);
    group.High[0][at] = Above(*x.second);
    group.Low[1][at] = Below(*y.first);
    group.High[1][at] = Above(*y.second);
    group.Low[2][at] = BelowDepth(*std::min_element(quad.Q, quad.Q + 4));
    for (int axis = 0; axis < 3; ++axis)
    {
      group.All.Min[axis] = std::min(group.All.Min[axis], group.Low[axis][at]);
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      group.All.Max[axis] = std::max(group.All.Max[axis], group.High[axis][at]);
    }
  };
  for (int i = first; i < end; ++i)
  {
    const Box& box = mesh.Boxes[static_cast<std::size_t>(i)];
    if (!IsInView(box) || this->SampleStates[static_cast<std::size_t>(i)] != 0)
    {
      continue;
    }
    Quad& quad = group.Quads[group.Count++];
    quad = Quad();
    quad.Triangle = i;
    quad.Cell = mesh.Mesh->GetCell(i);
    const std::uint32_t* corners = mesh.Mesh->GetCorners(i);
    const Vertex* v[3] = { &mesh.Vertices[corners[0]], &mesh.Vertices[corners[1]],
      &mesh.Vertices[corners[2]] };
    for (int s = 0; s < Samples; ++s)
    {
      const glm::dvec3& w = this->PointWeights[static_cast<std::size_t>(s)];
      const double a = w.x * v[0]->Z;
      const double b = w.y * v[1]->Z;
      const double c = w.z * v[2]->Z;
      const double q = 1.0 / (a + b + c);
      quad.Q[s] = q;
      quad.X[s] = (a * v[0]->X + b * v[1]->X + c * v[2]->X) * q;
      quad.Y[s] = (a * v[0]->Y + b * v[1]->Y + c * v[2]->Y) * q;
    }
    this->FillQuad(quad, 4);
    // A ray hits its target triangle, unless it sees the triangle edge-on.
    quad.Doubtful = mesh.Sides[static_cast<std::size_t>(i)] == Side::Unclear ? All : 0u;
    add(quad);
  }
  const auto chunkAt = static_cast<std::size_t>(chunk);
  int count = 0; // points in the last quad
  for (std::size_t i = this->Firsts[chunkAt]; i < this->Firsts[chunkAt + 1]; ++i)
  {
    const Vertex& vertex = mesh.Vertices[i];
    if (!this->IsOpen(mesh, i))
    {
      continue;
    }
    if (count == 0)
    {
      group.Quads[group.Count++] = Quad();
    }
    Quad& quad = group.Quads[group.Count - 1];
    quad.X[count] = vertex.X;
    quad.Y[count] = vertex.Y;
    quad.Q[count] = vertex.Q;
    quad.Corners[count] = static_cast<std::uint32_t>(i);
    ++count;
    if (count == 4)
    {
      this->FillQuad(quad, count);
      add(quad);
      count = 0;
    }
  }
  if (count > 0)
  {
    this->FillQuad(group.Quads[group.Count - 1], count);
    add(group.Quads[group.Count - 1]);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    group.Center[axis] = 0.5 * (static_cast<double>(group.All.Min[axis]) + group.All.Max[axis]);
  }
  group.Reach = std::max(group.All.Max.x - group.Center[0], group.All.Max.y - group.Center[1]);
  for (int at = 0; at < group.Count; ++at)
  {
    Quad& quad = group.Quads[at];
    for (int i = 0; i < 4; ++i)
    {
      quad.LocalX[i] = static_cast<float>(quad.X[i] - group.Center[0]);
      quad.LocalY[i] = static_cast<float>(quad.Y[i] - group.Center[1]);
    }
  }
  for (int at = group.Count; at < MostQuads; ++at)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      group.Low[axis][at] = std::numeric_limits<float>::max(); // overlaps nothing
    }
    group.High[0][at] = group.High[1][at] = -std::numeric_limits<float>::max();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::LookAtChunk(int chunk, const View& view)
{
  const int end = std::min(Chunk * (chunk + 1), static_cast<int>(this->SampleStates.size()));
  // Most chunks need a single look.
  const Projected& target = this->Meshes[static_cast<std::size_t>(this->Target)];
  Box around = vtkRelievoWideTree::Nowhere();
  unsigned layered = 0; // bits
  for (int i = Chunk * chunk; i < end; ++i)
  {
    if (this->HasLayer(target, i))
    {
      const Box& box = target.Boxes[static_cast<std::size_t>(i)];
      around = { glm::min(around.Min, box.Min), glm::max(around.Max, box.Max) };
      layered |= 1u << (i - Chunk * chunk);
    }
  }
  const bool isHidden = this->HiddenChunks[static_cast<std::size_t>(chunk)] != 0;
  const State state = isHidden ? State::Hidden : this->Judge(around);
  for (; layered != 0; layered &= layered - 1)
  {
    this->JudgeTriangle(Chunk * chunk + vtkRelievoGetLowest(layered), state);
  }
  bool isOpen = false;
  for (int i = Chunk * chunk; i < end; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    isOpen = isOpen || (this->SampleStates[at] == 0 && IsInView(target.Boxes[at]));
  }
  const auto number = static_cast<std::size_t>(chunk);
  for (std::size_t i = this->Firsts[number]; i < this->Firsts[number + 1]; ++i)
  {
    this->JudgeCorner(i, around, state);
    isOpen = isOpen || this->IsOpen(target, i);
  }
  if (isOpen)
  {
    this->CompareChunk(chunk, view);
  }
}

//------------------------------------------------------------------------------
// Compares the points of a chunk whose state the layers do not determine with triangles.
void vtkRelievoTriangleSight::CompareChunk(int chunk, const View& view)
{
  Group group;
  this->Fill(group, chunk);
  if (group.Count == 0)
  {
    return;
  }
  unsigned open = (1u << group.Count) - 1u;
  const auto look = [&](int meshAt, int triangle) {
    const Projected& mesh = this->Meshes[static_cast<std::size_t>(meshAt)];
    const Box& box = mesh.Boxes[static_cast<std::size_t>(triangle)];
    using Four = vtkRelievoFour;
    unsigned bits = 0;
    for (int i = 0; i < group.Count; i += 4)
    {
      const Four overlaps = (Four(box.Min.x) <= Four::Load(group.High[0] + i)) &
        (Four(box.Min.y) <= Four::Load(group.High[1] + i)) &
        (Four::Load(group.Low[0] + i) <= Four(box.Max.x)) &
        (Four::Load(group.Low[1] + i) <= Four(box.Max.y)) &
        (Four::Load(group.Low[2] + i) <= Four(box.Max.z));
      bits |= vtkRelievoGetBits(overlaps) << i;
    }
    bits &= open;
    if (bits == 0)
    {
      return;
    }
    const std::uint32_t* corners = mesh.Mesh->GetCorners(triangle);
    const Vertex* const v[3] = { &mesh.Vertices[corners[0]], &mesh.Vertices[corners[1]],
      &mesh.Vertices[corners[2]] };
    Facing facing{ meshAt, triangle, { v[0], v[1], v[2] }, {}, {}, GetSize(box),
      this->GetError(box) };
    for (int k = 0; k < 3; ++k)
    {
      facing.X[k] = static_cast<float>(v[k]->X - group.Center[0]);
      facing.Y[k] = static_cast<float>(v[k]->Y - group.Center[1]);
    }
    for (; bits != 0; bits &= bits - 1)
    {
      const int at = vtkRelievoGetLowest(bits);
      Quad& quad = group.Quads[at];
      if (const unsigned hidden = MayHide(facing, quad, group.Reach) & quad.Open)
      {
        this->Compare(quad, facing, hidden);
        open &= quad.Open ? ~0u : ~(1u << at);
      }
    }
  };
  group.All.Max.z = std::numeric_limits<float>::max();
  for (std::size_t m = 0; m < this->Meshes.size() && open != 0; ++m)
  {
    this->Meshes[m].Tree.FindOverlaps(group.All, [&](int first, int count) {
      for (int i = first; i < first + count; ++i)
      {
        look(static_cast<int>(m), i);
      }
      return open != 0;
    });
  }
  for (int i = 0; i < group.Count; ++i)
  {
    for (const Wild& wild : this->Wilds)
    {
      this->CompareWild(group.Quads[i], wild, view);
    }
  }
  this->Keep(group);
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Compare(Quad& quad, const Facing& facing, unsigned hidden) const
{
  const Vertex& a = *facing.Corners[0];
  const Vertex& b = *facing.Corners[1];
  const Vertex& c = *facing.Corners[2];
  const int triangle = facing.Triangle;
  const Projected& mesh = this->Meshes[static_cast<std::size_t>(facing.Mesh)];
  const bool isOfTarget = facing.Mesh == this->Target;
  const double most = std::max(std::max(a.Q, b.Q), c.Q);
  const double size = facing.Size + quad.Size;
  const double margin = facing.Error * size;
  for (; hidden != 0; hidden &= hidden - 1)
  {
    const int i = vtkRelievoGetLowest(hidden);
    const unsigned bit = 1u << i;
    // Twice the areas between the point and the triangle's sides: of equal sign inside.
    const double ax = a.X - quad.X[i];
    const double ay = a.Y - quad.Y[i];
    const double bx = b.X - quad.X[i];
    const double by = b.Y - quad.Y[i];
    const double cx = c.X - quad.X[i];
    const double cy = c.Y - quad.Y[i];
    const double u = bx * cy - cx * by;
    const double v = cx * ay - ax * cy;
    const double w = ax * by - bx * ay;
    const double least = std::min(std::min(u, v), w);
    const double greatest = std::max(std::max(u, v), w);
    if (least < -margin && greatest > margin)
    {
      continue;
    }
    const bool inside = least > margin || greatest < -margin;
    if (isOfTarget && triangle == quad.Triangle)
    {
      continue;
    }
    const double sum = u + v + w;
    const double q = quad.Q[i];
    const double depth = sum < 0.0 ? -1.0 : 1.0;
    const double nearer = depth * (u * (a.Q - q) + v * (b.Q - q) + w * (c.Q - q));
    const double depthMargin = std::abs(sum) * q * (LeastDepth + this->DepthErrorByQ * most) +
      3.0 * margin * std::max(std::max(std::abs(a.Q - q), std::abs(b.Q - q)), std::abs(c.Q - q));
    const bool isSure = std::abs(sum) > 4.0 * margin;
    if (isSure && nearer < -depthMargin)
    {
      continue;
    }
    const bool isOfCell =
      isOfTarget && quad.Triangle >= 0 && mesh.Mesh->GetCell(triangle) == quad.Cell;
    if (inside && isSure && nearer > depthMargin && !isOfCell)
    {
      quad.Hidden |= bit;
      quad.Open &= this->HasManyToACell ? All : ~bit;
      continue;
    }
    if (quad.Triangle < 0 && isOfTarget)
    {
      // A triangle does not hide its own corners, unless it is seen edge-on.
      const Vertex& own = mesh.Vertices[quad.Corners[i]];
      const auto isCorner = [&own](const Vertex& p) {
        return p.X == own.X && p.Y == own.Y && p.Z == own.Z;
      };
      if ((isCorner(a) || isCorner(b) || isCorner(c)) && std::abs(sum) > 1e-5 * size * size)
      {
        continue;
      }
    }
    quad.Doubtful |= bit;
    if (isOfCell)
    {
      quad.Valid &= ~bit; // whatever else hides the point
    }
  }
}

//------------------------------------------------------------------------------
// A direction is d = (u a + v b + w c) / volume, where a, b, c are the triangle's corners.
void vtkRelievoTriangleSight::CompareWild(Quad& quad, const Wild& wild, const View& view) const
{
  const glm::dvec3& a = wild.Corners[0];
  const glm::dvec3& b = wild.Corners[1];
  const glm::dvec3& c = wild.Corners[2];
  const glm::dvec2 center = 0.5 * (view.Low + view.High);
  const glm::dvec2 half = 0.5 * (view.High - view.Low);
  const glm::dvec3 sides[3] = { glm::cross(b, c), glm::cross(c, a), glm::cross(a, b) };
  const double volume = glm::dot(a, sides[0]);
  const double reach = std::max(std::max(glm::length(a), glm::length(b)), glm::length(c));
  // The compared values have errors of Error, and of Rounding in the corners.
  const double margin =
    16.0 * reach * (reach * this->Error + view.Rounding) * (1.0 + glm::length(half + center));
  const bool isSure = std::abs(volume) > margin * reach;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3 d(center.x + half.x * quad.X[i], center.y + half.y * quad.Y[i], 1.0);
    double s[3];
    for (int k = 0; k < 3; ++k)
    {
      s[k] = volume < 0.0 ? -glm::dot(d, sides[k]) : glm::dot(d, sides[k]);
    }
    const double least = std::min(std::min(s[0], s[1]), s[2]);
    const double q = (s[0] + s[1] + s[2]) / std::abs(volume);
    const double off = quad.Q[i] * LeastDepth + 3.0 * margin / std::abs(volume);
    const unsigned bit = 1u << i;
    if (isSure && (least < -margin || q < quad.Q[i] - off))
    {
      continue;
    }
    const bool isOfCell = wild.Mesh == this->Target && quad.Triangle >= 0 &&
      this->Meshes[static_cast<std::size_t>(wild.Mesh)].Mesh->GetCell(wild.Triangle) == quad.Cell;
    if (isSure && least > margin && q > quad.Q[i] + off && !isOfCell)
    {
      quad.Hidden |= bit;
      continue;
    }
    quad.Doubtful |= bit;
    if (isOfCell)
    {
      quad.Valid &= ~bit;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTriangleSight::Keep(const Group& group)
{
  for (int at = 0; at < group.Count; ++at)
  {
    const Quad& quad = group.Quads[at];
    const unsigned hidden = quad.Hidden & quad.Valid;
    const unsigned seen = quad.Valid & ~(quad.Hidden | quad.Doubtful);
    if (quad.Triangle >= 0)
    {
      this->SampleStates[static_cast<std::size_t>(quad.Triangle)] |=
        static_cast<std::uint8_t>(seen | hidden << 4);
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      if ((seen | hidden) >> i & 1)
      {
        this->CornerStates[quad.Corners[i]] = seen >> i & 1 ? State::Seen : State::Hidden;
      }
    }
  }
}
