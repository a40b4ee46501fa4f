// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lens.h"

#include "CameraOptions.h"
#include "Errors.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Values.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoCalibration.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoLensPicture.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoRayScene.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace scene
{
namespace
{
constexpr double WidestFit = 120.0; // of a fitted camera, degrees

vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(
  vtkRelievoCalibration* calibration, const RenderOptions& options, vtkCamera* view)
{
  const vtkNew<vtkCallbackCommand> silent; // its message is thrown instead
  calibration->AddObserver(vtkCommand::ErrorEvent, silent);
  if ((!options.Lens.empty() && !calibration->SetWords(options.Lens)) || !calibration->Read())
  {
    throw FileError(calibration->GetFailureText());
  }
  const bool sized = options.IsSized || calibration->GetFileSize()[0] == 0;
  const int* given = calibration->GetFileSize();
  if (!sized && std::max(given[0], given[1]) > LargestSize)
  {
    throw UsageError("--lens " + options.Lens + ": its pictures have " + std::to_string(given[0]) +
      "x" + std::to_string(given[1]) + " pixels, expected at most " + std::to_string(LargestSize) +
      " each way; give a smaller --size of that shape");
  }
  vtkSmartPointer<vtkRelievoCameraModel> sensor =
    calibration->MakeCamera(view, sized ? options.Size[0] : calibration->GetFileSize()[0],
      sized ? options.Size[1] : calibration->GetFileSize()[1]);
  if (!sensor)
  {
    throw UsageError("--lens: " + calibration->GetFailureText());
  }
  return sensor;
}

vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(
  vtkRelievoCalibration* calibration, const RenderOptions& options)
{
  vtkNew<vtkCamera> view;
  view->SetViewAngle(options.View.Angle.value_or(StandardViewAngle));
  return MakeSensor(calibration, options, view);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options, vtkCamera* view)
{
  vtkNew<vtkRelievoCalibration> calibration;
  return MakeSensor(calibration, options, view);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(vtkCamera* view, int columns, int rows)
{
  if (view->GetParallelProjection())
  {
    vtkNew<vtkRelievoCalibration> calibration;
    calibration->SetWords("orthographic");
    return calibration->MakeCamera(view, columns, rows);
  }
  auto pinhole = vtkSmartPointer<vtkRelievoLensCamera>::New();
  return pinhole->TakeFrom(view, columns, rows) ? pinhole : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoCameraModel> MakeSensor(const RenderOptions& options)
{
  vtkNew<vtkRelievoCalibration> calibration;
  return MakeSensor(calibration, options);
}

//------------------------------------------------------------------------------
void CheckLensScale(const RenderOptions& options)
{
  if (options.Lens == "orthographic")
  {
    throw UsageError(
      "--lens orthographic: no camera gives its scale here; give the pixels per world "
      "unit, as in orthographic:100");
  }
}

//------------------------------------------------------------------------------
void CheckLensLayer(const std::string& name)
{
  if (name != vtkRelievoLayerCatalogue::GetPicture().Name &&
    !vtkRelievoRayLayers::HasLayer(name.c_str()))
  {
    RefuseValue("--layers", name,
      "with --lens one of color, " + vtkRelievoRayLayers::GetLayerNames() +
        ", or an array of the files");
  }
}

//------------------------------------------------------------------------------
RenderOptions FollowLens(RenderOptions options)
{
  vtkNew<vtkRelievoCalibration> calibration;
  const auto sensor = MakeSensor(calibration, options);
  std::copy_n(sensor->GetSize(), 2, options.Size.begin());
  const double angle = calibration->GetAngleOfWords();
  if (angle > 0.0 && !options.View.Angle && !options.View.ParallelScale)
  {
    options.View.Angle = std::min(angle, WidestFit);
  }
  return options;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DrawLens(vtkRenderer* renderer, const RenderOptions& options,
  const std::vector<std::string>& layers, vtkSmartPointer<vtkImageData>& picture,
  Progress& progress)
{
  const auto sensor = MakeSensor(options, renderer->GetActiveCamera());
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNew<vtkRelievoLensPicture> drawn;
  drawn->SetRenderer(renderer);
  drawn->SetCamera(sensor);
  drawn->SetHDR(options.Has("--hdr"));
  drawn->SetPicture(options.WantsPicture());
  progress.Observe(drawn);
  drawn->Update();
  Messages::Check("--lens " + options.Lens, drawn->GetOutput()->GetNumberOfPoints() == 0);
  image->ShallowCopy(drawn->GetOutput());
  if (vtkDataArray* shown = image->GetPointData()->GetScalars())
  {
    picture = vtkSmartPointer<vtkImageData>::New();
    picture->CopyStructure(image);
    picture->GetPointData()->SetScalars(shown);
    image->GetPointData()->RemoveArray(shown->GetName());
  }
  vtkNew<vtkRelievoRayScene> scene;
  vtkNew<vtkRelievoRayLayers> rays;
  scene->SetRenderer(renderer);
  rays->SetScene(scene);
  rays->SetCamera(sensor);
  for (const std::string& name : layers)
  {
    if (name != vtkRelievoLayerCatalogue::GetPicture().Name)
    {
      rays->AddLayer(name.c_str());
    }
  }
  if (options.EXR.empty() || layers.size() < 2)
  {
    return image;
  }
  progress.Observe(rays);
  rays->Update();
  Messages::Check("--lens " + options.Lens, rays->GetOutput()->GetNumberOfPoints() == 0);
  for (int i = 0; i < rays->GetOutput()->GetPointData()->GetNumberOfArrays(); ++i)
  {
    image->GetPointData()->AddArray(rays->GetOutput()->GetPointData()->GetArray(i));
  }
  return image;
}

//------------------------------------------------------------------------------
std::string WriteCalibration(vtkFieldData* fields, const std::array<int, 2>& size)
{
  nlohmann::ordered_json calibration = { { "size", size } };
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    auto& value = calibration[fields->GetArrayName(i)];
    if (auto* text = vtkStringArray::SafeDownCast(fields->GetAbstractArray(i)))
    {
      value = text->GetValue(0);
    }
    else if (auto* numbers = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray(i)))
    {
      value = std::vector<double>(
        numbers->GetPointer(0), numbers->GetPointer(numbers->GetNumberOfValues()));
    }
  }
  return calibration.dump();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFieldData> GetCalibration(vtkRenderer* renderer, const int size[2])
{
  auto fields = vtkSmartPointer<vtkFieldData>::New();
  vtkNew<vtkRelievoLensCamera> pinhole;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (vtkRelievoLensCamera::IsPinhole(camera) && pinhole->TakeFrom(camera, size[0], size[1]))
  {
    pinhole->AddTo(fields);
  }
  return fields;
}
}
