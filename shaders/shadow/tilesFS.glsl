//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Which lights certainly reach all visible places in a tile of 8 x 8 pixels: if they lie in one
// plane, rays from all of them are tested at once. Writes a sum of 2^light, -1 if nothing is open,
// or -2 if the present verdicts stay: the same surface is visible, and none of its rays passes near
// anything that has moved since.
//
// The boxes of all rays of the tile are enlarged by half of the tile's extent; and a triangle
// blocks no ray of the tile if it is not between any corner of the tile and the light.
//RELIEVO::Include(formulas/geometry/ray.glsl)
//RELIEVO::Include(rays/tree.glsl)
//RELIEVO::Include(shadow/seen.glsl)
uniform vec4 relievoSeenSource[24]; // w = 0: the direction to it
uniform vec3 relievoShadowCenter;
uniform int relievoSeenKeeps;        // whether verdicts may stay
uniform sampler2D relievoSeenBefore; // visible surfaces at the time of the verdicts
uniform int relievoMovedCount;
uniform vec3 relievoMoved[16]; // boxes of local space, two corners each

struct relievoTile
{
  vec3 middle; // local space
  vec3 extent; // half of it
  vec3 corners[4];
  float blur;
};

vec3 relievoTilePlace(vec2 texel, float z)
{
  vec3 placeVC = relievoSeenPlace(relievoSeenPixel(texel), z);
  return (relievoShadowToLocal * vec4(placeVC - relievoShadowCenter, 1.0)).xyz;
}

// Whether a ray from the tile may hit anything on its way to the light.
bool relievoTileHits(int casters, relievoTile tile, vec4 source)
{
  bool ends = source.w != 0.0;
  float last = ends ? 1.0 : 1e30;
  vec3 rayLC = relievoSeenToLight(source, tile.middle);
  vec3 inverseLC = relievoRayInverse(rayLC);
  bool hit = false;
  int caster = 0;
  while (caster < casters && !hit)
  {
    vec4 low = texelFetch(relievoTree, 2 * caster);
    vec4 high = texelFetch(relievoTree, 2 * caster + 1);
    bool leaf = low.w < 0.0;
    bool hitsBox = relievoRayHitsBox(
      tile.middle, inverseLC, last, low.xyz - tile.extent, high.xyz + tile.extent);
    caster += hitsBox || leaf ? 1 : relievoTreeNodesOf(low.w);
    int record = relievoTreeRecords + 5 * (hitsBox && leaf ? relievoTreeLeaf(low.w) : 0);
    vec4 rowX = texelFetch(relievoTree, record);
    vec4 rowY = texelFetch(relievoTree, record + 1);
    vec4 rowZ = texelFetch(relievoTree, record + 2);
    vec4 mesh = texelFetch(relievoTree, record + 3);
    vec4 size = texelFetch(relievoTree, record + 4);
    int base = 16 * int(mesh.x);
    int ofMesh = relievoTreeNodesOf(mesh.y);
    int nodes = hitsBox && leaf ? ofMesh : 0;
    int triangles = base + 2 * ofMesh;
    float near = size.x * tile.blur + size.y;
    vec4 start = vec4(tile.middle, 1.0);
    vec3 from = vec3(dot(rowX, start), dot(rowY, start), dot(rowZ, start));
    vec3 ray = vec3(dot(rowX.xyz, rayLC), dot(rowY.xyz, rayLC), dot(rowZ.xyz, rayLC));
    vec3 inverse = relievoRayInverse(ray);
    vec3 room = vec3(dot(abs(rowX.xyz), tile.extent), dot(abs(rowY.xyz), tile.extent),
      dot(abs(rowZ.xyz), tile.extent));
    room = 1.0001 * room + 1e-6 * max(abs(from.x), max(abs(from.y), abs(from.z)));
    vec3 light = vec3(dot(rowX, source), dot(rowY, source), dot(rowZ, source));
    int node = 0;
    while (node < nodes && !hit)
    {
      vec4 least = texelFetch(relievoTree, base + 2 * node);
      vec4 most = texelFetch(relievoTree, base + 2 * node + 1);
      bool within = relievoRayHitsBox(from, inverse, last, least.xyz - room, most.xyz + room);
      bool isLeaf = least.w < 0.0;
      int slot = within && isLeaf ? relievoTreeLeafFirst(least.w) : 0;
      int end = within && isLeaf ? slot + int(most.w) : 0;
      node += within || isLeaf ? 1 : relievoTreeNodesOf(least.w);
      while (slot < end)
      {
        vec3 a;
        vec3 b;
        vec3 c;
        relievoTreeTriangle(triangles, slot, a, b, c);
        vec3 normal = cross(b - a, c - a);
        float toward = ends ? dot(normal, light - a) : dot(normal, ray);
        float nearest = near * length(normal);
        float lowest = 1e38;
        for (int k = 0; k < 4; ++k)
        {
          vec4 corner = vec4(tile.corners[k], 1.0);
          vec3 place = vec3(dot(rowX, corner), dot(rowY, corner), dot(rowZ, corner));
          lowest = min(lowest, dot(normal, place - a) * sign(toward));
        }
        bool inBox = relievoRayHitsBox(
          from, inverse, last, min(a, min(b, c)) - room, max(a, max(b, c)) + room);
        hit = hit || !(lowest >= -0.5 * nearest || !inBox);
        ++slot;
      }
    }
  }
  return hit;
}

// Whether a ray from the tile may hit anything that has moved.
bool relievoTileHitsMoved(relievoTile tile, vec4 source)
{
  float last = source.w != 0.0 ? 1.0 : 1e30;
  vec3 inverseLC = relievoRayInverse(relievoSeenToLight(source, tile.middle));
  bool hit = false;
  for (int i = 0; i < relievoMovedCount; ++i)
  {
    hit = hit || relievoRayHitsBox(tile.middle, inverseLC, last,
      relievoMoved[2 * i] - tile.extent, relievoMoved[2 * i + 1] + tile.extent);
  }
  return hit;
}

void main()
{
  ivec2 first = 8 * ivec2(gl_FragCoord.xy);
  ivec2 end = ivec2(relievoSeenSize) - 1;
  relievoTile tile;
  ivec2 ends = min(first + 7, end);
  for (int k = 0; k < 4; ++k)
  {
    ivec2 texel = ivec2((k & 1) == 0 ? first.x : ends.x, k < 2 ? first.y : ends.y);
    tile.corners[k] = relievoTilePlace(vec2(texel), texelFetch(relievoSeen, texel, 0).x);
  }
  // NaN for a single row or column of pixels: the remainder of a tile at the viewport's edge.
  vec3 normal = normalize(cross(normalize(tile.corners[1] - tile.corners[0]),
    normalize(tile.corners[2] - tile.corners[0])));
  bool wide = ends.x > first.x && ends.y > first.y && dot(normal, normal) > 0.5;
  vec3 low = vec3(1e30);
  vec3 high = vec3(-1e30);
  float off = 0.0;
  float eye = 1e30;
  bool whole = true;
  bool some = false;
  bool keep = relievoSeenKeeps != 0;
  for (int i = 0; i < 64; ++i)
  {
    ivec2 texel = min(first + ivec2(i & 7, i >> 3), end);
    vec2 seen = texelFetch(relievoSeen, texel, 0).xy;
    float z = seen.x;
    bool there = z > -1e29;
    keep = keep && seen == texelFetch(relievoSeenBefore, texel, 0).xy;
    whole = whole && there;
    some = some || there;
    vec3 place = relievoTilePlace(vec2(texel), z);
    off = max(off, abs(dot(normal, place - tile.corners[0])));
    eye = min(eye, length(relievoSeenPlace(relievoSeenPixel(vec2(texel)), z)));
    low = there ? min(low, place) : low;
    high = there ? max(high, place) : high;
  }
  tile.middle = 0.5 * low + 0.5 * high;
  tile.extent = 0.5001 * (high - low) + 1e-6 * max(abs(low), abs(high));
  tile.blur = relievoTreeBlur.x + relievoTreeBlur.y * eye;
  for (int light = 0; light < (keep && some ? relievoSeenLights : 0); ++light)
  {
    keep = keep && !relievoTileHitsMoved(tile, relievoSeenSource[light]);
  }
  bool plane = !keep && whole && wide && off <= 0.4 * tile.blur;
  float sure = 0.0;
  float digit = 1.0;
  for (int light = 0; light < relievoSeenLights; ++light)
  {
    bool hit = relievoTileHits(plane ? relievoTreeNodes : 0, tile, relievoSeenSource[light]);
    sure += plane && !hit ? digit : 0.0;
    digit *= 2.0;
  }
  gl_FragData[0] = vec4(keep ? -2.0 : some && sure < digit - 1.0 ? sure : -1.0, 0.0, 0.0, 0.0);
}
