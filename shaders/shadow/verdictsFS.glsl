//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdicts of all lights about the visible surface at a pixel.
//RELIEVO::Include(formulas/formats/octahedral.glsl)
//RELIEVO::Include(formulas/light/shadow.glsl)
//RELIEVO::Include(shadow/seen.glsl)
//RELIEVO::Include(rays/walk.glsl)
uniform vec4 relievoSeenSource[24]; // w = 0: the direction to it
uniform vec3 relievoShadowCenter;
uniform int cameraParallel;
uniform sampler2D relievoSeenTiles; // see tilesFS.glsl

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec2 seen = texelFetch(relievoSeen, texel, 0).xy;
  bool there = seen.x > -1e29;
  vec3 placeVC = relievoSeenPlace(relievoSeenPixel(vec2(texel)), there ? seen.x : -1.0);
  vec3 placeLC = (relievoShadowToLocal * vec4(placeVC - relievoShadowCenter, 1.0)).xyz;
  float row = floor(seen.y / 4096.0);
  vec3 normalVC = relievoOctDecode(vec2(row, seen.y - 4096.0 * row) / 2047.5 - 1.0);
  float side = cameraParallel != 0 ? normalVC.z : -dot(normalVC, placeVC);
  bool plain = abs(side) >= 0.02 * (cameraParallel != 0 ? 1.0 : length(placeVC));
  vec3 normalLC = mat3(relievoShadowToLocal) * normalVC * sign(side);
  float blur = relievoTreeBlur.x + relievoTreeBlur.y * length(placeVC);
  float slant = there ? side / (cameraParallel != 0 ? 1.0 : length(placeVC)) : 1.0;
  vec3 snapLC =
    mat3(relievoShadowToLocal) * relievoSeenSnap(placeVC, slant, cameraParallel != 0);
  float tile = texelFetch(relievoSeenTiles, texel / 8, 0).x;
  bool closed = tile < 0.0; // all lights reach it
  float sure = closed ? 16777215.0 : tile;
  RELIEVO_PASSES levels = RELIEVO_PASSES(0.0);
  float digit = 1.0;
  for (int light = 0; light < relievoSeenLights; ++light)
  {
    vec4 source = relievoSeenSource[light];
    vec3 ray = relievoSeenToLight(source, placeLC);
    // Surfaces turned away are dark, by the fragment's own normal, whatever is written here. A
    // missing normal, NaN, turns none away.
    float others = floor(0.5 * sure);
    bool open = sure - 2.0 * others < 0.5;
    sure = others;
    bool away = plain && dot(normalLC, ray) <= -0.02 * length(ray);
    bool facing = closed || (there && !away);
    RELIEVO_PASSES passes = relievoTreeWalk(
      facing && open ? relievoTreeNodes : 0, placeLC, ray, source.w != 0.0, blur, snapLC);
    levels += digit * (facing ? relievoSeenLevel(passes) : RELIEVO_PASSES(0.0));
    digit *= relievoSeenLevels;
  }
  gl_FragData[0] = RELIEVO_PASSES_TEXEL(levels);
}
