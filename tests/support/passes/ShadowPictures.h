// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowPictures.h
 * @brief Pictures with shadows against the pictures that VTK draws with the light on and off.
 */
#ifndef relievoTestShadowPictures_h
#define relievoTestShadowPictures_h

#include "ShadowScenes.h"

#include <functional>
#include <string>

namespace relievoTest
{
/** Whether a picture shows a light's shadow where the truth has it, and is unchanged elsewhere. */
struct PictureErrors
{
  long long Lit = 0; // compared pixels: certainly lit, with all neighbours within `radius`
  long long LitWrong = 0;
  long long Dark = 0;
  long long DarkWrong = 0;
  /** Over all pixels: not between their values with and without the light. */
  long long Outside = 0;

  std::string ToString() const;
};

/**
 * `shadows` must equal `off` (no shadows) where the light reaches, and `dark` (the light switched
 * off) where it does not, within `slack` of 255. Pixels whose neighbours within `radius` have
 * another verdict, and those without a verdict, may have any value in between.
 */
PictureErrors JudgePicture(vtkImageData* shadows, vtkImageData* off, vtkImageData* dark,
  const ShadowTruth& truth, int radius, int slack);

/** Number of pixels at which two pictures differ by more than `slack` of 255 in a channel. */
long long CountUnlike(vtkImageData* a, vtkImageData* b, int slack = 0);

/** A sun that casts (light 0), and one that does not. Returns the first. */
vtkSmartPointer<vtkLight> AddTwoSuns(ShadowStage& stage);

/** Pictures of a stage without shadows, without that light, and with shadows, which stay on. */
struct ShadowPictures
{
  vtkSmartPointer<vtkImageData> Off;
  vtkSmartPointer<vtkImageData> Dark;
  vtkSmartPointer<vtkImageData> On;

  ShadowPictures(ShadowStage& stage, vtkLight* light);
  ShadowPictures(ShadowStage& stage, vtkLight* light,
    const std::function<vtkSmartPointer<vtkImageData>()>& picture);
};

/**
 * Compares, prints, and fails if more than `limit` of the lit or of the dark pixels are wrong, or
 * if few pixels are compared.
 */
PictureErrors CheckPictures(const std::string& what, const ShadowPictures& pictures,
  const ShadowTruth& truth, double limit, int radius = 1, int slack = 1);
}

#endif
