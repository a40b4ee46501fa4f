// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTangentSpace.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace relievo
{
namespace
{
// Bit patterns of numbers; -0 counts as 0.
template <std::size_t Count>
struct Bits
{
  std::array<std::uint64_t, Count> Words;

  bool operator==(const Bits& other) const { return this->Words == other.Words; }
};

template <std::size_t Count>
struct BitsHash
{
  std::size_t operator()(const Bits<Count>& bits) const
  {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint64_t word : bits.Words)
    {
      hash = (hash ^ word) * 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

std::uint64_t BitsOf(double value)
{
  const double number = value + 0.; // -0 becomes 0
  std::uint64_t word;
  std::memcpy(&word, &number, sizeof(word));
  return word;
}

glm::dvec3 UnitOrZero(const glm::dvec3& v)
{
  const double size = glm::length(v);
  return size > 0. && std::isfinite(size) ? v / size : glm::dvec3(0.);
}

// v without its component along the normal n, which has length 1 or 0.
glm::dvec3 InPlane(const glm::dvec3& v, const glm::dvec3& n)
{
  return UnitOrZero(v - n * glm::dot(n, v));
}

// A unit vector perpendicular to n: from the axis along which n is smallest.
glm::dvec3 AcrossNormal(const glm::dvec3& n)
{
  const glm::dvec3 size = glm::abs(n);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z
    ? glm::dvec3(1., 0., 0.)
    : (size.y <= size.z ? glm::dvec3(0., 1., 0.) : glm::dvec3(0., 0., 1.));
  return InPlane(axis, n);
}
}

//------------------------------------------------------------------------------
TangentSpace::TangentSpace(std::vector<Vertex> vertices, const std::vector<Triangle>& triangles)
  : Vertices(std::move(vertices))
  , Faces(triangles.size())
{
  for (Vertex& vertex : this->Vertices)
  {
    vertex.Normal = UnitOrZero(vertex.Normal);
  }
  this->Join(triangles);
  this->MeasureFaces();
  this->FindNeighbours();
  this->FindGroups();
  this->GroupOfVertex.assign(this->Vertices.size(), None);
  this->GroupOfPlace.assign(this->Vertices.size(), None);
  for (std::size_t g = 0; g < this->Groups.size(); ++g)
  {
    Group& group = this->Groups[g];
    this->Average(group);
    for (int* of :
      { &this->GroupOfVertex[group.Vertex], &this->GroupOfPlace[this->Place[group.Vertex]] })
    {
      *of = *of == None ? static_cast<int>(g) : *of;
    }
  }
}

//------------------------------------------------------------------------------
void TangentSpace::Join(const std::vector<Triangle>& triangles)
{
  std::unordered_map<Bits<8>, int, BitsHash<8>> known;
  std::unordered_map<Bits<3>, int, BitsHash<3>> places;
  known.reserve(this->Vertices.size());
  places.reserve(this->Vertices.size());
  std::vector<int> joined;
  joined.reserve(this->Vertices.size());
  this->Place.reserve(this->Vertices.size());
  for (const Vertex& vertex : this->Vertices)
  {
    const int own = static_cast<int>(joined.size());
    const glm::dvec3& p = vertex.Position;
    const glm::dvec3& n = vertex.Normal;
    const Bits<3> place = { { BitsOf(p.x), BitsOf(p.y), BitsOf(p.z) } };
    const Bits<8> all = { { place.Words[0], place.Words[1], place.Words[2], BitsOf(n.x),
      BitsOf(n.y), BitsOf(n.z), BitsOf(vertex.Texture.x), BitsOf(vertex.Texture.y) } };
    joined.push_back(known.emplace(all, own).first->second);
    this->Place.push_back(places.emplace(place, own).first->second);
  }
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Faces[f].Vertex[i] = joined[triangles[f][i]];
    }
  }
}

//------------------------------------------------------------------------------
void TangentSpace::MeasureFaces()
{
  for (Face& face : this->Faces)
  {
    const Vertex* corner[3];
    int place[3];
    for (int i = 0; i < 3; ++i)
    {
      corner[i] = &this->Vertices[face.Vertex[i]];
      place[i] = this->Place[face.Vertex[i]];
    }
    face.Collapsed = place[0] == place[1] || place[1] == place[2] || place[2] == place[0];
    const glm::dvec3 d1 = corner[1]->Position - corner[0]->Position;
    const glm::dvec3 d2 = corner[2]->Position - corner[0]->Position;
    const glm::dvec2 t1 = corner[1]->Texture - corner[0]->Texture;
    const glm::dvec2 t2 = corner[2]->Texture - corner[0]->Texture;
    const double area = t1.x * t2.y - t1.y * t2.x;
    // Texture area that rounding to float may give a triangle without area.
    double largest = 0.;
    for (const Vertex* v : corner)
    {
      largest = std::max({ largest, std::abs(v->Texture.x), std::abs(v->Texture.y) });
    }
    const double doubt = 0x1p-23 * largest * (glm::length(t1) + glm::length(t2));
    const glm::dvec3 s = t2.y * d1 - t1.y * d2;
    const glm::dvec3 t = t1.x * d2 - t2.x * d1;
    face.Preserving = area > 0.;
    face.S = UnitOrZero(s) * (face.Preserving ? 1. : -1.);
    face.T = UnitOrZero(t) * (face.Preserving ? 1. : -1.);
    // Written so that NaN counts as without area.
    const bool measured = std::abs(area) > doubt && std::isfinite(area) && glm::dot(s, s) > 0. &&
      glm::dot(t, t) > 0. && std::isfinite(glm::dot(s, s) + glm::dot(t, t));
    face.JoinsAny = face.Collapsed || !measured;
    this->NumberOfDegenerate += face.JoinsAny ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void TangentSpace::FindNeighbours()
{
  // Faces at each edge, in order, by its two vertices. An adjacent face runs through the edge in
  // the other direction; if more than two faces meet, they are paired in order.
  struct Edge
  {
    std::uint64_t Key;
    int Face;
    int Side;
    bool Forward;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * this->Faces.size());
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const Face& face = this->Faces[f];
    for (int i = 0; i < 3 && !face.Collapsed; ++i)
    {
      const auto a = static_cast<std::uint64_t>(face.Vertex[i]);
      const auto b = static_cast<std::uint64_t>(face.Vertex[(i + 1) % 3]);
      edges.push_back({ std::min(a, b) << 32 | std::max(a, b), static_cast<int>(f), i, a < b });
    }
  }
  std::stable_sort(
    edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Key < b.Key; });
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    int& mine = this->Faces[edges[e].Face].Neighbour[edges[e].Side];
    for (std::size_t o = e + 1; mine == None && o < edges.size() && edges[o].Key == edges[e].Key;
         ++o)
    {
      int& other = this->Faces[edges[o].Face].Neighbour[edges[o].Side];
      if (other == None && edges[o].Forward != edges[e].Forward)
      {
        mine = edges[o].Face;
        other = edges[e].Face;
      }
    }
  }
}

//------------------------------------------------------------------------------
void TangentSpace::FindGroups()
{
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Face& face = this->Faces[f];
      if (!face.JoinsAny && face.Group[i] == None)
      {
        this->Groups.push_back({ face.Vertex[i], face.Preserving, glm::dvec4(0.), {} });
        this->Grow(static_cast<int>(this->Groups.size()) - 1, static_cast<int>(f));
      }
    }
  }
}

//------------------------------------------------------------------------------
void TangentSpace::Grow(int group, int first)
{
  Group& all = this->Groups[group];
  std::vector<int> waiting = { first };
  while (!waiting.empty())
  {
    const int f = waiting.back();
    waiting.pop_back();
    Face& face = this->Faces[f];
    const auto found = std::find(face.Vertex.begin(), face.Vertex.end(), all.Vertex);
    const auto i = static_cast<int>(found - face.Vertex.begin());
    if (i == 3 || face.Group[i] != None)
    {
      continue;
    }
    if (face.JoinsAny && face.Group[0] == None && face.Group[1] == None && face.Group[2] == None)
    {
      face.Preserving = all.Preserving;
    }
    if (face.Preserving != all.Preserving)
    {
      continue;
    }
    face.Group[i] = group;
    all.Faces.push_back(f);
    // The last neighbour first: a face without texture area takes the group that reaches it first.
    for (const int next : { face.Neighbour[(i + 2) % 3], face.Neighbour[i] })
    {
      if (next != None)
      {
        waiting.push_back(next);
      }
    }
  }
}

//------------------------------------------------------------------------------
void TangentSpace::Average(Group& group)
{
  glm::dvec3 sum(0.);
  glm::dvec3 bitangents(0.);
  const glm::dvec3 normal = this->Vertices[group.Vertex].Normal;
  const glm::dvec3 here = this->Vertices[group.Vertex].Position;
  for (const int f : group.Faces)
  {
    const Face& face = this->Faces[f];
    if (!face.JoinsAny)
    {
      const auto found = std::find(face.Vertex.begin(), face.Vertex.end(), group.Vertex);
      const auto i = found - face.Vertex.begin();
      const glm::dvec3 next = this->Vertices[face.Vertex[(i + 1) % 3]].Position - here;
      const glm::dvec3 last = this->Vertices[face.Vertex[(i + 2) % 3]].Position - here;
      const glm::dvec3 a = InPlane(next, normal);
      const glm::dvec3 b = InPlane(last, normal);
      const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      sum += angle * InPlane(face.S, normal);
      bitangents += angle * InPlane(face.T, normal);
    }
  }
  const glm::dvec3 tangent = UnitOrZero(sum);
  // The side towards which v grows. If triangles wind as their normals require, `Preserving` tells
  // it; it also decides where the side cannot be determined.
  const double side = glm::dot(glm::cross(normal, tangent), bitangents);
  const bool right = side != 0. ? side > 0. : group.Preserving;
  group.Tangent =
    glm::dvec4(tangent == glm::dvec3(0.) ? AcrossNormal(normal) : tangent, right ? 1. : -1.);
  group.Faces = std::vector<int>(); // no longer needed
}

//------------------------------------------------------------------------------
glm::dvec4 TangentSpace::GetTangent(std::size_t triangle, int corner) const
{
  const Face& face = this->Faces[triangle];
  const int vertex = face.Vertex[corner];
  const int group = face.Group[corner] == None ? this->GroupOfVertex[vertex] : face.Group[corner];
  if (group != None)
  {
    return this->Groups[group].Tangent;
  }
  const glm::dvec3 normal = this->Vertices[vertex].Normal;
  const int beside = this->GroupOfPlace[this->Place[vertex]];
  if (beside != None)
  {
    const glm::dvec4 borrowed = this->Groups[beside].Tangent;
    const glm::dvec3 tangent = InPlane(glm::dvec3(borrowed), normal);
    if (tangent != glm::dvec3(0.))
    {
      return glm::dvec4(tangent, borrowed.w);
    }
  }
  return glm::dvec4(AcrossNormal(normal), 1.);
}
}
