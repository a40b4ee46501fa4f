// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --lamps, --fog, --markers: files of points with values, for the stages that draw such. Which
 * stages these are, and which values they take, they say themselves.
 */
#ifndef PointOptions_h
#define PointOptions_h

#include "Values.h"

#include "vtkRelievoPointValues.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace scene
{
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

/// New values of points for a stage of that name.
vtkSmartPointer<vtkRelievoPointValues> MakePointValues(const std::string& stage);

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
}

#endif
