// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of a normal map in a frame filled by its mesh, one texel per pixel: against the plain frame,
// and against VTK's own frames with a texture and with the normal map of its PBR shading.
#include "RelievoBench.h"

#include "FrameBench.h"
#include "ReliefTruth.h"
#include "Table.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataTangents.h>
#include <vtkProperty.h>
#include <vtkRelievoMaterial.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using namespace relievoTest;

constexpr int Width = 1600; // makes frames long compared with the start of their threads
constexpr int Height = 1200;
constexpr int Texels = 2048;
constexpr double ViewAngle = 30.;
constexpr int Rounds = 31;
constexpr int Fine = 256; // quads along a side of the finer mesh

// The normals of waves as unsigned integers.
template <typename ArrayT>
vtkSmartPointer<vtkImageData> AsIntegers(vtkImageData* floats, double most)
{
  vtkDataArray* values = floats->GetPointData()->GetScalars();
  vtkNew<ArrayT> integers;
  integers->SetName("normal");
  integers->SetNumberOfComponents(3);
  integers->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      integers->SetComponent(i, c, std::round((0.5 + 0.5 * values->GetComponent(i, c)) * most));
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Texels, Texels, 1);
  image->GetPointData()->SetScalars(integers);
  return image;
}

struct PlaneWindow
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRelievoMaterial> Surface;
  vtkSmartPointer<vtkRenderWindow> Window;

  PlaneWindow(int cells, bool tangents)
  {
    vtkSmartPointer<vtkPolyData> mesh = ReliefPlane(cells);
    if (tangents)
    {
      vtkNew<vtkPolyDataTangents> filter;
      filter->SetInputData(mesh);
      filter->Update();
      mesh = filter->GetOutput();
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window = MakeWindow(Width, Height, this->Renderer);
    // The plane is 2 wide: this many of its texels fill the picture's height.
    const double height = 2. * Height / Texels;
    const double angle = ViewAngle * std::acos(-1.) / 180.;
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetViewAngle(ViewAngle);
    camera->SetPosition(0., 0., 0.5 * height / std::tan(0.5 * angle));
    camera->SetFocalPoint(0., 0., 0.);
    this->Renderer->ResetCameraClippingRange();
  }
  ~PlaneWindow() { this->Surface->Detach(this->Actor); }
  void SetStyle(vtkImageData* normals)
  {
    this->Surface->SetNormalMap(normals);
    this->Surface->Attach(this->Actor);
  }
};

vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image, bool mipmaps)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetMipmap(mipmaps);
  texture->RepeatOn();
  return texture;
}

struct Drawn
{
  const char* Name;
  int Cells;
  bool Tangents;
  std::size_t Peer; // the frame without its map
  std::function<void(PlaneWindow&)> Style;
};
}

//------------------------------------------------------------------------------
int RelievoBenchNormalMaps(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  const HeightField waves = [](const glm::dvec2& uv) {
    const double turn = 16. * std::acos(-1.);
    return 0.5 + 0.02 * (std::sin(turn * uv.x) + std::sin(turn * uv.y));
  };
  const auto floats = NormalImage(waves, Texels);
  const auto bytes = AsIntegers<vtkUnsignedCharArray>(floats, 255.);
  const auto shorts = AsIntegers<vtkUnsignedShortArray>(floats, 65535.);
  const auto plain = [](PlaneWindow&) {};
  const auto style = [](vtkImageData* image) {
    return [image](PlaneWindow& window) { window.SetStyle(image); };
  };
  const auto asPBR = [](PlaneWindow& w) { w.Actor->GetProperty()->SetInterpolationToPBR(); };
  const Drawn ways[] = {
    { "two triangles", 1, false, 0, plain },
    { "colours of a VTK texture, 8 bits", 1, false, 0,
      [&](PlaneWindow& w) { w.Actor->SetTexture(MakeTexture(bytes, false)); } },
    { "colours of a VTK texture, 8 bits, mipmaps", 1, false, 0,
      [&](PlaneWindow& w) { w.Actor->SetTexture(MakeTexture(bytes, true)); } },
    { "normal map, 8 bits", 1, false, 0, style(bytes) },
    { "normal map, 16 bits", 1, false, 0, style(shorts) },
    { "normal map, float", 1, false, 0, style(floats) },
    { "normal map, 8 bits, the mesh's tangents", 1, true, 0, style(bytes) },
    { "material off", 1, false, 0,
      [&](PlaneWindow& w) {
        w.SetStyle(bytes);
        w.Surface->EnabledOff();
      } },
    { "two triangles, PBR", 1, false, 8, asPBR },
    { "PBR, VTK's own normal texture, 8 bits", 1, true, 8,
      [&](PlaneWindow& w) {
        asPBR(w);
        w.Actor->GetProperty()->SetNormalTexture(MakeTexture(bytes, true));
      } },
    { "PBR, normal map, 8 bits", 1, false, 8,
      [&](PlaneWindow& w) {
        asPBR(w);
        w.SetStyle(bytes);
      } },
    { "131 072 triangles", Fine, false, 11, plain },
    { "131 072 triangles, normal map, 8 bits", Fine, false, 11, style(bytes) },
  };
  std::vector<std::unique_ptr<PlaneWindow>> windows;
  std::vector<Timed> frames;
  for (const Drawn& way : ways)
  {
    windows.emplace_back(new PlaneWindow(way.Cells, way.Tangents));
    way.Style(*windows.back());
    frames.push_back(Frame(windows.back()->Window));
  }
  const auto times = TimeInTurn(frames, Rounds);
  Table table({ "drawn", "ms", "times the same without", "+-" });
  for (std::size_t i = 0; i < std::size(ways); ++i)
  {
    const TimingPair pair = PairOf(times[i], times[ways[i].Peer]);
    std::cout << ways[i].Name << ": " << pair.ToString("frame", "without") << std::endl;
    table.AddRow({ ways[i].Name, Number(1000. * times[i].Median(), 4), Number(pair.Ratio(), 3),
      Number(pair.RatioSpread(), 1) });
  }
  return table.WriteCsv(outDir + "/normal-maps.csv") ? 0 : 1;
}
