// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfValue.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relievo
{
namespace
{
// Above this, doubles skip integers.
constexpr double LargestWhole = 9007199254740992.;

std::string Shorten(const nlohmann::json& value)
{
  if (value.is_structured())
  {
    return value.is_array() ? "a list" : "an object";
  }
  constexpr std::size_t longest = 60;
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > longest)
  {
    text = text.substr(0, longest) + "...";
  }
  return text;
}

std::string Write(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}
}

//------------------------------------------------------------------------------
GltfValue GltfValue::Get(const char* key) const
{
  if (this->Value && !this->Value->is_object())
  {
    this->FailExpecting("an object");
  }
  const nlohmann::json* member = nullptr;
  if (this->Value)
  {
    const auto found = this->Value->find(key);
    member = found == this->Value->end() ? nullptr : &*found;
  }
  return GltfValue(member, this->Place.empty() ? key : this->Place + "." + key);
}

//------------------------------------------------------------------------------
std::vector<std::string> GltfValue::GetKeys() const
{
  std::vector<std::string> keys;
  if (this->Value && !this->Value->is_object())
  {
    this->FailExpecting("an object");
  }
  if (this->Value)
  {
    for (const auto& member : this->Value->items())
    {
      keys.push_back(member.key());
    }
  }
  return keys;
}

//------------------------------------------------------------------------------
std::size_t GltfValue::GetSize() const
{
  if (this->Value && !this->Value->is_array())
  {
    this->FailExpecting("a list");
  }
  return this->Value ? this->Value->size() : 0;
}

//------------------------------------------------------------------------------
GltfValue GltfValue::At(std::size_t i) const
{
  return GltfValue(&(*this->Value)[i], this->Place + "[" + std::to_string(i) + "]");
}

//------------------------------------------------------------------------------
bool GltfValue::GetFlag(bool otherwise) const
{
  if (this->Value && !this->Value->is_boolean())
  {
    this->FailExpecting("true or false");
  }
  return this->Value ? this->Value->get<bool>() : otherwise;
}

//------------------------------------------------------------------------------
double GltfValue::GetNumber(double otherwise) const
{
  if (this->Value && !this->Value->is_number())
  {
    this->FailExpecting("a number");
  }
  const double number = this->Value ? this->Value->get<double>() : otherwise;
  if (this->Value && !std::isfinite(number))
  {
    this->FailExpecting("a finite number");
  }
  return number;
}

//------------------------------------------------------------------------------
double GltfValue::GetNumber(double otherwise, double least, double most) const
{
  const double number = this->GetNumber(otherwise);
  if (this->Value && (number < least || number > most))
  {
    this->FailExpecting(std::isinf(most) ? "at least " + Write(least)
                                         : "a number from " + Write(least) + " to " + Write(most));
  }
  return number;
}

//------------------------------------------------------------------------------
std::size_t GltfValue::GetCount(std::size_t otherwise, std::size_t least) const
{
  if (!this->Value)
  {
    return otherwise;
  }
  const double number = this->Value->is_number() ? this->Value->get<double>() : -1.;
  // Also rejects NaN.
  if (!(number >= static_cast<double>(least)) || number > LargestWhole ||
    number != std::floor(number))
  {
    this->FailExpecting("a whole number of at least " + std::to_string(least));
  }
  return static_cast<std::size_t>(number);
}

//------------------------------------------------------------------------------
std::string GltfValue::GetText(const std::string& otherwise) const
{
  if (this->Value && !this->Value->is_string())
  {
    this->FailExpecting("a text");
  }
  return this->Value ? this->Value->get<std::string>() : otherwise;
}

//------------------------------------------------------------------------------
std::size_t GltfValue::GetWord(const std::vector<std::string>& words) const
{
  if (!this->Value)
  {
    return 0;
  }
  const std::string given = this->GetText("");
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end())
  {
    std::string expected;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      expected += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
    }
    this->FailExpecting(expected);
  }
  return static_cast<std::size_t>(found - words.begin());
}

//------------------------------------------------------------------------------
std::vector<double> GltfValue::GetNumbers(const std::vector<double>& otherwise) const
{
  if (!this->Value)
  {
    return otherwise;
  }
  if (this->GetSize() != otherwise.size())
  {
    this->Fail("has " + std::to_string(this->GetSize()) + " numbers, expected " +
      std::to_string(otherwise.size()));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < otherwise.size(); ++i)
  {
    numbers.push_back(this->At(i).GetNumber(0.));
  }
  return numbers;
}

//------------------------------------------------------------------------------
int GltfValue::GetIndex(const char* of, std::size_t size) const
{
  if (!this->Value)
  {
    return -1;
  }
  const std::size_t index = this->GetCount(0);
  if (index >= size)
  {
    this->Fail("names " + std::string(of) + "[" + std::to_string(index) + "], and there are " +
      std::to_string(size) + " " + of);
  }
  return static_cast<int>(index);
}

//------------------------------------------------------------------------------
void GltfValue::FailExpecting(const std::string& expected) const
{
  this->Fail((this->Value ? "is " + Shorten(*this->Value) : std::string("is missing")) +
    ", expected " + expected);
}

//------------------------------------------------------------------------------
void GltfValue::Fail(const std::string& what) const
{
  throw GltfError((this->Place.empty() ? "the file" : this->Place) + " " + what);
}
}
