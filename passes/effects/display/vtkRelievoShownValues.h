// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The least and the greatest visible value of a layer of depths in a frame, for the first and the
// last colour. A ground that extends far beyond all other objects counts only within their range. A
// picture in tiles, or one for which only bounds are known, takes the values of the whole scene.
#ifndef vtkRelievoShownValues_h
#define vtkRelievoShownValues_h

#include "vtkRelievoScreenQuad.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkOpenGLFramebufferObject;
class vtkRelievoFrameContext;
class vtkTextureObject;
class vtkWindow;

class vtkRelievoShownValues
{
public:
  // Returns an error message, or an empty string. The range is infinite if no pixel has a value.
  std::string Find(vtkRelievoFrameContext& context, const std::string& layer, double range[2]);

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

private:
  std::string Measure(vtkRelievoFrameContext& context, const std::string& layer, double range[2]);

  vtkRelievoScreenQuad Quad;
  vtkSmartPointer<vtkTextureObject> Extremes; // of squares of pixels
  vtkSmartPointer<vtkOpenGLFramebufferObject> Pen;
  int Size[2] = { 0, 0 };
};

#endif
