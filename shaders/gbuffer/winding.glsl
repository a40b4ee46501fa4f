// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// -1 if a glyph's own matrix mirrors it, else 1.

//RELIEVO::Section(VertexDec)
flat out float relievoGlyphWindingVSOutput;

//RELIEVO::Section(VertexImpl)
  relievoGlyphWindingVSOutput = determinant(mat3(GCMCMatrix)) < 0.0 ? -1.0 : 1.0;

//RELIEVO::Section(GeometryDec)
flat in float relievoGlyphWindingVSOutput[];
flat out float relievoGlyphWindingGSOutput;

//RELIEVO::Section(GeometryImpl)
  relievoGlyphWindingGSOutput = relievoGlyphWindingVSOutput[i];

//RELIEVO::Section(FragmentDec)
flat in float relievoGlyphWindingVSOutput;
