//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes every primitive on unchanged, with its number.
#extension GL_ARB_arrays_of_arrays : enable
layout(RELIEVO_PRIMITIVE_IN) in;
layout(RELIEVO_PRIMITIVE_OUT, max_vertices = RELIEVO_CORNERS) out;
//RELIEVO::Varyings::Dec

void main()
{
  for (int i = 0; i < RELIEVO_CORNERS; ++i)
  {
    gl_PrimitiveID = gl_PrimitiveIDIn;
    gl_Position = gl_in[i].gl_Position;
    //RELIEVO::Varyings::Impl
    EmitVertex();
  }
  EndPrimitive();
}
