// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoReserve.h
 * @brief Reserves room for later insertions: growing takes twice the room.
 */
#ifndef vtkRelievoReserve_h
#define vtkRelievoReserve_h

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkRelievoVTKVersions.h"

namespace relievo
{
/** Reserves room for so many values in an empty array. */
inline void Reserve(vtkDataArray* array, vtkIdType values)
{
#ifdef RELIEVO_VTK_RESERVE
  array->ReserveValues(values);
#else
  array->Allocate(values);
#endif
}

/** Reserves room for so many points in an empty set. */
inline void Reserve(vtkPoints* points, vtkIdType count)
{
  Reserve(points->GetData(), 3 * count);
}
}

#endif
