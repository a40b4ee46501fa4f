// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSurfaces.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoMovedMesh.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include "codes.glsl"

#include <algorithm>
#include <functional>
#include <vector>

using namespace vtkRelievoSpliceText;

namespace
{
const char* const PointsOrLines = "draws points or lines";

// A section of shaders/gbuffer/lights.glsl without its line ends.
std::string Section(const char* name)
{
  const std::string text = vtkRelievoShaderLibrary::GetSection("gbuffer/lights.glsl", name);
  return text.substr(0, text.find_last_not_of("\n") + 1);
}

using Work = std::function<void(vtkActor*, vtkMatrix4x4*)>;

void ForEachMesh(const vtkRelievoFrameScene& scene, const Work& work)
{
  for (const vtkRelievoFrameProp& prop : scene.Props)
  {
    for (const vtkRelievoPropParts::Part& part : prop.Parts)
    {
      vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
      if (actor)
      {
        work(actor, part.Matrix ? part.Matrix : actor->GetMatrix());
      }
    }
  }
}

void ForEachLit(const vtkRelievoFrameScene& scene, const Work& work)
{
  ForEachMesh(scene, [&work](vtkActor* actor, vtkMatrix4x4* matrix) {
    if (actor->GetProperty()->GetLighting())
    {
      work(actor, matrix);
    }
  });
}

// Data other than polydata may have cells of any kind.
bool HasLines(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (HasLines(leaf->GetCurrentDataObject()))
      {
        return true;
      }
    }
    return false;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return data && (!mesh || mesh->GetNumberOfLines() > 0);
}

bool DrawsLines(vtkActor* actor)
{
  return actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME ||
    HasLines(actor->GetMapper()->GetInputDataObject(0, 0));
}

bool Shines(vtkProperty* property)
{
  const double* color = property->GetSpecularColor();
  return property->GetSpecular() > 0.0 && (color[0] > 0.0 || color[1] > 0.0 || color[2] > 0.0);
}

std::string WhyLitPbr(vtkProperty* property, vtkRenderer* renderer)
{
  if (renderer->GetUseImageBasedLighting())
  {
    return "is lit by an environment";
  }
  if (property->GetCoatStrength() > 0.0 || property->GetAnisotropy() != 0.0)
  {
    return "has a clear coat or anisotropy";
  }
  const double* tint = property->GetEdgeTint();
  if (property->GetBaseIOR() != 1.5 || tint[0] != 1.0 || tint[1] != 1.0 || tint[2] != 1.0)
  {
    return "has an index of refraction other than 1.5, or an edge tint";
  }
  for (const auto& texture : property->GetAllTextures())
  {
    if (texture.first != "albedoTex" && texture.first != "normalTex")
    {
      return "has the texture " + texture.first;
    }
  }
  return std::string();
}

void SetHighlight(vtkProperty* property, float highlight[4])
{
  const double* color = property->GetSpecularColor();
  for (int i = 0; i < 3; ++i)
  {
    highlight[i] = static_cast<float>(property->GetSpecular() * color[i]);
  }
  highlight[3] = static_cast<float>(property->GetSpecularPower());
}
}

//------------------------------------------------------------------------------
vtkRelievoSurfaces vtkRelievoSurfaces::Find(const vtkRelievoFrameScene& scene)
{
  vtkRelievoSurfaces found;
  ForEachLit(scene, [&found](vtkActor* actor, vtkMatrix4x4*) {
    for (vtkProperty* property : { actor->GetProperty(), actor->GetBackfaceProperty() })
    {
      const bool isPbr = property && property->GetInterpolation() == VTK_PBR;
      const bool shines = property && !isPbr && Shines(property);
      found.Specular = found.Specular || shines;
      found.Pbr = found.Pbr || isPbr;
      found.Detail = found.Detail || isPbr || shines || (property && property->GetDiffuse() != 1.0);
    }
  });
  return found;
}

//------------------------------------------------------------------------------
std::map<vtkMapper*, std::string> vtkRelievoSurfaces::FindLit(
  const vtkRelievoFrameScene& scene, vtkRenderer* renderer, bool mirrors)
{
  std::map<vtkMapper*, std::string> lit;
  ForEachLit(scene, [&](vtkActor* actor, vtkMatrix4x4* matrix) {
    const bool mirrored = (matrix->Determinant() < 0.0) != mirrors;
    // VTK orients normals by the winding of faces, which a mirroring matrix inverts.
    const std::string why =
      mirrored ? "is mirrored, so that VTK lights its other side" : WhyLit(actor, renderer);
    if (!why.empty())
    {
      lit.emplace(actor->GetMapper(), why);
    }
  });
  return lit;
}

//------------------------------------------------------------------------------
std::map<vtkMapper*, int> vtkRelievoSurfaces::FindLineShaders(const vtkRelievoFrameScene& scene)
{
  std::map<vtkMapper*, int> found;
  ForEachMesh(scene, [&found](vtkActor* actor, vtkMatrix4x4*) {
    const bool wide = DrawsLines(actor) && actor->GetProperty()->GetLineWidth() > 1.0F;
    found[actor->GetMapper()] |= wide ? WideLines : NoWideLines;
  });
  for (auto it = found.begin(); it != found.end();)
  {
    it = it->second == NoWideLines ? found.erase(it) : std::next(it);
  }
  return found;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSurfaces::WhyAllLit(
  const vtkRelievoFrameScene& scene, vtkRenderWindow* window)
{
  const bool smooth = window->GetLineSmoothing() != 0;
  std::string why;
  ForEachMesh(scene, [&why, smooth](vtkActor* actor, vtkMatrix4x4*) {
    vtkProperty* property = actor->GetProperty();
    vtkProperty* back = actor->GetBackfaceProperty();
    auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(actor->GetShaderProperty());
    if (actor->GetForceOpaque() && actor->HasTranslucentPolygonalGeometry() == 0 &&
      property->GetOpacity() < 1.0)
    {
      why = "a translucent surface is forced to be drawn among the opaque geometry";
    }
    else if (actor->GetMapper()->IsA("vtkPointGaussianMapper"))
    {
      why = "Gaussian splats are drawn among the opaque geometry";
    }
    else if (back && back->GetOpacity() < 1.0 && property->GetOpacity() >= 1.0)
    {
      why = "the backs of some surfaces are translucent";
    }
    else if (smooth && DrawsLines(actor))
    {
      why = "smoothed lines are drawn among the opaque geometry (vtkRenderWindow::LineSmoothing)";
    }
    else if (shaders && shaders->HasFragmentShaderCode())
    {
      why = "an actor replaces the whole fragment shader";
    }
  });
  return why;
}

//------------------------------------------------------------------------------
bool vtkRelievoSurfaces::AreMoved(const vtkRelievoFrameScene& scene)
{
  bool found = false;
  ForEachMesh(scene, [&found](vtkActor* actor, vtkMatrix4x4*) { found = found || IsMoved(actor); });
  return found;
}

//------------------------------------------------------------------------------
bool vtkRelievoSurfaces::IsMoved(vtkActor* actor)
{
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(actor->GetShaderProperty());
  if (!shaders || shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode())
  {
    return shaders != nullptr;
  }
  // Skins move in the mesh's space, so their position follows from the depth.
  auto* skin = dynamic_cast<vtkRelievoMovedMesh*>(actor);
  const int count = shaders->GetNumberOfShaderReplacements();
  bool found = false;
  for (int i = 0; i < count && !(skin && count == skin->GetNumberOfMovingReplacements()); ++i)
  {
    found = found || shaders->GetNthShaderReplacementTypeAsString(i) != "Fragment";
  }
  return found;
}

//------------------------------------------------------------------------------
bool vtkRelievoSurfaces::LeaveLightOut(std::string& fragment)
{
  const auto find = [&fragment](const char* section, bool behind) {
    const std::string text = Section(section);
    const std::size_t at = fragment.find(text);
    return at == std::string::npos || !behind ? at : at + text.size();
  };
  std::size_t begin = find("PbrBegin", true);
  // VTK 9.7 replaces one with the other.
  std::size_t end = std::min(find("PbrEnd", false), find("PbrEndWithoutEnvironment", false));
  std::string unlit;
  if (begin == std::string::npos)
  {
    begin = std::min(find("HeadlightBegin", false), find("PhongBegin", false));
    end = find("PhongEnd", true);
    unlit = Section("Unlit");
  }
  // Later code uses variables that a clear coat declares there.
  if (begin >= end || end == std::string::npos || find("CoatBegin", false) != std::string::npos)
  {
    return false;
  }
  fragment.replace(begin, end - begin, "\n" + unlit + "\n");
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSurfaces::WhyLit(vtkActor* actor, vtkRenderer* renderer)
{
  vtkProperty* property = actor->GetProperty();
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(actor->GetShaderProperty());
  if (shaders &&
    (shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasFragmentShaderCode() ||
      shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode()))
  {
    return "has shader code of its own";
  }
  if (property->GetRepresentation() != VTK_SURFACE)
  {
    return PointsOrLines;
  }
  if (property->GetEdgeVisibility())
  {
    return "draws the edges of its cells over its light";
  }
  return property->GetInterpolation() == VTK_PBR ? WhyLitPbr(property, renderer) : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoSurfaces::WhyLit(vtkOpenGLPolyDataMapper* mapper, const std::string& fragment)
{
  // Points and lines have one position across their width; VTK lights spheres and tubes at another.
  if (!vtkRelievoAccess::Mapper::DrawsTriangles(mapper))
  {
    return PointsOrLines;
  }
  if (Has(fragment, "relievoHeightMap") || Has(fragment, "relievoReflection"))
  {
    return "has a relief or an environment (vtkRelievoMaterial)";
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoSurfaces::SetUniforms(vtkShaderProgram* program, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkProperty* back = actor->GetBackfaceProperty() ? actor->GetBackfaceProperty() : property;
  const int lit =
    property->GetInterpolation() == VTK_PBR ? RELIEVO_SHADING_PBR : RELIEVO_SHADING_PHONG;
  program->SetUniformi(
    "relievoShading", actor->GetProperty()->GetLighting() ? lit : RELIEVO_SHADING_NONE);
  float highlights[2][4];
  SetHighlight(property, highlights[0]);
  SetHighlight(back, highlights[1]);
  program->SetUniform4fv("relievoHighlight", 2, highlights);
  const float metal[2] = { static_cast<float>(property->GetMetallic()),
    static_cast<float>(property->GetRoughness()) };
  program->SetUniform2f("relievoMetal", metal);
}
