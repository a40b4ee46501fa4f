// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLensViews.h"

#include "vtkMath.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoCubeFaces.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace
{
constexpr unsigned char NoFace = relievo::CubeFaces;
constexpr double WidestSlope = 1.2;    // of a ray in a single view: 50 degrees
constexpr int Margin = 2;              // pixels around a view, to interpolate between pixels
constexpr int MostPixels = 8192;       // of a view each way, which every OpenGL can draw
constexpr double MostInAll = 1 << 18;  // of a face each way
constexpr int Probes = 256;            // each way, of the sides of pixels
constexpr double BetweenProbes = 1.02; // by so much a pixel may be narrower than its neighbours

// Where a ray passes through the plane of a face; false if it does not.
bool Pass(const double direction[3], int face, double place[2])
{
  const double away = vtkMath::Dot(relievo::CubeAxes[face][2], direction);
  place[0] = vtkMath::Dot(relievo::CubeAxes[face][0], direction) / away;
  place[1] = vtkMath::Dot(relievo::CubeAxes[face][1], direction) / away;
  return away > 0.0;
}
}

//------------------------------------------------------------------------------
void vtkRelievoLensViews::Bounds::Add(const double place[2])
{
  for (int i = 0; i < 2; ++i)
  {
    this->Low[i] = this->IsAny ? std::min(this->Low[i], place[i]) : place[i];
    this->High[i] = this->IsAny ? std::max(this->High[i], place[i]) : place[i];
  }
  this->IsAny = true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLensViews::GetFace(
  const double direction[3], bool single, int& face, double place[2])
{
  face = 0;
  if (!single)
  {
    for (int i = 1; i < relievo::CubeFaces; ++i)
    {
      const double more = vtkMath::Dot(relievo::CubeAxes[i][2], direction);
      face = more > vtkMath::Dot(relievo::CubeAxes[face][2], direction) ? i : face;
    }
  }
  return Pass(direction, face, place);
}

//------------------------------------------------------------------------------
bool vtkRelievoLensViews::IsWithinOne() const
{
  const Bounds& front = this->FaceBounds[0];
  return front.IsAny &&
    std::none_of(this->FaceBounds.begin() + 1, this->FaceBounds.end(),
      [](const Bounds& bounds) { return bounds.IsAny; }) &&
    std::max({ -front.Low[0], -front.Low[1], front.High[0], front.High[1] }) <= WidestSlope;
}

//------------------------------------------------------------------------------
// Finds the face of each pixel. A single face takes steeper rays than the faces of a cube.
void vtkRelievoLensViews::FindFaces(bool single)
{
  const int columns = this->Sensor->GetSize()[0];
  const int rows = this->Sensor->GetSize()[1];
  std::vector<std::array<Bounds, relievo::CubeFaces>> found(static_cast<std::size_t>(rows));
  std::atomic<bool> isWide{ false };
  std::atomic<bool> isMoving{ false };
  vtkRelievoWithThreads([&] {
    vtkSMPTools::For(0, rows, 4, [&](vtkIdType begin, vtkIdType end) {
      for (auto row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < columns; ++column)
        {
          double origin[3];
          double direction[3];
          double place[2];
          int face = NoFace;
          const bool isSeen = this->Sensor->GetCameraRay(column, row, origin, direction);
          if (isSeen && vtkMath::Norm(origin) != 0.0)
          {
            isMoving = true;
          }
          if (isSeen && GetFace(direction, single, face, place))
          {
            found[static_cast<std::size_t>(row)][static_cast<std::size_t>(face)].Add(place);
          }
          else if (isSeen)
          {
            isWide = true;
          }
          this->Faces[static_cast<std::size_t>(row) * columns + column] =
            static_cast<unsigned char>(isSeen ? face : NoFace);
        }
      }
    });
  });
  this->FaceBounds.assign(relievo::CubeFaces, Bounds());
  for (const auto& row : found)
  {
    for (std::size_t face = 0; face < relievo::CubeFaces; ++face)
    {
      if (row[face].IsAny)
      {
        this->FaceBounds[face].Add(row[face].Low);
        this->FaceBounds[face].Add(row[face].High);
      }
    }
  }
  this->IsOnePlace = !isMoving;
  if (isWide) // behind the single face
  {
    const double beyond[2] = { 2.0 * WidestSlope, 0.0 };
    this->FaceBounds[0].Add(beyond);
  }
}

//------------------------------------------------------------------------------
// The shortest side of a pixel in a face, of pixels that are long and thin half of the long one.
double vtkRelievoLensViews::GetPixelSide(int face) const
{
  const int* size = this->Sensor->GetSize();
  const int steps[2] = { std::min(size[0], Probes), std::min(size[1], Probes) };
  double shortest = std::numeric_limits<double>::infinity();
  for (int j = 0; j < steps[1]; ++j)
  {
    const int row = steps[1] > 1 ? int(std::int64_t(size[1] - 1) * j / (steps[1] - 1)) : 0;
    for (int i = 0; i < steps[0]; ++i)
    {
      const int column = steps[0] > 1 ? int(std::int64_t(size[0] - 1) * i / (steps[0] - 1)) : 0;
      if (this->Faces[static_cast<std::size_t>(row) * size[0] + column] != face)
      {
        continue;
      }
      double sides[2] = { 0.0, 0.0 };
      for (int axis = 0; axis < 2; ++axis)
      {
        double edges[2][2];
        bool isSeen = true;
        for (int end = 0; end < 2; ++end)
        {
          double origin[3];
          double direction[3];
          const double off = end - 0.5;
          isSeen = isSeen &&
            this->Sensor->GetCameraRay(
              column + (axis == 0 ? off : 0.0), row + (axis == 1 ? off : 0.0), origin, direction) &&
            Pass(direction, face, edges[end]);
        }
        sides[axis] =
          isSeen ? std::hypot(edges[1][0] - edges[0][0], edges[1][1] - edges[0][1]) : 0.0;
      }
      const double longer = std::max(sides[0], sides[1]);
      if (longer > 0.0)
      {
        shortest = std::min(shortest, std::max(std::min(sides[0], sides[1]), 0.5 * longer));
      }
    }
  }
  return shortest;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLensViews::Plan(vtkRelievoCameraModel* sensor, double oversampling)
{
  this->Sensor = sensor;
  this->Views.clear();
  const int* size = sensor->GetSize();
  this->Faces.assign(static_cast<std::size_t>(size[0]) * size[1], NoFace);
  this->Single = false;
  this->FindFaces(false);
  if (!this->IsOnePlace || !sensor->HasPicture())
  {
    return "colour is drawn from one place, and of pixels: got a " +
      std::string(sensor->GetClassName()) +
      ", expected a lens, a panorama or an orthographic camera; layers by rays are of any";
  }
  if (this->FaceBounds[0].IsAny &&
    !this->FaceBounds[2].IsAny) // rays of up to 50 degrees may be those of neighbouring faces
  {
    const std::vector<Bounds> six = this->FaceBounds;
    const std::vector<unsigned char> faces = this->Faces;
    this->FindFaces(true);
    this->Single = this->IsWithinOne();
    if (!this->Single)
    {
      this->FaceBounds = six;
      this->Faces = faces;
    }
  }
  for (int face = 0; face < relievo::CubeFaces; ++face)
  {
    const Bounds& bounds = this->FaceBounds[static_cast<std::size_t>(face)];
    if (!bounds.IsAny)
    {
      continue;
    }
    const double side = this->GetPixelSide(face);
    // A lone pixel whose edges are not seen has no side.
    const double density = oversampling * BetweenProbes / (std::isfinite(side) ? side : 1.0);
    int counts[2];
    int parts[2];
    for (int i = 0; i < 2; ++i)
    {
      const double pixels = std::ceil((bounds.High[i] - bounds.Low[i]) * density) + 1.0;
      if (!(pixels <= MostInAll))
      {
        std::ostringstream text;
        text << "the lens's picture would take " << pixels << " pixels each way, expected at most "
             << MostInAll << ": its pixels differ too much in size";
        return text.str();
      }
      counts[i] = static_cast<int>(pixels);
      parts[i] = (counts[i] - 1) / (MostPixels - 2 * Margin) + 1;
    }
    for (int part = 0; part < parts[0] * parts[1]; ++part)
    {
      View view;
      view.Face = face;
      view.PixelsPerUnit = density;
      const int which[2] = { part % parts[0], part / parts[0] };
      for (int i = 0; i < 2; ++i)
      {
        const int first = int(std::int64_t(counts[i]) * which[i] / parts[i]);
        const int end = int(std::int64_t(counts[i]) * (which[i] + 1) / parts[i]);
        view.Low[i] = bounds.Low[i] + first / density;
        view.High[i] = bounds.Low[i] + end / density;
        view.Size[i] = end - first + 2 * Margin;
      }
      this->Views.push_back(view);
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkRelievoLensViews::SetCamera(const View& view, vtkRelievoLensCamera* camera) const
{
  double rotation[9];
  double translation[3];
  for (int i = 0; i < 3; ++i)
  {
    const double* axis = relievo::CubeAxes[view.Face][i];
    for (int j = 0; j < 3; ++j)
    {
      rotation[3 * i + j] = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        rotation[3 * i + j] += axis[k] * this->Sensor->GetRotation()[3 * k + j];
      }
    }
    translation[i] = vtkMath::Dot(axis, this->Sensor->GetTranslation());
  }
  const double f = view.PixelsPerUnit;
  camera->SetSize(view.Size[0], view.Size[1]);
  camera->SetLens(vtkRelievoLensCamera::PINHOLE, 0, nullptr);
  camera->SetIntrinsics(f, f, 0.0, Margin - f * view.Low[0], Margin - f * view.Low[1]);
  camera->SetExtrinsics(rotation, translation);
}

//------------------------------------------------------------------------------
bool vtkRelievoLensViews::Find(const View& view, int column, int row, double place[2]) const
{
  const auto pixel =
    static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Sensor->GetSize()[0]) +
    static_cast<std::size_t>(column);
  double origin[3];
  double direction[3];
  double at[2];
  if (this->Faces[pixel] != view.Face ||
    !this->Sensor->GetCameraRay(column, row, origin, direction) || !Pass(direction, view.Face, at))
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    place[i] = Margin + view.PixelsPerUnit * (at[i] - view.Low[i]);
  }
  return at[0] >= view.Low[0] && at[1] >= view.Low[1] && at[0] < view.High[0] &&
    at[1] < view.High[1];
}
