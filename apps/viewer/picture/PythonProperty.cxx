// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonProperty.h"

#include "PythonWords.h"
#include "Settings.h"

#include "vtkColorTransferFunction.h"
#include "vtkMapper.h"
#include "vtkProperty.h"

namespace viewer
{
//------------------------------------------------------------------------------
void WriteColors(std::ostream& out, vtkMapper* mapper, bool wasColored, bool wasInterpolated)
{
  if (!mapper->GetScalarVisibility())
  {
    out << (wasColored ? "mapper.ScalarVisibilityOff()\n" : "");
    return;
  }
  out << (wasColored ? "" : "mapper.ScalarVisibilityOn()\n");
  auto* map = vtkColorTransferFunction::SafeDownCast(mapper->GetLookupTable());
  const int mode = mapper->GetScalarMode();
  if (mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)
  {
    out << "mapper.SetScalarMode(" << mode << ")\nmapper.SelectColorArray("
        << Quote(mapper->GetArrayName()) << ")\n";
  }
  if (!map || !mapper->GetUseLookupTableScalarRange())
  {
    return;
  }
  out << "colors = vtkColorTransferFunction()\ncolors.SetNanColor(0.5, 0.5, 0.5)\n"
      << "colors.SetColorSpace(" << map->GetColorSpace() << ")\n"
      << "colors.SetHSVWrap(" << map->GetHSVWrap() << ")\n"
      << "colors.SetVectorMode(" << map->GetVectorMode() << ")\n"
      << "colors.SetVectorComponent(" << map->GetVectorComponent() << ")\n";
  for (int i = 0; i < map->GetSize(); ++i)
  {
    double node[6];
    map->GetNodeValue(i, node);
    out << "colors.AddRGBPoint(" << WriteNumbers({ node, node + 6 }) << ")\n";
  }
  out << "mapper.SetColorModeToMapScalars()\nmapper.SetLookupTable(colors)\n"
      << "mapper.UseLookupTableScalarRangeOn()\n";
  if ((mapper->GetInterpolateScalarsBeforeMapping() != 0) != wasInterpolated)
  {
    out << "mapper.InterpolateScalarsBeforeMapping" << (wasInterpolated ? "Off" : "On") << "()\n";
  }
}

//------------------------------------------------------------------------------
void WriteProperty(std::ostream& out, vtkProperty* property, vtkProperty* before)
{
  if (property->GetInterpolation() != before->GetInterpolation())
  {
    out << "property.SetInterpolation(" << property->GetInterpolation() << ")\n";
  }
  const auto write = [&](const char* name, double* (vtkProperty::*get)()) {
    const std::string value = WriteThree((property->*get)());
    if (value != WriteThree((before->*get)()))
    {
      out << "property.Set" << name << "(" << value << ")\n";
    }
  };
  const auto writeNumber = [&](const char* name, double (vtkProperty::*get)()) {
    if ((property->*get)() != (before->*get)())
    {
      out << "property.Set" << name << "(" << WriteNumber((property->*get)()) << ")\n";
    }
  };
  writeNumber("Opacity", &vtkProperty::GetOpacity);
  write("AmbientColor", &vtkProperty::GetAmbientColor);
  write("DiffuseColor", &vtkProperty::GetDiffuseColor);
  write("SpecularColor", &vtkProperty::GetSpecularColor);
  writeNumber("Specular", &vtkProperty::GetSpecular);
  writeNumber("SpecularPower", &vtkProperty::GetSpecularPower);
  if (property->GetEdgeVisibility() && !before->GetEdgeVisibility())
  {
    out << "property.EdgeVisibilityOn()\nproperty.SetEdgeColor("
        << WriteThree(property->GetEdgeColor()) << ")\n";
  }
  if (before->GetTexture("albedoTex") && !property->GetTexture("albedoTex"))
  {
    out << "property.RemoveTexture(\"albedoTex\")\n";
  }
}
}
