// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows on volumes that VTK lights: splices shaders/shadow/volume.glsl into their shaders.
#ifndef vtkRelievoShadowVolumes_h
#define vtkRelievoShadowVolumes_h

#include "vtkNew.h"
#include "vtkRelievoVolumeSplice.h"

#include <functional>
#include <string>
#include <vector>

class vtkRelievoShadowMethod;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
class vtkVolumeMapper;
struct vtkRelievoShadowContext;

class vtkRelievoShadowVolumes
{
public:
  // The shadows of a frame. Strength: share of a blocked light that is removed.
  struct Shadows
  {
    const vtkRelievoShadowContext& Work;
    const vtkRelievoShadowMethod& Method;
    double Strength;
    vtkRenderer* Renderer;
    std::function<void(const std::string& message)> Report; // of errors
  };

  vtkRelievoShadowVolumes();
  vtkRelievoShadowVolumes(const vtkRelievoShadowVolumes&) = delete;
  void operator=(const vtkRelievoShadowVolumes&) = delete;

  ///@{
  // Between Begin and End, volumes are drawn with these shadows on them.
  void Begin(const Shadows& shadows);
  void End();
  ///@}

  // The structure of the shadows has changed.
  void ModifyShaders() { this->Splice->ModifyShaders(); }

private:
  std::string Fill(std::string& fragment, const Shadows& shadows);
  void SetUniforms(vtkShaderProgram* program, vtkVolumeMapper* mapper, vtkVolume* volume,
    const Shadows& shadows) const;

  vtkNew<vtkRelievoVolumeSplice> Splice;
  bool Begun = false;
  std::vector<bool> Past; // lights from which surfaces may shade a volume
  bool LampsFirst = true; // VTK's shader numbers positional lights before the others
};

#endif
