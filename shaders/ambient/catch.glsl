// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders of what catches shadows: what it is darkened by where it sees
// less of the sky. Other splices into the same shader walk trees of their own: C++ puts `ambient`
// in the place of `relievo` in all names of this one.
//
// Names of VTK's shaders that are read: vertexVC, normalVCVSOutput, gl_FragData[0].

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(ambient/sees.glsl)
uniform mat4 ambientToLocal; // the tree's space, from eye space
uniform float ambientStrength;

//RELIEVO::Section(Impl)
  {
    float sees = relievoAmbientSees(relievoTreeNodes, (ambientToLocal * vertexVC).xyz,
      normalize(mat3(ambientToLocal) * normalVCVSOutput),
      relievoTreeBlur.x + relievoTreeBlur.y * length(vertexVC.xyz), ivec2(gl_FragCoord.xy));
    gl_FragData[0].rgb = relievoSrgbColorFromLinear(
      relievoLinearColorFromSrgb(gl_FragData[0].rgb) * (1.0 - ambientStrength * (1.0 - sees)));
  }
