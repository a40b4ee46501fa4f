// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of points with values, for the stages that draw points: --lamps, --fog, --markers. The list
 * of stages and their values comes from the stages' own descriptions.
 */
#ifndef Points_h
#define Points_h

#include "Values.h"

#include "vtkRelievoPointValues.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoPass;

namespace scene
{
class Progress;
struct RenderOptions;

/// A stage that draws points; its option is --NAME.
struct PointStage
{
  std::string Name;
  vtkSmartPointer<vtkRelievoPointValues> Points; ///< new ones, for their description
  std::vector<std::string> Parameters;           ///< stage parameters that the option accepts too
  std::string Help;                              ///< help of the option
};

/// The point stages of a frame, in its order.
const std::vector<PointStage>& GetPointStages();

/// One use of such an option.
struct PointsChoice
{
  std::string Stage;
  std::string File;
  NamedWords Values; ///< values of points, by name
};

/// Parses FILE[,NAME=VALUE]...: values of points, or parameters of the stage. Throws UsageError.
void TakePoints(RenderOptions& options, const std::string& stage, const std::string& word);

/// Parses the file and the values, each name once; \, is a comma within a value. Throws UsageError.
std::string ParseFileAndValues(
  const std::string& option, const std::string& word, NamedWords& values);

/// Writes a word that ParseFileAndValues accepts.
std::string WriteFileAndValues(const std::string& file, const NamedWords& values);

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
FramePoints ReadFramePoints(const RenderOptions& options, Progress& progress);

/// Gives the points to a new pass.
void AddFramePoints(vtkRelievoPass* pass, const FramePoints& points);
}

#endif
