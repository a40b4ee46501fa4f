// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The layers of a volume, in VTK's march through it. By vtkRelievoVolumesStage:
//
// RELIEVO_VOLUME_EXTREME    the blend mode shows the greatest value (1.0) or the least (-1.0)
// RELIEVO_VOLUME_COMPONENT  index of the component that gives the value
// RELIEVO_VOLUME_GRID       the coordinates of texels are not equidistant
// RELIEVO_VOLUME_CLIPPED    there are clipping planes, behind which the march begins
//
// VTK's own `scalar`, a sample's values, is local to the march's code; the splice makes it global.
// Positions along the ray are in steps, 0 at the ray's entry: samples are at 1, 2, ...

//RELIEVO::Section(Dec)
// Rules: 0 the first visible sample, 1 where the accumulated opacity reaches a threshold, 2 the
// sample that contributes most.
uniform int relievoVolumeRule;
uniform float relievoVolumeThreshold;
uniform vec3 relievoVolumePoints; // number of the data's points along each axis
uniform int relievoVolumeLinear; // values between points are interpolated

vec4 scalar = vec4(0.0);
bool relievoVolumeFound = false;
float relievoVolumeOpacity = 0.0; // accumulated before the present sample
float relievoVolumeMost = 0.0;    // contribution, or extreme value, of the sample found
float relievoVolumeSteps = 0.0;   // of the position found
float relievoVolumeValue = 0.0;   // there, 0 to 1 over the data's range
bool relievoVolumeStarted = false;
float relievoVolumeLast = 0.0;    // value of the sample before; where it was skipped, the present's

// Takes a point between the last sample (0) and the present one (1).
void relievoVolumeTake(float share, float value)
{
#ifdef RELIEVO_VOLUME_CLIPPED
  vec3 first = g_rayOrigin;
#else
  vec3 first = ip_textureCoords;
#endif
  float steps = floor(length(g_dataPos - first) / length(g_dirStep) + 0.5);
#ifdef RELIEVO_VOLUME_CLIPPED
  steps += length(first - ip_textureCoords) / length(g_dirStep);
#endif
  relievoVolumeFound = true;
  relievoVolumeSteps = steps - 1.0 + share;
  relievoVolumeValue = relievoVolumeLinear != 0 ? mix(relievoVolumeLast, value, share) : value;
}

void relievoVolumeSample()
{
  float value = scalar[RELIEVO_VOLUME_COMPONENT];
  relievoVolumeLast = relievoVolumeStarted ? relievoVolumeLast : value;
  relievoVolumeStarted = true;
#ifdef RELIEVO_VOLUME_EXTREME
  if (!relievoVolumeFound || RELIEVO_VOLUME_EXTREME * (value - relievoVolumeMost) > 0.0)
  {
    relievoVolumeMost = value;
    relievoVolumeTake(1.0, value);
  }
#else
  float added = g_fragColor.a - relievoVolumeOpacity;
  if (relievoVolumeRule == 1)
  {
    if (!relievoVolumeFound && g_fragColor.a >= relievoVolumeThreshold)
    {
      // A sample stands for the step before it, with constant extinction.
      float passed = (1.0 - g_fragColor.a) / (1.0 - relievoVolumeOpacity);
      float needed = (1.0 - relievoVolumeThreshold) / (1.0 - relievoVolumeOpacity);
      relievoVolumeTake(passed > 0.0 ? clamp(log(needed) / log(passed), 0.0, 1.0) : 0.0, value);
    }
  }
  else if (added > relievoVolumeMost && (relievoVolumeRule == 2 || !relievoVolumeFound))
  {
    relievoVolumeMost = added;
    relievoVolumeTake(1.0, value);
  }
  relievoVolumeOpacity = g_fragColor.a;
#endif
  relievoVolumeLast = value;
}

// Direction in which values fall, in the world; 0 where they do not change.
vec3 relievoVolumeNormal(vec3 place)
{
#ifdef RELIEVO_VOLUME_GRID
  return vec3(0.0);
#else
  vec3 rise;
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 voxel = vec3(0.0);
    voxel[axis] = in_cellStep[0][axis];
    rise[axis] = (texture(in_volume[0], place + voxel)[RELIEVO_VOLUME_COMPONENT] -
                   texture(in_volume[0], place - voxel)[RELIEVO_VOLUME_COMPONENT]) /
      voxel[axis];
  }
  vec3 inWorld = transpose(mat3(RELIEVO_VOLUME_FROM_WORLD)) * rise;
  float size = length(inWorld);
  return size > 0.0 ? -inWorld / size : vec3(0.0);
#endif
}

float relievoVolumeEyeDepth(vec3 place)
{
  vec4 eye = in_modelViewMatrix * (RELIEVO_VOLUME_TO_WORLD * vec4(place, 1.0));
  return -eye.z / eye.w;
}

// In each texel, alpha replaces what lies behind by VTK's blending of blocks, back to front; that
// of the first texel is the accumulated opacity.
void relievoVolumeWrite()
{
#ifdef RELIEVO_VOLUME_EXTREME
  relievoVolumeFound = relievoVolumeFound && g_fragColor.a > 0.0;
#endif
  // A brick of the data (vtkOpenGLGPUVolumeRayCastMapper::SetPartitions); cells are one less.
  vec3 size = in_textureExtentsMax - in_textureExtentsMin;
  bool brick = any(lessThan(size, relievoVolumePoints - 2.5));
  gl_FragData[0] = vec4(relievoVolumeEyeDepth(ip_textureCoords), in_sampleDistance,
    brick ? 1.0 : 0.0, g_fragColor.a);
  gl_FragData[1] = vec4(0.0);
  gl_FragData[2] = vec4(0.0);
  if (relievoVolumeFound)
  {
    vec3 place = ip_textureCoords + relievoVolumeSteps * g_dirStep;
    vec2 range = in_scalarsRange[RELIEVO_VOLUME_COMPONENT];
    gl_FragData[1] = vec4(relievoVolumeSteps, range.x + relievoVolumeValue * (range.y - range.x),
      relievoVolumeEyeDepth(place), 1.0);
    gl_FragData[2] = vec4(relievoVolumeNormal(place), 1.0);
  }
}

//RELIEVO::Section(Local)
      vec4 scalar;

//RELIEVO::Section(Sample)
    if (!g_skip)
    {
      relievoVolumeSample();
    }
    else
    {
      relievoVolumeStarted = false;
    }

//RELIEVO::Section(Exit)
  relievoVolumeWrite();
