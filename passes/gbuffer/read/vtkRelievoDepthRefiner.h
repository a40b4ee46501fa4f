// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Computes the depth at the pixels' centres from the mesh in double: the id word gives the
// triangle. This removes two errors of the rasteriser: it interpolates in float, with an error of a
// thousandth on a triangle seen edge-on; and it rounds corners to parts of a pixel (usually 1/256),
// so that a pixel near an edge may be assigned to the neighbouring triangle and extrapolate from
// there. The triangle that contains the centre is searched among those of the neighbouring pixels
// on the same mesh, then, for slivers that no pixel shows, among those that share a point with the
// triangle shown, and last among other meshes, which may continue the surface. Where the surface
// ends (a silhouette), the depth is that of its point nearest to the centre.
#ifndef vtkRelievoDepthRefiner_h
#define vtkRelievoDepthRefiner_h

#include "vtkRelievoDrawTable.h"
#include "vtkRelievoGBufferModule.h" // for the export macro

#include <limits>
#include <vector>

class vtkIdList;
class vtkRelievoMeshLinks;
struct vtkRelievoFrameCamera;

// Not exported, so that the compiler can inline its methods into the loops over pixels.
class VTKRELIEVOGBUFFER_NO_EXPORT vtkRelievoDepthRefiner
{
public:
  // `words`: the id words of the whole view.
  vtkRelievoDepthRefiner(const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view,
    const std::uint32_t* words);

  // Replaces the view's depths at pixels that show a mesh's triangle.
  void Refine(float* depths, vtkRelievoMeshLinks& links);

private:
  // A point of the triangle that a pixel shows: its depth, and its distance in the image from the
  // pixel's centre, in pixels.
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
    double Other = std::numeric_limits<double>::infinity(); // depth on other meshes' triangles
  };
  // A triangle projected to the view: x, y and w of its corners in clip coordinates, and their
  // depths. Not Known if the primitive is no triangle, or shader code moves it.
  struct Triangle
  {
    bool Known = false;
    const vtkPolyData* Mesh = nullptr;
    const glm::dmat4* Place = nullptr; // of the mesh: several actors may show it
    glm::dvec3 Clip[3];
    double Depth[3];
  };
  // A triangle's weights at a pixel, up to a common factor, and their change to the next pixel on
  // the right: the weights are linear over the view, in every projection.
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

  // Depth of the triangle's plane after `steps` pixels. Not finite if the triangle is seen edge-on.
  static double GetDepth(
    const Triangle& triangle, const Weights& weights, double steps, bool& inside);

  // The point on the triangle's edges nearest to the pixel's centre in the image. Not finite if all
  // of them lie in front of the near plane.
  Point GetNearest(const Triangle& triangle, int x, int y) const;

  // Refines row y; pixels whose centre lies in no triangle found so far are added to `open`.
  void RefineRow(int y, float* depths, Recent& recent, std::vector<Pixel>& open) const;

  // Whether the surface continues from the nearest point shown to this depth at the pixel's centre.
  bool RunsOn(const Point& nearest, double depth) const;

  // Depth at the pixel's centre on a triangle of the same mesh that contains it, if it continues
  // the surface: GetNeighbourDepth() searches the neighbours' triangles, GetAdjacentDepth() those
  // that share a point with the triangle shown; infinity if none fits. GetNeighbourDepth() also
  // stores the depth on other meshes in the pixel.
  double GetNeighbourDepth(Pixel& pixel, const Triangle& shown, Recent& recent) const;
  double GetAdjacentDepth(const Pixel& pixel, vtkRelievoMeshLinks& links) const;

  const vtkRelievoDrawTable& Draws;
  const vtkRelievoFrameCamera& View;
  const std::uint32_t* Words;
};

#endif
