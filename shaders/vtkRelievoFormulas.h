// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoFormulas.h
 * @brief The formulas of shaders/formulas/ as C++, through GLM: the same lines that the GPU runs.
 *
 * relievo::f32 computes in float, like the shaders; relievo::f64 computes in double: there `float`,
 * vec2, mat4 ... mean double, dvec2, dmat4 ... Words (`uint`, uvec2 ...) have 32 bits in both, and
 * a number stored as float or half is rounded to it in both. Everything has internal linkage.
 */
#ifndef vtkRelievoFormulas_h
#define vtkRelievoFormulas_h

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <cstring>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif

namespace relievo
{
/// GLSL built-in functions on bits that C++ lacks.
namespace bits
{
inline std::uint32_t FromFloat(float value)
{
  std::uint32_t word;
  std::memcpy(&word, &value, sizeof(word));
  return word;
}

inline float ToFloat(std::uint32_t word)
{
  float value;
  std::memcpy(&value, &word, sizeof(value));
  return value;
}

/// Half nearest to a float, ties to even, which is the rounding of OpenGL drivers; GLM's
/// packHalf2x16 rounds ties up.
inline std::uint32_t ToHalf(float value)
{
  const std::uint32_t word = FromFloat(value);
  const std::uint32_t sign = (word >> 16) & 0x8000u;
  const std::uint32_t size = word & 0x7fffffffu;
  if (size > 0x7f800000u)
  {
    return sign | 0x7e00u; // NaN
  }
  if (size >= 0x477ff000u)
  {
    return sign | 0x7c00u; // 65520 and above round to infinity
  }
  if (size < 0x38800000u)
  {
    // Below 2^-14 halves are multiples of 2^-24, which is the step of floats in [0.5, 1).
    return sign | (FromFloat(ToFloat(size) + 0.5f) - 0x3f000000u);
  }
  const std::uint32_t odd = (size >> 13) & 1u;
  return sign | ((size - 0x38000000u + 0xfffu + odd) >> 13);
}

inline float FromHalf(std::uint32_t half)
{
  const std::uint32_t sign = (half & 0x8000u) << 16;
  const std::uint32_t size = half & 0x7fffu;
  if (size >= 0x7c00u)
  {
    return ToFloat(sign | 0x7f800000u | ((size & 0x3ffu) << 13));
  }
  if (size < 0x400u)
  {
    const float small = static_cast<float>(size) * (1.0f / 16777216.0f);
    return sign ? -small : small;
  }
  return ToFloat(sign | ((size << 13) + 0x38000000u));
}
}

#define RELIEVO_FORMULA_BUILTINS                                                                   \
  using glm::abs;                                                                                  \
  using glm::atan;                                                                                 \
  using glm::clamp;                                                                                \
  using glm::cos;                                                                                  \
  using glm::cross;                                                                                \
  using glm::dot;                                                                                  \
  using glm::exp;                                                                                  \
  using glm::exp2;                                                                                 \
  using glm::floor;                                                                                \
  using glm::isinf;                                                                                \
  using glm::isnan;                                                                                \
  using glm::length;                                                                               \
  using glm::log;                                                                                  \
  using glm::log2;                                                                                 \
  using glm::max;                                                                                  \
  using glm::min;                                                                                  \
  using glm::mix;                                                                                  \
  using glm::normalize;                                                                            \
  using glm::pow;                                                                                  \
  using glm::sin;                                                                                  \
  using glm::sqrt;                                                                                 \
  using uint = std::uint32_t;                                                                      \
  using uvec2 = glm::uvec2;                                                                        \
  using uvec3 = glm::uvec3;                                                                        \
  using uvec4 = glm::uvec4;                                                                        \
  using ivec2 = glm::ivec2;                                                                        \
  using ivec3 = glm::ivec3;                                                                        \
  using ivec4 = glm::ivec4;

/// The formulas in float.
namespace f32
{
RELIEVO_FORMULA_BUILTINS
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using mat3 = glm::mat3;
using mat4 = glm::mat4;

namespace
{
inline uint floatBitsToUint(float value)
{
  return bits::FromFloat(value);
}
inline float uintBitsToFloat(uint word)
{
  return bits::ToFloat(word);
}
// An object, because a call of a function of this name could also mean GLM's, which rounds
// otherwise.
constexpr auto packHalf2x16 = [](const vec2& v) {
  return bits::ToHalf(v.x) | (bits::ToHalf(v.y) << 16);
};
inline vec2 unpackHalf2x16(uint word)
{
  return vec2(bits::FromHalf(word & 0xffffu), bits::FromHalf(word >> 16));
}
#include "vtkRelievoFormulaFiles.h"
}
}

/// The formulas in double.
namespace f64
{
RELIEVO_FORMULA_BUILTINS
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;

namespace
{
inline uint floatBitsToUint(double value)
{
  return bits::FromFloat(static_cast<float>(value));
}
inline double uintBitsToFloat(uint word)
{
  return bits::ToFloat(word);
}
constexpr auto packHalf2x16 = [](const vec2& v) {
  return bits::ToHalf(static_cast<float>(v.x)) | (bits::ToHalf(static_cast<float>(v.y)) << 16);
};
inline vec2 unpackHalf2x16(uint word)
{
  return vec2(bits::FromHalf(word & 0xffffu), bits::FromHalf(word >> 16));
}
#define float double
#include "vtkRelievoFormulaFiles.h"
#undef float
}
}
#undef RELIEVO_FORMULA_BUILTINS
}

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
