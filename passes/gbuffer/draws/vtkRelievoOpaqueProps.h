// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The props of a frame that write layers: actors with a mapper, parts of assemblies and levels of
// detail included.
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

  // Class of a prop that may draw opaque geometry without writing layers; empty if there is none.
  const std::string& GetForeign() const { return this->Foreign; }

  // Whether faces are drawn with edges, which VTK draws beyond the faces' outline.
  bool ShowsEdges() const { return this->Edges; }

  // Splices the pass into the props' shaders, until RemovePass().
  void AddPass(vtkOpenGLRenderPass* pass);
  void RemovePass(vtkOpenGLRenderPass* pass);

  // Draws the opaque geometry of the props that write layers; of wireframes only the visible lines
  // if `removesHiddenLines`.
  void RenderOpaque(vtkRenderer* renderer, bool removesHiddenLines);

private:
  std::vector<vtkProp*> Props; // in the renderer's order
  std::set<vtkProp*> Mixed;    // subset of Props: assemblies of which only the meshes write layers
  std::string Foreign;
  bool Edges = false;
  vtkRelievoSplicedKeys Spliced;
};

#endif
