// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The props of a frame that write layers: actors with a mapper, also as parts of assemblies
// and as levels of detail.
#ifndef vtkRelievoOpaqueProps_h
#define vtkRelievoOpaqueProps_h

#include "vtkRelievoSplicedKeys.h"

#include <set>
#include <string>
#include <vector>

class vtkOpenGLRenderPass;
class vtkProp;
class vtkRenderer;
struct vtkRelievoFrameScene;

class vtkRelievoOpaqueProps
{
public:
  void Collect(const vtkRelievoFrameScene& scene);

  // Class of a prop that may draw opaque geometry but writes no layers; empty if there is none.
  const std::string& GetForeign() const { return this->Foreign; }

  // Whether faces are drawn with edges, which VTK has reach beyond them.
  bool ShowsEdges() const { return this->Edges; }

  // Splices the pass into the shaders of the props, until it is removed.
  void AddPass(vtkOpenGLRenderPass* pass);
  void RemovePass(vtkOpenGLRenderPass* pass);

  // Draws the opaque geometry of those props that write layers, of wire frames what is in sight
  // only if it is asked.
  void RenderOpaque(vtkRenderer* renderer, bool removesHiddenLines);

private:
  std::vector<vtkProp*> Props; // in the renderer's order
  std::set<vtkProp*> Mixed;    // of Props: assemblies of which only the meshes write layers
  std::string Foreign;
  bool Edges = false;
  vtkRelievoSplicedKeys Spliced;
};

#endif
