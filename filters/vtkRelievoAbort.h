// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoAbort.h
 * @brief Work that is cut short: when to stop, and what becomes of the outputs.
 */
#ifndef vtkRelievoAbort_h
#define vtkRelievoAbort_h

class vtkAlgorithm;
class vtkInformationVector;

namespace relievo
{
/** Whether the filter is to stop, or, where VTK asks them, one that it has its input from. */
bool IsStopped(vtkAlgorithm* filter);

/** To be called before outputs are made: what Discard has set is undone. */
void Begin(vtkInformationVector* outputs);

/** Empties the outputs: the next update makes them, though nothing has changed. */
void Discard(vtkInformationVector* outputs);
}

#endif
