// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonScript.h"

#include "Options.h"
#include "PythonActors.h"
#include "PythonPoints.h"
#include "PythonProgram.h"
#include "PythonSurface.h"
#include "PythonWords.h"
#include "Readers.h"
#include "Scene.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <sstream>

namespace viewer
{
namespace
{
//------------------------------------------------------------------------------
void WriteLights(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options)
{
  if (options.Lights.empty())
  {
    return; // VTK makes a headlight
  }
  const bool brought =
    std::any_of(options.Files.begin(), options.Files.end(), cli::IsGLTF); // whose scenes have some
  out << (brought ? "\nrenderer.RemoveAllLights()" : "")
      << "\nrenderer.AutomaticLightCreationOff()\nlights = []\n";
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
      out << "frame.GetShadowStage().SetLightCasts(" << light << "False)\n";
    }
    if (options.Lights[i].Size)
    {
      out << "frame.GetShadowStage().SetLightSize(" << light << WriteNumber(*options.Lights[i].Size)
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
  out << "camera = renderer.GetActiveCamera()\n"
      << "camera.SetParallelProjection(" << camera->GetParallelProjection() << ")\n"
      << "camera.SetViewAngle(" << WriteNumber(camera->GetViewAngle()) << ")\n"
      << "camera.SetPosition(" << WriteThree(camera->GetPosition()) << ")\n"
      << "camera.SetFocalPoint(" << WriteThree(camera->GetFocalPoint()) << ")\n"
      << "camera.SetViewUp(" << WriteThree(camera->GetViewUp()) << ")\n"
      << "camera.SetParallelScale(" << WriteNumber(camera->GetParallelScale()) << ")\n"
      << "renderer.ResetCameraClippingRange()\n";
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
  const cli::RenderOptions options = settings.Parse();
  vtkRenderer* renderer = picture.GetRenderer();
  const int* size = renderer->GetRenderWindow()->GetSize();
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "renderer = vtkRenderer()\nwindow = vtkRenderWindow()\n"
      << "window.SetOffScreenRendering(1)\nwindow.SetMultiSamples(0)\n"
      << "window.SetSize(" << size[0] << ", " << size[1] << ")\nwindow.AddRenderer(renderer)\n";
  WriteActors(out, picture.GetBare(), options);
  WriteLights(out, renderer, options);
  WriteView(out, renderer, options);
  WriteScalarBar(out, renderer);
  WriteSurface(out, picture.GetBare().Get(), options);
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
  return CompletePython(out.str());
}
}
