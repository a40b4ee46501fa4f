// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Properties of each displayed file.
 */
#ifndef FileFacts_h
#define FileFacts_h

#include "Facts.h"

namespace viewer
{
class Picture;

/// In the order of the files. Finding ranges of arrays takes time.
std::vector<FileFacts> GetFileFacts(
  const Picture& picture, const std::vector<std::string>& files, bool ranges = false);
}

#endif
