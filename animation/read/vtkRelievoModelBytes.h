// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** A model as bytes, for programs that let another process read its file. */
#ifndef vtkRelievoModelBytes_h
#define vtkRelievoModelBytes_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoModel.h"

namespace relievo
{
void PutModel(ByteWriter& writer, const Model& model);

/// Throws std::runtime_error if the bytes are not a model, or its nodes, meshes, materials, lights,
/// cameras and tracks are inconsistent.
void GetModel(ByteReader& reader, Model& model);
}

#endif
