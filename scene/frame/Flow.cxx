// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Flow.h"

#include "Errors.h"
#include "Lens.h"
#include "Messages.h"
#include "Options.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoRayScene.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace scene
{
namespace
{
// The camera model of the picture.
vtkSmartPointer<vtkRelievoCameraModel> GetSensor(
  vtkRenderer* renderer, const RenderOptions& options)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (!options.Lens.empty())
  {
    return MakeSensor(options, camera);
  }
  const auto sensor = MakeSensor(camera, options.Size[0], options.Size[1]);
  Messages::Check("--layers flow", !sensor);
  return sensor;
}
}

//------------------------------------------------------------------------------
bool IsFlowOfFrames(const RenderOptions& options, const std::string& name)
{
  return (options.Model.Times.size() > 1 || options.Motion.MovesCamera()) &&
    vtkRelievoRayLayers::IsFlow(name.c_str());
}

//------------------------------------------------------------------------------
FlowOfFrames::FlowOfFrames(const RenderOptions& options, std::vector<std::string>& layers)
{
  const auto first = std::stable_partition(layers.begin(), layers.end(),
    [&options](const std::string& name) { return !IsFlowOfFrames(options, name); });
  this->Layers.assign(first, layers.end());
  layers.erase(first, layers.end());
}

//------------------------------------------------------------------------------
void FlowOfFrames::AddTo(vtkImageData* image, vtkRenderer* renderer, const RenderOptions& options)
{
  if (this->Layers.empty())
  {
    return;
  }
  const vtkSmartPointer<vtkRelievoCameraModel> camera = GetSensor(renderer, options);
  if (!this->Scene)
  {
    this->Scene = vtkSmartPointer<vtkRelievoRayScene>::New();
    this->Scene->SetRenderer(renderer);
    this->Scene->SetOpaqueOnly(options.Lens.empty());          // like the frame's other layers
    this->Before = vtkSmartPointer<vtkRelievoRayScene>::New(); // empty: no earlier frame
    this->CameraBefore = camera;
  }
  vtkNew<vtkRelievoRayLayers> source;
  source->SetScene(this->Scene);
  source->SetCamera(camera);
  source->SetOther(this->Before, this->CameraBefore);
  for (const std::string& name : this->Layers)
  {
    source->AddLayer(name.c_str());
  }
  source->Update();
  Messages::Check("--layers flow", source->GetOutput()->GetNumberOfPoints() == 0);
  for (const std::string& name : this->Layers)
  {
    image->GetPointData()->AddArray(source->GetOutput()->GetPointData()->GetArray(name.c_str()));
  }
  this->Before->CopyStateOf(this->Scene);
  this->CameraBefore = camera;
}
}
