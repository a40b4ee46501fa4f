// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shows a layer as the picture: depth, range, normals and albedo straight from the G-buffer's
// words; ids, positions and arrays, whose meaning is known on the CPU only, by way of it.
#ifndef vtkRelievoDisplayStage_h
#define vtkRelievoDisplayStage_h

#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoStage.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkTextureObject;

class vtkRelievoDisplayStage : public vtkRelievoStage
{
public:
  static vtkRelievoDisplayStage* New();
  vtkTypeMacro(vtkRelievoDisplayStage, vtkRelievoStage);

  // Set by the frame, before it asks whether the stage is needed.
  void SetFrame(const std::string& layer, const double range[2], bool grey);

  std::string GetStageName() override { return "display"; }
  vtkIdType GetBytesHeld() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoDisplayStage();
  ~vtkRelievoDisplayStage() override;

  bool IsNeeded(const vtkRenderState* s, std::string& reason) override;
  std::vector<std::string> GetNeededLayers() override;
  void RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s) override;

private:
  vtkRelievoDisplayStage(const vtkRelievoDisplayStage&) = delete;
  void operator=(const vtkRelievoDisplayStage&) = delete;

  // The colours of a layer, made on the CPU, as a texture; false if the layer cannot be read.
  bool UploadColors(vtkRelievoPass* frame, vtkOpenGLRenderWindow* window);

  std::string Layer;
  double Range[2] = { 0.0, 0.0 };
  bool Grey = false;
  vtkRelievoScreenQuad Quad;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkIdType ColorBytes = 0;
  std::string Told; // what was wrong with the layer in the last frame: told once
};

#endif
