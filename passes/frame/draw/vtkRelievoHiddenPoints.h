// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Leaves out of what an actor draws the points of which nothing is seen, because others of its
// points lie before them. OpenGL shades each pixel of a point that is drawn as a sphere before it
// knows whether it is hidden: in software that is most of a picture of many points. The picture is
// the same, bit for bit: what rounding may show is drawn.
#ifndef vtkRelievoHiddenPoints_h
#define vtkRelievoHiddenPoints_h

#include "vtkNew.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkProp;
class vtkRenderer;

class VTKRELIEVOFRAME_EXPORT vtkRelievoHiddenPoints
{
public:
  // Whether the prop may be one that draws many points as spheres; fast.
  static bool IsPossible(vtkProp* prop);

  // While this object lives, draw the prop with the renderer's camera into OpenGL's viewport.
  // `flat`: into a map, where spheres are discs. Does nothing where it cannot, or need not.
  vtkRelievoHiddenPoints(vtkProp* prop, vtkRenderer* renderer, bool flat);
  ~vtkRelievoHiddenPoints();
  vtkRelievoHiddenPoints(const vtkRelievoHiddenPoints&) = delete;
  vtkRelievoHiddenPoints& operator=(const vtkRelievoHiddenPoints&) = delete;

  // How many points are drawn; -1: all.
  vtkIdType GetNumberOfSeen() const;

private:
  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper;
  vtkOpenGLIndexBufferObject* All = nullptr;
  vtkNew<vtkOpenGLIndexBufferObject> Seen;
};

#endif
