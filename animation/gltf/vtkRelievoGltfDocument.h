// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** A glTF 2 file with the numbers of its accessors. Mismatches are thrown as GltfError. */
#ifndef vtkRelievoGltfDocument_h
#define vtkRelievoGltfDocument_h

#include "vtkRelievoGltfContainer.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace relievo
{
/// The kinds of values allowed in a place of the file.
struct GltfKind
{
  std::vector<std::string> Types;  ///< SCALAR, VEC3 and so on
  std::vector<int> ComponentTypes; ///< with glTF's numbers
  bool Normalized = false;         ///< integers always represent 0 to 1 or -1 to 1
};

/// An accessor's values, with sparse ones inserted and normalized integers converted.
struct GltfNumbers
{
  std::size_t Count = 0;
  std::size_t Components = 0;
  std::vector<double> Values;

  const double* At(std::size_t i) const { return this->Values.data() + this->Components * i; }
};

namespace gltf
{
enum ComponentType : int
{
  Byte = 5120,
  UnsignedByte = 5121,
  Short = 5122,
  UnsignedShort = 5123,
  UnsignedInt = 5125,
  Float = 5126
};
}

class GltfDocument : public GltfContainer
{
public:
  using GltfContainer::GltfContainer;

  /// The values of the accessor named at this place, cached until Forget().
  const GltfNumbers& GetNumbers(const GltfValue& place, const GltfKind& kind);
  void Forget() { this->Numbers.clear(); }

  /// Checks that decoded values match the accessor named at this place, and converts those that it
  /// declares normalized.
  void CheckDecoded(const GltfValue& place, GltfNumbers& numbers) const;
  /// Checks the kind of the accessor named at this place; returns whether its integers are
  /// normalized.
  bool Check(const GltfValue& place, const GltfKind& kind) const;

  /// The number of values of the accessor named at this place.
  std::size_t GetCount(const GltfValue& place) const;

private:
  struct Layout;

  GltfValue GetAccessor(const GltfValue& place) const;
  Layout GetLayout(const GltfValue& accessor) const;
  void ReadDense(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  void ReadSparse(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  // The address and stride of `count` values with `bytes` bytes each.
  const unsigned char* Find(const GltfValue& owner, const std::string& what, std::size_t count,
    std::size_t bytes, std::size_t alignment, std::size_t& stride);

  std::map<std::pair<std::string, bool>, GltfNumbers> Numbers; // by place and whether normalized
};
}

#endif
