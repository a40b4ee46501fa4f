// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of meshes in a texture buffer, for the rays of shaders/rays/walk.glsl: a tree over
// the casters, which are placed meshes, and one tree over the triangles of each mesh, however often
// it is placed.
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

  // Uploads the casters, in coordinates about an origin. Returns an error message, or an empty
  // string.
  std::string Update(vtkOpenGLRenderWindow* window,
    const std::vector<vtkRelievoPlacedMesh>& casters, const glm::dvec3& origin);

  // Whether the buffer is in the window, with this origin.
  bool IsIn(vtkOpenGLRenderWindow* window, const glm::dvec3& origin) const
  {
    return this->Buffer.IsIn(window) && this->Origin == origin;
  }

  bool Bind(); // false if there is no texture unit left
  void Unbind() { this->Buffer.Deactivate(); }
  int GetTextureUnit() const { return this->Buffer.GetTextureUnit(); }

  // Changes with the buffer's content.
  double GetVersion() const { return this->Version; }

  // Whether the last update only moved some casters; GetMoved() then has their boxes before and
  // after, in the tree's coordinates, at most MostMoved.
  static constexpr std::size_t MostMoved = 8;
  bool HasOnlyMoved() const { return this->OnlyMoved; }
  const std::vector<vtkRelievoBoxTree::Box>& GetMoved() const { return this->Moved; }

  // Whether a caster transmits part of the light.
  bool HasTranslucent() const;
  bool HasColors() const; // and colours it

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  int GetNumberOfNodes() const { return this->Nodes; } // over the casters
  int GetFirstRecord() const { return 2 * this->Nodes; }
  vtkIdType GetNumberOfTriangles() const;
  int GetNumberOfCasters() const { return static_cast<int>(this->Casters.size()); }
  vtkIdType GetNumberOfGlyphs() const; // of all casters

  // In the last update: meshes whose trees were built, and meshes whose trees were refitted to
  // moved points.
  int GetMeshesBuilt() const { return this->MeshesBuilt; }
  int GetMeshesRefitted() const { return this->MeshesRefitted; }

  vtkIdType GetBytes() const { return this->Buffer.GetBytes(); }
  void Release(vtkWindow* window);

private:
  static constexpr std::size_t Grain = 16; // alignment of meshes in texels
  static constexpr int RecordTexels = 5;
  static std::size_t RoundUp(std::size_t texels) { return (texels + Grain - 1) / Grain * Grain; }

  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    vtkRelievoMeshTexels Mesh;
    std::size_t Texel = 0;
  };
  std::string TryUpdate(vtkOpenGLRenderWindow* window,
    const std::vector<vtkRelievoPlacedMesh>& casters, const glm::dvec3& origin);
  bool UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& casters);
  std::size_t CountRecords() const;
  bool FindMoved(const std::vector<vtkRelievoPlacedMesh>& castersBefore,
    const std::vector<vtkRelievoBoxTree::Box>& boxesBefore);
  // Makes the nodes and records of the casters.
  std::vector<glm::vec4> MakeFront();
  std::string FindFault(std::size_t records) const;
  std::string Upload(bool all, const std::vector<glm::vec4>& front);
  void ReleaseBuffer(vtkWindow* window);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::map<vtkPolyData*, std::unique_ptr<Held>> Meshes;
  std::vector<vtkRelievoPlacedMesh> Casters;
  std::vector<vtkRelievoBoxTree::Box> Boxes; // of Casters, over all their places
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
