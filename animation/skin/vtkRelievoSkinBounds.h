// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Boxes around the points of a mesh by their bones, from which a box around the moved points
 * follows without moving them.
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

  void Add(const glm::dvec3& point); ///< what is not a number is left out
  void Add(const SkinBox& box);
  /// Another box moved by a matrix, or only its turn about the origin, and larger by `reach`, and
  /// by what `rounding` makes of its numbers: by default floats, with some to spare.
  void Add(const SkinBox& box, const glm::dmat4& matrix, double reach, double rounding = 1e-6);
  void Move(const glm::dvec3& by); ///< an empty one stays empty
  bool IsEmpty() const { return !(this->Low.x <= this->High.x); }
};

class SkinBounds
{
public:
  /// A point with the bones that move it, strongest first, and weights of sum 1; `count` may be 0.
  void Add(const glm::dvec3& point, const int* joints, const float* weights, int count);

  /// All that another has.
  void Add(const SkinBounds& other);

  /// Around all points, blended by matrices: between the places where their bones alone put them;
  /// those of no bone are moved by `unmovedBy`.
  SkinBox GetOfMatrices(
    const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy = glm::dvec3(0.)) const;

  /// Around all points, blended by dual quaternions: near the place where the strongest bone alone
  /// puts them, by as much as the others disagree.
  SkinBox GetOfMotions(
    const std::vector<glm::dmat4>& matrices, const glm::dvec3& unmovedBy = glm::dvec3(0.)) const;

private:
  // Of the points with this strongest bone and that other one; the bone itself where it is alone.
  struct Pair
  {
    SkinBox Box;
    double Ratio = 0.; // largest, of the other's weight to the strongest's
    int Others = 0;    // most bones besides the strongest
  };

  Pair& GetPair(int place, int first, int second);

  std::map<std::pair<int, int>, Pair> Pairs;
  // The last of each place, as neighbours in the mesh mostly have the same bones.
  struct Recent
  {
    Recent() = default;
    Recent(const Recent&) {} // a copy has pairs of its own
    void operator=(const Recent&) { this->At = nullptr; }

    std::pair<int, int> Bones{ -1, -1 };
    Pair* At = nullptr;
  };
  std::array<Recent, 8> Last;
  SkinBox Unmoved;
};
}

#endif
