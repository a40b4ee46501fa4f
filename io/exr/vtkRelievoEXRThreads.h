// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRThreads.h
 * @brief OpenEXR's threads, one set per process.
 */
#ifndef vtkRelievoEXRThreads_h
#define vtkRelievoEXRThreads_h

namespace relievo::exr
{
/** Ensures that OpenEXR has at least `count` threads; never removes any. Thread-safe. */
void StartThreads(int count);
}

#endif
