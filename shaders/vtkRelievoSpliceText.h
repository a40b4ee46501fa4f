// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text functions shared by all splices into VTK's shaders.
#ifndef vtkRelievoSpliceText_h
#define vtkRelievoSpliceText_h

#include "vtkRelievoShadersModule.h" // for the export macro

#include <string>

namespace vtkRelievoSpliceText
{
VTKRELIEVOSHADERS_EXPORT bool Has(const std::string& source, const std::string& text);

// Inserts the mark on the line after VTK's tag, which remains.
VTKRELIEVOSHADERS_EXPORT void MarkBehind(
  std::string& source, const std::string& tag, const std::string& mark);

///@{
// The marks after VTK's light code, which has written gl_FragData[0], in the order of their texts;
// MarkBehindLight inserts one of them in this order: shadow catchers and the light of casting
// lights, fill lights, the casting lights' share in the sum, ambient occlusion of catchers, lamps.
VTKRELIEVOSHADERS_EXPORT extern const char* const BehindLight[5];
VTKRELIEVOSHADERS_EXPORT void MarkBehindLight(std::string& source, const char* mark);
///@}

// Replaces the first such mark by the text.
VTKRELIEVOSHADERS_EXPORT void FillMark(
  std::string& source, const std::string& mark, const std::string& text);

// Replaces every such word by the text.
VTKRELIEVOSHADERS_EXPORT void FillWord(
  std::string& source, const std::string& word, const std::string& text);

// The defaults of names that one splice defines and another reads, from
// shaders/splice/contract.glsl; to be inserted after //VTK::System::Dec, after any #extension.
VTKRELIEVOSHADERS_EXPORT std::string GetContract();

// Marks the places of varyings in all three stages.
VTKRELIEVOSHADERS_EXPORT void MarkVaryings(
  std::string& vertex, std::string& geometry, std::string& fragment);

// Whether all present stages have the marks.
VTKRELIEVOSHADERS_EXPORT bool CanCarryVarying(
  const std::string& vertex, const std::string& geometry, const std::string& fragment);

// Inserts one varying's declarations and statements, sections of a source, at the marks of the
// three stages.
VTKRELIEVOSHADERS_EXPORT void FillVarying(std::string& vertex, std::string& geometry,
  std::string& fragment, const char* file, bool hasFragmentImpl);

// Adds the eye-space position `vertexVC` if VTK's shader has none. False if this is impossible.
VTKRELIEVOSHADERS_EXPORT bool EnsurePosition(
  std::string& vertex, std::string& geometry, std::string& fragment);
}

#endif
