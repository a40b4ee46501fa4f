// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --transparent: a picture without its background. Drawn over black and over white, it tells how
 * much of both is seen: so the ground, which has the background's colour, is gone but for its
 * shadows, which are black of the opacity that darkens white as they do.
 */
#ifndef Transparency_h
#define Transparency_h

#include "vtkSmartPointer.h"

class vtkImageData;

namespace scene
{
struct Scene;

/// While one lives, the background has one grey, 0 black to 1 white, and the ground with it.
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

/// RGBA, 8 bits, not premultiplied: over black it is the first picture, within rounding, and over
/// white the second, where the background is seen alike in all three colours, else in their mean.
vtkSmartPointer<vtkImageData> MakeTransparent(vtkImageData* overBlack, vtkImageData* overWhite);
}

#endif
