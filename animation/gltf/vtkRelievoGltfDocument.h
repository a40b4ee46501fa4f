// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A glTF 2 file: its JSON, and the bytes of its buffers, images and accessors. Whatever does not
 * fit is a GltfError.
 */
#ifndef vtkRelievoGltfDocument_h
#define vtkRelievoGltfDocument_h

#include "vtkRelievoGltfValue.h"
#include "vtkRelievoModelSources.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace relievo
{
/// Bytes in a buffer that the document holds.
struct GltfBytes
{
  const unsigned char* Data = nullptr;
  std::size_t Size = 0;
};

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

/// Most points and most corners of all meshes of a scene, each counted at each node that shows it;
/// most numbers of all keys of all animations; most values of an accessor that has no bytes, and is
/// all zeros but for its sparse ones: small files must not take all memory.
constexpr std::size_t MostPoints = std::size_t(1) << 25;
constexpr std::size_t MostCorners = std::size_t(1) << 27;
constexpr std::size_t MostKeyNumbers = std::size_t(1) << 26;
constexpr std::size_t MostZeros = std::size_t(1) << 22;
/// Most bytes of a file together with all those that it names.
constexpr std::uintmax_t MostBytes = std::uintmax_t(1) << 32;
/// Nodes below nodes, and values within values of the JSON.
constexpr int DeepestNodes = 2000;
constexpr int DeepestValues = 500;
}

class GltfDocument
{
public:
  /// Reads the file, and adds it to the sources as it does each file that is named by it.
  GltfDocument(const std::string& path, ModelSources& sources);

  GltfValue Get(const char* key) const;
  /// The extensions that the file uses and that are not read.
  std::vector<std::string> GetUnread() const;

  /// The bytes of a buffer view.
  GltfBytes GetView(std::size_t view);

  /// The bytes of an image, and its name: what the file names, or its place in the file.
  GltfBytes GetImage(std::size_t image, std::string& name);

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

  void Open();
  void Parse(const unsigned char* text, std::size_t size);
  void CheckExtensions() const;
  GltfBytes GetBuffer(std::size_t buffer);
  std::vector<unsigned char> ReadUri(const GltfValue& owner, const std::string& uri);
  GltfValue GetAccessor(const GltfValue& place) const;
  Layout GetLayout(const GltfValue& accessor) const;
  void ReadDense(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  void ReadSparse(const GltfValue& accessor, const Layout& layout, GltfNumbers& numbers);
  // The bytes from which `count` values, of so many bytes each, are to be read, and their distance.
  const unsigned char* Find(const GltfValue& owner, const std::string& what, std::size_t count,
    std::size_t bytes, std::size_t alignment, std::size_t& stride);

  std::string Path;
  ModelSources& Sources;
  nlohmann::json Json;
  std::vector<unsigned char> Chunk; // of a .glb
  std::uintmax_t Read = 0;          // bytes
  std::map<std::size_t, std::vector<unsigned char>> Buffers;
  std::map<std::size_t, std::vector<unsigned char>> Images;
  std::map<std::pair<std::string, bool>, GltfNumbers> Numbers; // by place, and normalized
};

/// Whether these are base64 and nothing else; then their bytes.
bool DecodeBase64(const char* text, std::size_t size, std::vector<unsigned char>& bytes);
}

#endif
