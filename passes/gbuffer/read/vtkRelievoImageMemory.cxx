// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoImageMemory.h"

#include "vtkAbstractArray.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace
{
constexpr std::size_t LargePage = std::size_t(2) << 20;
}

//------------------------------------------------------------------------------
void* vtkRelievoNewImageMemory(std::size_t bytes)
{
#ifdef __linux__
  void* aligned = nullptr;
  if (bytes >= LargePage && posix_memalign(&aligned, LargePage, bytes) == 0)
  {
    // The rest of an incomplete page stays in small pages; the whole block does if madvise fails.
    madvise(aligned, bytes / LargePage * LargePage, MADV_HUGEPAGE);
    return aligned;
  }
#endif
  if (void* memory = std::malloc(bytes))
  {
    return memory;
  }
  throw std::bad_alloc();
}

//------------------------------------------------------------------------------
void vtkRelievoAllocateImage(vtkDataArray* array, int components, vtkIdType tuples)
{
  array->SetNumberOfComponents(components);
  const vtkIdType values = tuples * components;
  const std::size_t bytes =
    static_cast<std::size_t>(values) * static_cast<std::size_t>(array->GetDataTypeSize());
  // Arrays of bits are not byte-addressed.
  if (bytes >= LargePage && array->HasStandardMemoryLayout())
  {
    array->SetVoidArray(
      vtkRelievoNewImageMemory(bytes), values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
    return;
  }
  array->SetNumberOfTuples(tuples);
}
