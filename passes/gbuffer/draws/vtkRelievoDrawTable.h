// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The draw calls of a frame that wrote layers, and the meaning of a pixel's id word: actor, block,
// cell, and the mesh with its data. The word numbers the primitives of the frame consecutively: a
// draw starts where the draw before it ends.
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
  // The word of a background pixel.
  static constexpr std::uint32_t Nothing = 0xffffffffu;

  struct Hit
  {
    int Actor = -1;               // index in vtkRenderer::GetActors()
    int Block = -1;               // flat index; 0 for data that is not composite
    vtkIdType Cell = -1;          // of Mesh, or a point of Points
    vtkPolyData* Mesh = nullptr;  // the mesh whose triangles, lines or points are visible
    vtkDataSet* Points = nullptr; // the points shown as glyphs, spheres or sticks
    vtkActor* Prop = nullptr;
    const glm::dmat4* ViewToModel = nullptr;
    const glm::dmat4* ModelToView = nullptr;
    int Representation = 0; // at the time of drawing
    bool Deformed = false;  // by the actor's own shader code
    // Deformed in the picture, so that the position does not follow from depth.
    bool Moved = false;
    bool Changed = false; // cells or points of Mesh have changed since

    // Index of the OpenGL primitive within Mesh's cell.
    vtkIdType GetPrimitiveInCell() const;

    vtkIdType Primitive = 0; // in OpenGL's count
    const vtkRelievoCellMap* Map = nullptr;
    const vtkRelievoCellMap::Offsets* Offsets = nullptr;
  };

  void Clear();

  // Starts a draw call; returns the id word of its first primitive, or Nothing for the whole draw
  // if the words are used up.
  std::uint32_t Add(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource);

  // Whether the last draw's words cannot distinguish its blocks.
  bool IsLastAmbiguous() const { return !this->Draws.empty() && this->Draws.back().Ambiguous; }

  // Whether data that was drawn has changed since, so that Find() would tell of other data.
  bool IsStale() const;

  // Prepares Find(), from the mappers' present data.
  void Resolve(vtkRenderer* renderer, const vtkRelievoFrameCamera& view);

  // After Resolve(): all meshes and point sets that were drawn, with their actors.
  std::vector<Hit> GetMeshes() const;

  // A range of words, from First to the next range's, that belongs to the part Part, an actor's
  // block; -1 for glyphs, each of which is its own part.
  struct PartStart
  {
    std::uint32_t First;
    int Part;
  };
  std::vector<PartStart> GetParts() const;

  // The meaning of the word; an empty Hit if it has none. Thread-safe.
  Hit Find(std::uint32_t word) const;

private:
  struct Range
  {
    vtkRelievoCellMap::Offsets Offsets;
    int Block;
    // Holds a reference: the layers may be read after the scene has released the mesh.
    vtkSmartPointer<vtkPolyData> Mesh;
    std::shared_ptr<const vtkRelievoCellMap> Map;
    vtkMTimeType Time; // of Mesh, at the time of drawing
    bool Changed = false;
  };
  struct Draw
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkInformation* Keys; // shared by an LOD actor's device and the actor in the renderer
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    int PrimitiveSource;
    int LastPrimitiveType; // of this draw's primitives
    int Representation;
    std::uint32_t First;
    std::uint32_t Count;
    glm::dmat4 ModelToWorld; // at the time of drawing: an assembly changes its parts' matrices
    vtkMTimeType Time;       // of its data, at the time of drawing
    int ActorIndex;
    vtkActor* Prop;
    glm::dmat4 ViewToModel;
    glm::dmat4 ModelToView;
    bool Deformed;
    bool Moved;
    bool Ambiguous;            // several blocks number their primitives alike
    std::vector<Range> Ranges; // ordered by their first primitive
    int Block;                 // of Points
    vtkSmartPointer<vtkDataSet> Points;
    std::vector<vtkIdType> Ids; // of Points, by the glyph's instance
  };

  void AddRanges(Draw& draw, vtkOpenGLPolyDataMapper* mapper);
  // Sets the start of the count of the kind that the mapper draws now.
  static void SetOffset(Draw& draw, vtkOpenGLPolyDataMapper* mapper, int type);
  static vtkMTimeType GetTime(const Draw& draw);
  void ResolveGlyphs();

  std::vector<Draw> Draws;
  vtkRelievoCellMaps Maps;
};

#endif
