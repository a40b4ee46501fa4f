// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Access to the protected arrays by which a vtkGlyph3DMapper places its glyphs, through a derived
// class that is never instantiated: pointers to members have the base's type.
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
