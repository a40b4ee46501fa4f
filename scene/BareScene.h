// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene as read from its files, and how to undo every option that was applied to it.
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

  /// Restores the scene as read from its files; surface maps and the skybox stay.
  Scene& Undress();

  /// Replaces surface maps and the skybox. If this throws, the old ones stay, and their files are
  /// not read again.
  void Wear(const RenderOptions& options, Progress& progress);
  void TakeOff();

  Scene& Get() { return this->Read; }
  const Scene& Get() const { return this->Read; }

  /// An actor's state before options were applied.
  struct Part
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<vtkProperty> Property;
    vtkSmartPointer<vtkTexture> Texture;
    bool SRGB;                                    // whether the texture is sRGB
    vtkSmartPointer<vtkRelievoMaterial> Material; // the model's own material
    bool Colored;
    int ScalarMode, ColorMode, ArrayAccess, ArrayId;
    std::string ArrayName;
    bool OwnRange;
    bool Interpolated; // interpolates scalars before mapping them to colours
  };

  /// Null for an actor that was not read from a file, such as a skeleton.
  const Part* Find(vtkActor* actor) const;

  /// Lights of the files.
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
