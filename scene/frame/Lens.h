// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --lens: what a lens, a panorama or a map sees in place of the camera's pinhole. Colour is warped
 * from frames, layers are by rays.
 */
#ifndef Lens_h
#define Lens_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkFieldData;
class vtkRelievoCameraModel;
class vtkRenderer;

namespace scene
{
class Progress;
struct RenderOptions;

/// Throws UsageError for a layer that rays do not have.
void CheckLensLayer(const std::string& name);

/// Throws UsageError for a lens that takes its scale from a camera, where no camera says any.
void CheckLensScale(const RenderOptions& options);

/// The sensor of the option's words, or a pinhole without them, with the pose and the angle of a
/// view. Throws FileError, and UsageError for a size or an angle that it cannot have.
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options, vtkCamera* view);

/// That sensor with the angle of the options, or the standard one, before it has a pose.
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options);

/// The options with what the lens says: the size, if a file says it and no option does, and the
/// angle to which a camera is fitted. Throws FileError, and UsageError for a size or an angle that
/// the lens cannot have.
RenderOptions FollowLens(RenderOptions options);

/// The layers, `color` among them, with the calibration as field data, and the picture, if one is
/// to be written. Throws WorkError.
vtkSmartPointer<vtkImageData> DrawLens(vtkRenderer* renderer, const RenderOptions& options,
  const std::vector<std::string>& layers, vtkSmartPointer<vtkImageData>& picture,
  Progress& progress);

/// A calibration as JSON: the size, and what the field data has of K, R, t, lens and distortion.
std::string WriteCalibration(vtkFieldData* fields, const std::array<int, 2>& size);

/// The calibration of a picture that was drawn by a camera of VTK, in so many pixels: R and t, and
/// K if it has one.
vtkSmartPointer<vtkFieldData> GetCalibration(vtkRenderer* renderer, const int size[2]);
}

#endif
