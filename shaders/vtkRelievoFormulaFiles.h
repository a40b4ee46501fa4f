// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// No include guard: vtkRelievoFormulas.h includes this list once for each number type. A file comes
// after the files that it names in `//RELIEVO::Include(...)`, which is a comment in C++.
#include "formulas/numbers.glsl"

#include "formulas/octahedral.glsl"

#include "formulas/normal_formats.glsl"

#include "formulas/depth.glsl"

#include "formulas/normal_depth.glsl"

#include "formulas/unproject.glsl"

#include "formulas/srgb.glsl"

#include "formulas/tone.glsl"

#include "formulas/blend.glsl"

#include "formulas/hash_color.glsl"

#include "formulas/colormap.glsl"

#include "formulas/shadow.glsl"

#include "formulas/ray.glsl"

#include "formulas/sky.glsl"

#include "formulas/environment.glsl"

#include "formulas/irradiance.glsl"

#include "formulas/fresnel.glsl"

#include "formulas/prefilter.glsl"

#include "formulas/tangent_frame.glsl"

#include "formulas/half.glsl"

#include "formulas/lamp.glsl"

#include "formulas/surface.glsl"

#include "formulas/shading.glsl"

#include "formulas/fog.glsl"

#include "formulas/marker.glsl"

#include "formulas/noise.glsl"

#include "formulas/cube.glsl"

#include "formulas/skin.glsl"
