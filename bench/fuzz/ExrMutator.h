// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExrMutator.h
 * @brief Damages EXR files in relevant ways; equal numbers give equal damage.
 */
#ifndef ExrMutator_h
#define ExrMutator_h

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace exrFuzz
{
class Mutator
{
public:
  /** `seeds`: intact files, at least one, none empty. */
  explicit Mutator(std::vector<std::string> seeds);

  /**
   * File number `index`: a seed with one to four kinds of damage: bits and bytes changed, the file
   * cut or lengthened, sections removed, repeated or taken from another seed, attributes of the
   * header with other sizes, types or values, other flags, and wrong offsets.
   */
  std::string Make(uint64_t index) const;

private:
  using Random = std::mt19937_64;

  void Damage(std::string& bytes, std::size_t from, Random& random) const;
  void DamageHeader(std::string& bytes, Random& random) const;

  std::vector<std::string> Seeds;
};
}

#endif
