// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The draw calls of a frame that wrote layers, and what a pixel's id word means: actor, block,
// cell, and the mesh with its data. The word counts the primitives of the frame through: a draw's
// first one has the number after the last one of the draw before.
#ifndef vtkRelievoDrawTable_h
#define vtkRelievoDrawTable_h

#include "vtkRelievoCellMap.h"
#include "vtkRelievoFormulas.h" // for GLM
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkInformation;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkRenderer;
struct vtkRelievoFrameCamera;

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
    int Representation = 0; // as it was drawn
    bool Deformed = false;  // by shader code of the actor's own
    bool Moved = false;     // by such, in the picture: its place does not follow from depth
    bool Changed = false;   // Mesh has other cells or points by now

    // Which of the OpenGL primitives that Mesh's cell was cut into: 0 is the first.
    vtkIdType GetPrimitiveInCell() const;

    vtkIdType Primitive = 0; // as OpenGL counts them
    const vtkRelievoCellMap* Map = nullptr;
    const vtkRelievoCellMap::Offsets* Offsets = nullptr;
  };

  void Clear();

  // A draw call begins; returns the id word of its first primitive, or Nothing for all of them
  // where no words are left.
  std::uint32_t Add(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource);

  // Whether the words of the draw that was added last cannot tell its blocks apart.
  bool IsLastAmbiguous() const { return !this->Draws.empty() && this->Draws.back().Ambiguous; }

  // Makes ready for Find(), from what the mappers hold now.
  void Resolve(vtkRenderer* renderer, const vtkRelievoFrameCamera& view);

  // After Resolve(): every mesh and every points that were drawn, with the actor.
  std::vector<Hit> GetMeshes() const;

  // What belongs together among the words: from First on, up to the next one's, they are of part
  // Part, which is an actor's block, or each of a part of its own, -1: glyphs.
  struct PartStart
  {
    std::uint32_t First;
    int Part;
  };
  std::vector<PartStart> GetParts() const;

  // What the word means; all of it nothing if it means nothing. Threads may call it at once.
  Hit Find(std::uint32_t word) const;

private:
  struct Range
  {
    vtkRelievoCellMap::Offsets Offsets;
    int Block;
    // Kept alive: the layers may be read after the scene has let go of them.
    vtkSmartPointer<vtkPolyData> Mesh;
    std::shared_ptr<const vtkRelievoCellMap> Map;
    vtkMTimeType Time; // of Mesh, when it was drawn
    bool Changed = false;
  };
  struct Draw
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkInformation* Keys; // an LOD actor's device shares them with the actor in the renderer
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    int PrimitiveSource;
    int LastPrimitiveType; // of those drawn for it
    int Representation;
    std::uint32_t First;
    std::uint32_t Count;
    glm::dmat4 ModelToWorld; // as it was drawn: an assembly gives its parts other matrices
    int ActorIndex;
    vtkActor* Prop;
    glm::dmat4 ViewToModel;
    glm::dmat4 ModelToView;
    bool Deformed;
    bool Moved;
    bool Ambiguous;            // primitives of several blocks have the same numbers
    std::vector<Range> Ranges; // by their first primitive
    int Block;                 // of Points
    vtkSmartPointer<vtkDataSet> Points;
    std::vector<vtkIdType> Ids; // of Points, by instance of a glyph
  };

  void AddRanges(Draw& draw, vtkOpenGLPolyDataMapper* mapper);
  // Where the count of a kind begins that the mapper draws now.
  static void SetOffset(Draw& draw, vtkOpenGLPolyDataMapper* mapper, int type);
  void ResolveGlyphs();

  std::vector<Draw> Draws;
  vtkRelievoCellMaps Maps;
};

#endif
