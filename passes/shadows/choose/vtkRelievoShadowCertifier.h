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
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkRelievoFramePass;
class vtkRelievoShadowCertificate;
class vtkRelievoShadowLights;
class vtkRelievoShadowMethod;
class vtkRenderer;
struct vtkRelievoShadowContext;

class vtkRelievoShadowCertifier
{
public:
  // What drew a picture.
  struct Picture
  {
    vtkRelievoFramePass* Frame;
    vtkRenderer* Renderer;
    const vtkRelievoShadowContext& Work;
    const vtkRelievoShadowLights& Lights;
    const std::unique_ptr<vtkRelievoShadowMethod>& Method; // drawing may make another
  };

  // Draws the picture again as layers, and judges it. Null if it cannot be drawn, for the fault.
  static vtkSmartPointer<vtkRelievoShadowCertificate> CertifyPicture(
    const Picture& picture, int rays, int seed, std::string& fault);

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
