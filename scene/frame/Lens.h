// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --lens: the view of a lens, a panorama or a map in place of the camera's pinhole. Colour is
 * warped from frames, layers are computed by rays.
 */
#ifndef Lens_h
#define Lens_h

#include "SceneNames.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkFieldData;
class vtkRelievoCameraModel;
class vtkRenderer;

namespace reading
{
class Progress;
}

namespace scene
{
struct RenderOptions;

/// Throws UsageError for a layer that rays cannot compute.
void CheckLensLayer(const std::string& name);

/// Throws UsageError for a lens that takes its scale from a camera, if no camera gives one.
void CheckLensScale(const RenderOptions& options);

/// The option's sensor, or a pinhole without the option, with the pose and the angle of a view.
/// Throws FileError, and UsageError for an impossible size or angle.
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options, vtkCamera* view);

/// The view of a camera, pinhole or orthographic, in these columns and rows. Null, with an error
/// event, for a view that is neither.
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(vtkCamera* view, int columns, int rows);

/// The option's sensor with the options' or the standard angle, before it has a pose.
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options);

/// The options completed by the lens: the size, if a file gives it and no option does, and the
/// angle for fitting the camera. Throws FileError, and UsageError for a size or an angle that the
/// lens cannot have.
RenderOptions FollowLens(RenderOptions options);

/// The layers, `color` among them, with the calibration as field data, and the picture if one is
/// requested. Throws WorkError.
vtkSmartPointer<vtkImageData> DrawLens(vtkRenderer* renderer, const RenderOptions& options,
  const std::vector<std::string>& layers, vtkSmartPointer<vtkImageData>& picture,
  Progress& progress);

/// A calibration as JSON: the size, and the entries K, R, t, lens and distortion of the field data.
std::string WriteCalibration(vtkFieldData* fields, const std::array<int, 2>& size);

/// The calibration of a picture of this size by a VTK camera: R and t, and K if it has one.
vtkSmartPointer<vtkFieldData> GetCalibration(vtkRenderer* renderer, const int size[2]);
}

#endif
