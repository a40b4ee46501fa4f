// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowSplice.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoNearestDepths.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkRelievoShadowStructure.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cstring>
#include <regex>
#include <sstream>

using namespace vtkRelievoSpliceText;

namespace
{
const char* const Dec = "//RELIEVO::Shadow::Dec";
const char* const VertexDec = "//RELIEVO::Shadow::VertexDec";
const char* const Impl = "//RELIEVO::Shadow::Impl";
const char* const Catch = "//RELIEVO::Shadow::Catch";
const char* const Caught = BehindLight[0];
const char* const Direct = BehindLight[2];
const char* const Extensions = "//RELIEVO::Shadow::Extensions";
const char* const UniformFlow = "//RELIEVO::Shadow::UniformFlow";

std::string Section(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("shadow/receive.glsl", section);
}

std::string Lens(const char* section)
{
  return vtkRelievoShaderLibrary::GetSection("shadow/lens.glsl", section);
}

// Whether the shader text uses the vertex's place, and does not only set it or add to it.
bool ReadsPlace(const std::string& text)
{
  static const std::regex found = [] {
    std::istringstream pattern(Lens("Use"));
    std::string use;
    pattern >> use;
    return std::regex(use);
  }();
  for (std::sregex_iterator each(text.begin(), text.end(), found), none; each != none; ++each)
  {
    if (each->str(3).empty())
    {
      return true;
    }
  }
  return false;
}

// Maps are drawn without the effect of such a text.
void SpareLights(std::string& vertex)
{
  const char* const mark = "//RELIEVO::Position::Impl";
  const std::size_t at = vertex.find(mark);
  const std::size_t end = vertex.rfind('}');
  if (at != std::string::npos && end != std::string::npos && ReadsPlace(vertex.substr(at)))
  {
    vertex.insert(end, Lens("Impl"));
    MarkBehind(vertex, mark, Lens("Keep"));
    MarkBehind(vertex, VertexDec, Lens("Dec"));
  }
}

// A section's text as part of a line.
std::string Line(const char* section)
{
  std::string text = Section(section);
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

// Whether a user changes the fragment shader, and so may read or set VTK's highlights. VTK makes
// some replacements last, after this splice.
bool HasUsersFragment(vtkShaderProperty* shaders)
{
  bool found = shaders->HasFragmentShaderCode();
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    found = found || shaders->GetNthShaderReplacementTypeAsString(i) == "Fragment";
  }
  return found;
}

// Leaves VTK's highlights out, unless the back faces or VTK's passes give them a strength.
void LeaveHighlights(std::string& fragment)
{
  const std::string set = Line("SpecularOfVTK");
  const std::string begin = Line("HighlightOfVTK");
  const std::string none = Line("NoHighlight");
  const std::string anySet = set.substr(0, set.find('=') + 1);
  if (!Has(fragment, set) || fragment.find(anySet) != fragment.rfind(anySet))
  {
    return;
  }
  for (std::size_t from = fragment.find(begin); from != std::string::npos;
       from = fragment.find(begin, from))
  {
    fragment.replace(from, fragment.find(';', from) - from, none);
  }
}

// Repeats VTK's light code, which is between two marks, with other lights: at each of these words
// of the section.
void Repeat(std::string& fragment, const char* section,
  const std::vector<std::pair<const char*, std::string>>& words)
{
  const std::size_t from = fragment.find(Catch) + std::strlen(Catch);
  const std::string light = fragment.substr(from, fragment.find(Caught) - from);
  std::string again = Section(section);
  for (const auto& [word, lights] : words)
  {
    FillWord(again, word, lights + light);
  }
  FillMark(fragment, Caught, again);
}

std::string Numbered(
  const char* section, const vtkRelievoShadowStructure::Light& light, int slot, int face)
{
  std::string text = Section(section);
  FillWord(text, "RELIEVO_NUMBER", std::to_string(light.ShaderIndex));
  FillWord(text, "RELIEVO_SLOT", std::to_string(slot));
  FillWord(text, "RELIEVO_FACE", std::to_string(face));
  return text;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowSplice::Mark(std::string& vertex, std::string& geometry, std::string& fragment)
{
  MarkVaryings(vertex, geometry, fragment);
  MarkBehind(vertex, "//VTK::Camera::Dec", VertexDec);
  MarkBehind(fragment, "//VTK::System::Dec", Extensions);
  MarkBehind(fragment, "//VTK::Light::Dec", Dec);
  vtkShaderProgram::Substitute(fragment, "//VTK::Light::Impl",
    std::string(Impl) + "\n" + Catch + "\n//VTK::Light::Impl", false);
  MarkBehindLight(fragment, Caught);
  MarkBehindLight(fragment, Direct);
  vtkShaderProgram::Substitute(fragment, "//VTK::UniformFlow::Impl",
    std::string(UniformFlow) + "\n  //VTK::UniformFlow::Impl", false);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowSplice::Fill(std::string& vertex, std::string& geometry,
  std::string& fragment, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
  const vtkRelievoShadowStructure& structure)
{
  const bool impostor = Has(fragment, "vertexVC.xyz =") && Has(fragment, "normalVCVSOutput");
  SpareLights(vertex);
  std::string lights;
  std::string flow = Section("UniformFlow");
  std::string visibility;
  std::string colors;
  std::string unshadowed;
  std::string others;
  // Not by actor: ParaView's draws by another one.
  const bool found =
    std::count(structure.Found.begin(), structure.Found.end(), actor->GetMapper()) > 0;
  int slot = 0;
  int face = 0;
  for (const vtkRelievoShadowStructure::Light& light : structure.Lights)
  {
    // An impostor has its own normal. Derivatives are undefined where it selects a cube's side.
    const std::string way = !structure.Maps ? "No"
      : light.Cube                          ? "Cube"
      : impostor                            ? "Normal"
      : light.Soft > 0                      ? "Soft"
      : light.Parallel                      ? "Sun"
                                            : "Lamp";
    visibility += Numbered((way + "Visibility").c_str(), light, slot, face);
    flow += way == "Sun" || way == "Lamp" ? Numbered((way + "Flow").c_str(), light, slot, face)
                                          : std::string();
    if (Has(fragment, " lightColor" + std::to_string(light.ShaderIndex) + ";"))
    {
      lights += Numbered("LightDec", light, slot, face);
      colors += Numbered("LightImpl", light, slot, face);
      unshadowed += Numbered("UnshadowedImpl", light, slot, face);
      others += Numbered("NoLightImpl", light, slot, face);
    }
    ++slot;
    face += light.GetRoom();
  }
  if (structure.Lights.empty() || (colors.empty() && !structure.Unlit))
  {
    return std::string();
  }
  if (Has(fragment, "shadowAttenuation0"))
  {
    return "vtkShadowMapPass has put its own into its shaders; take one of the two";
  }
  for (const char* mark : { Extensions, Dec, Impl, UniformFlow })
  {
    if (!Has(fragment, mark))
    {
      return std::string("its fragment shader lacks VTK's tag for ") + mark +
        "; use VTK's templates, with their tags";
    }
  }
  if (!EnsurePosition(vertex, geometry, fragment))
  {
    return "its shaders lack VTK's tags PositionVC::Dec and PositionVC::Impl; use VTK's templates";
  }
  // Actors of other representations may share the mapper and its shaders: a uniform distinguishes
  // them.
  const bool triangles = vtkRelievoAccess::Mapper::DrawsTriangles(mapper) && !impostor;
  std::ostringstream dec;
  dec << "#define RELIEVO_SHADOW_LIGHTS " << structure.Lights.size() << "\n";
  dec << "#define RELIEVO_SHADOW_FACES " << structure.GetFaces() << "\n";
  dec << "#define RELIEVO_SHADOW_NUMBERS " << structure.Numbers << "\n";
  if (structure.Parts > 0)
  {
    dec << "#define RELIEVO_SHADOW_PARTS " << structure.Parts << "\n";
  }
  if (structure.Nearest)
  {
    dec << "#define RELIEVO_SHADOW_NEAREST " << vtkRelievoNearestDepths::BlockPower << "\n";
  }
  dec << (structure.WideFilter ? "#define RELIEVO_SHADOW_WIDE\n" : "");
  dec << (structure.Spread ? "#define RELIEVO_VOLUME_SPREAD\n" : "");
  dec << (structure.Around ? "#define RELIEVO_VOLUME_AROUND\n" : "");
  dec << "#define RELIEVO_VOLUME_HARMONICS " << structure.Harmonics << "\n";
  dec << (structure.Colored ? "#define RELIEVO_SHADOW_COLORED\n" : "");
  dec << (structure.Tinted ? "#define RELIEVO_VOLUME_TINTED\n" : "");
  dec << (impostor ? "#define RELIEVO_SHADOW_IMPOSTOR\n" : "");
  dec << (triangles ? "#define RELIEVO_SHADOW_TRIANGLES\n" : "");
  // Some VTK versions widen triangles with edges by half a line, and move places with them.
  dec << (Has(geometry, "+ offsets[i]*") ? "#define RELIEVO_SHADOW_WIDENED\n" : "");
  std::string normal = Section("FragmentImpl");
  if (impostor) // for others, the name alone would make other splices assume a normal
  {
    FillWord(normal, "RELIEVO_IMPOSTOR_NORMAL", "normalVCVSOutput");
  }
  const std::string bulge = Line("BulgeOfVTK"); // of spheres and tubes
  vtkShaderProgram::Substitute(fragment, bulge, bulge + "\n" + Section("BulgeDec"), false);
  FillMark(fragment, Extensions, Section("Extensions") + GetContract());
  const auto ofMethod = [&](const char* section) {
    return vtkRelievoShaderLibrary::GetSection(structure.Method, section);
  };
  const bool traced = structure.Traced && !found;
  if (structure.Traced && found) // another program draws the visible surface
  {
    FillMark(vertex, VertexDec, ofMethod("FoundVertexDec"));
  }
  std::string shade;
  for (slot = 0; structure.Volumes && slot < static_cast<int>(structure.Lights.size()); ++slot)
  {
    shade += Numbered("ShadeImpl", structure.Lights[slot], slot, 0);
  }
  const bool catches = vtkRelievoShadowCatcher::Is(actor);
  const bool separates = structure.Direct && !catches && !colors.empty() &&
    !HasUsersFragment(actor->GetShaderProperty());
  const bool colored = catches && geometry.empty() && vtkRelievoShadowCatcher::HasColors(mapper);
  if (colored)
  {
    FillMark(vertex, VertexDec, Section("CatcherVertexDec"));
    vertex.insert(vertex.rfind('}'), Section("CatcherVertexImpl"));
  }
  dec << (catches ? Section(colored ? "CatcherDec" : "PlainCatcherDec") : std::string());
  dec << (Has(fragment, "vec3 albedo =") ? "#define RELIEVO_SHADOW_LINEAR_LIGHT\n" : "");
  FillMark(fragment, Dec,
    dec.str() + (catches || separates ? Section("DirectDec") : std::string()) +
      Section("FragmentDec") + ofMethod("MethodDec") +
      (traced ? ofMethod("TraceDec") : std::string()) + Section("MapsDec") +
      (structure.Volumes ? Section("ShadeDec") : std::string()) + lights);
  FillMark(fragment, UniformFlow, flow);
  const std::string trace = structure.Traced
    ? ofMethod("PlaceImpl") + ofMethod(traced ? "TraceImpl" : "FoundImpl")
    : std::string();
  FillMark(fragment, Impl, normal + visibility + trace + shade + colors);
  // Shaders are not built again for an actor's other property, but they are for another structure.
  if (!structure.Highlights && actor->GetProperty()->GetSpecular() == 0.0 &&
    !HasUsersFragment(actor->GetShaderProperty()))
  {
    LeaveHighlights(fragment);
  }
  if (catches)
  {
    Repeat(fragment, "CaughtImpl",
      { { "RELIEVO_OTHER_LIGHT_OF_VTK", others }, { "RELIEVO_LIGHT_OF_VTK", unshadowed } });
    FillMark(fragment, Catch, Section("CatchImpl"));
  }
  else if (separates)
  {
    Repeat(fragment, "OthersImpl", { { "RELIEVO_LIGHT_OF_VTK", others } });
    FillMark(fragment, Direct, Section("DirectImpl"));
  }
  return std::string();
}
