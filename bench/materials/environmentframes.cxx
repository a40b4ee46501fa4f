// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of reflections of an environment, and of its light, in a frame filled by a plane of two
// triangles: ratios to the plain frame, drawn in turn in one process.
#include "BenchSizes.h"

#include "FrameBench.h"
#include "ReliefTruth.h"
#include "Table.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoEnvironmentIrradiance.h>
#include <vtkRelievoEnvironmentPrefilter.h>
#include <vtkRelievoMaterial.h>
#include <vtkRenderer.h>
#include <vtkTable.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using namespace relievoTest;

constexpr double ViewAngle = 30.;

// Brighter at the horizon, with waves along it.
vtkSmartPointer<vtkImageData> MakeSky(int height)
{
  vtkNew<vtkFloatArray> light;
  light->SetName("light");
  light->SetNumberOfComponents(3);
  light->SetNumberOfTuples(2 * static_cast<vtkIdType>(height) * height);
  const double turn = 2. * std::acos(-1.);
  for (vtkIdType i = 0; i < light->GetNumberOfTuples(); ++i)
  {
    const double across = static_cast<double>(i % (2 * height)) / (2 * height);
    const double up = static_cast<double>(i / (2 * height)) / height - 0.5;
    const double value = std::exp(-16. * up * up) * (1. + 0.5 * std::sin(8. * turn * across));
    light->SetTuple3(i, value, 0.9 * value, 0.5 + up);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2 * height, height, 1);
  image->GetPointData()->SetScalars(light);
  return image;
}

vtkSmartPointer<vtkRelievoEnvironment> MakeEnvironment(int height)
{
  const auto sky = MakeSky(height);
  vtkNew<vtkRelievoEnvironmentPrefilter> levels;
  levels->SetInputData(sky);
  levels->Update();
  vtkNew<vtkRelievoEnvironmentIrradiance> nine;
  nine->SetInputData(sky);
  nine->Update();
  auto environment = vtkSmartPointer<vtkRelievoEnvironment>::New();
  environment->SetImage(sky);
  environment->SetLevels(levels->GetOutput());
  environment->SetIrradiance(
    vtkDataArray::SafeDownCast(nine->GetOutput()->GetColumnByName("radiance")));
  return environment;
}

struct Way
{
  const char* Name;
  bool Attached;
  bool Enabled;
  double Roughness;
};

const Way Ways[] = {
  { "plain", false, false, 0. }, { "material off", true, false, 0. },
  { "mirror and irradiance, sharp", true, true, 0. },
  { "mirror and irradiance, roughness 0.3", true, true, 0.3 }, // between two levels
};

struct MirrorWindow
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRelievoMaterial> Surface;
  vtkSmartPointer<vtkRenderWindow> Window;

  MirrorWindow(const Way& way, vtkRelievoEnvironment* environment, int width, int height)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(ReliefPlane(1)); // 2 wide
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window = MakeWindow(width, height, this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetViewAngle(ViewAngle);
    camera->SetPosition(0., 0., 0.5 / std::tan(0.5 * ViewAngle * std::acos(-1.) / 180.));
    camera->SetFocalPoint(0., 0., 0.);
    this->Renderer->ResetCameraClippingRange();
    if (way.Attached)
    {
      this->Surface->SetEnvironment(environment);
      this->Surface->SetReflectivity(0.5);
      this->Surface->SetRoughness(way.Roughness);
      this->Surface->SetEnabled(way.Enabled);
      this->Surface->Attach(this->Actor);
    }
  }
  ~MirrorWindow() { this->Surface->Detach(this->Actor); }
};
}

//------------------------------------------------------------------------------
bool relievoBench::BenchEnvironmentFrames(const std::string& outDir, const EnvironmentSizes& sizes)
{
  const auto environment = MakeEnvironment(sizes.Sky);
  std::vector<std::unique_ptr<MirrorWindow>> windows;
  std::vector<Timed> frames;
  for (const Way& way : Ways)
  {
    windows.emplace_back(new MirrorWindow(way, environment, sizes.Width, sizes.Height));
    frames.push_back(Frame(windows.back()->Window));
  }
  const auto times = TimeInTurn(frames, sizes.Rounds);
  Table table({ "frame", "ms", "times a plain frame", "+-", "load" });
  for (std::size_t i = 0; i < std::size(Ways); ++i)
  {
    const TimingPair pair = PairOf(times[i], times[0]);
    std::cout << Ways[i].Name << ": " << pair.ToString("frame", "plain") << std::endl;
    table.AddRow({ Ways[i].Name, Number(1000. * times[i].Median(), 4), Number(pair.Ratio(), 3),
      Number(pair.RatioSpread(), 1), Number(LoadAverage(), 2) });
  }
  return table.WriteCsv(outDir + "/environment-frames.csv");
}
