// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// SIMD vector of eight integers of 16 bits.
#ifndef vtkRelievoEight_h
#define vtkRelievoEight_h

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#else
#include <algorithm>
#include <cstring>
#endif

#if defined(__SSE2__)
struct vtkRelievoEight
{
  __m128i X;

  static vtkRelievoEight Of(int value)
  {
    return { _mm_set1_epi16(static_cast<std::int16_t>(value)) };
  }
  // From and to memory aligned to 16 bytes.
  static vtkRelievoEight Load(const void* from)
  {
    return { _mm_load_si128(static_cast<const __m128i*>(from)) };
  }
  void Store(std::int16_t* to) const { _mm_store_si128(reinterpret_cast<__m128i*>(to), this->X); }
  // The numbers from the fourth one on, and zeros.
  vtkRelievoEight FromFourth() const { return { _mm_srli_si128(this->X, 6) }; }
};

inline vtkRelievoEight operator-(vtkRelievoEight a, vtkRelievoEight b)
{
  return { _mm_sub_epi16(a.X, b.X) };
}
inline vtkRelievoEight vtkRelievoMin(vtkRelievoEight a, vtkRelievoEight b)
{
  return { _mm_min_epi16(a.X, b.X) };
}
inline vtkRelievoEight vtkRelievoMax(vtkRelievoEight a, vtkRelievoEight b)
{
  return { _mm_max_epi16(a.X, b.X) };
}
// The lower halves of products.
inline vtkRelievoEight vtkRelievoMultiplyLow(vtkRelievoEight a, vtkRelievoEight b)
{
  return { _mm_mullo_epi16(a.X, b.X) };
}
// The upper halves of products, without signs.
inline vtkRelievoEight vtkRelievoMultiplyHigh(vtkRelievoEight a, vtkRelievoEight b)
{
  return { _mm_mulhi_epu16(a.X, b.X) };
}
#else
struct vtkRelievoEight
{
  std::int16_t X[8];

  template <typename Function>
  static vtkRelievoEight Make(Function f)
  {
    vtkRelievoEight made;
    for (int i = 0; i < 8; ++i)
    {
      made.X[i] = static_cast<std::int16_t>(f(i));
    }
    return made;
  }
  static vtkRelievoEight Of(int value)
  {
    return Make([&](int) { return value; });
  }
  static vtkRelievoEight Load(const void* from)
  {
    vtkRelievoEight made;
    std::memcpy(made.X, from, sizeof(made.X));
    return made;
  }
  void Store(std::int16_t* to) const { std::copy_n(this->X, 8, to); }
  vtkRelievoEight FromFourth() const
  {
    return Make([&](int i) { return i < 5 ? this->X[i + 3] : 0; });
  }
};

inline vtkRelievoEight operator-(const vtkRelievoEight& a, const vtkRelievoEight& b)
{
  return vtkRelievoEight::Make([&](int i) { return a.X[i] - b.X[i]; });
}
inline vtkRelievoEight vtkRelievoMin(const vtkRelievoEight& a, const vtkRelievoEight& b)
{
  return vtkRelievoEight::Make([&](int i) { return std::min(a.X[i], b.X[i]); });
}
inline vtkRelievoEight vtkRelievoMax(const vtkRelievoEight& a, const vtkRelievoEight& b)
{
  return vtkRelievoEight::Make([&](int i) { return std::max(a.X[i], b.X[i]); });
}
inline vtkRelievoEight vtkRelievoMultiplyLow(const vtkRelievoEight& a, const vtkRelievoEight& b)
{
  return vtkRelievoEight::Make([&](int i) { return a.X[i] * b.X[i]; });
}
inline vtkRelievoEight vtkRelievoMultiplyHigh(const vtkRelievoEight& a, const vtkRelievoEight& b)
{
  return vtkRelievoEight::Make([&](int i) {
    return (static_cast<std::uint32_t>(static_cast<std::uint16_t>(a.X[i])) *
             static_cast<std::uint16_t>(b.X[i])) >>
      16;
  });
}
#endif

#endif
