// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of files, for the stages that draw such.
 */
#ifndef Points_h
#define Points_h

#include "vtkRelievoPointValues.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoPass;

namespace scene
{
class ReadContext;
struct PointsChoice;
struct RenderOptions;

/// Throws UsageError or WorkError, which name the option or the file, for one that cannot be read
/// or is no points.
void CheckPointFile(const PointsChoice& choice);

/// Points for a stage of that name.
struct FramePointSet
{
  std::string Stage;
  vtkSmartPointer<vtkRelievoPointValues> Points;
};
using FramePoints = std::vector<FramePointSet>;

/// Throws UsageError for arrays that a file does not have, WorkError with the file's name: what
/// cannot be read, arrays that do not fit, files without a point that has an effect.
FramePoints ReadFramePoints(const RenderOptions& options, ReadContext& context);

/// Gives the points to a pass that has none.
void AddFramePoints(vtkRelievoPass* pass, const FramePoints& points);
}

#endif
