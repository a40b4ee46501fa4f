//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// One map of a light, over the drawn area.
//RELIEVO::Include(formulas/formats/depth.glsl)
in vec2 texCoord;
uniform sampler2DArray relievoLightMaps;
uniform float relievoLightLayer;
uniform vec3 relievoLightRange; // near, far, whether rays are parallel

void main()
{
  ivec2 size = textureSize(relievoLightMaps, 0).xy;
  ivec2 texel = clamp(ivec2(floor(texCoord * vec2(size))), ivec2(0), size - 1);
  float z = texelFetch(relievoLightMaps, ivec3(texel, int(relievoLightLayer)), 0).r;
  float near = relievoLightRange.x;
  float far = relievoLightRange.y;
  float depth =
    relievoLightRange.z != 0.0 ? z * (far - near) : relievoPerspectiveDepth(z, near, far);
  gl_FragData[0] = vec4(z >= 1.0 ? relievoInfinity() : depth);
}
