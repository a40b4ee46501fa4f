// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentImages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
#define RELIEVO_SAME_CODE(name)                                                                    \
  static_assert(                                                                                   \
    vtkRelievoEnvironment::name == RELIEVO_ENVIRONMENT_##name, "differs from shaders/codes.glsl")
RELIEVO_SAME_CODE(EQUIRECTANGULAR);
RELIEVO_SAME_CODE(CUBE);
RELIEVO_SAME_CODE(SPHERE_MAP);
#undef RELIEVO_SAME_CODE

constexpr float Infinite = 65504.f; // the largest half

std::string SizeOf(const int size[3])
{
  std::ostringstream out;
  out << size[0] << " x " << size[1] << " x " << size[2] << " points";
  return out.str();
}

float Number(double value, double scale, bool sRGB)
{
  if (std::isnan(value))
  {
    return 0.f;
  }
  const double number = std::isinf(value) ? std::copysign(Infinite, value) : value * scale;
  return static_cast<float>(sRGB ? relievo::f64::relievoLinearFromSrgb(number) : number);
}

// Bilinear filtering and mipmaps at the rim read texels outside the circle.
void FillOutside(vtkRelievoEnvironmentImages::Pixels& pixels)
{
  const double half = 0.5 * pixels.Width;
  for (int y = 0; y < pixels.Height; ++y)
  {
    for (int x = 0; x < pixels.Width; ++x)
    {
      const double away[2] = { x + 0.5 - half, y + 0.5 - half };
      const double distance = std::hypot(away[0], away[1]);
      if (distance <= half)
      {
        continue;
      }
      // Half a texel's diagonal and a little more inside the circle.
      const double nearer = std::max(half - 0.75, 0.) / distance;
      const int column = std::clamp(static_cast<int>(half + away[0] * nearer), 0, pixels.Width - 1);
      const int row = std::clamp(static_cast<int>(half + away[1] * nearer), 0, pixels.Height - 1);
      for (int c = 0; c < 3; ++c)
      {
        pixels.Values[(static_cast<std::size_t>(y) * pixels.Width + x) * 3 + c] =
          pixels.Values[(static_cast<std::size_t>(row) * pixels.Width + column) * 3 + c];
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironmentImages::FindProjection(
  vtkImageData* image, int projection, std::string& failure)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  if (!values || values->GetNumberOfTuples() == 0 ||
    values->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    failure = "it has no scalars at its points";
    return Automatic;
  }
  const int* size = image->GetDimensions();
  const bool square = size[0] == size[1];
  const bool fits[4] = { false, size[0] == 2 * size[1] && size[2] == 1, square && size[2] == 6,
    square && size[2] == 1 };
  const char* const shapes[4] = { "2n x n x 1 (equirectangular), n x n x 6 (cube) or n x n x 1 "
                                  "(sphere map)",
    "2n x n x 1", "n x n x 6", "n x n x 1" };
  const int found = fits[Equirectangular] ? Equirectangular : (fits[Cube] ? Cube : SphereMap);
  const int meant = projection == Automatic ? found : projection;
  if (!fits[meant])
  {
    failure = "it has " + SizeOf(size) + "; " + shapes[projection] + " was expected";
    return Automatic;
  }
  return meant;
}

//------------------------------------------------------------------------------
vtkRelievoEnvironmentImages::Pixels vtkRelievoEnvironmentImages::Read(
  vtkImageData* image, int projection, bool sRGB, int limit)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const int components = values->GetNumberOfComponents();
  const int type = values->GetDataType();
  const double scale = type == VTK_FLOAT || type == VTK_DOUBLE ? 1. : 1. / values->GetDataTypeMax();
  const int* size = image->GetDimensions();
  const int factor = (std::max(size[0], size[1]) + limit - 1) / limit;
  Pixels pixels;
  pixels.Width = std::max(1, size[0] / factor);
  pixels.Height = std::max(1, size[1] / factor);
  pixels.Slices = size[2];
  pixels.Values.reserve(static_cast<std::size_t>(pixels.Width) * pixels.Height * size[2] * 3);
  for (int slice = 0; slice < size[2]; ++slice)
  {
    for (int y = 0; y < pixels.Height; ++y)
    {
      for (int x = 0; x < pixels.Width; ++x)
      {
        for (int c = 0; c < 3; ++c)
        {
          double sum = 0.;
          for (int k = 0; k < factor * factor; ++k)
          {
            const vtkIdType row = static_cast<vtkIdType>(slice) * size[1] + y * factor + k / factor;
            const vtkIdType at = row * size[0] + x * factor + k % factor;
            sum += Number(values->GetComponent(at, components < 3 ? 0 : c), scale, sRGB);
          }
          pixels.Values.push_back(static_cast<float>(sum / (factor * factor)));
        }
      }
    }
  }
  if (projection == SphereMap)
  {
    FillOutside(pixels);
  }
  pixels.Greatest = *std::max_element(pixels.Values.begin(), pixels.Values.end());
  return pixels;
}
