// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdict of a ray from the fragment's own place to the light, past the casters' triangles;
// casters without triangles are in maps: see receive.glsl.
//
// FoundImpl: for surfaces whose verdicts verdictsFS.glsl has found, pixel by pixel; hidden
// fragments may get any verdict. TraceImpl: for all others, which take these verdicts if their
// place is the visible one, and otherwise trace the ray themselves, with the same result.

//RELIEVO::Section(MethodDec)
//RELIEVO::Include(shadow/seen.glsl)
uniform vec4 relievoShadowSource[RELIEVO_SHADOW_LIGHTS]; // w = 0: the direction to it
uniform sampler2D relievoSeenVerdicts; // levels of the lights, as digits of a number

float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
{
  return relievoShadowFilter(face, place, slope, texel);
}

#ifdef RELIEVO_SHADOW_WIDENED
uniform vec4 vpDims; // of VTK's geometry shader: the viewport

// The pixel's place in the plane of a nearby place; the given place if the plane is seen edge-on.
vec3 relievoSeenInPlane(vec3 place, vec3 normal)
{
  vec2 pixel = gl_FragCoord.xy - vpDims.xy - 0.5 * vpDims.zw;
  vec3 start = relievoSeenPlace(pixel, place.z);
  vec3 along = relievoSeenPlace(pixel, place.z - max(abs(place.z), 1e-30)) - start;
  float steep = dot(normal, along);
  return abs(steep) > 1e-3 * length(along) * length(normal)
    ? start + along * (dot(normal, place - start) / steep)
    : place;
}
#endif

// The transmitted light is all that remains of a light.
void relievoShadowTake(int slot, RELIEVO_PASSES passes)
{
#ifdef RELIEVO_SHADOW_COLORED
  relievoShadowColors[slot] *= passes.rgb;
#endif
  relievoVisibility[slot] *= RELIEVO_PASSES_WHOLE(passes);
}

//RELIEVO::Section(TraceDec)
//RELIEVO::Include(rays/walk.glsl)
uniform int relievoSeenHides; // whether it hides everything behind it: no samples of pixels' edges

//RELIEVO::Section(PlaceImpl)
  vec2 relievoSeenOwn = relievoSeenAt(vertexVC.xyz);
  vec2 relievoSeenOwnTexel =
    clamp(relievoSeenTexel(relievoSeenOwn), vec2(0.0), relievoSeenSize - 1.0);
  vec2 relievoSeenCenter = relievoSeenPixel(relievoSeenOwnTexel);
  vec2 relievoSeenOff = abs(relievoSeenOwn - relievoSeenCenter);
#ifdef RELIEVO_SHADOW_WIDENED
  bool relievoSeenCentered = false;
  float relievoSeenInside = 0.0; // not in the band by which the triangle was widened
  for (int i = 0; i < 3; ++i)
  {
    relievoSeenInside =
      min(relievoSeenInside, dot(edgeEqn[i].xy, gl_FragCoord.xy) + edgeEqn[i].w);
  }
  vec3 relievoShadowPlaceVC = relievoSeenInside < 0.0
    ? vertexVC.xyz
    : relievoSeenInPlane(vertexVC.xyz, relievoShadowNormalVC);
#else
  bool relievoSeenCentered = max(relievoSeenOff.x, relievoSeenOff.y) < 0.004;
  vec3 relievoShadowPlaceVC =
    relievoSeenCentered ? relievoSeenPlace(relievoSeenCenter, vertexVC.z) : vertexVC.xyz;
#endif
  vec4 relievoShadowOwnLC =
    relievoShadowToLocal * vec4(relievoShadowPlaceVC - relievoShadowCenter, 1.0);
  vec3 relievoShadowPlaceLC = RELIEVO_RECEIVER(relievoShadowToLocal, relievoShadowOwnLC).xyz;
  vec3 relievoShadowNormalLC = mat3(relievoShadowToLocal) * relievoShadowNormalVC;
  float relievoShadowSide = cameraParallel != 0 ? relievoShadowNormalVC.z
                                                : -dot(relievoShadowNormalVC, vertexVC.xyz);
  RELIEVO_PASSES relievoSeenDigits =
    RELIEVO_PASSES_OF_TEXEL(texelFetch(relievoSeenVerdicts, ivec2(relievoSeenOwnTexel), 0));
  int relievoShadowTaken = relievoShadowInner < 0.0 ? 0 : RELIEVO_SHADOW_LIGHTS;
#ifdef RELIEVO_SHADOW_COLORED
  for (int slot = 0; slot < RELIEVO_SHADOW_LIGHTS; ++slot)
  {
    relievoShadowColors[slot] = vec3(relievoVisibility[slot]);
  }
#endif

//RELIEVO::Section(FoundVertexDec)
invariant gl_Position; // equal to that of seenVS.glsl

//RELIEVO::Section(FoundImpl)
  for (int slot = 0; slot < relievoShadowTaken; ++slot)
  {
    RELIEVO_PASSES level = relievoSeenNextLevel(relievoSeenDigits);
    vec3 ray = relievoSeenToLight(relievoShadowSource[slot], relievoShadowPlaceLC);
    // Dark if the visible side is turned away from the light.
    bool facing =
      !RELIEVO_SHADOW_HAS_PLANE || dot(relievoShadowNormalLC, ray) * relievoShadowSide > 0.0;
    relievoShadowTake(slot, facing ? relievoSeenVerdict(level) : RELIEVO_PASSES(0.0));
  }

//RELIEVO::Section(TraceImpl)
  {
    float front = texelFetch(relievoSeen, ivec2(relievoSeenOwnTexel), 0).x;
    bool same = relievoSeenCentered && relievoShadowPlaceLC == relievoShadowOwnLC.xyz &&
      front == vertexVC.z;
    // Fragments behind it will be overdrawn. The margin: steps of a depth buffer.
    bool hidden = relievoSeenCentered && relievoSeenHides != 0 &&
      relievoSeenDepth(vertexVC.z) - relievoSeenDepth(front) > 1e-6;
    int found = hidden ? RELIEVO_SHADOW_LIGHTS : same ? relievoSeenLights : 0;
    float blur = relievoTreeBlur.x + relievoTreeBlur.y * length(relievoShadowPlaceVC);
    float slant = RELIEVO_SHADOW_HAS_PLANE
      ? relievoShadowSide /
        ((cameraParallel != 0 ? 1.0 : length(vertexVC.xyz)) * length(relievoShadowNormalVC))
      : 1.0;
    vec3 snapLC = mat3(relievoShadowToLocal) *
      relievoSeenSnap(relievoShadowPlaceVC, slant, cameraParallel != 0);
    for (int slot = 0; slot < relievoShadowTaken; ++slot)
    {
      RELIEVO_PASSES level = relievoSeenNextLevel(relievoSeenDigits);
      vec4 source = relievoShadowSource[slot];
      vec3 ray = relievoSeenToLight(source, relievoShadowPlaceLC);
      bool facing =
        !RELIEVO_SHADOW_HAS_PLANE || dot(relievoShadowNormalLC, ray) * relievoShadowSide > 0.0;
      bool open = facing && slot >= found;
      RELIEVO_PASSES passes = relievoTreeWalk(
        open ? relievoTreeNodes : 0, relievoShadowPlaceLC, ray, source.w != 0.0, blur, snapLC);
      RELIEVO_PASSES digit = open ? relievoSeenLevel(passes) : level;
      relievoShadowTake(slot, facing ? relievoSeenVerdict(digit) : RELIEVO_PASSES(0.0));
    }
  }
