// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles that cast shadows or hide the sky, for traversal along rays.
//
// The buffer, by vtkRelievoTreeBuffer: nodes of a tree over the casters (vtkRelievoBoxTree), a
// record of five texels for each caster, then for each mesh, at a multiple of 16 texels, the nodes
// of a tree over its triangles and the triangles, five texels for two.
//
// Floats count leaves, since there are four triangles in a leaf and twice as many nodes as leaves:
// see rays/leaves.glsl.
//
// On software OpenGL branches cost their content whether they are taken or not, and loops at least
// one turn. So each loop does only one kind of work until another kind is due.
//RELIEVO::Include(rays/leaves.glsl)
uniform samplerBuffer relievoTree;
uniform int relievoTreeNodes;   // over the casters
uniform int relievoTreeRecords; // texel of the first record
// Error of positions: constant, and per distance from the eye.
uniform vec2 relievoTreeBlur;

// The corners of a mesh's triangle; `triangles`: texel of the mesh's first triangle.
void relievoTreeTriangle(int triangles, int slot, out vec3 a, out vec3 b, out vec3 c)
{
  bool odd = (slot & 1) != 0;
  int texel = triangles + (5 * slot) / 2;
  vec4 p = texelFetch(relievoTree, texel);
  vec4 q = texelFetch(relievoTree, texel + 1);
  vec4 r = texelFetch(relievoTree, texel + 2);
  a = odd ? vec3(p.zw, q.x) : p.xyz;
  b = odd ? q.yzw : vec3(p.w, q.xy);
  c = odd ? r.xyz : vec3(q.zw, r.x);
}
