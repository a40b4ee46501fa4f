// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonSurface.h"

#include "Options.h"
#include "PythonWords.h"
#include "Settings.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkPropCollection.h"
#include "vtkRelievoMaterial.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

namespace viewer
{
namespace
{
void WriteMaterial(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options)
{
  out << "\nmaterial = relievo.vtkRelievoMaterial()\n";
  if (!options.NormalMap.empty())
  {
    out << "material.SetNormalMap(image(" << Quote(options.NormalMap) << "))\n";
  }
  if (!options.HeightMap.empty())
  {
    // The depth of the relief may follow from the scene's size: it is that of what is shown.
    vtkRelievoMaterial* material =
      vtkRelievoMaterial::Get(vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(0)));
    out << "material.SetHeightMap(image(" << Quote(options.HeightMap) << "))\n"
        << "material.SetHeightScale(" << WriteNumber(material->GetHeightScale()) << ")\n"
        << "material.SetMethod(" << material->GetMethod() << ")\n"
        << "material.SetDepthCorrection(" << (material->GetDepthCorrection() ? "True" : "False")
        << ")\nmaterial.SetSelfShadow(" << (material->GetSelfShadow() ? "True" : "False") << ")\n";
  }
  if (!options.Environment.empty())
  {
    out << "material.SetReflectivity(" << WriteNumber(options.Reflectivity)
        << ")\nmaterial.SetRoughness(" << WriteNumber(options.Roughness) << ")\n";
  }
  out << "for actor in renderer.GetActors():\n    material.Attach(actor)\n";
}
}

//------------------------------------------------------------------------------
bool IsMapped(const cli::RenderOptions& options)
{
  return !options.NormalMap.empty() || !options.HeightMap.empty();
}

//------------------------------------------------------------------------------
void WriteMapped(std::ostream& out, const cli::RenderOptions& options)
{
  static const char* const mappings[] = { "Box", "Plane", "Sphere" };
  const auto mapping = options.TextureMapping.value_or(cli::Mapping::Box);
  out << R"(

def mapped(data):
    """With texture coordinates, where there are none."""
    if data.GetPointData().GetTCoords() or data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        return data
    if data.GetNumberOfStrips() > 0:
        triangles = vtkTriangleFilter()
        triangles.SetInputData(data)
        triangles.Update()
        data = triangles.GetOutput()
    coordinates = relievo.vtkRelievoTextureCoordinates()
    coordinates.SetInputData(data)
    coordinates.SetMappingTo)"
      << mappings[static_cast<int>(mapping)] << "()\n    coordinates.SetUp(" << options.UpAxis
      << R"()
    coordinates.Update()
    data = coordinates.GetOutput()
    data.GetPointData().RemoveArray("vtkOriginalPointIds")
    return data

)";
}

//------------------------------------------------------------------------------
void WriteSurface(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options)
{
  if (IsMapped(options))
  {
    WriteMaterial(out, renderer, options);
  }
  if (options.Environment.empty())
  {
    return;
  }
  if (options.Lights.empty())
  {
    out << "\nlight = vtkLight()\nlight.SetLightTypeToHeadlight()\nlight.SetIntensity(0)\n"
        << "renderer.AddLight(light)  # the environment lights\n";
  }
  out << "\nrelievo.environment(renderer, " << Quote(options.Environment)
      << ", rotation=" << WriteNumber(options.EnvironmentRotation) << ", up=\""
      << "xyz"[options.UpAxis]
      << "\",\n                    reflectivity=" << WriteNumber(options.Reflectivity)
      << ", roughness=" << WriteNumber(options.Roughness)
      << ", sky=" << (options.Skybox ? "True" : "False") << ")\n";
}

//------------------------------------------------------------------------------
void WriteScalarBar(std::ostream& out, vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* bar = vtkScalarBarActor::SafeDownCast(prop);
    if (!bar)
    {
      continue;
    }
    const double* place = bar->GetPosition();
    out << "\nbar = vtkScalarBarActor()\nbar.SetLookupTable(colors)\nbar.SetTitle("
        << Quote(bar->GetTitle()) << ")\nbar.SetNumberOfLabels(" << bar->GetNumberOfLabels()
        << ")\nbar.SetVerticalTitleSeparation(" << bar->GetVerticalTitleSeparation()
        << ")\nbar.UnconstrainedFontSizeOn()\n"
        << "for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):\n"
        << "    text.SetColor(" << WriteThree(bar->GetTitleTextProperty()->GetColor())
        << ")\n    text.SetFontSize(" << bar->GetTitleTextProperty()->GetFontSize()
        << ")\n    text.BoldOff()\n    text.ItalicOff()\n    text.ShadowOff()\n"
        << "bar.SetPosition(" << WriteNumbers({ place[0], place[1] }) << ")\nbar.SetWidth("
        << WriteNumber(bar->GetWidth()) << ")\nbar.SetHeight(" << WriteNumber(bar->GetHeight())
        << ")\nrenderer.AddViewProp(bar)\n";
  }
}
}
