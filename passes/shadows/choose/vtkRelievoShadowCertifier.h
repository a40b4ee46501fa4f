// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Judges shadow verdicts of a picture by rays: see vtkRelievoShadowCertificate.
#ifndef vtkRelievoShadowCertifier_h
#define vtkRelievoShadowCertifier_h

#include "vtkRelievoCasterRays.h"
#include "vtkRelievoShadowLight.h"
#include "vtkRelievoShadowPixels.h"
#include "vtkRelievoShadowRegion.h"

#include <vector>

class vtkRelievoShadowCertificate;

class vtkRelievoShadowCertifier
{
public:
  enum Findings
  {
    RIGHT,
    FALSE_SHADOW,
    FALSE_LIGHT,
    TIE,
    GRAZING,
    UNLIT,
    UNKNOWN,
    NOTHING // no surface: not drawn by lot
  };

  vtkRelievoFrameCamera View;
  vtkRelievoCasterRays Rays;
  std::vector<vtkRelievoBox> Unfollowed; // what may cast or be seen there is unknown
  std::vector<vtkRelievoShadowLight> Lights;
  std::vector<const float*> Visibility; // of each light, per pixel
  bool CoarseDepth = false;             // it does not tell the sides of a thin plate apart
  bool Attenuates = false;              // what was drawn is a transmittance, not a verdict
  const float* Depth = nullptr;         // per pixel, from the eye along the view's axis

  Findings Judge(int x, int y, int light) const;

  // Draws lots until so many verdicts are judged, or all of the picture are.
  void Certify(int rays, int seed, vtkRelievoShadowCertificate* certificate) const;

private:
  double GetDepthWindow(double depth) const;
  bool IsAlike(double a, double b) const; // verdicts
  bool HasOtherNeighbour(const vtkRelievoPixelRay& beside, int light, double wanted,
    const vtkRelievoCasterRays::Meeting& seen, double truth) const;
};

#endif
