//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The cover of a pixel by a piece of a dashed line that is hidden by the visible surface.
//RELIEVO::Include(gbuffer/read.glsl)
flat in vec4 linesEnds;
flat in vec4 linesAlong;
uniform vec2 relievoSize;
uniform mat4 relievoProjection;
uniform float linesHalfWidth;
uniform float linesDashShare;

// A line is hidden if the visible surface lies in front of it in the pixel and all around it, by
// more than this many pixels' widths: next to a visible edge some pixel shows the edge's own depth.
const float linesBefore = 3.0;

bool linesIsHidden(vec2 place, float nearness)
{
  // Width of a pixel at unit depth; times z in perspective, so times 1 / z for depths stored as 1 /
  // z.
  float width = 2.0 / (relievoProjection[1][1] * relievoSize.y);
  float least = nearness + linesBefore * width * (relievoParallel != 0 ? 1.0 : nearness);
  ivec2 last = ivec2(relievoSize) - 1;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      float depth =
        relievoFetchDepth(clamp(ivec2(floor(place)) + ivec2(x, y), ivec2(0), last));
      if (isinf(depth) || !((relievoParallel != 0 ? -depth : 1.0 / depth) > least))
      {
        return false;
      }
    }
  }
  return true;
}

void main()
{
  vec2 way = linesEnds.zw - linesEnds.xy;
  float far = length(way);
  float along =
    far > 0.0 ? clamp(dot(gl_FragCoord.xy - linesEnds.xy, way) / (far * far), 0.0, 1.0) : 0.0;
  vec2 place = linesEnds.xy + along * way;
  float cover =
    clamp(linesHalfWidth + 0.5 - distance(gl_FragCoord.xy, place), 0.0, 1.0);
  float steps = linesAlong.w - linesAlong.z;
  if (steps > 0.0)
  {
    float at = linesAlong.z + along * steps;
    float off = abs(at - floor(at + 0.5)); // distance from a dash's middle
    cover *= clamp((0.5 * linesDashShare - off) * far / steps + 0.5, 0.0, 1.0);
  }
  if (!(cover > 0.0) || !linesIsHidden(place, mix(linesAlong.x, linesAlong.y, along)))
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0, 0.0, cover, 0.0);
}
