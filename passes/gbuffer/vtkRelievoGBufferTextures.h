// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers of a frame as its stages read them on the GPU: shaders include gbuffer/read.glsl.
#ifndef vtkRelievoGBufferTextures_h
#define vtkRelievoGBufferTextures_h

#include "vtkRelievoShading.h"

class vtkRelievoGBufferTarget;
struct vtkRelievoGBufferLayout;

class vtkRelievoGBufferTextures : public vtkRelievoShading
{
public:
  // The viewport begins at `offset` within the textures.
  void Set(const vtkRelievoGBufferLayout& layout, vtkRelievoGBufferTarget& target,
    const int offset[2], bool worldNormals);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  const vtkRelievoGBufferLayout* Layout = nullptr;
  vtkRelievoGBufferTarget* Target = nullptr;
  int Offset[2] = { 0, 0 };
  bool WorldNormals = true;
};

#endif
