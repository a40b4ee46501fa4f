// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Leaves out an actor's triangles that touch no pixel marked by vtkRelievoSampleMarks, which saves
// software OpenGL most of its work where few pixels are marked. The drawing is identical in the
// marked pixels, bit for bit: triangles that rounding may move into them are drawn.
#ifndef vtkRelievoMarkedTriangles_h
#define vtkRelievoMarkedTriangles_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <vector>

class vtkActor;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkRelievoFrameContext;
class vtkRelievoSampleMarks;

class vtkRelievoMarkedTriangles
{
public:
  // The actor must have been drawn in the present frame.
  explicit vtkRelievoMarkedTriangles(vtkActor* actor);
  ~vtkRelievoMarkedTriangles();
  vtkRelievoMarkedTriangles(const vtkRelievoMarkedTriangles&) = delete;
  vtkRelievoMarkedTriangles& operator=(const vtkRelievoMarkedTriangles&) = delete;

  // Whether triangles can be left out: VTK's own code draws nothing else, from existing buffers.
  bool IsPossible() const { return this->Mapper != nullptr; }

  // Finds the triangles that touch marked pixels of each part of the viewport (x, y, width, height
  // in pixels).
  void Find(const vtkRelievoFrameContext& context, const vtkRelievoSampleMarks& marks,
    const std::vector<std::array<int, 4>>& parts);

  ///@{
  // Until End(), drawing the actor leaves out its other triangles, for one of the parts. Begin()
  // returns false if no triangle is left.
  bool Begin(std::size_t part);
  void End();
  ///@}

private:
  void Project(const vtkRelievoFrameContext& context);

  vtkActor* Actor;
  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper;
  std::vector<glm::vec2> Places; // of the vertices, in pixels of the viewport; NaN: anywhere
  float Around = 0.0f;           // error of the places
  std::vector<std::vector<unsigned int>> Touching; // vertices of triangles, for each part
  vtkOpenGLIndexBufferObject* All = nullptr;
  vtkNew<vtkOpenGLIndexBufferObject> Used;
};

#endif
