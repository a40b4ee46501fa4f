// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The JSON and the binary part of a glTF 2 file in one container (.glb), as they are built.
 */
#ifndef GltfBuffer_h
#define GltfBuffer_h

#include "SceneNames.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scene
{
class GltfBuffer
{
public:
  using Json = nlohmann::ordered_json;

  /// The document without its buffer; lists are absent while they are empty, as glTF demands.
  Json Document;

  /// Appends an object to one of the document's lists, such as "meshes". Returns its index.
  std::size_t Append(const std::string& list, Json&& object);

  /// Names an extension that the file uses, once.
  void Use(const std::string& extension);

  ///@{
  /// Adds an accessor of floats (SCALAR, VEC2, VEC3, VEC4), of indices, or of colours of 16 bits
  /// with red, green, blue and alpha. Positions and times need their bounds in the file.
  std::size_t AddFloats(const std::vector<float>& values, std::size_t components, bool isVertex,
    bool withBounds = false);
  std::size_t AddIndices(const std::vector<std::uint32_t>& values, std::size_t points);
  std::size_t AddColors(const std::vector<std::uint16_t>& values);
  ///@}

  /// Adds bytes that no accessor describes: an image file. Returns the view's index.
  std::size_t AddBytes(const unsigned char* bytes, std::size_t count);

  /// The whole file, or nothing if it exceeds the 4 GiB of a container.
  std::vector<unsigned char> GetFile() const;

private:
  std::size_t AddView(const void* bytes, std::size_t count, int target);

  std::vector<unsigned char> Bytes;
};
}

#endif
