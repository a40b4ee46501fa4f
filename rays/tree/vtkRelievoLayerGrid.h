// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts layers of triangles over squares of a picture, in sheets with gaps in depth between them.
// Triangles that join without a gap cover each point of a square as often as its centre, if the
// outline of their layer does not cross the square: the nearest sheet is visible if it is a single
// layer, and triangles behind a sheet are hidden, whatever their shapes.
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

  // Adds a triangle with its box, seen from its front or its back; `margin`: the error of twice the
  // areas between a square's centre and the triangle's sides.
  void Add(bool isFront, const glm::dvec2 corners[3], const Box& box, double margin);

  // Adds an edge of a layer's outline, with the box of its triangle.
  void AddOutline(const glm::dvec2& a, const glm::dvec2& b, const Box& box);

  // Marks squares that the grid has no answers for.
  void Block(const Box& box);

  // Prepares the answers, after the last triangle. More triangles can then be added, without those
  // of which IsHidden is known; Finish prepares the answers anew.
  void Finish();

  // IsHidden: whether the box's content is hidden by a layer in front of it. IsFirst: whether
  // nothing lies in front of a triangle or a corner with that box. False if this is unknown.
  bool IsHidden(const Box& box) const;
  bool IsFirst(const Box& box) const;

private:
  // Triangles that may reach into a square, and whose ranges of Q overlap, directly or through
  // others, as those of triangles that join do.
  struct Sheet
  {
    float Low; // range of Q
    float High;
    int Layers;     // at the square's centre, of both sides
    bool IsCrossed; // or may lack triangles, which are hidden

    bool IsBehind(const Sheet& other) const { return this->Low < other.Low; }
  };
  static constexpr int MostSheets = 3;
  struct Square
  {
    int Count;
    Sheet Sheets[MostSheets]; // disjoint
  };

  // The answers of a square.
  struct Answer
  {
    float FirstFrom;   // the nearest sheet's least Q, if it is visible
    float HiddenBelow; // Q
  };

  static void Put(Square& square, Sheet sheet);

  static constexpr std::size_t MostLooks = 32; // squares visited per triangle

  int GetPlace(double x) const;
  template <typename Visit>
  bool ForEach(const Box& box, Visit visit) const;
  std::size_t GetIndex(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Count) +
      static_cast<std::size_t>(column);
  }

  int Count = 0;        // squares in each direction
  std::size_t Left = 0; // visits left; 0: the grid has no answers
  std::vector<Square> Squares;
  std::vector<Answer> Answers; // by square
  bool HasAnswers = false;
};

#endif
