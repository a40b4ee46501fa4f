// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// No include guard: vtkRelievoFormulas.h includes this list once for each number type. A file comes
// after the files that it names in `//RELIEVO::Include(...)`, which is a comment in C++.
#include "formulas/formats/numbers.glsl"

#include "formulas/formats/octahedral.glsl"

#include "formulas/formats/normal_formats.glsl"

#include "formulas/formats/depth.glsl"

#include "formulas/formats/normal_depth.glsl"

#include "formulas/geometry/unproject.glsl"

#include "formulas/color/srgb.glsl"

#include "formulas/color/tone.glsl"

#include "formulas/color/blend.glsl"

#include "formulas/color/hash_color.glsl"

#include "formulas/color/colormap.glsl"

#include "formulas/light/shadow.glsl"

#include "formulas/geometry/ray.glsl"

#include "formulas/light/sky.glsl"

#include "formulas/light/environment.glsl"

#include "formulas/light/irradiance.glsl"

#include "formulas/light/fresnel.glsl"

#include "formulas/light/prefilter.glsl"

#include "formulas/geometry/tangent_frame.glsl"

#include "formulas/formats/half.glsl"

#include "formulas/light/lamp.glsl"

#include "formulas/formats/surface.glsl"

#include "formulas/light/shading.glsl"

#include "formulas/light/fog.glsl"

#include "formulas/geometry/marker.glsl"

#include "formulas/geometry/noise.glsl"

#include "formulas/geometry/cube.glsl"

#include "formulas/geometry/skin.glsl"

#include "formulas/light/sky_grid.glsl"
