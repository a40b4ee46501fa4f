// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Leaves out samples of VTK's march through a volume that the transfer function makes transparent
// (vtkRelievoEmptySpaceStage). The other samples keep their places bit for bit: VTK's additions of
// the step are repeated, without the work of a sample.
//
// Software OpenGL executes both branches of an `if`: a transparent sample is as expensive as any
// other. There are two ways, by vtkRelievoEmptySpaceStage:
//
// - RELIEVO_EMPTY_PROBES, for volumes with gradients: in blocks of voxels that are not empty, the
//   opacity is looked up first, so that the pixels that are drawn together take visible samples
//   together.
// - Otherwise VTK's loop over samples becomes the inner one of two: it takes the samples of a block
//   that is not empty, and the outer one skips the others, without a look-up for each sample.
//
// The march for layers (volumes/layers.glsl) looks at all samples.

//RELIEVO::Section(Dec)
#ifndef RELIEVO_VOLUME_COMPONENT
uniform sampler3D relievoEmptyBlocks; // distance to the next block that is not empty, in 1/255
uniform vec3 relievoEmptyScale;       // from texture coordinates to blocks

vec3 relievoEmptyInverse;  // of the step, in blocks
vec3 relievoEmptyAhead;    // 1 where the step is positive
float relievoEmptyEnd;     // g_currentT up to which the march does not end
float relievoEmptySamples; // to be taken before the next look-up

// At the march's beginning.
void relievoEmptyBegin()
{
  vec3 way = g_dirStep * relievoEmptyScale;
  relievoEmptyAhead = step(vec3(0.0), way);
  relievoEmptyInverse = (2.0 * relievoEmptyAhead - 1.0) / max(abs(way), vec3(1e-12));
  vec3 border = mix(in_texMin[0], in_texMax[0], relievoEmptyAhead);
  vec3 steps = (border - g_dataPos) * relievoEmptyScale * relievoEmptyInverse;
  float inside = floor(min(min(steps.x, steps.y), steps.z) - 0.01);
  relievoEmptyEnd = g_currentT + min(inside, floor(g_terminatePointMax - g_currentT));
}

// Skips samples of the empty blocks around the present place; returns whether there were any.
bool relievoEmptySkip()
{
  vec3 place = g_dataPos * relievoEmptyScale;
  // Rounding puts samples at the image's border before the first block, or behind the last one.
  ivec3 last = textureSize(relievoEmptyBlocks, 0) - 1;
  vec3 block = clamp(floor(place), vec3(0.0), vec3(last));
  float empty = floor(255.0 * texelFetch(relievoEmptyBlocks, ivec3(block), 0).r + 0.5);
  // Radius and border of the blocks nearer than the next one that is not empty, or of this block.
  float radius = max(empty, 1.0);
  vec3 border = block + mix(vec3(1.0 - radius), vec3(radius), relievoEmptyAhead);
  vec3 steps = (border - place) * relievoEmptyInverse;
  float samples = floor(min(min(steps.x, steps.y), steps.z)) + 1.0;
  float skipped = empty > 0.0 ? min(samples, relievoEmptyEnd - g_currentT) : 0.0;
  skipped = skipped >= 1.0 ? min(skipped, 65536.0) : 0.0;
  relievoEmptySamples = empty > 0.0 ? 1.0 : samples;
  g_currentT += skipped;
  bool any = skipped > 0.0;
  for (; skipped > 0.0; --skipped)
  {
    g_dataPos += g_dirStep;
  }
  return any;
}

#ifdef RELIEVO_EMPTY_PROBES
// Skips transparent samples of a block that is not empty. Returns whether its end was reached, and
// not that of the march.
bool relievoEmptyProbe()
{
  float left = min(relievoEmptySamples, relievoEmptyEnd - g_currentT);
  bool visible = !(left >= 1.0);
  while (!visible && left >= 1.0)
  {
    float scalar = texture(in_volume[0], g_dataPos).r * in_volume_scale[0].r + in_volume_bias[0].r;
    visible = computeOpacity(vec4(scalar)) > 0.0;
    if (!visible)
    {
      g_dataPos += g_dirStep;
      ++g_currentT;
      --left;
    }
  }
  return !visible;
}
#endif
#endif

//RELIEVO::Section(Begin)
#ifndef RELIEVO_VOLUME_COMPONENT
  relievoEmptyBegin();
#endif

//RELIEVO::Section(Skip)
#ifndef RELIEVO_VOLUME_COMPONENT
    bool relievoEmptySkips = true;
    while (relievoEmptySkips)
    {
      relievoEmptySkips = relievoEmptySkip();
#ifdef RELIEVO_EMPTY_PROBES
      if (!relievoEmptySkips)
      {
        relievoEmptySkips = relievoEmptyProbe();
      }
    }
#else
    }
    bool relievoEmptyEnded = true; // by a break of VTK's
    while (!g_exit)
    {
#endif
#endif

//RELIEVO::Section(Next)
#if !defined(RELIEVO_VOLUME_COMPONENT) && !defined(RELIEVO_EMPTY_PROBES)
      relievoEmptySamples -= 1.0;
      if (!(relievoEmptySamples >= 1.0))
      {
        relievoEmptyEnded = false;
        break;
      }
    }
    if (relievoEmptyEnded)
    {
      break;
    }
#endif
