// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts layers of triangles over squares of a picture, for the two visible sides separately.
// Triangles that join without a gap cover each point of a square as often as its centre, if the
// outline of the layer does not cross the square: a layer in front of all triangles of the other
// side is visible, and triangles behind it are hidden, whatever their shapes.
//
// X and Y are -1 to 1 in the picture, Q grows towards the eye.
#ifndef vtkRelievoLayerGrid_h
#define vtkRelievoLayerGrid_h

#include "vtkRelievoWideTree.h"

#include <cstddef>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoLayerGrid
{
public:
  using Box = vtkRelievoWideTree::Box;

  // Empties the grid for `triangles` triangles of roughly this size.
  void Clear(std::size_t triangles, double size);

  // Adds a triangle of one side, 0 or 1, with its box; `margin`: the error of twice the areas
  // between a square's centre and the triangle's sides.
  void Add(int side, const glm::dvec2 corners[3], const Box& box, double margin);

  // Adds an edge of a layer's outline.
  void AddOutline(const glm::dvec2& a, const glm::dvec2& b);

  // Marks the box's content as having no side.
  void Block(const Box& box);

  // IsHidden: whether the box's content is hidden by a layer in front of it. IsFirst: whether
  // nothing lies in front of a triangle of that side. False if this is unknown.
  bool IsHidden(const Box& box) const;
  bool IsFirst(const Box& box, int side) const;

private:
  struct Square
  {
    float Least[2]; // range of Q of triangles that may reach into the square, by side
    float Greatest[2];
    int Layers[2];
    bool IsCrossed;
  };

  static constexpr std::size_t MostLooks = 32; // squares visited per triangle

  int GetPlace(double x) const;
  template <typename Visit>
  bool ForEach(const Box& box, Visit visit) const;
  Square& At(int column, int row)
  {
    return this->Squares[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Count) +
      static_cast<std::size_t>(column)];
  }

  int Count = 0;        // squares in each direction
  std::size_t Left = 0; // visits left; 0: the grid has no answers
  std::vector<Square> Squares;
};

#endif
