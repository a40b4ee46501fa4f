// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text work that every splice into VTK's shaders shares.
#ifndef vtkRelievoSpliceText_h
#define vtkRelievoSpliceText_h

#include "vtkRelievoShadersModule.h" // for the export macro

#include <string>

namespace vtkRelievoSpliceText
{
VTKRELIEVOSHADERS_EXPORT bool Has(const std::string& source, const std::string& text);

// Puts the mark on the line behind VTK's tag, which stays.
VTKRELIEVOSHADERS_EXPORT void MarkBehind(
  std::string& source, const std::string& tag, const std::string& mark);

///@{
// The marks behind VTK's light code, which is in gl_FragData[0] by then, in the order of their
// texts; MarkBehindLight puts one of them there, whichever are there already.
VTKRELIEVOSHADERS_EXPORT extern const char* const BehindLight[3]; // catchers, ambient, lamps
VTKRELIEVOSHADERS_EXPORT void MarkBehindLight(std::string& source, const char* mark);
///@}

// Puts the text in the place of the first such mark.
VTKRELIEVOSHADERS_EXPORT void FillMark(
  std::string& source, const std::string& mark, const std::string& text);

// Puts the text in the place of every such word.
VTKRELIEVOSHADERS_EXPORT void FillWord(
  std::string& source, const std::string& word, const std::string& text);

// The defaults of what one splice defines and another reads, shaders/splice/contract.glsl; for
// behind //VTK::System::Dec, after any #extension.
VTKRELIEVOSHADERS_EXPORT std::string GetContract();

// Marks where varyings go, in all three stages.
VTKRELIEVOSHADERS_EXPORT void MarkVaryings(
  std::string& vertex, std::string& geometry, std::string& fragment);

// Whether all stages there are have the marks.
VTKRELIEVOSHADERS_EXPORT bool CanCarryVarying(
  const std::string& vertex, const std::string& geometry, const std::string& fragment);

// The three stages' declarations and statements of one varying, sections of a source, at the marks.
VTKRELIEVOSHADERS_EXPORT void FillVarying(std::string& vertex, std::string& geometry,
  std::string& fragment, const char* file, bool hasFragmentImpl);

// The eye-space position as `vertexVC`, where VTK's shader has none. False if it cannot be carried.
VTKRELIEVOSHADERS_EXPORT bool EnsurePosition(
  std::string& vertex, std::string& geometry, std::string& fragment);
}

#endif
