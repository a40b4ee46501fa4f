// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NormalPeers.h
 * @brief Two well-known normal encodings that Relievo does not offer, for comparison.
 */
#ifndef relievoBenchNormalPeers_h
#define relievoBenchNormalPeers_h

#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relievoBench
{
/** Packs two values in [0, 1] into a word of 2 x `Bits` bits, and unpacks them. */
template <int Bits>
std::uint32_t JoinUnit(glm::vec2 v)
{
  constexpr float maxCode = static_cast<float>((1u << Bits) - 1u);
  return relievo::f32::relievoQuantizeUnorm(v.x, maxCode) |
    (relievo::f32::relievoQuantizeUnorm(v.y, maxCode) << Bits);
}

template <int Bits>
glm::vec2 SplitUnit(std::uint32_t word)
{
  constexpr std::uint32_t mask = (1u << Bits) - 1u;
  return glm::vec2(word & mask, (word >> Bits) & mask) / static_cast<float>(mask);
}

/** Spherical angles: azimuth and polar angle, quantised uniformly. */
template <int Bits>
struct Spherical
{
  static constexpr float Pi = 3.14159265358979f;

  static std::uint32_t Encode(const glm::vec3& n)
  {
    return JoinUnit<Bits>(glm::vec2(
      std::atan2(n.y, n.x) / (2.f * Pi) + 0.5f, std::acos(std::clamp(n.z, -1.f, 1.f)) / Pi));
  }

  static glm::vec3 Decode(std::uint32_t word)
  {
    const glm::vec2 v = SplitUnit<Bits>(word);
    const float azimuth = (v.x - 0.5f) * 2.f * Pi;
    const float polar = v.y * Pi;
    return glm::vec3(
      std::cos(azimuth) * std::sin(polar), std::sin(azimuth) * std::sin(polar), std::cos(polar));
  }
};

/** Lambert's azimuthal equal-area map, the "spheremap" of game engines; -z is its entire rim. */
template <int Bits>
struct Azimuthal
{
  static std::uint32_t Encode(const glm::vec3& n)
  {
    const float rim = std::hypot(n.x, n.y);
    const float radius = std::sqrt(std::max(0.f, 0.5f - 0.5f * n.z)); // 1 at -z
    const glm::vec2 outward = rim > 0.f ? glm::vec2(n.x, n.y) / rim : glm::vec2(1.f, 0.f);
    return JoinUnit<Bits>(0.5f * radius * outward + 0.5f);
  }

  static glm::vec3 Decode(std::uint32_t word)
  {
    const glm::vec2 v = 2.f * SplitUnit<Bits>(word) - 1.f;
    const float square = std::min(1.f, v.x * v.x + v.y * v.y);
    const float size = 2.f * std::sqrt(1.f - square);
    return glm::vec3(v.x * size, v.y * size, 1.f - 2.f * square);
  }
};
}

#endif
