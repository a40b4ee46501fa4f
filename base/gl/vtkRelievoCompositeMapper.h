// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's mapper of composite data that draws blocks together, under one name for all versions: VTK
// 9.3 moved the features of vtkCompositePolyDataMapper2 into vtkCompositePolyDataMapper.
#ifndef vtkRelievoCompositeMapper_h
#define vtkRelievoCompositeMapper_h

#include "vtkRelievoVTKVersions.h"

#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
#include "vtkCompositePolyDataMapper2.h"
using vtkRelievoCompositeMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using vtkRelievoCompositeMapper = vtkCompositePolyDataMapper;
#endif

#endif
