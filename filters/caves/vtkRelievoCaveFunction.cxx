// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCaveFunction.h"

#include "vtkRelievoCaveField.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRelievoCaveFunction);

namespace
{
bool IsFinite(const relievo::CavePlace& place)
{
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
}
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::SetLength(const char* name, double& member, double value, bool orZero)
{
  if (!std::isfinite(value) || value < 0. || (value == 0. && !orZero))
  {
    vtkErrorMacro(<< name << " is " << value << ", expected a number "
                  << (orZero ? "of at least 0" : "above 0") << "; it stays " << member << ".");
  }
  else if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::Describe(vtkRelievoParameterList& list)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  list.AddWhole(
    "seed", this->Seed, [this](int seed) { this->SetSeed(seed); }, least, most, "",
    "Seed of the random caves.");
  list.AddNumber(
    "tunnel_width", this->TunnelWidth, [this](double width) { this->SetTunnelWidth(width); }, 0.,
    infinity, "", "Width of tunnels in world units, at most half of Scale; 0: use Shell.");
  list
    .AddNumber(
      "scale", this->Scale, [this](double scale) { this->SetScale(scale); }, 0., infinity, "",
      "Distance between the bends of tunnels, in world units.")
    .Open = true;
  list
    .AddNumber(
      "vertical_scale", this->VerticalScale,
      [this](double scale) { this->SetVerticalScale(scale); }, 0., infinity, "",
      "Ratio of the width of caves to their height.")
    .Open = true;
  vtkRelievoParameter& up = list.AddChoice(
    "up", this->Up, [this](int axis) { this->SetUp(axis); }, { "x", "y", "z" },
    "The axis that points up.");
  up.Label = "Up Axis";
  up.Advanced = true;
  vtkRelievoParameter& shell = list.AddPair(
    "shell", this->Shell, [this](const double* limits) { this->SetShell(limits); },
    "Used if TunnelWidth is 0: air is where both noises, from -1 to 1, lie between these "
    "thresholds, the lower first.");
  shell.Advanced = true;
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::SetScale(double scale)
{
  this->SetLength("Scale", this->Scale, scale, false);
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::SetVerticalScale(double scale)
{
  this->SetLength("VerticalScale", this->VerticalScale, scale, false);
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::SetTunnelWidth(double width)
{
  this->SetLength("TunnelWidth", this->TunnelWidth, width, true);
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::SetShell(double low, double high)
{
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
  {
    vtkErrorMacro("Shell is " << low << " " << high
                              << ", expected two numbers, the lower first; it stays "
                              << this->Shell[0] << " " << this->Shell[1] << ".");
  }
  else if (this->Shell[0] != low || this->Shell[1] != high)
  {
    this->Shell[0] = low;
    this->Shell[1] = high;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::GetThresholds(double thresholds[2])
{
  const relievo::CaveField field = this->GetField();
  thresholds[0] = field.Middle - 1. / field.PerHalf;
  thresholds[1] = field.Middle + 1. / field.PerHalf;
}

//------------------------------------------------------------------------------
relievo::CaveField vtkRelievoCaveFunction::GetField() const
{
  relievo::CaveField field;
  const auto seed = static_cast<unsigned int>(this->Seed);
  const unsigned int first = (seed << 1u) | (seed >> 31u); // no bit is lost
  field.Seeds = { first, first ^ 1u };
  field.Cells.fill(1. / this->Scale);
  field.Cells[this->Up] *= this->VerticalScale;
  if (this->TunnelWidth > 0.)
  {
    const double width = std::min(this->TunnelWidth / this->Scale, relievo::CaveField::Widest);
    field.PerHalf = 1. / relievo::CaveField::HalfOf(width);
  }
  else
  {
    field.Middle = 0.5 * (this->Shell[0] + this->Shell[1]);
    field.PerHalf = 2. / (this->Shell[1] - this->Shell[0]);
  }
  return field;
}

//------------------------------------------------------------------------------
double vtkRelievoCaveFunction::EvaluateFunction(double point[3])
{
  const relievo::CaveField field = this->GetField();
  const relievo::CavePlace place = field.PlaceOf(point);
  if (!IsFinite(place))
  {
    return std::numeric_limits<double>::max();
  }
  const std::array<double, 2> walls = field.WallsAt(place);
  return std::max(walls[0], walls[1]);
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::EvaluateFunction(vtkDataArray* points, vtkDataArray* values)
{
  if (!points || !values)
  {
    vtkErrorMacro("EvaluateFunction was given no array of " << (points ? "values" : "points")
                                                            << "; give it two vtkDataArrays.");
    return;
  }
  this->Superclass::EvaluateFunction(points, values);
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::EvaluateGradient(double point[3], double gradient[3])
{
  std::fill(gradient, gradient + 3, 0.);
  const relievo::CaveField field = this->GetField();
  const relievo::CavePlace place = field.PlaceOf(point);
  if (!IsFinite(place))
  {
    return;
  }
  const std::array<double, 2> walls = field.WallsAt(place);
  const std::array<double, 3> slope = field.GradientAt(place, walls[0] < walls[1] ? 1 : 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    gradient[axis] = slope[axis] * field.Cells[axis];
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCaveFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "VerticalScale: " << this->VerticalScale << "\n";
  os << indent << "Up: " << this->Up << "\n";
  os << indent << "TunnelWidth: " << this->TunnelWidth << "\n";
  os << indent << "Shell: " << this->Shell[0] << " " << this->Shell[1] << "\n";
}
