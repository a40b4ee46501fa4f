// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The least and the greatest value of depth or range that a frame shows, of what the first and the
// last colour are for: what is seen, but of a ground that reaches far beyond all else only the part
// that is as near and as far as the rest. Of a picture in tiles, and where nothing but bounds is
// known, those of the whole scene.
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
  // Returns what is wrong, in words. Infinite where no pixel has a value.
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
