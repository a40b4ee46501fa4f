// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCgroup.h
 * @brief The memory that Linux control groups leave, as containers and batch systems set it.
 */
#ifndef vtkRelievoCgroup_h
#define vtkRelievoCgroup_h

#include <string>

namespace relievo
{
/**
 * Bytes that the process's control group and those around it, of version 1 or 2, leave; infinity
 * without a limit. What the system holds of files may be given back, and counts as free.
 * `processGroups` is the file that names the groups, and `root` the folder that has them.
 */
double FreeBytesOfCgroup(const std::string& processGroups = "/proc/self/cgroup",
  const std::string& root = "/sys/fs/cgroup");
}

#endif
