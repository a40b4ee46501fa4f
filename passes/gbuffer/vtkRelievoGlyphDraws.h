// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which input points the instances of a vtkGlyph3DMapper's draw calls stand for: masks leave points
// out, and every source has draw calls of its own.
#ifndef vtkRelievoGlyphDraws_h
#define vtkRelievoGlyphDraws_h

#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkGlyph3DMapper;

struct vtkRelievoGlyphDraw
{
  int Block = 0;                // flat index of the points in composite input, else 0
  vtkDataSet* Points = nullptr; // the input
  std::vector<vtkIdType> Ids;   // of the input's points, by instance
};

// In the order in which the mapper draws. Culling, which reorders instances, is not modelled.
std::vector<vtkRelievoGlyphDraw> vtkRelievoGetGlyphDraws(vtkGlyph3DMapper* mapper);

#endif
