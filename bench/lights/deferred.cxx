// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deferred shading against VTK's own: plates behind each other that fill the window, drawn from
// back to front, so that every pixel is drawn once per plate; lit by VTK's lights. Frames in turn
// in one process.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "FrameBench.h"
#include "Table.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timing;

struct PlatesWindow
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  PlatesWindow(int plates, int lights, bool shines, int pixels, bool deferred)
    : Window(vtkSmartPointer<vtkRenderWindow>::New())
  {
    for (int i = 0; i < plates; ++i)
    {
      vtkNew<vtkPlaneSource> plate;
      plate->SetOrigin(-2., -2., 0.1 * i);
      plate->SetPoint1(2., -2., 0.1 * i);
      plate->SetPoint2(-2., 2., 0.1 * i);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(plate->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.9, 0.4 + 0.03 * i, 0.3);
      actor->GetProperty()->SetSpecular(shines ? 0.3 : 0.);
      actor->GetProperty()->SetSpecularPower(30.);
      this->Renderer->AddActor(actor);
    }
    this->Renderer->AutomaticLightCreationOff();
    for (int i = 0; i < lights; ++i)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->PositionalOn();
      light->SetConeAngle(180.);
      light->SetPosition(-1.5 + 3. * ((i * 7) % lights) / lights, -1.5 + 3. * i / lights, 3.);
      light->SetIntensity(1. / lights);
      this->Renderer->AddLight(light);
    }
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0., 0., 5.);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewAngle(30.);
    camera->SetClippingRange(1., 10.);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(pixels, pixels);
    this->Window->AddRenderer(this->Renderer);
    if (deferred)
    {
      vtkRelievoPass::Attach(this->Renderer)->DeferredOn();
    }
  }
};
}

//------------------------------------------------------------------------------
namespace relievoBench
{
int BenchDeferred(const std::string& outDir, const DeferredSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "surface", "lights", "overdraw", "way", "milliseconds", "times VTK's", "+-",
    "bytes a pixel", "load" });
  for (const bool shines : { false, true })
  {
    for (const int lights : sizes.Lights)
    {
      for (const int overdraw : sizes.Overdraw)
      {
        const PlatesWindow own(overdraw, lights, shines, sizes.Pixels, false);
        const PlatesWindow deferred(overdraw, lights, shines, sizes.Pixels, true);
        const std::vector<Timing> times = TimeInTurn(
          { relievoTest::Frame(own.Window), relievoTest::Frame(deferred.Window) }, sizes.Rounds);
        const vtkIdType bytes = vtkRelievoPass::Attach(deferred.Renderer)->GetBytesHeld();
        const auto ratio = PairOf(times[1], times[0]);
        const std::string surface = shines ? "with highlights" : "matte";
        std::cout << surface << ", " << lights << " lights, " << overdraw << " plates: VTK "
                  << Number(1e3 * times[0].Median(), 3) << " ms, deferred "
                  << Number(1e3 * times[1].Median(), 3) << " ms, " << Number(ratio.Ratio(), 3)
                  << " +- " << Number(ratio.RatioSpread(), 1) << std::endl;
        const double pixels = static_cast<double>(sizes.Pixels) * sizes.Pixels;
        for (int way = 0; way < 2; ++way)
        {
          table.AddRow({ surface, std::to_string(lights), std::to_string(overdraw),
            way == 0 ? "VTK's shading" : "deferred", Number(1e3 * times[way].Median(), 4),
            way == 0 ? "1" : Number(ratio.Ratio(), 4),
            way == 0 ? "" : Number(ratio.RatioSpread(), 2),
            way == 0 ? "0" : Number(static_cast<double>(bytes) / pixels, 4),
            Number(LoadAverage(), 2) });
        }
      }
    }
  }
  return table.WriteCsv(outDir + "/deferred.csv") ? 0 : 1;
}
}

//------------------------------------------------------------------------------
int RelievoBenchDeferred(const std::string& outDir)
{
  return relievoBench::BenchDeferred(outDir, {});
}
