// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How many verdicts maps will get wrong in a view, before anything is drawn: at some of its pixels,
// rays on the CPU tell what the four texels around the pixel's place would say, in two maps coarser
// than those to be drawn, and whether their filtered verdict is that of the place itself. Wrong
// verdicts lie along edges, so that their share falls with the texel's width by a power law.
//
// A function of scene, lights, settings and view, and of nothing else. View and lights are taken in
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
  // Brings the probe up to date with the frame's casters and lights, and the picture's view.
  void Update(const vtkRelievoShadowContext& work, const std::vector<vtkRelievoShadowLight>& lights,
    const vtkRelievoFrameCamera& picture);

  // Drawing alone has changed the state of what is drawn: whether the probe is up to date with it,
  // and that it is.
  bool HasScene(const vtkRelievoShadowProps& props) const;
  void Settle(const vtkRelievoShadowProps& props);

  // Forgets all, trees as well.
  void Release();

  // Whether rays can tell: not if casters that cannot be followed may matter at most pixels.
  bool IsKnown() const { return this->Known; }

  // Casters that are drawn into maps by every method.
  bool HasUnfollowed() const { return !this->Unfollowed.empty(); }

  // The expected share of wrong verdicts among those that face the light, 0 to 1, of maps of
  // size x size texels, `warped` or not.
  double GetWrongShare(int size, bool warped) const;

  // The share of pixels that face a light whose verdict is another half a pixel aside: how densely
  // edges lie in the picture, of shadows, and of what is lit before what is not. Sends as many rays
  // again, once for what the probe was brought up to date with.
  double GetEdgeShare();

  double GetRoundedReach() const; // of all meshes, in units of the world
  long long GetNumberOfTriangles() const { return this->Rays.GetNumberOfTriangles(); }
  int GetNumberOfMaps() const { return this->Maps; }
  int GetUpdates() const { return this->Updates; } // how often rays were sent

private:
  struct Sample
  {
    glm::dvec3 Place;
    vtkRelievoCasterRays::Meeting Seen;
    double Blur;
    vtkRelievoPixelRay Beside; // of the eye, half a pixel aside
    int Light;
    bool Lit;
  };
  // Of a method's maps: pixels, and the expected number of wrong ones in the coarse maps.
  static constexpr int Levels = 2;
  struct Count
  {
    double Asked = 0.0;
    double Wrong[Levels] = { 0.0, 0.0 };
  };

  // At pixels of a part of the window, its low corner and its size as shares of it.
  void TakeSamples(const vtkRelievoFrameCamera& view, const glm::dvec4& part);
  bool IsAtEdge(const Sample& sample) const;
  Count Ask(const vtkRelievoShadowCache& cache, double bias) const;
  void AddWrong(const Sample& sample, const vtkRelievoShadowView& view, double bias,
    double (&wrong)[Levels]) const;

  vtkRelievoCasterRays Rays;
  std::vector<vtkRelievoBox> Unfollowed;
  std::vector<vtkRelievoShadowLight> Lights;
  std::vector<Sample> Samples;
  std::vector<double> Key; // what the rays were sent for
  std::vector<std::uint64_t> Scene;
  double Nearest = 0.0; // where rays of the eye begin
  Count Even;
  Count Warped;
  double EdgeShare = -1.0; // -1: not asked for yet
  bool Known = false;
  int Maps = 0;
  int Updates = 0;
};

#endif
