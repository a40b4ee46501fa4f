// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCameraModel.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRelievoThreads.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr vtkIdType Grain = 4096;      // rays per task of a thread
constexpr double RotationError = 1e-3; // of an element of R transposed times R

bool AreFinite(const double* values, int count)
{
  return std::all_of(values, values + count, [](double value) { return std::isfinite(value); });
}

// world = R transposed * camera
void Turn(const double rotation[9], const double camera[3], double world[3])
{
  const double from[3] = { camera[0], camera[1], camera[2] };
  for (int i = 0; i < 3; ++i)
  {
    world[i] = rotation[i] * from[0] + rotation[3 + i] * from[1] + rotation[6 + i] * from[2];
  }
}

// Right, down and forward of a view; false if the view has no direction.
bool FindAxes(
  const double position[3], const double target[3], const double up[3], double axes[3][3])
{
  double* const forward = axes[2];
  vtkMath::Subtract(target, position, forward);
  const bool apart = vtkMath::Normalize(forward) > 0.0;
  vtkMath::Cross(forward, up, axes[0]);
  const bool isView = apart && vtkMath::Normalize(axes[0]) > 0.0 && AreFinite(position, 3);
  vtkMath::Cross(forward, axes[0], axes[1]);
  return isView;
}
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::SetSize(int columns, int rows)
{
  if (columns < 1 || rows < 1)
  {
    vtkErrorMacro("The size is " << columns << " x " << rows
                                 << ", expected at least 1 column and 1 row of pixels.");
    return;
  }
  if (columns != this->Size[0] || rows != this->Size[1])
  {
    this->Size[0] = columns;
    this->Size[1] = rows;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::SetExtrinsics(const double rotation[9], const double translation[3])
{
  double deviation = AreFinite(rotation, 9) ? 0.0 : std::numeric_limits<double>::infinity();
  double given[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      given[i][j] = rotation[3 * i + j];
      double product = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k)
      {
        product += rotation[3 * k + i] * rotation[3 * k + j];
      }
      deviation = std::max(deviation, std::abs(product));
    }
  }
  if (!(deviation <= RotationError) || vtkMath::Determinant3x3(given) < 0.0)
  {
    vtkErrorMacro("R is not a rotation: its columns have an error of "
      << deviation << (deviation <= RotationError ? ", and it mirrors" : "")
      << ", expected 9 numbers, row by row, of orthogonal unit vectors of determinant 1.");
    return;
  }
  if (!AreFinite(translation, 3))
  {
    vtkErrorMacro("t is not finite, expected 3 numbers in world units.");
    return;
  }
  double nearest[3][3];
  vtkMath::Orthogonalize3x3(given, nearest);
  for (int i = 0; i < 9; ++i)
  {
    this->Rotation[i] = nearest[i / 3][i % 3];
  }
  std::copy_n(translation, 3, this->Translation);
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoCameraModel::CheckView(
  const double position[3], const double target[3], const double up[3])
{
  double axes[3][3];
  if (FindAxes(position, target, up, axes))
  {
    return std::string();
  }
  std::ostringstream text;
  const auto write = [&text](const double* place) {
    text << "(" << place[0] << ", " << place[1] << ", " << place[2] << ")";
  };
  text << "from ";
  write(position);
  text << " to ";
  write(target);
  text << " with ";
  write(up);
  text << " upwards is not a view, expected two different positions, and another direction upwards";
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkRelievoCameraModel::LookAt(
  const double position[3], const double target[3], const double up[3])
{
  double axes[3][3];
  if (!FindAxes(position, target, up, axes))
  {
    vtkErrorMacro(<< CheckView(position, target, up));
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(axes[i], 3, this->Rotation + 3 * i);
    this->Translation[i] = -vtkMath::Dot(axes[i], position);
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoCameraModel::Nowhere(double* values, int count)
{
  std::fill_n(values, count, std::numeric_limits<double>::quiet_NaN());
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoCameraModel::GetRay(double u, double v, double origin[3], double direction[3])
{
  if (!this->GetCameraRay(u, v, origin, direction))
  {
    return false;
  }
  vtkMath::Subtract(origin, this->Translation, origin);
  Turn(this->Rotation, origin, origin);
  Turn(this->Rotation, direction, direction);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoCameraModel::Project(const double point[3], double pixel[2])
{
  double camera[3];
  for (int i = 0; i < 3; ++i)
  {
    camera[i] = vtkMath::Dot(this->Rotation + 3 * i, point) + this->Translation[i];
  }
  return this->ProjectCameraPoint(camera, pixel);
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::GetRays(vtkDoubleArray* origins, vtkDoubleArray* directions)
{
  this->GetRowRays(0, this->Size[1], origins, directions);
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::GetRowRays(
  int first, int end, vtkDoubleArray* origins, vtkDoubleArray* directions)
{
  if (!origins || !directions || first < 0 || end < first || end > this->Size[1])
  {
    vtkErrorMacro("The rays of the rows " << first << " to " << end
                                          << " were asked for, expected rows of the picture, 0 to "
                                          << this->Size[1] << ", and two arrays to fill.");
    return;
  }
  const vtkIdType columns = this->Size[0];
  this->Fill(
    columns * (end - first), origins, directions, [columns, first](vtkIdType i, double* place) {
      place[0] = static_cast<double>(i % columns);
      place[1] = static_cast<double>(first + i / columns);
    });
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::GetRays(
  vtkDoubleArray* places, vtkDoubleArray* origins, vtkDoubleArray* directions)
{
  if (!places || !origins || !directions || places->GetNumberOfComponents() != 2)
  {
    vtkErrorMacro("GetRays expects places of 2 components and two arrays to fill.");
    return;
  }
  this->Fill(places->GetNumberOfTuples(), origins, directions,
    [places](vtkIdType i, double* place) { std::copy_n(places->GetPointer(2 * i), 2, place); });
}

//------------------------------------------------------------------------------
// For a number of positions, returned one by one by `Place`.
template <typename Place>
void vtkRelievoCameraModel::Fill(
  vtkIdType count, vtkDoubleArray* origins, vtkDoubleArray* directions, const Place& getPlace)
{
  for (vtkDoubleArray* array : { origins, directions })
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(count);
  }
  vtkRelievoWithThreads([&] {
    vtkSMPTools::For(0, count, Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double place[2];
        getPlace(i, place);
        this->GetRay(place[0], place[1], origins->GetPointer(3 * i), directions->GetPointer(3 * i));
      }
    });
  });
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::Project(vtkDoubleArray* points, vtkDoubleArray* places)
{
  if (!points || !places || points->GetNumberOfComponents() != 3)
  {
    vtkErrorMacro("Project expects points of 3 components and an array to fill.");
    return;
  }
  const vtkIdType count = points->GetNumberOfTuples();
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(count);
  vtkRelievoWithThreads([&] {
    vtkSMPTools::For(0, count, Grain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Project(points->GetPointer(3 * i), places->GetPointer(2 * i));
      }
    });
  });
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::GetRangeLimits(double limits[2])
{
  limits[0] = 0.0;
  limits[1] = std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
double vtkRelievoCameraModel::GetDepth(const double[3], const double point[3])
{
  return vtkMath::Dot(this->Rotation + 6, point) + this->Translation[2];
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::Copy(vtkRelievoCameraModel* other)
{
  if (!other)
  {
    return;
  }
  std::copy_n(other->Size, 2, this->Size);
  std::copy_n(other->Rotation, 9, this->Rotation);
  std::copy_n(other->Translation, 3, this->Translation);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::AddNumbers(
  vtkFieldData* fields, const char* name, const double* values, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  std::copy_n(values, count, array->GetPointer(0));
  if (fields)
  {
    fields->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::AddText(vtkFieldData* fields, const char* name, const char* text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  if (fields)
  {
    fields->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::AddTo(vtkFieldData* fields)
{
  AddNumbers(fields, "R", this->Rotation, 9);
  AddNumbers(fields, "t", this->Translation, 3);
}

//------------------------------------------------------------------------------
void vtkRelievoCameraModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "Rotation:";
  for (double value : this->Rotation)
  {
    os << " " << value;
  }
  os << "\n" << indent << "Translation:";
  for (double value : this->Translation)
  {
    os << " " << value;
  }
  os << "\n";
}
