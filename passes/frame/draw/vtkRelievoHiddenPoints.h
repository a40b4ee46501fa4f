// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Leaves out an actor's points that are completely hidden by its other points. OpenGL shades each
// pixel of a point drawn as a sphere before the depth test, which on software OpenGL takes most of
// the time of pictures with many points. The picture is identical, bit for bit: points that
// rounding may reveal are drawn.
#ifndef vtkRelievoHiddenPoints_h
#define vtkRelievoHiddenPoints_h

#include "vtkNew.h"
#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkProp;
class vtkRelievoPointGroups;
class vtkRenderer;

class VTKRELIEVOFRAME_EXPORT vtkRelievoHiddenPoints
{
public:
  // Whether the prop may draw many points as spheres; fast.
  static bool IsPossible(vtkProp* prop);

  // The mesh, if the prop draws only many spheres at its vertices, by VTK's own code; else nullptr.
  static vtkPolyData* GetMesh(vtkProp* prop);

  // During the lifetime of this object, drawing the prop with the renderer's camera into OpenGL's
  // viewport leaves out hidden points. Does nothing for other props or few points. `groups` keeps
  // data that do not depend on the camera.
  vtkRelievoHiddenPoints(vtkProp* prop, vtkRenderer* renderer, vtkRelievoPointGroups& groups);
  ~vtkRelievoHiddenPoints();
  vtkRelievoHiddenPoints(const vtkRelievoHiddenPoints&) = delete;
  vtkRelievoHiddenPoints& operator=(const vtkRelievoHiddenPoints&) = delete;

  // Number of points drawn; -1: all.
  vtkIdType GetNumberOfSeen() const;

private:
  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper;
  vtkOpenGLIndexBufferObject* All = nullptr;
  vtkNew<vtkOpenGLIndexBufferObject> Seen;
};

#endif
