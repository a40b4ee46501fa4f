// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRThreads.h
 * @brief OpenEXR's threads, of which a process has one set.
 */
#ifndef vtkRelievoEXRThreads_h
#define vtkRelievoEXRThreads_h

namespace relievo::exr
{
/** Sees to it that OpenEXR has at least `count` threads; never takes any away. Thread-safe. */
void StartThreads(int count);
}

#endif
