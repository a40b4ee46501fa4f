// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a material holds besides its settings.
#ifndef vtkRelievoMaterialInternals_h
#define vtkRelievoMaterialInternals_h

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentTextures.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoMaterialMap.h"
#include "vtkRelievoMaterialSplice.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <set>
#include <string>
#include <vector>

class vtkRelievoMaterial::Internals
{
public:
  vtkRelievoMaterialMap Normals{ "normal map", 3 };
  vtkRelievoMaterialMap Heights{ "height map", 1 };
  vtkRelievoMaterialSplice::Structure Structure;
  vtkTimeStamp StructureTime;
  vtkSmartPointer<vtkRelievoEnvironment> Environment;
  vtkRelievoEnvironmentTextures::Structure EnvironmentStructure;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // drawn in last
  std::vector<vtkWeakPointer<vtkActor>> Actors; // attached to
  std::set<std::string> Said;

  // Units are few: they are given back when the next material, on any actor, is drawn.
  static Internals*& GetInUse()
  {
    static Internals* inUse = nullptr;
    return inUse;
  }
  static void GiveBack()
  {
    Internals*& inUse = GetInUse();
    if (inUse)
    {
      inUse->Normals.Deactivate();
      inUse->Heights.Deactivate();
      if (inUse->Environment)
      {
        vtkRelievoEnvironmentTextures::Of(inUse->Environment).Deactivate(inUse->Window);
      }
    }
    inUse = nullptr;
  }
  void Use()
  {
    GiveBack();
    GetInUse() = this;
  }
  ~Internals()
  {
    if (GetInUse() == this)
    {
      GetInUse() = nullptr;
    }
  }
};

#endif
