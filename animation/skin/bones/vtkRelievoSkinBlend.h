// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The combined effect of a point's bones, by method. Numbers are in groups of four for vector
 * instructions; each point is computed separately, so threads do not change the result.
 */
#ifndef vtkRelievoSkinBlend_h
#define vtkRelievoSkinBlend_h

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinBones.h"
#include "vtkRelievoSkinWeights.h"

#include <array>
#include <cstddef>
#include <vector>

namespace relievo
{
template <typename Real>
struct alignas(4 * sizeof(Real)) Four
{
  Real V[4] = {};

  void Add(const Four& other, Real weight)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->V[i] += other.V[i] * weight;
    }
  }
  void Scale(Real by)
  {
    for (Real& value : this->V)
    {
      value *= by;
    }
  }
  glm::vec<3, Real> GetVector() const
  {
    return glm::vec<3, Real>(this->V[0], this->V[1], this->V[2]);
  }
};

template <typename Real>
Four<Real> ToFour(const glm::vec<4, Real>& v)
{
  return { { v.x, v.y, v.z, v.w } };
}

/// The transform of one point's surroundings: the columns of a matrix, the last being the
/// translation.
template <typename Real>
struct SkinChange
{
  std::array<Four<Real>, 4> Columns;

  glm::mat<3, 3, Real> GetLinear() const
  {
    return glm::mat<3, 3, Real>(
      this->Columns[0].GetVector(), this->Columns[1].GetVector(), this->Columns[2].GetVector());
  }
};

template <typename Real>
class MatrixBlend
{
public:
  explicit MatrixBlend(const std::vector<glm::dmat4>& matrices)
  {
    for (const glm::dmat4& m : matrices)
    {
      SkinChange<Real> bone;
      for (int i = 0; i < 4; ++i)
      {
        bone.Columns[static_cast<std::size_t>(i)] = ToFour(glm::vec<4, Real>(m[i]));
      }
      this->Bones.push_back(bone);
    }
  }

  /// Computes the transform; false if the point has no bone.
  bool Get(const int* joints, const float* weights, int count, SkinChange<Real>& change) const
  {
    SkinChange<Real> sum;
    Real whole = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      const auto weight = static_cast<Real>(weights[i]);
      if (IsInfluence(joints[i], weights[i], this->Bones.size()))
      {
        for (std::size_t j = 0; j < 4; ++j)
        {
          sum.Columns[j].Add(this->Bones[bone].Columns[j], weight);
        }
        whole += weight;
      }
    }
    const Real scale = Real(1) / whole;
    for (Four<Real>& column : sum.Columns)
    {
      column.Scale(scale);
    }
    change = sum;
    return whole > Real(0);
  }

private:
  std::vector<SkinChange<Real>> Bones;
};

template <typename Real>
class DualBlend
{
public:
  explicit DualBlend(const std::vector<glm::dmat4>& matrices)
  {
    for (const glm::dmat4& m : matrices)
    {
      const BoneMotion<double> motion = GetMotion<double>(m);
      Bone bone;
      bone.Rotation = ToFour(glm::vec<4, Real>(motion.Rotation));
      bone.Dual = ToFour(glm::vec<4, Real>(motion.Dual));
      for (int i = 0; i < 3; ++i)
      {
        const glm::dvec3& column = motion.Stretch[i];
        bone.Stretch[static_cast<std::size_t>(i)] =
          ToFour(glm::vec<4, Real>(glm::dvec4(column, 0.)));
        this->Rigid = this->Rigid && glm::length(column - glm::dmat3(1.)[i]) < 1e-12;
      }
      this->Bones.push_back(bone);
    }
  }

  bool Get(const int* joints, const float* weights, int count, SkinChange<Real>& change) const
  {
    // For both number types.
    using f32::relievoDualCancels;
    using f32::relievoDualWeight;
    using f64::relievoDualCancels;
    using f64::relievoDualWeight;
    const Bone* strongest = nullptr;
    Real most = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      if (static_cast<Real>(weights[i]) > most &&
        IsInfluence(joints[i], weights[i], this->Bones.size()))
      {
        most = static_cast<Real>(weights[i]);
        strongest = &this->Bones[bone];
      }
    }
    if (!strongest)
    {
      return false;
    }
    Bone sum;
    Real whole = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      const auto weight = static_cast<Real>(weights[i]);
      if (IsInfluence(joints[i], weights[i], this->Bones.size()))
      {
        const Bone& from = this->Bones[bone];
        const Real side =
          relievoDualWeight(ToVector(from.Rotation), ToVector(strongest->Rotation), weight);
        sum.Rotation.Add(from.Rotation, side);
        sum.Dual.Add(from.Dual, side);
        if (!this->Rigid)
        {
          for (std::size_t j = 0; j < 3; ++j)
          {
            sum.Stretch[j].Add(from.Stretch[j], weight);
          }
        }
        whole += weight;
      }
    }
    if (relievoDualCancels(ToVector(sum.Rotation), whole))
    {
      sum.Rotation = strongest->Rotation;
      sum.Dual = strongest->Dual;
    }
    this->Apply(sum, whole, change);
    return true;
  }

private:
  struct Bone
  {
    Four<Real> Rotation;
    Four<Real> Dual;
    std::array<Four<Real>, 3> Stretch;
  };

  static glm::vec<4, Real> ToVector(const Four<Real>& four)
  {
    return glm::vec<4, Real>(four.V[0], four.V[1], four.V[2], four.V[3]);
  }

  void Apply(const Bone& sum, Real whole, SkinChange<Real>& change) const
  {
    // For both number types.
    using f32::relievoDualTranslation;
    using f32::relievoQuaternionMatrix;
    using f64::relievoDualTranslation;
    using f64::relievoQuaternionMatrix;
    const glm::vec<4, Real> rotation = ToVector(sum.Rotation);
    glm::mat<3, 3, Real> linear = relievoQuaternionMatrix(glm::normalize(rotation));
    if (!this->Rigid)
    {
      glm::mat<3, 3, Real> stretch;
      for (int i = 0; i < 3; ++i)
      {
        stretch[i] = sum.Stretch[static_cast<std::size_t>(i)].GetVector() / whole;
      }
      linear = linear * stretch;
    }
    for (int i = 0; i < 3; ++i)
    {
      change.Columns[static_cast<std::size_t>(i)] = ToFour(glm::vec<4, Real>(linear[i], Real(0)));
    }
    change.Columns[3] =
      ToFour(glm::vec<4, Real>(relievoDualTranslation(rotation, ToVector(sum.Dual)), Real(1)));
  }

  std::vector<Bone> Bones;
  bool Rigid = true; // no bone of the mesh stretches
};
}

#endif
