// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMovedMesh.h"

// Defined here, so that all libraries share one type.
vtkRelievoMovedMesh::~vtkRelievoMovedMesh() = default;
