// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Simplex noise in three dimensions (K. Perlin 2001; the kernel of radius sqrt(0.5), which has no
// jumps), with a hash of integers, so that nothing is lost far from the origin: a point is a whole
// cell and the part of a cell beyond it. Repeats after 2^32 cells of the skewed lattice.

// A word for a corner of the lattice: every bit depends on all of them.
uint relievoNoiseHash(uint x, uint y, uint z, uint seed)
{
  uint word = (seed ^ z) * 0x9e3779b1u;
  word = ((word ^ (word >> uint(15))) ^ y) * 0x85ebca6bu;
  word = ((word ^ (word >> uint(13))) ^ x) * 0xc2b2ae35u;
  word = (word ^ (word >> uint(16))) * 0x7feb352du;
  return word ^ (word >> uint(15));
}

// What a corner at (x, y, z) from the point adds: (0.5 - r^2)^4 times the product with one of the
// twelve directions to the edges of a cube.
float relievoNoiseCorner(uint word, float x, float y, float z)
{
  float inside = max(float(0.5) - x * x - y * y - z * z, float(0.0));
  uint edge = ((word >> uint(16)) * uint(12)) >> uint(16);
  float u = edge < uint(8) ? x : y;
  float v = edge < uint(4) ? y : z;
  float along = ((edge & uint(1)) != uint(0) ? -u : u) + ((edge & uint(2)) != uint(0) ? -v : v);
  float square = inside * inside;
  return square * square * along;
}

// The noise in [-1, 1] at cell + part; the cell's coordinates are at most 2^29 in size, those of
// the part in [0, 1). Its mean is 0.
float relievoSimplexNoise(ivec3 cell, vec3 part, uint seed)
{
  // The lattice is that of cubes after moving each point by a third of its coordinates' sum along
  // all axes. Whole thirds of a cell are split off as integers; 3 * 2^29 keeps the sum positive,
  // which only an unsigned one can hold.
  uint sum = uint(cell.x) + uint(cell.y) + uint(cell.z) + uint(1610612736);
  int third = int(sum / uint(3)) - 536870912;
  float rest = (float(sum % uint(3)) + part.x + part.y + part.z) / float(3.0);
  float sx = part.x + rest;
  float sy = part.y + rest;
  float sz = part.z + rest;
  float bx = floor(sx);
  float by = floor(sy);
  float bz = floor(sz);
  sx -= bx;
  sy -= by;
  sz -= bz;
  uint x = uint(cell.x + third + int(bx));
  uint y = uint(cell.y + third + int(by));
  uint z = uint(cell.z + third + int(bz));
  float back = (sx + sy + sz) / float(6.0);
  float dx = sx - back;
  float dy = sy - back;
  float dz = sz - back;
  // The way from the lowest corner to the highest goes along the largest coordinate first.
  uint x1 = (sx >= sy && sx >= sz) ? uint(1) : uint(0);
  uint y1 = (sy > sx && sy >= sz) ? uint(1) : uint(0);
  uint z1 = uint(1) - x1 - y1;
  uint z2 = (sz > sx || sz > sy) ? uint(1) : uint(0);
  uint y2 = (y1 == uint(1) || (sy > sx || sy >= sz)) ? uint(1) : uint(0);
  uint x2 = uint(2) - y2 - z2;
  float g = float(1.0) / float(6.0);
  float value = relievoNoiseCorner(relievoNoiseHash(x, y, z, seed), dx, dy, dz) +
    relievoNoiseCorner(relievoNoiseHash(x + x1, y + y1, z + z1, seed), dx - float(x1) + g,
      dy - float(y1) + g, dz - float(z1) + g) +
    relievoNoiseCorner(relievoNoiseHash(x + x2, y + y2, z + z2, seed),
      dx - float(x2) + float(2.0) * g, dy - float(y2) + float(2.0) * g,
      dz - float(z2) + float(2.0) * g) +
    relievoNoiseCorner(relievoNoiseHash(x + uint(1), y + uint(1), z + uint(1), seed),
      dx - float(0.5), dy - float(0.5), dz - float(0.5));
  return value * float(76.0);
}
