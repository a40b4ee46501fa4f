// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of meshes in a texture buffer, for the rays of shaders/rays/walk.glsl: a tree over
// the casters, which are meshes at their places, and for each mesh, once however often it casts, a
// tree over its triangles.
#ifndef vtkRelievoTreeBuffer_h
#define vtkRelievoTreeBuffer_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoTextureBuffer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoTreeBuffer
{
public:
  vtkRelievoTreeBuffer() = default;
  ~vtkRelievoTreeBuffer();
  vtkRelievoTreeBuffer(const vtkRelievoTreeBuffer&) = delete;
  void operator=(const vtkRelievoTreeBuffer&) = delete;

  // Brings the casters into the buffer, in coordinates about an origin. Returns why not, in words.
  std::string Update(vtkOpenGLRenderWindow* window,
    const std::vector<vtkRelievoPlacedMesh>& casters, const glm::dvec3& origin);

  // Whether it is in a window, about that origin.
  bool IsIn(vtkOpenGLRenderWindow* window, const glm::dvec3& origin) const
  {
    return this->Buffer.IsIn(window) && this->Origin == origin;
  }

  bool Bind(); // false if there is no texture unit left
  void Unbind() { this->Buffer.Deactivate(); }
  int GetTextureUnit() const { return this->Buffer.GetTextureUnit(); }

  // Another number for each content of the buffer.
  double GetVersion() const { return this->Version; }

  // Whether the last content differs from the one before in the places of some casters alone; then
  // the boxes of where they were and are, in the tree's coordinates, a few.
  static constexpr std::size_t MostMoved = 8;
  bool HasOnlyMoved() const { return this->OnlyMoved; }
  const std::vector<vtkRelievoBoxTree::Box>& GetMoved() const { return this->Moved; }

  // Whether a caster lets part of the light pass.
  bool HasTranslucent() const;
  bool HasColors() const; // and colours it

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  int GetNumberOfNodes() const { return this->Nodes; } // over the casters
  int GetFirstRecord() const { return 2 * this->Nodes; }
  vtkIdType GetNumberOfTriangles() const;
  int GetNumberOfCasters() const { return static_cast<int>(this->Casters.size()); }
  vtkIdType GetNumberOfGlyphs() const; // of all of the casters

  // In the last update: meshes whose trees were built, and those that were fitted to moved points.
  int GetMeshesBuilt() const { return this->MeshesBuilt; }
  int GetMeshesRefitted() const { return this->MeshesRefitted; }

  vtkIdType GetBytes() const { return this->Buffer.GetBytes(); }
  void Release(vtkWindow* window);

private:
  static constexpr std::size_t Grain = 16; // texels: where meshes begin
  static constexpr int RecordTexels = 5;
  static std::size_t RoundUp(std::size_t texels) { return (texels + Grain - 1) / Grain * Grain; }

  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    vtkRelievoMeshTexels Mesh;
    std::size_t Texel = 0;
  };
  bool UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& casters);
  std::size_t CountRecords() const;
  bool FindMoved(const std::vector<vtkRelievoPlacedMesh>& castersBefore,
    const std::vector<vtkRelievoBoxTree::Box>& boxesBefore);
  // Nodes and records of the casters.
  std::vector<glm::vec4> MakeFront();
  std::string FindFault(std::size_t records) const;
  std::string Upload(bool all, const std::vector<glm::vec4>& front);
  void ReleaseBuffer(vtkWindow* window);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::map<vtkPolyData*, std::unique_ptr<Held>> Meshes;
  std::vector<vtkRelievoPlacedMesh> Casters;
  std::vector<vtkRelievoBoxTree::Box> Boxes; // of Casters at all of their places
  std::vector<vtkRelievoBoxTree::Box> Moved;
  bool OnlyMoved = false;
  glm::dvec3 Origin{ 0.0 };
  int Nodes = 0;
  double Version = 0.0;
  int MeshesBuilt = 0;
  int MeshesRefitted = 0;
  std::size_t Texels = 0;
  vtkRelievoTextureBuffer Buffer;
};

#endif
