// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinShader.h"

#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSkinRestPose.h"

#include "vtkDataObject.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"

#include <string>

namespace relievo
{
namespace
{
// Sections of the shader: VTK's declarations; with "Moved", the code after them.
const char* const Declared[] = { "Point", "Normal", "Tangent" };
const char* const Begin = "//VTK::CustomBegin::Impl";

// A section's text without its last line ends, as in VTK's shaders.
std::string GetText(const std::string& section)
{
  const std::string text = vtkRelievoShaderLibrary::GetSection("skin/skin.glsl", section);
  return text.substr(0, text.find_last_not_of("\n") + 1);
}

void SetAttributes(vtkPolyDataMapper* mapper, int influences)
{
  for (int four = 0; four < 2; ++four)
  {
    const std::string joints = "relievoJoints" + std::to_string(four);
    const std::string weights = "relievoWeights" + std::to_string(four);
    mapper->RemoveVertexAttributeMapping(joints.c_str());
    mapper->RemoveVertexAttributeMapping(weights.c_str());
    if (4 * four < influences)
    {
      mapper->MapDataArrayToVertexAttribute(joints.c_str(),
        vtkRelievoSkinRestPose::GetJointsName(four), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
      mapper->MapDataArrayToVertexAttribute(weights.c_str(),
        vtkRelievoSkinRestPose::GetWeightsName(four), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    }
  }
}
}

//------------------------------------------------------------------------------
// Recognised by the replacement of the points, which is unique.
bool SkinShader::IsIn(vtkShaderProperty* shaders) const
{
  bool found = !this->Moves();
  for (int i = 0; !found && i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    std::string name;
    std::string value;
    bool first = false;
    bool all = false;
    shaders->GetNthShaderReplacement(i, name, first, value, all);
    found = value == this->PointText;
  }
  return found;
}

//------------------------------------------------------------------------------
void SkinShader::Set(
  vtkShaderProperty* shaders, vtkPolyDataMapper* mapper, int influences, bool dual)
{
  if (this->Influences == influences && this->Dual == dual && this->IsIn(shaders))
  {
    return;
  }
  this->Influences = influences;
  this->Dual = dual;
  SetAttributes(mapper, influences);
  for (const char* section : Declared)
  {
    shaders->ClearVertexShaderReplacement(GetText(section), false);
  }
  shaders->ClearVertexShaderReplacement(Begin, true);
  if (!this->Moves())
  {
    return;
  }
  const std::string defines = "\n#define RELIEVO_SKIN_INFLUENCES " + std::to_string(influences) +
    (dual ? "\n#define RELIEVO_SKIN_DUAL\n" : "\n");
  for (const char* section : Declared)
  {
    // After VTK's own and the passes' replacements, whose declarations are then available.
    const std::string text = GetText(section);
    const std::string between = section == Declared[0] ? defines : "\n";
    const std::string moved = text + between + GetText(std::string(section) + "Moved");
    shaders->AddVertexShaderReplacement(text, false, moved, false);
    this->PointText = section == Declared[0] ? moved : this->PointText;
  }
  shaders->AddVertexShaderReplacement(Begin, true, GetText("Main") + "\n" + Begin, false);
}
}
