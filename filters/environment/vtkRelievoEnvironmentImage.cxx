// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentImage.h"

#include "vtkRelievoArrayNames.h"
#include "vtkRelievoParameter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double LargestHalf = 65504.;
// Light is clamped here: sums and products of brighter texels overflow floats.
constexpr double Brightest = 1e12;

std::string Sizes(const int size[3])
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]);
}

// Whether an image of this size can have the projection; if not, `problem` says why.
bool Fits(const int size[3], Projection projection, std::string& problem)
{
  const char* wanted = nullptr;
  switch (projection)
  {
    case Projection::Cube:
      wanted = size[0] != size[1] || size[2] != 6 ? "a cube is n x n x 6" : nullptr;
      break;
    case Projection::SphereMap:
      wanted = size[0] != size[1] || size[2] != 1 ? "a sphere map is n x n x 1" : nullptr;
      break;
    case Projection::Equirectangular:
      wanted = size[2] != 1 ? "an equirectangular image has one slice" : nullptr;
      break;
    default:
      wanted = "neither n x n x 6 (a cube) nor 2n x n x 1 (equirectangular) nor n x n x 1 (a "
               "sphere map); set InputProjection";
  }
  if (wanted)
  {
    problem = "the image is " + Sizes(size) + ", but " + wanted;
  }
  return !wanted;
}

float Number(double value, double scale, bool sRGB)
{
  if (std::isnan(value))
  {
    return 0.f;
  }
  const double number = std::isinf(value) ? std::copysign(LargestHalf, value) : value * scale;
  const double light = sRGB ? f64::relievoLinearFromSrgb(number) : number;
  return static_cast<float>(std::clamp(light, -Brightest, Brightest));
}
}

//------------------------------------------------------------------------------
void DescribeEnvironmentInput(vtkRelievoParameterList& list, const int& projection,
  const std::function<void(int)>& setProjection, const bool& srgb,
  const std::function<void(bool)>& setSRGB, const bool& mirrored,
  const std::function<void(bool)>& setMirrored)
{
  list.AddChoice("input_projection", projection, setProjection,
    { "automatic", "equirectangular", "cube", "sphere_map" },
    "The projection of the image. Automatic is chosen by size: n x n x 6 is a cube, 2n x n "
    "equirectangular, n x n a sphere map.");
  list.AddFlag("input_srgb", srgb, setSRGB,
    "Whether the image's values are sRGB, as in most 8-bit pictures. It is never guessed.");
  list
    .AddFlag("input_mirrored", mirrored, setMirrored,
      "Whether the light of (x, y, z) is in the place of (x, y, -z), as in cubes of six pictures "
      "taken from inside.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
Projection ProjectionOfSize(const int size[3])
{
  if (size[0] == size[1] && size[2] == 6)
  {
    return Projection::Cube;
  }
  if (size[2] != 1)
  {
    return Projection::Automatic;
  }
  return size[0] == 2 * size[1]
    ? Projection::Equirectangular
    : (size[0] == size[1] ? Projection::SphereMap : Projection::Automatic);
}

//------------------------------------------------------------------------------
EnvironmentShape::EnvironmentShape(Projection projection, int width, int height, bool mirrored)
  : Kind(projection)
  , Width(width)
  , Height(height)
  , Mirrored(mirrored)
{
}

//------------------------------------------------------------------------------
f64::vec3 EnvironmentShape::GetDirection(const EnvironmentPlace& place) const
{
  f64::vec3 direction;
  switch (this->Kind)
  {
    case Projection::Cube:
      direction = f64::relievoDirectionFromCube(place.At, place.Slice);
      break;
    case Projection::SphereMap:
      direction = f64::relievoDirectionFromSphereMap(place.At);
      break;
    default:
      direction = f64::relievoDirectionFromEquirectangular(place.At);
  }
  direction.z = this->Mirrored ? -direction.z : direction.z;
  return direction;
}

//------------------------------------------------------------------------------
double EnvironmentShape::GetDensity(const EnvironmentPlace& place) const
{
  switch (this->Kind)
  {
    case Projection::Cube:
      return f64::relievoCubeDensity(place.At);
    case Projection::SphereMap:
      return f64::relievoSphereMapDensity(place.At);
    default:
      return f64::relievoEquirectangularDensity(place.At);
  }
}

//------------------------------------------------------------------------------
f64::vec2 EnvironmentShape::GetSteps(const EnvironmentPlace& place) const
{
  if (this->Kind == Projection::Cube)
  {
    // A step of 2 / n in the face's plane at distance `far`: perpendicular to the view, or along
    // it.
    const double far = glm::length(f64::relievoDirectionFromCube(place.At, place.Slice));
    return f64::vec2(2. / this->Width / (far * far), 2. / this->Width / far);
  }
  if (this->Kind == Projection::SphereMap)
  {
    const double radius = std::min(2. * glm::length(place.At - 0.5), 1.);
    const double squeeze = std::max(std::sqrt(1. - radius * radius), 1. / this->Width);
    return f64::vec2(4. / this->Width * squeeze, 4. / this->Width / squeeze);
  }
  const double down = Pi / this->Height;
  const double across =
    2. * Pi / this->Width * std::max(std::cos((place.At.y - 0.5) * Pi), 0.5 * down);
  return f64::vec2(std::min(down, across), std::max(down, across));
}

//------------------------------------------------------------------------------
EnvironmentPlace EnvironmentShape::GetPlace(const f64::vec3& direction) const
{
  f64::vec3 d = direction;
  d.z = this->Mirrored ? -d.z : d.z;
  switch (this->Kind)
  {
    case Projection::Cube:
    {
      const int face = f64::relievoCubeFace(d);
      return { face, f64::relievoCubeFromDirection(d, face) };
    }
    case Projection::SphereMap:
      return { 0, f64::relievoSphereMapFromDirection(d) };
    default:
      return { 0, f64::relievoEquirectangularFromDirection(d) };
  }
}

//------------------------------------------------------------------------------
double EnvironmentShape::GetDetail() const
{
  const double perFace =
    this->Kind == Projection::Cube ? 1. : (this->Kind == Projection::SphereMap ? 3. : 4.);
  return this->Width / perFace;
}

//------------------------------------------------------------------------------
EnvironmentImage::EnvironmentImage(const EnvironmentShape& shape)
  : Shape(shape)
  , Texels(static_cast<std::size_t>(shape.GetNumberOfTexels()))
{
}

//------------------------------------------------------------------------------
Projection EnvironmentImage::Check(
  vtkImageData* image, vtkDataArray* array, Projection projection, std::string& problem)
{
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    problem = "the image needs a point array of colours: its scalars, or another that is chosen as "
              "the input array. Its point arrays are: " +
      ArrayNames(image->GetPointData());
    return Projection::Automatic;
  }
  const int* size = image->GetDimensions();
  const Projection kind = projection == Projection::Automatic ? ProjectionOfSize(size) : projection;
  return Fits(size, kind, problem) ? kind : Projection::Automatic;
}

//------------------------------------------------------------------------------
EnvironmentImage::EnvironmentImage(vtkImageData* image, vtkDataArray* array, Projection projection,
  bool mirrored, bool sRGB, std::string& problem)
  : Shape(projection, 1, 1, mirrored)
{
  const Projection kind = Check(image, array, projection, problem);
  if (!problem.empty())
  {
    return;
  }
  const int* size = image->GetDimensions();
  this->Shape = EnvironmentShape(kind, size[0], size[1], mirrored);
  this->Texels.resize(array->GetNumberOfTuples());
  const int components = array->GetNumberOfComponents();
  const int type = array->GetDataType();
  const double scale = type == VTK_FLOAT || type == VTK_DOUBLE ? 1. : 1. / array->GetDataTypeMax();
  vtkSMPTools::For(0, array->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        this->Texels[i][c] = Number(array->GetComponent(i, components < 3 ? 0 : c), scale, sRGB);
      }
    }
  });
}

//------------------------------------------------------------------------------
f32::vec3 EnvironmentImage::FetchCube(int face, int column, int row) const
{
  const int last = this->Shape.GetWidth() - 1;
  const int inColumn = std::clamp(column, 0, last);
  const int inRow = std::clamp(row, 0, last);
  if (column == inColumn && row == inRow)
  {
    return this->GetTexel(face, column, row);
  }
  if (column != inColumn && row != inRow)
  {
    // Only three texels meet at a corner.
    return (this->GetTexel(face, inColumn, inRow) + this->FetchCube(face, column, inRow) +
             this->FetchCube(face, inColumn, row)) /
      3.f;
  }
  // The texel across the edge: found in a direction slightly beyond it.
  const double size = this->Shape.GetWidth();
  const auto beside = [size](int index, int inside) {
    return index == inside ? (index + 0.5) / size
                           : (index < inside ? -1e-3 / size : 1. + 1e-3 / size);
  };
  const f64::vec3 direction =
    f64::relievoDirectionFromCube(f64::vec2(beside(column, inColumn), beside(row, inRow)), face);
  const int other = f64::relievoCubeFace(direction);
  const f64::vec2 place = f64::relievoCubeFromDirection(direction, other) * size;
  return this->GetTexel(other, std::clamp(static_cast<int>(place.x), 0, last),
    std::clamp(static_cast<int>(place.y), 0, last));
}

//------------------------------------------------------------------------------
f32::vec3 EnvironmentImage::FetchSphereMap(int column, int row) const
{
  // Texels whose centre is outside the circle are empty: the nearest one inside is used.
  const int size = this->Shape.GetWidth();
  f64::vec2 away = f64::vec2(column + 0.5, row + 0.5) - 0.5 * size;
  const double distance = glm::length(away);
  if (distance > 0.5 * size)
  {
    // Slightly more than half a texel's diagonal inside the circle.
    away *= std::max(0.5 * size - 0.75, 0.) / distance;
  }
  const f64::vec2 place = away + 0.5 * size;
  return this->GetTexel(0, std::clamp(static_cast<int>(place.x), 0, size - 1),
    std::clamp(static_cast<int>(place.y), 0, size - 1));
}

//------------------------------------------------------------------------------
f32::vec3 EnvironmentImage::Fetch(int slice, int column, int row) const
{
  switch (this->Shape.GetProjection())
  {
    case Projection::Cube:
      return this->FetchCube(slice, column, row);
    case Projection::SphereMap:
      return this->FetchSphereMap(column, row);
    default:
    {
      // Crossing a pole leads to the other side.
      const int width = this->Shape.GetWidth();
      const int height = this->Shape.GetHeight();
      const bool over = row < 0 || row >= height;
      const int inside = row < 0 ? -1 - row : (over ? 2 * height - 1 - row : row);
      const int turned = (column + width + (over ? width / 2 : 0)) % width;
      return this->GetTexel(0, turned, std::clamp(inside, 0, height - 1));
    }
  }
}

//------------------------------------------------------------------------------
f32::vec3 EnvironmentImage::Sample(const f32::vec3& direction) const
{
  // In float: a coordinate's last bit is 1e-7 of the image, and this function dominates the time.
  f32::vec3 d = direction;
  d.z = this->Shape.IsMirrored() ? -d.z : d.z;
  int slice = 0;
  f32::vec2 place;
  switch (this->Shape.GetProjection())
  {
    case Projection::Cube:
      slice = f32::relievoCubeFace(d);
      place = f32::relievoCubeFromDirection(d, slice);
      break;
    case Projection::SphereMap:
      place = f32::relievoSphereMapFromDirection(d);
      break;
    default:
      place = f32::relievoEquirectangularFromDirection(d);
  }
  const float x = place.x * static_cast<float>(this->Shape.GetWidth()) - 0.5f;
  const float y = place.y * static_cast<float>(this->Shape.GetHeight()) - 0.5f;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const float u = x - static_cast<float>(column);
  const float v = y - static_cast<float>(row);
  const bool inner = column >= 0 && row >= 0 && column + 1 < this->Shape.GetWidth() &&
    row + 1 < this->Shape.GetHeight() && this->Shape.GetProjection() != Projection::SphereMap;
  const auto texel = [&](int i, int j) {
    return inner ? this->GetTexel(slice, column + i, row + j)
                 : this->Fetch(slice, column + i, row + j);
  };
  return (1.f - v) * ((1.f - u) * texel(0, 0) + u * texel(1, 0)) +
    v * ((1.f - u) * texel(0, 1) + u * texel(1, 1));
}

//------------------------------------------------------------------------------
bool EnvironmentImage::CanHalve() const
{
  return this->Shape.GetWidth() % 2 == 0 && this->Shape.GetHeight() % 2 == 0;
}

//------------------------------------------------------------------------------
EnvironmentImage EnvironmentImage::Halve() const
{
  const EnvironmentShape& from = this->Shape;
  const f64::vec2 size(from.GetWidth(), from.GetHeight());
  EnvironmentImage half(EnvironmentShape(
    from.GetProjection(), from.GetWidth() / 2, from.GetHeight() / 2, from.IsMirrored()));
  const int width = half.Shape.GetWidth();
  const int height = half.Shape.GetHeight();
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(height) * from.GetSlices(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType line = begin; line < end; ++line)
      {
        const auto slice = static_cast<int>(line / height);
        const auto row = static_cast<int>(line % height);
        for (int column = 0; column < width; ++column)
        {
          f64::vec3 sum(0.);
          double weights = 0.;
          for (int k = 0; k < 4; ++k)
          {
            const int i = 2 * column + k % 2;
            const int j = 2 * row + k / 2;
            const double weight = from.GetDensity({ slice, (f64::vec2(i, j) + 0.5) / size });
            sum += weight * f64::vec3(this->GetTexel(slice, i, j));
            weights += weight;
          }
          half.Texels[line * width + column] =
            f32::vec3(weights > 0. ? sum / weights : f64::vec3(0.));
        }
      }
    });
  return half;
}
}
