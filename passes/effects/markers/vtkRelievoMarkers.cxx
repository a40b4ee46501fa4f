// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkers.h"

#include "vtkRelievoMovedMesh.h"
#include "vtkRelievoParameter.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRelievoMarkers);

class vtkRelievoMarkers::Internals
{
public:
  std::vector<vtkSmartPointer<vtkProp3D>> Actors;
};

namespace
{
enum Values
{
  RADIUS,
  WIDTH,
  REACH,
  OPACITY,
  COLOR
};

constexpr double Orange[3] = { 1.0, 0.5, 0.0 };
constexpr double Skewed = 1e-6; // cosine between axes beyond which they do not form a box

bool IsBox(const double bounds[6])
{
  return std::all_of(bounds, bounds + 6, [](double v) { return std::isfinite(v); }) &&
    bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}

// Bounds without the prop's matrix, if the prop is an actor. For a mesh moved by its shader, the
// moved bounds: the mapper's are those at rest.
const double* GetOwnBounds(vtkProp3D* prop, double moved[6])
{
  if (auto* mover = dynamic_cast<vtkRelievoMovedMesh*>(prop))
  {
    mover->GetMovedBounds(moved);
    return moved;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetMapper() ? actor->GetMapper()->GetBounds() : prop->GetBounds();
}

// The box of the bounds under a matrix; false if the matrix shears or flattens it.
bool FindBox(const double bounds[6], vtkMatrix4x4* matrix, vtkRelievoMarkers::Box& box)
{
  const double middle[4] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]), 1.0 };
  double center[4];
  matrix->MultiplyPoint(middle, center);
  std::copy_n(center, 3, box.Center);
  for (int i = 0; i < 3; ++i)
  {
    for (int row = 0; row < 3; ++row)
    {
      box.Axes[i][row] = matrix->GetElement(row, i);
    }
    const double length = vtkMath::Normalize(box.Axes[i]);
    box.Half[i] = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]) * length;
    if (!(length > 0.0) || !std::isfinite(length))
    {
      return false;
    }
  }
  return std::abs(vtkMath::Dot(box.Axes[0], box.Axes[1])) < Skewed &&
    std::abs(vtkMath::Dot(box.Axes[1], box.Axes[2])) < Skewed &&
    std::abs(vtkMath::Dot(box.Axes[2], box.Axes[0])) < Skewed;
}
}

//------------------------------------------------------------------------------
vtkRelievoMarkers::vtkRelievoMarkers()
  : Internal(new Internals)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->SetThings("markers",
    "places must be finite, radii, opacities, widths of rings and reaches of shadows above 0, "
    "colours not negative");
  this->AddValue("radius", 1.0, 0.0, infinity, "world units", "Radius of the markers.");
  this->AddValue("width", 0.2, 0.0, 1.0, "radii", "Width of rings.").OnlyIf = "shape=ring";
  vtkRelievoParameter& reach =
    this->AddValue("reach", 4.0, 0.0, infinity, "radii", "Length of shadows downwards.");
  reach.OnlyIf = "shape=shadow";
  reach.Usual = 20.0;
  this->AddValue("opacity", 0.8, 0.0, 1.0, "", "Opacity over the surface below.");
  this->AddColorValue("color", Orange, "Linear colour of the markers; shadows have none.");
  this->Description.AddChoice(
    "shape", this->Shape, [this](int shape) { this->SetShape(shape); },
    { "ring", "glow", "disc", "shadow" },
    "Shape around each point; shadow is a soft dark blob on the surface below.");
  this->Description
    .AddVector(
      "up", this->Up, [this](const double* up) { this->SetUp(up[0], up[1], up[2]); },
      "Direction that shadows fall from, one for the whole set: up, or towards the light.")
    .IsDirection = true;
}

//------------------------------------------------------------------------------
vtkRelievoMarkers::~vtkRelievoMarkers() = default;

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetRadius(double radius)
{
  this->SetForAll(RADIUS, &radius);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetWidth(double width)
{
  this->SetForAll(WIDTH, &width);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetReach(double reach)
{
  this->SetForAll(REACH, &reach);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetOpacity(double opacity)
{
  this->SetForAll(OPACITY, &opacity);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetForAll(COLOR, color);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::GetColor(double color[3]) const
{
  std::copy_n(this->GetForAll(COLOR), 3, color);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::SetUp(double x, double y, double z)
{
  double up[3] = { x, y, z };
  const double length = vtkMath::Norm(up);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    vtkErrorMacro("SetUp was given (" << x << ", " << y << ", " << z
                                      << "), expected a non-zero direction; nothing is changed.");
    return;
  }
  if (!std::equal(up, up + 3, this->Up))
  {
    std::copy_n(up, 3, this->Up);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::AddActor(vtkProp3D* actor)
{
  auto& actors = this->Internal->Actors;
  if (actor && std::find(actors.begin(), actors.end(), actor) == actors.end())
  {
    actors.emplace_back(actor);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::RemoveActor(vtkProp3D* actor)
{
  auto& actors = this->Internal->Actors;
  const auto found = std::find(actors.begin(), actors.end(), actor);
  if (found != actors.end())
  {
    actors.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::RemoveAllActors()
{
  if (!this->Internal->Actors.empty())
  {
    this->Internal->Actors.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoMarkers::GetNumberOfActors()
{
  return static_cast<int>(this->Internal->Actors.size());
}

//------------------------------------------------------------------------------
vtkProp3D* vtkRelievoMarkers::GetActor(int i)
{
  return i >= 0 && i < this->GetNumberOfActors() ? this->Internal->Actors[i].Get() : nullptr;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoMarkers::Box> vtkRelievoMarkers::GetBoxes()
{
  std::vector<Box> boxes;
  vtkNew<vtkMatrix4x4> matrix;
  for (const auto& prop : this->Internal->Actors)
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    Box box;
    auto* actor = vtkActor::SafeDownCast(prop);
    double moved[6];
    const double* bounds = GetOwnBounds(prop, moved);
    if (!bounds || !IsBox(bounds))
    {
      continue;
    }
    if (actor && actor->GetMapper())
    {
      actor->GetMatrix(matrix);
    }
    else
    {
      matrix->Identity();
    }
    if (!FindBox(bounds, matrix, box))
    {
      // A sheared or flat box is replaced by one along the world's axes.
      matrix->Identity();
      bounds = prop->GetBounds();
      if (!bounds || !IsBox(bounds) || !FindBox(bounds, matrix, box))
      {
        continue;
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

//------------------------------------------------------------------------------
bool vtkRelievoMarkers::GetValuesForActors(double values[7]) const
{
  for (int i = RADIUS; i <= OPACITY; ++i)
  {
    values[i] = this->GetForAll(i)[0];
  }
  std::copy_n(this->GetForAll(COLOR), 3, values + COLOR);
  const bool finite = std::all_of(values, values + 7, [](double v) { return std::isfinite(v); });
  return finite && this->IsVisible(values) &&
    (values[RADIUS] > 0.0 || (this->Shape == SHADOW && values[RADIUS] == 0.0));
}

//------------------------------------------------------------------------------
bool vtkRelievoMarkers::IsVisible(const double* values) const
{
  return values[OPACITY] > 0.0 && (this->Shape != RING || values[WIDTH] > 0.0) &&
    (this->Shape != SHADOW || values[REACH] > 0.0);
}

//------------------------------------------------------------------------------
bool vtkRelievoMarkers::HasEffect(const double* row) const
{
  return row[3 + RADIUS] > 0.0 && this->IsVisible(row + 3);
}

//------------------------------------------------------------------------------
void vtkRelievoMarkers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Up: " << this->Up[0] << " " << this->Up[1] << " " << this->Up[2] << "\n";
  for (const auto& actor : this->Internal->Actors)
  {
    os << indent << "Actor: " << actor.GetPointer() << "\n";
  }
}
