// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoAbort.h
 * @brief Aborting a filter: when to stop, and what happens to the outputs.
 */
#ifndef vtkRelievoAbort_h
#define vtkRelievoAbort_h

class vtkAlgorithm;
class vtkInformationVector;

namespace relievo
{
/** Whether the filter must stop, or, in VTK versions that propagate it, a filter upstream. */
bool IsStopped(vtkAlgorithm* filter);

/** Undoes Discard; to be called before outputs are made. */
void Begin(vtkInformationVector* outputs);

/** Empties the outputs, so that the next update makes them although nothing has changed. */
void Discard(vtkInformationVector* outputs);
}

#endif
