// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentIrradiance.h"

#include "vtkRelievoEnvironmentImage.h"
#include "vtkRelievoWholeImage.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using relievo::EnvironmentImage;
using relievo::EnvironmentPlace;
using relievo::EnvironmentShape;
namespace f64 = relievo::f64;

vtkStandardNewMacro(vtkRelievoEnvironmentIrradiance);

namespace
{
// Sums over part of the sphere: solid angle, and light times harmonics.
struct Sums
{
  double SolidAngle = 0.;
  std::array<f64::vec3, 9> Light = {};

  void Add(const Sums& other)
  {
    this->SolidAngle += other.SolidAngle;
    for (int i = 0; i < 9; ++i)
    {
      this->Light[i] += other.Light[i];
    }
  }
};

// Sums a line of texels, each divided into `parts` x `parts` with Gauss's 2 x 2 points.
Sums SumLine(const EnvironmentImage& image, int slice, int row, int parts)
{
  const EnvironmentShape& shape = image.GetShape();
  const f64::vec2 size = f64::vec2(shape.GetWidth(), shape.GetHeight());
  const double off = 0.5 / std::sqrt(3.);
  const double area = 1. / (4. * parts * parts * size.x * size.y);
  Sums line;
  for (int column = 0; column < shape.GetWidth(); ++column)
  {
    Sums texel;
    std::array<double, 9> harmonics = {};
    for (int k = 0; k < 4 * parts * parts; ++k)
    {
      const int i = k % (2 * parts);
      const int j = k / (2 * parts);
      const f64::vec2 part(i / 2, j / 2);
      const f64::vec2 point(i % 2 ? off : -off, j % 2 ? off : -off);
      const f64::vec2 inside = part + 0.5 + point;
      const EnvironmentPlace place = { slice,
        (f64::vec2(column, row) + inside / static_cast<double>(parts)) / size };
      const double weight = shape.GetDensity(place) * area;
      const f64::vec3 direction = glm::normalize(shape.GetDirection(place));
      texel.SolidAngle += weight;
      for (int h = 0; h < 9; ++h)
      {
        harmonics[h] += weight * f64::relievoShBasis(h, direction);
      }
    }
    const f64::vec3 light(image.GetLight(slice, column, row));
    for (int h = 0; h < 9; ++h)
    {
      texel.Light[h] = light * harmonics[h];
    }
    line.Add(texel);
  }
  return line;
}
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentIrradiance::vtkRelievoEnvironmentIrradiance()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  relievo::DescribeEnvironmentInput(this->Parameters, vtkRelievoMember(InputProjection),
    vtkRelievoMember(InputSRGB), vtkRelievoMember(InputMirrored));
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentIrradiance::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentIrradiance::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  return relievo::RequestWholeImage(inputs);
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentIrradiance::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkTable* output = vtkTable::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  std::fill_n(&this->Coefficients[0][0], 27, 0.);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  std::string problem;
  const EnvironmentImage image(input, this->GetInputArrayToProcess(0, inputs),
    static_cast<relievo::Projection>(this->InputProjection), this->InputMirrored, this->InputSRGB,
    problem);
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No irradiance: " << problem << ".");
    return 1;
  }
  const EnvironmentShape& shape = image.GetShape();
  const int parts = static_cast<int>(std::max(1., std::ceil(32. / shape.GetDetail())));
  // Summed per line, then in order: the result does not depend on the number of threads.
  std::vector<Sums> lines(static_cast<std::size_t>(shape.GetHeight()) * shape.GetSlices());
  vtkSMPTools::For(0, static_cast<vtkIdType>(lines.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType line = begin; line < end; ++line)
    {
      lines[line] = SumLine(image, static_cast<int>(line / shape.GetHeight()),
        static_cast<int>(line % shape.GetHeight()), parts);
    }
  });
  Sums whole;
  for (const Sums& line : lines)
  {
    whole.Add(line);
  }
  vtkNew<vtkDoubleArray> radiance;
  radiance->SetName("radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(9);
  for (int h = 0; h < 9; ++h)
  {
    const f64::vec3 value = whole.Light[h] * (4. * f64::relievoPi / whole.SolidAngle);
    for (int c = 0; c < 3; ++c)
    {
      this->Coefficients[h][c] = value[c];
    }
    radiance->SetTuple(h, this->Coefficients[h]);
  }
  output->AddColumn(radiance);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentIrradiance::GetCoefficient(int index, double color[3])
{
  for (int c = 0; c < 3; ++c)
  {
    color[c] = index >= 0 && index < 9 ? this->Coefficients[index][c] : 0.;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentIrradiance::GetIrradiance(const double normal[3], double color[3])
{
  f64::vec3 coefficients[9];
  for (int h = 0; h < 9; ++h)
  {
    const double* of = this->Coefficients[h];
    coefficients[h] = f64::vec3(of[0], of[1], of[2]);
  }
  const f64::vec3 unit = glm::normalize(f64::vec3(normal[0], normal[1], normal[2]));
  const f64::vec3 irradiance = f64::relievoShIrradiance(unit, coefficients);
  for (int c = 0; c < 3; ++c)
  {
    color[c] = irradiance[c];
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  for (int h = 0; h < 9; ++h)
  {
    const double* of = this->Coefficients[h];
    os << indent << "Coefficient " << h << ": " << of[0] << " " << of[1] << " " << of[2] << "\n";
  }
}
