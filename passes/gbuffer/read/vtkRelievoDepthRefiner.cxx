// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthRefiner.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoCell.h"
#include "vtkRelievoCellGeometry.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoMeshLinks.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace
{
constexpr std::uint32_t Nothing = vtkRelievoDrawTable::Nothing;

// Tolerance for depths on one surface: the largest difference from the depth of the triangle shown,
// in widths of a pixel, and its increase for every pixel between them in the image. A larger
// difference means another sheet, in front of or behind the triangle's silhouette.
constexpr double Gap = 0.1;
constexpr double Slope = 10.0;
}

// A thread's latest triangles, by their words: the row above showed most of them.
class vtkRelievoDepthRefiner::Recent
{
public:
  explicit Recent(const vtkRelievoDepthRefiner& refiner)
    : Refiner(refiner)
    , Entries(Size)
  {
  }

  const Triangle& Get(std::uint32_t word)
  {
    Entry& entry = this->Entries[word % Size];
    if (entry.Word != word)
    {
      entry.Word = word;
      entry.Seen = this->Refiner.GetTriangle(word, this->Scratch);
    }
    return entry.Seen;
  }

private:
  // 60 kB fit the second-level cache.
  static constexpr std::size_t Size = 512;
  struct Entry
  {
    std::uint32_t Word = Nothing;
    Triangle Seen;
  };
  const vtkRelievoDepthRefiner& Refiner;
  std::vector<Entry> Entries;
  vtkNew<vtkIdList> Scratch;
};

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::vtkRelievoDepthRefiner(
  const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view, const std::uint32_t* words)
  : Draws(draws)
  , View(view)
  , Words(words)
{
}

//------------------------------------------------------------------------------
bool vtkRelievoDepthRefiner::RunsOn(const Point& nearest, double depth) const
{
  const glm::dmat4& m = this->View.ViewToNDC;
  const double w = m[3][3] - m[2][3] * nearest.Depth;
  const double pixel = 2.0 * w / (std::abs(m[1][1]) * this->View.Viewport[3]);
  return std::abs(depth - nearest.Depth) <= (Gap + Slope * nearest.Distance) * pixel;
}

//------------------------------------------------------------------------------
std::uint32_t vtkRelievoDepthRefiner::GetWord(int x, int y) const
{
  return this->Words[static_cast<std::ptrdiff_t>(y) * this->View.Viewport[2] + x];
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::SetCorner(
  Triangle& triangle, int i, const glm::dmat4& modelToView, const glm::dvec3& model) const
{
  const glm::dvec4 eye = modelToView * glm::dvec4(model, 1.0);
  const glm::dvec4 clip = this->View.ViewToNDC * eye;
  triangle.Clip[i] = glm::dvec3(clip.x, clip.y, clip.w);
  triangle.Depth[i] = -eye.z;
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::Triangle vtkRelievoDepthRefiner::GetTriangle(
  std::uint32_t word, vtkIdList* scratch) const
{
  Triangle triangle;
  const vtkRelievoDrawTable::Hit hit = this->Draws.Find(word);
  if (hit.Mesh && !hit.Deformed && !hit.Changed)
  {
    const vtkRelievoCellGeometry cell(hit, scratch);
    triangle.Known = cell.Count == 3;
    triangle.Mesh = hit.Mesh;
    triangle.Place = hit.ModelToView;
    for (int i = 0; i < cell.Count; ++i)
    {
      this->SetCorner(triangle, i, *hit.ModelToView, cell.Corners[i]);
    }
  }
  return triangle;
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::Weights vtkRelievoDepthRefiner::GetWeights(
  const Triangle& triangle, int x, int y) const
{
  // The point of the triangle that is drawn at ndc is a weighted mean of its corners, with weights
  // for which the mean of the clip coordinates is a multiple of (ndc, 1). With the origin moved to
  // ndc these are the areas spanned by the corners' x and y; moving first preserves the precision
  // of small triangles.
  const glm::dvec2 size(this->View.Viewport[2], this->View.Viewport[3]);
  const glm::dvec2 ndc = relievo::f64::relievoNdcFromPixel(glm::dvec2(x, y), size);
  glm::dvec2 p[3];
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& corner = triangle.Clip[i];
    p[i] = glm::dvec2(corner.x - ndc.x * corner.z, corner.y - ndc.y * corner.z);
  }
  const double step = 2.0 / size.x;
  Weights weights;
  for (int i = 0; i < 3; ++i)
  {
    const int a = (i + 1) % 3;
    const int b = (i + 2) % 3;
    weights.At[i] = p[a].x * p[b].y - p[b].x * p[a].y;
    weights.Step[i] = step * (triangle.Clip[b].z * p[a].y - triangle.Clip[a].z * p[b].y);
  }
  return weights;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetDepth(
  const Triangle& triangle, const Weights& weights, double steps, bool& inside)
{
  double w[3];
  for (int i = 0; i < 3; ++i)
  {
    w[i] = weights.At[i] + steps * weights.Step[i];
  }
  const double sum = w[0] + w[1] + w[2];
  const double sign = sum < 0.0 ? -1.0 : 1.0;
  inside = w[0] * sign >= 0.0 && w[1] * sign >= 0.0 && w[2] * sign >= 0.0;
  const double* d = triangle.Depth;
  return d[0] + (w[1] * (d[1] - d[0]) + w[2] * (d[2] - d[0])) / sum;
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::Point vtkRelievoDepthRefiner::GetNearest(
  const Triangle& triangle, int x, int y) const
{
  const glm::dvec2 size(this->View.Viewport[2], this->View.Viewport[3]);
  const glm::dvec2 ndc = relievo::f64::relievoNdcFromPixel(glm::dvec2(x, y), size);
  Point nearest;
  const glm::dmat4& m = this->View.ViewToNDC;
  const double least = m[3][3] - m[2][3] * this->View.Near;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    glm::dvec3 clip[2] = { triangle.Clip[i], triangle.Clip[j] };
    double depth[2] = { triangle.Depth[i], triangle.Depth[j] };
    if (clip[0].z < least && clip[1].z < least)
    {
      continue;
    }
    const int behind = clip[0].z < clip[1].z ? 0 : 1;
    if (clip[behind].z < least)
    {
      // The part in front of the near plane.
      const int ahead = 1 - behind;
      const double cut = (least - clip[behind].z) / (clip[ahead].z - clip[behind].z);
      clip[behind] += cut * (clip[ahead] - clip[behind]);
      depth[behind] += cut * (depth[ahead] - depth[behind]);
    }
    // Relative to the pixel's centre, in pixels.
    const glm::dvec2 from = (glm::dvec2(clip[0]) / clip[0].z - ndc) * 0.5 * size;
    const glm::dvec2 to = (glm::dvec2(clip[1]) / clip[1].z - ndc) * 0.5 * size;
    const glm::dvec2 along = to - from;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? glm::clamp(-glm::dot(from, along) / length, 0.0, 1.0) : 0.0;
    const double distance = glm::length(from + t * along);
    if (distance < nearest.Distance)
    {
      nearest.Distance = distance;
      // Converts the position in the image to the position on the edge.
      const double share = t * clip[0].z / (t * clip[0].z + (1.0 - t) * clip[1].z);
      nearest.Depth = depth[0] + share * (depth[1] - depth[0]);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetNeighbourDepth(
  Pixel& pixel, const Triangle& shown, Recent& recent) const
{
  const int x = pixel.X;
  const int y = pixel.Y;
  std::uint32_t last = this->GetWord(x, y);
  // The nearest of all triangles that contain the centre is visible.
  double best = std::numeric_limits<double>::infinity();
  for (int j = std::max(0, y - 1); j <= std::min(this->View.Viewport[3] - 1, y + 1); ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(this->View.Viewport[2] - 1, x + 1); ++i)
    {
      const std::uint32_t word = this->GetWord(i, j);
      if (word == last || word == Nothing)
      {
        continue;
      }
      last = word;
      const Triangle& triangle = recent.Get(word);
      if (!triangle.Known)
      {
        continue;
      }
      bool inside = false;
      const double candidate = GetDepth(triangle, this->GetWeights(triangle, x, y), 0.0, inside);
      if (inside && this->RunsOn(pixel.Nearest, candidate))
      {
        const bool own = triangle.Mesh == shown.Mesh && triangle.Place == shown.Place;
        double& nearest = own ? best : pixel.Other;
        nearest = std::min(nearest, candidate);
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetAdjacentDepth(
  const Pixel& pixel, vtkRelievoMeshLinks& links) const
{
  const vtkRelievoDrawTable::Hit hit = this->Draws.Find(this->GetWord(pixel.X, pixel.Y));
  const vtkRelievoMeshLinks::Links& cells = links.Get(hit.Mesh);
  vtkNew<vtkIdList> ownScratch;
  vtkNew<vtkIdList> scratch;
  vtkRelievoPolygonCut cut;
  const vtkRelievoCell own(hit.Mesh, hit.Cell, ownScratch);
  double best = std::numeric_limits<double>::infinity();
  for (vtkIdType c = 0; c < own.Count; ++c)
  {
    const vtkIdType point = own.Points[c];
    for (vtkIdType k = cells.Offsets[point]; k < cells.Offsets[point + 1]; ++k)
    {
      const vtkRelievoCell cell(hit.Mesh, cells.Cells[k], scratch);
      const bool polygon = cell.Kind == vtkRelievoCell::Polys && cell.Count > 3;
      const auto* triangles = polygon ? &cut.Cut(hit.Mesh, cell.Points, cell.Count) : nullptr;
      const vtkIdType number =
        triangles ? static_cast<vtkIdType>(triangles->size()) : cell.Count - 2;
      for (vtkIdType i = 0; i < number; ++i)
      {
        Triangle triangle;
        for (int j = 0; j < 3; ++j)
        {
          const vtkIdType corner = triangles ? (*triangles)[static_cast<std::size_t>(i)][j] : i + j;
          glm::dvec3 model;
          hit.Mesh->GetPoint(cell.Points[corner], &model[0]);
          this->SetCorner(triangle, j, *hit.ModelToView, model);
        }
        bool inside = false;
        const double candidate =
          GetDepth(triangle, this->GetWeights(triangle, pixel.X, pixel.Y), 0.0, inside);
        if (inside && this->RunsOn(pixel.Nearest, candidate))
        {
          best = std::min(best, candidate);
        }
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::Refine(float* depths, vtkRelievoMeshLinks& links)
{
  const int width = this->View.Viewport[2];
  std::vector<Pixel> open;
  std::mutex openMutex;
  vtkRelievoForRows(this->View.Viewport[3], width, [&](vtkIdType from, vtkIdType to) {
    Recent recent(*this);
    std::vector<Pixel> ownOpen;
    for (vtkIdType y = from; y < to; ++y)
    {
      this->RefineRow(static_cast<int>(y), depths + y * width, recent, ownOpen);
    }
    const std::lock_guard<std::mutex> lock(openMutex);
    open.insert(open.end(), ownOpen.begin(), ownOpen.end());
  });
  // Few pixels: about one in several thousand.
  for (const Pixel& pixel : open)
  {
    float& depth = depths[static_cast<std::ptrdiff_t>(pixel.Y) * width + pixel.X];
    const double found = this->GetAdjacentDepth(pixel, links);
    depth = std::isfinite(found)   ? static_cast<float>(found)
      : std::isfinite(pixel.Other) ? static_cast<float>(pixel.Other)
                                   : depth;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::RefineRow(
  int y, float* depths, Recent& recent, std::vector<Pixel>& open) const
{
  const std::uint32_t* words =
    this->Words + static_cast<std::ptrdiff_t>(y) * this->View.Viewport[2];
  std::uint32_t last = Nothing;
  Triangle triangle;
  Weights weights{};
  int first = 0; // the pixel of the weights
  for (int x = 0; x < this->View.Viewport[2]; ++x)
  {
    const std::uint32_t word = words[x];
    if (word == Nothing)
    {
      continue;
    }
    if (word != last)
    {
      last = word;
      first = x;
      triangle = recent.Get(word);
      if (triangle.Known)
      {
        weights = this->GetWeights(triangle, x, y);
      }
    }
    if (!triangle.Known || !std::isfinite(depths[x]))
    {
      continue;
    }
    bool inside = false;
    double depth = GetDepth(triangle, weights, x - first, inside);
    if (!inside || !std::isfinite(depth))
    {
      Pixel pixel{ x, y, this->GetNearest(triangle, x, y) };
      depth = pixel.Nearest.Depth;
      const double found =
        std::isfinite(depth) ? this->GetNeighbourDepth(pixel, triangle, recent) : depth;
      if (std::isfinite(found))
      {
        depth = found;
      }
      else if (std::isfinite(depth))
      {
        open.push_back(pixel);
      }
    }
    if (std::isfinite(depth))
    {
      depths[x] = static_cast<float>(depth);
    }
  }
}
