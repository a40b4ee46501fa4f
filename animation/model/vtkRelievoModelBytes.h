// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A model as bytes, for the program that has another process read its file.
 */
#ifndef vtkRelievoModelBytes_h
#define vtkRelievoModelBytes_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoModel.h"

namespace relievo
{
void PutModel(ByteWriter& writer, const Model& model);

/// Throws std::runtime_error if the bytes are no model, or its nodes, meshes, materials, lights,
/// cameras and tracks do not fit each other.
void GetModel(ByteReader& reader, Model& model);
}

#endif
