// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoReserve.h
 * @brief Room for what is inserted later: growing takes twice the room.
 */
#ifndef vtkRelievoReserve_h
#define vtkRelievoReserve_h

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkRelievoVTKVersions.h"

namespace relievo
{
/** Room for so many values of an array that is empty. */
inline void Reserve(vtkDataArray* array, vtkIdType values)
{
#ifdef RELIEVO_VTK_RESERVE
  array->ReserveValues(values);
#else
  array->Allocate(values);
#endif
}

/** Room for so many points where there are none. */
inline void Reserve(vtkPoints* points, vtkIdType count)
{
  Reserve(points->GetData(), 3 * count);
}
}

#endif
