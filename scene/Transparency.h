// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --transparent: a picture without its background. Drawing over black and over white gives the
 * share of the background in each pixel. The ground has the background's colour, so that only its
 * shadows remain: black, with the opacity that darkens white as much.
 */
#ifndef Transparency_h
#define Transparency_h

#include "SceneNames.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace scene
{
struct Scene;

/// While one lives, background and ground have one grey, 0 black to 1 white.
class Backdrop
{
public:
  Backdrop(const Scene& scene, double grey);
  ~Backdrop();
  Backdrop(const Backdrop&) = delete;
  void operator=(const Backdrop&) = delete;

private:
  void Paint(const double bottom[3], const double ground[3]);

  const Scene& Shown;
  double Bottom[3];
  bool Gradient;
  double Ground[3] = { 0.0, 0.0, 0.0 };
};

/// RGBA, 8 bits, not premultiplied: over black it gives the first picture, within rounding. Over
/// white it gives the second where the background's share is equal in all three channels, and
/// otherwise their mean.
vtkSmartPointer<vtkImageData> MakeTransparent(vtkImageData* overBlack, vtkImageData* overWhite);
}

#endif
