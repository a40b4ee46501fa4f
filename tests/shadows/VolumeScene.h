// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeScene.h
 * @brief A cube of cloud, the lights that shine through it, and a ground below a sun in the zenith.
 */
#ifndef VolumeScene_h
#define VolumeScene_h

#include "Check.h"
#include "ShadowScenes.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRelievoOpticalDepths.h>
#include <vtkRelievoPlacedVolume.h>
#include <vtkRelievoVolumeExtinction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <functional>
#include <string>

namespace volumeScene
{
using relievoTest::ShadowStage;
using Source = vtkRelievoOpticalDepths::Source;
using Scalars = std::function<double(const glm::dvec3&)>; // of a place from 0 to 1 in the box

// A volume with the corners (0, 0, 0) and (size, size, size); its scalars are opacities from 0 to 1
// per unit distance.
struct Volume
{
  explicit Volume(int samples, const Scalars& scalars, double size = 1.0, int type = VTK_FLOAT)
  {
    this->Image->SetDimensions(samples, samples, samples);
    const double spacing = size / (samples - 1);
    this->Image->SetSpacing(spacing, spacing, spacing);
    this->Image->AllocateScalars(type, 1);
    for (int k = 0; k < samples; ++k)
    {
      for (int j = 0; j < samples; ++j)
      {
        for (int i = 0; i < samples; ++i)
        {
          this->Image->SetScalarComponentFromDouble(
            i, j, k, 0, scalars(glm::dvec3(i, j, k) / (samples - 1.0)));
        }
      }
    }
    this->Mapper->SetInputData(this->Image);
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(static_cast<float>(spacing));
    this->Mapper->UseJitteringOff();
    this->Opacity->AddPoint(0.0, 0.0);
    this->Opacity->AddPoint(1.0, 1.0);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 1.0, 0.8, 0.6);
    vtkVolumeProperty* property = this->Prop->GetProperty();
    property->SetColor(color);
    property->SetScalarOpacity(this->Opacity);
    property->SetInterpolationTypeToLinear();
    this->Prop->SetMapper(this->Mapper);
  }

  double GetDepth(const Source& source, const glm::dvec3& place) const
  {
    std::string why;
    const auto fields = vtkRelievoVolumeExtinction::Collect(this->Prop.Get(), why);
    RELIEVO_CHECK(fields.size() == 1 && why.empty());
    vtkRelievoOpticalDepths depths;
    depths.Make(fields, source, 256);
    return depths.GetDepth(place);
  }

  double GetExact(const Source& source, const glm::dvec3& place) const
  {
    std::string why;
    return vtkRelievoOpticalDepths::GetExactDepth(
      vtkRelievoVolumeExtinction::Collect(this->Prop.Get(), why), source, place);
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkVolume> Prop;
};

inline Scalars Constant(double opacity)
{
  return [=](const glm::dvec3&) { return opacity; };
}

// A sun whose rays have this direction, and a lamp.
inline Source Sun(const glm::dvec3& direction)
{
  Source source;
  source.Direction = glm::normalize(direction);
  return source;
}
inline Source Lamp(const glm::dvec3& place)
{
  Source source;
  source.Positional = true;
  source.Position = place;
  return source;
}

// The extinction of an opacity of 0.7 per unit distance.
const double Sigma = -std::log(1.0 - 0.7);

// A stage with a ground below a sun in the zenith.
struct ZenithStage : ShadowStage
{
  ZenithStage()
  {
    this->AddGround();
    this->Renderer->GetActiveCamera()->SetPosition(0.0, 8.0, 0.1);
    this->Renderer->ResetCameraClippingRange();
    this->AddSun(0.0, 1.0, 0.0);
  }
};
}

#endif
