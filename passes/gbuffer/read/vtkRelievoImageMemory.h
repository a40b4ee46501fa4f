// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Memory for one or more values per pixel, in pages of 2 MB where Linux has them: the allocation of
// ten thousand pages of 4 kB takes longer than the decoding into them.
#ifndef vtkRelievoImageMemory_h
#define vtkRelievoImageMemory_h

#include "vtkDataArray.h"

#include <cstddef>

// Freed by free(). Throws std::bad_alloc, like `new`.
void* vtkRelievoNewImageMemory(std::size_t bytes);

// Allocates the tuples without clearing them.
void vtkRelievoAllocateImage(vtkDataArray* array, int components, vtkIdType tuples);

#endif
