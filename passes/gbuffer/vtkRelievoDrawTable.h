// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The draw calls of a frame that wrote layers, and what a pixel's id word means: actor, block,
// cell, and the mesh with its data. The word counts the primitives of the frame through: a draw's
// first one has the number after the last one of the draw before.
#ifndef vtkRelievoDrawTable_h
#define vtkRelievoDrawTable_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkInformation;
class vtkOpenGLCellToVTKCellMap;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkRenderer;
struct vtkRelievoView;

class vtkRelievoDrawTable
{
public:
  // The word of a pixel that shows nothing.
  static constexpr std::uint32_t Nothing = 0xffffffffu;

  struct Hit
  {
    int Actor = -1;               // place in vtkRenderer::GetActors()
    int Block = -1;               // flat index; 0 for data that is not composite
    vtkIdType Cell = -1;          // of Mesh, or a point of Points
    vtkPolyData* Mesh = nullptr;  // whose triangles, lines or points are seen
    vtkDataSet* Points = nullptr; // whose points are seen as glyphs, spheres or sticks
    vtkActor* Prop = nullptr;
    const glm::dmat4* ViewToModel = nullptr;
    const glm::dmat4* ModelToView = nullptr;
    bool Deformed = false; // by shader code of the actor's own

    // Which of the OpenGL primitives that Mesh's cell was cut into: 0 is the first.
    vtkIdType GetPrimitiveInCell() const;

    vtkIdType Word = 0;  // the primitive, as OpenGL counts it
    vtkIdType First = 0; // of the block
    vtkOpenGLCellToVTKCellMap* Map = nullptr;
  };

  void Clear();

  // A draw call begins; returns the id word of its first primitive.
  std::uint32_t Add(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource);

  // Makes ready for Find(), from what the mappers hold now.
  void Resolve(vtkRenderer* renderer, const vtkRelievoView& view);

  // After Resolve(): every mesh and every points that were drawn, with the actor.
  std::vector<Hit> GetMeshes() const;

  // What the word means; all of it nothing if it means nothing. Threads may call it at once.
  Hit Find(std::uint32_t word) const;

private:
  struct Range
  {
    vtkIdType First; // first primitive of the block
    int Block;
    // Kept alive: the layers may be read after the scene has let go of them.
    vtkSmartPointer<vtkPolyData> Mesh;
    vtkSmartPointer<vtkOpenGLCellToVTKCellMap> Map;
  };
  struct Draw
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkInformation* Keys; // an LOD actor's device shares them with the actor in the renderer
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    int PrimitiveSource;
    std::uint32_t First;
    std::uint32_t Count;
    glm::dmat4 ModelToWorld; // as it was drawn: an assembly gives its parts other matrices
    int ActorIndex;
    vtkActor* Prop;
    glm::dmat4 ViewToModel;
    glm::dmat4 ModelToView;
    bool Deformed;
    std::vector<Range> Ranges; // by First
    int Block;                 // of Points
    vtkSmartPointer<vtkDataSet> Points;
    std::vector<vtkIdType> Ids; // of Points, by instance of a glyph
  };

  static void AddRanges(Draw& draw, vtkOpenGLPolyDataMapper* mapper);
  void ResolveGlyphs();

  std::vector<Draw> Draws;
};

#endif
