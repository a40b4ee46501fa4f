// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where vertices between blocks move: symmetric under the 48 symmetries of the cube and under
// exchange of blocks and air; a step becomes a slope of 45 degrees; and no triangle of a face turns
// over or loses its area, for all 2^16 surroundings of a face, with any of its neighbours rigid or
// level, and for samples of up to six labels.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoBlockRule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

namespace testSmoothBlocksRule
{
namespace
{
using namespace relievoTest;
using relievo::BlockRule;
using Place = std::array<double, 3>;

// Symmetries: axis a goes to Axis[a], turned around where Flip says so.
struct Symmetry
{
  int Axis[3];
  bool Flip[3];

  unsigned int Of(unsigned int solid) const
  {
    unsigned int moved = 0;
    for (unsigned int block = 0; block < 8; ++block)
    {
      unsigned int to = 0;
      for (int a = 0; a < 3; ++a)
      {
        const unsigned int side = (block >> a & 1u) ^ (this->Flip[a] ? 1u : 0u);
        to |= side << this->Axis[a];
      }
      moved |= (solid >> block & 1u) << to;
    }
    return moved;
  }

  Place Of(const Place& offset) const
  {
    Place moved;
    for (int a = 0; a < 3; ++a)
    {
      moved[this->Axis[a]] = this->Flip[a] ? -offset[a] : offset[a];
    }
    return moved;
  }
};

void TestSymmetry()
{
  const BlockRule rule(0.11);
  int mismatches = 0;
  int symmetries = 0;
  int axes[3] = { 0, 1, 2 };
  do
  {
    for (int flips = 0; flips < 8; ++flips)
    {
      const Symmetry symmetry = { { axes[0], axes[1], axes[2] },
        { (flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0 } };
      ++symmetries;
      for (unsigned int solid = 0; solid < 256; ++solid)
      {
        mismatches += rule.Of(symmetry.Of(solid)) != symmetry.Of(rule.Of(solid));
        mismatches += rule.Of(solid) != rule.Of(255u ^ solid);
      }
    }
  } while (std::next_permutation(axes, axes + 3));
  RELIEVO_CHECK(symmetries == 48);
  RELIEVO_CHECK_THAT(mismatches == 0, std::to_string(mismatches) + " offsets are not symmetric");
}

void TestKnown()
{
  const BlockRule rule(0.125);
  const BlockRule none(0.);
  const Place still = { 0., 0., 0. };
  RELIEVO_CHECK(rule.Of(0x0fu) == still); // flat ground
  RELIEVO_CHECK(rule.Of(0u) == still);
  RELIEVO_CHECK(rule.Of(0x96u) == still && rule.Of(0x69u) == still); // a checkerboard
  // A step, solid at the lower x of the upper layer: both vertices of its face lie on a slope of 45
  // degrees, and the single block's corner moves inwards.
  const Place top = rule.Of(0x05u);
  const Place foot = rule.Of(0x5fu);
  RELIEVO_CHECK(top[0] == -0.25 && top[1] == 0. && top[2] == -0.25);
  RELIEVO_CHECK(foot[0] == 0.25 && foot[1] == 0. && foot[2] == 0.25);
  RELIEVO_CHECK_NEAR((1. + top[2] - foot[2]) / (foot[0] - top[0]), 1., 1e-15, "slope of a step");
  RELIEVO_CHECK((rule.Of(0x01u) == Place{ -0.375, -0.375, -0.375 }));
  for (unsigned int solid = 0; solid < 256; ++solid)
  {
    RELIEVO_CHECK(none.Of(solid) == still);
  }
}

struct Smallest
{
  double Area = 1.;
  double Inwards = 1.; // the part of the area in the plane of the face: negative is turned over
};

// The triangles of the face between blocks (1, 1, 0) and (1, 1, 1), by either diagonal.
void Add(const std::array<Place, 4>& offsets, Smallest& smallest)
{
  static const int triangles[4][3] = { { 0, 1, 3 }, { 0, 3, 2 }, { 0, 1, 2 }, { 1, 3, 2 } };
  std::array<Place, 4> corners = offsets;
  for (int i = 0; i < 4; ++i)
  {
    corners[i][0] += i & 1;
    corners[i][1] += i >> 1;
  }
  for (const int* triangle : triangles)
  {
    double a[3];
    double b[3];
    for (int c = 0; c < 3; ++c)
    {
      a[c] = corners[triangle[1]][c] - corners[triangle[0]][c];
      b[c] = corners[triangle[2]][c] - corners[triangle[0]][c];
    }
    const double normal[] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
    smallest.Inwards = std::min(smallest.Inwards, 0.5 * normal[2]);
    smallest.Area = std::min(smallest.Area, 0.5 * std::hypot(normal[0], normal[1], normal[2]));
  }
}

// The 3 x 3 x 2 blocks around that face; bit 9 z + 3 y + x.
unsigned int Surroundings(unsigned int bits)
{
  const unsigned int low = bits & 0xfu;
  const unsigned int low2 = bits >> 4 & 0xfu;
  const unsigned int high = bits >> 8 & 0xfu;
  const unsigned int high2 = bits >> 12 & 0xfu;
  return low | 1u << 4 | low2 << 5 | high << 9 | high2 << 14;
}

unsigned int AroundVertex(unsigned int blocks, int vertex)
{
  unsigned int solid = 0;
  for (int block = 0; block < 8; ++block)
  {
    const int x = (vertex & 1) + (block & 1);
    const int y = (vertex >> 1) + (block >> 1 & 1);
    solid |= (blocks >> (9 * (block >> 2) + 3 * y + x) & 1u) << block;
  }
  return solid;
}

void TestFaces()
{
  Smallest smallest;
  for (int step = 1; step <= 16; ++step)
  {
    const BlockRule rule(step / 64.);
    for (unsigned int bits = 0; bits < 65536; ++bits)
    {
      const unsigned int blocks = Surroundings(bits);
      std::array<Place, 4> offsets;
      for (int vertex = 0; vertex < 4; ++vertex)
      {
        offsets[vertex] = rule.Of(AroundVertex(blocks, vertex));
      }
      Add(offsets, smallest);
    }
  }
  RELIEVO_CHECK_AT_MOST(-smallest.Inwards, -0.012, "turned over, in blocks squared");
  RELIEVO_CHECK_AT_MOST(-smallest.Area, -0.031, "smallest area, negative");
}

// Vertices at rigid blocks stay; those at level blocks stay at their height and move half as far.
// Which vertices that are depends on which of the solid blocks are such.
void TestSpecialNeighbours()
{
  Smallest smallest;
  for (const double strength : { 0.125, 0.25 })
  {
    const BlockRule rule(strength);
    for (unsigned int bits = 0; bits < 65536; ++bits)
    {
      const unsigned int blocks = Surroundings(bits);
      std::array<Place, 4> offsets;
      unsigned int around[18] = {}; // vertices at each solid block
      for (int vertex = 0; vertex < 4; ++vertex)
      {
        offsets[vertex] = rule.Of(AroundVertex(blocks, vertex));
      }
      for (int block = 0; block < 18; ++block)
      {
        for (int vertex = 0; vertex < 4 && (blocks >> block & 1u); ++vertex)
        {
          const int x = block % 3 - (vertex & 1);
          const int y = block / 3 % 3 - (vertex >> 1);
          around[block] |= x >= 0 && x < 2 && y >= 0 && y < 2 ? 1u << vertex : 0u;
        }
      }
      for (unsigned int special = 1; special < 16; ++special)
      {
        unsigned int reached = 0;
        for (const unsigned int vertices : around)
        {
          reached |= vertices & ~special ? 0u : vertices;
        }
        for (int kind = 0; reached == special && kind < 4; ++kind)
        {
          std::array<Place, 4> moved = offsets;
          for (int vertex = 0; vertex < 4; ++vertex)
          {
            for (int c = 0; (special >> vertex & 1u) && c < 3; ++c)
            {
              // Kind 3 is rigid; the others are level, and up is x, y or z.
              moved[vertex][c] *= kind == 3 || kind == c ? 0. : 0.5;
            }
          }
          Add(moved, smallest);
        }
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(-smallest.Inwards, -0.012, "turned over beside rigid and level blocks");
  RELIEVO_CHECK_AT_MOST(-smallest.Area, -0.031, "smallest area there, negative");
}

void TestLabels()
{
  std::mt19937 random(5);
  Smallest smallest;
  const BlockRule rules[] = { BlockRule(0.125), BlockRule(0.25) };
  int different = 0;
  for (int sample = 0; sample < 400000; ++sample)
  {
    const unsigned int count = 3u + static_cast<unsigned int>(sample) % 4u;
    std::array<vtkTypeInt64, 18> blocks;
    for (vtkTypeInt64& label : blocks)
    {
      label = random() % count;
    }
    blocks[4] = 0;
    blocks[13] = 1;
    const BlockRule& rule = rules[sample >> 3 & 1];
    std::array<Place, 4> offsets;
    for (int vertex = 0; vertex < 4; ++vertex)
    {
      std::array<vtkTypeInt64, 8> labels;
      for (int block = 0; block < 8; ++block)
      {
        labels[block] = blocks[9 * (block >> 2) + 3 * ((vertex >> 1) + (block >> 1 & 1)) +
          (vertex & 1) + (block & 1)];
      }
      offsets[vertex] = rule.Of(labels);
      // Neither the order of labels nor their values matter.
      std::array<vtkTypeInt64, 8> renamed = labels;
      for (vtkTypeInt64& label : renamed)
      {
        label = (label + 2) % count * 1000003 - 5;
      }
      different += rule.Of(renamed) != offsets[vertex];
    }
    Add(offsets, smallest);
  }
  RELIEVO_CHECK_AT_MOST(-smallest.Inwards, -0.012, "turned over between labels");
  RELIEVO_CHECK_AT_MOST(-smallest.Area, -0.031, "smallest area between labels, negative");
  RELIEVO_CHECK(different == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocksRule)
{
  relievoTest::Session session;
  TestSymmetry();
  TestKnown();
  TestFaces();
  TestSpecialNeighbours();
  TestLabels();
  return session.Result();
}
}
