// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The contract of what gbuffer/, shadow/ and material/ splice into VTK's fragment shaders: every
// name that one of them defines and another reads, and no other. Each may be there without the
// others, in any order: all put the defaults (vtkRelievoSpliceText::GetContract) behind
// //VTK::System::Dec; whoever reads finds them, whoever defines says #undef and #define.
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
// A macro is expanded where it is read: what it names must be declared further up by then.
// material/ declares behind //VTK::PositionVC::Dec, shadow/ behind //VTK::Light::Dec, gbuffer/
// behind //VTK::Output::Dec; in main(), material/ writes before //VTK::UniformFlow::Impl, shadow/
// before //VTK::Light::Impl, and gbuffer/ reads behind //VTK::Picking::Impl.
//
// RELIEVO_NUMBER is no macro: C++ fills it with the index of a light as in VTK's lightColor0.
//
// Names of VTK's shaders that are read: vertexVC (position.glsl makes it where VTK has none),
// normalVCVSOutput, cameraParallel, opacity, lightColorN. Names of VTK's that are taken over in
// main(): lightColorN is VTK's light times what shadow/ and the relief of material/ let through,
// tcoordVCVSOutput is the place that the relief shows; gbuffer/'s albedo runs VTK's code of
// textures once more, and so sees what they made of it.

//RELIEVO::Section(Defaults)
#ifndef RELIEVO_CONTRACT
#define RELIEVO_CONTRACT
#define RELIEVO_VISIBILITY(number) 1.0
#define RELIEVO_SURFACE_VC vertexVC.xyz
#define RELIEVO_RECEIVER(matrix, place) (place)
#define RELIEVO_ALPHA(alpha) (alpha)
#endif
