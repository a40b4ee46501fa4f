// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The casters' triangles, for walks along rays to lights.
//
// The buffer, by vtkRelievoShadowTree: nodes of a tree over the casters (vtkRelievoBoxTree), a
// record of five texels for each caster, then for each mesh, at a multiple of 16 texels, the nodes
// of a tree over its triangles and the triangles, five texels for two.
//
// On software OpenGL branches cost what is in them, whether they are taken or not, and loops one
// turn at least. So each loop does one thing until there is something else to do.
uniform samplerBuffer relievoShadowTree;
uniform int relievoShadowCasters; // nodes over them
uniform int relievoShadowRecords; // texel of the first record
// How far places may be off: constant, and per distance from the eye.
uniform vec2 relievoShadowBlur;

// The corners of a mesh's triangle; `triangles`: texel of the mesh's first.
void relievoShadowTriangle(int triangles, int slot, out vec3 a, out vec3 b, out vec3 c)
{
  bool odd = (slot & 1) != 0;
  int texel = triangles + (5 * slot) / 2;
  vec4 p = texelFetch(relievoShadowTree, texel);
  vec4 q = texelFetch(relievoShadowTree, texel + 1);
  vec4 r = texelFetch(relievoShadowTree, texel + 2);
  a = odd ? vec3(p.zw, q.x) : p.xyz;
  b = odd ? q.yzw : vec3(p.w, q.xy);
  c = odd ? r.xyz : vec3(q.zw, r.x);
}
