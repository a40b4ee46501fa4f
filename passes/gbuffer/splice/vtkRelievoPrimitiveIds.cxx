// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPrimitiveIds.h"

#include "vtkActor.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <sstream>

using namespace vtkRelievoSpliceText;

namespace
{
int Forced = -1;

struct Varying
{
  std::string Qualifiers; // "flat ", or nothing
  std::string Type;
  std::string Name;
  std::string Array; // "[6]", or nothing
};

bool IsWordPart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Parses the declarations of outputs, one per line as VTK writes them; false for any other form.
bool FindVaryings(const std::string& vertex, std::vector<Varying>& varyings)
{
  std::istringstream lines(vertex);
  std::string line;
  while (std::getline(lines, line))
  {
    line = line.substr(0, line.find("//"));
    std::istringstream words(line);
    std::string word;
    Varying varying;
    while (words >> word &&
      (word == "flat" || word == "smooth" || word == "noperspective" || word == "centroid"))
    {
      varying.Qualifiers += word + " ";
    }
    if (word != "out" && word != "varying")
    {
      continue;
    }
    words >> varying.Type;
    if (varying.Type == "highp" || varying.Type == "mediump" || varying.Type == "lowp")
    {
      words >> varying.Type;
    }
    std::string rest;
    std::getline(words, rest, '\0');
    rest.erase(
      std::remove_if(rest.begin(), rest.end(), [](unsigned char c) { return std::isspace(c); }),
      rest.end());
    const std::size_t end = rest.find(';');
    if (end == std::string::npos || rest.find_first_of(",{(=") < end)
    {
      return false;
    }
    rest = rest.substr(0, end);
    const std::size_t bracket = rest.find('[');
    varying.Name = rest.substr(0, bracket);
    varying.Array = bracket == std::string::npos ? "" : rest.substr(bracket);
    varyings.push_back(varying);
  }
  return true;
}

void Rename(std::string& source, const std::string& name, const std::string& other)
{
  for (std::size_t at = source.find(name); at != std::string::npos;
       at = source.find(name, at + other.size()))
  {
    const bool whole = (at == 0 || !IsWordPart(source[at - 1])) &&
      (at + name.size() >= source.size() || !IsWordPart(source[at + name.size()]));
    if (whole)
    {
      source.replace(at, name.size(), other);
    }
  }
}

// Draws with `varyings` varyings beside the number, and reads the number back.
bool Try(vtkOpenGLRenderWindow* window, int varyings, bool geometryShader)
{
  using namespace vtkRelievoPrimitiveIds;
  std::string vertex = vtkRelievoShaderLibrary::Get("probe/primitivesVS.glsl");
  std::string fragment = vtkRelievoShaderLibrary::Get("probe/primitivesFS.glsl");
  const std::string define = "#define RELIEVO_VARYINGS " + std::to_string(varyings) + "\n";
  FillMark(vertex, "//RELIEVO::Defines", define);
  FillMark(fragment, "//RELIEVO::Defines", define);
  std::string geometry;
  if (geometryShader)
  {
    // Resolves the vertex shader's preprocessor conditions, because MakeGeometryShader takes every
    // varying in the text.
    std::string plain;
    std::istringstream lines(vertex);
    std::string line;
    int least = 0;
    while (std::getline(lines, line))
    {
      if (line.rfind("#if RELIEVO_VARYINGS > ", 0) == 0)
      {
        least = line.back() - '0';
      }
      else if (line == "#endif")
      {
        least = 0;
      }
      else if (varyings > least)
      {
        plain += line + "\n";
      }
    }
    vertex = plain;
    geometry = MakeGeometryShader(vertex, 3);
  }
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), geometry.c_str());
  if (!program)
  {
    return false;
  }
  program->SetUniformi("relievoRows", Rows);
  glDrawArrays(GL_TRIANGLES, 0, 3 * Rows);
  std::vector<std::uint32_t> texels(4 * Rows * Columns, 0xffffffffu);
  glFinish();
  glReadPixels(0, 0, Columns, Rows, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels.data());
  std::vector<std::uint32_t> words(Rows * Columns);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    words[i] = texels[4 * i];
  }
  return Check(words);
}

vtkRelievoPrimitiveIds::Route Probe(vtkOpenGLRenderWindow* window)
{
  using namespace vtkRelievoPrimitiveIds;
  vtkOpenGLState* state = window->GetState();
  auto kept = std::make_unique<vtkRelievoScopedState>(state);
  GLuint texture = 0;
  GLuint framebuffer = 0;
  GLuint array = 0;
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(
    GL_TEXTURE_2D, 0, GL_RGBA32UI, Columns, Rows, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  // VTK caches the buffers of the framebuffer bound before, and may skip the change.
  unsigned int buffer = GL_COLOR_ATTACHMENT0;
  state->vtkglDrawBuffers(1, &buffer);
  glDrawBuffers(1, &buffer);
  state->vtkglReadBuffer(buffer);
  glReadBuffer(buffer);
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  state->vtkglViewport(0, 0, Columns, Rows);
  state->vtkglScissor(0, 0, Columns, Rows);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  auto tryAll = [window](bool geometryShader) {
    return Try(window, 1, geometryShader) && Try(window, 3, geometryShader) &&
      Try(window, 6, geometryShader);
  };
  const Route route = tryAll(false) ? AsWritten : tryAll(true) ? ThroughGeometryShader : Unreliable;
  window->GetShaderCache()->ReleaseCurrentShader();
  glBindVertexArray(0);
  kept.reset();
  glDeleteVertexArrays(1, &array);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
  return route;
}
}

//------------------------------------------------------------------------------
vtkRelievoPrimitiveIds::Route vtkRelievoPrimitiveIds::Get(vtkOpenGLRenderWindow* window)
{
  struct Known
  {
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    vtkMTimeType Context;
    Route Found;
  };
  static std::vector<Known> all;
  if (Forced >= 0)
  {
    return static_cast<Route>(Forced);
  }
  all.erase(
    std::remove_if(all.begin(), all.end(), [](const Known& known) { return !known.Window; }),
    all.end());
  const vtkMTimeType context = window->GetContextCreationTime();
  for (const Known& known : all)
  {
    if (known.Window == window && known.Context == context)
    {
      return known.Found;
    }
  }
  all.push_back(Known{ window, context, Probe(window) });
  return all.back().Found;
}

//------------------------------------------------------------------------------
const char* vtkRelievoPrimitiveIds::ToString(Route route)
{
  return route == AsWritten          ? "as written"
    : route == ThroughGeometryShader ? "through a geometry shader"
                                     : "unreliable: this OpenGL gives fragment shaders wrong "
                                       "numbers of primitives; cell ids are not read";
}

//------------------------------------------------------------------------------
void vtkRelievoPrimitiveIds::Force(int route)
{
  Forced = route;
}

//------------------------------------------------------------------------------
bool vtkRelievoPrimitiveIds::Check(const std::vector<std::uint32_t>& words)
{
  if (words.size() != static_cast<std::size_t>(Rows * Columns))
  {
    return false;
  }
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (words[i] != i / Columns)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoPrimitiveIds::MakeGeometryShader(std::string& vertex, int corners)
{
  std::vector<Varying> varyings;
  if (!FindVaryings(vertex, varyings))
  {
    return std::string();
  }
  std::string declarations;
  std::string copies;
  for (const Varying& varying : varyings)
  {
    // VTK's shader cache appends GSOutput to the fragment shader's inputs.
    std::string in = varying.Name;
    std::string out = varying.Name;
    if (Has(in, "VSOut"))
    {
      FillWord(out, "VSOut", "GSOut");
    }
    else
    {
      in += "VSOutput";
      Rename(vertex, varying.Name, in);
    }
    for (auto& [section, text] :
      { std::make_pair("Dec", &declarations), std::make_pair("Impl", &copies) })
    {
      std::string one = vtkRelievoShaderLibrary::GetSection("gbuffer/varying.glsl", section);
      FillWord(one, "RELIEVO_QUALIFIERS ", varying.Qualifiers);
      FillWord(one, "RELIEVO_TYPE", varying.Type);
      FillWord(one, "RELIEVO_INPUT", in);
      FillWord(one, "RELIEVO_OUTPUT", out);
      FillWord(one, "RELIEVO_ARRAY", varying.Array);
      *text += one;
    }
  }
  if (Has(vertex, "gl_PointSize"))
  {
    copies += vtkRelievoShaderLibrary::GetSection("gbuffer/varying.glsl", "PointSize");
  }
  std::string geometry = vtkRelievoShaderLibrary::Get("gbuffer/passthroughGS.glsl");
  FillWord(geometry, "RELIEVO_PRIMITIVE_IN",
    corners == 1     ? "points"
      : corners == 2 ? "lines"
                     : "triangles");
  FillWord(geometry, "RELIEVO_PRIMITIVE_OUT",
    corners == 1     ? "points"
      : corners == 2 ? "line_strip"
                     : "triangle_strip");
  FillWord(geometry, "RELIEVO_CORNERS", std::to_string(corners));
  FillMark(geometry, "//RELIEVO::Varyings::Dec\n", declarations);
  FillMark(geometry, "    //RELIEVO::Varyings::Impl\n", copies);
  return geometry;
}

//------------------------------------------------------------------------------
int vtkRelievoPrimitiveIds::GetCorners(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  const int representation = actor->GetProperty()->GetRepresentation();
  const int type = vtkRelievoAccess::Mapper::BoundPrimitiveType(mapper);
  return representation == VTK_POINTS || type == vtkOpenGLPolyDataMapper::PrimitivePoints ? 1
    : representation == VTK_WIREFRAME || type == vtkOpenGLPolyDataMapper::PrimitiveLines  ? 2
                                                                                          : 3;
}
