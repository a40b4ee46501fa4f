// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinBounds.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinBones.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
glm::dvec3 GetMiddle(const SkinBox& box)
{
  return (box.Low + box.High) * 0.5;
}

glm::dvec3 GetHalf(const SkinBox& box)
{
  return (box.High - box.Low) * 0.5;
}

// Half sizes of a box around a rotated box.
glm::dvec3 Spread(const glm::dmat3& m, const glm::dvec3& half)
{
  return glm::abs(m[0]) * half.x + glm::abs(m[1]) * half.y + glm::abs(m[2]) * half.z;
}
}

//------------------------------------------------------------------------------
void SkinBox::Add(const glm::dvec3& point)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Low[i] = point[i] < this->Low[i] ? point[i] : this->Low[i];
    this->High[i] = point[i] > this->High[i] ? point[i] : this->High[i];
  }
}

//------------------------------------------------------------------------------
void SkinBox::Add(const SkinBox& box)
{
  this->Low = glm::min(this->Low, box.Low);
  this->High = glm::max(this->High, box.High);
}

//------------------------------------------------------------------------------
void SkinBox::Add(const SkinBox& box, const glm::dmat4& matrix, double reach, double rounding)
{
  if (box.IsEmpty())
  {
    return;
  }
  const glm::dvec3 middle(matrix * glm::dvec4(GetMiddle(box), 1.));
  const glm::dvec3 half = Spread(glm::dmat3(matrix), GetHalf(box)) + glm::dvec3(reach);
  const glm::dvec3 room = (glm::abs(middle) + half) * rounding;
  this->Add(middle - half - room);
  this->Add(middle + half + room);
}

//------------------------------------------------------------------------------
void SkinBox::Move(const glm::dvec3& by)
{
  this->Low += by;
  this->High += by;
}

//------------------------------------------------------------------------------
void SkinBounds::Add(const glm::dvec3& point, const int* joints, const float* weights, int count)
{
  if (count == 0)
  {
    this->Unmoved.Add(point);
    return;
  }
  for (int i = count == 1 ? 0 : 1; i < count; ++i)
  {
    Pair& pair = this->GetPair(i, joints[0], joints[i]);
    pair.Box.Add(point);
    if (i > 0)
    {
      pair.Ratio = std::max(pair.Ratio, static_cast<double>(weights[i]) / weights[0]);
      pair.Others = std::max(pair.Others, count - 1);
    }
  }
}

//------------------------------------------------------------------------------
SkinBounds::Pair& SkinBounds::GetPair(int place, int first, int second)
{
  Recent& last = this->Last[static_cast<std::size_t>(place)];
  if (!last.At || last.Bones != std::make_pair(first, second))
  {
    last.Bones = { first, second };
    last.At = &this->Pairs[last.Bones];
  }
  return *last.At;
}

//------------------------------------------------------------------------------
void SkinBounds::Add(const SkinBounds& other)
{
  for (const auto& [bones, theirs] : other.Pairs)
  {
    Pair& pair = this->Pairs[bones];
    pair.Box.Add(theirs.Box);
    pair.Ratio = std::max(pair.Ratio, theirs.Ratio);
    pair.Others = std::max(pair.Others, theirs.Others);
  }
  this->Unmoved.Add(other.Unmoved);
}

//------------------------------------------------------------------------------
SkinBox SkinBounds::GetOfMatrices(
  const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy) const
{
  SkinBox all = this->Unmoved;
  all.Move(unmovedBy);
  for (const auto& [bones, pair] : this->Pairs)
  {
    all.Add(pair.Box, matrices[static_cast<std::size_t>(bones.first)], 0.);
    if (bones.first != bones.second)
    {
      all.Add(pair.Box, matrices[static_cast<std::size_t>(bones.second)], 0.);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
// Take as origin the point moved by the strongest bone s, and x_i the point moved by bone i with
// the stretch of s. The blended rotations then move the point to the sum of w_i x_i times q_i
// conj(q), divided by |q|^2. Its distance is at most the sum of w_i |x_i| / |q|, and |q| is at
// least the sum of w_i q_i.q_s. The blended stretches differ from that of s by the sum of w_i (S_i
// - S_s).
SkinBox SkinBounds::GetOfMotions(
  const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy) const
{
  std::vector<BoneMotion<double>> motions;
  std::vector<glm::dmat4> rigid;
  for (const glm::dmat4& m : matrices)
  {
    motions.push_back(GetMotion<double>(m));
    rigid.emplace_back(f64::relievoQuaternionMatrix(motions.back().Rotation));
    rigid.back()[3] = m[3];
  }
  const auto farthest = [](const glm::dmat4& m, const SkinBox& box) {
    const glm::dvec3 middle(m * glm::dvec4(GetMiddle(box), 1.));
    return glm::length(glm::abs(middle) + Spread(glm::dmat3(m), GetHalf(box)));
  };
  SkinBox all = this->Unmoved;
  all.Move(unmovedBy);
  for (const auto& [bones, pair] : this->Pairs)
  {
    const auto strongest = static_cast<std::size_t>(bones.first);
    const auto other = static_cast<std::size_t>(bones.second);
    const BoneMotion<double>& s = motions[strongest];
    const BoneMotion<double>& o = motions[other];
    const double turned =
      farthest((rigid[other] - rigid[strongest]) * glm::dmat4(s.Stretch), pair.Box);
    glm::dmat4 stretch(o.Stretch - s.Stretch);
    stretch[3] = glm::dvec4(0.);
    const double share =
      pair.Ratio / (1. + pair.Ratio * std::abs(glm::dot(o.Rotation, s.Rotation)));
    const double stretched = farthest(stretch, pair.Box) * pair.Ratio / (1. + pair.Ratio);
    all.Add(pair.Box, matrices[strongest], pair.Others * (share * turned + stretched));
  }
  return all;
}
}
