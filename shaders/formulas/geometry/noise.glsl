// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Simplex noise in three dimensions (K. Perlin 2001; the continuous kernel of radius sqrt(0.5)),
// with an integer hash, so that no precision is lost far from the origin: a point is an integer
// cell and a part of a cell. Repeats after 2^32 cells of the skewed lattice.
//
// Each seed is one noise, shared by all filters. Caves and particles with the setting Seed = s both
// use the seeds 2 s and 2 s + 1, the second moved by 0.375 of a cell along each axis, and smooth
// blocks with NoiseSeed = s the seed s: with equal cells, whirls follow tunnels. Other seeds are
// not related.

// A word for a corner of the lattice, in which every bit depends on all inputs.
uint relievoNoiseHash(uint x, uint y, uint z, uint seed)
{
  uint word = (seed ^ z) * 0x9e3779b1u;
  word = ((word ^ (word >> uint(15))) ^ y) * 0x85ebca6bu;
  word = ((word ^ (word >> uint(13))) ^ x) * 0xc2b2ae35u;
  word = (word ^ (word >> uint(16))) * 0x7feb352du;
  return word ^ (word >> uint(15));
}

// The word's direction, one of the twelve to the edges of a cube, times (x, y, z).
float relievoNoiseAlong(uint word, float x, float y, float z)
{
  uint edge = ((word >> uint(16)) * uint(12)) >> uint(16);
  float u = edge < uint(8) ? x : y;
  float v = edge < uint(4) ? y : z;
  return ((edge & uint(1)) != uint(0) ? -u : u) + ((edge & uint(2)) != uint(0) ? -v : v);
}

// Contribution of a corner at (x, y, z) from the point: (0.5 - r^2)^4 times the product with its
// direction.
float relievoNoiseCorner(uint word, float x, float y, float z)
{
  float inside = max(float(0.5) - x * x - y * y - z * z, float(0.0));
  float square = inside * inside;
  return square * square * relievoNoiseAlong(word, x, y, z);
}

// The gradient of the contribution.
vec3 relievoNoiseCornerGradient(uint word, float x, float y, float z)
{
  float inside = max(float(0.5) - x * x - y * y - z * z, float(0.0));
  float cube = inside * inside * inside;
  float inwards = float(-8.0) * cube * relievoNoiseAlong(word, x, y, z);
  float along = cube * inside;
  return vec3(
    along * relievoNoiseAlong(word, float(1.0), float(0.0), float(0.0)) + inwards * x,
    along * relievoNoiseAlong(word, float(0.0), float(1.0), float(0.0)) + inwards * y,
    along * relievoNoiseAlong(word, float(0.0), float(0.0), float(1.0)) + inwards * z);
}

// The simplex of the lattice that contains a point, the same for all seeds: its lowest corner A,
// the steps from there to the next two, B and C (D is one step along all axes), and the point
// relative to A.
struct relievoSimplex
{
  uint ax;
  uint ay;
  uint az;
  uint bx;
  uint by;
  uint bz;
  uint cx;
  uint cy;
  uint cz;
  float x;
  float y;
  float z;
};

// The simplex at cell + part; the cell's coordinates are at most 2^29 in size, those of the part in
// [0, 1).
relievoSimplex relievoSimplexAt(ivec3 cell, vec3 part)
{
  // The lattice becomes cubic after moving each point by a third of its coordinates' sum along all
  // axes. Whole thirds of a cell are split off as integers; 3 * 2^29 keeps the sum positive, which
  // only an unsigned integer can hold.
  uint sum = uint(cell.x) + uint(cell.y) + uint(cell.z) + uint(1610612736);
  int third = int(sum / uint(3)) - 536870912;
  float rest = (float(sum % uint(3)) + part.x + part.y + part.z) / float(3.0);
  float sx = part.x + rest;
  float sy = part.y + rest;
  float sz = part.z + rest;
  float wholeX = floor(sx);
  float wholeY = floor(sy);
  float wholeZ = floor(sz);
  sx -= wholeX;
  sy -= wholeY;
  sz -= wholeZ;
  float back = (sx + sy + sz) / float(6.0);
  relievoSimplex simplex;
  simplex.ax = uint(cell.x + third + int(wholeX));
  simplex.ay = uint(cell.y + third + int(wholeY));
  simplex.az = uint(cell.z + third + int(wholeZ));
  simplex.x = sx - back;
  simplex.y = sy - back;
  simplex.z = sz - back;
  // The path from the lowest corner to the highest follows the largest coordinate first.
  simplex.bx = (sx >= sy && sx >= sz) ? uint(1) : uint(0);
  simplex.by = (sy > sx && sy >= sz) ? uint(1) : uint(0);
  simplex.bz = uint(1) - simplex.bx - simplex.by;
  simplex.cz = (sz > sx || sz > sy) ? uint(1) : uint(0);
  simplex.cy = (simplex.by == uint(1) || (sy > sx || sy >= sz)) ? uint(1) : uint(0);
  simplex.cx = uint(2) - simplex.cy - simplex.cz;
  return simplex;
}

// The noise of a seed in [-1, 1] at the point of a simplex. Its mean is 0.
float relievoSimplexNoiseIn(relievoSimplex s, uint seed)
{
  float g = float(1.0) / float(6.0);
  float value = relievoNoiseCorner(relievoNoiseHash(s.ax, s.ay, s.az, seed), s.x, s.y, s.z) +
    relievoNoiseCorner(relievoNoiseHash(s.ax + s.bx, s.ay + s.by, s.az + s.bz, seed),
      s.x - float(s.bx) + g, s.y - float(s.by) + g, s.z - float(s.bz) + g) +
    relievoNoiseCorner(relievoNoiseHash(s.ax + s.cx, s.ay + s.cy, s.az + s.cz, seed),
      s.x - float(s.cx) + float(2.0) * g, s.y - float(s.cy) + float(2.0) * g,
      s.z - float(s.cz) + float(2.0) * g) +
    relievoNoiseCorner(
      relievoNoiseHash(s.ax + uint(1), s.ay + uint(1), s.az + uint(1), seed), s.x - float(0.5),
      s.y - float(0.5), s.z - float(0.5));
  return value * float(76.0);
}

// The noise at cell + part: see relievoSimplexAt.
float relievoSimplexNoise(ivec3 cell, vec3 part, uint seed)
{
  return relievoSimplexNoiseIn(relievoSimplexAt(cell, part), seed);
}

// The gradient of the noise of a seed, per cell.
vec3 relievoSimplexNoiseGradientIn(relievoSimplex s, uint seed)
{
  float g = float(1.0) / float(6.0);
  return float(76.0) *
    (relievoNoiseCornerGradient(relievoNoiseHash(s.ax, s.ay, s.az, seed), s.x, s.y, s.z) +
      relievoNoiseCornerGradient(
        relievoNoiseHash(s.ax + s.bx, s.ay + s.by, s.az + s.bz, seed), s.x - float(s.bx) + g,
        s.y - float(s.by) + g, s.z - float(s.bz) + g) +
      relievoNoiseCornerGradient(
        relievoNoiseHash(s.ax + s.cx, s.ay + s.cy, s.az + s.cz, seed),
        s.x - float(s.cx) + float(2.0) * g, s.y - float(s.cy) + float(2.0) * g,
        s.z - float(s.cz) + float(2.0) * g) +
      relievoNoiseCornerGradient(
        relievoNoiseHash(s.ax + uint(1), s.ay + uint(1), s.az + uint(1), seed), s.x - float(0.5),
        s.y - float(0.5), s.z - float(0.5)));
}

// Upper bound of the noise's slope, per cell. A corner at the distance r adds t^4 (g . d) with t =
// 0.5 - r^2 and |g| = sqrt(2). Its gradient, t^4 g - 8 t^3 (g . d) d, is the product of g and a
// symmetric matrix that multiplies the component along d by t^3 (t - 8 r^2) and the rest by t^4, so
// it is at most sqrt(2) B(r) long, B being the larger of t^4 and t^3 (9 r^2 - 0.5). Over a simplex,
// the sum of the four B is below 0.0725 (testFormulasNoise bounds it by halving the simplex); 76 *
// sqrt(2) * 0.0725 = 7.793. The steepest place found has 6.7.
const float relievoSimplexNoiseSlope = float(7.8);
