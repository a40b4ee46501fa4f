// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A value in the JSON of a glTF file that knows its place, for messages such as:
 * `materials[2].alphaMode is "FADE", expected OPAQUE, MASK or BLEND`.
 */
#ifndef vtkRelievoGltfValue_h
#define vtkRelievoGltfValue_h

#include <nlohmann/json.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace relievo
{
/// The problem of a file, with its place.
class GltfError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class GltfValue
{
public:
  /// `value`: null if missing.
  GltfValue(const nlohmann::json* value, std::string place)
    : Value(value)
    , Place(std::move(place))
  {
  }

  bool IsThere() const { return this->Value != nullptr; }
  const std::string& GetPlace() const { return this->Place; }

  /// A member of an object; a missing member has missing members itself.
  GltfValue Get(const char* key) const;
  /// The names of an object's members.
  std::vector<std::string> GetKeys() const;
  /// The size of a list; 0 if missing.
  std::size_t GetSize() const;
  GltfValue At(std::size_t i) const;

  ///@{
  /// The value, or `otherwise` if it is not there. Anything else is an error, as is a
  /// number outside of the range.
  bool GetFlag(bool otherwise) const;
  double GetNumber(double otherwise) const;
  double GetNumber(double otherwise, double least, double most) const;
  std::size_t GetCount(std::size_t otherwise, std::size_t least = 0) const;
  std::string GetText(const std::string& otherwise) const;
  ///@}

  /// The index of the value among these words; 0 if the value is missing.
  std::size_t GetWord(const std::vector<std::string>& words) const;

  /// As many finite numbers as `otherwise` has; `otherwise` if missing.
  std::vector<double> GetNumbers(const std::vector<double>& otherwise) const;

  /// An index into the list `of`, which has `size` entries; -1 if missing.
  int GetIndex(const char* of, std::size_t size) const;

  /// Throws this place, its value, and the expectation.
  [[noreturn]] void FailExpecting(const std::string& expected) const;
  /// Throws this place and `what`.
  [[noreturn]] void Fail(const std::string& what) const;

private:
  const nlohmann::json* Value;
  std::string Place;
};
}

#endif
