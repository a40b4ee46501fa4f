// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVerdicts.h"

#include "Window.h"

#include <vtkProperty.h>

#include <limits>

namespace relievoBench
{
//------------------------------------------------------------------------------
double Percent(long long part, long long all)
{
  return all > 0 ? 100. * static_cast<double>(part) / static_cast<double>(all)
                 : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
ShadowVerdicts::ShadowVerdicts(const std::string& name, vtkPolyData* mesh, const ShadowLight& light,
  int width, int height, const relievoTest::TruthImage* view)
  : Scene(MakeShadowScene(name, mesh, light))
  , Window(relievoTest::MakeWindow(width, height, this->Scene.Renderer))
{
  this->Plain = relievoTest::Picture(this->Window);
  const auto truth = this->Scene.MakeTruth();
  this->View = view ? *view : truth->Trace(relievoTest::View(this->Scene.Renderer));
  this->Truth = relievoTest::TraceShadow(*truth, this->View, this->Scene.Light);
}

//------------------------------------------------------------------------------
void ShadowVerdicts::UsePBR()
{
  for (vtkActor* actor : { this->Scene.MeshActor.Get(), this->Scene.GroundActor.Get() })
  {
    actor->GetProperty()->SetInterpolationToPBR();
  }
  this->Plain = relievoTest::Picture(this->Window);
  this->Gamma = 2.2; // the display gamma for which the shader encodes its colours
}

//------------------------------------------------------------------------------
relievoTest::ShadowErrors ShadowVerdicts::Measure(const ShadowWay& way, int mapSize)
{
  way.SetUp(this->Scene.Renderer, mapSize);
  const relievoTest::ShadowErrors errors = this->MeasureAsItIs();
  UseNoShadows(this->Window, this->Scene.Renderer);
  return errors;
}

//------------------------------------------------------------------------------
relievoTest::ShadowErrors ShadowVerdicts::MeasureAsItIs()
{
  const vtkSmartPointer<vtkImageData> picture = relievoTest::Picture(this->Window);
  return relievoTest::CompareShadow(
    this->Truth, PictureVisibility(picture, this->Plain, this->Gamma).data());
}
}
