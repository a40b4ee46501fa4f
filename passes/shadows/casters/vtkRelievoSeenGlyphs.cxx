// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSeenGlyphs.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <new>

//------------------------------------------------------------------------------
bool vtkRelievoSeenGlyphs::Content::IsOf(const vtkRelievoPlacedMesh& glyph) const
{
  return this->Mesh == glyph.Mesh && this->Time == glyph.Mesh->GetMTime() &&
    this->Places == glyph.Places;
}

//------------------------------------------------------------------------------
vtkRelievoSeenGlyphs::Content vtkRelievoSeenGlyphs::GetContent(const vtkRelievoPlacedMesh& glyph)
{
  Content content;
  content.Mesh = glyph.Mesh;
  content.Time = glyph.Mesh->GetMTime();
  content.Places = glyph.Places;
  return content;
}

//------------------------------------------------------------------------------
bool vtkRelievoSeenGlyphs::Update(
  vtkOpenGLRenderWindow* window, const std::vector<vtkRelievoPlacedMesh>& glyphs)
{
  if (!glyphs.empty() &&
    std::equal(this->Refused.begin(), this->Refused.end(), glyphs.begin(), glyphs.end(),
      [](const Content& content, const auto& glyph) { return content.IsOf(glyph); }))
  {
    return false;
  }
  this->Refused.clear();
  std::vector<std::unique_ptr<Group>> before = std::move(this->Groups);
  this->Groups.clear();
  bool fits = true;
  for (const vtkRelievoPlacedMesh& glyph : glyphs)
  {
    const auto same = std::find_if(
      before.begin(), before.end(), [&](const auto& group) { return group && group->IsOf(glyph); });
    std::unique_ptr<Group> group =
      same == before.end() ? std::make_unique<Group>() : std::move(*same);
    group->ToWorld = glyph.MeshToWorld;
    if (same == before.end())
    {
      static_cast<Content&>(*group) = GetContent(glyph);
      group->Version = ++this->Version;
      fits = fits && Fill(*group, window);
    }
    this->Groups.push_back(std::move(group));
  }
  for (const auto& gone : before)
  {
    if (gone)
    {
      Release(*gone, window);
    }
  }
  if (!fits)
  {
    this->Release(window);
    for (const vtkRelievoPlacedMesh& glyph : glyphs)
    {
      this->Refused.push_back(GetContent(glyph));
    }
    return false;
  }
  if (!this->Groups.empty())
  {
    this->Groups.front()->Matrices.Activate();
    if (this->Groups.front()->Matrices.GetTextureUnit() < 0)
    {
      this->Release(window);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// False without memory.
bool vtkRelievoSeenGlyphs::Fill(Group& group, vtkOpenGLRenderWindow* window)
try
{
  std::vector<float> points;
  vtkPolyData* mesh = group.Mesh;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points.insert(points.end(),
      { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) });
  }
  std::vector<unsigned int> corners;
  vtkRelievoPolygonCut::ForEachTriangle(
    mesh, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
      corners.insert(corners.end(),
        { static_cast<unsigned int>(a), static_cast<unsigned int>(b),
          static_cast<unsigned int>(c) });
    });
  std::vector<float> matrices;
  matrices.reserve(16 * group.Places->size());
  for (const glm::dmat4& place : *group.Places)
  {
    const glm::mat4 matrix(place);
    matrices.insert(matrices.end(), &matrix[0][0], &matrix[0][0] + 16);
  }
  group.Points = static_cast<int>(points.size() / 3);
  group.Corners = static_cast<int>(corners.size());
  if (!group.Matrices.Upload(window, matrices, 4).empty())
  {
    return false;
  }
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Discards earlier errors, so that later ones are this code's.
  }
  glGenBuffers(2, group.Buffers);
  glBindBuffer(GL_COPY_WRITE_BUFFER, group.Buffers[0]);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(float)),
    points.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_COPY_WRITE_BUFFER, group.Buffers[1]);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(unsigned int)),
    corners.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  return glGetError() == GL_NO_ERROR;
}
catch (const std::bad_alloc&)
{
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoSeenGlyphs::AddState(std::vector<double>& state) const
{
  for (const auto& group : this->Groups)
  {
    state.push_back(group->Version);
    state.insert(state.end(), &group->ToWorld[0][0], &group->ToWorld[0][0] + 16);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoSeenGlyphs::Draw(vtkShaderProgram* program, const glm::dmat4& worldToNDC,
  const glm::dmat4& worldToView, int& calls)
{
  this->Unbind(); // each group takes the reserved unit
  const auto attribute =
    static_cast<GLuint>(glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), "vertexMC"));
  for (const auto& group : this->Groups)
  {
    if (group->Corners == 0)
    {
      continue;
    }
    const glm::mat4 toNDC(worldToNDC * group->ToWorld);
    const glm::mat4 toView(worldToView * group->ToWorld);
    program->SetUniformMatrix4x4("MCDCMatrix", const_cast<float*>(&toNDC[0][0]));
    program->SetUniformMatrix4x4("MCVCMatrix", const_cast<float*>(&toView[0][0]));
    group->Matrices.Activate(program, "relievoGlyphs");
    const bool bound = group->Matrices.GetTextureUnit() >= 0;
    if (bound)
    {
      glBindBuffer(GL_ARRAY_BUFFER, group->Buffers[0]);
      glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), nullptr);
      glBindBuffer(GL_ARRAY_BUFFER, 0);
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, group->Buffers[1]);
      glDrawElementsInstanced(GL_TRIANGLES, group->Corners, GL_UNSIGNED_INT, nullptr,
        static_cast<GLsizei>(group->Places->size()));
      ++calls;
    }
    group->Matrices.Deactivate();
    if (!bound)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoSeenGlyphs::Unbind()
{
  for (const auto& group : this->Groups)
  {
    group->Matrices.Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoSeenGlyphs::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& group : this->Groups)
  {
    bytes += group->Matrices.GetBytes() + 12 * static_cast<vtkIdType>(group->Points) +
      4 * static_cast<vtkIdType>(group->Corners);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoSeenGlyphs::Release(Group& group, vtkWindow* window)
{
  group.Matrices.Release(window);
  if (window && group.Buffers[0])
  {
    glDeleteBuffers(2, group.Buffers);
  }
  std::fill_n(group.Buffers, 2, 0);
}

//------------------------------------------------------------------------------
void vtkRelievoSeenGlyphs::Release(vtkWindow* window)
{
  for (const auto& group : this->Groups)
  {
    Release(*group, window);
  }
  this->Groups.clear();
  this->Refused.clear();
}
