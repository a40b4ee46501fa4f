// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders of shadow catchers: darkens them by the hidden share of the
// sky, except for the share of casting lights. Other splices into the same shader traverse their
// own trees, so C++ replaces `relievo` by `ambient` in all names of this one.
//
// Reads these names of VTK's shaders: vertexVC, normalVCVSOutput, gl_FragData[0]; and, as
// AMBIENT_SPARED, RELIEVO_DIRECT_LIGHT (splice/contract.glsl).

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(ambient/sees.glsl)
uniform mat4 ambientToLocal; // the tree's space, from eye space
uniform float ambientStrength;

//RELIEVO::Section(Impl)
  {
    float sees = relievoAmbientSees(relievoTreeNodes, (ambientToLocal * vertexVC).xyz,
      normalize(mat3(ambientToLocal) * normalVCVSOutput),
      relievoTreeBlur.x + relievoTreeBlur.y * length(vertexVC.xyz), ivec2(gl_FragCoord.xy));
    gl_FragData[0].rgb =
      relievoSrgbColorFromLinear(relievoLinearColorFromSrgb(gl_FragData[0].rgb) *
        (1.0 - ambientStrength * (1.0 - sees) * (1.0 - AMBIENT_SPARED)));
  }
