// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights what is translucent with lamps, in VTK's own shaders while VTK draws it: each fragment
// computes the lamps that its cluster lists.
#ifndef vtkRelievoTranslucentLamps_h
#define vtkRelievoTranslucentLamps_h

#include "vtkRelievoLampClusters.h"
#include "vtkRelievoLampList.h"
#include "vtkRelievoSplicedKeys.h"
#include "vtkRelievoSplicedPass.h"
#include "vtkRelievoTextureBuffer.h"

#include <string>
#include <vector>

class vtkRelievoFrameContext;
class vtkRelievoLamps;

class vtkRelievoTranslucentLamps : public vtkRelievoSplicedPass
{
public:
  static vtkRelievoTranslucentLamps* New();
  vtkTypeMacro(vtkRelievoTranslucentLamps, vtkRelievoSplicedPass);

  // From here to End, the lamps' light is in what VTK draws translucent: all of it, or catchers of
  // shadows alone. The sets are shared or up to date. Returns what is wrong, in words.
  std::string Begin(
    vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, bool all);
  void End();

  // Those that are lit in the frame.
  int GetNumberOfProps() const { return this->NumberOfProps; }

  vtkIdType GetBytes() const;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // Called by VTK's mappers.
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  void Render(const vtkRenderState*) override {}

protected:
  vtkRelievoTranslucentLamps() = default;
  ~vtkRelievoTranslucentLamps() override = default;

  bool IsSplicing() const override;
  void MarkShaders(const vtkRelievoShaderTexts& shaders) override;
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;

private:
  vtkRelievoTranslucentLamps(const vtkRelievoTranslucentLamps&) = delete;
  void operator=(const vtkRelievoTranslucentLamps&) = delete;

  vtkRelievoFrameCamera View;
  vtkRelievoLampList List;
  vtkRelievoLampClusters Clusters;
  vtkRelievoTextureBuffer Lamps;
  vtkRelievoTextureBuffer Attenuations;
  vtkRelievoTextureBuffer Cells;
  vtkRelievoTextureBuffer Lists;
  vtkRelievoSplicedKeys Keys;
  vtkOpenGLRenderWindow* Window = nullptr; // between Begin and End
  int NumberOfProps = 0;
  bool Parallel = false;
};

#endif
