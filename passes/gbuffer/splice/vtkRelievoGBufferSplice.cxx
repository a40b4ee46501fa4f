// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferSplice.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoPrimitiveIds.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRelievoSurfaces.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>

using namespace vtkRelievoSpliceText;

namespace
{
constexpr const char* SourceDefine = "#define RELIEVO_PRIMITIVE_SOURCE ";
constexpr const char* Advice = "; use VTK's shader templates, with their tags";

std::string Section(const char* file, const char* section)
{
  return vtkRelievoShaderLibrary::GetSection(std::string("gbuffer/") + file, section);
}

// Whether there are normals at the points, which VTK's unlit shaders leave out.
bool HasPointNormals(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  return mapper->CurrentInput && mapper->CurrentInput->GetPointData()->GetNormals() &&
    actor->GetProperty()->GetInterpolation() != VTK_FLAT &&
    !vtkOpenGLGlyph3DHelper::SafeDownCast(mapper);
}
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferSplice::GetPrimitiveSource(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  if (vtkOpenGLGlyph3DHelper::SafeDownCast(mapper))
  {
    // Culling reorders the instances.
    auto* glyphs = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
    return glyphs && glyphs->GetCullingAndLOD() ? NoPrimitive : InstanceOfGlyphs;
  }
  // By name: cvista lacks both classes.
  if (mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper"))
  {
    return PointOfMesh;
  }
  return vtkRelievoAccess::Mapper::BoundPrimitiveType(mapper) >
      vtkOpenGLPolyDataMapper::PrimitiveTriStrips
    ? NoPrimitive
    : PrimitiveOfMesh;
}

//------------------------------------------------------------------------------
int vtkRelievoGBufferSplice::GetPrimitiveSource(const std::string& fragment)
{
  const std::size_t at = fragment.find(SourceDefine);
  return at == std::string::npos ? NoPrimitive
                                 : fragment[at + std::string(SourceDefine).size()] - '0';
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferSplice::Mark(
  std::string& vertex, std::string& geometry, std::string& fragment)
{
  MarkVaryings(vertex, geometry, fragment);
  MarkBehind(fragment, "//VTK::System::Dec", "//RELIEVO::Extensions");
  MarkBehind(fragment, "//VTK::Output::Dec", "//RELIEVO::Write::Dec");
  MarkBehind(fragment, "//VTK::Picking::Impl", "//RELIEVO::Write::Impl");
  vtkShaderProgram::Substitute(fragment, "//VTK::UniformFlow::Impl",
    "//RELIEVO::UniformFlow::Impl\n  //VTK::UniformFlow::Impl", false);
  vtkShaderProgram::Substitute(fragment, "//VTK::TCoord::Impl",
    "//RELIEVO::Texture::Begin\n//VTK::TCoord::Impl\n//RELIEVO::Texture::End", false);
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferSplice::Fill(std::string& vertex, std::string& geometry,
  std::string& fragment, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
  const vtkRelievoGBufferLayout& layout, const Mode& mode)
{
  for (const char* mark : { "//RELIEVO::Extensions", "//RELIEVO::Write::Dec",
         "//RELIEVO::Write::Impl", "//RELIEVO::UniformFlow::Impl" })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark + Advice;
    }
  }
  if (Has(fragment, "FragData[1]"))
  {
    return "it draws to several buffers at once; give it one colour output";
  }
  int source = GetPrimitiveSource(mapper, actor);
  const bool numbered = source == PrimitiveOfMesh || source == PointOfMesh;
  if (numbered && mode.PrimitiveIds == vtkRelievoPrimitiveIds::Unreliable)
  {
    source = NoPrimitive;
  }
  const bool triangles = vtkRelievoAccess::Mapper::DrawsTriangles(mapper);
  const bool needsNormal =
    triangles && !Has(fragment, "normalVCVSOutput") && HasPointNormals(mapper, actor);
  const bool needsInstance = layout.IdWord >= 0 && source == InstanceOfGlyphs;
  const bool normalByWinding =
    needsNormal || Has(fragment, "gl_FrontFacing == false) { normalVCVSOutput");
  const bool glyphs = Has(vertex, "mat4 GCMCMatrix;");
  const bool needsWinding = normalByWinding && glyphs;
  const bool needsGlyphDepth =
    glyphs && triangles && (layout.DepthWord >= 0 || layout.NormalDepthWord >= 0);
  if (((needsNormal || needsInstance || needsWinding || needsGlyphDepth) &&
        !CanCarryVarying(vertex, geometry, fragment)) ||
    !EnsurePosition(vertex, geometry, fragment))
  {
    return std::string("its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl") + Advice;
  }

  const bool impostor = Has(fragment, "vertexVC.xyz =");
  const bool hasNormal = needsNormal || Has(fragment, "normalVCVSOutput");
  const bool spherePoints = Has(fragment, "ZCalcR") && Has(fragment, "gl_PointCoord");
  const bool tubeLines = Has(fragment, "ZCalcR") && Has(fragment, "float lenZ");
  // Actors of other representations may share the mapper and its shaders, so a uniform
  // distinguishes them.
  const bool faces = triangles && !impostor;

  if (needsNormal)
  {
    FillVarying(vertex, geometry, fragment, "gbuffer/normal.glsl", true);
  }
  if (needsInstance)
  {
    FillVarying(vertex, geometry, fragment, "gbuffer/instance.glsl", false);
  }
  if (needsWinding)
  {
    FillVarying(vertex, geometry, fragment, "gbuffer/winding.glsl", false);
  }
  if (needsGlyphDepth)
  {
    FillVarying(vertex, geometry, fragment, "gbuffer/glyph_depth.glsl", false);
  }

  if (mode.LayersOnly)
  {
    // VTK widens edges by half a line's width around each triangle.
    vtkShaderProgram::Substitute(geometry, " + offsets[i]*", " + 0.0*", false);
  }

  // VTK's own geometry shaders, for edges and wide lines, pass the number on as well.
  if (numbered && layout.IdWord >= 0 && geometry.empty() &&
    mode.PrimitiveIds == vtkRelievoPrimitiveIds::ThroughGeometryShader)
  {
    geometry = vtkRelievoPrimitiveIds::MakeGeometryShader(
      vertex, vtkRelievoPrimitiveIds::GetCorners(mapper, actor));
    source = geometry.empty() ? NoPrimitive : source;
  }

  std::ostringstream defines;
  defines << layout.GetDefines() << SourceDefine << source << "\n";
  auto define = [&defines](bool on, const char* name) {
    if (on)
    {
      defines << "#define " << name << "\n";
    }
  };
  const bool isFaceNormal = hasNormal && Has(fragment, "cross(fdx,fdy)");
  const bool asksFace = layout.GeometricNormalWord >= 0 || !hasNormal;
  define(faces && asksFace && !isFaceNormal, "RELIEVO_FACE_NORMAL");
  define(hasNormal, "RELIEVO_HAS_NORMAL");
  define(normalByWinding, "RELIEVO_NORMAL_BY_WINDING");
  define(needsWinding, "RELIEVO_GLYPH_WINDING");
  define(needsGlyphDepth, "RELIEVO_GLYPH_DEPTH");
  define(spherePoints, "RELIEVO_SPHERE_POINTS");
  define(tubeLines && !spherePoints, "RELIEVO_TUBE_LINES");
  define(Has(fragment, "vec3 albedo ="), "RELIEVO_PBR_ALBEDO");
  define(Has(fragment, "float diffuseIntensityBF;"), "RELIEVO_BACKFACE_PROPERTY");
  // VTK reports an error if a shader ignores attributes of culled glyphs, so it keeps all of them.
  const bool culledGlyphs = source == NoPrimitive && vtkOpenGLGlyph3DHelper::SafeDownCast(mapper);
  define(mode.LayersOnly && !culledGlyphs, "RELIEVO_LAYERS_ONLY");
  define(mode.LinearVisibility, "RELIEVO_LINEAR_VISIBILITY");
  // VTK 9.1 adds only the offset.
  define(Has(fragment, "FragCoord.z + cFactor") || Has(fragment, "FragCoord.z + 1.0*cOffset"),
    "RELIEVO_COINCIDENT_OFFSET");

  define(mode.Deferred && vtkRelievoSurfaces::WhyLit(mapper, fragment).empty() &&
      vtkRelievoSurfaces::LeaveLightOut(fragment),
    "RELIEVO_LIGHT_LEFT_OUT");

  std::string write = Section("write.glsl", "FragmentImpl");
  const std::size_t begin = fragment.find("//RELIEVO::Texture::Begin");
  const std::size_t end = fragment.find("//RELIEVO::Texture::End");
  if (begin != std::string::npos && end != std::string::npos && begin < end)
  {
    // Once for the colour, once for the highlight's colour.
    FillMark(write, "//RELIEVO::Texture::Copy", fragment.substr(begin, end - begin));
    FillMark(write, "//RELIEVO::Texture::Copy", fragment.substr(begin, end - begin));
  }
  std::string shadows;
  for (std::size_t i = 0; i < layout.Shadows.size(); i += 2)
  {
    const std::size_t second = std::min(i + 1, layout.Shadows.size() - 1);
    std::string word = Section("write.glsl", "ShadowWord");
    FillWord(word, "RELIEVO_OFFSET", std::to_string(i / 2));
    FillWord(word, "RELIEVO_FIRST", std::to_string(layout.Shadows[i]));
    FillWord(word, "RELIEVO_SECOND", std::to_string(layout.Shadows[second]));
    shadows += word;
  }
  FillMark(write, "//RELIEVO::Shadow::Words", shadows);
  FillMark(fragment, "//RELIEVO::Extensions",
    Section("write.glsl", "Extensions") + GetContract() + defines.str());
  FillMark(fragment, "//RELIEVO::Write::Dec", Section("write.glsl", "FragmentDec"));
  FillMark(fragment, "//RELIEVO::UniformFlow::Impl", Section("write.glsl", "UniformFlow"));
  FillMark(fragment, "//RELIEVO::Write::Impl", write);
  return std::string();
}
