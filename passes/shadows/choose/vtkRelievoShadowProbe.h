// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Predicts the share of wrong verdicts of maps in a view before drawing: at a sample of pixels,
// rays on the CPU compute the values of the four texels around the pixel's place in two maps
// coarser than the real ones, and compare their filtered verdict with that of the place itself.
// Wrong verdicts lie along edges, so that their share follows a power law of the texel's width.
//
// The result depends only on scene, lights, settings and view. View and lights are rounded to
// steps, so that most of their moves need no new rays.
#ifndef vtkRelievoShadowProbe_h
#define vtkRelievoShadowProbe_h

#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowPixels.h"

#include <cstdint>
#include <vector>

class vtkRelievoShadowMethod;
class vtkRelievoShadowProps;
struct vtkRelievoShadowContext;

class vtkRelievoShadowProbe
{
public:
  // Updates the probe for the frame's casters and lights, and the picture's view.
  void Update(const vtkRelievoShadowContext& work, const std::vector<vtkRelievoShadowLight>& lights,
    const vtkRelievoFrameCamera& picture);

  // Drawing alone may change the state of props: asks whether the probe was up to date before, and
  // marks it as up to date.
  bool HasScene(const vtkRelievoShadowProps& props) const;
  void Settle(const vtkRelievoShadowProps& props);

  // Deletes all data, including trees.
  void Release();

  // Whether the result is valid: not if casters that rays cannot trace may affect most pixels.
  bool IsKnown() const { return this->Known; }

  // Whether there are casters that rays cannot trace, which every method draws into maps.
  bool HasUnfollowed() const { return !this->Unfollowed.empty(); }

  // The expected share of wrong verdicts among those that face the light, 0 to 1, for maps of size
  // x size texels, `warped` or not.
  double GetWrongShare(int size, bool warped) const;

  // The share of pixels facing a light whose verdict differs half a pixel aside: the density of
  // edges in the picture, of shadows and of outlines of lit surfaces. Traces as many rays again,
  // once per update.
  double GetEdgeShare();

  double GetRoundedReach() const; // of all meshes, in world units
  long long GetNumberOfTriangles() const { return this->Rays.GetNumberOfTriangles(); }
  int GetNumberOfMaps() const { return this->Maps; }
  int GetUpdates() const { return this->Updates; } // number of updates with rays

private:
  struct Sample
  {
    glm::dvec3 Place;
    vtkRelievoCasterRays::Hit Seen;
    double Blur;
    vtkRelievoPixelRay Beside; // the eye's ray, half a pixel aside
    int Light;
    bool Lit;
  };
  // For a method's maps: pixels, and the expected number of wrong ones in the coarse maps.
  static constexpr int Levels = 2;
  struct Count
  {
    double Asked = 0.0;
    double Wrong[Levels] = { 0.0, 0.0 };
  };

  // Samples pixels of a part of the window, given by its low corner and size as shares of it.
  void TakeSamples(const vtkRelievoFrameCamera& view, const glm::dvec4& part);
  bool IsAtEdge(const Sample& sample) const;
  Count Ask(const vtkRelievoShadowCache& cache, double bias) const;
  void AddWrong(const Sample& sample, const vtkRelievoShadowView& view, double bias,
    double (&shares)[Levels]) const;

  vtkRelievoCasterRays Rays;
  std::vector<vtkRelievoBox> Unfollowed;
  std::vector<vtkRelievoShadowLight> Lights;
  std::vector<Sample> Samples;
  std::vector<double> Key; // input of the rays
  std::vector<std::uint64_t> Scene;
  double Nearest = 0.0; // start of the eye's rays
  Count Even;
  Count Warped;
  double EdgeShare = -1.0; // -1: not computed yet
  bool Known = false;
  int Maps = 0;
  int Updates = 0;
};

#endif
