// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The contract of the splices of gbuffer/, shadow/ and material/ into VTK's fragment shaders: all
// names that one of them defines and another reads. Each may be present without the others, in any
// order: all insert the defaults (vtkRelievoSpliceText::GetContract) after //VTK::System::Dec, so
// that readers always find a definition; definers use #undef and #define.
//
// name                        defined by   read by   type, unit, range
// RELIEVO_VISIBILITY(number)  shadow       gbuffer   float, 0 dark to 1 lit: what of the
//                                                    renderer's light `number` (from 0, those that
//                                                    are off included) passes; after
//                                                    //VTK::Light::Impl
// RELIEVO_SURFACE_VC          material     gbuffer   vec3, eye space, world units: the place that
//                                                    the depth tells; after
//                                                    //VTK::UniformFlow::Impl
// RELIEVO_RECEIVER(matrix, place)
//                             material     shadow    vec4 in the space that `matrix` (mat4) leads
//                                                    to from eye space: where what is seen at
//                                                    `place` (vec4 there, of the mesh) receives
//                                                    its light; after //VTK::UniformFlow::Impl
// RELIEVO_ALPHA(alpha)        material     gbuffer   float, 0 to 1: the opacity that is drawn,
//                                                    of that of colours and textures
//
// relievoFromLight            shadow       material  uniform int, 1 while what a light sees is
//                                                    drawn, else and without shadow/ 0; whoever
//                                                    reads it declares it
//
// A macro is expanded where it is read: the names that it uses must be declared before that place.
// material/ declares behind //VTK::PositionVC::Dec, shadow/ behind //VTK::Light::Dec, gbuffer/
// behind //VTK::Output::Dec; in main(), material/ writes before //VTK::UniformFlow::Impl, shadow/
// before //VTK::Light::Impl, and gbuffer/ reads behind //VTK::Picking::Impl.
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
#define RELIEVO_SURFACE_VC vertexVC.xyz
#define RELIEVO_RECEIVER(matrix, place) (place)
#define RELIEVO_ALPHA(alpha) (alpha)
#endif
