// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEnvironmentImage.h
 * @brief The light of an environment image of any projection, by direction.
 *
 * Orientation: shaders/formulas/light/environment.glsl. A cube is one image of n x n x 6 points;
 * its slices are the faces +x -x +y -y +z -z in OpenGL's order.
 */
#ifndef vtkRelievoEnvironmentImage_h
#define vtkRelievoEnvironmentImage_h

#include "vtkRelievoFormulas.h"
#include "vtkRelievoParameterList.h"

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace relievo
{
/** Numbered as vtkRelievoEnvironmentConvert::ProjectionType. */
enum class Projection
{
  Automatic = 0,
  Equirectangular = 1,
  Cube = 2,
  SphereMap = 3
};

/**
 * The projection of an image of this size; Automatic if none fits. See the docstring of
 * vtkRelievoEnvironmentConvert::SetInputProjection.
 */
Projection ProjectionOfSize(const int size[3]);

/** Describes the settings of a filter's input, each by its member and setter. */
void DescribeEnvironmentInput(vtkRelievoParameterList& list, const int& projection,
  const std::function<void(int)>& setProjection, const bool& srgb,
  const std::function<void(bool)>& setSRGB, const bool& mirrored,
  const std::function<void(bool)>& setMirrored);

/** A position in an image: slice (face) and texture coordinates. */
struct EnvironmentPlace
{
  int Slice;
  f64::vec2 At;
};

/** The shape of an environment image: maps positions to directions and back. */
class EnvironmentShape
{
public:
  EnvironmentShape(Projection projection, int width, int height, bool mirrored);

  Projection GetProjection() const { return this->Kind; }
  bool IsMirrored() const { return this->Mirrored; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetSlices() const { return this->Kind == Projection::Cube ? 6 : 1; }
  vtkIdType GetNumberOfTexels() const
  {
    return static_cast<vtkIdType>(this->Width) * this->Height * this->GetSlices();
  }

  /** Direction of a position, not normalised. */
  f64::vec3 GetDirection(const EnvironmentPlace& place) const;

  /** Solid angle per area of [0, 1]^2, steradian; 0 outside a sphere map's circle. */
  double GetDensity(const EnvironmentPlace& place) const;

  /** Angle between adjacent texels, radian: in the narrower and the wider direction. */
  f64::vec2 GetSteps(const EnvironmentPlace& place) const;

  /** The position in the image of a direction of any length. */
  EnvironmentPlace GetPlace(const f64::vec3& direction) const;

  /** The width of a cube face with the same level of detail. */
  double GetDetail() const;

private:
  Projection Kind;
  int Width;
  int Height;
  bool Mirrored; // the light of (x, y, z) is where the formulas put (x, y, -z)
};

/** The texels as floats, red, green, blue. */
class EnvironmentImage
{
public:
  /**
   * Reads the image's array (null: none). One component is grey; a fourth component is ignored.
   * Integers are fractions of their type's largest number; sRGB values, also floats in [0, 1],
   * become linear. NaN counts as 0, infinity as 65504, the largest half. If the image cannot be
   * read, `problem` says why.
   */
  EnvironmentImage(vtkImageData* image, vtkDataArray* array, Projection projection, bool mirrored,
    bool sRGB, std::string& problem);

  /** The projection that the constructor would use; `problem` says why if there is none. */
  static Projection Check(
    vtkImageData* image, vtkDataArray* array, Projection projection, std::string& problem);

  const EnvironmentShape& GetShape() const { return this->Shape; }

  /** A texel. */
  const f32::vec3& GetTexel(int slice, int column, int row) const
  {
    return this->Texels[(static_cast<std::size_t>(slice) * this->Shape.GetHeight() + row) *
        this->Shape.GetWidth() +
      column];
  }

  /** A texel; outside a sphere map's circle, the nearest one inside. */
  f32::vec3 GetLight(int slice, int column, int row) const
  {
    return this->Shape.GetProjection() == Projection::SphereMap
      ? this->FetchSphereMap(column, row)
      : this->GetTexel(slice, column, row);
  }

  /**
   * Interpolates between the four texels around a direction of any length, across seams, poles and
   * edges.
   */
  f32::vec3 Sample(const f32::vec3& direction) const;

  /** Whether both sizes are even, so that texels can be averaged in groups of four. */
  bool CanHalve() const;

  /** An image half as wide and high: each texel is the mean of four over their solid angles. */
  EnvironmentImage Halve() const;

private:
  explicit EnvironmentImage(const EnvironmentShape& shape);

  f32::vec3 Fetch(int slice, int column, int row) const;
  f32::vec3 FetchCube(int face, int column, int row) const;
  f32::vec3 FetchSphereMap(int column, int row) const;

  EnvironmentShape Shape;
  std::vector<f32::vec3> Texels;
};
}

#endif
