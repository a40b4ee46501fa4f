// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Moves points, normals and tangents with blended bones in the vertex shaders of VTK's mappers. The
// code follows VTK's declaration of each, and takes over its name in all later code.
//
// Defines, by vtkRelievoSkinShader: RELIEVO_SKIN_INFLUENCES, the most bones of a point, 1 to 8;
// RELIEVO_SKIN_DUAL (dual quaternions, otherwise matrices).

//RELIEVO::Section(Point)
in vec4 vertexMC;

//RELIEVO::Section(PointMoved)
//RELIEVO::Include(formulas/geometry/skin.glsl)
// Strongest first; unused entries repeat the first bone with weight 0.
in vec4 relievoJoints0;
in vec4 relievoWeights0; // sum 1; all 0 if no bone moves the point
#if RELIEVO_SKIN_INFLUENCES > 4
in vec4 relievoJoints1;
in vec4 relievoWeights1;
#endif
// A bone's matrix by rows, 3 texels; for dual quaternions its stretch by columns, its rotation and
// the dual part, 5 texels.
uniform samplerBuffer relievoBones;
// Offset of unmoved points far from the origin: from the mesh's middle to the pose's middle.
uniform vec3 relievoUnmovedBy;

mat3 relievoSkinLinear = mat3(0.0);
vec4 relievoSkinnedMC = vec4(0.0);

#ifdef RELIEVO_SKIN_DUAL
vec4 relievoSkinStrongest = vec4(0.0);
vec4 relievoSkinReal = vec4(0.0);
vec4 relievoSkinDual = vec4(0.0);

void relievoAddBone(float joint, float weight)
{
  int first = 5 * int(joint + 0.5);
  relievoSkinLinear += weight *
    mat3(texelFetch(relievoBones, first).xyz, texelFetch(relievoBones, first + 1).xyz,
      texelFetch(relievoBones, first + 2).xyz);
  vec4 real = texelFetch(relievoBones, first + 3);
  float side = relievoDualWeight(real, relievoSkinStrongest, weight);
  relievoSkinReal += side * real;
  relievoSkinDual += side * texelFetch(relievoBones, first + 4);
}
#else
vec4 relievoSkinRows[3] = vec4[3](vec4(0.0), vec4(0.0), vec4(0.0));

void relievoAddBone(float joint, float weight)
{
  int first = 3 * int(joint + 0.5);
  relievoSkinRows[0] += weight * texelFetch(relievoBones, first);
  relievoSkinRows[1] += weight * texelFetch(relievoBones, first + 1);
  relievoSkinRows[2] += weight * texelFetch(relievoBones, first + 2);
}
#endif

void relievoSkin()
{
#ifdef RELIEVO_SKIN_DUAL
  int strongest = 5 * int(relievoJoints0.x + 0.5);
  relievoSkinStrongest = texelFetch(relievoBones, strongest + 3);
#endif
  relievoAddBone(relievoJoints0.x, relievoWeights0.x);
#if RELIEVO_SKIN_INFLUENCES > 1
  relievoAddBone(relievoJoints0.y, relievoWeights0.y);
#endif
#if RELIEVO_SKIN_INFLUENCES > 2
  relievoAddBone(relievoJoints0.z, relievoWeights0.z);
#endif
#if RELIEVO_SKIN_INFLUENCES > 3
  relievoAddBone(relievoJoints0.w, relievoWeights0.w);
#endif
#if RELIEVO_SKIN_INFLUENCES > 4
  relievoAddBone(relievoJoints1.x, relievoWeights1.x);
#endif
#if RELIEVO_SKIN_INFLUENCES > 5
  relievoAddBone(relievoJoints1.y, relievoWeights1.y);
#endif
#if RELIEVO_SKIN_INFLUENCES > 6
  relievoAddBone(relievoJoints1.z, relievoWeights1.z);
#endif
#if RELIEVO_SKIN_INFLUENCES > 7
  relievoAddBone(relievoJoints1.w, relievoWeights1.w);
#endif

#ifdef RELIEVO_SKIN_DUAL
  if (relievoDualCancels(relievoSkinReal, 1.0))
  {
    relievoSkinReal = relievoSkinStrongest;
    relievoSkinDual = texelFetch(relievoBones, strongest + 4);
  }
  relievoSkinLinear = relievoQuaternionMatrix(normalize(relievoSkinReal)) * relievoSkinLinear;
  vec3 move = relievoDualTranslation(relievoSkinReal, relievoSkinDual);
#else
  relievoSkinLinear =
    transpose(mat3(relievoSkinRows[0].xyz, relievoSkinRows[1].xyz, relievoSkinRows[2].xyz));
  vec3 move = vec3(relievoSkinRows[0].w, relievoSkinRows[1].w, relievoSkinRows[2].w);
#endif
  relievoSkinnedMC = vec4(relievoSkinLinear * vertexMC.xyz + move, vertexMC.w);
  if (!(relievoWeights0.x > 0.0))
  {
    relievoSkinLinear = mat3(1.0);
    relievoSkinnedMC = vec4(vertexMC.xyz + relievoUnmovedBy, vertexMC.w);
  }
}
#define vertexMC relievoSkinnedMC

//RELIEVO::Section(Normal)
in vec3 normalMC;

//RELIEVO::Section(NormalMoved)
vec3 relievoSkinnedNormalMC()
{
  return relievoTurnNormal(relievoSkinLinear, normalMC);
}
#define normalMC relievoSkinnedNormalMC()

//RELIEVO::Section(Tangent)
in vec3 tangentMC;

//RELIEVO::Section(TangentMoved)
vec3 relievoSkinnedTangentMC()
{
  return relievoTurnDirection(relievoSkinLinear, tangentMC);
}
#define tangentMC relievoSkinnedTangentMC()

//RELIEVO::Section(Main)
  relievoSkin();
