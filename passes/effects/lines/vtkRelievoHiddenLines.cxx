// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoHiddenLines.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRelievoDashes.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
using Settings = vtkRelievoHiddenLines::Settings;
using Piece = vtkRelievoDashes::Piece;

// The pieces of one mesh at one place.
class Finder
{
public:
  Finder(const vtkRelievoFrameCamera& view, const Settings& settings, const glm::dmat4& toWorld)
    : View(view)
    , Wanted(settings)
    , ToView(view.WorldToView * toWorld)
    , NormalsToView(glm::transpose(glm::inverse(glm::dmat3(this->ToView))))
    , Eye(glm::inverse(this->ToView) *
        (view.Parallel ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0)))
  {
  }

  std::vector<Piece> Find(const vtkRelievoFeatureEdges& edges) const
  {
    std::vector<Piece> pieces;
    for (const vtkRelievoFeatureEdges::Edge& edge : edges.GetEdges())
    {
      const glm::dvec3& a = edges.GetPoints()[edge.Points[0]];
      const glm::dvec3& b = edges.GetPoints()[edge.Points[1]];
      const bool ends = edge.Faces[0] == edge.Faces[1];
      const glm::dvec3& first = edges.GetNormals()[edge.Faces[0]];
      const glm::dvec3 second = (edge.Flipped ? -1.0 : 1.0) * edges.GetNormals()[edge.Faces[1]];
      const bool crease = this->Wanted.Creases && !ends && this->IsCrease(first, second);
      if (crease || (this->Wanted.Silhouettes && (ends || this->IsSilhouette(a, first, second))))
      {
        Piece piece = { { edge.Points[0], edge.Points[1] }, {}, {}, !crease && !ends };
        if (this->Project(a, b, piece))
        {
          pieces.push_back(piece);
        }
      }
    }
    return pieces;
  }

private:
  bool IsCrease(const glm::dvec3& first, const glm::dvec3& second) const
  {
    return glm::dot(glm::normalize(this->NormalsToView * first),
             glm::normalize(this->NormalsToView * second)) < this->Wanted.CreaseCosine;
  }

  bool IsSilhouette(
    const glm::dvec3& point, const glm::dvec3& first, const glm::dvec3& second) const
  {
    const glm::dvec3 toEye = glm::dvec3(this->Eye) - this->Eye.w * point;
    return (glm::dot(first, toEye) > 0.0) != (glm::dot(second, toEye) > 0.0);
  }

  // Projects the edge's part between the clipping planes. False if there is none.
  bool Project(const glm::dvec3& a, const glm::dvec3& b, Piece& piece) const
  {
    glm::dvec4 ends[2] = { this->ToView * glm::dvec4(a, 1.0), this->ToView * glm::dvec4(b, 1.0) };
    double from = 0.0;
    double to = 1.0;
    const double step = ends[0].z - ends[1].z; // of depth
    for (const double side : { 1.0, -1.0 })
    {
      const double inside =
        side * (-ends[0].z - (side > 0.0 ? this->View.Near : this->View.Far)); // at the first end
      if (inside + side * from * step < 0.0 && inside + side * to * step < 0.0)
      {
        return false;
      }
      from = inside + side * from * step < 0.0 ? -inside / (side * step) : from;
      to = inside + side * to * step < 0.0 ? -inside / (side * step) : to;
    }
    const glm::dvec4 way = ends[1] - ends[0];
    ends[1] = to < 1.0 ? ends[0] + to * way : ends[1];
    ends[0] = from > 0.0 ? ends[0] + from * way : ends[0];
    for (int i = 0; i < 2; ++i)
    {
      const glm::dvec4 clip = this->View.ViewToNDC * ends[i];
      const glm::dvec2 size(this->View.Viewport[2], this->View.Viewport[3]);
      piece.Ends[i] = 0.5 * size * (glm::dvec2(clip) / clip.w + 1.0);
      piece.Nearness[i] = this->View.Parallel ? ends[i].z : -1.0 / ends[i].z;
    }
    return true;
  }

  const vtkRelievoFrameCamera& View;
  const Settings& Wanted;
  glm::dmat4 ToView;
  glm::dmat3 NormalsToView;
  glm::dvec4 Eye; // in the mesh's coordinates; a direction in parallel projection
};
}

//------------------------------------------------------------------------------
vtkRelievoHiddenLines::vtkRelievoHiddenLines() = default;

//------------------------------------------------------------------------------
vtkRelievoHiddenLines::~vtkRelievoHiddenLines() = default;

//------------------------------------------------------------------------------
std::vector<float> vtkRelievoHiddenLines::FindPieces(
  const vtkRelievoFrameContext& context, const Settings& settings)
{
  const std::vector<vtkRelievoPlacedMesh> meshes = this->Meshes.Find(context.Renderer);
  std::map<vtkPolyData*, Held> before = std::move(this->Edges);
  this->Edges.clear();
  std::vector<float> texels;
  vtkRelievoDashes dashes;
  const glm::dvec2 size(context.View.Viewport[2], context.View.Viewport[3]);
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    Held& held = this->Edges[mesh.Mesh];
    if (held.Mesh != mesh.Mesh)
    {
      Held& old = before[mesh.Mesh];
      held = old.Mesh == mesh.Mesh ? std::move(old) : Held();
      held.Mesh = mesh.Mesh;
      held.Edges.Update(mesh.Mesh);
    }
    for (std::size_t i = 0; i < mesh.GetNumberOfPlaces(); ++i)
    {
      const Finder finder(context.View, settings, mesh.GetPlace(i));
      dashes.Append(finder.Find(held.Edges),
        static_cast<std::uint32_t>(held.Edges.GetPoints().size()), settings.Dash, size, texels);
    }
  }
  return texels;
}

//------------------------------------------------------------------------------
std::string vtkRelievoHiddenLines::Draw(
  vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target, const Settings& settings)
{
  vtkRelievoResource* depth = context.Find(vtkRelievoResources::Depth);
  if (!depth)
  {
    return "the frame has no layer 'depth'";
  }
  const std::vector<float> texels = this->FindPieces(context, settings);
  if (texels.empty())
  {
    return {};
  }
  const std::string error = this->Pieces.Upload(context.Window, texels, 4);
  if (!error.empty())
  {
    return error;
  }
  vtkShaderProgram* program =
    this->Quads.Ready(context, "lines/hiddenVS.glsl", "lines/hiddenFS.glsl", depth->GetDefines());
  if (!program)
  {
    return this->Quads.GetError();
  }
  program->SetUniformf("linesHalfWidth", static_cast<float>(settings.HalfWidth));
  program->SetUniformf("linesDashShare", static_cast<float>(vtkRelievoDashes::Share));
  target.GoOn(context);
  depth->Activate(program);
  this->Pieces.Activate(program, "linesPieces");
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MAX);
  this->Quads.Draw(static_cast<int>(texels.size() / 8));
  state->vtkglBlendEquation(GL_FUNC_ADD);
  this->Pieces.Deactivate();
  depth->Deactivate();
  target.End();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoHiddenLines::Release(vtkWindow* window)
{
  this->Quads.Release(window);
  this->Pieces.Release(window);
  this->Edges.clear();
  this->Meshes = vtkRelievoOpaqueMeshes();
}
