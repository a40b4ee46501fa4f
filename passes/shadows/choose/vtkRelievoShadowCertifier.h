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
#include "vtkRelievoVolumeExtinction.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkRelievoFramePass;
class vtkRelievoShadowCertificate;
class vtkRelievoShadowLights;
class vtkRelievoShadowMethod;
class vtkRelievoShadowProps;
class vtkRenderer;
struct vtkRelievoShadowContext;

class vtkRelievoShadowCertifier
{
public:
  // The objects that drew a picture.
  struct Picture
  {
    vtkRelievoFramePass* Frame;
    vtkRenderer* Renderer;
    vtkRelievoShadowContext& Work;
    const vtkRelievoShadowLights& Lights;
    const std::unique_ptr<vtkRelievoShadowMethod>& Method; // drawing may replace it
  };

  // Draws the picture again as layers, and judges it. Null if it cannot be drawn, with the error in
  // `fault`.
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
    NOTHING // no surface: not sampled
  };

  vtkRelievoFrameCamera View;
  vtkRelievoCasterRays Rays;
  std::vector<vtkRelievoBox> Unfollowed; // boxes of surfaces that rays cannot trace
  std::vector<vtkRelievoShadowLight> Lights;
  std::vector<const float*> Visibility; // of each light, per pixel
  bool CoarseDepth = false;             // too coarse to distinguish the sides of a thin plate
  bool Attenuates = false;              // the layers are transmittances, not verdicts
  const float* Depth = nullptr;         // per pixel, from the eye along the view's axis
  // With volumes: the layers again, as `Visibility` has the light past surfaces alone.
  std::vector<vtkRelievoVolumeExtinction> Volumes;
  std::vector<const float*> Dimmed;

  Findings Judge(int x, int y, int light) const;

  // Samples pixels until enough verdicts are judged, or all pixels are.
  void Certify(int rays, int seed, vtkRelievoShadowCertificate* certificate) const;

private:
  double GetDepthWindow(double depth) const;
  bool IsAlike(double a, double b) const; // compares verdicts
  void AddVolumes(const vtkRelievoShadowProps& props);
  bool HasOtherNeighbour(const vtkRelievoPixelRay& beside, int light, double wanted,
    const vtkRelievoCasterRays::Hit& seen, double truth) const;
};

#endif
