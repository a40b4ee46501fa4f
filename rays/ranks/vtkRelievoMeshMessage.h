// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Messages about a process's traced meshes, as bytes: the meshes' triangles, once and after each
// change; and after any change the list of their placements.
#ifndef vtkRelievoMeshMessage_h
#define vtkRelievoMeshMessage_h

#include "vtkRelievoBox.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkPolyData;

using vtkRelievoBytes = std::vector<unsigned char>;

// A process's part of the scene.
struct vtkRelievoMeshPart
{
  std::vector<vtkRelievoPlacedMesh> Meshes; // traced meshes
  std::vector<vtkRelievoBox> Receivers;     // of shadows
  std::vector<vtkRelievoBox> InMaps;        // casters that cannot be traced
};

class vtkRelievoMeshSender
{
public:
  // Whether the part differs from the last written one, or has changed since.
  bool IsNews(const vtkRelievoMeshPart& part) const;

  // The changes that the readers lack; empty if there are none. Copies of another process's cells
  // are that process's: the part's meshes become meshes without them.
  vtkRelievoBytes Write(vtkRelievoMeshPart& part);

  // The replacement of a mesh in the last part: its cells without copies.
  vtkPolyData* GetOwn(vtkPolyData* mesh) const;

  // Restarts: the readers have lost all data.
  void Clear() { *this = vtkRelievoMeshSender(); }

private:
  struct Sent
  {
    vtkWeakPointer<vtkPolyData> Data;
    std::vector<vtkMTimeType> Times;
    vtkSmartPointer<vtkPolyData> Own;
    std::vector<int> Triangles;
    int Id = 0;
  };
  bool IsSame(const vtkRelievoPlacedMesh& now, const vtkRelievoPlacedMesh& before) const;
  void WritePart(const vtkRelievoMeshPart& part, vtkRelievoBytes& bytes);
  // Returns the number of written meshes: 0 or 1.
  int WriteMesh(Sent& sent, vtkPolyData* mesh, vtkRelievoBytes& bytes);

  vtkRelievoMeshPart Last;
  bool Written = false;
  std::map<vtkPolyData*, Sent> Meshes;
  std::map<const void*, int> Places; // of Last, which holds references
  int NextId = 0;
};

class vtkRelievoMeshReceiver
{
public:
  // Reads a message; an empty one means no changes.
  void Read(const vtkRelievoBytes& bytes);

  const vtkRelievoMeshPart& GetPart() const { return this->Part; }
  vtkIdType GetNumberOfTriangles() const;

private:
  vtkRelievoMeshPart Part;
  std::map<int, vtkSmartPointer<vtkPolyData>> Meshes;
  std::map<int, std::shared_ptr<const std::vector<glm::dmat4>>> Places;
};

#endif
