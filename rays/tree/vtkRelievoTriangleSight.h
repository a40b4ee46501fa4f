// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a mesh's triangles, and which of their corners, are seen from one place, without
// a ray for each: triangles are projected, and where layers of them do not say it, points are
// compared with the triangles that overlap them (for shadows: T. Aila, S. Laine, Alias-free shadow
// maps, 2004).
//
// An answer is that of a ray, or Unknown: what rounding might change, and what is not in the view.
#ifndef vtkRelievoTriangleSight_h
#define vtkRelievoTriangleSight_h

#include "vtkRelievoLayerGrid.h"
#include "vtkRelievoRayTree.h"

#include <array>
#include <cstdint>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoTriangleSight
{
public:
  static constexpr int Samples = 4; // of a triangle

  // Of a triangle's corners, for each of its points.
  using Weights = std::array<glm::dvec3, Samples>;

  enum class State : std::uint8_t
  {
    Unknown,
    Hidden,
    Seen
  };

  // From a place of the scene's coordinates, along unit axes: what is ahead, and there from Low to
  // High in the coordinates x / z and y / z.
  struct View
  {
    glm::dvec3 From{ 0.0 };
    glm::dvec3 Axes[3]; // right, down and ahead
    glm::dvec2 Low{ -1.0 };
    glm::dvec2 High{ 1.0 };
    double Rounding = 0.0; // of world coordinates, by those who compare
  };

  // The points of the triangles at a place of the scene. The scene must stay as it is.
  vtkRelievoTriangleSight(const vtkRelievoRayTree& scene, int place, const Weights& weights);

  // Nothing is known again.
  void Clear();
  // Adds what is known by a view.
  void Look(const View& view);

  // Of a point of a triangle: seen if the first triangle that a ray to it meets is of its cell.
  State GetSample(int triangle, int sample) const
  {
    const std::uint8_t states = this->SampleStates[static_cast<std::size_t>(triangle)];
    return states >> sample & 1    ? State::Seen
      : states >> (sample + 4) & 1 ? State::Hidden
                                   : State::Unknown;
  }
  // Of a corner, by its number in vtkRelievoMeshTree::GetPlaces: seen if nothing lies before it.
  State GetCorner(std::size_t corner) const { return this->CornerStates[corner]; }

private:
  static constexpr int Chunk = 8;      // triangles that are looked at together
  static constexpr int MostQuads = 16; // with their corners
  using Box = vtkRelievoWideTree::Box;

  // X and Y are -1 to 1 in the view; Q is 1 / z, less than 0: not ahead.
  struct Vertex
  {
    double X;
    double Y;
    double Q;
    double Z;
  };

  // Which side of a triangle is seen, as bits.
  enum Side : std::uint8_t
  {
    Front = 1, // counterclockwise by X and Y
    Back = 2,
    Unclear = 4 // from its edge, or not all ahead
  };

  // A mesh in the view.
  struct Projected
  {
    const vtkRelievoMeshTree* Mesh = nullptr;
    glm::dmat4 ToScene{ 1.0 };
    vtkRelievoWideTree Tree;
    std::vector<Vertex> Vertices;
    std::vector<Box> Boxes;                // of triangles, of X, Y and Q
    std::vector<Side> Sides;               // of triangles
    std::vector<std::uint8_t> CornerSides; // of all triangles at each corner
    std::vector<char> IsClosed; // corners: triangles have each edge there as often in one direction
                                // as in the other
  };

  // A triangle that is not all ahead, in the view's coordinates.
  struct Wild
  {
    int Mesh;
    int Triangle;
    glm::dvec3 Corners[3];
  };

  struct Quad;
  struct Group;
  struct Facing;

  void Project(int mesh, const View& view);
  Side GetSide(const Vertex& a, const Vertex& b, const Vertex& c, const Box& box) const;
  double GetError(const Box& box) const;
  void FillLayers();
  void JudgeTriangle(int triangle);
  void JudgeCorner(std::size_t corner);
  bool IsOpen(std::size_t corner) const;
  void LookAtChunk(int chunk, const View& view);
  void Fill(Group& group, int chunk) const;
  void FillQuad(Quad& quad, int count) const;
  static unsigned Meets(const Facing& facing, const Quad& quad, double reach);
  void Compare(Quad& quad, const Facing& facing, unsigned met) const;
  void CompareWild(Quad& quad, const Wild& wild, const View& view) const;
  void Keep(const Group& group);

  std::vector<Projected> Meshes; // of the scene's places
  int Target = 0;                // which of Meshes
  Weights PointWeights;
  bool HasManyToACell = false;            // triangles of the target
  std::vector<std::size_t> Firsts;        // of each chunk the first corner that no chunk before has
  std::vector<Wild> Wilds;                // of the view
  vtkRelievoLayerGrid Layers;             // of the view
  std::vector<std::uint8_t> CellSides;    // of all triangles of the target's cells
  double Error = 0.0;                     // of X and Y
  double ErrorByQ = 0.0;                  // more of it, times Q
  double DepthErrorByQ = 0.0;             // relative, times Q
  std::vector<std::uint8_t> SampleStates; // bits: seen, and hidden
  std::vector<State> CornerStates;
};

#endif
