// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ambient occlusion of shadow catchers: darkens them by the hidden share of the sky, in VTK's own
// shaders while VTK draws them.
#ifndef vtkRelievoAmbientCatch_h
#define vtkRelievoAmbientCatch_h

#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoSplicedPass.h"

#include <functional>
#include <vector>

class vtkProp;

class vtkRelievoAmbientCatch : public vtkRelievoSplicedPass
{
public:
  static vtkRelievoAmbientCatch* New();
  vtkTypeMacro(vtkRelievoAmbientCatch, vtkRelievoSplicedPass);

  // From Begin() to End(), these props are darkened; `tell` sets a program's uniforms.
  void Begin(vtkOpenGLRenderWindow* window, const std::vector<vtkProp*>& props,
    const std::function<void(vtkShaderProgram*)>& tell);
  void End();

  // Called by VTK's mappers.
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  void Render(const vtkRenderState*) override {}

protected:
  vtkRelievoAmbientCatch() = default;
  ~vtkRelievoAmbientCatch() override = default;

  bool IsSplicing() const override { return this->Window != nullptr; }
  void MarkShaders(const vtkRelievoShaderTexts& shaders) override;
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;

private:
  vtkRelievoAmbientCatch(const vtkRelievoAmbientCatch&) = delete;
  void operator=(const vtkRelievoAmbientCatch&) = delete;

  vtkRelievoSplicedKeys Keys;
  std::function<void(vtkShaderProgram*)> Tell;
  vtkOpenGLRenderWindow* Window = nullptr; // between Begin and End
};

#endif
