// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampClusters.h"

#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Threads take lamps in pieces: enough of them to occupy all threads, few enough to join their
// lists.
constexpr int MostPieces = 32;
constexpr int LeastLamps = 16;
constexpr int MostLamps = 512;

constexpr int MostSlices = 256;

// Bounds memory and time of the lists: with more cells, the cells are made larger.
constexpr double MostCells = 1 << 21;
constexpr double MostEntries = 1 << 23;

// Shaders compute a pixel's slice from a logarithm in float.
constexpr double SliceMargin = 1e-5;
}

//------------------------------------------------------------------------------
// Cells are about as large as the lamps: smaller ones cost more to fill than they save.
void vtkRelievoLampClusters::Divide(
  const vtkRelievoFrameCamera& view, const vtkRelievoLampList& list)
{
  this->Width = view.Viewport[2];
  this->Height = view.Viewport[3];
  this->Parallel = view.Parallel;
  this->Bounds = vtkRelievoSphereBounds(view.ViewToNDC);
  double from = view.Far;
  double to = view.Near;
  double across = 0.0; // sum of the rectangles' mean sides, in pixels
  double thickness = 0.0;
  // Sums over the rectangles: area, half the edge, and both multiplied by the thickness.
  double area = 0.0;
  double edge = 0.0;
  double volume = 0.0;
  double band = 0.0;
  for (const vtkRelievoLampList::Lamp& lamp : list.GetLamps())
  {
    const double depth = -lamp.Sphere.Center.z;
    from = std::min(from, std::max(view.Near, depth - lamp.Sphere.Radius));
    to = std::max(to, std::min(view.Far, depth + lamp.Sphere.Radius));
    const double width = 0.5 * (lamp.Rectangle[2] - lamp.Rectangle[0]) * this->Width;
    const double height = 0.5 * (lamp.Rectangle[3] - lamp.Rectangle[1]) * this->Height;
    across += std::sqrt(width * height);
    const double near = std::max(view.Near, depth - lamp.Sphere.Radius);
    const double far = std::min(view.Far, depth + lamp.Sphere.Radius);
    const double thick = view.Parallel ? far - near : std::log2(std::max(1.0, far / near));
    thickness += thick;
    area += width * height;
    edge += width + height;
    volume += width * height * thick;
    band += (width + height) * thick;
  }
  const double count = std::max<double>(1.0, static_cast<double>(list.GetLamps().size()));
  this->From = from < to ? from : view.Near;
  this->To = from < to ? to : view.Far;
  const double range = this->Parallel ? this->To - this->From : std::log2(this->To / this->From);
  double tile = 4.0;
  while (tile < 64.0 && 2.0 * tile <= 0.2 * across / count)
  {
    tile *= 2.0;
  }
  double slices = std::min<double>(MostSlices, std::ceil(3.5 * range * count / thickness));
  slices = std::isfinite(slices) ? std::max(1.0, slices) : 1.0;
  const auto cells = [&]() {
    return std::ceil(this->Width / tile) * std::ceil(this->Height / tile) * slices;
  };
  // The number of cells touched by boxes around the lamps' visible parts, so that few large lamps
  // among many small ones get their due weight.
  const auto entries = [&]() {
    const double perThickness = slices / std::max(range, 1e-300);
    return (area + perThickness * volume) / (tile * tile) + (edge + perThickness * band) / tile +
      count + perThickness * thickness;
  };
  while (cells() > 1.0 && (cells() > MostCells || entries() > std::max(MostEntries, 2.0 * count)))
  {
    tile *= 2.0;
    slices = std::max(1.0, std::floor(0.5 * slices));
  }
  this->Tile = static_cast<int>(tile);
  this->Slices = static_cast<int>(slices);
  this->Columns = (this->Width + this->Tile - 1) / this->Tile;
  this->Rows = (this->Height + this->Tile - 1) / this->Tile;
  const double scale = range > 0.0 ? this->Slices / range : 0.0;
  const double start = this->Parallel ? this->From : std::log2(this->From);
  this->SliceScale = static_cast<float>(scale);
  this->SliceOffset = static_cast<float>(-start * scale);
  this->SliceStarts.clear();
  for (int slice = 0; slice <= this->Slices; ++slice)
  {
    const double share = static_cast<double>(slice) / this->Slices;
    this->SliceStarts.push_back(this->Parallel
        ? this->From + share * (this->To - this->From)
        : this->From * std::pow(this->To / this->From, share));
  }
  this->RowPlanes.clear();
  for (int row = 0; row <= this->Rows; ++row)
  {
    this->RowPlanes.push_back(
      this->Bounds.GetPlane(1, 2.0 * row * this->Tile / this->Height - 1.0));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLampClusters::AddSpans(
  const vtkRelievoLampList& list, int lamp, std::vector<std::vector<Span>>& slices) const
{
  const vtkRelievoSphereBounds::Sphere& sphere = list.GetLamps()[lamp].Sphere;
  const double depth = -sphere.Center.z;
  const auto findSlice = [this](double d) {
    const double f = this->Parallel ? d : std::log2(std::max(d, 0.5 * this->From));
    return std::clamp(
      static_cast<int>(std::floor(f * this->SliceScale + this->SliceOffset)), 0, this->Slices - 1);
  };
  const double margin = SliceMargin * std::max(std::abs(this->From), std::abs(this->To));
  const auto widen = [&](double d, double sign) {
    return d + sign * (this->Parallel ? margin : SliceMargin * std::abs(d));
  };
  const int firstSlice = findSlice(widen(depth - sphere.Radius, -1.0));
  const int lastSlice = findSlice(widen(depth + sphere.Radius, 1.0));
  for (int slice = firstSlice; slice <= lastSlice; ++slice)
  {
    const double from = widen(this->SliceStarts[slice], -1.0);
    const double to = widen(this->SliceStarts[slice + 1], 1.0);
    double least;
    double most;
    if (!this->Bounds.FindExtent(sphere, 1, from, to, least, most))
    {
      continue;
    }
    // Range of pixels whose centres lie in the extent, slightly enlarged.
    const auto firstPixel = [](double ndc, int size) {
      return std::max(0.0, std::ceil(0.5 * (ndc + 1.0) * size - 0.51));
    };
    const auto lastPixel = [](double ndc, int size) {
      return std::min(size - 1.0, std::floor(0.5 * (ndc + 1.0) * size - 0.49));
    };
    const double bottom = firstPixel(least, this->Height);
    const double top = lastPixel(most, this->Height);
    if (bottom > top)
    {
      continue;
    }
    const int lastRow = static_cast<int>(top) / this->Tile;
    for (int row = static_cast<int>(bottom) / this->Tile; row <= lastRow; ++row)
    {
      // The sphere's part beyond a plane lies within a smaller sphere, centred on the plane.
      vtkRelievoSphereBounds::Sphere part = sphere;
      bool reaches = true;
      for (int side = 0; side < 2; ++side)
      {
        const glm::dvec4& plane = this->RowPlanes[row + side];
        const double above = glm::dot(glm::dvec3(plane), sphere.Center) + plane.w;
        if ((side == 0) == (above < 0.0))
        {
          part.Center = sphere.Center - above * glm::dvec3(plane);
          const double left = sphere.Radius * sphere.Radius - above * above;
          part.Radius = left > 0.0 ? std::sqrt(left) : 0.0;
          reaches = reaches && left > 0.0;
        }
      }
      if (!reaches || !this->Bounds.FindExtent(part, 0, from, to, least, most))
      {
        continue;
      }
      const double first = firstPixel(least, this->Width);
      const double last = lastPixel(most, this->Width);
      if (first <= last)
      {
        slices[slice].push_back(
          { lamp, static_cast<short>(row), static_cast<short>(static_cast<int>(first) / this->Tile),
            static_cast<short>(static_cast<int>(last) / this->Tile) });
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLampClusters::FillSlice(int slice)
{
  Sheet& sheet = this->Sheets[slice];
  sheet.Starts.assign(static_cast<std::size_t>(this->Columns) * this->Rows + 1, 0);
  const auto forEach = [&](const auto& work) {
    for (const std::vector<Span>& piece : sheet.Pieces)
    {
      for (const Span& span : piece)
      {
        for (int column = span.First; column <= span.Last; ++column)
        {
          work(span.Lamp, static_cast<std::size_t>(span.Row) * this->Columns + column);
        }
      }
    }
  };
  forEach([&](int, std::size_t cell) { ++sheet.Starts[cell + 1]; });
  for (std::size_t cell = 1; cell < sheet.Starts.size(); ++cell)
  {
    sheet.Starts[cell] += sheet.Starts[cell - 1];
  }
  sheet.Lists.resize(static_cast<std::size_t>(sheet.Starts.back()));
  std::vector<int> next(sheet.Starts.begin(), sheet.Starts.end() - 1);
  forEach(
    [&](int lamp, std::size_t cell) { sheet.Lists[next[cell]++] = static_cast<float>(lamp); });
}

//------------------------------------------------------------------------------
void vtkRelievoLampClusters::Build(
  const vtkRelievoFrameCamera& view, const vtkRelievoLampList& list)
{
  this->Divide(view, list);
  const int count = static_cast<int>(list.GetLamps().size());
  const int size = std::clamp(count / MostPieces, LeastLamps, MostLamps);
  const int pieces = (count + size - 1) / size;
  std::vector<std::vector<std::vector<Span>>> found(static_cast<std::size_t>(pieces));
  vtkSMPTools::For(0, pieces, 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType piece = from; piece < to; ++piece)
    {
      found[piece].resize(static_cast<std::size_t>(this->Slices));
      const int end = std::min(count, static_cast<int>(piece + 1) * size);
      for (int lamp = static_cast<int>(piece) * size; lamp < end; ++lamp)
      {
        this->AddSpans(list, lamp, found[piece]);
      }
    }
  });
  this->Sheets.resize(static_cast<std::size_t>(this->Slices));
  for (int slice = 0; slice < this->Slices; ++slice)
  {
    this->Sheets[slice].Pieces.clear();
    for (auto& piece : found)
    {
      this->Sheets[slice].Pieces.push_back(std::move(piece[slice]));
    }
  }
  vtkSMPTools::For(0, this->Slices, 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType slice = from; slice < to; ++slice)
    {
      this->FillSlice(static_cast<int>(slice));
    }
  });
  const std::size_t cells = static_cast<std::size_t>(this->Columns) * this->Rows;
  this->Cells.resize(cells * this->Sheets.size() + 1);
  std::vector<std::size_t> starts(1, 0);
  for (const Sheet& sheet : this->Sheets)
  {
    starts.push_back(starts.back() + sheet.Lists.size());
  }
  this->Lists.resize(starts.back());
  vtkSMPTools::For(0, this->Slices, 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType slice = from; slice < to; ++slice)
    {
      Sheet& sheet = this->Sheets[slice];
      float* out = this->Cells.data() + cells * slice;
      const auto start = static_cast<int>(starts[slice]);
      for (std::size_t cell = 0; cell < cells; ++cell)
      {
        out[cell] = static_cast<float>(start + sheet.Starts[cell]);
      }
      std::copy(sheet.Lists.begin(), sheet.Lists.end(), this->Lists.begin() + start);
    }
  });
  this->Cells.back() = static_cast<float>(starts.back());
}

//------------------------------------------------------------------------------
void vtkRelievoLampClusters::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("relievoColumns", this->Columns);
  program->SetUniformi("relievoRows", this->Rows);
  program->SetUniformi("relievoSlices", this->Slices);
  program->SetUniformi("relievoTile", this->Tile);
  program->SetUniformf("relievoSliceScale", this->SliceScale);
  program->SetUniformf("relievoSliceOffset", this->SliceOffset);
}
