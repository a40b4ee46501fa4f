// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Markers on surfaces: how much of a pixel is covered by what lies within a distance of a box (a
// point is a box of no size), and how dark a blob shadow is. Edges are filtered over the pixel: by
// how much distance changes across it, on the plane that the depths around it say.

// By how much depth changes to a neighbour if the surface is a plane: in perspective it is 1 /
// depth that is linear over pixels. The neighbour may be infinite.
float relievoMarkerStep(float depth, float neighbor, bool parallel)
{
  return parallel ? neighbor - depth : depth * (float(1.0) - depth / neighbor);
}

// Its change by pixels, from the changes from the pixel before and to the one after: the smaller,
// or none if they are of different signs. So neither an outline nor a wire before something far
// away looks like a steep surface.
float relievoMarkerSlope(float before, float after)
{
  return !(before * after > float(0.0)) ? float(0.0)
    : abs(before) < abs(after) ? before : after;
}

// From the box to the point, by the shortest way; zero inside. Each in the box's own axes.
vec3 relievoMarkerWay(vec3 place, vec3 halves)
{
  vec3 beyond = max(abs(place) - halves, vec3(float(0.0), float(0.0), float(0.0)));
  return vec3(place.x < float(0.0) ? -beyond.x : beyond.x,
    place.y < float(0.0) ? -beyond.y : beyond.y, place.z < float(0.0) ? -beyond.z : beyond.z);
}

// By how much the distance changes across the pixel: twice the difference between its middle and
// its edge, half a pixel up the slope. `way` is from the box to the point, alongX and alongY are
// the point's changes by pixels.
float relievoMarkerFootprint(vec3 way, vec3 alongX, vec3 alongY)
{
  float range = length(way);
  float stepX = dot(way, alongX);
  float stepY = dot(way, alongY);
  float across = float(0.5) * (dot(alongX, alongX) + dot(alongY, alongY));
  float more = sqrt(stepX * stepX + stepY * stepY) + float(0.25) * across;
  float sum = range + sqrt(range * range + more);
  return sum > float(0.0) ? float(2.0) * more / sum : float(0.0);
}

// The share of [range - footprint / 2, range + footprint / 2] that is less than the radius.
float relievoMarkerBelow(float range, float radius, float footprint)
{
  return footprint > float(0.0)
    ? clamp((radius - range) / footprint + float(0.5), float(0.0), float(1.0))
    : range < radius ? float(1.0) : float(0.0);
}

// Width of the box across the way, on a surface of that normal; its diagonal where there is no
// way. All in the box's own axes.
float relievoMarkerBoxWidth(vec3 way, vec3 normal, vec3 halves)
{
  vec3 across = cross(normal, way);
  float size = length(across);
  return float(2.0) * (size > float(0.0) ? dot(abs(across), halves) / size : length(halves));
}

// How much of a pixel's width the disc covers, and the box that it is drawn around, along the chord
// so far from its middle.
float relievoMarkerChord(float at, float radius, float box, float width)
{
  float chord = float(2.0) * sqrt(max((radius - at) * (radius + at), float(0.0))) + box;
  return min(float(1.0), chord / width);
}

// The share that lies in [-radius, radius]: as from one rim to the other; and less where that is
// narrower than the pixel, by the mean of its chords (by Gauss's three places).
//   pixel  area that the pixel shows, on the surface
//   box    width of the box across the way
float relievoMarkerDisc(float range, float radius, float footprint, float pixel, float box)
{
  float share = relievoMarkerBelow(range, radius, footprint) -
    relievoMarkerBelow(range, -radius, footprint);
  if (share > float(0.0) && footprint > float(0.0))
  {
    float low = max(-radius, range - float(0.5) * footprint);
    float high = min(radius, range + float(0.5) * footprint);
    float middle = float(0.5) * (low + high);
    float off = float(0.3872983346207417) * (high - low);
    float width = pixel / footprint;
    share *= (float(4.0) * relievoMarkerChord(middle, radius, box, width) +
      float(2.5) * relievoMarkerChord(middle - off, radius, box, width) +
      float(2.5) * relievoMarkerChord(middle + off, radius, box, width)) / float(9.0);
  }
  return share;
}

// Between the inner and the outer radius.
float relievoMarkerRing(
  float range, float inner, float outer, float footprint, float pixel, float box)
{
  return relievoMarkerDisc(range, outer, footprint, pixel, box) -
    relievoMarkerDisc(range, inner, footprint, pixel, box);
}

// (1 - (range / radius)^2)^2. Where the footprint is not small, both are added up, and the height
// is less for the width.
float relievoMarkerGlow(float range, float radius, float footprint)
{
  float square = radius * radius;
  float wider = square + float(0.25) * footprint * footprint;
  float left = max(float(0.0), float(1.0) - range * range / wider);
  return square / wider * left * left;
}

// A soft shadow below something.
//   square  of the distance from its axis: 1 at the rim
//   height  up from its middle
//   heights x: where it begins to be dark; y: 1 / length over which it becomes so; z: where the
//           shadow has faded away; w: 1 / length over which it does. All downwards.
//   facing  cosine between the surface's normal and up
float relievoBlobShadow(float square, float height, vec4 heights, float facing)
{
  float left = clamp(float(1.0) - square, float(0.0), float(1.0));
  float onset = clamp((-height - heights.x) * heights.y, float(0.0), float(1.0));
  float fade = clamp((heights.z + height) * heights.w, float(0.0), float(1.0));
  return left * left * onset * fade * clamp(float(4.0) * facing, float(0.0), float(1.0));
}
