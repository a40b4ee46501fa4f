// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LayerErrors.h
 * @brief Errors of captured layers against the truth, in the measures of the design.
 */
#ifndef relievoTestLayerErrors_h
#define relievoTestLayerErrors_h

#include "Truth.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkRenderer;

namespace relievoTest
{
class EmbreeScene;

/** Errors of the layers in the image; those of missing layers stay 0. */
struct LayerErrors
{
  /** Pixels shown by either side, and the share of them shown only by one. */
  long long Compared = 0;
  double Coverage = 0.;
  /** Inner pixels left out: their triangle is narrower than 1/64 pixel. */
  long long OnSlivers = 0;
  /** Relative error of the depth of inner pixels. */
  double DepthMedian = 0.;
  double DepthP99 = 0.;
  double DepthMax = 0.;
  /** Relative error of the range of inner pixels. */
  double RangeMax = 0.;
  /**
   * Degrees, geometric normal, triangles at least 2 pixels wide, with the drawn position inside
   * them.
   */
  double FaceNormalMax = 0.;
  /** Degrees, of the layer `normal` against the geometric normal (for flat shading). */
  double NormalMax = 0.;
  /** Distance in pixels of the same view between the position and the truth, inner pixels. */
  double PositionMax = 0.;
  /** Inner pixels with another actor; and of those well inside a triangle, with another cell. */
  long long WrongActors = 0;
  long long WrongCells = 0;

  std::string ToString() const;
};

/**
 * Captures layers of a renderer in a window by vtkRelievoLayerSource; fails the test if it cannot.
 */
vtkSmartPointer<vtkImageData> CaptureLayers(
  vtkRenderer* renderer, const std::vector<std::string>& layers);

/**
 * Compares with the truth of the renderer's view. Pixels where two triangles have equal depth are
 * not compared by cell.
 */
LayerErrors CompareLayers(vtkImageData* layers, const EmbreeScene& scene, vtkRenderer* renderer);
}

#endif
