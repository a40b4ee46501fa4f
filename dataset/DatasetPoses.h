// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cameras of a data set, in words or from a file.
 */
#ifndef DatasetPoses_h
#define DatasetPoses_h

#include "vtkBoundingBox.h"
#include "vtkRelievoCameraModel.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scene
{
/// Numbers that a seed gives alike on every machine (G. Steele, D. Lea, C. Flood, Fast splittable
/// pseudorandom number generators, 2014).
class DatasetRandom
{
public:
  DatasetRandom(int seed, int purpose, int view);

  double Next(double low, double high);

private:
  std::uint64_t State;
};

/// What poses stand around.
struct DatasetSurroundings
{
  vtkBoundingBox Box; ///< not valid: nothing is there
  int UpAxis;         ///< also of poses by position and target that have no other
  int Seed;
};

/// "orbit:N[,NAME=VALUE]...", "random:N[,NAME=VALUE]..." or a file of JSON: cameras that are copies
/// of `like`, where they do not say otherwise. `option` is named in errors: UsageError, FileError.
std::vector<vtkSmartPointer<vtkRelievoCameraModel>> MakeDatasetPoses(const std::string& option,
  const std::string& words, vtkRelievoCameraModel* like, const DatasetSurroundings& around);

/// Throws UsageError for words that say no poses, whatever there is to see; files are not read.
void CheckDatasetPoses(const std::string& option, const std::string& words);

/// A direction towards the sun of a view, by its number: 15 to 75 degrees above the horizon.
std::array<double, 3> MakeDatasetSun(int seed, int view, int upAxis);
}

#endif
