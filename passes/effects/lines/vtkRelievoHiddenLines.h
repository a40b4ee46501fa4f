// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cover of each pixel by dashed lines of hidden edges. The edges are those of the meshes, in
// double: boundaries, creases between triangles, and silhouettes, where one triangle faces the eye
// and the other does not. Edges that are visible by the frame's depth are not drawn.
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
    bool Silhouettes; // and boundaries
    bool Creases;
    double CreaseCosine;
    double HalfWidth; // pixels
    double Dash;      // pixels
  };

  vtkRelievoHiddenLines();
  ~vtkRelievoHiddenLines();

  // Draws the covered share into the target's third channel, where it exceeds the present value.
  // Returns an error message, or an empty string.
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
  std::map<vtkPolyData*, Held> Edges; // of the meshes drawn last
  vtkRelievoTextureBuffer Pieces;
  vtkRelievoInstancedQuads Quads;
};

#endif
