// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a process tells others of what rays meet in it, as bytes: meshes as their triangles, once
// and again when they change; and, if anything has changed, the list of where they stand.
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

// What a process has of a scene.
struct vtkRelievoMeshPart
{
  std::vector<vtkRelievoPlacedMesh> Meshes; // that are followed
  std::vector<vtkRelievoBox> Receivers;     // of shadows
  std::vector<vtkRelievoBox> InMaps;        // what casts and cannot be followed
};

class vtkRelievoMeshSender
{
public:
  // Whether it is not what was written last, or has changed since.
  bool IsNews(const vtkRelievoMeshPart& part) const;

  // What the readers do not know of it; nothing if they know all of it. Cells that are copies of
  // another process's count there: the part's meshes become those without them.
  vtkRelievoBytes Write(vtkRelievoMeshPart& part);

  // What is in the last part in the place of a mesh: its cells that are no copies.
  vtkPolyData* GetOwn(vtkPolyData* mesh) const;

  // The readers know nothing any more.
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
  // How many meshes it wrote: 0 or 1.
  int WriteMesh(Sent& sent, vtkPolyData* mesh, vtkRelievoBytes& bytes);

  vtkRelievoMeshPart Last;
  bool Written = false;
  std::map<vtkPolyData*, Sent> Meshes;
  std::map<const void*, int> Places; // of Last, which keeps them
  int NextId = 0;
};

class vtkRelievoMeshReceiver
{
public:
  // Nothing: nothing has changed.
  void Read(const vtkRelievoBytes& bytes);

  const vtkRelievoMeshPart& GetPart() const { return this->Part; }
  vtkIdType GetNumberOfTriangles() const;

private:
  vtkRelievoMeshPart Part;
  std::map<int, vtkSmartPointer<vtkPolyData>> Meshes;
  std::map<int, std::shared_ptr<const std::vector<glm::dmat4>>> Places;
};

#endif
