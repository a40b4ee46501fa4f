// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Determines which points of a mesh's triangles, and which of their corners, are visible from one
// position, without a ray for each: triangles are projected, and points whose state layers of
// triangles do not determine are compared with overlapping triangles (for shadows: T. Aila, S.
// Laine, Alias-free shadow maps, 2004).
//
// Answers equal those of rays, or are Unknown: where rounding matters, or outside the view.
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
  static constexpr int Samples = 4; // per triangle

  // Weights of a triangle's corners, for each of its points.
  using Weights = std::array<glm::dvec3, Samples>;

  enum class State : std::uint8_t
  {
    Unknown,
    Hidden,
    Seen
  };

  // A view from a position in the scene's coordinates, along unit axes: of points ahead, it covers
  // the range from Low to High in the coordinates x / z and y / z.
  struct View
  {
    glm::dvec3 From{ 0.0 };
    glm::dvec3 Axes[3]; // right, down and ahead
    glm::dvec2 Low{ -1.0 };
    glm::dvec2 High{ 1.0 };
    double Rounding = 0.0; // of world coordinates, in the caller's comparison
  };

  // `place`: index of the examined mesh's place in the scene. The scene must not change.
  vtkRelievoTriangleSight(const vtkRelievoRayTree& scene, int place, const Weights& weights);

  // Resets all states to Unknown.
  void Clear();
  // Adds the states determined by a view.
  void Look(const View& view);

  // Bits of a triangle's points that are known to be Seen or Hidden: Seen if the first triangle
  // that a ray to the point hits belongs to its cell.
  unsigned GetSamples(int triangle, State state) const
  {
    const std::uint8_t states = this->SampleStates[static_cast<std::size_t>(triangle)];
    return state == State::Hidden ? states >> Samples : states & ((1u << Samples) - 1u);
  }
  // State of a corner, by its index in vtkRelievoMeshTree::GetPlaces: Seen if nothing lies in front
  // of it.
  State GetCorner(std::size_t corner) const { return this->CornerStates[corner]; }

private:
  static constexpr int Chunk = 8;      // triangles examined together
  static constexpr int MostQuads = 16; // including their corners
  using Box = vtkRelievoWideTree::Box;

  // X and Y are -1 to 1 in the view; Q is 1 / z, below 0 if the vertex is not ahead.
  struct Vertex
  {
    double X;
    double Y;
    double Q;
    double Z;
  };

  // The visible side of a triangle, as bits.
  enum Side : std::uint8_t
  {
    Front = 1, // counterclockwise by X and Y
    Back = 2,
    Unclear = 4 // edge-on, or not entirely ahead
  };

  // A projected mesh.
  struct Projected
  {
    const vtkRelievoMeshTree* Mesh = nullptr;
    glm::dmat4 ToScene{ 1.0 };
    vtkRelievoWideTree Tree;
    std::vector<Vertex> Vertices;
    std::vector<Box> Boxes;                // of triangles, in X, Y and Q
    std::vector<Side> Sides;               // of triangles
    std::vector<std::uint8_t> CornerSides; // of all triangles at each corner
    std::vector<char> IsClosed; // corners: triangles have each edge there as often in one direction
                                // as in the other
    Side Nearer = Side::Front;  // the side of the triangles that are nearer in the mean
  };

  // A triangle that is not entirely ahead, in the view's coordinates.
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
  // Error of twice the areas of triangles, per length of their sides.
  double GetError(const Box& box) const
  {
    return 16.0 * (this->Error + this->ErrorByQ * box.Max.z);
  }
  void FillLayers();
  void GatherSides();
  void AddToLayers(const Projected& mesh, std::size_t triangle);
  State Judge(const Box& box) const;
  bool HasLayer(const Projected& mesh, int triangle) const;
  void JudgeTriangle(int triangle, State state);
  void JudgeCorner(std::size_t corner, const Box& around, State state);
  bool IsOpen(const Projected& mesh, std::size_t corner) const;
  void LookAtChunk(int chunk, const View& view);
  void CompareChunk(int chunk, const View& view);
  void Fill(Group& group, int chunk) const;
  void FillQuad(Quad& quad, int count) const;
  static unsigned MayHide(const Facing& facing, const Quad& quad, double reach);
  void Compare(Quad& quad, const Facing& facing, unsigned hidden) const;
  void CompareWild(Quad& quad, const Wild& wild, const View& view) const;
  void Keep(const Group& group);

  std::vector<Projected> Meshes; // at the scene's places
  int Target = 0;                // index in Meshes
  Weights PointWeights;
  bool HasManyToACell = false; // in the target
  // For each chunk the corners that no earlier chunk has start here.
  std::vector<std::size_t> Firsts;
  std::vector<Wild> Wilds;                // in the view
  vtkRelievoLayerGrid Layers;             // in the view
  std::vector<char> HiddenChunks;         // of the target, by layers of nearer sides
  std::vector<std::uint8_t> CellSides;    // of all triangles of the target's cells
  double Error = 0.0;                     // of X and Y
  double ErrorByQ = 0.0;                  // additional error, times Q
  double DepthErrorByQ = 0.0;             // relative, times Q
  std::vector<std::uint8_t> SampleStates; // bits: seen, and hidden
  std::vector<State> CornerStates;
};

#endif
