// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The index of a fragment's glyph in an instanced draw call.

//RELIEVO::Section(VertexDec)
flat out int relievoInstanceVSOutput;

//RELIEVO::Section(VertexImpl)
  relievoInstanceVSOutput = gl_InstanceID;

//RELIEVO::Section(GeometryDec)
flat in int relievoInstanceVSOutput[];
flat out int relievoInstanceGSOutput;

//RELIEVO::Section(GeometryImpl)
  relievoInstanceGSOutput = relievoInstanceVSOutput[i];

//RELIEVO::Section(FragmentDec)
flat in int relievoInstanceVSOutput;
