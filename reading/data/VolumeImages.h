// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Turns images with depth into a surface at a value, the surfaces of labelled regions, or a volume.
 */
#ifndef VolumeImages_h
#define VolumeImages_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;
class vtkVolume;

namespace reading
{
class Progress;

/// --image: how to show images with depth.
struct ImageChoice
{
  enum class Kind
  {
    Found, ///< labels or a surface, by the image's content
    Box,   ///< outer faces, in colours
    Surface,
    Labels,
    Volume
  };
  Kind Is = Kind::Box;
  std::optional<double> Value; ///< value of the surface; none: Otsu's threshold
};

/// Parses "labels", "surface=120" and so on; throws UsageError.
ImageChoice ParseImage(const std::string& word);

/// The row of --image.
void AddImageOption(OptionRows& rows, ImageChoice& image);

/// The image if the data has depth and one value per point, or else per cell; values of cells are
/// moved to points. Null: other data.
vtkSmartPointer<vtkImageData> GetVolumeImage(vtkDataObject* data);

/// An isosurface by VTK; a left-handed image turns triangles inside out, which is corrected.
vtkSmartPointer<vtkPolyData> TurnOutwards(vtkPolyData* surface, vtkImageData* image);

/// Whether the values are whole numbers that rarely change between neighbouring points.
bool HasLabels(vtkImageData* image);

/// Why MakeLabelSurfaces refuses the image: too many values, or a grey image, whose surfaces would
/// have nearly as many polygons as the image has points. "" if it accepts the image.
std::string CheckLabels(vtkImageData* image);

/// The smoothed surface of each region with a non-zero value, with a colour per value.
vtkSmartPointer<vtkPolyData> MakeLabelSurfaces(vtkImageData* image, Progress& progress);

/// The threshold that separates the image's histogram best (Otsu, 1979).
double FindThreshold(vtkImageData* image);

/// The isosurface at the value; its faces look towards smaller values.
vtkSmartPointer<vtkPolyData> MakeIsosurface(vtkImageData* image, double value, Progress& progress);

/// A volume that is transparent below the threshold; SetLook gives the colours.
vtkSmartPointer<vtkVolume> MakeVolume(vtkImageData* image);

/// From 0 to 1: its square scales the share of light that the volume stops at 1.
void SetVolumeOpacity(vtkVolume* volume, double opacity);

/// Opacities over a hundredth of the image's diagonal at increasing values; none: those of a new
/// volume.
void SetVolumeCurve(vtkVolume* volume, const std::vector<std::array<double, 2>>& curve);

/// The step of rays, as a share of the distance of the image's points.
void SetVolumeStep(vtkVolume* volume, double share);
}

#endif
