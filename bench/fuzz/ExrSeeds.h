// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExrSeeds.h
 * @brief Small intact EXR files of every kind, from which the fuzz run starts.
 */
#ifndef ExrSeeds_h
#define ExrSeeds_h

#include <string>
#include <vector>

namespace exrFuzz
{
/**
 * The bytes of the files: scan lines and tiles with every compression, mip and rip maps, several
 * parts, subsampled channels, deep data, and layers written by vtkRelievoEXRWriter.
 * \param folder  Where they are written for a moment.
 */
std::vector<std::string> MakeSeeds(const std::string& folder);
}

#endif
