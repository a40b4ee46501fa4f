// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentConvert.h"

#include "vtkRelievoEnvironmentImage.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoWholeImage.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>

using relievo::EnvironmentImage;
using relievo::EnvironmentPlace;
using relievo::EnvironmentShape;
using relievo::Projection;
namespace f64 = relievo::f64;

vtkStandardNewMacro(vtkRelievoEnvironmentConvert);

//------------------------------------------------------------------------------
vtkRelievoEnvironmentConvert::vtkRelievoEnvironmentConvert()
{
  vtkRelievoParameterList& list = this->Parameters;
  relievo::DescribeEnvironmentInput(list, vtkRelievoMember(InputProjection),
    vtkRelievoMember(InputSRGB), vtkRelievoMember(InputMirrored));
  list.AddChoice("output_projection", vtkRelievoMember(OutputProjection),
    { "equirectangular", "cube", "sphere_map" }, "The projection of the output.", EQUIRECTANGULAR);
  list.AddWhole("output_size", vtkRelievoMember(OutputSize), 0, 32768, "texels",
    "Height of an equirectangular image, width of a face or a sphere map. 0 keeps the input's "
    "detail.");
  list
    .AddFlag("output_mirrored", vtkRelievoMember(OutputMirrored),
      "Whether the output is mirrored, as vtkSkybox expects of cubes.")
    .Advanced = true;
  list
    .AddWhole("samples_per_texel", vtkRelievoMember(SamplesPerTexel), 1, 16, "",
      "Samples across a texel of the input, in both directions.")
    .Advanced = true;
}

namespace
{
// Samples across a texel: `rate` per input texel, by the output texel's longest side and the input
// texel's shortest. A texel's light is read as a tent, whose sum over the samples is within 1 / (pi
// rate)^2 of the whole in each direction.
int SamplesAt(
  const EnvironmentShape& from, const EnvironmentShape& to, const EnvironmentPlace& place, int rate)
{
  const double step = from.GetSteps(from.GetPlace(to.GetDirection(place))).x;
  return static_cast<int>(std::clamp(std::ceil(rate * to.GetSteps(place).y / step), 2., 64.));
}

// The mean over the solid angle of one texel.
f64::vec3 MeanOf(const EnvironmentImage& image, const EnvironmentShape& to, int slice, int column,
  int row, int rate)
{
  const f64::vec2 size(to.GetWidth(), to.GetHeight());
  const f64::vec2 corner(column, row);
  const int samples = SamplesAt(image.GetShape(), to, { slice, (corner + 0.5) / size }, rate);
  f64::vec3 sum(0.);
  double weights = 0.;
  for (int j = 0; j < samples; ++j)
  {
    for (int i = 0; i < samples; ++i)
    {
      const f64::vec2 inside((i + 0.5) / samples, (j + 0.5) / samples);
      const EnvironmentPlace place = { slice, (corner + inside) / size };
      const double weight = to.GetDensity(place);
      if (weight > 0.)
      {
        sum += weight * f64::vec3(image.Sample(glm::vec3(to.GetDirection(place))));
        weights += weight;
      }
    }
  }
  return weights > 0. ? sum / weights : f64::vec3(0.);
}
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentConvert::GetOutputDimensions(const int input[3], int output[3])
{
  const Projection from = this->InputProjection == AUTOMATIC
    ? relievo::ProjectionOfSize(input)
    : static_cast<Projection>(this->InputProjection);
  const double face = EnvironmentShape(from, input[0], input[1], false).GetDetail();
  const double perFace[4] = { 0., 2., 1., 3. };
  const int size = this->OutputSize > 0
    ? this->OutputSize
    : std::max(1, static_cast<int>(std::lround(face * perFace[this->OutputProjection])));
  output[0] = this->OutputProjection == EQUIRECTANGULAR ? 2 * size : size;
  output[1] = size;
  output[2] = this->OutputProjection == CUBE ? 6 : 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentConvert::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  int whole[6];
  inputs[0]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  const int input[3] = { whole[1] - whole[0] + 1, whole[3] - whole[2] + 1,
    whole[5] - whole[4] + 1 };
  int size[3];
  this->GetOutputDimensions(input, size);
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
  const double origin[3] = { 0., 0., 0. };
  const double spacing[3] = { 1., 1., 1. };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 3);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentConvert::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  return relievo::RequestWholeImage(inputs);
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentConvert::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  // The pipeline requests an empty image again and again.
  const bool isSaid = this->GetMTime() == this->RefusedAt;
  this->SetErrorCode(vtkErrorCode::NoError);
  output->Initialize();
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  std::string problem;
  EnvironmentImage image(input, this->GetInputArrayToProcess(0, inputs),
    static_cast<Projection>(this->InputProjection), this->InputMirrored, this->InputSRGB, problem);
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    if (!isSaid)
    {
      vtkErrorMacro("No environment: " << problem << ".");
    }
    this->RefusedAt = this->GetMTime();
    return 1;
  }
  int size[3];
  this->GetOutputDimensions(input->GetDimensions(), size);
  const EnvironmentShape to(
    static_cast<Projection>(this->OutputProjection), size[0], size[1], this->OutputMirrored);
  // At 2, the last halving would blur as much as the texels themselves.
  while (image.CanHalve() && image.GetShape().GetDetail() >= 4. * to.GetDetail())
  {
    image = image.Halve();
  }
  const EnvironmentShape& from = image.GetShape();
  const bool same = from.GetProjection() == to.GetProjection() && from.GetWidth() == size[0] &&
    from.GetHeight() == size[1] && this->InputMirrored == this->OutputMirrored;

  vtkNew<vtkFloatArray> radiance;
  radiance->SetName("radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(to.GetNumberOfTexels());
  float* texels = radiance->GetPointer(0);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(size[1]) * size[2], [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType line = begin; line < end; ++line)
      {
        const auto slice = static_cast<int>(line / size[1]);
        const auto row = static_cast<int>(line % size[1]);
        for (int column = 0; column < size[0]; ++column)
        {
          const f64::vec3 mean = same
            ? f64::vec3(image.GetTexel(slice, column, row))
            : MeanOf(image, to, slice, column, row, this->SamplesPerTexel);
          for (int c = 0; c < 3; ++c)
          {
            texels[3 * (line * size[0] + column) + c] = static_cast<float>(mean[c]);
          }
        }
      }
    });
  output->SetDimensions(size);
  output->SetOrigin(0., 0., 0.);
  output->SetSpacing(1., 1., 1.);
  output->GetPointData()->SetScalars(radiance);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentConvert::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  const char* names[] = { "automatic", "equirectangular", "cube", "sphere map" };
  os << indent << "OutputProjection: " << names[this->OutputProjection] << "\n";
}
