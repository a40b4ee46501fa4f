// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tests of a ray with eight boxes, or with four triangles in double, at once, by instructions of
// AVX2, for processors that have it. Results equal those of the portable code bit for bit: each
// lane computes the same operations in the same order, and AVX2 has no fused products.
#ifndef vtkRelievoAvx2_h
#define vtkRelievoAvx2_h

#include "vtkRelievoRay.h"

#include <cstdint>

#if defined(__GNUC__) && defined(__x86_64__)
#include <immintrin.h>

#define RELIEVO_AVX2 __attribute__((target("avx2")))
#define RELIEVO_INLINED inline __attribute__((always_inline))

struct vtkRelievoAvx2
{
  static bool IsSupported() { return __builtin_cpu_supports("avx2") != 0; }

  // Bits of the boxes that the ray hits up to `last`, and its distances to them. `sides`: least x,
  // y, z, and greatest, of the boxes; `near`: which of the six the ray reaches first on each axis.
  RELIEVO_AVX2 static unsigned HitBoxes(const float (*sides)[8], const int near[3],
    const float from[3], const float inverse[3], float last, float rounding, float t[8])
  {
    __m256 low = _mm256_setzero_ps();
    __m256 high = _mm256_set1_ps(last);
    for (int i = 0; i < 3; ++i)
    {
      const __m256 start = _mm256_set1_ps(from[i]);
      const __m256 scale = _mm256_set1_ps(inverse[i]);
      const float* first = sides[near[i]];
      const float* second = sides[2 * i + 3 - near[i]];
      low = _mm256_max_ps(_mm256_mul_ps(_mm256_sub_ps(_mm256_loadu_ps(first), start), scale), low);
      high =
        _mm256_min_ps(_mm256_mul_ps(_mm256_sub_ps(_mm256_loadu_ps(second), start), scale), high);
    }
    _mm256_storeu_ps(t, low);
    return static_cast<unsigned>(_mm256_movemask_ps(
      _mm256_cmp_ps(low, _mm256_mul_ps(high, _mm256_set1_ps(rounding)), _CMP_LE_OQ)));
  }

  // vtkRelievoRay::Hits for four triangles, each with three indices in `places`: bits of those
  // that the ray hits, and where.
  RELIEVO_AVX2 static unsigned HitTriangles(const vtkRelievoRay& ray, const glm::dvec3* places,
    const std::uint32_t corners[12], double t[4])
  {
    const int axes[3] = { ray.X, ray.Y, ray.Z };
    __m256d p[3][3]; // by corner and axis, as by vtkRelievoRay::Place
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3& a = places[corners[k]];
      const glm::dvec3& b = places[corners[k + 3]];
      const glm::dvec3& c = places[corners[k + 6]];
      const glm::dvec3& d = places[corners[k + 9]];
      for (int i = 0; i < 3; ++i)
      {
        const int axis = axes[i];
        p[k][i] = _mm256_sub_pd(
          _mm256_set_pd(d[axis], c[axis], b[axis], a[axis]), _mm256_set1_pd(ray.From[axis]));
      }
      for (int i = 0; i < 2; ++i)
      {
        p[k][i] = _mm256_sub_pd(p[k][i], _mm256_mul_pd(_mm256_set1_pd(ray.Shear[i]), p[k][2]));
      }
    }
    const __m256d zero = _mm256_setzero_pd();
    __m256d below = zero;
    __m256d above = zero;
    __m256d sides[3];
    for (int k = 0; k < 3; ++k)
    {
      const __m256d* from = p[(k + 1) % 3];
      const __m256d* to = p[(k + 2) % 3];
      sides[k] = _mm256_sub_pd(_mm256_mul_pd(to[0], from[1]), _mm256_mul_pd(from[0], to[1]));
      below = _mm256_or_pd(below, _mm256_cmp_pd(sides[k], zero, _CMP_LT_OQ));
      above = _mm256_or_pd(above, _mm256_cmp_pd(sides[k], zero, _CMP_GT_OQ));
    }
    const __m256d sum = _mm256_add_pd(_mm256_add_pd(sides[0], sides[1]), sides[2]);
    const __m256d isEdgeOn = _mm256_cmp_pd(sum, zero, _CMP_EQ_OQ);
    const auto bits = static_cast<unsigned>(
      _mm256_movemask_pd(_mm256_andnot_pd(isEdgeOn, _mm256_xor_pd(below, above))));
    if (bits != 0)
    {
      __m256d depth = _mm256_mul_pd(sides[0], p[0][2]);
      depth = _mm256_add_pd(depth, _mm256_mul_pd(sides[1], p[1][2]));
      depth = _mm256_add_pd(depth, _mm256_mul_pd(sides[2], p[2][2]));
      _mm256_storeu_pd(t, _mm256_div_pd(_mm256_mul_pd(depth, _mm256_set1_pd(ray.Shear.z)), sum));
    }
    return bits;
  }
};
#else
#define RELIEVO_AVX2
#define RELIEVO_INLINED inline

// Never called.
struct vtkRelievoAvx2
{
  static bool IsSupported() { return false; }
  static unsigned HitBoxes(
    const float (*)[8], const int*, const float*, const float*, float, float, float*)
  {
    return 0;
  }
  static unsigned HitTriangles(
    const vtkRelievoRay&, const glm::dvec3*, const std::uint32_t*, double*)
  {
    return 0;
  }
};
#endif

#endif
