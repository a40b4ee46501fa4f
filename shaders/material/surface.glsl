// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's shaders by vtkRelievoMaterial: normals from a map, relief from heights.
//
// Defines: RELIEVO_NORMAL_MAP, RELIEVO_HEIGHT_MAP; with normals RELIEVO_TANGENTS (the mesh has
// tangents), RELIEVO_NORMAL_TEXTURE (VTK's shader maps its own normals, by a frame `tbn`); with
// heights RELIEVO_METHOD (a code of codes.glsl), RELIEVO_DEPTH_CORRECTION; RELIEVO_TEXTURE_MATRIX
// (VTK's texture has a transform).
// Names shared with other splices: splice/contract.glsl.
//
// Heights are from 0 to 1, with the mesh itself at 1; below, depth is 1 - height.

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
//RELIEVO::Include(formulas/geometry/tangent_frame.glsl)
//RELIEVO::Include(material/eye.glsl)
in vec2 relievoTCoordVSOutput;
#ifdef RELIEVO_TANGENTS
in vec3 relievoTangentVSOutput;
#endif
uniform vec4 relievoTextureTransform; // tiles per texture coordinate, offset in tiles
#ifdef RELIEVO_TEXTURE_MATRIX
uniform mat4 tcMatrix; // VTK's matrix of the texture's transform
#endif

vec2 relievoUV = vec2(0.0); // of the visible point, in tiles
vec2 relievoTCoord = vec2(0.0); // in the coordinates of VTK's textures
vec2 relievoUVdX = vec2(0.0); // per pixel, on the mesh
vec2 relievoUVdY = vec2(0.0);
vec3 relievoPerU = vec3(1.0, 0.0, 0.0); // eye space, on the mesh
vec3 relievoPerV = vec3(0.0, 1.0, 0.0);
float relievoHandedness = 1.0; // -1 for coordinates mirrored in the view
// Normal of the mesh's face, towards the eye; unit with heights.
vec3 relievoFaceVC = vec3(0.0, 0.0, 1.0);
bool relievoFramed = false; // texture coordinates span the face

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
// A relief shows another point of its mesh than the one at the pixel.
#undef RELIEVO_RECEIVER
#define RELIEVO_RECEIVER(matrix, place) ((place) + (matrix) * vec4(relievoShiftVC, 0.0))
uniform sampler2D relievoHeightMap;
// From shadow/: unless it is 0, the mesh is drawn without its relief.
uniform int relievoFromLight;
uniform vec2 relievoHeightDecode; // from the texture's values to 0 .. 1: scale, offset
uniform vec2 relievoHeightSize; // texels
uniform float relievoHeightScale; // world length of a height of 1
uniform vec4 relievoSteps; // steps per texel; least, most; refinement steps
float relievoLevel = 0.0; // mipmap level, one for all samples along a ray
float relievoHitDepth = 0.0; // 0 on the mesh, 1 on the ground
vec3 relievoSurfaceVC = vec3(0.0); // position of the visible point
vec3 relievoShiftVC = vec3(0.0); // offset to the point of the mesh above it

float relievoHeight(vec2 uv)
{
  return textureLod(relievoHeightMap, uv, relievoLevel).r * relievoHeightDecode.x +
    relievoHeightDecode.y;
}

// Number of samples along a ray that moves by `through` in total: more for a grazing ray.
float relievoStepsOf(vec2 through)
{
  float texels = length(through * relievoHeightSize) * exp2(-relievoLevel);
  return clamp(ceil(texels * relievoSteps.x), relievoSteps.y, relievoSteps.z);
}

// Depth at which a ray from uv hits the heights; it moves by `through` on its way to the ground.
float relievoTraceDepth(vec2 uv, vec2 through)
{
#if RELIEVO_METHOD == RELIEVO_METHOD_PARALLAX
  return 1.0 - relievoHeight(uv);
#else
  float steps = relievoStepsOf(through);
  float inside = 1.0;
  float insideBelow = 0.0; // distance of the ray below the heights
  float outside = 0.0;
  float outsideAbove = 1.0 - relievoHeight(uv); // and above them
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
  // Interpolates the heights linearly between the two samples.
  return mix(outside, inside, outsideAbove / max(outsideAbove + insideBelow, 1e-20));
#endif
#endif
}

void relievoSeeRelief(vec3 gazeVC, vec3 vertexVC)
{
  // The shorter side of the pixel's footprint: along the longer one the ray takes its steps.
  float across =
    min(length(relievoUVdX * relievoHeightSize), length(relievoUVdY * relievoHeightSize));
  relievoLevel = max(0.0, log2(across));
#if RELIEVO_METHOD != RELIEVO_METHOD_OFF
  float down = max(-dot(gazeVC, relievoFaceVC), 1e-3);
  vec2 through = relievoTextureStep(gazeVC, relievoPerU, relievoPerV) * (relievoHeightScale / down);
#if RELIEVO_METHOD == RELIEVO_METHOD_PARALLAX
  // Limits the offset: the ray's full shift would tear the surface at grazing angles.
  through *= down;
#endif
  relievoHitDepth = relievoTraceDepth(relievoUV, through);
  vec2 moved = relievoHitDepth * through;
  relievoUV += moved;
  relievoShiftVC = relievoPerU * moved.x + relievoPerV * moved.y;
  relievoSurfaceVC = vertexVC + gazeVC * (relievoHitDepth * relievoHeightScale / down);
#endif
}

// Slope of the heights in world lengths per tile.
vec2 relievoSlopes(vec2 uv)
{
  vec2 texel = exp2(relievoLevel) / relievoHeightSize;
  vec2 x = vec2(texel.x, 0.0);
  vec2 y = vec2(0.0, texel.y);
  return relievoHeightScale * 0.5 *
    vec2(relievoHeight(uv + x) - relievoHeight(uv - x),
      relievoHeight(uv + y) - relievoHeight(uv - y)) / texel;
}

// 1 if a light from this direction (eye space, unit) reaches the visible point of the relief.
float relievoReliefLit(vec3 towardsVC)
{
  float up = dot(towardsVC, relievoFaceVC);
  if (!relievoFramed || up <= 1e-3 || relievoHitDepth <= 0.0)
  {
    return 1.0;
  }
  // From the visible point up to the mesh.
  vec2 through = relievoTextureStep(towardsVC, relievoPerU, relievoPerV) *
    (relievoHeightScale * relievoHitDepth / up);
  float steps = relievoStepsOf(through);
  for (float i = 1.0; i < steps; i += 1.0)
  {
    float way = i / steps;
    float depth = relievoHitDepth * (1.0 - way);
    // The tolerance prevents the start's own slope from blocking the light.
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
  // After all of //VTK::UniformFlow::Impl: there are no derivatives next to discarded fragments.
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
  // Window z is -A - B / z in perspective, A z + B in a parallel projection; A and B come from
  // VTK's matrices. Only the difference from the mesh is computed, which preserves its digits.
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
    normalVCVSOutput = tbn[2]; // the normal before VTK's normal texture, which the map replaces
#endif
    // VTK orients normals by the winding, which a mirroring actor inverts: maps on the visible
    // side, and keeps VTK's orientation.
    float relievoSide = dot(normalVCVSOutput, relievoFaceVC) < 0.0 ? -1.0 : 1.0;
#ifdef RELIEVO_NORMAL_MAP
#ifdef RELIEVO_HEIGHT_MAP
    vec3 relievoMapped =
      textureGrad(relievoNormalMap, relievoUV, relievoUVdX, relievoUVdY).xyz;
#endif
    relievoMapped = relievoMapped * relievoNormalDecode.x + relievoNormalDecode.y;
    // Mapping on the other side and turning the result back equals a change of the sign of x.
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
