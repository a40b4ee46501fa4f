//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible share of the sky at each pixel's surface, by rays through the triangles of the scene;
// 1 in the background.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(formulas/geometry/unproject.glsl)
//RELIEVO::Include(ambient/sees.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform mat4 relievoProjection;
uniform mat4 ambientToLocal; // the tree's space, from eye space

// Upper bound of the error of a stored depth.
float ambientDepthStep(float depth)
{
#ifdef RELIEVO_NORMAL_DEPTH_WORD
#if RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA8
  return (relievoFar - relievoNear) / 254.0;
#elif RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA16F
  return depth / 512.0;
#else
  return 0.0;
#endif
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_16F
  return depth / 512.0;
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_WINDOW_Z24
  float range = relievoFar - relievoNear;
  return (relievoParallel != 0 ? range : depth * depth * range / (relievoFar * relievoNear)) /
    8388608.0;
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_REVERSED_32F
  float range = relievoFar - relievoNear;
  return (relievoParallel != 0 ? range : depth * range / relievoFar) / 2097152.0;
#else
  return 0.0;
#endif
}

// Rasterisers round corners to 1/256 of a pixel: next to an edge shared by two walls, a pixel may
// show a wall where it lies behind the other one, and GPUs give a surface the depth of a place some
// hundredths of a pixel away (0.04 on NVIDIA's H100, `relievo bench position`). A start moved
// towards the eye by this many pixels' widths lies in front of both walls.
const float ambientBefore = 1.0 / 16.0;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  float depth = relievoFetchDepth(pixel);
  vec3 normal = relievoFetchGeometricNormal(pixel);
  bool surface = !isinf(depth) && dot(normal, normal) > 0.5;
  depth = surface ? depth : relievoNear;
  vec3 place =
    relievoEyePosition(relievoNdcFromPixel(vec2(pixel), relievoSize), depth, relievoProjection);
  bool away = relievoParallel != 0 ? normal.z < 0.0 : dot(normal, place) > 0.0;
  vec3 up = surface ? normalize(mat3(ambientToLocal) * (away ? -normal : normal))
                    : vec3(0.0, 0.0, 1.0);
  float pixelWidth = (relievoParallel != 0 ? 2.0 : 2.0 * depth) /
    (abs(relievoProjection[1][1]) * relievoSize.y);
  vec3 toEye = relievoParallel != 0 ? vec3(0.0, 0.0, 1.0) : -normalize(place);
  vec3 before = place + ambientBefore * pixelWidth * toEye;
  // A depth of few bits may lie behind the surface.
  float step = ambientDepthStep(depth) * (relievoParallel != 0 ? 1.0 : length(place) / depth);
  vec3 from = (ambientToLocal * vec4(before, 1.0)).xyz + step * up;
  float blur = relievoTreeBlur.x + relievoTreeBlur.y * length(place) + 2.0 * step;
  gl_FragData[0] =
    vec4(relievoAmbientSees(surface ? relievoTreeNodes : 0, from, up, blur, pixel));
}
