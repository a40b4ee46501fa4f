// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The points of files, for the stages that draw such.
 */
#ifndef Points_h
#define Points_h

#include "SceneNames.h"
#include "vtkRelievoPointValues.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoPass;

namespace reading
{
class ReadContext;
}

namespace scene
{
struct PointsChoice;
struct RenderOptions;

/// Throws UsageError or WorkError, naming the option or the file, if a file cannot be read or
/// contains no points.
void CheckPointFile(const PointsChoice& choice);

/// New points for the stage of that name.
struct FramePointSet
{
  std::string Stage;
  vtkSmartPointer<vtkRelievoPointValues> Points;
};
using FramePoints = std::vector<FramePointSet>;

/// Reads the points. Throws UsageError for arrays that a file lacks, and WorkError naming the file
/// for unreadable files, unsuitable arrays, or files without any point that has an effect.
FramePoints ReadFramePoints(const RenderOptions& options, ReadContext& context);

/// Gives the points to a new pass.
void AddFramePoints(vtkRelievoPass* pass, const FramePoints& points);
}

#endif
