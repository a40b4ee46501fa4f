// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoBuiltInStages_h
#define vtkRelievoBuiltInStages_h

// Registers the stages of Relievo's own modules, once.
void vtkRelievoAddBuiltInStages();

#endif
