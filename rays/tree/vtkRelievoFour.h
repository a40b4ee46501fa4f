// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// SIMD vector of four floats.
#ifndef vtkRelievoFour_h
#define vtkRelievoFour_h

#if defined(__SSE2__)
#include <emmintrin.h>
#else
#include <algorithm>
#endif

#if defined(__SSE2__)
struct vtkRelievoFour
{
  __m128 X;

  vtkRelievoFour(__m128 x)
    : X(x)
  {
  }
  explicit vtkRelievoFour(float x)
    : X(_mm_set1_ps(x))
  {
  }
  static vtkRelievoFour Load(const float* from) { return _mm_load_ps(from); } // aligned to 16 bytes
  void Store(float* to) const { _mm_storeu_ps(to, this->X); }
};

inline vtkRelievoFour operator-(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_sub_ps(a.X, b.X);
}
inline vtkRelievoFour operator*(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_mul_ps(a.X, b.X);
}
inline vtkRelievoFour vtkRelievoMin(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_min_ps(a.X, b.X);
}
inline vtkRelievoFour vtkRelievoMax(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_max_ps(a.X, b.X);
}
inline vtkRelievoFour operator<=(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_cmple_ps(a.X, b.X);
}
inline vtkRelievoFour operator&(vtkRelievoFour a, vtkRelievoFour b)
{
  return _mm_and_ps(a.X, b.X);
}
// One bit for each of the four comparisons.
inline unsigned vtkRelievoGetBits(vtkRelievoFour comparisons)
{
  return static_cast<unsigned>(_mm_movemask_ps(comparisons.X));
}
#else
struct vtkRelievoFour
{
  float X[4];

  vtkRelievoFour() = default;
  explicit vtkRelievoFour(float x)
    : X{ x, x, x, x }
  {
  }
  template <typename Do>
  static vtkRelievoFour Each(Do each)
  {
    vtkRelievoFour result;
    for (int i = 0; i < 4; ++i)
    {
      result.X[i] = each(i);
    }
    return result;
  }
  static vtkRelievoFour Load(const float* from)
  {
    return Each([from](int i) { return from[i]; });
  }
  void Store(float* to) const { std::copy_n(this->X, 4, to); }
};

inline vtkRelievoFour operator-(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return vtkRelievoFour::Each([&](int i) { return a.X[i] - b.X[i]; });
}
inline vtkRelievoFour operator*(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return vtkRelievoFour::Each([&](int i) { return a.X[i] * b.X[i]; });
}
inline vtkRelievoFour vtkRelievoMin(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return vtkRelievoFour::Each([&](int i) { return a.X[i] < b.X[i] ? a.X[i] : b.X[i]; });
}
inline vtkRelievoFour vtkRelievoMax(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return vtkRelievoFour::Each([&](int i) { return a.X[i] > b.X[i] ? a.X[i] : b.X[i]; });
}
inline vtkRelievoFour operator<=(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return vtkRelievoFour::Each([&](int i) { return a.X[i] <= b.X[i] ? 1.f : 0.f; });
}
inline vtkRelievoFour operator&(const vtkRelievoFour& a, const vtkRelievoFour& b)
{
  return a * b;
}
// One bit for each of the four comparisons.
inline unsigned vtkRelievoGetBits(const vtkRelievoFour& comparisons)
{
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i)
  {
    bits |= comparisons.X[i] != 0.f ? 1u << i : 0u;
  }
  return bits;
}
#endif

// Index of the lowest set bit; there must be one.
inline int vtkRelievoGetLowest(unsigned bits)
{
#if defined(__GNUC__)
  return __builtin_ctz(bits);
#else
  int lowest = 0;
  for (; (bits & 1u) == 0; bits >>= 1)
  {
    ++lowest;
  }
  return lowest;
#endif
}

#endif
