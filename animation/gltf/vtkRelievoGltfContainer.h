// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A glTF 2 file as a container: its JSON, and the bytes of its buffers and images, inside the file
 * or beside it. Problems are thrown as GltfError.
 */
#ifndef vtkRelievoGltfContainer_h
#define vtkRelievoGltfContainer_h

#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoGltfValue.h"
#include "vtkRelievoModelSources.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace relievo
{
/// Bytes in a buffer owned by the container.
struct GltfBytes
{
  const unsigned char* Data = nullptr;
  std::size_t Size = 0;
};

/// An unsigned little-endian integer of so many bytes.
std::size_t ReadLittle(const unsigned char* at, int bytes);

namespace gltf
{
/// Limits against small files that would use up memory: points and corners of all meshes of a
/// scene, each counted at every node that shows it; numbers of all keys of all animations; and
/// values of an accessor without bytes, which is all zeros except for its sparse values.
constexpr std::size_t MostPoints = std::size_t(1) << 25;
constexpr std::size_t MostCorners = std::size_t(1) << 27;
constexpr std::size_t MostKeyNumbers = std::size_t(1) << 26;
constexpr std::size_t MostZeros = std::size_t(1) << 22;
/// Most bytes of a file together with all files that it names, and of the images that are kept.
constexpr std::uintmax_t MostBytes = std::uintmax_t(1) << 32;
constexpr std::size_t MostImageBytes = std::size_t(1) << 30;
/// Deepest nesting of nodes, and of values in the JSON.
constexpr int DeepestNodes = 2000;
constexpr int DeepestValues = 500;
}

class GltfContainer
{
public:
  /// Reads the file, and adds it and each file named in it to the sources.
  GltfContainer(
    const std::string& path, const vtkRelievoAllowedFolders& allowed, ModelSources& sources);

  GltfValue Get(const char* key) const;
  /// The extensions that the file uses but that are not supported.
  std::vector<std::string> GetUnread() const;

  /// The bytes of a buffer view.
  GltfBytes GetView(std::size_t view);

  /// Why the file of an image may not be read; "" if it may, or if the image has no file.
  std::string FindObstacle(std::size_t image) const;

  /// The bytes of an image, and its name: that in the file, or its index.
  GltfBytes GetImage(std::size_t image, std::string& name);

private:
  void Open();
  void Parse(const unsigned char* text, std::size_t size);
  void CheckExtensions() const;
  GltfBytes GetBuffer(std::size_t buffer);
  std::string FindNamed(const std::string& uri) const; // the path of a file
  std::vector<unsigned char> ReadUri(const GltfValue& owner, const std::string& uri);

  std::string Path;
  const vtkRelievoAllowedFolders& Allowed;
  ModelSources& Sources;
  nlohmann::json Json;
  std::vector<unsigned char> Chunk; // the binary chunk of a .glb
  std::uintmax_t Read = 0;          // total bytes read
  std::map<std::size_t, std::vector<unsigned char>> Buffers;
  std::map<std::size_t, std::vector<unsigned char>> Images;
};
}

#endif
