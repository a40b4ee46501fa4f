// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinKeys.h
 * @brief Error of a turning bone by the number of its keys.
 */
#ifndef SkinKeys_h
#define SkinKeys_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>

namespace relievoBench
{
/** The quaternion of a rotation about an axis of unit length. */
glm::dvec4 AboutAxis(const glm::dvec3& axis, double angle);

/** Writes skin-keys.csv. */
bool MeasureSkinKeys(const std::string& outDir);
}

#endif
