// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of each pixel the dashed lines of hidden edges cover. Edges are those of the meshes
// themselves, in double: where one ends, where its triangles meet at an angle, and where one faces
// the eye and the other does not. Nothing is drawn where the frame's depth says that they are seen.
#ifndef vtkRelievoHiddenLines_h
#define vtkRelievoHiddenLines_h

#include "vtkRelievoFeatureEdges.h"
#include "vtkRelievoInstancedQuads.h"
#include "vtkRelievoOpaqueMeshes.h"
#include "vtkRelievoTextureBuffer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>

class vtkRelievoFrameContext;
class vtkRelievoScreenTarget;
class vtkWindow;

class vtkRelievoHiddenLines
{
public:
  struct Settings
  {
    bool Silhouettes; // and where a mesh ends
    bool Creases;
    double CreaseCosine;
    double HalfWidth; // pixels
    double Dash;      // pixels
  };

  vtkRelievoHiddenLines();
  ~vtkRelievoHiddenLines();

  // Draws the share that is covered into the target's third channel, where it is more than what is
  // there. Returns what is wrong, in words.
  std::string Draw(
    vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target, const Settings& settings);

  int GetNumberOfPropsLeftOut() const { return this->Meshes.GetNumberOfPropsLeftOut(); }

  vtkIdType GetBytes() const { return this->Pieces.GetBytes(); }
  void Release(vtkWindow* window);

private:
  struct Held
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkRelievoFeatureEdges Edges;
  };

  std::vector<float> FindPieces(const vtkRelievoFrameContext& context, const Settings& settings);

  vtkRelievoOpaqueMeshes Meshes;
  std::map<vtkPolyData*, Held> Edges; // of what was drawn last
  vtkRelievoTextureBuffer Pieces;
  vtkRelievoInstancedQuads Quads;
};

#endif
