// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splices the light of fill lights into VTK's shaders, in place of VTK's code for each of them.
#ifndef vtkRelievoFillSplice_h
#define vtkRelievoFillSplice_h

#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoSplicedPass.h"

#include <functional>
#include <vector>

class vtkProp;

class vtkRelievoFillSplice : public vtkRelievoSplicedPass
{
public:
  static vtkRelievoFillSplice* New();
  vtkTypeMacro(vtkRelievoFillSplice, vtkRelievoSplicedPass);

  // The structure for which shaders are built.
  struct Structure
  {
    std::vector<int> Lights; // the fill lights' numbers in VTK's shaders
    bool Sky = false;        // there is a grid of the visible sky

    bool operator==(const Structure& other) const
    {
      return this->Lights == other.Lights && this->Sky == other.Sky;
    }
  };

  // From Begin() to End(), these props are lit; `tell` sets a program's uniforms.
  void Begin(vtkOpenGLRenderWindow* window, const std::vector<vtkProp*>& props,
    const Structure& structure, const std::function<void(vtkShaderProgram*)>& tell);
  void End();

  // Called by VTK's mappers.
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  void Render(const vtkRenderState*) override {}

protected:
  vtkRelievoFillSplice() = default;
  ~vtkRelievoFillSplice() override = default;

  bool IsSplicing() const override { return this->Window != nullptr; }
  void MarkShaders(const vtkRelievoShaderTexts& shaders) override;
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;

private:
  vtkRelievoFillSplice(const vtkRelievoFillSplice&) = delete;
  void operator=(const vtkRelievoFillSplice&) = delete;

  vtkRelievoSplicedKeys Keys;
  Structure Is;
  std::function<void(vtkShaderProgram*)> Tell;
  vtkOpenGLRenderWindow* Window = nullptr; // between Begin and End
};

#endif
