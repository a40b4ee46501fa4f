// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The depth at the pixels' centres from the mesh in double: the id word says which triangle. A
// rasteriser has two errors that this takes away: it interpolates in float, which on a triangle on
// edge is off by a thousandth; and it rounds corners to parts of a pixel (1/256, as a rule), so
// that a pixel near an edge may be given to the neighbour and extrapolate from there. The triangle
// that truly holds the centre is looked for among those of the neighbouring pixels on the mesh that
// is shown, then, for slivers that no pixel shows, among those that share a point with the triangle
// shown, and last among other meshes, which may carry the surface on. Where the surface shown ends
// (a silhouette), the depth is that of its point next to the centre.
#ifndef vtkRelievoDepthRefiner_h
#define vtkRelievoDepthRefiner_h

#include "vtkRelievoDrawTable.h"
#include "vtkRelievoGBufferModule.h" // for the export macro

#include <limits>
#include <vector>

class vtkIdList;
class vtkRelievoMeshLinks;
struct vtkRelievoFrameCamera;

// Hidden, so that the compiler may put its methods into the loops over all pixels.
class VTKRELIEVOGBUFFER_NO_EXPORT vtkRelievoDepthRefiner
{
public:
  // The id words of the whole view.
  vtkRelievoDepthRefiner(const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view,
    const std::uint32_t* words);

  // Replaces the view's depths where a triangle of a mesh is seen.
  void Refine(float* depths, vtkRelievoMeshLinks& links);

private:
  // A point of the triangle that a pixel shows: its depth, and how many pixels from the pixel's
  // centre it is drawn.
  struct Point
  {
    double Depth = std::numeric_limits<double>::infinity();
    double Distance = std::numeric_limits<double>::infinity();
  };
  struct Pixel
  {
    int X;
    int Y;
    Point Nearest;
    double Other = std::numeric_limits<double>::infinity(); // of other meshes' triangles
  };
  // A triangle as the view projects it: x, y and w of its corners in clip coordinates, and their
  // depths. Not Known: something else, or a triangle that shader code moves.
  struct Triangle
  {
    bool Known = false;
    const vtkPolyData* Mesh = nullptr;
    const glm::dmat4* Place = nullptr; // of the mesh: several actors may show it
    glm::dvec3 Clip[3];
    double Depth[3];
  };
  // A triangle's weights at a pixel, up to a common factor, and how they change to the next pixel
  // on the right: they are linear over the view, in every projection.
  struct Weights
  {
    double At[3];
    double Step[3];
  };
  class Recent;

  std::uint32_t GetWord(int x, int y) const;
  void SetCorner(
    Triangle& triangle, int i, const glm::dmat4& modelToView, const glm::dvec3& model) const;
  Triangle GetTriangle(std::uint32_t word, vtkIdList* scratch) const;
  Weights GetWeights(const Triangle& triangle, int x, int y) const;

  // Depth of the triangle's plane `steps` pixels on. Not finite if the triangle is seen on edge.
  static double GetDepth(
    const Triangle& triangle, const Weights& weights, double steps, bool& inside);

  // The point of the triangle's edges that is drawn nearest to the pixel's centre. Not finite if
  // there is none before the near plane.
  Point GetNearest(const Triangle& triangle, int x, int y) const;

  // Those of row y; pixels whose centre no triangle at hand holds are added to `open`.
  void RefineRow(int y, float* depths, Recent& recent, std::vector<Pixel>& open) const;

  // Whether the surface runs on from the nearest point shown to this depth at the pixel's centre.
  bool RunsOn(const Point& nearest, double depth) const;

  // Depth on the triangle of the mesh shown that holds the pixel's centre, if the surface shown
  // runs on to it, of the neighbours' and of those that share a point with the triangle shown;
  // infinity if none does. Of the neighbours' also that on other meshes, which the pixel keeps.
  double GetNeighbourDepth(Pixel& pixel, const Triangle& shown, Recent& recent) const;
  double GetAdjacentDepth(const Pixel& pixel, vtkRelievoMeshLinks& links) const;

  const vtkRelievoDrawTable& Draws;
  const vtkRelievoFrameCamera& View;
  const std::uint32_t* Words;
};

#endif
