// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A varying in passthroughGS.glsl, as the vertex shader declares it; the words in capitals are
// filled by vtkRelievoPrimitiveIds.

//RELIEVO::Section(Dec)
RELIEVO_QUALIFIERS in RELIEVO_TYPE RELIEVO_INPUT[]RELIEVO_ARRAY;
RELIEVO_QUALIFIERS out RELIEVO_TYPE RELIEVO_OUTPUTRELIEVO_ARRAY;

//RELIEVO::Section(Impl)
    RELIEVO_OUTPUT = RELIEVO_INPUT[i];

//RELIEVO::Section(PointSize)
    gl_PointSize = gl_in[i].gl_PointSize;
