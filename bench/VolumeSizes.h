// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeSizes.h
 * @brief The bench of volumes, as long as it takes.
 */
#ifndef relievoBenchVolumeSizes_h
#define relievoBenchVolumeSizes_h

#include <string>
#include <vector>

/** Light through volumes: error against time, closed forms; frames beside VTK's. Minutes. */
int RelievoBenchVolumes(const std::string& outDir);

namespace relievoBench
{
struct VolumeSizes
{
  std::vector<int> Sizes = { 64, 128, 256, 512 }; // voxels along an axis
  int Largest = 128;                              // above it only the ball, by the default
  std::vector<int> Nodes = { 32, 64, 128, 256 };
  int FourierNodes = 256; // those with rows for Fourier terms too
  int Places = 1000;
  std::vector<int> FrameSizes = { 64, 128, 256 };
  int Rounds = 7;
};

int BenchVolumes(const std::string& outDir, const VolumeSizes& sizes);
}

#endif
