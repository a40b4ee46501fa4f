// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The contract of the splices of gbuffer/, shadow/ and material/ into VTK's fragment shaders: all
// names that one of them defines and another reads. Each may be present without the others, in any
// order: all insert the defaults (vtkRelievoSpliceText::GetContract) after //VTK::System::Dec, so
// that readers always find a definition; definers use #undef and #define.
//
// name                        defined by   read by   type, unit, range
// RELIEVO_VISIBILITY(number)  shadow       gbuffer   float, 0 dark to 1 lit: unblocked share
//                                                    of the renderer's light `number` (from 0,
//                                                    switched-off lights included); after
//                                                    //VTK::Light::Impl
// RELIEVO_DIRECT_LIGHT        shadow       gbuffer   vec3, 0 to 1: the share of casting lights in
//                                                    the light of each linear colour channel;
//                                                    after //VTK::Light::Impl
// RELIEVO_SURFACE_VC          material     gbuffer   vec3, eye space, world units: the position
//                                                    at the fragment's depth; after
//                                                    //VTK::UniformFlow::Impl
// RELIEVO_RECEIVER(matrix, place)
//                             material     shadow    vec4 in the target space of `matrix` (mat4,
//                                                    from eye space): the point that receives
//                                                    light for the mesh's point `place` (vec4 in
//                                                    that space); after //VTK::UniformFlow::Impl
// RELIEVO_ALPHA(alpha)        material     gbuffer   float, 0 to 1: the drawn opacity, for the
//                                                    opacity of colours and textures
//
// relievoFromLight            shadow       material  uniform int, 1 while a light's view is drawn,
//                                                    -1 while a shadow method draws the camera's
//                                                    depth, else, and without shadow/, 0; each
//                                                    reader declares it
//
// A macro is expanded where it is read: the names that it uses must be declared before that place.
// material/ declares after //VTK::PositionVC::Dec, shadow/ after //VTK::Light::Dec, gbuffer/
// after //VTK::Output::Dec; in main(), material/ writes before //VTK::UniformFlow::Impl, shadow/
// before //VTK::Light::Impl, and gbuffer/ reads after //VTK::Picking::Impl.
//
// RELIEVO_NUMBER is not a macro: C++ replaces it by the index of a light in VTK's lightColor0.
//
// Reads these names of VTK's shaders: vertexVC (position.glsl makes it if VTK does not),
// normalVCVSOutput, cameraParallel, opacity, lightColorN. Redefines these in main(): lightColorN is
// VTK's light times the share that passes shadow/ and the relief of material/, tcoordVCVSOutput is
// the visible point of the relief; gbuffer/'s albedo runs VTK's code of textures again, and so uses
// them.

//RELIEVO::Section(Defaults)
#ifndef RELIEVO_CONTRACT
#define RELIEVO_CONTRACT
#define RELIEVO_VISIBILITY(number) 1.0
#define RELIEVO_DIRECT_LIGHT vec3(0.0)
#define RELIEVO_SURFACE_VC vertexVC.xyz
#define RELIEVO_RECEIVER(matrix, place) (place)
#define RELIEVO_ALPHA(alpha) (alpha)
#endif
