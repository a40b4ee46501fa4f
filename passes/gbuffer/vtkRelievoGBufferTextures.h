// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gives stages access to a frame's layers on the GPU: shaders include gbuffer/read.glsl.
#ifndef vtkRelievoGBufferTextures_h
#define vtkRelievoGBufferTextures_h

#include "vtkRelievoShading.h"
#include "vtkRelievoTextureBuffer.h"

class vtkOpenGLRenderWindow;
class vtkRelievoDrawTable;
class vtkRelievoGBufferTarget;
class vtkWindow;
struct vtkRelievoGBufferLayout;

class vtkRelievoGBufferTextures : public vtkRelievoShading
{
public:
  // The viewport starts at `offset` within the textures.
  void Set(const vtkRelievoGBufferLayout& layout, vtkRelievoGBufferTarget& target,
    const int offset[2], bool worldNormals);

  // Sets the draws from which relievoFetchPart finds connected ids, evaluated only if a shader uses
  // it.
  void SetDraws(const vtkRelievoDrawTable& draws, vtkOpenGLRenderWindow* window);
  vtkIdType GetBytes() const { return this->Parts.GetBytes(); }
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  void ActivateParts(vtkShaderProgram* program);

  const vtkRelievoGBufferLayout* Layout = nullptr;
  vtkRelievoGBufferTarget* Target = nullptr;
  int Offset[2] = { 0, 0 };
  bool WorldNormals = true;
  const vtkRelievoDrawTable* Draws = nullptr; // until they are converted to Parts
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkRelievoTextureBuffer Parts;
  int NumberOfParts = 0;
};

#endif
