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
