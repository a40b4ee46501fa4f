// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentPrefilter.h"

#include "vtkRelievoCubePyramid.h"
#include "vtkRelievoEnvironmentConvert.h"
#include "vtkRelievoEnvironmentImage.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoWholeImage.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <string>

using relievo::CubePyramid;
using relievo::EnvironmentShape;
using relievo::Projection;
namespace f64 = relievo::f64;

vtkStandardNewMacro(vtkRelievoEnvironmentPrefilter);

namespace
{
int PowerOfTwo(double atLeast)
{
  int power = 1;
  while (power < atLeast)
  {
    power *= 2;
  }
  return power;
}

// The level for a roughness above 0, `size` texels across.
vtkSmartPointer<vtkFloatArray> Blur(
  const CubePyramid& pyramid, int size, double roughness, double tolerance)
{
  auto radiance = vtkSmartPointer<vtkFloatArray>::New();
  radiance->SetName("radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(static_cast<vtkIdType>(6) * size * size);
  float* texels = radiance->GetPointer(0);
  const EnvironmentShape shape(Projection::Cube, size, size, false);
  vtkSMPTools::For(0, radiance->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType texel = begin; texel < end; ++texel)
    {
      const f64::vec2 inside(texel % size + 0.5, texel / size % size + 0.5);
      const auto face = static_cast<int>(texel / size / size);
      const f64::vec3 axis =
        glm::normalize(shape.GetDirection({ face, inside / static_cast<double>(size) }));
      const f64::vec3 mean = pyramid.LobeMean(axis, roughness, tolerance);
      for (int c = 0; c < 3; ++c)
      {
        texels[3 * texel + c] = static_cast<float>(mean[c]);
      }
    }
  });
  return radiance;
}
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentPrefilter::vtkRelievoEnvironmentPrefilter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  vtkRelievoParameterList& list = this->Parameters;
  relievo::DescribeEnvironmentInput(list, vtkRelievoMember(InputProjection),
    vtkRelievoMember(InputSRGB), vtkRelievoMember(InputMirrored));
  list.AddWhole("size", vtkRelievoMember(Size), 0, 2048, "texels",
    "Across a face of the first cube. 0 uses the input's detail, up to 256.");
  list.AddWhole("levels", vtkRelievoMember(Levels), 2, 12, "",
    "Number of cubes, for roughness 0 to 1 in equal steps.");
  list
    .AddNumber("tolerance", vtkRelievoMember(Tolerance), 1e-7, 1.0, "",
      "The error allowed for one part of the sum, as a share of the texel's light.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentPrefilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentPrefilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  return relievo::RequestWholeImage(inputs);
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentPrefilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputs);
  std::string problem;
  const Projection projection = relievo::EnvironmentImage::Check(
    input, array, static_cast<Projection>(this->InputProjection), problem);
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No levels: " << problem << ".");
    return 1;
  }
  const int* dimensions = input->GetDimensions();
  const double detail =
    EnvironmentShape(projection, dimensions[0], dimensions[1], false).GetDetail();
  const int size = PowerOfTwo(this->Size > 0 ? this->Size : std::min(detail, 256.));

  vtkNew<vtkImageData> image;
  image->CopyStructure(input);
  image->GetPointData()->SetScalars(array);
  vtkNew<vtkRelievoEnvironmentConvert> convert;
  convert->SetInputData(image);
  convert->SetInputProjection(static_cast<int>(projection));
  convert->SetInputSRGB(this->InputSRGB);
  convert->SetInputMirrored(this->InputMirrored);
  convert->SetOutputSize(size);
  convert->Update();
  auto* sharp =
    vtkFloatArray::SafeDownCast(convert->GetOutput()->GetPointData()->GetArray("radiance"));
  const CubePyramid pyramid(sharp->GetPointer(0), size);

  const int possible = static_cast<int>(std::lround(std::log2(size))) + 1;
  const int count = std::min(this->Levels, possible);
  output->SetNumberOfBlocks(static_cast<unsigned int>(count));
  for (int level = 0; level < count && !this->GetAbortExecute(); ++level)
  {
    const int across = size >> level;
    const double value = f64::relievoPrefilterRoughness(level, count);
    vtkNew<vtkImageData> cube;
    cube->SetDimensions(across, across, 6);
    cube->GetPointData()->SetScalars(
      level == 0 ? sharp : Blur(pyramid, across, value, this->Tolerance).Get());
    vtkNew<vtkDoubleArray> roughness;
    roughness->SetName("roughness");
    roughness->InsertNextValue(value);
    cube->GetFieldData()->AddArray(roughness);
    const auto block = static_cast<unsigned int>(level);
    output->SetBlock(block, cube);
    output->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ("level " + std::to_string(level)).c_str());
    this->UpdateProgress((level + 1.) / count);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentPrefilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
}
