// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cameras of a data set, in words or from a file.
 */
#ifndef DatasetPoses_h
#define DatasetPoses_h

#include "DatasetNames.h"
#include "vtkBoundingBox.h"
#include "vtkRelievoCameraModel.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dataset
{
/// A random generator with equal sequences on every machine (G. Steele, D. Lea, C. Flood, Fast
/// splittable pseudorandom number generators, 2014).
class DatasetRandom
{
public:
  DatasetRandom(int seed, int purpose, int view);

  double Next(double low, double high);

private:
  std::uint64_t State;
};

/// The scene that poses surround.
struct DatasetSurroundings
{
  vtkBoundingBox Box; ///< invalid: the scene is empty
  int UpAxis;         ///< default up axis of poses with position and target, too
  int Seed;
};

/// Parses "orbit:N[,NAME=VALUE]...", "random:N[,NAME=VALUE]..." or a JSON file into cameras: copies
/// of `like` with the given values replaced. `option` is named in errors: UsageError, FileError.
std::vector<vtkSmartPointer<vtkRelievoCameraModel>> MakeDatasetPoses(const std::string& option,
  const std::string& words, vtkRelievoCameraModel* like, const DatasetSurroundings& around);

/// Throws UsageError for words that describe no poses, without knowing the scene; reads no file.
void CheckDatasetPoses(const std::string& option, const std::string& words);

/// The direction towards a view's sun, by the view's number: 15 to 75 degrees above the horizon.
std::array<double, 3> MakeDatasetSun(int seed, int view, int upAxis);
}

#endif
