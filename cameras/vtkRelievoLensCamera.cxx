// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLensCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkRelievoLensCamera);

namespace
{
constexpr int Used[] = { 0, 8, 4, 1 }; // number of coefficients, by lens
const std::vector<int> Counts[] = { { 0 }, { 0, 2, 4, 5, 8 }, { 0, 1, 2, 3, 4 }, { 0, 1 } };
const char* const Names[] = { "pinhole", "Brown-Conrady", "fisheye", "division" };

constexpr double WidestTangent = 1e4; // larger angles are beyond any polynomial of the tangent
constexpr int ScanSteps = 8192;
constexpr int NewtonSteps = 50;

// Radial part of Brown's lens: the factor of (x, y) at r², and its derivative by r².
double GetRadialFactor(const double c[8], double r2, double& slope)
{
  const double top = 1.0 + r2 * (c[0] + r2 * (c[1] + r2 * c[4]));
  const double topSlope = c[0] + r2 * (2.0 * c[1] + 3.0 * r2 * c[4]);
  const double bottom = 1.0 + r2 * (c[5] + r2 * (c[6] + r2 * c[7]));
  const double bottomSlope = c[5] + r2 * (2.0 * c[6] + 3.0 * r2 * c[7]);
  slope = (topSlope * bottom - top * bottomSlope) / (bottom * bottom);
  return bottom > 0.0 ? top / bottom : std::numeric_limits<double>::quiet_NaN();
}

// Brown's lens at (x, y): the distorted position, and the four derivatives.
void BendBrown(const double c[8], const double at[2], double bent[2], double jacobian[2][2])
{
  const double x = at[0];
  const double y = at[1];
  const double p1 = c[2];
  const double p2 = c[3];
  const double r2 = x * x + y * y;
  double slope = 0.0;
  const double factor = GetRadialFactor(c, r2, slope);
  bent[0] = x * factor + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x);
  bent[1] = y * factor + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y;
  jacobian[0][0] = factor + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x;
  jacobian[1][1] = factor + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  jacobian[0][1] = jacobian[1][0] = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
}

// A model transform may scale or mirror the world.
bool IsRotation(vtkMatrix4x4* view)
{
  constexpr double most = 1e-9;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double product = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k)
      {
        product += view->GetElement(i, k) * view->GetElement(j, k);
      }
      if (!(std::abs(product) < most) || view->GetElement(3, j) != 0.0)
      {
        return false;
      }
    }
  }
  return view->Determinant() > 0.0;
}

double GetDeterminant(const double m[2][2])
{
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoSensorWords> vtkRelievoLensCamera::GetWords()
{
  const std::string range = ": finite numbers, FX and FY above 0, DEG above 0 and at most 360";
  return { { "pinhole", "pinhole", { 0 }, range, PINHOLE },
    { "brown", "brown:K1,K2[,P1,P2[,K3[,K4,K5,K6]]]", { 2, 4, 5, 8 }, range, BROWN_CONRADY },
    { "fisheye", "fisheye[:K1,K2,K3,K4]", { 0, 1, 2, 3, 4 }, range, FISHEYE },
    { "division", "division:K", { 1 }, range, DIVISION } };
}

//------------------------------------------------------------------------------
vtkRelievoLensCamera::vtkRelievoLensCamera()
  : Limit(this->GetLimit())
{
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::SetIntrinsics(double fx, double fy, double skew, double cx, double cy)
{
  if (!(std::isfinite(fx + fy + skew + cx + cy) && fx > 0.0 && fy > 0.0))
  {
    vtkErrorMacro("The intrinsics are fx " << fx << ", fy " << fy << ", skew " << skew << ", cx "
                                           << cx << ", cy " << cy
                                           << ", expected finite numbers of pixels, fx and fy "
                                              "above 0.");
    return;
  }
  this->FocalX = fx;
  this->FocalY = fy;
  this->Skew = skew;
  this->PrincipalPoint[0] = cx;
  this->PrincipalPoint[1] = cy;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::GetIntrinsics(double matrix[9])
{
  const double rows[9] = { this->FocalX, this->Skew, this->PrincipalPoint[0], 0.0, this->FocalY,
    this->PrincipalPoint[1], 0.0, 0.0, 1.0 };
  std::copy_n(rows, 9, matrix);
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::SetLens(int lens, int count, const double* coefficients)
{
  if (lens < PINHOLE || lens > DIVISION)
  {
    vtkErrorMacro("Unknown lens " << lens << ", expected " << PINHOLE << " to " << DIVISION << ".");
    return;
  }
  if (!TakesCount(lens, count) ||
    !std::all_of(
      coefficients, coefficients + count, [](double value) { return std::isfinite(value); }))
  {
    vtkErrorMacro("The lens " << Names[lens] << " was given " << count << " coefficients, expected "
                              << GetCounts(lens) << ", all of them finite.");
    return;
  }
  this->Lens = lens;
  std::fill_n(this->Coefficients, static_cast<int>(MOST_COEFFICIENTS), 0.0);
  std::copy_n(coefficients, count, this->Coefficients);
  this->Limit = this->GetLimit();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::TakesCount(int lens, int count)
{
  return lens >= PINHOLE && lens <= DIVISION &&
    std::count(Counts[lens].begin(), Counts[lens].end(), count) != 0;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLensCamera::GetCounts(int lens)
{
  std::string words;
  for (int count = 0; count <= MOST_COEFFICIENTS; ++count)
  {
    if (TakesCount(lens, count))
    {
      const bool isLast = count == Counts[lens].back();
      words += (words.empty() ? "" : isLast ? " or " : ", ") + std::to_string(count);
    }
  }
  return words;
}

//------------------------------------------------------------------------------
double vtkRelievoLensCamera::GetCoefficient(int i)
{
  return i >= 0 && i < MOST_COEFFICIENTS ? this->Coefficients[i] : 0.0;
}

//------------------------------------------------------------------------------
// Distorted radius for this radius, or this angle, without the tangential part.
double vtkRelievoLensCamera::GetBent(double r, double* slope) const
{
  const double* c = this->Coefficients;
  const double r2 = r * r;
  if (this->Lens == FISHEYE)
  {
    *slope = 1.0 + r2 * (3.0 * c[0] + r2 * (5.0 * c[1] + r2 * (7.0 * c[2] + 9.0 * r2 * c[3])));
    return r * (1.0 + r2 * (c[0] + r2 * (c[1] + r2 * (c[2] + r2 * c[3]))));
  }
  double factorSlope = 0.0;
  const double factor = GetRadialFactor(c, r2, factorSlope);
  *slope = factor + 2.0 * r2 * factorSlope;
  return r * factor;
}

//------------------------------------------------------------------------------
// The end of the range in which the distorted radius grows.
double vtkRelievoLensCamera::GetLimit() const
{
  if (this->Lens != BROWN_CONRADY && this->Lens != FISHEYE)
  {
    return std::numeric_limits<double>::infinity();
  }
  const bool angles = this->Lens == FISHEYE;
  const double end = angles ? vtkMath::Pi() : std::atan(WidestTangent);
  const auto grows = [this, angles](double angle) {
    double slope = 0.0;
    this->GetBent(angles ? angle : std::tan(angle), &slope);
    return slope > 0.0;
  };
  for (int i = 1; i <= ScanSteps; ++i)
  {
    double high = end * i / ScanSteps;
    if (!grows(high))
    {
      double low = end * (i - 1) / ScanSteps;
      for (int step = 0; step < NewtonSteps; ++step)
      {
        const double middle = 0.5 * (low + high);
        (grows(middle) ? low : high) = middle;
      }
      return angles ? low : std::tan(low);
    }
  }
  return angles ? end : WidestTangent;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::Straighten(const double bent[2], double direction[3]) const
{
  direction[0] = bent[0];
  direction[1] = bent[1];
  direction[2] = 1.0;
  if (this->Lens == PINHOLE)
  {
    return true;
  }
  const double radius = std::hypot(bent[0], bent[1]);
  if (this->Lens == DIVISION)
  {
    direction[2] = 1.0 + this->Coefficients[0] * radius * radius;
    return true;
  }
  // Finds the radius, or the angle, by Newton's method between bounds.
  double low = 0.0;
  double high = this->Limit;
  double slope = 0.0;
  const bool tangential =
    this->Lens == BROWN_CONRADY && (this->Coefficients[2] != 0.0 || this->Coefficients[3] != 0.0);
  double r = high;
  if (this->GetBent(high, &slope) > radius)
  {
    r = std::min(radius, high);
    for (int i = 0; i < NewtonSteps; ++i)
    {
      const double off = this->GetBent(r, &slope) - radius;
      (off > 0.0 ? high : low) = r;
      double next = r - off / slope;
      if (!(next > low && next < high))
      {
        next = 0.5 * (low + high);
      }
      if (next == r || off == 0.0)
      {
        break;
      }
      r = next;
    }
  }
  else if (!tangential)
  {
    return false;
  }
  if (this->Lens == FISHEYE)
  {
    const double scale = radius > 0.0 ? std::sin(r) / radius : 1.0;
    direction[0] *= scale;
    direction[1] *= scale;
    direction[2] = std::cos(r);
    return true;
  }
  const double scale = radius > 0.0 ? r / radius : 1.0;
  direction[0] *= scale;
  direction[1] *= scale;
  if (!tangential)
  {
    return true;
  }
  double jacobian[2][2];
  for (int i = 0; i < NewtonSteps; ++i)
  {
    double now[2];
    BendBrown(this->Coefficients, direction, now, jacobian);
    const double off[2] = { now[0] - bent[0], now[1] - bent[1] };
    const double determinant = GetDeterminant(jacobian);
    if (!(determinant > 0.0))
    {
      return false;
    }
    const double step[2] = { (jacobian[1][1] * off[0] - jacobian[0][1] * off[1]) / determinant,
      (jacobian[0][0] * off[1] - jacobian[1][0] * off[0]) / determinant };
    direction[0] -= step[0];
    direction[1] -= step[1];
    const double size = 1.0 + std::hypot(direction[0], direction[1]);
    if (std::hypot(step[0], step[1]) < 1e-15 * size)
    {
      break;
    }
    if (i + 1 == NewtonSteps && std::hypot(off[0], off[1]) > 1e-12 * size)
    {
      return false;
    }
  }
  return std::hypot(direction[0], direction[1]) <= this->Limit && GetDeterminant(jacobian) > 0.0;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::Bend(const double point[3], double bent[2]) const
{
  const double side = this->Lens == PINHOLE ? 0.0 : std::hypot(point[0], point[1]);
  const double* c = this->Coefficients;
  if (this->Lens == DIVISION)
  {
    // The root of k1 side r² - z r + side = 0 that is nearer to the axis.
    const double under = point[2] * point[2] - 4.0 * c[0] * side * side;
    const double below = point[2] + std::sqrt(std::max(0.0, under));
    if (under < 0.0 || !(below > 0.0))
    {
      return false;
    }
    bent[0] = 2.0 * point[0] / below;
    bent[1] = 2.0 * point[1] / below;
    return true;
  }
  if (this->Lens == FISHEYE)
  {
    const double angle = std::atan2(side, point[2]);
    double slope = 0.0;
    const double scale = side > 0.0 ? this->GetBent(angle, &slope) / side : 0.0;
    bent[0] = scale * point[0];
    bent[1] = scale * point[1];
    return angle <= this->Limit && (side > 0.0 || point[2] > 0.0);
  }
  if (!(point[2] > 0.0))
  {
    return false;
  }
  const double straight[2] = { point[0] / point[2], point[1] / point[2] };
  if (this->Lens == PINHOLE)
  {
    std::copy_n(straight, 2, bent);
    return true;
  }
  double jacobian[2][2];
  BendBrown(c, straight, bent, jacobian);
  return side <= this->Limit * point[2] && GetDeterminant(jacobian) > 0.0;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::GetCameraRay(double u, double v, double origin[3], double direction[3])
{
  double bent[2];
  bent[1] = (v - this->PrincipalPoint[1]) / this->FocalY;
  bent[0] = (u - this->PrincipalPoint[0] - this->Skew * bent[1]) / this->FocalX;
  std::fill_n(origin, 3, 0.0);
  if (!std::isfinite(bent[0] + bent[1]) || !this->Straighten(bent, direction))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  vtkMath::Normalize(direction);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  double bent[2];
  if (!std::isfinite(point[0] + point[1] + point[2]) || !this->Bend(point, bent))
  {
    return Nowhere(pixel, 2);
  }
  pixel[0] = this->FocalX * bent[0] + this->Skew * bent[1] + this->PrincipalPoint[0];
  pixel[1] = this->FocalY * bent[1] + this->PrincipalPoint[1];
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::ApplyTo(vtkCamera* camera)
{
  if (!camera || this->Lens != PINHOLE)
  {
    vtkErrorMacro("ApplyTo was given " << (camera ? "a lens with distortion: " : "no camera: ")
                                       << "a vtkCamera is a pinhole without distortion.");
    return false;
  }
  // The rows of R are the axes in the world; R p + t is 0 at the eye.
  const double* right = this->Rotation;
  const double* down = this->Rotation + 3;
  const double* forward = this->Rotation + 6;
  double eye[3];
  double focus[3];
  const double distance = camera->GetDistance();
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = -(right[i] * this->Translation[0] + down[i] * this->Translation[1] +
      forward[i] * this->Translation[2]);
    focus[i] = eye[i] + distance * forward[i];
  }
  // The user transform moves picture positions, from -1 to 1 with y upwards.
  const double columns = this->Size[0];
  const double rows = this->Size[1];
  const double stretch = this->FocalX / this->FocalY;
  const double shear = -this->Skew * rows / (this->FocalY * columns);
  const double center[2] = { 2.0 * (this->PrincipalPoint[0] + 0.5) / columns - 1.0,
    1.0 - 2.0 * (this->PrincipalPoint[1] + 0.5) / rows };
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(-down[0], -down[1], -down[2]);
  camera->SetParallelProjection(0);
  camera->SetUseHorizontalViewAngle(0);
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan2(0.5 * rows, this->FocalY)));
  camera->SetWindowCenter(-(center[0] - shear * center[1]) / stretch, -center[1]);
  camera->SetViewShear(0.0, 0.0, 1.0);
  camera->SetUseExplicitProjectionTransformMatrix(false);
  camera->SetUseExplicitAspectRatio(false);
  camera->SetModelTransformMatrix(vtkNew<vtkMatrix4x4>());
  if (stretch == 1.0 && shear == 0.0)
  {
    camera->SetUserTransform(nullptr);
    return true;
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, stretch);
  matrix->SetElement(0, 1, shear);
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  camera->SetUserTransform(transform);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::IsPinhole(vtkCamera* camera)
{
  if (!camera)
  {
    return false;
  }
  vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0);
  const auto at = [projection](int i, int j) { return projection->GetElement(i, j); };
  const double zeros[] = { at(0, 3), at(1, 0), at(1, 3), at(3, 0), at(3, 1), at(3, 3) };
  return !camera->GetParallelProjection() && IsRotation(camera->GetModelViewTransformMatrix()) &&
    std::all_of(std::begin(zeros), std::end(zeros), [](double zero) { return zero == 0.0; }) &&
    at(0, 0) * at(3, 2) < 0.0 && at(1, 1) * at(3, 2) < 0.0;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensCamera::TakeFrom(vtkCamera* camera, int columns, int rows)
{
  if (!camera || columns < 1 || rows < 1)
  {
    vtkErrorMacro("TakeFrom was given " << (camera ? "" : "no camera and ") << columns << " x "
                                        << rows << " pixels, expected a camera and 1 x 1 or more.");
    return false;
  }
  if (!IsPinhole(camera))
  {
    vtkErrorMacro("The camera has no intrinsics K: "
      << (camera->GetParallelProjection() ? "its projection is parallel"
                                          : "its projection is not that of a pinhole")
      << ", expected a perspective camera.");
    return false;
  }
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(static_cast<double>(columns) / rows, -1.0, 1.0);
  const auto at = [projection](int i, int j) { return projection->GetElement(i, j); };
  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  double rotation[9];
  double translation[3];
  for (int i = 0; i < 3; ++i)
  {
    const double sign = i == 0 ? 1.0 : -1.0; // y and z are reversed
    for (int j = 0; j < 3; ++j)
    {
      rotation[3 * i + j] = sign * view->GetElement(i, j);
    }
    translation[i] = sign * view->GetElement(i, 3);
  }
  const double w = -at(3, 2);
  const vtkMTimeType before = this->GetMTime();
  this->SetExtrinsics(rotation, translation);
  if (this->GetMTime() == before)
  {
    return false; // the error was reported
  }
  this->SetSize(columns, rows);
  this->SetLens(PINHOLE, 0, nullptr);
  this->SetIntrinsics(0.5 * columns * at(0, 0) / w, 0.5 * rows * at(1, 1) / w,
    -0.5 * columns * at(0, 1) / w, 0.5 * columns * (1.0 - at(0, 2) / w) - 0.5,
    0.5 * rows * (1.0 + at(1, 2) / w) - 0.5);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  if (auto* same = vtkRelievoLensCamera::SafeDownCast(other))
  {
    this->FocalX = same->FocalX;
    this->FocalY = same->FocalY;
    this->Skew = same->Skew;
    std::copy_n(same->PrincipalPoint, 2, this->PrincipalPoint);
    this->Lens = same->Lens;
    std::copy_n(same->Coefficients, static_cast<int>(MOST_COEFFICIENTS), this->Coefficients);
    this->Limit = same->Limit;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  double matrix[9];
  this->GetIntrinsics(matrix);
  AddNumbers(fields, "K", matrix, 9);
  if (this->Lens != PINHOLE)
  {
    AddText(fields, "lens", Names[this->Lens]);
    AddNumbers(fields, "distortion", this->Coefficients, Used[this->Lens]);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLensCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FocalX: " << this->FocalX << "\n";
  os << indent << "FocalY: " << this->FocalY << "\n";
  os << indent << "Skew: " << this->Skew << "\n";
  os << indent << "PrincipalPoint: " << this->PrincipalPoint[0] << ", " << this->PrincipalPoint[1]
     << "\n";
  os << indent << "Lens: " << Names[this->Lens] << "\n";
  os << indent << "Coefficients:";
  for (double value : this->Coefficients)
  {
    os << " " << value;
  }
  os << "\n";
}
