// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a process tells others of its casters, as bytes: meshes as the triangles that cast, once and
// again when they change; and, if anything has changed, the list of who casts with them.
#ifndef vtkRelievoCasterMessage_h
#define vtkRelievoCasterMessage_h

#include "vtkRelievoShadowRegion.h"
#include "vtkRelievoTreeBuffer.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkPolyData;

using vtkRelievoBytes = std::vector<unsigned char>;

// What a process has of a scene.
struct vtkRelievoCasterPart
{
  std::vector<vtkRelievoPlacedMesh> Casters; // that are followed
  std::vector<vtkRelievoBox> Receivers;
  std::vector<vtkRelievoBox> InMaps; // casters that cannot be followed
};

class vtkRelievoCasterSender
{
public:
  // Whether it is not what was written last, or has changed since.
  bool IsNews(const vtkRelievoCasterPart& part) const;

  // What the readers do not know of it; nothing if that is all of it. Cells that are copies of
  // another process's cast there: the part's meshes become those without them.
  vtkRelievoBytes Write(vtkRelievoCasterPart& part);

  // The mesh that casts in place of one of the last part's; the same without copied cells.
  vtkPolyData* GetCasting(vtkPolyData* mesh) const;

  // The readers know nothing any more.
  void Clear() { *this = vtkRelievoCasterSender(); }

private:
  struct Sent
  {
    vtkWeakPointer<vtkPolyData> Data;
    std::vector<vtkMTimeType> Times;
    vtkSmartPointer<vtkPolyData> Casting;
    std::vector<int> Triangles;
    int Id = 0;
  };
  bool IsSame(const vtkRelievoPlacedMesh& now, const vtkRelievoPlacedMesh& before) const;
  void WritePart(const vtkRelievoCasterPart& part, vtkRelievoBytes& bytes);
  // How many meshes it wrote: 0 or 1.
  int WriteMesh(Sent& sent, vtkPolyData* mesh, vtkRelievoBytes& bytes);

  vtkRelievoCasterPart Last;
  bool Written = false;
  std::map<vtkPolyData*, Sent> Meshes;
  std::map<const void*, int> Places; // of Last, which keeps them
  int NextId = 0;
};

class vtkRelievoCasterReceiver
{
public:
  // Nothing: nothing has changed.
  void Read(const vtkRelievoBytes& bytes);

  const vtkRelievoCasterPart& GetPart() const { return this->Part; }
  vtkIdType GetNumberOfTriangles() const;

private:
  vtkRelievoCasterPart Part;
  std::map<int, vtkSmartPointer<vtkPolyData>> Meshes;
  std::map<int, std::shared_ptr<const std::vector<glm::mat4>>> Places;
};

#endif
