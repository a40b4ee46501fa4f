// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonScript.h"

#include "PythonPoints.h"
#include "PythonSurface.h"
#include "PythonWords.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <algorithm>
#include <sstream>

namespace viewer
{
namespace
{
const char* const Head = R"(import relievo
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkImageReader2Factory, vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkWindowToImageFilter)


def data(reader, path):
    """What a file holds."""
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutputDataObject(0)


def image(path):
    """An image, such as a map of normals."""
    ending = path[path.rfind("."):].lower()
    reader = (relievo.vtkRelievoEXRReader() if ending == ".exr" else
              vtkImageReader2Factory.CreateImageReader2FromExtension(ending))
    return data(reader, path)


def surface(data, smooth):
    """The polygons to draw, with normals."""
    if not isinstance(data, vtkPolyData):
        outside = vtkGeometryFilter()
        outside.PassThroughCellIdsOn()
        outside.SetInputDataObject(data)
        outside.Update()
        data = outside.GetOutput()
    have = data.GetPointData().GetNormals() or data.GetCellData().GetNormals()
    if smooth and not have and data.GetNumberOfPolys() > 0:
        normals = vtkPolyDataNormals()
        normals.ConsistencyOff()
        normals.SetInputData(data)
        normals.Update()
        data = normals.GetOutput()
    return data
)";

constexpr const char* Unsaid[] = { "--skeleton", "--time", "--animation", "--skin" };

//------------------------------------------------------------------------------
void WriteColors(std::ostream& out, vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
  {
    out << "mapper.ScalarVisibilityOff()\n";
    return;
  }
  const int mode = mapper->GetScalarMode();
  if (mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)
  {
    out << "mapper.SetScalarMode(" << mode << ")\nmapper.SelectColorArray("
        << Quote(mapper->GetArrayName()) << ")\n";
  }
  auto* map = vtkColorTransferFunction::SafeDownCast(mapper->GetLookupTable());
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
}

//------------------------------------------------------------------------------
void WriteProperty(std::ostream& out, vtkProperty* property)
{
  const vtkNew<vtkProperty> fresh;
  out << "property = actor.GetProperty()\nproperty.SetInterpolation("
      << property->GetInterpolation() << ")\nproperty.SetOpacity("
      << WriteNumber(property->GetOpacity()) << ")\n";
  const auto write = [&](const char* name, double* (vtkProperty::*get)()) {
    const std::string value = WriteThree((property->*get)());
    if (value != WriteThree((fresh->*get)()))
    {
      out << "property.Set" << name << "(" << value << ")\n";
    }
  };
  const auto writeNumber = [&](const char* name, double (vtkProperty::*get)()) {
    if ((property->*get)() != (fresh->*get)())
    {
      out << "property.Set" << name << "(" << WriteNumber((property->*get)()) << ")\n";
    }
  };
  write("AmbientColor", &vtkProperty::GetAmbientColor);
  write("DiffuseColor", &vtkProperty::GetDiffuseColor);
  write("SpecularColor", &vtkProperty::GetSpecularColor);
  writeNumber("Specular", &vtkProperty::GetSpecular);
  writeNumber("SpecularPower", &vtkProperty::GetSpecularPower);
  if (property->GetEdgeVisibility())
  {
    out << "property.EdgeVisibilityOn()\nproperty.SetEdgeColor("
        << WriteThree(property->GetEdgeColor()) << ")\n";
  }
}

//------------------------------------------------------------------------------
void WriteActors(std::ostream& out, vtkRenderer* renderer, const Settings& settings, bool mapped,
  const std::set<std::string>& incomplete)
{
  vtkActorCollection* actors = renderer->GetActors();
  if (actors->GetNumberOfItems() != static_cast<int>(settings.Files.size()))
  {
    RefusePython("a file with materials");
  }
  const char* smooth = settings.Get("--shading") == "flat" ? "False" : "True";
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    const std::string& path = settings.Files[static_cast<std::size_t>(i)];
    if (incomplete.count(path) != 0)
    {
      RefusePython(path + " with points that are not finite");
    }
    if (actor->GetTexture() || !vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()))
    {
      RefusePython(path);
    }
    out << "\nmapper = vtkPolyDataMapper()\nmapper.SetInputData(" << (mapped ? "mapped(" : "")
        << "surface(data(" << GetReader(path) << "(), " << Quote(path) << "), " << smooth << ")"
        << (mapped ? "))\n" : ")\n");
    WriteColors(out, actor->GetMapper());
    out << "actor = vtkActor()\nactor.SetMapper(mapper)\n";
    WriteProperty(out, actor->GetProperty());
    out << "renderer.AddActor(actor)\n";
  }
}

//------------------------------------------------------------------------------
void WriteLights(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options)
{
  if (options.Lights.empty())
  {
    return; // VTK makes a headlight
  }
  out << "\nrenderer.AutomaticLightCreationOff()\nlights = []\n";
  vtkLightCollection* lights = renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    vtkLight* light = vtkLight::SafeDownCast(lights->GetItemAsObject(i));
    out << "light = vtkLight()\nlight.SetLightTypeToSceneLight()\n"
        << "light.SetPosition(" << WriteThree(light->GetPosition()) << ")\n"
        << "light.SetFocalPoint(" << WriteThree(light->GetFocalPoint()) << ")\n"
        << "light.SetPositional(" << light->GetPositional() << ")\n"
        << "light.SetConeAngle(" << WriteNumber(light->GetConeAngle()) << ")\n"
        << "light.SetColor(" << WriteThree(light->GetDiffuseColor()) << ")\n"
        << "renderer.AddLight(light)\nlights.append(light)\n";
  }
}

//------------------------------------------------------------------------------
void WriteFrame(std::ostream& out, vtkRelievoPass* frame, const cli::RenderOptions& options)
{
  out << "\nframe = relievo.attach(renderer)\nframe.WaitForSamplesOn()\n";
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = frame->GetStage(i);
    const std::string get = "frame.GetStage(" + Quote(stage->GetStageName()) + ")";
    if (stage->GetEnabled() && !stage->GetDescription().OnByDefault)
    {
      out << get << ".EnabledOn()\n";
    }
    for (int k = 0; k < stage->GetNumberOfParameters(); ++k)
    {
      const std::string name = stage->GetParameterName(k);
      const std::string value = stage->GetParameter(name);
      if (value != stage->GetParameterDefault(name))
      {
        out << get << ".SetParameter(" << Quote(name) << ", " << Quote(value) << ")\n";
      }
    }
  }
  for (std::size_t i = 0; i < options.Lights.size(); ++i)
  {
    const std::string light = "lights[" + std::to_string(i) + "], ";
    if (!options.Lights[i].Casts)
    {
      out << "frame.GetShadowPass().SetLightCasts(" << light << "False)\n";
    }
    if (options.Lights[i].Size)
    {
      out << "frame.GetShadowPass().SetLightSize(" << light << WriteNumber(*options.Lights[i].Size)
          << ")\n";
    }
  }
}

//------------------------------------------------------------------------------
void WriteView(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options)
{
  out << "\nrenderer.SetBackground(" << WriteThree(renderer->GetBackground()) << ")\n";
  if (renderer->GetGradientBackground())
  {
    out << "renderer.SetBackground2(" << WriteThree(renderer->GetBackground2())
        << ")\nrenderer.GradientBackgroundOn()\n";
  }
  if (renderer->GetUseDepthPeeling())
  {
    out << "renderer.UseDepthPeelingOn()\n";
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const int* size = renderer->GetRenderWindow()->GetSize();
  out << "window = vtkRenderWindow()\nwindow.SetOffScreenRendering(1)\nwindow.SetMultiSamples(0)\n"
      << "window.SetSize(" << size[0] << ", " << size[1] << ")\nwindow.AddRenderer(renderer)\n"
      << "camera = renderer.GetActiveCamera()\n"
      << "camera.SetParallelProjection(" << camera->GetParallelProjection() << ")\n"
      << "camera.SetViewAngle(" << WriteNumber(camera->GetViewAngle()) << ")\n"
      << "camera.SetPosition(" << WriteThree(camera->GetPosition()) << ")\n"
      << "camera.SetFocalPoint(" << WriteThree(camera->GetFocalPoint()) << ")\n"
      << "camera.SetViewUp(" << WriteThree(camera->GetViewUp()) << ")\n"
      << "renderer.ResetCameraClippingRange()\n"
      << "camera.SetParallelScale(" << WriteNumber(camera->GetParallelScale()) << ")\n";
  if (options.Clip)
  {
    out << "camera.SetClippingRange(" << WriteNumbers({ (*options.Clip)[0], (*options.Clip)[1] })
        << ")\n";
  }
}
}

//------------------------------------------------------------------------------
std::string WritePython(Picture& picture, const Settings& settings, const std::string& png)
{
  picture.CheckShown("Copy as Python");
  for (const char* option : Unsaid)
  {
    if (settings.Has(option))
    {
      RefusePython(option);
    }
  }
  const cli::RenderOptions options = settings.Parse();
  vtkRenderer* renderer = picture.GetRenderer();
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << Head;
  const bool mapped = IsMapped(options);
  if (mapped)
  {
    WriteMapped(out, options);
  }
  out << "\n\nrenderer = vtkRenderer()\n";
  WriteActors(out, renderer, settings, mapped, picture.GetIncomplete());
  WriteLights(out, renderer, options);
  WriteView(out, renderer, options);
  WriteScalarBar(out, renderer);
  WriteSurface(out, renderer, options);
  if (vtkRelievoPass* frame = picture.GetFrame())
  {
    WriteFrame(out, frame, options);
  }
  WritePoints(out, options);
  out << R"(
window.Render()
grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
grab.ShouldRerenderOff()
writer = vtkPNGWriter()
writer.SetInputConnection(grab.GetOutputPort())
)"
      << "writer.SetFileName(" << Quote(png) << ")\nwriter.Write()\n";
  return out.str();
}
}
