// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws glyphs of vtkGlyph3DMapper from buffers of its own, at the places that VTK's shaders have,
// bit for bit: VTK does not give out its mapper's buffers.
#ifndef vtkRelievoSeenGlyphs_h
#define vtkRelievoSeenGlyphs_h

#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoTextureBuffer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoSeenGlyphs
{
public:
  // Uploads changed glyphs, and reserves a texture unit until Draw. False, and there are none,
  // without a unit, or without memory for all.
  bool Update(vtkOpenGLRenderWindow* window, const std::vector<vtkRelievoPlacedMesh>& glyphs);

  // Appends numbers that change with the drawn glyphs.
  void AddState(std::vector<double>& state) const;

  bool IsEmpty() const { return this->Groups.empty(); }

  // Draws with a program that has vertexMC, MCDCMatrix, MCVCMatrix and relievoGlyphs, and counts
  // draw calls. False without a texture unit.
  bool Draw(vtkShaderProgram* program, const glm::dmat4& worldToNDC, const glm::dmat4& worldToView,
    int& calls);

  void Unbind();
  vtkIdType GetBytes() const;

  // Deletes the buffers in the window's current context; without a window they are gone already.
  void Release(vtkWindow* window);

private:
  struct Content
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    std::shared_ptr<const std::vector<glm::dmat4>> Places; // held: no others get their address

    bool IsOf(const vtkRelievoPlacedMesh& glyph) const;
  };
  struct Group : Content
  {
    glm::dmat4 ToWorld{ 1.0 };
    double Version = 0.0; // of the buffers
    int Corners = 0;
    int Points = 0;
    unsigned int Buffers[2] = {}; // of points and corners
    vtkRelievoTextureBuffer Matrices;
  };
  static Content GetContent(const vtkRelievoPlacedMesh& glyph);
  static bool Fill(Group& group, vtkOpenGLRenderWindow* window);
  static void Release(Group& group, vtkWindow* window);

  std::vector<std::unique_ptr<Group>> Groups;
  double Version = 0.0;         // of the last buffers
  std::vector<Content> Refused; // the last glyphs, if there was no memory for them
};

#endif
