// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DatasetOptions_h
#define DatasetOptions_h

#include "Options.h"

#include <array>
#include <string>
#include <vector>

namespace cli
{
/// What an object is.
enum class DatasetParts
{
  File,
  Actor,
  Block
};

struct DatasetOptions
{
  std::vector<std::string> Scene; ///< files and options in the words of render
  std::vector<std::string> Words; ///< all words but where to write, and which views
  scene::RenderOptions Render;    ///< of these words
  std::string Poses;              ///< "orbit:N", "random:N", or a file
  std::string Folder;
  int Format = 0; ///< vtkRelievoDatasetWriter::Formats
  std::vector<std::string> Layers;
  DatasetParts Objects = DatasetParts::File;
  double DepthStep = 0.; ///< 0: by the scene
  double MillimetersPerUnit = 1000.;
  int Seed = 0;
  bool RandomSun = false;
  std::array<int, 2> Range = { 0, -1 }; ///< views from one to before another; -1: all
};

/// The words after "dataset", as said.
DatasetOptions ParseDataset(const std::vector<std::string>& words);
}

#endif
