// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of volumes. Optical depths towards lights: closed forms of a box, with the volume's
// matrices, clipping, cropping and units. Pictures: a ground in the shade of a ball against
// exp(-depth) at each of its pixels, and volumes in the shade of others.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "View.h"
#include "VolumeScene.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDoubleArray.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFloatArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLODProp3D.h>
#include <vtkLight.h>
#include <vtkMultiBlockVolumeMapper.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRectilinearGrid.h>
#include <vtkRelievoAntialiasStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPlacedVolume.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoVolumeExtinction.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace testVolumeShadows
{
namespace
{
using namespace volumeScene;

// The part of the way from the light to a place that lies within a box.
double GetChord(
  const Source& source, const glm::dvec3& place, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 ray = source.Positional ? place - source.Position : source.Direction;
  double first = source.Positional ? 0.0 : -1e9;
  double last = source.Positional ? 1.0 : 0.0;
  const glm::dvec3 start = source.Positional ? source.Position : place;
  for (int i = 0; i < 3; ++i)
  {
    const double a = (low[i] - start[i]) / ray[i];
    const double b = (high[i] - start[i]) / ray[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return last > first ? (last - first) * glm::length(ray) : 0.0;
}

void TestBox()
{
  Volume volume(17, Constant(0.7));
  const Source sources[] = { Sun({ 0, 0, -1 }), Sun({ 0.3, -1.0, 0.2 }), Sun({ 1, 1, 1 }),
    Lamp({ 0.5, 4.0, 0.3 }), Lamp({ 1.5, 1.2, 0.6 }), Lamp({ 0.4, 0.5, 0.6 }) };
  const glm::dvec3 places[] = { { 0.5, 0.5, 0.5 }, { 0.31, 0.62, 0.27 }, { 0.5, -0.4, 0.45 },
    { 0.5, 0.45, -3.0 }, { 0.6, 2.0, 0.5 }, { 3.0, 3.0, 2.8 } };
  double worst = 0.0;
  for (const Source& source : sources)
  {
    for (const glm::dvec3& place : places)
    {
      const double chord = GetChord(source, place, glm::dvec3(0.0), glm::dvec3(1.0));
      // A ray near an edge of the box is interpolated with one past it.
      double around = 0.0;
      for (const double off : { -0.1, 0.1 })
      {
        for (int i = 0; i < 3; ++i)
        {
          glm::dvec3 other = place;
          other[i] += off;
          around = std::max(
            around, std::abs(GetChord(source, other, glm::dvec3(0.0), glm::dvec3(1.0)) - chord));
        }
      }
      if (around < 0.3)
      {
        worst = relievoTest::Larger(
          worst, std::abs(std::exp(-volume.GetDepth(source, place)) - std::exp(-Sigma * chord)));
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 8e-3, "a box: transmittance");
  const Source down = Sun({ 0, 0, -1 });
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 0.5, 0.5, -2.0 }), Sigma, 1e-5, "a box, whole");
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 0.5, 0.5, 0.25 }), 0.75 * Sigma, 1e-5, "a box, part");
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 0.5, 0.5, 2.0 }), 0.0, 0.0, "before a box");
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 1.1, 0.5, -2.0 }), 0.0, 0.0, "beside a box");

  vtkVolumeProperty* property = volume.Prop->GetProperty();
  for (const double unit : { 1e-3, 1e3 })
  {
    property->SetScalarOpacityUnitDistance(unit);
    RELIEVO_CHECK_NEAR(unit * volume.GetDepth(down, { 0.5, 0.5, -2.0 }), Sigma, 1e-5,
      "a unit distance of " + std::to_string(unit));
  }
  property->SetScalarOpacityUnitDistance(1.0);

  // Lengths count in the volume's own coordinates, whatever its matrix.
  volume.Prop->SetScale(2.0, 2.0, 2.0);
  volume.Prop->RotateX(90.0);
  volume.Prop->SetPosition(1e5, 0.0, 0.0);
  RELIEVO_CHECK_NEAR(
    volume.GetDepth(Sun({ 0, 1, 0 }), { 1e5 + 1.0, 5.0, 1.0 }), Sigma, 1e-4, "a matrix");
  volume.Prop->SetScale(1.0, 1.0, 1.0);
  volume.Prop->SetOrientation(0.0, 0.0, 0.0);
  volume.Prop->SetPosition(0.0, 0.0, 0.0);
  volume.Image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { -0.5, 0.5, -2.0 }), Sigma, 1e-5, "a direction matrix");
  volume.Image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.4);
  plane->SetNormal(0.0, 0.0, 1.0);
  volume.Mapper->AddClippingPlane(plane);
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 0.5, 0.5, -2.0 }), 0.6 * Sigma, 1e-5, "clipped");
  volume.Mapper->RemoveAllClippingPlanes();
  volume.Mapper->CroppingOn();
  volume.Mapper->SetCroppingRegionFlagsToSubVolume();
  volume.Mapper->SetCroppingRegionPlanes(0.0, 1.0, 0.0, 1.0, 0.25, 0.5);
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, { 0.5, 0.5, -2.0 }), 0.25 * Sigma, 1e-5, "cropped");
}

// Rays in double: a box, a ramp whose opacity function bends within a voxel, and a step.
void TestExact()
{
  Volume box(17, Constant(0.7));
  const Source oblique = Sun({ 0.3, -1.0, 0.2 });
  const Source lamp = Lamp({ 0.4, 0.5, 0.6 });
  for (const glm::dvec3& place :
    { glm::dvec3(0.31, 0.62, 0.27), glm::dvec3(0.6, -0.4, 0.55), glm::dvec3(2.0, 0.5, 0.4) })
  {
    for (const Source& source : { oblique, lamp })
    {
      const double chord = GetChord(source, place, glm::dvec3(0.0), glm::dvec3(1.0));
      RELIEVO_CHECK_NEAR(box.GetExact(source, place), Sigma * chord, 1e-7, "a box in double");
    }
  }
  // Opacities bend in the middle of a voxel: the extinction is -log(1 - f(z)).
  Volume bent(4, [](const glm::dvec3& place) { return place.z; });
  bent.Opacity->RemoveAllPoints();
  bent.Opacity->AddPoint(0.0, 0.0);
  bent.Opacity->AddPoint(0.5, 0.8);
  bent.Opacity->AddPoint(1.0, 0.0);
  // Twice the integral of -log(1 - 1.6 z) up to 0.5: -(q log q - q) / 1.6 at q = 0.2 and 1.
  const double half = ((0.2 * std::log(0.2) - 0.2) + 1.0) / 1.6;
  RELIEVO_CHECK_NEAR(
    bent.GetExact(Sun({ 0, 0, -1 }), { 0.5, 0.5, -1.0 }), 2.0 * half, 2e-5, "a bent function");
  bent.Prop->GetProperty()->SetInterpolationTypeToNearest();
  RELIEVO_CHECK_NEAR(bent.GetExact(Sun({ 0, 0, -1 }), { 0.5, 0.5, -1.0 }),
    -2.0 / 3.0 * std::log(1.0 - 1.6 / 3.0), 1e-7, "steps of voxels");
}

// Masks, blanked points and cells, and independent components.
void TestCut()
{
  const Source down = Sun({ 0, 0, -1 });
  const glm::dvec3 below(0.5625, 0.5625, -1.0); // in the middle of cells
  Volume volume(9, Constant(0.7));              // eight cells, each of depth Sigma / 8
  const auto check = [&](double share, double slack, const std::string& what) {
    RELIEVO_CHECK_NEAR(volume.GetExact(down, below), share * Sigma, 1e-6, what + ", in double");
    RELIEVO_CHECK_NEAR(volume.GetDepth(down, below), share * Sigma, slack, what);
  };
  // A sample has the half cells around it.
  if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(volume.Mapper))
  {
    vtkNew<vtkImageData> mask;
    mask->SetDimensions(9, 9, 9);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 729; ++i)
    {
      static_cast<unsigned char*>(mask->GetScalarPointer())[i] = i / 81 < 3 ? 255 : 0;
    }
    gpu->SetMaskInput(mask);
    gpu->SetMaskTypeToBinary();
    check(2.5 / 8.0, 0.07 * Sigma, "a mask");
    gpu->SetMaskTypeToLabelMap();
    std::string why;
    RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why).empty());
    RELIEVO_CHECK(why.find("its mask is a label map") == 0);
    mask->SetDimensions(3, 9, 9);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    gpu->SetMaskTypeToBinary();
    RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why).empty());
    RELIEVO_CHECK(why.find("its mask and its image") == 0);
    gpu->SetMaskInput(nullptr);
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(729);
  ghosts->Fill(0);
  ghosts->SetValue(4 + 9 * (4 + 9 * 2), vtkDataSetAttributes::HIDDENPOINT);
  volume.Image->GetPointData()->AddArray(ghosts);
  check(6.0 / 8.0, 1e-5, "a blanked point");
  volume.Image->GetPointData()->RemoveArray(ghosts->GetName());
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName(vtkDataSetAttributes::GhostArrayName());
  cells->SetNumberOfValues(512);
  cells->Fill(0);
  cells->SetValue(4 + 8 * (4 + 8 * 2), vtkDataSetAttributes::HIDDENCELL);
  volume.Image->GetCellData()->AddArray(cells);
  check(7.0 / 8.0, 0.07 * Sigma, "a blanked cell");
  volume.Image->GetCellData()->RemoveArray(cells->GetName());

  // Extinctions s and t of weights v and w are VTK's (s^2 + t^2) / (v s + w t) for small steps.
  volume.Image->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  auto* values = static_cast<unsigned char*>(volume.Image->GetScalarPointer());
  for (int i = 0; i < 729; ++i)
  {
    values[2 * i] = i % 2 ? 51 : 50; // a range
    values[2 * i + 1] = i % 2 ? 102 : 101;
  }
  vtkVolumeProperty* property = volume.Prop->GetProperty();
  property->IndependentComponentsOn();
  const double first = 0.5;
  const double second = 1.5;
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 1.0 - std::exp(i ? -second : -first));
    property->SetScalarOpacity(i, opacity);
  }
  property->SetComponentWeight(1, 0.5);
  const double both = (first * first + second * second) / (first + 0.5 * second);
  RELIEVO_CHECK_NEAR(volume.GetExact(down, below), both, 1e-6, "two components, in double");
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, below), both, 1e-4, "two components");
  property->SetComponentWeight(1, 0.0);
  RELIEVO_CHECK_NEAR(volume.GetDepth(down, below), first, 1e-4, "one that weighs nothing");
}

// Anisotropic voxels, direction matrices, scalar types, thin and opaque extremes: closed forms.
void TestHard()
{
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_INT, VTK_LONG_LONG, VTK_DOUBLE })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 33, 9);
    image->SetSpacing(0.5, 0.03, 0.4);
    image->SetOrigin(1e5, -2e5, 3e5);
    const double turn[9] = { 0.8, 0.0, 0.6, 0.36, 0.8, -0.48, -0.48, 0.6, 0.64 };
    image->SetDirectionMatrix(turn);
    image->AllocateScalars(type, 1);
    for (int i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      image->GetPointData()->GetScalars()->SetTuple1(i, i % 3 ? 100.0 : 20.0);
    }
    Volume volume(2, Constant(0.7));
    volume.Mapper->SetInputData(image);
    volume.Opacity->RemoveAllPoints();
    volume.Opacity->AddPoint(20.0, 0.7);
    volume.Opacity->AddPoint(100.0, 0.7);
    // Along the image's second axis, through its middle.
    const glm::dvec3 axis(turn[1], turn[4], turn[7]);
    const glm::dvec3 middle = glm::dvec3(1e5, -2e5, 3e5) +
      0.5 * glm::dvec3(turn[0], turn[3], turn[6]) + 0.48 * axis +
      1.6 * glm::dvec3(turn[2], turn[5], turn[8]);
    const std::string what = "type " + std::to_string(type);
    const Source source = Sun(axis);
    RELIEVO_CHECK_NEAR(
      volume.GetExact(source, middle + 2.0 * axis), 0.96 * Sigma, 1e-6, what + ", in double");
    RELIEVO_CHECK_NEAR(volume.GetDepth(source, middle + 2.0 * axis), 0.96 * Sigma, 1e-3, what);
    RELIEVO_CHECK_NEAR(volume.GetDepth(source, middle), 0.48 * Sigma, 2e-2, what + ", half of it");
    for (const double unit : { 1e-3, 1e3 })
    {
      volume.Prop->GetProperty()->SetScalarOpacityUnitDistance(unit);
      RELIEVO_CHECK_NEAR(unit * volume.GetExact(source, middle + 2.0 * axis), 0.96 * Sigma, 1e-6,
        what + ", another unit distance");
    }
  }
}

// Values of 8 bits have the opacities by which VTK draws them, where the function is steep: the
// light that passes is the white background behind a black volume, in VTK's own picture.
void TestBytes()
{
  constexpr float step = 1.f / 256.f;
  vtkNew<vtkFixedPointVolumeRayCastMapper> fixed; // draws on the processor
  fixed->AutoAdjustSampleDistancesOff();
  fixed->SetSampleDistance(step);
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetRequestedRenderModeToRayCast();
  smart->AutoAdjustSampleDistancesOff();
  smart->SetSampleDistance(step);
  const struct
  {
    int Type;
    double Value;
    vtkVolumeMapper* Mapper;
  } kinds[] = { { VTK_UNSIGNED_CHAR, 128.0, nullptr }, { VTK_SIGNED_CHAR, 100.0, nullptr },
    { VTK_SIGNED_CHAR, -100.0, nullptr }, { VTK_UNSIGNED_CHAR, 128.0, fixed },
    { VTK_UNSIGNED_CHAR, 128.0, smart } };
  for (const auto& kind : kinds)
  {
    const double value = kind.Value;
    // A range with the value in its middle, where VTK's table has no offset of half an entry.
    const auto scalars = [=](const glm::dvec3& place) {
      const double corner = place.x + place.y + place.z;
      return value + (corner == 0.0 ? -20.0 : corner == 3.0 ? 20.0 : 0.0);
    };
    Volume volume(17, scalars, 1.0, kind.Type);
    volume.Mapper->SetSampleDistance(step);
    if (kind.Mapper)
    {
      kind.Mapper->SetInputDataObject(volume.Image);
      volume.Prop->SetMapper(kind.Mapper);
    }
    volume.Opacity->RemoveAllPoints();
    volume.Opacity->AddPoint(value - 1.0, 0.0);
    volume.Opacity->AddPoint(value + 1.0, 0.9);
    vtkNew<vtkColorTransferFunction> black;
    black->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    volume.Prop->GetProperty()->SetColor(black);
    ShadowStage stage(64, 64);
    stage.Renderer->AddVolume(volume.Prop);
    stage.Renderer->SetBackground(1.0, 1.0, 1.0);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetPosition(0.5, 0.5, 4.0);
    camera->SetFocalPoint(0.5, 0.5, 0.0);
    camera->SetClippingRange(1.0, 10.0);
    const double drawn =
      relievoTest::Picture(stage.Window)->GetScalarComponentAsDouble(32, 32, 0, 0) / 255.0;
    const Source source = Sun({ 0, 0, -1 });
    const glm::dvec3 behind(0.51, 0.51, -1.0);
    const std::string what =
      "bytes of " + std::to_string(value) + ", " + volume.Prop->GetMapper()->GetClassName();
    RELIEVO_CHECK_NEAR(std::exp(-volume.GetDepth(source, behind)), drawn, 0.01, what);
    RELIEVO_CHECK_NEAR(
      std::exp(-volume.GetExact(source, behind)), drawn, 0.01, what + ", in double");
  }
}

// The length and one component of vectors, which VTK selects only when it draws; and volumes that
// VTK leaves out.
void TestVectors()
{
  Volume volume(3, Constant(0.0));
  volume.Image->AllocateScalars(VTK_FLOAT, 3);
  for (int i = 0; i < 27; ++i)
  {
    const double range = i == 0 ? 0.0 : i == 26 ? 2.0 : 1.0; // of two corners beside the ray
    volume.Image->GetPointData()->GetScalars()->SetTuple3(i, 0.3 * range, 0.4 * range, 0.0);
  }
  const Source down = Sun({ 0, 0, -1 });
  const glm::dvec3 below(0.25, 0.75, -1.0);
  vtkNew<vtkSmartVolumeMapper> smart;
  vtkNew<vtkMultiBlockVolumeMapper> blocks;
  for (vtkVolumeMapper* mapper :
    { static_cast<vtkVolumeMapper*>(smart.Get()), static_cast<vtkVolumeMapper*>(blocks.Get()) })
  {
    mapper->SetInputDataObject(volume.Image);
    volume.Prop->SetMapper(mapper);
    for (const int component : { -1, 0, 1 })
    {
      const int mode =
        component < 0 ? vtkSmartVolumeMapper::MAGNITUDE : vtkSmartVolumeMapper::COMPONENT;
      smart->SetVectorMode(mode);
      smart->SetVectorComponent(std::max(component, 0));
      blocks->SetVectorMode(mode);
      blocks->SetVectorComponent(std::max(component, 0));
      const double opacity = component < 0 ? 0.5 : component == 0 ? 0.3 : 0.4;
      const std::string what =
        std::string(mapper->GetClassName()) + ", component " + std::to_string(component);
      RELIEVO_CHECK_NEAR(
        std::exp(-volume.GetExact(down, below)), 1.0 - opacity, 1e-5, what + ", in double");
      RELIEVO_CHECK_NEAR(std::exp(-volume.GetDepth(down, below)), 1.0 - opacity, 1e-3, what);
    }
  }
  std::string why;
  volume.Prop->GetProperty()->IndependentComponentsOff();
  volume.Image->AllocateScalars(VTK_FLOAT, 1);
  RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why).empty());
  RELIEVO_CHECK_THAT(why.find("of which VTK draws only 2 or 4") != std::string::npos, why);
  volume.Prop->GetProperty()->IndependentComponentsOn();
  volume.Prop->SetMapper(smart);
  smart->SetRequestedRenderModeToRayCast();
  volume.Image->AllocateScalars(VTK_FLOAT, 2);
  RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why).empty());
  RELIEVO_CHECK_THAT(why.find("several components, on the processor") != std::string::npos, why);
}

// Whatever is not traced is named; NaN lets light pass.
void TestRefused()
{
  Volume volume(9, Constant(0.5), 1.0, VTK_DOUBLE);
  volume.Image->SetScalarComponentFromDouble(4, 4, 4, 0, std::nan(""));
  RELIEVO_CHECK(volume.GetDepth(Sun({ 0, 0, -1 }), { 0.5, 0.5, -1.0 }) < std::log(2.0));
  const auto why = [&]() {
    std::string reason;
    RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), reason).empty());
    return reason;
  };
  volume.Mapper->SetBlendModeToMaximumIntensity();
  RELIEVO_CHECK(why() == "its blend mode is not composite");
  volume.Mapper->SetBlendModeToComposite();
  vtkNew<vtkPiecewiseFunction> none;
  none->AddPoint(0.0, 0.0);
  volume.Prop->GetProperty()->SetScalarOpacity(none);
  RELIEVO_CHECK(why().empty());

  // Neither does anything cast that VTK does not draw.
  if (volume.Mapper->IsA("vtkGPUVolumeRayCastMapper"))
  {
    Volume mirrored(9, Constant(0.5));
    mirrored.Image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, -1);
    Volume chars(9, Constant(0.0), 1.0, VTK_CHAR);
    for (const auto& each : { std::make_pair(&mirrored, "left-handed axes"),
           std::make_pair(&chars, "VTK does not draw values of VTK_CHAR") })
    {
      std::string reason;
      RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(each.first->Prop.Get(), reason).empty());
      RELIEVO_CHECK_THAT(reason.find(each.second) != std::string::npos, reason);
      // A mapper that draws on the GPU inside leaves the same out, on the processor nothing.
      vtkNew<vtkSmartVolumeMapper> smart;
      smart->SetInputDataObject(each.first->Image);
      each.first->Prop->SetMapper(smart);
      RELIEVO_CHECK(vtkRelievoVolumeExtinction::Collect(each.first->Prop.Get(), reason).empty());
      RELIEVO_CHECK_THAT(reason.find(each.second) != std::string::npos, reason);
      each.first->Opacity->AddPoint(0.0, 0.5);
      smart->SetRequestedRenderModeToRayCast();
      RELIEVO_CHECK(!vtkRelievoVolumeExtinction::Collect(each.first->Prop.Get(), reason).empty());
      RELIEVO_CHECK_THAT(reason.empty(), reason);
    }
  }

  RELIEVO_CHECK(vtkRelievoPlacedVolume::FindWhyNotPlaced(volume.Prop).empty());
  // Shaders have no one matrix from its texture to the world.
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(3, 3, 3);
  vtkNew<vtkDoubleArray> places;
  for (const double place : { 0.0, 0.2, 1.0 })
  {
    places->InsertNextValue(place);
  }
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfValues(27);
  scalars->Fill(0.5);
  grid->GetPointData()->SetScalars(scalars);
  volume.Mapper->SetInputDataObject(grid);
  RELIEVO_CHECK(
    vtkRelievoPlacedVolume::FindWhyNotPlaced(volume.Prop) == "its data are not a vtkImageData");
  RELIEVO_CHECK(why() == "its data are not a vtkImageData");
}

// The depth of the ball of TestGround, of radius 0.6, between a light and a place: the integral of
// 3 (1 - r^2 / 0.36) along the ray.
double GetBallDepth(const Source& source, const glm::dvec3& place)
{
  const glm::dvec3 way =
    source.Positional ? glm::normalize(place - source.Position) : source.Direction;
  const glm::dvec3 start =
    (source.Positional ? source.Position : place - 20.0 * way) - glm::dvec3(0.0, 1.3, 0.0);
  const double along = glm::dot(start, way);
  const double rest = 0.36 - glm::dot(start, start);
  const double half2 = along * along + rest;
  if (half2 <= 0.0)
  {
    return 0.0;
  }
  const auto integral = [&](double t) {
    return 3.0 / 0.36 * (rest * t - along * t * t - t * t * t / 3.0);
  };
  const double first = std::max(0.0, -along - std::sqrt(half2));
  const double last = std::max(first, -along + std::sqrt(half2));
  return integral(last) - integral(first);
}

// A ball of cloud above the ground, with a lamp, a sun, or a light in its middle.
void TestGround()
{
  struct
  {
    const char* Name;
    int Method;
    bool Positional;
    glm::dvec3 Place;
    double ConeAngle;
  } const lights[] = {
    { "a sun", vtkRelievoShadowStage::METHOD_MAP, false, { 1.0, 3.0, 1.5 }, 0.0 },
    { "a lamp", vtkRelievoShadowStage::METHOD_FORWARD, true, { 1.0, 3.0, 0.5 }, 60.0 },
    { "a lamp, warped", vtkRelievoShadowStage::METHOD_WARPED, true, { 1.0, 3.0, 0.5 }, 60.0 },
    { "a light within", vtkRelievoShadowStage::METHOD_MAP, true, { 0.1, 1.35, -0.05 }, 180.0 },
    { "one traced", vtkRelievoShadowStage::METHOD_EXACT, true, { 0.1, 1.35, -0.05 }, 180.0 },
  };
  for (const auto& each : lights)
  {
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.AddGround();
    stage.Renderer->GetActiveCamera()->SetPosition(0.0, 5.0, 5.0);
    stage.Renderer->ResetCameraClippingRange();
    Volume volume(
      65,
      [](const glm::dvec3& place) {
        const glm::dvec3 off = 2.0 * place - 1.0;
        return 1.0 - std::exp(-3.0 * std::max(0.0, 1.0 - glm::dot(off, off)));
      },
      1.2);
    volume.Prop->SetPosition(-0.6, 0.7, -0.6);
    stage.Renderer->AddVolume(volume.Prop);
    const auto light = each.Positional
      ? stage.AddLamp(each.Place, { 0.0, 0.0, 0.0 }, each.ConeAngle)
      : stage.AddSun(each.Place.x, each.Place.y, each.Place.z);
    vtkRelievoShadowStage* shadows = stage.GetShadows();
    shadows->SetMethod(each.Method);
    const auto layer = relievoTest::CaptureShadow(stage, 0);
    const relievoTest::View view(stage.Renderer);
    const Source source = each.Positional ? Lamp(each.Place) : Sun(-each.Place);
    double squares = 0.0;
    double worst = 0.0;
    long long dimmed = 0;
    vtkDataArray* values = layer->GetPointData()->GetArray("shadow_0");
    for (int y = 0; values && y < 180; ++y)
    {
      for (int x = 0; x < 240; ++x)
      {
        const relievoTest::Ray ray = view.PixelRay(x + 0.5, y + 0.5);
        const glm::dvec3 place = ray.At(-ray.Origin.y / ray.Direction.y);
        if (std::max(std::abs(place.x), std::abs(place.z)) > 2.9)
        {
          continue;
        }
        const double depth = GetBallDepth(source, place);
        const double error =
          values->GetTuple1(static_cast<vtkIdType>(y) * 240 + x) - std::exp(-depth);
        dimmed += depth > 0.0 ? 1 : 0;
        squares += depth > 0.0 ? error * error : 0.0;
        worst = relievoTest::Larger(worst, std::abs(error));
      }
    }
    const std::string what = std::string("the shadow of a ball by ") + each.Name;
    RELIEVO_CHECK_THAT(dimmed > 500, what + ": " + std::to_string(dimmed) + " pixels");
    RELIEVO_CHECK_AT_MOST(std::sqrt(squares / dimmed), 1.0 / 255.0, what + ": rms");
    RELIEVO_CHECK_AT_MOST(worst, 0.02, what + ": worst");
    RELIEVO_CHECK(shadows->GetBytesHeld() > 0);

    // Depths are computed again only after a change.
    const auto isMade = [&](const std::string& number) {
      stage.Window->Render();
      return shadows->GetReason().find(", " + number + " made anew") != std::string::npos;
    };
    const vtkIdType bytes = shadows->GetBytesHeld();
    shadows->EnabledOn();
    stage.Window->Render();
    RELIEVO_CHECK(isMade("0"));
    light->SetPosition(1.1, 3.0, 1.5);
    RELIEVO_CHECK(isMade("1"));
    if (each.Method == vtkRelievoShadowStage::METHOD_MAP) // all methods ask the same grids
    {
      stage.Renderer->GetActiveCamera()->Azimuth(1.0);
      RELIEVO_CHECK(isMade("0"));
      volume.Prop->GetProperty()->SetAmbient(0.3);
      volume.Prop->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.5, 1.0, 0.0, 0.0);
      RELIEVO_CHECK(isMade("0"));
      volume.Opacity->AddPoint(0.5, 0.4);
      RELIEVO_CHECK(isMade("1"));
      volume.Image->Modified();
      RELIEVO_CHECK(isMade("1"));
      volume.Prop->AddPosition(0.1, 0.0, 0.0);
      RELIEVO_CHECK(isMade("1"));
      RELIEVO_CHECK(isMade("0"));
    }

    // Chosen not to cast, it changes nothing; nor does it hold anything.
    shadows->EnabledOff();
    shadows->SetPropCasts(volume.Prop, vtkRelievoShadowStage::CASTS_NEVER);
    const relievoTest::Layers lit(relievoTest::CaptureShadow(stage, 0));
    double darkest = 1.0;
    for (int i = 0; i < 240 * 180; ++i)
    {
      darkest = std::min(darkest, lit.Value("shadow_0", i % 240, i / 240));
    }
    RELIEVO_CHECK_NEAR(darkest, 1.0, 0.0, what + ": casts nothing");
    RELIEVO_CHECK(shadows->GetBytesHeld() < bytes);
  }
}

// The layer's value at the pixel of a place.
double GetShadow(ShadowStage& stage, double x, double z, double y = 0.0)
{
  const relievoTest::Layers layer(relievoTest::CaptureShadow(stage, 0));
  glm::dvec2 pixel;
  RELIEVO_CHECK(relievoTest::View(stage.Renderer).Project({ x, y, z }, pixel));
  return layer.Value("shadow_0", static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

// VTK weights components only if there are several.
void TestWeight()
{
  Volume volume(9, Constant(0.5));
  const double depth = volume.GetExact(Sun({ 0, 0, -1 }), { 0.5, 0.5, -1.0 });
  RELIEVO_CHECK(depth > 0.5);
  volume.Prop->GetProperty()->SetComponentWeight(0, 0.0);
  RELIEVO_CHECK_NEAR(volume.GetExact(Sun({ 0, 0, -1 }), { 0.5, 0.5, -1.0 }), depth, 0.0,
    "the weight of the only component");
}

// Light through a coloured volume has colour^depth, besides exp(-depth); the layer has no colours.
void TestColored()
{
  for (const int method :
    { vtkRelievoShadowStage::METHOD_MAP, vtkRelievoShadowStage::METHOD_EXACT })
  {
    ZenithStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    vtkActor* ground = stage.Renderer->GetActors()->GetLastActor();
    ground->GetProperty()->SetColor(1.0, 1.0, 1.0);
    ground->GetProperty()->SetDiffuse(0.8);
    ground->GetProperty()->SetAmbient(0.0);
    ground->GetProperty()->SetSpecular(0.0);
    Volume volume(9, Constant(0.7));
    vtkNew<vtkColorTransferFunction> color;
    const glm::dvec3 glass(1.0, 0.5, 0.25);
    color->AddRGBPoint(0.0, glass.x, glass.y, glass.z);
    volume.Prop->GetProperty()->SetColor(color);
    volume.Prop->GetProperty()->SetScalarOpacityUnitDistance(2.0);
    volume.Prop->SetPosition(-0.5, 0.5, -0.5);
    volume.Prop->SetScale(1.0, 0.5, 1.0);
    stage.Renderer->AddVolume(volume.Prop);
    stage.Renderer->GetActiveCamera()->SetPosition(0.0, 8.0, 2.5);
    stage.Renderer->ResetCameraClippingRange();
    vtkRelievoShadowStage* shadows = stage.GetShadows();
    shadows->SetMethod(method);
    shadows->SetVolumeHarmonics(method == vtkRelievoShadowStage::METHOD_MAP ? 0 : 7);
    shadows->SetStrength(1.0);
    const double depth = 0.5 * Sigma; // lengths count in the volume's coordinates
    // Seen beside the volume.
    const glm::dvec3 place(0.1, 0.0, -0.45);
    RELIEVO_CHECK_NEAR(
      GetShadow(stage, place.x, place.z), std::exp(-depth), 2e-3, "the layer of a coloured volume");
    glm::dvec2 pixel;
    RELIEVO_CHECK(relievoTest::View(stage.Renderer).Project(place, pixel));
    const auto getColor = [&](bool on) {
      shadows->SetEnabled(on);
      volume.Prop->SetVisibility(on);
      glm::dvec3 found;
      const auto picture = relievoTest::Picture(stage.Window);
      for (int i = 0; i < 3; ++i)
      {
        found[i] = picture->GetScalarComponentAsDouble(
          static_cast<int>(pixel.x), static_cast<int>(pixel.y), 0, i);
      }
      return found;
    };
    const glm::dvec3 lit = getColor(false);
    RELIEVO_CHECK(lit.x > 100.0);
    // The camera sees the ground through the volume: by light of each colour, in front of it.
    stage.Renderer->GetActiveCamera()->SetPosition(0.0, 0.35, 4.0);
    stage.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    stage.Renderer->ResetCameraClippingRange();
    RELIEVO_CHECK(relievoTest::View(stage.Renderer).Project(place, pixel));
    const glm::dvec3 grey = getColor(true) / lit;
    shadows->ColoredShadowsOn();
    const glm::dvec3 tinted = getColor(true) / lit;
    for (int i = 0; i < 3; ++i)
    {
      RELIEVO_CHECK_NEAR(grey[i], std::exp(-depth), 0.01, "light without colours");
      RELIEVO_CHECK_NEAR(tinted[i], std::exp(-depth) * std::pow(glass[i], depth), 0.01,
        "coloured light, channel " + std::to_string(i));
    }
  }
}

// Depths too large for the texture's half floats.
void TestSteep()
{
  ZenithStage stage;
  const relievoTest::GLCheck gl(stage.Window);
  Volume volume(9, Constant(0.7));
  volume.Prop->SetPosition(-0.5, 0.5, -0.5);
  volume.Prop->GetProperty()->SetScalarOpacityUnitDistance(1e-6);
  stage.Renderer->AddVolume(volume.Prop);
  RELIEVO_CHECK_NEAR(GetShadow(stage, 0.1, 0.2), 0.0, 1e-6, "below a wall of fog");
  RELIEVO_CHECK_NEAR(GetShadow(stage, 1.5, 0.2), 1.0, 0.0, "beside a wall of fog");
  stage.AddBox({ 0.1, 1.9, 0.2 }, { 0.4, 0.2, 0.4 });
  stage.Renderer->ResetCameraClippingRange();
  RELIEVO_CHECK_NEAR(GetShadow(stage, 0.1, 0.2, 2.0), 1.0, 0.0, "above a wall of fog");
}

// Each volume of a prop counts where VTK draws it, and once.
void TestProps()
{
  ZenithStage stage;
  Volume volume(9, Constant(0.7));
  vtkNew<vtkLODProp3D> levels;
  const int first = levels->AddLOD(volume.Mapper, volume.Prop->GetProperty(), 0.0);
  levels->AddLOD(volume.Mapper, volume.Prop->GetProperty(), 0.0);
  levels->SetPosition(-0.5, 0.5, -0.5);
  levels->AutomaticLODSelectionOff();
  levels->SetSelectedLODID(first);
  stage.Renderer->AddViewProp(levels);
  RELIEVO_CHECK_NEAR(GetShadow(stage, 0.1, 0.2), 0.3, 2e-3, "levels of detail");
  stage.Renderer->RemoveViewProp(levels);

  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(volume.Prop);
  assembly->SetPosition(0.8, 0.5, -0.5);
  stage.Renderer->AddViewProp(assembly);
  RELIEVO_CHECK_NEAR(GetShadow(stage, 1.3, 0.2), 0.3, 2e-3, "in an assembly");
  RELIEVO_CHECK_NEAR(GetShadow(stage, 0.4, 0.2), 1.0, 0.0, "beside an assembly");
}

// Without anything that receives nothing is computed.
void TestNoReceivers()
{
  ShadowStage stage;
  Volume volume(9, Constant(0.7));
  stage.Renderer->AddVolume(volume.Prop);
  stage.AddSun(0.0, 1.0, 0.0);
  const auto has = [&](const std::string& words) {
    stage.GetShadows()->EnabledOn();
    stage.Window->Render();
    return stage.GetShadows()->GetReason().find(words) != std::string::npos;
  };
  RELIEVO_CHECK(!has("depths of volumes"));
  RELIEVO_CHECK(has("a volume receives none: it is not shaded"));
  volume.Prop->GetProperty()->ShadeOn();
  RELIEVO_CHECK(has("depths of volumes"));

  // CPU mappers have no shaders.
  vtkNew<vtkFixedPointVolumeRayCastMapper> processor;
  processor->SetInputData(volume.Image);
  volume.Prop->SetMapper(processor);
  RELIEVO_CHECK(has("a volume receives none: its mapper draws on the processor"));
  RELIEVO_CHECK(!has("depths of volumes"));
}

// The half shadow of a thin plate of cloud below a sun with a size: the covered share of its disc.
void TestSoft()
{
  ShadowStage stage;
  const relievoTest::GLCheck gl(stage.Window);
  stage.AddGround();
  stage.Renderer->GetActiveCamera()->SetPosition(0.0, 8.0, 0.1);
  stage.Renderer->ResetCameraClippingRange();
  Volume plate(17, Constant(0.7));
  plate.Prop->SetScale(4.0, 0.1, 4.0);
  plate.Prop->SetPosition(-4.0, 1.0, -2.0); // its border is at x = 0
  plate.Prop->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  stage.Renderer->AddVolume(plate.Prop);
  stage.AddSun(0.0, 1.0, 0.0);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->SetSunAngle(40.0);
  shadows->SetSoftSamples(4);
  shadows->SoftAtOnceOn();
  const relievoTest::Layers layer(relievoTest::CaptureShadow(stage, 0));
  const relievoTest::View view(stage.Renderer);
  const double radius = 1.05 * std::tan(20.0 * 3.14159265358979 / 180.0);
  const double passes = std::exp(-2.0 * Sigma);
  double worst = 0.0;
  for (int x = 0; x < 240; ++x)
  {
    const relievoTest::Ray ray = view.PixelRay(x + 0.5, 90.5);
    const double place = ray.At(-ray.Origin.y / ray.Direction.y).x;
    if (std::abs(place) < 1.0)
    {
      const double t = std::min(1.0, std::max(-1.0, place / radius));
      const double free = 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / 3.14159265358979;
      worst = relievoTest::Larger(
        worst, std::abs(layer.Value("shadow_0", x, 90) - (passes + (1.0 - passes) * free)));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 0.12, "a half shadow");
}

// The picture of such a half shadow, whose pixels' samples have a part of the disc each.
void TestSoftParts()
{
  ShadowStage stage;
  const auto ground = stage.AddGround();
  ground->GetProperty()->SetAmbient(0.0);
  ground->GetProperty()->SetSpecular(0.0);
  ground->GetProperty()->SetDiffuse(0.9);
  ground->GetProperty()->SetColor(1.0, 1.0, 1.0);
  stage.Renderer->GetActiveCamera()->SetPosition(3.0, 0.75, 0.0); // the plate is out of view
  stage.Renderer->ResetCameraClippingRange();
  Volume plate(17, Constant(0.7));
  plate.Prop->SetScale(1.0, 0.1, 1.0);
  plate.Prop->SetPosition(-1.0, 3.0, -0.5);
  plate.Prop->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  stage.Renderer->AddVolume(plate.Prop);
  stage.AddSun(0.0, 1.0, 0.0);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->EnabledOn();
  shadows->SetSunAngle(10.0);
  shadows->SetSoftSamples(24);
  shadows->SetSoftMaps(4);
  vtkNew<vtkRelievoAntialiasStage> antialias;
  antialias->SetSamples(24);
  stage.GetFrame()->AddStage(antialias);
  stage.GetFrame()->WaitForSamplesOn();
  const auto picture = relievoTest::Picture(stage.Window);
  RELIEVO_CHECK_THAT(
    shadows->GetReason().find("parts of each sun") != std::string::npos, shadows->GetReason());
  const double white = relievoTest::LinearFromSrgb(std::round(0.9 * 255.0) / 255.0);
  const double radius = 3.05 * std::tan(5.0 * 3.14159265358979 / 180.0);
  // VTK's light is in the values that displays show; means are linear.
  const double passes = relievoTest::LinearFromSrgb(0.9 * std::exp(-2.0 * Sigma)) / white;
  const relievoTest::View view(stage.Renderer);
  double squares = 0.0;
  double mean = 0.0;
  int count = 0;
  for (int y = 0; y < 180; ++y)
  {
    for (int x = 0; x < 240; ++x)
    {
      const relievoTest::Ray ray = view.PixelRay(x + 0.5, y + 0.5);
      const glm::dvec3 place = ray.At(-ray.Origin.y / ray.Direction.y);
      const double t = place.x / radius;
      if (std::abs(t) < 1.0 && std::abs(place.z) < 0.2)
      {
        const double free = 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / 3.14159265358979;
        const double found =
          relievoTest::LinearFromSrgb(picture->GetScalarComponentAsDouble(x, y, 0, 0) / 255.0);
        const double error = found / white - (passes + (1.0 - passes) * free);
        squares += error * error;
        mean += error;
        ++count;
      }
    }
  }
  RELIEVO_CHECK(count > 300);
  RELIEVO_CHECK_AT_MOST(std::sqrt(squares / count), 0.04, "parts of a half shadow: rms");
  RELIEVO_CHECK_AT_MOST(std::abs(mean / count), 0.02, "parts of a half shadow: mean");
}

// Volumes in front of black, seen along z in parallel projection: light from above is then equal
// along each ray.
struct LitStage : ShadowStage
{
  LitStage()
    : ShadowStage(64, 64)
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.2);
    camera->SetPosition(0.5, 1.0, 10.0);
    camera->SetFocalPoint(0.5, 1.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(1.0, 20.0);
    this->Light(this->Sun, glm::dvec3(0.8, 0.0, 0.0));
    this->Sun->SetPosition(0.5, 5.0, 0.5);
    this->Sun->SetFocalPoint(0.5, 0.0, 0.5);
    // Far enough away for parallel rays.
    this->Light(this->Lamp, glm::dvec3(0.0, 0.8, 0.0));
    this->Lamp->SetPosition(0.5, 1000.0, 0.5);
    this->Lamp->SetFocalPoint(0.5, 0.0, 0.5);
    this->Lamp->PositionalOn();
    this->Lamp->SetConeAngle(20.0);
    this->Lamp->SetExponent(0.0);
    this->GetShadows();
  }

  void Light(vtkLight* light, const glm::dvec3& color)
  {
    light->SetLightTypeToSceneLight();
    light->SetColor(color.x, color.y, color.z);
    this->Renderer->AddLight(light);
  }

  // Adds a shaded volume whose normals point along y.
  void Add(Volume& volume)
  {
    vtkVolumeProperty* property = volume.Prop->GetProperty();
    property->ShadeOn();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    volume.Opacity->RemoveAllPoints();
    volume.Opacity->AddPoint(0.0, 0.7);
    volume.Opacity->AddPoint(1.0, 0.7);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    property->SetColor(white);
    this->Renderer->AddVolume(volume.Prop);
  }

  // The picture's row of this height, in the middle of the volumes; or of another x.
  glm::dvec3 GetColor(double y, double x = 0.5)
  {
    const auto picture = relievoTest::Picture(this->Window);
    const int column = static_cast<int>((x - 0.5) / 2.4 * 64 + 32);
    const int row = static_cast<int>((y - 1.0) / 2.4 * 64 + 32);
    glm::dvec3 color;
    for (int i = 0; i < 3; ++i)
    {
      color[i] = picture->GetScalarComponentAsDouble(column, row, 0, i);
    }
    return color;
  }

  static double GetHeight(double y) // of that row's centre
  {
    return (std::floor((y - 1.0) / 2.4 * 64 + 32) + 0.5 - 32) * 2.4 / 64 + 1.0;
  }

  vtkNew<vtkLight> Sun;
  vtkNew<vtkLight> Lamp;
};

Scalars Upwards()
{
  return [](const glm::dvec3& place) { return place.y; };
}

// The share of both lights' colours that is left at a height, with `shadows` on.
void CheckLeft(LitStage& stage, double y, const glm::dvec2& expected, const std::string& what)
{
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->EnabledOff();
  const glm::dvec3 lit = stage.GetColor(y);
  shadows->EnabledOn();
  const glm::dvec3 left = stage.GetColor(y);
  RELIEVO_CHECK_THAT(lit.x > 100.0 && lit.y > 100.0, what + ": it is lit");
  RELIEVO_CHECK_NEAR(left.x / lit.x, expected.x, 0.015, what + ": the sun");
  RELIEVO_CHECK_NEAR(left.y / lit.y, expected.y, 0.015, what + ": the lamp");
}

void TestOnVolumes()
{
  LitStage stage; // without GLCheck: drivers warn about VTK's own shader of lit volumes
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  Volume volume(33, Upwards());
  stage.Add(volume);
  for (const double y : { 0.2, 0.5, 0.8 })
  {
    const double own = std::exp(-Sigma * (1.0 - LitStage::GetHeight(y)));
    CheckLeft(stage, y, { own, own }, "a volume on itself");
  }
  // VTK's shader of volumes numbers lamps first, the renderer as they were added.
  const double middle = std::exp(-Sigma * (1.0 - LitStage::GetHeight(0.5)));
  shadows->SetLightCasts(stage.Lamp, false);
  CheckLeft(stage, 0.5, { middle, 1.0 }, "without the lamp's");
  shadows->SetLightCasts(stage.Lamp, true);
  shadows->SetLightCasts(stage.Sun, false);
  CheckLeft(stage, 0.5, { 1.0, middle }, "without the sun's");
  shadows->SetLightCasts(stage.Sun, true);
  shadows->SetStrength(0.5);
  CheckLeft(stage, 0.5, glm::dvec2(0.5 + 0.5 * middle), "half of it");
  shadows->SetStrength(1.0);
  shadows->SetPropReceives(volume.Prop, false);
  CheckLeft(stage, 0.5, { 1.0, 1.0 }, "a volume that receives none");
  shadows->SetPropReceives(volume.Prop, true);

  shadows->SetPropCasts(volume.Prop, vtkRelievoShadowStage::CASTS_NEVER);
  CheckLeft(stage, 0.5, { 1.0, 1.0 }, "a volume that casts none");
  Volume above(17, Upwards(), 0.5);
  stage.Add(above);
  above.Prop->SetPosition(0.25, 1.4, 0.0);
  above.Prop->SetScale(1.0, 1.0, 2.0);
  CheckLeft(stage, 0.5, glm::dvec2(std::exp(-0.5 * Sigma)), "a volume below another one");
  stage.Renderer->RemoveVolume(above.Prop);

  // Each partition has texture coordinates of its own.
  auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(volume.Mapper);
  if (mapper)
  {
    const relievoTest::ExpectMessage expect("it has partitions");
    shadows->SetPropCasts(volume.Prop, vtkRelievoShadowStage::CASTS_ALWAYS);
    mapper->SetPartitions(1, 2, 1);
    volume.Image->Modified();
    CheckLeft(stage, 0.5, { 1.0, 1.0 }, "a volume in partitions");
    mapper->SetPartitions(1, 1, 1);
    volume.Image->Modified();
    shadows->SetPropCasts(volume.Prop, vtkRelievoShadowStage::CASTS_NEVER);
  }

  // A slab over the left half.
  const auto slab = stage.AddBox({ -0.5, 1.6, 0.5 }, { 2.0, 0.1, 2.0 });
  slab->GetProperty()->SetOpacity(1.0);
  for (const int method :
    { vtkRelievoShadowStage::METHOD_MAP, vtkRelievoShadowStage::METHOD_FORWARD,
      vtkRelievoShadowStage::METHOD_WARPED, vtkRelievoShadowStage::METHOD_EXACT })
  {
    shadows->SetMethod(method);
    const std::string what = "below a slab, method " + std::to_string(method);
    const glm::dvec3 left = stage.GetColor(0.5, 0.3);
    const glm::dvec3 right = stage.GetColor(0.5, 0.7);
    RELIEVO_CHECK_NEAR(glm::length(left), 0.0, 0.0, what);
    shadows->EnabledOff();
    RELIEVO_CHECK_NEAR(glm::length(right - stage.GetColor(0.5, 0.7)), 0.0, 1.5, what + ", beside");
    shadows->EnabledOn();
  }
}
}

RELIEVO_TEST_CASE(testVolumeShadows)
{
  relievoTest::Session session;
  TestWeight();
  TestBox();
  TestExact();
  TestCut();
  TestHard();
  TestBytes();
  TestVectors();
  TestRefused();
  TestGround();
  TestColored();
  TestSteep();
  TestProps();
  TestNoReceivers();
  TestSoft();
  TestSoftParts();
  TestOnVolumes();
  return session.Result();
}
}
