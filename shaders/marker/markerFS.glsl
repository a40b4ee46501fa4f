//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The cover of a pixel by one marker, premultiplied. All lengths but depths are in units of the
// marker. RELIEVO_MARKER_SHADOWS: some markers are blob shadows, which need the normals.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(formulas/geometry/marker.glsl)
flat in vec4 markerColor;
flat in vec4 markerOrigin;  // from the centre to the ray at the centre's depth; and the pixel
flat in vec4 markerOffsets; // change of the origin per pixel in x, and in y
flat in vec4 markerDepth;   // of the centre; its remainder as a float; 1 / unit; shape
flat in vec4 markerEdges;   // outer and inner radius; for a shadow: heights
flat in vec4 markerAxisX;   // axis of the box, in eye space, and its half length
flat in vec4 markerAxisY;
flat in vec4 markerAxisZ;
uniform vec2 relievoSize;
uniform vec2 markerDirection;     // x and y of the ray of pixel (0, 0), per unit of depth
uniform vec4 markerDirectionStep; // change of the direction per pixel in x, and in y

float relievoSlopeAt(ivec2 pixel, float depth, ivec2 aside, int index, int count)
{
  bool parallel = relievoParallel != 0;
  float before = 0.0;
  float after = 0.0;
  if (index > 0)
  {
    before = -relievoMarkerStep(depth, relievoFetchDepth(pixel - aside), parallel);
  }
  if (index + 1 < count)
  {
    after = relievoMarkerStep(depth, relievoFetchDepth(pixel + aside), parallel);
  }
  before = index > 0 ? before : after;
  after = index + 1 < count ? after : before;
  return relievoMarkerSlope(before, after);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = relievoFetchDepth(pixel);
  if (isinf(depth))
  {
    discard;
  }
  vec2 direction = markerDirection + markerDirectionStep.xy * gl_FragCoord.x +
    markerDirectionStep.zw * gl_FragCoord.y;
  vec2 away = gl_FragCoord.xy - markerOrigin.zw;
  float unit = markerDepth.z;
  float deeper = ((depth - markerDepth.x) - markerDepth.y) * unit;
  vec3 place = vec3(markerOrigin.xy + markerOffsets.xy * away.x + markerOffsets.zw * away.y +
    deeper * direction, -deeper);
  if (!(dot(place, place) < 1e8)) // too far for floats, and for every marker
  {
    discard;
  }
  float share = 0.0;
#ifdef RELIEVO_MARKER_SHADOWS
  if (markerDepth.w == 3.0)
  {
    // The axes of the ellipse around the shadow's axis, over their half lengths; and up.
    float alongX = dot(markerAxisX.xyz, place);
    float alongY = dot(markerAxisY.xyz, place);
    vec3 normalVC = relievoFetchNormal(pixel);
    float facing = dot(normalVC, normalVC) > 0.0 ? dot(normalVC, markerAxisZ.xyz) : 1.0;
    share = relievoBlobShadow(
      alongX * alongX + alongY * alongY, dot(place, markerAxisZ.xyz), markerEdges, facing);
  }
  else
#endif
  {
    vec3 along = vec3(dot(markerAxisX.xyz, place), dot(markerAxisY.xyz, place),
      dot(markerAxisZ.xyz, place));
    vec3 halves = vec3(markerAxisX.w, markerAxisY.w, markerAxisZ.w);
    vec3 inAxes = relievoMarkerWay(along, halves);
    vec3 way = inAxes.x * markerAxisX.xyz + inAxes.y * markerAxisY.xyz +
      inAxes.z * markerAxisZ.xyz;
    float slopeX =
      relievoSlopeAt(pixel, depth, ivec2(1, 0), pixel.x, int(relievoSize.x)) * unit;
    float slopeY =
      relievoSlopeAt(pixel, depth, ivec2(0, 1), pixel.y, int(relievoSize.y)) * unit;
    vec3 alongX = vec3(markerOffsets.xy + deeper * markerDirectionStep.xy + slopeX * direction,
      -slopeX);
    vec3 alongY = vec3(markerOffsets.zw + deeper * markerDirectionStep.zw + slopeY * direction,
      -slopeY);
    float range = length(way);
    float footprint = relievoMarkerFootprint(way, alongX, alongY);
    vec3 normal = cross(alongX, alongY);
    float shown = length(normal);
    float box = relievoMarkerBoxWidth(inAxes, vec3(dot(markerAxisX.xyz, normal),
      dot(markerAxisY.xyz, normal), dot(markerAxisZ.xyz, normal)) / shown, halves);
    share = markerDepth.w == 0.0
      ? relievoMarkerRing(range, markerEdges.y, markerEdges.x, footprint, shown, box)
      : markerDepth.w == 1.0 ? relievoMarkerGlow(range, markerEdges.x, footprint)
                             : relievoMarkerDisc(range, markerEdges.x, footprint, shown, box);
  }
  float alpha = markerColor.a * share;
  if (!(alpha > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(markerColor.rgb * alpha, alpha);
}
