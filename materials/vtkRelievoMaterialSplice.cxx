// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterialSplice.h"

#include "vtkRelievoMaterial.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"

#include "codes.glsl"

#include <cctype>
#include <sstream>

using namespace vtkRelievoSpliceText;

namespace
{
#define RELIEVO_SAME_CODE(name)                                                                    \
  static_assert(vtkRelievoMaterial::name == RELIEVO_##name, "differs from shaders/codes.glsl")
RELIEVO_SAME_CODE(METHOD_OFF);
RELIEVO_SAME_CODE(METHOD_PARALLAX);
RELIEVO_SAME_CODE(METHOD_STEEP);
RELIEVO_SAME_CODE(METHOD_OCCLUSION);
RELIEVO_SAME_CODE(METHOD_RELIEF);
#undef RELIEVO_SAME_CODE

const char* const Defines = "//RELIEVO::Material::Defines";
const char* const Dec = "//RELIEVO::Material::Dec";
const char* const UniformFlow = "//RELIEVO::Material::UniformFlow";
const char* const Depth = "//RELIEVO::Material::Depth";
const char* const Normal = "//RELIEVO::Material::Normal";
const char* const Light = "//RELIEVO::Material::Light";
constexpr const char* File = "material/surface.glsl";

std::string Section(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection(File, section);
}

void MarkBefore(std::string& source, const std::string& tag, const std::string& mark)
{
  FillMark(source, tag, mark + "\n  " + tag);
}

bool IsNamePart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Renames a variable wherever the shader's main() reads it.
void Rename(std::string& source, const std::string& name, const std::string& other)
{
  std::size_t at = source.find(name, source.find("void main()"));
  while (at != std::string::npos)
  {
    const std::size_t end = at + name.size();
    const bool whole =
      !IsNamePart(source[at - 1]) && (end == source.size() || !IsNamePart(source[end]));
    if (whole)
    {
      source.replace(at, name.size(), other);
    }
    at = source.find(name, at + (whole ? other.size() : name.size()));
  }
}

void AddSelfShadow(std::string& fragment)
{
  std::string lit;
  for (int number = 0;; ++number)
  {
    const std::string i = std::to_string(number);
    if (!Has(fragment, " lightColor" + i + ";"))
    {
      break;
    }
    const char* const kind = Has(fragment, "vec3 lightPositionVC" + i + ";") ? "LampLit"
      : Has(fragment, "vec3 lightDirectionVC" + i + ";")                     ? "SunLit"
                                                                             : nullptr;
    if (kind) // a light at the eye reaches every visible point
    {
      std::string one = Section(kind);
      FillWord(one, "RELIEVO_NUMBER", i);
      lit += one;
      Rename(fragment, "lightColor" + i, "relievoReliefColor" + i);
    }
  }
  FillMark(fragment, Light, lit);
}
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialSplice::Mark(
  std::string& vertex, std::string& geometry, std::string& fragment)
{
  MarkVaryings(vertex, geometry, fragment);
  for (std::string* source : { &vertex, &geometry, &fragment })
  {
    MarkBehind(*source, "//VTK::System::Dec", Defines);
  }
  MarkBehind(fragment, "//VTK::Light::Dec", Dec);
  MarkBefore(fragment, "//VTK::UniformFlow::Impl", UniformFlow);
  MarkBefore(fragment, "//VTK::Depth::Impl", Depth);
  MarkBehind(fragment, "//VTK::Normal::Impl", Normal);
  MarkBefore(fragment, "//VTK::Light::Impl", Light);
}

//------------------------------------------------------------------------------
std::string vtkRelievoMaterialSplice::Fill(std::string& vertex, std::string& geometry,
  std::string& fragment, const Structure& structure, bool tangents)
{
  for (const char* mark : { Defines, Dec, UniformFlow, Depth, Normal, Light })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark +
        "; use VTK's templates, with their tags";
    }
  }
  if (!CanCarryVarying(vertex, geometry, fragment) || !EnsurePosition(vertex, geometry, fragment))
  {
    return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's templates";
  }
  std::ostringstream defines;
  auto define = [&defines](bool on, const char* text) {
    if (on)
    {
      defines << "#define " << text << "\n";
    }
  };
  const bool relief = structure.Method != RELIEVO_METHOD_OFF;
  const bool corrects = relief && structure.DepthCorrection;
  define(structure.NormalMap, "RELIEVO_NORMAL_MAP");
  define(structure.HeightMap, "RELIEVO_HEIGHT_MAP");
  define(structure.HeightMap, ("RELIEVO_METHOD " + std::to_string(structure.Method)).c_str());
  define(corrects, "RELIEVO_DEPTH_CORRECTION");
  define(relief && Has(vertex, "mat4 tcMatrix;"), "RELIEVO_TEXTURE_MATRIX");
  define(structure.NormalMap && tangents, "RELIEVO_TANGENTS");
  define(structure.NormalMap && Has(fragment, "mat3 tbn ="), "RELIEVO_NORMAL_TEXTURE");
  for (std::string* source : { &vertex, &geometry, &fragment })
  {
    FillMark(*source, Defines, GetContract() + defines.str());
  }

  if (!Has(vertex, "in vec2 tcoord;"))
  {
    MarkBehind(vertex, "//RELIEVO::Position::Dec", Section("TCoordDec"));
  }
  if (structure.NormalMap && tangents && !Has(vertex, "in vec3 tangentMC;"))
  {
    MarkBehind(vertex, "//RELIEVO::Position::Dec", Section("TangentDec"));
  }
  FillVarying(vertex, geometry, fragment, File, false);
  std::string extra;
  if (corrects)
  {
    extra += Has(fragment, "mat4 MCVCMatrix;") ? "" : Section("EyeMatrix");
    extra += Has(fragment, "mat4 MCDCMatrix;") ? "" : Section("ClipMatrix");
  }
  MarkBehind(fragment, Dec, extra);

  // VTK's own textures are sampled where the ray hits the relief.
  if (relief)
  {
    Rename(fragment, "tcoordVCVSOutput", "relievoTCoord");
  }
  FillMark(fragment, UniformFlow, Section("UniformFlow"));
  if (corrects)
  {
    // VTK's offset of coincident geometry starts from the mesh's depth.
    for (const std::string offset : { " + cFactor", " + 1.0*cOffset" })
    {
      FillWord(fragment, "FragCoord.z" + offset, "FragDepth" + offset);
    }
  }
  FillMark(fragment, Depth,
    (relief && structure.Clip ? Section("Clip") : "") + (corrects ? Section("Depth") : ""));
  const bool lit = Has(fragment, "vec3 normalVCVSOutput =");
  FillMark(fragment, Normal, lit ? Section("Normal") : std::string());
  if (relief && structure.SelfShadow && lit)
  {
    AddSelfShadow(fragment);
  }
  return std::string();
}
