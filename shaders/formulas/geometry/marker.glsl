// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Markers on surfaces: the share of a pixel within a distance of a box (a point is a box of size
// 0), and the darkness of a blob shadow. Edges are filtered over the pixel: by the change of
// distance across it, on the plane of the depths around it.

// The change of depth to a neighbour if the surface is a plane: in perspective 1 / depth is linear
// over pixels. The neighbour may be infinite.
float relievoMarkerStep(float depth, float neighbor, bool parallel)
{
  return parallel ? neighbor - depth : depth * (float(1.0) - depth / neighbor);
}

// The depth's change per pixel, from the changes from the pixel before and to the pixel after: the
// smaller one, or 0 if their signs differ. Outlines, and wires in front of something far away, so
// do not look like steep surfaces.
float relievoMarkerSlope(float before, float after)
{
  return !(before * after > float(0.0)) ? float(0.0)
    : abs(before) < abs(after) ? before : after;
}

// The shortest vector from the box to the point; zero inside. All in the box's own axes.
vec3 relievoMarkerWay(vec3 place, vec3 halves)
{
  vec3 beyond = max(abs(place) - halves, vec3(float(0.0), float(0.0), float(0.0)));
  return vec3(place.x < float(0.0) ? -beyond.x : beyond.x,
    place.y < float(0.0) ? -beyond.y : beyond.y, place.z < float(0.0) ? -beyond.z : beyond.z);
}

// The change of distance across the pixel: twice the difference between the pixel's centre and its
// edge, half a pixel up the slope. `way` leads from the box to the point; alongX and alongY are the
// point's changes per pixel.
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

// The share of [range - footprint / 2, range + footprint / 2] below the radius.
float relievoMarkerBelow(float range, float radius, float footprint)
{
  return footprint > float(0.0)
    ? clamp((radius - range) / footprint + float(0.5), float(0.0), float(1.0))
    : range < radius ? float(1.0) : float(0.0);
}

// Width of the box perpendicular to `way`, on a surface of that normal; its diagonal if `way` is 0.
// All in the box's own axes.
float relievoMarkerBoxWidth(vec3 way, vec3 normal, vec3 halves)
{
  vec3 across = cross(normal, way);
  float size = length(across);
  return float(2.0) * (size > float(0.0) ? dot(abs(across), halves) / size : length(halves));
}

// The share of a pixel's width covered by the disc, and by the box that it surrounds, along the
// chord at a distance from its middle.
float relievoMarkerChord(float at, float radius, float box, float width)
{
  float chord = float(2.0) * sqrt(max((radius - at) * (radius + at), float(0.0))) + box;
  return min(float(1.0), chord / width);
}

// The share that lies in [-radius, radius]: from one rim to the other; less if the disc is narrower
// than the pixel, by the mean of its chords (at Gauss's three points).
//   pixel  area of the pixel on the surface
//   box    width of the box perpendicular to `way`
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

// (1 - (range / radius)^2)^2. For footprints that are not small, the squares of the radius and of
// half the footprint add up, and the height is reduced in proportion.
float relievoMarkerGlow(float range, float radius, float footprint)
{
  float square = radius * radius;
  float wider = square + float(0.25) * footprint * footprint;
  float left = max(float(0.0), float(1.0) - range * range / wider);
  return square / wider * left * left;
}

// A soft shadow on the surface below an object.
//   square  squared distance from the axis: 1 at the rim
//   height  height above the object's middle
//   heights x: where darkness begins; y: 1 / length over which it grows; z: where the shadow has
//           faded away; w: 1 / length over which it fades. All downwards.
//   facing  cosine between the surface's normal and up
float relievoBlobShadow(float square, float height, vec4 heights, float facing)
{
  float left = clamp(float(1.0) - square, float(0.0), float(1.0));
  float onset = clamp((-height - heights.x) * heights.y, float(0.0), float(1.0));
  float fade = clamp((heights.z + height) * heights.w, float(0.0), float(1.0));
  return left * left * onset * fade * clamp(float(4.0) * facing, float(0.0), float(1.0));
}
