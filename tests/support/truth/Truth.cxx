// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
namespace
{
// Samples at (i + offset, j + offset), stored with a border that covers the neighbours outside.
class Samples
{
public:
  Samples(const View& view, const CastFunction& cast, int border, double offset)
    : Border(border)
    , Columns(view.Width + 1 + border)
    , Points(static_cast<size_t>(this->Columns) * (view.Height + 1 + border))
  {
    const int rows = view.Height + 1 + border;
    vtkSMPTools::For(0, rows, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType row = first; row < last; ++row)
      {
        for (int column = 0; column < this->Columns; ++column)
        {
          const double x = column - border + offset;
          const double y = static_cast<double>(row) - border + offset;
          this->Points[static_cast<size_t>(row) * this->Columns + column] =
            cast(view.PixelRay(x, y), view.Near, view.Far);
        }
      }
    });
  }

  const SurfacePoint& At(int x, int y) const
  {
    return this->Points[static_cast<size_t>(y + this->Border) * this->Columns + x + this->Border];
  }

private:
  const int Border;
  const int Columns;
  std::vector<SurfacePoint> Points;
};

// Depth along a ray of the tangent plane at a point; NaN for none.
double DepthOfPlane(const SurfacePoint& point, const Ray& ray)
{
  const double along = glm::dot(ray.Direction, point.Normal);
  const double depth = glm::dot(point.Position - ray.Origin, point.Normal) / along;
  return depth > 0. ? depth : std::numeric_limits<double>::quiet_NaN();
}

/*
 * Whether two samples lie on one surface. Between them, depth changes according to one of both
 * tangent planes or, over a crease, a mixture of both; a margin of half as much allows for small
 * triangles in between. A step onto another surface leaves that range, unless it is smaller.
 */
bool Continues(
  const SurfacePoint& here, const Ray& hereRay, const SurfacePoint& there, const Ray& thereRay)
{
  if (!there.Hit || there.Actor != here.Actor)
  {
    return false;
  }
  const double byHere = DepthOfPlane(here, thereRay) - here.Depth;
  const double byThere = there.Depth - DepthOfPlane(there, hereRay);
  const double slack =
    0.5 * std::max(std::abs(byHere), std::abs(byThere)) + 1e-9 * std::abs(here.Depth);
  const double change = there.Depth - here.Depth;
  // Written so that NaN gives false.
  return change >= std::min(byHere, byThere) - slack && change <= std::max(byHere, byThere) + slack;
}
}

//------------------------------------------------------------------------------
long long TruthImage::NumberOfHits() const
{
  return std::count_if(
    this->Pixels.begin(), this->Pixels.end(), [](const PixelTruth& p) { return p.Hit; });
}

//------------------------------------------------------------------------------
long long TruthImage::NumberOfInner() const
{
  return std::count_if(
    this->Pixels.begin(), this->Pixels.end(), [](const PixelTruth& p) { return p.Inner; });
}

//------------------------------------------------------------------------------
TruthImage TraceView(const View& view, const CastFunction& cast, const FinishFunction& finish)
{
  TruthImage image;
  image.Width = view.Width;
  image.Height = view.Height;
  image.Pixels.resize(static_cast<size_t>(view.Width) * view.Height);
  if (image.Pixels.empty())
  {
    return image;
  }
  const Samples centers(view, cast, 1, 0.5);
  const Samples corners(view, cast, 0, 0.);
  vtkSMPTools::For(0, view.Height, [&](vtkIdType first, vtkIdType last) {
    for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y)
    {
      for (int x = 0; x < view.Width; ++x)
      {
        PixelTruth& pixel = image.Pixels[static_cast<size_t>(y) * view.Width + x];
        static_cast<SurfacePoint&>(pixel) = centers.At(x, y);
        if (!pixel.Hit)
        {
          continue;
        }
        const Ray ray = view.PixelRay(x + 0.5, y + 0.5);
        pixel.Inner = true;
        for (int dy = -1; dy <= 1; ++dy)
        {
          for (int dx = -1; dx <= 1; ++dx)
          {
            pixel.Inner = pixel.Inner &&
              ((dx == 0 && dy == 0) ||
                Continues(pixel, ray, centers.At(x + dx, y + dy),
                  view.PixelRay(x + dx + 0.5, y + dy + 0.5)));
          }
        }
        for (int corner = 0; corner < 4; ++corner)
        {
          const int cx = x + corner % 2;
          const int cy = y + corner / 2;
          pixel.Inner =
            pixel.Inner && Continues(pixel, ray, corners.At(cx, cy), view.PixelRay(cx, cy));
        }
        if (finish)
        {
          finish(x, y, pixel);
        }
      }
    }
  });
  return image;
}

//------------------------------------------------------------------------------
double AngleDegrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}
}
