// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays through volumes that skip transparent parts draw VTK's own picture, bit for bit: with each
// kind of volume that is skipped, after changes, beside surfaces, seen from inside, with shadows.
// Other volumes are drawn in full, and the reason says why.
#include "Check.h"
#include "ImageCompare.h"
#include "Props.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockVolumeMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace testEmptySpace
{
namespace
{
using relievoTest::IsSame;
using relievoTest::Picture;

constexpr int Size = 41;
constexpr int Window = 120;

// Two balls, of which one is thin, in a box from (0, 0, 0) to (1, 1, 1); from 0 to 200.
double GetValue(int i, int j, int k)
{
  const double x = i / (Size - 1.0);
  const double y = j / (Size - 1.0);
  const double z = k / (Size - 1.0);
  const double large =
    std::sqrt(std::pow(x - 0.35, 2) + std::pow(y - 0.4, 2) + std::pow(z - 0.5, 2));
  const double small =
    std::sqrt(std::pow(x - 0.8, 2) + std::pow(y - 0.8, 2) + std::pow(z - 0.6, 2));
  return 200.0 * std::max(0.0, std::max(1.0 - large / 0.25, 0.6 * (small < 0.08)));
}

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Drawn;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkLight> Light;

  Scene()
  {
    this->Renderer->SetBackground(0.1, 0.2, 0.3);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(3.0, 5.0, 2.0);
    this->Renderer->AddLight(this->Light);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.9, 1.4, 2.6);
    camera->SetFocalPoint(0.5, 0.5, 0.5);
    this->Drawn = relievoTest::MakeWindow(Window, Window, this->Renderer);
    this->Fill(VTK_UNSIGNED_SHORT);
    this->Mapper->SetInputData(this->Image);
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(0.02f);
    this->Volume->SetMapper(this->Mapper);
    this->Reset();
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->ResetCameraClippingRange();
  }

  void Fill(int type, int components = 1)
  {
    this->Image->SetDimensions(Size, Size, Size);
    this->Image->SetSpacing(1.0 / (Size - 1), 1.0 / (Size - 1), 1.0 / (Size - 1));
    this->Image->AllocateScalars(type, components);
    for (int k = 0; k < Size; ++k)
    {
      for (int j = 0; j < Size; ++j)
      {
        for (int i = 0; i < Size; ++i)
        {
          for (int c = 0; c < components; ++c)
          {
            this->Image->SetScalarComponentFromDouble(i, j, k, c, GetValue(i, j, k));
          }
        }
      }
    }
    this->Image->Modified();
  }

  // A property of the volume without shading, with a ramp of opacities.
  vtkVolumeProperty* Reset()
  {
    vtkNew<vtkVolumeProperty> property;
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(200.0, 0.4);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 1.0, 0.6, 0.2);
    color->AddRGBPoint(200.0, 0.2, 0.5, 1.0);
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    property->SetScalarOpacityUnitDistance(0.05);
    property->SetInterpolationTypeToLinear();
    this->Volume->SetProperty(property);
    return property;
  }

  vtkRelievoStage* GetStage() const
  {
    return vtkRelievoPass::Attach(this->Renderer)->GetStage("empty_space");
  }

  // Checks that the picture is that of VTK, and whether parts are skipped.
  void Check(const std::string& name, bool skips = true, const std::string& why = std::string())
  {
    vtkRelievoPass::Detach(this->Renderer);
    this->Drawn->Render();
    const auto plain = Picture(this->Drawn);
    vtkRelievoStage* stage = this->GetStage();
    stage->EnabledOn();
    this->Drawn->Render();
    RELIEVO_CHECK_THAT(IsSame(plain, Picture(this->Drawn)), name);
    RELIEVO_CHECK_THAT(
      (stage->GetReasonCode() == "ran") == skips, name + ": " + stage->GetReason());
    RELIEVO_CHECK_THAT(
      stage->GetReason().find(why) != std::string::npos, name + ": " + stage->GetReason());
  }

  // Checks that a change between two frames gives VTK's picture. Returns the stage's reason in the
  // second frame.
  std::string CheckChange(const std::string& name, const std::function<void()>& change)
  {
    vtkRelievoStage* stage = this->GetStage();
    stage->EnabledOn();
    this->Drawn->Render();
    change();
    this->Drawn->Render();
    const auto skipped = Picture(this->Drawn);
    std::string reason = stage->GetReason();
    vtkRelievoPass::Detach(this->Renderer);
    this->Drawn->Render();
    RELIEVO_CHECK_THAT(IsSame(Picture(this->Drawn), skipped), name);
    return reason;
  }
};

// The ways in which VTK finds a sample's opacity, or leaves it out.
void TestKinds(Scene& scene)
{
  scene.Check("plain");
  RELIEVO_CHECK(scene.GetStage()->GetBytesHeld() > 0);
  scene.Reset()->ShadeOn();
  scene.Check("shaded");
  vtkNew<vtkPiecewiseFunction> gradient;
  gradient->AddPoint(0.0, 0.0);
  gradient->AddPoint(20.0, 1.0);
  scene.Reset()->SetGradientOpacity(gradient);
  scene.Check("gradient opacity");
  scene.Reset()->SetInterpolationTypeToNearest();
  scene.Check("nearest");

  // Transparent above and below, and where the data have no values.
  vtkVolumeProperty* property = scene.Reset();
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(60.0, 0.0);
  opacity->AddPoint(60.5, 0.5);
  opacity->AddPoint(90.0, 0.5);
  opacity->AddPoint(90.5, 0.0);
  opacity->AddPoint(200.0, 0.0);
  scene.Fill(VTK_UNSIGNED_CHAR);
  scene.Check("bytes, a band of values");
  scene.Fill(VTK_FLOAT);
  scene.Check("floats, a band of values");
  scene.Image->SetScalarComponentFromDouble(5, 30, 5, 0, std::numeric_limits<double>::quiet_NaN());
  scene.Image->Modified();
  scene.Image->GetPointData()->GetScalars()->Modified();
  scene.Check("a voxel that is not a number");
  scene.Fill(VTK_UNSIGNED_SHORT);

  scene.Reset();
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.3, 0.7, 0.3, 0.7, 0.3, 0.7);
  scene.Check("cropped");
  scene.Mapper->CroppingOff();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.4, 0.0, 0.0);
  plane->SetNormal(1.0, 0.3, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.Check("clipped");
  scene.Mapper->RemoveAllClippingPlanes();
}

// Data of these types: VTK's shader reads values of 8 and 16 bits larger than they are, and nothing
// that is defined beside infinite ones.
void TestTypes(Scene& scene)
{
  vtkPiecewiseFunction* opacity = scene.Reset()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(210.5, 0.0);
  opacity->AddPoint(211.0, 0.5);
  opacity->AddPoint(255.0, 0.5);
  scene.Fill(VTK_UNSIGNED_CHAR);
  vtkDataArray* bytes = scene.Image->GetPointData()->GetScalars();
  bytes->Fill(210.0);
  bytes->SetComponent(0, 0, 0.0);
  bytes->SetComponent(bytes->GetNumberOfTuples() - 1, 0, 255.0);
  scene.Image->Modified();
  scene.Check("bytes that are read as 210.8", false, "transparent");

  scene.Reset()->GetScalarOpacity()->AddPoint(30.0, 0.0);
  for (const int type : { VTK_SIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_DOUBLE })
  {
    scene.Fill(type);
    vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; type == VTK_SIGNED_CHAR && i < values->GetNumberOfTuples(); ++i)
    {
      values->SetComponent(i, 0, std::min(values->GetComponent(i, 0), 127.0));
    }
    scene.Check(values->GetClassName());
  }
  scene.Fill(VTK_FLOAT);
  scene.Image->SetScalarComponentFromDouble(5, 30, 15, 0, -std::numeric_limits<double>::infinity());
  scene.Image->Modified();
  scene.Check("an infinite voxel");
  scene.Fill(VTK_UNSIGNED_SHORT);

  // Values of cells, of which the first and the last touch the border of the image.
  vtkNew<vtkImageData> cells;
  cells->SetDimensions(Size + 1, Size + 1, Size + 1);
  cells->SetSpacing(1.0 / Size, 1.0 / Size, 1.0 / Size);
  cells->GetCellData()->SetScalars(scene.Image->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(cells);
  scene.Check("values of cells");
  scene.Mapper->SetInputData(scene.Image);

  vtkUnsignedCharArray* ghosts = scene.Image->AllocatePointGhostArray();
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    ghosts->SetValue(i, i % Size < 16 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  scene.Image->Modified();
  scene.Check("blanked points");
  scene.Image->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  scene.Image->Modified();
}

// Blocks of earlier data and functions are replaced.
void TestChanges(Scene& scene)
{
  scene.Reset();
  scene.Check("as at first");
  scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(20.0, 0.2);
  scene.Check("another function");
  scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.01);
  scene.Check("a function without a transparent part", false, "no part of it is transparent");
  scene.Reset();
  auto* values = static_cast<unsigned short*>(scene.Image->GetScalarPointer());
  const auto set = [&](int first, int step, unsigned short value) {
    for (int i = 0; i < 40; ++i)
    {
      values[first + i * step] = value;
    }
    scene.Image->Modified();
  };
  scene.CheckChange(
    "other values, of which the image knows", [&]() { set(5 * Size * Size, 1 + Size, 200); });
  scene.CheckChange("other values, of which the array knows", [&]() {
    values[9 * (Size * Size + Size)] = 200;
    scene.Image->GetPointData()->GetScalars()->Modified();
  });
  set(0, 1 + Size + Size * Size, 200); // the diagonal
  scene.Check("other values");

  vtkDataArray* all = scene.Image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedShortArray> before;
  before->DeepCopy(all);
  std::string reason = scene.CheckChange("no transparent part", [&]() {
    all->Fill(100.0);
    all->SetComponent(0, 0, 200.0);
    all->SetComponent(Size, 0, 0.0);
    scene.Image->Modified();
  });
  RELIEVO_CHECK_THAT(reason.find("no part of it is transparent") != std::string::npos, reason);
  reason = scene.CheckChange("transparent parts again", [&]() {
    all->DeepCopy(before);
    scene.Image->Modified();
  });
  RELIEVO_CHECK_THAT(reason.find("skips") == 0, reason);
  scene.Check("transparent parts still");
  RELIEVO_CHECK(scene.GetStage()->GetFacts()["skipped_volumes"].ToInt() == 1);
}

void TestViews(Scene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.9, 0.5, 0.75); // inside
  scene.Renderer->ResetCameraClippingRange();
  scene.Check("from inside");
  camera->SetPosition(0.5, 0.5, 3.0); // rays along an axis
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7);
  const auto ball = relievoTest::AddActor(scene.Renderer, relievoTest::MakeBall(0.3));
  ball->SetPosition(0.4, 0.4, 0.2);
  scene.Renderer->ResetCameraClippingRange();
  scene.Check("in parallel, with a surface inside");

  // Shadows from the surface onto the volume and back are the same, too.
  scene.Reset()->ShadeOn();
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->ShadowsOn();
  scene.GetStage()->EnabledOff();
  scene.Drawn->Render();
  const auto shadowed = Picture(scene.Drawn);
  scene.GetStage()->EnabledOn();
  scene.Drawn->Render();
  RELIEVO_CHECK_THAT(IsSame(shadowed, Picture(scene.Drawn)), "with shadows");
  RELIEVO_CHECK(scene.GetStage()->GetReasonCode() == "ran");
  const auto layer = [&scene, frame]() {
    auto image = vtkSmartPointer<vtkImageData>::New();
    RELIEVO_CHECK(frame->ReadLayer("volume_value", image));
    return image;
  };
  frame->RequestLayer("volume_value");
  scene.Drawn->Render();
  const auto skipped = layer();
  scene.GetStage()->EnabledOff();
  scene.Drawn->Render();
  vtkDataArray* a = skipped->GetPointData()->GetArray("volume_value");
  const auto full = layer();
  vtkDataArray* b = full->GetPointData()->GetArray("volume_value");
  bool same = a && b && a->GetNumberOfTuples() == b->GetNumberOfTuples();
  for (vtkIdType i = 0; same && i < a->GetNumberOfTuples(); ++i)
  {
    const double x = a->GetComponent(i, 0);
    const double y = b->GetComponent(i, 0);
    same = x == y || (std::isnan(x) && std::isnan(y));
  }
  RELIEVO_CHECK_THAT(same, "layers look at all samples");
  frame->ShadowsOff();
  scene.Renderer->RemoveActor(ball);
  camera->ParallelProjectionOff();
}

// Mappers around others, and volumes that are drawn in full.
void TestOthers(Scene& scene)
{
  scene.Reset();
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetInputData(scene.Image);
  smart->SetRequestedRenderModeToGPU();
  smart->SetAutoAdjustSampleDistances(0);
  smart->SetInteractiveAdjustSampleDistances(0);
  smart->SetSampleDistance(0.02f);
  scene.Volume->SetMapper(smart);
  scene.Check("vtkSmartVolumeMapper");
  vtkNew<vtkImageData> other;
  other->ShallowCopy(scene.Image);
  other->SetOrigin(-0.7, 0.2, 0.0);
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, scene.Image);
  images->SetBlock(1, other);
  vtkNew<vtkMultiBlockVolumeMapper> blocks;
  blocks->SetInputDataObject(0, images);
  blocks->SetRequestedRenderMode(vtkSmartVolumeMapper::GPURenderMode);
  scene.Volume->SetMapper(blocks);
  scene.Check("vtkMultiBlockVolumeMapper", true, "2 volumes");
  scene.Volume->SetMapper(scene.Mapper);
  vtkNew<vtkGPUVolumeRayCastMapper> second;
  second->SetInputData(other);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(second);
  volume->SetProperty(scene.Volume->GetProperty());
  scene.Renderer->AddVolume(volume);
  scene.Check("two volumes", true, "2 volumes");
  scene.Renderer->RemoveVolume(volume);

  const auto glass = relievoTest::AddActor(scene.Renderer, relievoTest::MakeBall(0.3));
  glass->SetPosition(0.5, 0.5, 0.7);
  glass->GetProperty()->SetOpacity(0.5);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  scene.Check("depth peeling");
  scene.Renderer->UseDepthPeelingForVolumesOff();
  scene.Renderer->UseDepthPeelingOff();
  scene.Renderer->RemoveActor(glass);

  scene.Mapper->SetBlendModeToMaximumIntensity();
  scene.Check("maximum intensity", false, "blend mode");
  scene.Mapper->SetBlendModeToComposite();
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(scene.Image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  mask->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkGPUVolumeRayCastMapper> labels;
  labels->SetInputData(scene.Image);
  labels->SetMaskInput(mask);
  scene.Volume->SetMapper(labels);
  labels->SetMaskTypeToBinary();
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    mask->GetPointData()->GetScalars()->SetComponent(i, 0, i % Size < 16 ? 255.0 : 0.0);
  }
  labels->AutoAdjustSampleDistancesOff();
  labels->SetSampleDistance(0.02f);
  scene.Check("a binary mask");
  mask->GetPointData()->GetScalars()->Fill(1.0);
  mask->Modified();
  labels->SetMaskTypeToLabelMap();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  vtkNew<vtkPiecewiseFunction> constant;
  constant->AddPoint(0.0, 0.1);
  vtkVolumeProperty* labelled = scene.Reset();
  labelled->SetLabelColor(1, color);
  labelled->SetLabelScalarOpacity(1, constant);
  scene.Check("labels", false, "mask");
  scene.Volume->SetMapper(scene.Mapper);
  vtkNew<vtkImageData> surface;
  surface->SetDimensions(32, 32, 1);
  surface->AllocateScalars(VTK_FLOAT, 4);
  surface->GetPointData()->GetScalars()->Fill(0.1);
  vtkVolumeProperty* property = scene.Reset();
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  property->SetTransferFunction2D(surface);
  scene.Check("a two-dimensional function", false, "two-dimensional");
  scene.Reset();
  scene.Fill(VTK_UNSIGNED_SHORT, 2);
  scene.Check("two components", false, "components");
  scene.Fill(VTK_UNSIGNED_SHORT);
}
}

RELIEVO_TEST_CASE(testEmptySpace)
{
  relievoTest::Session session;
  {
    Scene scene;
    TestKinds(scene);
    TestTypes(scene);
    TestChanges(scene);
    TestViews(scene);
    TestOthers(scene);
    scene.GetStage()->EnabledOff();
    scene.Drawn->Render();
    scene.GetStage()->ReleaseGraphicsResources(nullptr);
    RELIEVO_CHECK(scene.GetStage()->GetBytesHeld() == 0);
  }
  return session.Result();
}
}
