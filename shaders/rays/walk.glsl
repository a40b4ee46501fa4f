// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Traces a ray to a light through the casters' triangles. The including shader has
// formulas/light/shadow.glsl and rays/passes.glsl.
//RELIEVO::Include(formulas/geometry/ray.glsl)
//RELIEVO::Include(rays/tree.glsl)

// Light transmitted along a ray: the product of 1 - opacity, and of the colours, of all hit
// surfaces between the start and the light, which is at the ray's end or infinitely far. Surfaces
// that contain the start or the end, within `blur`, do not count. casters: number of nodes over the
// casters, or 0 to skip the traversal.
//
// snapLC: a vector towards the eye, whose length is the largest error by which the start may lie
// behind the visible surface's plane. Rasterisers place corners on a grid, which tilts narrow
// triangles and draws a triangle slightly beyond its edge, behind its neighbour; neither lies
// between the start and a light.
RELIEVO_PASSES relievoTreeWalk(
  int casters, vec3 fromLC, vec3 rayLC, bool ends, float blur, vec3 snapLC)
{
  RELIEVO_PASSES passes = RELIEVO_PASSES(1.0);
  int caster = 0;
  float last = ends ? 1.0 : 1e30;
  vec3 inverseLC = relievoRayInverse(rayLC);
  while (caster < casters)
  {
    int found = -1;
    while (caster < casters && found < 0)
    {
      vec4 low = texelFetch(relievoTree, 2 * caster);
      vec4 high = texelFetch(relievoTree, 2 * caster + 1);
      bool hitsBox = relievoRayHitsBox(fromLC, inverseLC, last, low.xyz, high.xyz);
      bool leaf = low.w < 0.0;
      found = hitsBox && leaf ? relievoTreeLeaf(low.w) : -1;
      caster += hitsBox || leaf ? 1 : relievoTreeNodesOf(low.w);
    }
    int record = relievoTreeRecords + 5 * max(found, 0);
    vec4 rowX = texelFetch(relievoTree, record);
    vec4 rowY = texelFetch(relievoTree, record + 1);
    vec4 rowZ = texelFetch(relievoTree, record + 2);
    vec4 mesh = texelFetch(relievoTree, record + 3); // texel / 16, leaves, 1 - opacity
    vec4 size = texelFetch(relievoTree, record + 4); // scale, blur
#ifdef RELIEVO_SHADOW_COLORED
    vec4 share = vec4(mesh.w, size.zw, mesh.z); // colours' share, minus the blocked share
#else
    float share = mesh.z;
#endif
    // Opaque casters may be counted twice, which closes gaps to their neighbours.
    bool blocks = mesh.z == 0.0;
    int base = 16 * int(mesh.x);
    int nodes = found < 0 ? 0 : relievoTreeNodesOf(mesh.y);
    int triangles = base + 2 * nodes;
    float near = size.x * blur + size.y;
    vec4 start = vec4(fromLC, 1.0);
    vec3 from = vec3(dot(rowX, start), dot(rowY, start), dot(rowZ, start));
    vec3 ray = vec3(dot(rowX.xyz, rayLC), dot(rowY.xyz, rayLC), dot(rowZ.xyz, rayLC));
    vec3 snap = vec3(dot(rowX.xyz, snapLC), dot(rowY.xyz, snapLC), dot(rowZ.xyz, snapLC));
    float snapped = length(snap);
    vec3 inverse = relievoRayInverse(ray);
    vec3 right = normalize(relievoTangent(ray));
    vec3 up = normalize(cross(ray, right));
    int node = 0;
    while (node < nodes)
    {
      int slot = 0;
      int end = 0;
      while (node < nodes && end == 0)
      {
        vec4 low = texelFetch(relievoTree, base + 2 * node);
        vec4 high = texelFetch(relievoTree, base + 2 * node + 1);
        bool hitsBox = relievoRayHitsBox(from, inverse, last, low.xyz, high.xyz);
        bool leaf = low.w < 0.0;
        slot = hitsBox && leaf ? relievoTreeLeafFirst(low.w) : 0;
        end = hitsBox && leaf ? slot + int(high.w) : 0;
        node += hitsBox || leaf ? 1 : relievoTreeNodesOf(low.w);
      }
      while (slot < end)
      {
        vec3 a;
        vec3 b;
        vec3 c;
        relievoTreeTriangle(triangles, slot, a, b, c);
        vec3 normal = cross(b - a, c - a);
        a -= from;
        b -= from;
        c -= from;
        float area = length(normal);
        float nearest = near * area;
        float side = -dot(normal, a);
        float along = dot(normal, ray);
        float other = side + along;
        bool seen = side * dot(normal, snap) < 0.0 && abs(side) <= snapped * area;
        bool between = !seen && abs(side) > nearest && side * along < 0.0 &&
          (!ends || (abs(other) > nearest && side * other < 0.0));
        bool hit = between &&
          relievoLineHitsTriangle(vec2(dot(right, a), dot(up, a)), vec2(dot(right, b), dot(up, b)),
            vec2(dot(right, c), dot(up, c)), blocks);
        passes *= hit ? share : RELIEVO_PASSES(1.0);
        ++slot;
      }
      nodes = RELIEVO_PASSES_WHOLE(passes) > 0.0 ? nodes : 0;
    }
    casters = RELIEVO_PASSES_WHOLE(passes) > 0.0 ? casters : 0;
  }
  return passes;
}
