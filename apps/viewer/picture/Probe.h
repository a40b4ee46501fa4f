// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads what layers hold at a pixel. The layers are drawn when they are first asked for after the
 * picture has changed, beside it: it stays as it is.
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
  bool IsBackground; ///< nothing is drawn there
};

class Probe
{
public:
  /// The picture has changed.
  void Forget() { this->Image = nullptr; }
  bool IsFresh() const { return this->Image != nullptr; }

  /// Layers of the catalogue, and of arrays. Pixels count from the lower left. Empty outside of the
  /// picture, or if it cannot be read.
  std::vector<ProbeValue> Read(
    vtkRenderer* renderer, const std::vector<std::string>& arrays, int x, int y);

private:
  vtkSmartPointer<vtkImageData> Image;
};
}

#endif
