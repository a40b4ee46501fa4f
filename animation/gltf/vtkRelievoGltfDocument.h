// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A glTF 2 file with the numbers of its accessors. What does not fit is a GltfError.
 */
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
/// Which values a place in the file takes.
struct GltfKind
{
  std::vector<std::string> Types;  ///< SCALAR, VEC3 and so on
  std::vector<int> ComponentTypes; ///< as the file has them
  bool Normalized = false; ///< whether integers stand for 0 to 1 or -1 to 1 whatever it says
};

/// The values of an accessor, sparse ones in place; integers that are normalized as numbers.
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

  /// The values of the accessor that stands at this place. They are kept until Forget().
  const GltfNumbers& GetNumbers(const GltfValue& place, const GltfKind& kind);
  void Forget() { this->Numbers.clear(); }

  /// Whether values that were decoded are what the accessor at this place announces; those that it
  /// calls normalized become so.
  void CheckDecoded(const GltfValue& place, GltfNumbers& numbers) const;
  /// Whether the accessor at this place is of the kind; whether its integers are normalized.
  bool Check(const GltfValue& place, const GltfKind& kind) const;

  /// How many values the accessor has that stands at this place.
  std::size_t GetCount(const GltfValue& place) const;

private:
  struct Layout;

  GltfValue GetAccessor(const GltfValue& place) const;
  Layout GetLayout(const GltfValue& accessor) const;
  void ReadDense(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  void ReadSparse(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  // The bytes from which `count` values, of so many bytes each, are to be read, and their distance.
  const unsigned char* Find(const GltfValue& owner, const std::string& what, std::size_t count,
    std::size_t bytes, std::size_t alignment, std::size_t& stride);

  std::map<std::pair<std::string, bool>, GltfNumbers> Numbers; // by place, and normalized
};
}

#endif
