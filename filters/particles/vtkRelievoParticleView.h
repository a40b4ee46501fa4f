// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An orthographic depth image as a surface for particles. Map coordinates: the centre of texel (i,
// j) is at (i, j); the third coordinate is the depth along the viewing direction. All are in
// texels.
#ifndef vtkRelievoParticleView_h
#define vtkRelievoParticleView_h

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// A position on the surface that a view sees.
struct vtkRelievoParticlePlace
{
  glm::dvec3 Position; // world
  glm::vec3 Normal;    // towards the viewer, of length 1
  glm::vec3 Velocity;  // world units per unit of time
  double Facing = 0.;  // the cosine between the normal and the direction to the viewer
};

class vtkRelievoParticleView
{
public:
  // An empty view: toMap and offset convert world to map coordinates.
  vtkRelievoParticleView(
    int width, int height, const glm::dmat3& toMap, const glm::dvec3& offset, double texel);

  // Sets a depth in texels; infinity if nothing is visible, as initially in all texels.
  void SetDepth(std::size_t texel, double depth);
  double GetDepth(std::size_t texel) const { return this->Texels[texel].Depth; }
  bool IsSeen(std::size_t texel) const;

  // Computes normals from adjacent depths, once all depths are set.
  void ComputeNormals();

  std::size_t GetNumberOfTexels() const { return this->Texels.size(); }
  double GetTexelSize() const { return this->TexelSize; } // world units
  const glm::dvec3& GetLook() const { return this->Look; }

  // The surface in a texel; partX and partY are offsets in it, -0.5 to 0.5.
  vtkRelievoParticlePlace At(std::size_t texel, double partX = 0., double partY = 0.) const;
  void SetVelocity(std::size_t texel, const glm::vec3& velocity);

  // The surface at a position: within one texel of the depth at the nearest texel's centre,
  // interpolated between the surrounding texels that see the same surface. False if the nearest
  // texel is empty; with `snap`, its nearest non-empty neighbour takes its place.
  bool Find(const glm::dvec3& position, bool snap, vtkRelievoParticlePlace& place) const;

  // Only the velocity, if the four surrounding texels see the position's surface; otherwise false.
  bool FindVelocity(const glm::dvec3& position, glm::vec3& velocity) const;

  // Distance of a position in front of the nearest texel's surface (above 0), in world units along
  // the viewing direction; infinity if the texel is empty.
  double GetHeight(const glm::dvec3& position) const;

  static std::size_t GetBytesPerTexel() { return sizeof(Texel); }

private:
  struct alignas(32) Texel
  {
    float Depth;
    glm::vec3 Normal;
    glm::vec3 Velocity;
  };
  glm::dvec3 ToMap(const glm::dvec3& position) const { return this->Map * position + this->Offset; }
  // The texel if it is not empty.
  const Texel* GetSeen(int i, int j) const
  {
    if (i < 0 || i >= this->Width || j < 0 || j >= this->Height)
    {
      return nullptr;
    }
    const Texel* texel = &this->Texels[static_cast<std::size_t>(j) * this->Width + i];
    return texel->Depth < std::numeric_limits<float>::infinity() ? texel : nullptr;
  }
  const Texel* GetNearest(const glm::dvec3& map, int& i, int& j) const;
  bool Snap(glm::dvec3& map, int& i, int& j) const;
  vtkRelievoParticlePlace Blend(const glm::dvec3& map, const Texel& nearest) const;

  // Largest difference of depth, in texels, between texels of one surface. A view covers slopes of
  // up to 60 degrees: a diagonal neighbour is then 2.4 texels farther.
  static constexpr float Step = 3.F;

  // Largest difference between a position's depth and the nearest texel's. A texel's corner is
  // 0.708 texels from its centre: together that is less than a texel.
  static constexpr double Slack = 0.7;

  // The floor of a coordinate not far below 0: std::floor is a function call on the oldest
  // supported processors.
  static int WholeOf(double coordinate) { return static_cast<int>(coordinate + 8.) - 8; }

  int Width;
  int Height;
  glm::dmat3 Map;
  glm::dvec3 Offset;
  glm::dmat3 World; // of map coordinates, without the offset
  glm::dvec3 Look;  // of length 1
  double TexelSize;
  std::vector<Texel> Texels;
};

// Inline in the header, as shared libraries prevent inlining otherwise: these run millions of times
// per step.
//------------------------------------------------------------------------------
inline const vtkRelievoParticleView::Texel* vtkRelievoParticleView::GetNearest(
  const glm::dvec3& map, int& i, int& j) const
{
  const bool near = map.x >= -1. && map.x <= this->Width && map.y >= -1. && map.y <= this->Height;
  i = near ? WholeOf(map.x + 0.5) : -9;
  j = near ? WholeOf(map.y + 0.5) : -9;
  return this->GetSeen(i, j);
}

//------------------------------------------------------------------------------
inline vtkRelievoParticlePlace vtkRelievoParticleView::Blend(
  const glm::dvec3& map, const Texel& nearest) const
{
  const int x = WholeOf(map.x);
  const int y = WholeOf(map.y);
  const auto partX = static_cast<float>(map.x - x);
  const auto partY = static_cast<float>(map.y - y);
  float sum = 0.F;
  float depth = 0.F; // relative to the nearest texel
  glm::vec3 normal(0.F);
  glm::vec3 velocity(0.F);
  const auto add = [&](const Texel& texel, float weight) {
    const float beyond = texel.Depth - nearest.Depth;
    if (std::abs(beyond) <= Step) // not if it is empty
    {
      sum += weight;
      depth += weight * beyond;
      normal += weight * texel.Normal;
      velocity += weight * texel.Velocity;
    }
  };
  if (x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height)
  {
    const Texel* lower = &this->Texels[static_cast<std::size_t>(y) * this->Width + x];
    const Texel* upper = lower + this->Width;
    add(lower[0], (1.F - partX) * (1.F - partY));
    add(lower[1], partX * (1.F - partY));
    add(upper[0], (1.F - partX) * partY);
    add(upper[1], partX * partY);
  }
  else
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      if (const Texel* texel = this->GetSeen(x + (corner & 1), y + (corner >> 1)))
      {
        add(*texel, ((corner & 1) ? partX : 1.F - partX) * ((corner >> 1) ? partY : 1.F - partY));
      }
    }
  }
  // The nearest texel is one of the four and has a weight of at least a quarter.
  vtkRelievoParticlePlace place;
  const double beyond = std::clamp(static_cast<double>(depth) / sum, -Slack, Slack);
  place.Position = this->World * (glm::dvec3(map.x, map.y, nearest.Depth + beyond) - this->Offset);
  const float length = glm::length(normal);
  place.Normal = length > 1e-3F ? normal / length : nearest.Normal;
  velocity /= sum;
  place.Velocity = velocity - glm::dot(velocity, place.Normal) * place.Normal;
  place.Facing = -glm::dot(glm::dvec3(place.Normal), this->Look);
  return place;
}

#endif
