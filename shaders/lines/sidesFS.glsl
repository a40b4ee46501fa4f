//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The sides of a pixel that are lines: x the right one, y the upper one. LINES_CREASES.
// LINES_VOLUMES: lines of volumes, which count as one part, instead of those of surfaces.
#ifdef LINES_VOLUMES
//RELIEVO::Include(frame/volume_depth.glsl)
uniform int relievoParallel;
#else
//RELIEVO::Include(gbuffer/read.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;
uniform mat4 relievoProjection;
uniform int linesOutlines;
uniform int linesFolds;
uniform float linesCreaseCosine;

// A jump exceeds the change expected from the slopes on the sides by this factor: two pixels within
// the curve of a ball's rim differ by 2.4 times as much as the two beside them.
const float linesJump = 4.0;
// And exceeds this many pixels' widths in depth; less is a steep slope.
const float linesSteep = 3.0;

struct linesPixel
{
  uint part;    // 0: background
  float depth;  // linear in the picture of a plane
  vec3 normal;
};

linesPixel linesFetch(ivec2 pixel)
{
  linesPixel found = linesPixel(uint(0), 0.0, vec3(0.0));
  if (all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(relievoSize))))
  {
#ifdef LINES_VOLUMES
    float depth = relievoFetchVolumeDepth(pixel);
    found.part = isinf(depth) ? uint(0) : uint(1);
#else
    found.part = relievoFetchPart(pixel);
    float depth = relievoFetchDepth(pixel);
#endif
    found.depth = isinf(depth) ? 0.0 : relievoParallel != 0 ? depth : 1.0 / depth;
#ifdef LINES_CREASES
    found.normal = relievoFetchGeometricNormal(pixel);
#endif
  }
  return found;
}

// A number of pixels' widths as a difference of stored depths: a pixel's width is proportional to z
// in perspective, so to 1 / z for depths stored as 1 / z.
float linesDepthOf(float widths, linesPixel a, linesPixel b)
{
  float width = 2.0 / (relievoProjection[1][1] * relievoSize.y);
  return widths * width * (relievoParallel != 0 ? 1.0 : min(a.depth, b.depth));
}

// Whether a surface without a crease may connect the two pixels.
bool linesLeads(linesPixel a, linesPixel b)
{
  return a.part == b.part && a.part != uint(0) && dot(a.normal, b.normal) >= linesCreaseCosine &&
    abs(a.depth - b.depth) <= linesDepthOf(linesJump * linesSteep, a, b);
}

bool linesLeads(linesPixel a, linesPixel b, linesPixel c, linesPixel d)
{
  return linesLeads(a, b) && linesLeads(b, c) && linesLeads(c, d);
}

// Whether there is a line between b and c of four pixels in a row. around: a surface without a
// crease connects b and c through the neighbouring pixels, so that their triangles only touch in a
// corner.
bool linesIsSide(linesPixel a, linesPixel b, linesPixel c, linesPixel d, bool around)
{
  if (b.part != c.part)
  {
    return linesOutlines != 0;
  }
  if (b.part == uint(0))
  {
    return false;
  }
  bool before = a.part == b.part; // a slope exists on this side
  bool after = d.part == c.part;
  if (linesFolds != 0 && (before || after))
  {
    float slope = max(before ? abs(b.depth - a.depth) : 0.0, after ? abs(d.depth - c.depth) : 0.0);
    if (abs(c.depth - b.depth) > linesJump * slope + linesDepthOf(linesSteep, b, c))
    {
      return true;
    }
  }
#ifdef LINES_CREASES
  float jump = dot(b.normal, c.normal);
  if (jump < linesCreaseCosine && !around)
  {
    // A surface that curves as much on both sides is round, or too far away, but not a crease.
    float beside =
      min(before ? dot(a.normal, b.normal) : 1.0, after ? dot(c.normal, d.normal) : 1.0);
    return acos(clamp(jump, -1.0, 1.0)) > 2.0 * acos(clamp(beside, -1.0, 1.0));
  }
#endif
  return false;
}

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  linesPixel here = linesFetch(pixel);
  linesPixel left = linesFetch(pixel - ivec2(1, 0));
  linesPixel right = linesFetch(pixel + ivec2(1, 0));
  linesPixel below = linesFetch(pixel - ivec2(0, 1));
  linesPixel above = linesFetch(pixel + ivec2(0, 1));
  bvec2 around = bvec2(false);
#ifdef LINES_CREASES
  linesPixel corner = linesFetch(pixel + ivec2(1, 1));
  around.x = linesLeads(here, above, corner, right) ||
    linesLeads(here, below, linesFetch(pixel + ivec2(1, -1)), right);
  around.y = linesLeads(here, right, corner, above) ||
    linesLeads(here, left, linesFetch(pixel + ivec2(-1, 1)), above);
#endif
  // The picture's border is not a line.
  bvec2 inside = lessThan(pixel + 1, ivec2(relievoSize));
  bool x =
    inside.x && linesIsSide(left, here, right, linesFetch(pixel + ivec2(2, 0)), around.x);
  bool y =
    inside.y && linesIsSide(below, here, above, linesFetch(pixel + ivec2(0, 2)), around.y);
  gl_FragData[0] = vec4(x ? 1.0 : 0.0, y ? 1.0 : 0.0, 0.0, 0.0);
}
