// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMovedMesh.h"

// Here, so that there is one type of it for all libraries.
vtkRelievoMovedMesh::~vtkRelievoMovedMesh() = default;
