// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads layers at a pixel. They are drawn at the first request after the picture has changed,
 * without affecting it.
 */
#ifndef Probe_h
#define Probe_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRenderer;

namespace viewer
{
struct ProbeValue
{
  std::string Layer;
  std::vector<double> Values;
  bool IsBackground; ///< no surface at the pixel; for layers of volumes, no volume
};

class Probe
{
public:
  /// Call when the picture has changed.
  void Forget() { this->Image = nullptr; }
  bool IsFresh() const { return this->Image != nullptr; }

  /// Values of the catalogue's layers, and of arrays. Pixels count from the lower left. Empty
  /// outside the picture, or if reading fails.
  std::vector<ProbeValue> Read(
    vtkRenderer* renderer, const std::vector<std::string>& arrays, int x, int y);

private:
  vtkSmartPointer<vtkImageData> Image;
};
}

#endif
