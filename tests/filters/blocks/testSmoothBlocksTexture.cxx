// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Texture coordinates of surfaces of blocks: every length as in space, nothing mirrored, up is up,
// one texture throughout flat ground; tiles of an atlas.
#include "BlockScenes.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoSmoothBlocks.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

namespace testSmoothBlocksTexture
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoSmoothBlocks;

// Every triangle is as large in the texture as in space, in world units.
void TestTextureLengths()
{
  vtkSmartPointer<vtkImageData> image = MakeBlocks({ 9, 8, 7 }, AnyOf(12, 2));
  for (const bool mirrored : { false, true })
  {
    image->SetSpacing(mirrored ? -2. : 2., 1., 3.);
    for (const double noise : { 0., 0.5 })
    {
      vtkNew<Filter> filter;
      filter->SetStrength(0.2);
      filter->TextureCoordinatesOn();
      filter->SetTileSize(2.5);
      filter->SetNoiseAmplitude(noise);
      filter->SetNoiseScale(4.);
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      vtkPolyData* surface = Run(filter, image);
      vtkDataArray* texture = surface->GetPointData()->GetTCoords();
      double worst = 0.;
      int turned = 0;
      int upright = 0;
      int sides = 0;
      ForEachTriangle(surface, [&](vtkIdType, vtkIdList* ids, const Place* corners) {
        double at[3][2];
        for (int c = 0; c < 3; ++c)
        {
          texture->GetTuple(ids->GetId(c), at[c]);
        }
        for (int c = 0; c < 3; ++c)
        {
          const int next = (c + 1) % 3;
          const double length =
            std::sqrt(vtkMath::Distance2BetweenPoints(corners[c].data(), corners[next].data()));
          const double inTexture = 2.5 * std::hypot(at[next][0] - at[c][0], at[next][1] - at[c][1]);
          worst = std::max(worst, std::abs(inTexture - length));
        }
        const double area = (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
          (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
        turned += area <= 0.;
        double normal[3];
        AreaOf(corners, normal);
        vtkMath::Normalize(normal);
        if (std::abs(normal[2]) < 0.1)
        {
          // On steep sides v grows with height.
          double slope = 0.;
          for (int c = 0; c < 3; ++c)
          {
            const int next = (c + 1) % 3;
            slope += (at[next][1] - at[c][1]) * (corners[next][2] - corners[c][2]);
          }
          ++sides;
          upright += slope > 0.;
        }
      });
      RELIEVO_CHECK_AT_MOST(worst, 2e-6, "lengths in the texture, world units");
      RELIEVO_CHECK_THAT(turned == 0, std::to_string(turned) + " triangles are mirrored");
      RELIEVO_CHECK(sides > 20 && upright == sides);
    }
  }
  // Flat ground has one texture throughout, whatever the block.
  vtkNew<Filter> filter;
  filter->TextureCoordinatesOn();
  vtkPolyData* surface =
    Run(filter, MakeBlocks({ 12, 12, 3 }, [](int, int, int k) { return vtkTypeInt64(k == 0); }));
  double worst = 0.;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double place[3];
    double at[2];
    surface->GetPoint(i, place);
    surface->GetPointData()->GetTCoords()->GetTuple(i, at);
    if (place[2] == 1. && place[0] > 1. && place[0] < 11. && place[1] > 1. && place[1] < 11.)
    {
      for (int c = 0; c < 2; ++c)
      {
        const double off = at[c] - place[c];
        worst = std::max(worst, std::abs(off - std::round(off)));
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-6, "texture of flat ground");
}

// All corners of a face lie in the tile of its material.
void TestAtlas()
{
  vtkNew<Filter> filter;
  filter->SetStrength(0.25);
  filter->TextureCoordinatesOn();
  filter->SetAtlas(4, 2);
  vtkPolyData* surface = Run(filter, MakeBlocks({ 8, 8, 8 }, AnyOf(13, 9)));
  vtkDataArray* materials = surface->GetCellData()->GetArray("material");
  int outside = 0;
  std::set<int> seen;
  ForEachTriangle(surface, [&](vtkIdType cell, vtkIdList* ids, const Place*) {
    const int tile = (static_cast<int>(materials->GetComponent(cell, 0)) + 7) % 8;
    seen.insert(tile);
    for (int c = 0; c < 3; ++c)
    {
      double at[2];
      surface->GetPointData()->GetTCoords()->GetTuple(ids->GetId(c), at);
      const double inTile[] = { 4. * at[0] - tile % 4, 2. * at[1] - tile / 4 };
      // Strictly inside: nothing had to be cut.
      outside += !(inTile[0] > 0. && inTile[0] < 1. && inTile[1] > 0. && inTile[1] < 1.);
    }
  });
  RELIEVO_CHECK_THAT(outside == 0, std::to_string(outside) + " corners are outside their tile");
  RELIEVO_CHECK(seen.size() == 8);
}

// Faces that noise makes larger than their tile are told with the size that they need; with that
// size all fit, and keep their lengths.
void TestAtlasOfNoise()
{
  vtkNew<Filter> filter;
  filter->TextureCoordinatesOn();
  filter->SetAtlas(2, 1);
  filter->SetNoiseAmplitude(2.);
  filter->SetNoiseScale(2.);
  filter->SetInputData(MakeBlocks(
    { 20, 20, 4 }, [](int i, int, int k) { return vtkTypeInt64(k < 2 ? 1 + i % 2 : 0); }));
  double needed = 0.;
  {
    const std::string before = "these faces need ";
    ExpectMessage expect("larger than the tiles of the atlas");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    const std::string said = expect.Messages().empty() ? before : expect.Messages().front();
    needed = std::atof(said.c_str() + said.find(before) + before.size());
  }
  RELIEVO_CHECK_THAT(needed > 2. && needed < 8., std::to_string(needed));
  const double tile = 1.001 * needed;
  filter->SetTileSize(tile);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  double worst = 0.;
  ForEachTriangle(surface, [&](vtkIdType, vtkIdList* ids, const Place* corners) {
    for (int c = 0; c < 3; ++c)
    {
      const int next = (c + 1) % 3;
      double at[2][2];
      surface->GetPointData()->GetTCoords()->GetTuple(ids->GetId(c), at[0]);
      surface->GetPointData()->GetTCoords()->GetTuple(ids->GetId(next), at[1]);
      const double inTexture = tile * std::hypot(2. * (at[1][0] - at[0][0]), at[1][1] - at[0][1]);
      const double inSpace =
        std::sqrt(vtkMath::Distance2BetweenPoints(corners[c].data(), corners[next].data()));
      worst = std::max(worst, std::abs(inTexture - inSpace));
    }
  });
  RELIEVO_CHECK_AT_MOST(worst, 1e-5, "lengths in an atlas, blocks");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocksTexture)
{
  relievoTest::Session session;
  TestTextureLengths();
  TestAtlas();
  TestAtlasOfNoise();
  return session.Result();
}
}
