// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The draw calls of a frame that wrote layers, and what a pixel's two id words (draw, primitive)
// mean: actor, block, cell, and the mesh with its data.
#ifndef vtkRelievoDrawTable_h
#define vtkRelievoDrawTable_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <vector>

class vtkActor;
class vtkInformation;
class vtkOpenGLCellToVTKCellMap;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkRenderer;

class vtkRelievoDrawTable
{
public:
  struct Hit
  {
    int Actor = -1;      // place in vtkRenderer::GetActors()
    int Block = -1;      // flat index; 0 for data that is not composite
    vtkIdType Cell = -1; // of Mesh, or the glyphs' input point
    vtkIdType Primitive = -1; // OpenGL primitive within Mesh's cell: 0 is its first
    vtkPolyData* Mesh = nullptr; // nullptr for glyphs
    vtkActor* Prop = nullptr;
  };

  void Clear();

  // A draw call begins; returns its id.
  int Add(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource);
  int GetNumberOfDraws() const { return static_cast<int>(this->Draws.size()); }

  // Makes ready for Find(), from what the mappers hold now.
  void Resolve(vtkRenderer* renderer);

  // After Resolve(): every mesh drawn, and (Mesh == nullptr) every actor of glyphs, with its actor.
  std::vector<Hit> GetMeshes() const;

  // What the words mean; all of it nothing if they mean nothing. Threads may call it at once.
  Hit Find(std::uint32_t draw, std::uint32_t primitive) const;

private:
  struct Range
  {
    vtkIdType First; // first primitive of the block
    int Block;
    vtkPolyData* Mesh;
    vtkOpenGLCellToVTKCellMap* Map;
  };
  struct Draw
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkInformation* Keys; // an LOD actor's device shares them with the actor in the renderer
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    int PrimitiveSource;
    int ActorIndex;
    vtkActor* Prop;
    std::vector<Range> Ranges; // by First
  };

  static void ResolveRanges(Draw& draw);

  std::vector<Draw> Draws;
};

#endif
