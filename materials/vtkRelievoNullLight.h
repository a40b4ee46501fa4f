// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A light of no intensity: without any light VTK's shaders shade nothing, and have no normals to
// mirror an environment about or to be lit by it.
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

  // Puts the light into the renderer if it is `wanted` and no other is on, else takes it out.
  void Place(vtkRenderer* renderer, bool wanted);

private:
  vtkNew<vtkLight> Light;
};

#endif
