// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options of the camera: its place, its view angle and its clipping distances.
 */
#ifndef CameraOptions_h
#define CameraOptions_h

#include "LookNames.h"

#include <array>
#include <optional>
#include <string>

class vtkCamera;
class vtkRenderer;

namespace look
{
struct CameraPlace
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  std::array<double, 3> ViewUp;
};

struct CameraChoice
{
  std::optional<CameraPlace> Place;          ///< none: fitted to the scene
  std::optional<std::array<double, 3>> From; ///< the fitted camera looks from right, up and near;
                                             ///< none: along an axis
  std::optional<double> Angle;               ///< full vertical angle, degrees
  std::optional<double> ParallelScale;       ///< half the height, world units
  std::optional<std::array<double, 2>> Clip; ///< clipping distances; none: around the scene
};

constexpr double StandardViewAngle = 30.0; ///< VTK's, degrees

/// Sets only the renderer's camera, fitted to these bounds unless the choice places it; `up`: the
/// axis that points up.
void PlaceCamera(vtkRenderer* renderer, const CameraChoice& choice, int up, const double bounds[6]);

/// The requirement that a place misses, as the end of an error message; "" if it is a view.
std::string CheckPlace(const CameraPlace& place);

/// The pose of a camera.
CameraPlace GetPlace(vtkCamera* camera);

///@{
/// The rows of --camera, --view-angle and --parallel-scale, and of --clip.
void AddCameraOptions(OptionRows& rows, CameraChoice& camera);
void AddClipOption(OptionRows& rows, CameraChoice& camera);
///@}
}

#endif
