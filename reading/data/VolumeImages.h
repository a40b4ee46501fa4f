// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images with depth to something that shows what is in them: a surface where a value is reached,
 * the surfaces of labelled regions, or a volume that light passes.
 */
#ifndef VolumeImages_h
#define VolumeImages_h

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;
class vtkVolume;

namespace scene
{
class Progress;

/// --image: how images with depth are shown.
struct ImageChoice
{
  enum class Kind
  {
    Found, ///< labels or a surface, by what the image holds
    Box,   ///< the outer faces, with colours
    Surface,
    Labels,
    Volume
  };
  Kind Is = Kind::Box;
  std::optional<double> Value; ///< of the surface; none: by Otsu's threshold
};

/// "labels", "surface=120" and so on; throws UsageError.
ImageChoice ParseImage(const std::string& word);

/// The image, if the data is one with depth and one value for each point, or else each cell; the
/// values of cells are at points then. Null: other data.
vtkSmartPointer<vtkImageData> GetVolumeImage(vtkDataObject* data);

/// A surface of the image by VTK, with triangles that a left-handed image has turned inside out
/// turned back.
vtkSmartPointer<vtkPolyData> TurnOutwards(vtkPolyData* surface, vtkImageData* image);

/// Whether the values are whole numbers that hardly change from a point to the next.
bool HasLabels(vtkImageData* image);

/// Why MakeLabelSurfaces does not take the image: its values are too many, or those of a grey one,
/// whose surfaces are nearly as many as its points. "" if it does.
std::string CheckLabels(vtkImageData* image);

/// The smoothed surface of each region whose value is not 0, with a colour for each value.
vtkSmartPointer<vtkPolyData> MakeLabelSurfaces(vtkImageData* image, Progress& progress);

/// The value that parts the image's histogram best (Otsu, 1979).
double FindThreshold(vtkImageData* image);

/// Where the image has the value; its faces turn to what is less.
vtkSmartPointer<vtkPolyData> MakeIsosurface(vtkImageData* image, double value, Progress& progress);

/// Light passes what is below the threshold; SetLook gives the colours.
vtkSmartPointer<vtkVolume> MakeVolume(vtkImageData* image);

/// From 0 to 1: the square of it is the share of light stopped of what such a volume stops at 1.
void SetVolumeOpacity(vtkVolume* volume, double opacity);
}

#endif
