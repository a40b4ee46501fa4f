// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCgroup.h
 * @brief The free memory within Linux control groups, as set by containers and batch systems.
 */
#ifndef vtkRelievoCgroup_h
#define vtkRelievoCgroup_h

#include "vtkRelievoBaseModule.h" // for the export macro

#include <string>

namespace relievo
{
/**
 * Free bytes in the process's control group and its ancestors, of version 1 or 2; infinity without
 * a limit. Inactive file cache can be reclaimed, so it counts as free. `processGroups` is the file
 * that names the groups, and `root` the folder that contains them.
 */
VTKRELIEVOBASE_EXPORT double FreeBytesOfCgroup(
  const std::string& processGroups = "/proc/self/cgroup",
  const std::string& root = "/sys/fs/cgroup");
}

#endif
