// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Empty-space skipping: processor time of frames of volumes of which a part is visible, VTK's own
// and with the stage empty_space, in one process, and the largest difference of the pictures. The
// shapes: one ball, 64 balls on a lattice, and the walls of a gyroid, which are everywhere.
#include "BenchSizes.h"
#include "FrameBench.h"
#include "ImageCompare.h"
#include "RelievoBench.h"
#include "Table.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;

constexpr double Pi = 3.14159265358979323846;
constexpr double Highest = 65535.0;

// How far from the shape's middle a place from 0 to 1 in the box is, in any unit.
struct Shape
{
  const char* Name;
  std::function<double(const glm::dvec3&)> Distance;
};

const Shape Shapes[] = {
  { "one ball", [](const glm::dvec3& place) { return glm::length(place - 0.5); } },
  { "64 balls",
    [](const glm::dvec3& place) { return glm::length(glm::fract(4.0 * place) - 0.5); } },
  { "gyroid",
    [](const glm::dvec3& place) {
      const glm::dvec3 s = glm::sin(6.0 * Pi * place);
      const glm::dvec3 c = glm::cos(6.0 * Pi * place);
      return std::abs(s.x * c.y + s.y * c.z + s.z * c.x);
    } },
};

// An image in which this share of the voxels is visible: the nearest to the shape's middle, from
// whose border the values rise.
void Fill(vtkImageData* image, const Shape& shape, int size, double share)
{
  image->SetDimensions(size, size, size);
  image->SetSpacing(1.0 / (size - 1), 1.0 / (size - 1), 1.0 / (size - 1));
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(size) * size * size);
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        distances.push_back(shape.Distance(glm::dvec3(i, j, k) / (size - 1.0)));
      }
    }
  }
  std::vector<double> sorted = distances;
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
  const double border = sorted[place];
  auto* to = static_cast<unsigned short*>(image->GetScalarPointer());
  for (const double distance : distances)
  {
    *to++ = static_cast<unsigned short>(
      std::lround(Highest * std::min(1.0, std::max(0.0, 1.0 - distance / border))));
  }
}

struct Window
{
  Window(vtkImageData* image, bool shaded, int pixels)
  {
    const double spacing = image->GetSpacing()[0];
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(image);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(static_cast<float>(spacing));
    mapper->UseJitteringOff();
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(Highest, 0.3);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
    color->AddRGBPoint(Highest, 0.2, 0.5, 1.0);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    vtkVolumeProperty* property = volume->GetProperty();
    property->SetScalarOpacity(opacity);
    property->SetScalarOpacityUnitDistance(1.0 / 64.0);
    property->SetColor(color);
    property->SetInterpolationTypeToLinear();
    property->SetShade(shaded);
    this->Renderer->AddVolume(volume);
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(1.0, 2.0, 3.0);
    this->Renderer->AddLight(sun);
    this->Renderer->SetBackground(0.1, 0.1, 0.1);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.5, 1.1, 2.3);
    camera->SetFocalPoint(0.5, 0.5, 0.5);
    this->Renderer->ResetCameraClippingRange();
    this->Drawn = relievoTest::MakeWindow(pixels, pixels, this->Renderer);
  }

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Drawn;
};

void Measure(const Shape& shape, int size, double share, const EmptySpaceSizes& sizes, Table& table)
{
  vtkNew<vtkImageData> image;
  Fill(image, shape, size, share);
  for (const bool shaded : { false, true })
  {
    const Window plain(image, shaded, sizes.Pixels);
    const Window skipping(image, shaded, sizes.Pixels);
    vtkRelievoStage* stage = vtkRelievoPass::Attach(skipping.Renderer)->GetStage("empty_space");
    stage->EnabledOn();
    const int difference = relievoTest::GetLargestDifference(
      relievoTest::Picture(plain.Drawn), relievoTest::Picture(skipping.Drawn));
    std::vector<relievoTest::Timing> times;
    TimeInTurn(
      { relievoTest::Frame(plain.Drawn), relievoTest::Frame(skipping.Drawn) }, sizes.Rounds, times);
    const auto pair = PairOf(times[0], times[1]);
    const std::string kind = shaded ? "shaded" : "not shaded";
    table.AddRow({ shape.Name, std::to_string(size), Number(100.0 * share), kind,
      Number(1e3 * times[0].Median()), Number(1e3 * times[1].Median()), Number(pair.Ratio()),
      Number(pair.RatioSpread(), 2), std::to_string(difference), stage->GetReasonCode() });
    std::cout << shape.Name << " of " << size << ", " << Number(100.0 * share) << " % visible, "
              << kind << ": " << Number(1e3 * times[0].Median(), 3) << " ms, skipping "
              << Number(1e3 * times[1].Median(), 3) << " ms, " << Number(pair.Ratio(), 3) << " +- "
              << Number(pair.RatioSpread(), 1) << " x as fast, " << difference << " levels"
              << std::endl;
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchEmptySpace(const std::string& outDir, const EmptySpaceSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "shape", "size", "visible %", "kind", "processor ms", "skipping ms", "times faster",
    "+-", "levels", "stage" });
  for (const int size : sizes.Sizes)
  {
    for (const Shape& shape : Shapes)
    {
      for (const double share : sizes.Shares)
      {
        Measure(shape, size, share, sizes, table);
      }
    }
  }
  return table.WriteCsv(outDir + "/empty-space.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchEmptySpace(const std::string& outDir)
{
  return relievoBench::BenchEmptySpace(outDir, {});
}
