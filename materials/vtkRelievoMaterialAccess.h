// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a material needs of VTK's mappers and they keep protected, named through a derived class
// that is never made.
#ifndef vtkRelievoMaterialAccess_h
#define vtkRelievoMaterialAccess_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

class vtkRelievoMaterialAccess : public vtkOpenGLPolyDataMapper
{
public:
  using Self = vtkRelievoMaterialAccess;

  static bool DrawsTriangles(vtkOpenGLPolyDataMapper* mapper)
  {
    vtkOpenGLHelper* bound = mapper->*(&Self::LastBoundBO);
    return bound &&
      (bound->PrimitiveType == PrimitiveTris || bound->PrimitiveType == PrimitiveTriStrips);
  }
  // Of a vertex attribute; 0: the mesh has none.
  static int GetComponents(vtkOpenGLPolyDataMapper* mapper, const char* attribute)
  {
    return (mapper->*(&Self::VBOs))->GetNumberOfComponents(attribute);
  }
  // Texture coordinates are those of a colour table.
  static bool ColorsByTexture(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&Self::InterpolateScalarsBeforeMapping) && mapper->*(&Self::ColorCoordinates);
  }
};

#endif
