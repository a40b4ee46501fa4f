// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights translucent surfaces with lamps, in VTK's own shaders while VTK draws them: each fragment
// computes the lamps of its cluster.
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

  // From Begin() to End(), VTK's translucent surfaces, or only catchers of shadows, are drawn with
  // the lamps' light. The sets are shared or up to date. Returns an error message, or an empty
  // string.
  std::string Begin(
    vtkRelievoFrameContext& context, const std::vector<vtkRelievoLamps*>& sets, bool all);
  void End();

  // Number of lit props in the frame.
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
