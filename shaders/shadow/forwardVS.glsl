//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Forward shadow mapping (H. Zhang, 1998): each sample of a light's map, a square of its texel's
// size, is transformed into the camera's view. Squares of a continuous surface share their corners,
// so that lit areas have no holes; at depth jumps they end half a texel off.
uniform sampler2DArray relievoShadowMaps;
uniform int relievoLayer;
uniform int relievoSize;
uniform mat4 relievoMapToClip; // map space: texels from the centre of the lowest left one, depth
uniform mat4 relievoMapToView;
uniform float relievoJump; // least depth difference of a jump between samples, at w = 1
uniform float relievoTexel; // width of a texel in world units, at w = 1
uniform vec2 relievoW;      // 1 / w of the map = x + y * depth
out float relievoDepthVSOutput;
out float relievoTexelVSOutput;

float relievoSample(ivec2 texel)
{
  ivec2 last = ivec2(relievoSize - 1);
  return texelFetch(relievoShadowMaps, ivec3(clamp(texel, ivec2(0), last), relievoLayer), 0).r;
}

void main()
{
  // An instance is a row of the map.
  int column = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * column;
  ivec2 texel = ivec2(column, gl_InstanceID);
  ivec2 side = ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : -1,
    corner == 2 || corner == 4 || corner == 5 ? 1 : -1);
  float own = relievoSample(texel);
  float inverseW = relievoW.x + relievoW.y * own;
  float jump = relievoJump * inverseW;
  float x = relievoSample(texel + ivec2(side.x, 0));
  float y = relievoSample(texel + ivec2(0, side.y));
  float xy = relievoSample(texel + side);
  bool goesX = abs(x - own) <= jump;
  bool goesY = abs(y - own) <= jump;
  float depth = 0.25 * (own + x + y + xy);
  if (!goesX || !goesY || abs(xy - own) > 2.0 * jump)
  {
    // The slope, by the neighbours on either side of the same surface.
    float beforeX = relievoSample(texel - ivec2(side.x, 0));
    float beforeY = relievoSample(texel - ivec2(0, side.y));
    float slopeX = goesX ? x - own : abs(own - beforeX) <= jump ? own - beforeX : 0.0;
    float slopeY = goesY ? y - own : abs(own - beforeY) <= jump ? own - beforeY : 0.0;
    depth = own + 0.5 * (slopeX + slopeY);
  }
  vec4 map = vec4(vec2(texel) + 0.5 * vec2(side), depth, 1.0);
  vec4 view = relievoMapToView * map;
  relievoDepthVSOutput = -view.z / view.w;
  relievoTexelVSOutput = relievoTexel / inverseW;
  // Depth 1 means no surface.
  gl_Position = own < 1.0 ? relievoMapToClip * map : vec4(2.0, 2.0, 2.0, 1.0);
}
