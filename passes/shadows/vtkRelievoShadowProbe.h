// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How many verdicts maps will get wrong in a view, before anything is drawn: at some of its pixels,
// rays on the CPU tell which of the four texels around the pixel's place, of maps much coarser than
// those to be drawn, would have another verdict than the place itself. Wrong verdicts lie among
// such pixels, and their share falls with the texel's width by a power law.
//
// A function of scene, lights, settings and view, and of nothing else. The view is taken in steps,
// so that most moves of the camera need no new rays.
#ifndef vtkRelievoShadowProbe_h
#define vtkRelievoShadowProbe_h

#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowPixels.h"

#include <cstdint>
#include <vector>

class vtkRelievoShadowMethod;
struct vtkRelievoShadowWork;

class vtkRelievoShadowProbe
{
public:
  // Brings the probe up to date with the frame's casters, lights and camera.
  void Update(const vtkRelievoShadowWork& work, const std::vector<vtkRelievoShadowLight>& casting);

  // Whether rays can tell: not if casters that cannot be followed may matter at most pixels.
  bool IsKnown() const { return this->Known; }

  // The expected share of wrong verdicts among those that face the light, 0 to 1, of maps of
  // size x size texels, `warped` or not.
  double GetWrongShare(int size, bool warped) const;

  long long GetNumberOfTriangles() const { return this->Rays.GetNumberOfTriangles(); }
  int GetNumberOfMaps() const { return this->Maps; }
  int GetUpdates() const { return this->Updates; } // how often rays were sent

private:
  struct Sample
  {
    glm::dvec3 Place;
    vtkRelievoCasterRays::Meeting Seen;
    double Blur;
    int Light;
    bool Lit;
  };
  // Of a method's maps: pixels with an unlike texel, over all levels.
  struct Count
  {
    long long Asked = 0;
    long long Unlike = 0;
  };

  void TakeSamples(const vtkRelievoView& view);
  Count Ask(const vtkRelievoShadowCache& cache, double bias) const;
  int CountUnlike(const Sample& sample, const vtkRelievoShadowView& view, double bias) const;

  vtkRelievoCasterRays Rays;
  std::vector<vtkRelievoBox> Unfollowed;
  std::vector<vtkRelievoShadowLight> Lights;
  std::vector<Sample> Samples;
  std::vector<double> Key; // what the rays were sent for
  std::vector<std::uint64_t> Casters;
  Count Even;
  Count Warped;
  bool Known = false;
  int Maps = 0;
  int Updates = 0;
};

#endif
