// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene as it was read, and the way back to it from whatever it was dressed in.
 */
#ifndef BareScene_h
#define BareScene_h

#include "Scene.h"

#include "vtkActor.h" // for the parts
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRelievoMaterial.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <string>
#include <vector>

namespace scene
{
class Progress;

class BareScene
{
public:
  BareScene() = default;

  explicit BareScene(const Scene& scene);

  /// Brings the scene back to how it was read; what surfaces wear stays, and the sky.
  Scene& Undress();

  /// Sets what surfaces wear, and the sky, instead of what there was; that stays, without its files
  /// being read again, where this throws.
  void Wear(const RenderOptions& options, Progress& progress);
  void TakeOff();

  Scene& Get() { return this->Read; }
  const Scene& Get() const { return this->Read; }

  /// What an actor was before it was dressed.
  struct Part
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkProperty> Property;
    vtkSmartPointer<vtkTexture> Texture;
    bool SRGB;                                    // of the texture
    vtkSmartPointer<vtkRelievoMaterial> Material; // of a model that brings one
    bool Colored;
    int ScalarMode, ColorMode, ArrayAccess, ArrayId;
    std::string ArrayName;
    bool OwnRange;
    bool Interpolated; // scalars, before they are colours
  };

  /// Null for an actor that was not read, such as a skeleton.
  const Part* Find(vtkActor* actor) const;

  /// Those of the files.
  const std::vector<vtkSmartPointer<vtkLight>>& GetLights() const { return this->Lights; }

private:
  void Restore(const Part& part);

  Scene Read;
  std::vector<Part> Parts;
  std::vector<vtkSmartPointer<vtkProp>> Props, Kept;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};
}

#endif
