// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoFirstShown.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyListDomain.h"
#include "vtkSMRepresentationProxy.h"

#include <cstring>

vtkStandardNewMacro(vtkSMRelievoFirstShown);

namespace
{
// ParaView's number for a scale along each axis (ScaleMode of 3D Glyphs).
constexpr int ByComponents = 2;

// Shows each point as a box whose size along each axis is given by the array.
void ShowBoxes(vtkSMProxy* proxy, const char* array)
{
  vtkSMProperty* glyph = proxy->GetProperty("GlyphType");
  auto* offered = glyph ? glyph->FindDomain<vtkSMProxyListDomain>() : nullptr;
  for (unsigned int i = 0; offered && i < offered->GetNumberOfProxies(); ++i)
  {
    if (std::strcmp(offered->GetProxy(i)->GetXMLName(), "CubeSource") == 0)
    {
      vtkSMPropertyHelper(glyph).Set(offered->GetProxy(i));
    }
  }
  vtkSMPropertyHelper(proxy, "Scaling", true).Set(1);
  vtkSMPropertyHelper(proxy, "ScaleMode", true).Set(ByComponents);
  vtkSMPropertyHelper(proxy, "SelectScaleArray", true).Set(array);
  vtkSMPropertyHelper(proxy, "ScaleFactor", true).Set(1.0);
  if (vtkSMProperty* factor = proxy->GetProperty("ScaleFactor"))
  {
    factor->Modified(); // the value stays 1, but an explicit value prevents ParaView's guess
  }
}
}

//------------------------------------------------------------------------------
void vtkSMRelievoFirstShown::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp)
{
  auto* representation = vtkSMRepresentationProxy::SafeDownCast(proxy);
  vtkSMProperty* type = proxy->GetProperty("Representation");
  const char* wanted = xml->GetAttribute("type");
  if (!representation || !type || !wanted || type->GetMTime() > initializationTimeStamp)
  {
    return;
  }
  if (const char* array = xml->GetAttribute("scales"))
  {
    ShowBoxes(proxy, array);
  }
  vtkSMPropertyHelper(proxy, "Shade", true).Set(1); // without it volumes of masks are flat
  representation->SetRepresentationType(wanted);
  proxy->UpdateVTKObjects();
}
