// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How many layers of triangles lie over squares of a picture, apart for the two sides that they
// show. Triangles that join without a gap lie over each point of a square as often as over its
// middle, if the outline of what they make does not cross it: where one layer lies before all of
// the other side, it is seen, and what lies behind it is hidden, whichever the triangles are.
//
// X and Y are -1 to 1 in the picture, Q is larger the nearer it is.
#ifndef vtkRelievoLayerGrid_h
#define vtkRelievoLayerGrid_h

#include "vtkRelievoWideTree.h"

#include <cstddef>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoLayerGrid
{
public:
  using Box = vtkRelievoWideTree::Box;

  // Nothing lies over it, and so many triangles will, of about that size.
  void Clear(std::size_t triangles, double size);

  // A triangle of one side, 0 or 1, in its box; `margin`: the error of twice the areas that the
  // middle of a square makes with its sides.
  void Add(int side, const glm::dvec2 corners[3], const Box& box, double margin);

  // An edge that belongs to the outline of a layer.
  void AddOutline(const glm::dvec2& a, const glm::dvec2& b);

  // What is in the box has no side.
  void Block(const Box& box);

  // Whether all that is in the box is hidden by a layer before it, or, of a triangle of that side,
  // that nothing lies before it. False if that is not known.
  bool IsHidden(const Box& box) const;
  bool IsFirst(const Box& box, int side) const;

private:
  struct Square
  {
    float Least[2]; // Q of the triangles that may reach into it, of each side
    float Greatest[2];
    int Layers[2];
    bool IsCrossed;
  };

  static constexpr std::size_t MostLooks = 32; // at squares, for each triangle

  int GetPlace(double x) const;
  template <typename Visit>
  bool ForEach(const Box& box, Visit visit) const;
  Square& At(int column, int row)
  {
    return this->Squares[static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Count) +
      static_cast<std::size_t>(column)];
  }

  int Count = 0;        // of squares, in each direction
  std::size_t Left = 0; // looks; 0: nothing is known
  std::vector<Square> Squares;
};

#endif
