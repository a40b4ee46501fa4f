// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Boxes around the points of a mesh by their bones, which give a box around the moved points
 * without moving them.
 */
#ifndef vtkRelievoSkinBounds_h
#define vtkRelievoSkinBounds_h

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace relievo
{
struct SkinBox
{
  glm::dvec3 Low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 High{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& point); ///< NaN is ignored
  void Add(const SkinBox& box);
  /// Adds another box transformed by a matrix, or only rotated about the origin, enlarged by
  /// `reach` and by relative errors of `rounding`: by default those of floats, with a margin.
  void Add(const SkinBox& box, const glm::dmat4& matrix, double reach, double rounding = 1e-6);
  void Move(const glm::dvec3& by); ///< an empty box stays empty
  bool IsEmpty() const { return !(this->Low.x <= this->High.x); }
};

class SkinBounds
{
public:
  /// A point with the bones that move it, strongest first, and weights with sum 1; `count` may be
  /// 0.
  void Add(const glm::dvec3& point, const int* joints, const float* weights, int count);

  /// Adds the points of another object.
  void Add(const SkinBounds& other);

  /// A box around all points blended by matrices: they lie between the positions given by their
  /// bones alone. Points without a bone are moved by `unmovedBy`.
  SkinBox GetOfMatrices(
    const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy = glm::dvec3(0.)) const;

  /// A box around all points blended by dual quaternions: near the position given by the strongest
  /// bone, within the deviations of the others.
  SkinBox GetOfMotions(
    const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy = glm::dvec3(0.)) const;

private:
  // Points with this strongest bone and that other bone; the same bone if it is alone.
  struct Pair
  {
    SkinBox Box;
    double Ratio = 0.; // largest ratio of the other's weight to the strongest's
    int Others = 0;    // most bones besides the strongest
  };

  Pair& GetPair(int place, int first, int second);

  std::map<std::pair<int, int>, Pair> Pairs;
  // The last pair of each index: adjacent points of the mesh mostly have the same bones.
  struct Recent
  {
    Recent() = default;
    Recent(const Recent&) {} // a copy has its own pairs
    void operator=(const Recent&) { this->At = nullptr; }

    std::pair<int, int> Bones{ -1, -1 };
    Pair* At = nullptr;
  };
  std::array<Recent, 8> Last;
  SkinBox Unmoved;
};
}

#endif
