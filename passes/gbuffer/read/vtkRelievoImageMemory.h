// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Memory for a value or more of each pixel, in pages of 2 MB where Linux has them: to be given ten
// thousand of 4 kB takes longer than to decode what goes there.
#ifndef vtkRelievoImageMemory_h
#define vtkRelievoImageMemory_h

#include "vtkDataArray.h"

#include <cstddef>

// What free() gives back. Throws std::bad_alloc, as `new` does.
void* vtkRelievoNewImageMemory(std::size_t bytes);

// Room for the tuples, not cleared.
void vtkRelievoAllocateImage(vtkDataArray* array, int components, vtkIdType tuples);

#endif
