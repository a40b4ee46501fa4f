// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The casters' triangles in a texture buffer, for the rays of shaders/shadow/exact.glsl: a tree
// over the casters, and for each mesh, once however often it casts, a tree over its triangles.
#ifndef vtkRelievoShadowTree_h
#define vtkRelievoShadowTree_h

#include "vtkRelievoCasterMesh.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkWindow;

// A mesh at a place of the world.
struct vtkRelievoCaster
{
  vtkPolyData* Mesh = nullptr;
  glm::dmat4 MeshToWorld{ 1.0 };
  double Passes = 0.0;     // of the light: 1 - opacity
  bool CullsFront = false; // to the eye; it casts from both sides
  bool CullsBack = false;
};

class vtkRelievoShadowTree
{
public:
  vtkRelievoShadowTree() = default;
  ~vtkRelievoShadowTree();
  vtkRelievoShadowTree(const vtkRelievoShadowTree&) = delete;
  void operator=(const vtkRelievoShadowTree&) = delete;

  // Brings the casters into the buffer, in coordinates about an origin. Returns why not, in words.
  std::string Update(vtkOpenGLRenderWindow* window, const std::vector<vtkRelievoCaster>& casters,
    const glm::dvec3& origin);

  bool Bind(); // false if there is no texture unit left
  void Unbind();
  int GetTextureUnit() const { return this->Unit; }

  // Another number for each content of the buffer.
  double GetVersion() const { return this->Version; }

  // Whether a caster lets part of the light pass.
  bool HasTranslucent() const;

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  int GetNumberOfNodes() const { return this->Nodes; } // over the casters
  int GetFirstRecord() const { return 2 * this->Nodes; }
  vtkIdType GetNumberOfTriangles() const;
  int GetNumberOfCasters() const { return static_cast<int>(this->Casters.size()); }

  // In the last update: meshes whose trees were built, and those that were fitted to moved points.
  int GetMeshesBuilt() const { return this->MeshesBuilt; }
  int GetMeshesRefitted() const { return this->MeshesRefitted; }

  vtkIdType GetBytes() const { return this->Bytes; }
  void Release(vtkWindow* window);

private:
  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    vtkRelievoCasterMesh Mesh;
    std::size_t Texel = 0;
  };
  bool UpdateMeshes(const std::vector<vtkRelievoCaster>& casters);
  std::vector<glm::vec4> MakeRecords();
  std::string Upload(bool all);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::map<vtkPolyData*, std::unique_ptr<Held>> Meshes;
  std::vector<vtkRelievoCaster> Casters;
  std::vector<glm::vec4> Front; // nodes and records of the casters
  glm::dvec3 Origin{ 0.0 };
  int Nodes = 0;
  double Version = 0.0;
  int MeshesBuilt = 0;
  int MeshesRefitted = 0;
  std::size_t Texels = 0;
  vtkIdType Bytes = 0;
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  int Unit = -1;
};

#endif
