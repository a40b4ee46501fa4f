// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of points with values, for the stages that draw points: --lamps, --fog, --markers. The list
 * of stages and their values comes from the stages' own descriptions.
 */
#ifndef PointOptions_h
#define PointOptions_h

#include "SceneNames.h"
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
  vtkSmartPointer<vtkRelievoPointValues> Points; ///< new ones, for their description
  std::vector<std::string> Parameters;           ///< stage parameters that the option accepts too
  std::string Help;                              ///< help of the option
};

/// The point stages of a frame, in its order.
const std::vector<PointStage>& GetPointStages();

/// New values of points for the stage of that name.
vtkSmartPointer<vtkRelievoPointValues> MakePointValues(const std::string& stage);

/// One use of such an option.
struct PointsChoice
{
  std::string Stage;
  std::string File;
  NamedWords Values; ///< values of points, by name
};

/// The rows of these options.
void AddPointOptions(OptionRows& rows, RenderOptions& options);

/// Parses the file and the values, each name once; \, is a comma within a value. Throws UsageError.
std::string ParseFileAndValues(
  const std::string& option, const std::string& word, NamedWords& values);

/// Writes a word that ParseFileAndValues accepts.
std::string WriteFileAndValues(const std::string& file, const NamedWords& values);
}

#endif
