// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The arrays that a vtkGlyph3DMapper makes its glyphs by, which VTK keeps protected. They are named
// through a derived class that is never made: its pointers to members are of the base's type.
#ifndef vtkRelievoGlyphArrays_h
#define vtkRelievoGlyphArrays_h

#include "vtkGlyph3DMapper.h"

class vtkRelievoGlyphArrays : public vtkGlyph3DMapper
{
public:
  static vtkDataArray* GetMask(vtkGlyph3DMapper* mapper, vtkDataSet* input)
  {
    return (mapper->*(&vtkRelievoGlyphArrays::GetMaskArray))(input);
  }
  static vtkDataArray* GetSourceIndex(vtkGlyph3DMapper* mapper, vtkDataSet* input)
  {
    return (mapper->*(&vtkRelievoGlyphArrays::GetSourceIndexArray))(input);
  }
  static vtkDataArray* GetOrientation(vtkGlyph3DMapper* mapper, vtkDataSet* input)
  {
    return (mapper->*(&vtkRelievoGlyphArrays::GetOrientationArray))(input);
  }
  static vtkDataArray* GetScale(vtkGlyph3DMapper* mapper, vtkDataSet* input)
  {
    return (mapper->*(&vtkRelievoGlyphArrays::GetScaleArray))(input);
  }
};

#endif
