// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's shaders of spheres and tubes read the fragment's depth before writing it when they shift
// coincident surfaces, so that visibility depends on old register content. During a frame, that
// depth is initialized with the primitive's depth.
#ifndef vtkRelievoDepthSplice_h
#define vtkRelievoDepthSplice_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoSplicedPass.h"

class vtkOpenGLRenderWindow;
struct vtkRelievoFrameScene;

class VTKRELIEVOFRAME_EXPORT vtkRelievoDepthSplice : public vtkRelievoSplicedPass
{
public:
  static vtkRelievoDepthSplice* New();
  vtkTypeMacro(vtkRelievoDepthSplice, vtkRelievoSplicedPass);

  // Between Begin() and End(), shaders that may write depth have the splice.
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
