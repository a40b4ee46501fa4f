//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Fades what is far towards a colour: the colour, and its fraction as alpha, to be blended over.
//RELIEVO::Include(gbuffer/read.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;    // of the viewport, pixels
uniform ivec2 relievoOffset; // of the viewport within the G-buffer
uniform vec3 sampleColor;
uniform float sampleStrength;

void main()
{
  float depth = relievoFetchDepth(ivec2(floor(texCoord * relievoSize)) + relievoOffset);
  float far = clamp((depth - relievoNear) / (relievoFar - relievoNear), 0.0, 1.0);
  gl_FragData[0] = vec4(sampleColor, isinf(depth) ? 0.0 : sampleStrength * far);
}
