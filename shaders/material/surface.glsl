// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's shaders by vtkRelievoMaterial: normals from a map, relief from heights.
//
// Defines: RELIEVO_NORMAL_MAP, RELIEVO_HEIGHT_MAP; with normals RELIEVO_TANGENTS (the mesh brings
// tangents), RELIEVO_NORMAL_TEXTURE (VTK's shader maps normals of its own, by a frame `tbn`); with
// heights RELIEVO_METHOD (a code of codes.glsl), RELIEVO_DEPTH_CORRECTION; RELIEVO_TEXTURE_MATRIX
// (VTK's texture has a transform).
// What it shares with other splices: splice/contract.glsl.
//
// Heights are from 0 to 1, the mesh itself being at 1; below, depth is 1 - height.

//RELIEVO::Section(TCoordDec)
in vec2 tcoord;

//RELIEVO::Section(TangentDec)
in vec3 tangentMC;

//RELIEVO::Section(VertexDec)
out vec2 relievoTCoordVSOutput;
#ifdef RELIEVO_TANGENTS
out vec3 relievoTangentVSOutput;
#endif

//RELIEVO::Section(VertexImpl)
  relievoTCoordVSOutput = tcoord;
#ifdef RELIEVO_TANGENTS
  relievoTangentVSOutput = mat3(MCVCMatrix) * tangentMC;
#endif

//RELIEVO::Section(GeometryDec)
in vec2 relievoTCoordVSOutput[];
out vec2 relievoTCoordGSOutput;
#ifdef RELIEVO_TANGENTS
in vec3 relievoTangentVSOutput[];
out vec3 relievoTangentGSOutput;
#endif

//RELIEVO::Section(GeometryImpl)
  relievoTCoordGSOutput = relievoTCoordVSOutput[i];
#ifdef RELIEVO_TANGENTS
  relievoTangentGSOutput = relievoTangentVSOutput[i];
#endif

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(codes.glsl)
//RELIEVO::Include(formulas/tangent_frame.glsl)
//RELIEVO::Include(material/eye.glsl)
in vec2 relievoTCoordVSOutput;
#ifdef RELIEVO_TANGENTS
in vec3 relievoTangentVSOutput;
#endif
uniform vec4 relievoTextureTransform; // tiles per texture coordinate, offset in tiles
#ifdef RELIEVO_TEXTURE_MATRIX
uniform mat4 tcMatrix; // VTK's, of the texture's own transform
#endif

vec2 relievoUV = vec2(0.0); // of what is seen, in tiles
vec2 relievoTCoord = vec2(0.0); // the same, as VTK's textures count
vec2 relievoUVdX = vec2(0.0); // per pixel, on the mesh
vec2 relievoUVdY = vec2(0.0);
vec3 relievoPerU = vec3(1.0, 0.0, 0.0); // eye space, on the mesh
vec3 relievoPerV = vec3(0.0, 1.0, 0.0);
float relievoHandedness = 1.0; // -1 on mirrored coordinates, as they are seen
vec3 relievoFaceVC = vec3(0.0, 0.0, 1.0); // of the mesh's face, towards the eye; unit with heights
bool relievoFramed = false; // there is a frame: texture coordinates spread over the face

#ifdef RELIEVO_NORMAL_MAP
uniform sampler2D relievoNormalMap;
uniform vec2 relievoNormalDecode; // from the texture's values to -1 .. 1: scale, offset
uniform vec2 relievoNormalWeight; // of the map's x and y: strength; negative y for a green flip
#endif

#ifdef RELIEVO_HEIGHT_MAP
#ifdef RELIEVO_DEPTH_CORRECTION
#undef RELIEVO_SURFACE_VC
#define RELIEVO_SURFACE_VC relievoSurfaceVC
#endif
// A relief shows another place of its mesh than the one that the pixel sees.
#undef RELIEVO_RECEIVER
#define RELIEVO_RECEIVER(matrix, place) ((place) + (matrix) * vec4(relievoShiftVC, 0.0))
uniform sampler2D relievoHeightMap;
uniform int relievoFromLight; // of shadow/: the mesh casts, not its relief
uniform vec2 relievoHeightDecode; // from the texture's values to 0 .. 1: scale, offset
uniform vec2 relievoHeightSize; // texels
uniform float relievoHeightScale; // length in the world of a height of 1
uniform vec4 relievoSteps; // per texel; least, most; of the refinement
float relievoLevel = 0.0; // of the map's mipmaps: one for all looks along a ray
float relievoHitDepth = 0.0; // 0 on the mesh, 1 on the ground
vec3 relievoSurfaceVC = vec3(0.0); // what is seen
vec3 relievoShiftVC = vec3(0.0); // to the place of the mesh above it

float relievoHeight(vec2 uv)
{
  return textureLod(relievoHeightMap, uv, relievoLevel).r * relievoHeightDecode.x +
    relievoHeightDecode.y;
}

// Looks along a ray that leaves texels behind as fast as `through` does in all: more for a ray that
// grazes the surface.
float relievoStepsOf(vec2 through)
{
  float texels = length(through * relievoHeightSize) * exp2(-relievoLevel);
  return clamp(ceil(texels * relievoSteps.x), relievoSteps.y, relievoSteps.z);
}

// Depth at which a ray that enters at uv and moves by `through` until the ground meets the heights.
float relievoMeet(vec2 uv, vec2 through)
{
#if RELIEVO_METHOD == RELIEVO_METHOD_PARALLAX
  return 1.0 - relievoHeight(uv);
#else
  float steps = relievoStepsOf(through);
  float inside = 1.0;
  float insideBelow = 0.0; // how far the ray is below the heights
  float outside = 0.0;
  float outsideAbove = 1.0 - relievoHeight(uv); // and how far above
  if (outsideAbove <= 0.0)
  {
    return 0.0;
  }
  for (float i = 1.0; i <= steps; i += 1.0)
  {
    float depth = i / steps;
    float above = 1.0 - depth - relievoHeight(uv + depth * through);
    if (above <= 0.0)
    {
      inside = depth;
      insideBelow = -above;
      break;
    }
    outside = depth;
    outsideAbove = above;
  }
#if RELIEVO_METHOD == RELIEVO_METHOD_STEEP
  return inside;
#else
#if RELIEVO_METHOD == RELIEVO_METHOD_RELIEF
  for (float i = 0.0; i < relievoSteps.w; i += 1.0)
  {
    float depth = 0.5 * (inside + outside);
    float above = 1.0 - depth - relievoHeight(uv + depth * through);
    if (above <= 0.0)
    {
      inside = depth;
      insideBelow = -above;
    }
    else
    {
      outside = depth;
      outsideAbove = above;
    }
  }
#endif
  // The heights as a straight line between the two looks.
  return mix(outside, inside, outsideAbove / max(outsideAbove + insideBelow, 1e-20));
#endif
#endif
}

void relievoSeeRelief(vec3 gazeVC, vec3 vertexVC)
{
  // Of a pixel's footprint the shorter side: along the longer one the ray takes its steps.
  float across =
    min(length(relievoUVdX * relievoHeightSize), length(relievoUVdY * relievoHeightSize));
  relievoLevel = max(0.0, log2(across));
#if RELIEVO_METHOD != RELIEVO_METHOD_OFF
  float down = max(-dot(gazeVC, relievoFaceVC), 1e-3);
  vec2 through = relievoTextureStep(gazeVC, relievoPerU, relievoPerV) * (relievoHeightScale / down);
#if RELIEVO_METHOD == RELIEVO_METHOD_PARALLAX
  // Offset limited: the ray's full shift would tear at grazing angles.
  through *= down;
#endif
  relievoHitDepth = relievoMeet(relievoUV, through);
  vec2 moved = relievoHitDepth * through;
  relievoUV += moved;
  relievoShiftVC = relievoPerU * moved.x + relievoPerV * moved.y;
  relievoSurfaceVC = vertexVC + gazeVC * (relievoHitDepth * relievoHeightScale / down);
#endif
}

// Slope of the heights in lengths of the world, per tile.
vec2 relievoSlopes(vec2 uv)
{
  vec2 texel = exp2(relievoLevel) / relievoHeightSize;
  vec2 x = vec2(texel.x, 0.0);
  vec2 y = vec2(0.0, texel.y);
  return relievoHeightScale * 0.5 *
    vec2(relievoHeight(uv + x) - relievoHeight(uv - x),
      relievoHeight(uv + y) - relievoHeight(uv - y)) / texel;
}

// 1 if a light from this direction (eye space, unit) reaches what is seen of the relief.
float relievoReliefLit(vec3 towardsVC)
{
  float up = dot(towardsVC, relievoFaceVC);
  if (!relievoFramed || up <= 1e-3 || relievoHitDepth <= 0.0)
  {
    return 1.0;
  }
  // From the place on, up to the mesh.
  vec2 through = relievoTextureStep(towardsVC, relievoPerU, relievoPerV) *
    (relievoHeightScale * relievoHitDepth / up);
  float steps = relievoStepsOf(through);
  for (float i = 1.0; i < steps; i += 1.0)
  {
    float way = i / steps;
    float depth = relievoHitDepth * (1.0 - way);
    // A texel's height lifts the start off its own slope.
    if (relievoHeight(relievoUV + way * through) > 1.0 - depth + 0.002)
    {
      return 0.0;
    }
  }
  return 1.0;
}
#endif

//RELIEVO::Section(UniformFlow)
  relievoTCoord = relievoTCoordVSOutput;
  relievoUV = relievoTCoordVSOutput * relievoTextureTransform.xy + relievoTextureTransform.zw;
  relievoUVdX = dFdx(relievoUV);
  relievoUVdY = dFdy(relievoUV);
#ifndef RELIEVO_HEIGHT_MAP
  vec3 relievoMapped = texture(relievoNormalMap, relievoUV).xyz;
#endif
  {
    vec3 px = dFdx(vertexVC.xyz);
    vec3 py = dFdy(vertexVC.xyz);
    vec3 gazeVC = relievoGazeAt(vertexVC.xyz, cameraParallel != 0);
    relievoFramed = relievoHasTextureFrame(relievoUVdX, relievoUVdY);
    relievoHandedness = relievoTextureArea(relievoUVdX, relievoUVdY) < 0.0 ? -1.0 : 1.0;
    relievoPerU = relievoPositionPerU(px, py, relievoUVdX, relievoUVdY);
    relievoPerV = relievoPositionPerV(px, py, relievoUVdX, relievoUVdY);
#ifdef RELIEVO_HEIGHT_MAP
    gazeVC = normalize(gazeVC);
    relievoFaceVC = normalize(cross(normalize(px), normalize(py)));
    relievoHitDepth = 0.0;
    relievoShiftVC = vec3(0.0);
    relievoSurfaceVC = vertexVC.xyz;
#else
    relievoFaceVC = cross(px, py); // of any length: only its side counts
#endif
    relievoFaceVC = dot(relievoFaceVC, gazeVC) > 0.0 ? -relievoFaceVC : relievoFaceVC;
#ifdef RELIEVO_HEIGHT_MAP
    if (relievoFramed && relievoFromLight == 0)
    {
      relievoSeeRelief(gazeVC, vertexVC.xyz);
      relievoTCoord = (relievoUV - relievoTextureTransform.zw) / relievoTextureTransform.xy;
    }
#endif
  }
#ifdef RELIEVO_TEXTURE_MATRIX
  vec4 placedTCoord = tcMatrix * vec4(relievoTCoord, 0.0, 1.0);
  relievoTCoord = placedTCoord.xy / placedTCoord.w;
#endif

//RELIEVO::Section(Clip)
  // Behind all of //VTK::UniformFlow::Impl: beside what is discarded there are no derivatives.
  bool relievoBeyond =
    any(lessThan(relievoUV, vec2(0.0))) || any(greaterThan(relievoUV, vec2(1.0)));
  if (relievoBeyond && relievoFromLight == 0)
  {
    discard;
  }

//RELIEVO::Section(EyeMatrix)
uniform mat4 MCVCMatrix;

//RELIEVO::Section(ClipMatrix)
uniform mat4 MCDCMatrix;

//RELIEVO::Section(Depth)
  // Window z is -A - B / z in a perspective, A z + B in a parallel picture; A and B from what VTK's
  // matrices do to z. Only the difference to the mesh is computed: it keeps its digits.
  {
    vec4 toVC = vec4(MCVCMatrix[0].z, MCVCMatrix[1].z, MCVCMatrix[2].z, MCVCMatrix[3].z);
    vec4 toDC = vec4(MCDCMatrix[0].z, MCDCMatrix[1].z, MCDCMatrix[2].z, MCDCMatrix[3].z);
    float a = dot(toDC.xyz, toVC.xyz) / dot(toVC.xyz, toVC.xyz);
    float b = toDC.w - a * toVC.w;
    float z = relievoSurfaceVC.z;
    float deeper = cameraParallel != 0 ? a * (z - vertexVC.z)
                                       : -b * (vertexVC.z - z) / (z * vertexVC.z);
    gl_FragDepth = clamp(gl_FragCoord.z + 0.5 * deeper, 0.0, 1.0);
  }

//RELIEVO::Section(Normal)
  if (relievoFramed)
  {
#ifdef RELIEVO_NORMAL_TEXTURE
    normalVCVSOutput = tbn[2]; // as it was before VTK's normal texture, which the map replaces
#endif
    // VTK turns normals by the winding, which a mirroring actor inverts: map on the side that is
    // seen, and leave it turned as VTK has it.
    float relievoSide = dot(normalVCVSOutput, relievoFaceVC) < 0.0 ? -1.0 : 1.0;
#ifdef RELIEVO_NORMAL_MAP
#ifdef RELIEVO_HEIGHT_MAP
    vec3 relievoMapped =
      textureGrad(relievoNormalMap, relievoUV, relievoUVdX, relievoUVdY).xyz;
#endif
    relievoMapped = relievoMapped * relievoNormalDecode.x + relievoNormalDecode.y;
    // Mapping on the other side and turning the result back is, in one: x the other way round.
    relievoMapped.xy *= vec2(relievoSide, 1.0) * relievoNormalWeight;
#ifdef RELIEVO_TANGENTS
    vec3 relievoTangentVC = relievoTangentVSOutput;
#else
    vec3 relievoTangentVC = relievoPerU;
#endif
    normalVCVSOutput = relievoFromTangentSpace(
      relievoMapped, normalVCVSOutput, relievoTangentVC, relievoHandedness);
#elif defined(RELIEVO_HEIGHT_MAP)
    normalVCVSOutput = relievoSide *
      relievoLiftedNormal(
        relievoSide * normalVCVSOutput, relievoPerU, relievoPerV, relievoSlopes(relievoUV));
#endif
  }

//RELIEVO::Section(LampLit)
  float relievoReliefLitRELIEVO_NUMBER = relievoReliefLit(lightPositionalRELIEVO_NUMBER != 0
      ? normalize(lightPositionVCRELIEVO_NUMBER - relievoSurfaceVC)
      : -lightDirectionVCRELIEVO_NUMBER);
#define relievoReliefColorRELIEVO_NUMBER (relievoReliefLitRELIEVO_NUMBER * lightColorRELIEVO_NUMBER)

//RELIEVO::Section(SunLit)
  float relievoReliefLitRELIEVO_NUMBER = relievoReliefLit(-lightDirectionVCRELIEVO_NUMBER);
#define relievoReliefColorRELIEVO_NUMBER (relievoReliefLitRELIEVO_NUMBER * lightColorRELIEVO_NUMBER)
