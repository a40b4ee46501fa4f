// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of points with values, for the stages that draw such: --lamps, --fog, --markers. Which
 * stages these are, and which values they take, they say themselves.
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
  vtkSmartPointer<vtkRelievoPointValues> Points; ///< new ones, for what they say of themselves
  std::vector<std::string> Parameters;           ///< of the stage, which its option takes as well
  std::string Help;                              ///< of the option
};

/// Of a frame, in its order.
const std::vector<PointStage>& GetPointStages();

/// What an option asks for.
struct PointsChoice
{
  std::string Stage;
  std::string File;
  NamedWords Values; ///< of points, by name
};

/// FILE[,NAME=VALUE]... behind the option of a stage: values of points, or parameters of the stage.
/// Throws UsageError.
void TakePoints(RenderOptions& options, const std::string& stage, const std::string& word);

/// The file, and the names with their values, each once; a comma of one is written \,. Throws
/// UsageError.
std::string ParseFileAndValues(
  const std::string& option, const std::string& word, NamedWords& values);

/// The word that ParseFileAndValues reads so.
std::string WriteFileAndValues(const std::string& file, const NamedWords& values);

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
FramePoints ReadFramePoints(const RenderOptions& options, Progress& progress);

/// Gives the points to a pass that has none.
void AddFramePoints(vtkRelievoPass* pass, const FramePoints& points);
}

#endif
