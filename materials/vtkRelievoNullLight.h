// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A light of intensity 0: without any light VTK's shaders compute no normals, which the reflection
// of an environment and its lighting need.
#ifndef vtkRelievoNullLight_h
#define vtkRelievoNullLight_h

#include "vtkNew.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro

class vtkLight;
class vtkRenderer;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoNullLight
{
public:
  vtkRelievoNullLight();
  ~vtkRelievoNullLight();
  vtkRelievoNullLight(const vtkRelievoNullLight&) = delete;
  void operator=(const vtkRelievoNullLight&) = delete;

  // Adds the light to the renderer if it is `wanted` and no other light is on, else removes it.
  void Place(vtkRenderer* renderer, bool wanted);

private:
  vtkNew<vtkLight> Light;
};

#endif
