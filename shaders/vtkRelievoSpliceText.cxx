// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSpliceText.h"

#include "vtkRelievoShaderLibrary.h"

//------------------------------------------------------------------------------
bool vtkRelievoSpliceText::Has(const std::string& source, const std::string& text)
{
  return source.find(text) != std::string::npos;
}

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::MarkBehind(
  std::string& source, const std::string& tag, const std::string& mark)
{
  FillMark(source, tag, tag + "\n" + mark);
}

//------------------------------------------------------------------------------
const char* const vtkRelievoSpliceText::BehindLight[5] = { "//RELIEVO::Shadow::Caught",
  "//RELIEVO::Fill::Impl", "//RELIEVO::Shadow::Direct", "//RELIEVO::Ambient::Impl",
  "//RELIEVO::Lamps::Impl" };

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::MarkBehindLight(std::string& source, const char* mark)
{
  const char* last = "//VTK::Light::Impl";
  for (const char* const* each = BehindLight; *each != mark; ++each)
  {
    last = Has(source, *each) ? *each : last;
  }
  MarkBehind(source, last, mark);
}

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::FillMark(
  std::string& source, const std::string& mark, const std::string& text)
{
  const std::size_t at = source.find(mark);
  if (at != std::string::npos)
  {
    source.replace(at, mark.size(), text);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::FillWord(
  std::string& source, const std::string& word, const std::string& text)
{
  for (std::size_t at = source.find(word); at != std::string::npos;
       at = source.find(word, at + text.size()))
  {
    source.replace(at, word.size(), text);
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoSpliceText::GetContract()
{
  return vtkRelievoShaderLibrary::GetSection("splice/contract.glsl", "Defaults");
}

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::MarkVaryings(
  std::string& vertex, std::string& geometry, std::string& fragment)
{
  for (std::string* source : { &vertex, &geometry, &fragment })
  {
    MarkBehind(*source, "//VTK::PositionVC::Dec", "//RELIEVO::Position::Dec");
    MarkBehind(*source, "//VTK::PositionVC::Impl", "//RELIEVO::Position::Impl");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoSpliceText::CanCarryVarying(
  const std::string& vertex, const std::string& geometry, const std::string& fragment)
{
  auto marked = [](const std::string& source) {
    return Has(source, "//RELIEVO::Position::Dec") && Has(source, "//RELIEVO::Position::Impl");
  };
  return marked(vertex) && marked(fragment) && (geometry.empty() || marked(geometry));
}

//------------------------------------------------------------------------------
void vtkRelievoSpliceText::FillVarying(std::string& vertex, std::string& geometry,
  std::string& fragment, const char* file, bool hasFragmentImpl)
{
  auto section = [file](
                   const char* name) { return vtkRelievoShaderLibrary::GetSection(file, name); };
  MarkBehind(vertex, "//RELIEVO::Position::Dec", section("VertexDec"));
  MarkBehind(vertex, "//RELIEVO::Position::Impl", section("VertexImpl"));
  MarkBehind(geometry, "//RELIEVO::Position::Dec", section("GeometryDec"));
  MarkBehind(geometry, "//RELIEVO::Position::Impl", section("GeometryImpl"));
  MarkBehind(fragment, "//RELIEVO::Position::Dec", section("FragmentDec"));
  if (hasFragmentImpl)
  {
    MarkBehind(fragment, "//RELIEVO::Position::Impl", section("FragmentImpl"));
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoSpliceText::EnsurePosition(
  std::string& vertex, std::string& geometry, std::string& fragment)
{
  if (Has(fragment, "vec4 vertexVC ="))
  {
    return true;
  }
  if (!CanCarryVarying(vertex, geometry, fragment))
  {
    return false;
  }
  FillVarying(vertex, geometry, fragment, "splice/position.glsl", true);
  FillMark(vertex, "RELIEVO_VERTEX_MC", Has(vertex, "vec4 vertex =") ? "vertex" : "vertexMC");
  return true;
}
