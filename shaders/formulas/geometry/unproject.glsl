// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Clip, NDC and window coordinates, and the inverse: from a pixel and its linear depth to eye and
// world positions.
//
// Matrices are GLSL's: columns, position = matrix * column vector. pIJ is projection[I][J] (column
// I, row J), which vtkMatrix4x4 stores as element (J, I). Eye space looks along -z; depth is -z.
// Pixel (0, 0) is the lower left one of the viewport, its centre at (0.5, 0.5).

// Clip coordinates to normalised device coordinates.
vec3 relievoNdcFromClip(vec4 clip)
{
  return vec3(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
}

// NDC to window coordinates and window z in [0, 1]; viewport: x, y, width, height in pixels.
vec3 relievoWindowFromNdc(vec3 ndc, vec4 viewport)
{
  return vec3(viewport.x + (float(0.5) * ndc.x + float(0.5)) * viewport.z,
    viewport.y + (float(0.5) * ndc.y + float(0.5)) * viewport.w,
    float(0.5) * ndc.z + float(0.5));
}

// Window coordinates and window z (those of gl_FragCoord) to NDC.
vec3 relievoNdcFromWindow(vec3 window, vec4 viewport)
{
  return vec3((float(2.0) * (window.x - viewport.x) - viewport.z) / viewport.z,
    (float(2.0) * (window.y - viewport.y) - viewport.w) / viewport.w,
    float(2.0) * window.z - float(1.0));
}

// NDC of the centre of a pixel, counted from 0 within a viewport of `size` pixels.
vec2 relievoNdcFromPixel(vec2 pixel, vec2 size)
{
  return vec2((float(2.0) * pixel.x + float(1.0) - size.x) / size.x,
    (float(2.0) * pixel.y + float(1.0) - size.y) / size.y);
}

// The pixel's direction in perspective: the eye position at depth 1. p20 and p21 are the offset of
// an off-centre window, 0 in a centred one.
vec3 relievoEyeDirection(vec2 ndc, float p00, float p11, float p20, float p21)
{
  return vec3((ndc.x + p20) / p00, (ndc.y + p21) / p11, float(-1.0));
}

// Eye position from NDC and depth, perspective.
vec3 relievoPerspectiveEyePosition(
  vec2 ndc, float depth, float p00, float p11, float p20, float p21)
{
  return depth * relievoEyeDirection(ndc, p00, p11, p20, p21);
}

// Eye position from NDC and depth, parallel projection; p30 and p31 shift an off-centre window.
vec3 relievoParallelEyePosition(vec2 ndc, float depth, float p00, float p11, float p30, float p31)
{
  return vec3((ndc.x - p30) / p00, (ndc.y - p31) / p11, -depth);
}

// Eye position from NDC and depth for any projection, sheared (oblique) ones included: the x and y
// for which rows 0 and 1 of the projection, at this z, give ndc times row 3.
vec3 relievoEyePosition(vec2 ndc, float depth, mat4 projection)
{
  float z = -depth;
  float a00 = projection[0][0] - ndc.x * projection[0][3];
  float a01 = projection[1][0] - ndc.x * projection[1][3];
  float a10 = projection[0][1] - ndc.y * projection[0][3];
  float a11 = projection[1][1] - ndc.y * projection[1][3];
  float w = projection[2][3] * z + projection[3][3];
  float b0 = ndc.x * w - (projection[2][0] * z + projection[3][0]);
  float b1 = ndc.y * w - (projection[2][1] * z + projection[3][1]);
  float determinant = a00 * a11 - a01 * a10;
  return vec3((b0 * a11 - b1 * a01) / determinant, (b1 * a00 - b0 * a10) / determinant, z);
}

// World position from an eye position; cameraToWorld is affine.
vec3 relievoWorldPosition(vec3 eye, mat4 cameraToWorld)
{
  vec4 world = cameraToWorld * vec4(eye.x, eye.y, eye.z, float(1.0));
  return vec3(world.x, world.y, world.z);
}

// Linear depth of an eye position.
float relievoDepthFromEyePosition(vec3 eye)
{
  return -eye.z;
}

// Distance from the eye, of an eye position or of a depth along relievoEyeDirection (perspective).
float relievoRange(vec3 eye)
{
  return length(eye);
}

float relievoRangeFromDepth(float depth, vec3 eyeDirection)
{
  return depth * length(eyeDirection);
}
