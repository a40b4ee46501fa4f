// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's shaders of spheres and tubes read the depth that they write before they have written it,
// where they move coincident surfaces: what they draw in front depends on what the processor's
// registers held. In a frame, their depth is that of the primitive until they write it.
#ifndef vtkRelievoDepthSplice_h
#define vtkRelievoDepthSplice_h

#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoSplicedPass.h"

class vtkOpenGLRenderWindow;
struct vtkRelievoFrameScene;

class vtkRelievoDepthSplice : public vtkRelievoSplicedPass
{
public:
  static vtkRelievoDepthSplice* New();
  vtkTypeMacro(vtkRelievoDepthSplice, vtkRelievoSplicedPass);

  // From here to End, it is in the shaders of what may write depth.
  void Begin(const vtkRelievoFrameScene& scene, vtkOpenGLRenderWindow* window);
  void End();

  void Render(const vtkRenderState*) override {}

protected:
  vtkRelievoDepthSplice() = default;
  ~vtkRelievoDepthSplice() override = default;

  bool IsSplicing() const override { return this->Window != nullptr; }
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;

private:
  vtkRelievoDepthSplice(const vtkRelievoDepthSplice&) = delete;
  void operator=(const vtkRelievoDepthSplice&) = delete;

  vtkRelievoSplicedKeys Keys;
  vtkOpenGLRenderWindow* Window = nullptr; // between Begin and End
};

#endif
