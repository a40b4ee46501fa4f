// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockCorners.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;

Vec3 Minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Unfolds the corners into a plane along the diagonal from the first to the third, keeping lengths.
std::array<Vec2, 4> Unfold(const std::array<Vec3, 4>& corners, int first)
{
  const Vec3 diagonal = Minus(corners[(first + 2) & 3], corners[first]);
  const double length = std::sqrt(Dot(diagonal, diagonal));
  std::array<Vec2, 4> flat;
  flat[first] = { 0., 0. };
  flat[(first + 2) & 3] = { length, 0. };
  for (const int step : { 1, 3 })
  {
    const Vec3 side = Minus(corners[(first + step) & 3], corners[first]);
    const double along = Dot(side, diagonal) / length;
    const double across = std::sqrt(std::max(Dot(side, side) - along * along, 0.));
    flat[(first + step) & 3] = { along, step == 1 ? -across : across };
  }
  return flat;
}

// Turns the corners about their mean until both edges along the first axis lie along it on average.
void Straighten(std::array<Vec2, 4>& flat)
{
  Vec2 along = { flat[1][0] - flat[0][0] + flat[2][0] - flat[3][0],
    flat[1][1] - flat[0][1] + flat[2][1] - flat[3][1] };
  const double length = std::hypot(along[0], along[1]);
  along = length > 0. ? Vec2{ along[0] / length, along[1] / length } : Vec2{ 1., 0. };
  Vec2 middle = { 0., 0. };
  for (Vec2& corner : flat)
  {
    corner = { corner[0] * along[0] + corner[1] * along[1],
      corner[1] * along[0] - corner[0] * along[1] };
    middle = { middle[0] + 0.25 * corner[0], middle[1] + 0.25 * corner[1] };
  }
  for (Vec2& corner : flat)
  {
    corner = { corner[0] - middle[0], corner[1] - middle[1] };
  }
}
}

//------------------------------------------------------------------------------
FaceTexture TextureOf(const BlockFace& face, const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh)
{
  const int u = (face.Axis + 1) % 3;
  const int v = (face.Axis + 2) % 3;
  const bool mirrored = vtkMath::Determinant3x3(settings.Axes) < 0.;
  const bool inOrder = face.Low != mirrored;
  int order[4]; // the corner of each point; 0 is the lowest along u and v, 1 is next to it along u
  std::array<Vec3, 4> corners;
  for (int point = 0; point < 4; ++point)
  {
    order[point] = inOrder ? (face.First + point) & 3 : (face.First + 4 - point) & 3;
    Vec3 block = surface.Offsets[face.Points[point]];
    block[u] += order[point] == 1 || order[point] == 2 ? 1. : 0.;
    block[v] += order[point] >= 2 ? 1. : 0.;
    for (int row = 0; row < 3; ++row)
    {
      corners[order[point]][row] = settings.Axes[row][0] * block[0] +
        settings.Axes[row][1] * block[1] + settings.Axes[row][2] * block[2];
    }
  }
  std::array<Vec2, 4> flat = Unfold(corners, face.First);
  Straighten(flat);

  // The face's place among the blocks: flat ground gets one continuous texture.
  const BlockBox& box = labels.GetBox();
  const vtkIdType place[3] = { face.Owner % box.Size[0], face.Owner / box.Size[0] % box.Size[1],
    face.Owner / (static_cast<vtkIdType>(box.Size[0]) * box.Size[1]) };
  const auto middleAlong = [&](int axis) {
    double squares = 0.;
    for (int row = 0; row < 3; ++row)
    {
      squares += settings.Axes[row][axis] * settings.Axes[row][axis];
    }
    return (settings.First[axis] + static_cast<double>(place[axis]) + 0.5) * std::sqrt(squares);
  };
  Vec2 middle = { middleAlong(u), middleAlong(v) };
  // Up on side faces is up in the texture, and nothing is mirrored when seen from outside.
  const bool turned = u == settings.Up;
  const double side = inOrder ? 1. : -1.;
  const auto turn = [turned, side](const Vec2& at) {
    return turned ? Vec2{ -side * at[1], at[0] } : Vec2{ side * at[0], at[1] };
  };
  middle = turn(middle);
  const bool atlas = mesh.AtlasColumns > 0 && mesh.AtlasRows > 0;
  const int tiles[2] = { mesh.AtlasColumns, mesh.AtlasRows };
  vtkIdType tile[2] = { 0, 0 };
  if (atlas)
  {
    const vtkTypeInt64 all = static_cast<vtkTypeInt64>(tiles[0]) * tiles[1];
    const vtkTypeInt64 number = ((labels.LabelAt(face.Owner) - 1) % all + all) % all;
    tile[0] = number % tiles[0];
    tile[1] = number / tiles[0];
  }
  FaceTexture texture;
  for (int point = 0; point < 4; ++point)
  {
    const Vec2 corner = turn(flat[order[point]]);
    for (int c = 0; c < 2; ++c)
    {
      const double start = middle[c] / mesh.TileSize;
      double value = corner[c] / mesh.TileSize;
      if (atlas)
      {
        texture.TileSize = std::max(texture.TileSize, 2. * std::abs(corner[c]));
        value = (static_cast<double>(tile[c]) + std::min(std::max(value + 0.5, 0.), 1.)) / tiles[c];
      }
      else
      {
        value += start - std::floor(start);
      }
      texture.Places[point][c] = static_cast<float>(value);
    }
  }
  return texture;
}
}
