// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoOFFTokenizer.h
 * @brief Walks over the words and numbers of an OFF text; private to vtkRelievoOFFReader.
 */
#ifndef vtkRelievoOFFTokenizer_h
#define vtkRelievoOFFTokenizer_h

#include "vtkErrorCode.h"
#include "vtkRelievoMeshText.h"
#include "vtkRelievoNumberText.h"
#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace relievo::off
{
// Walks over the words of the text, counting lines and skipping comments.
class Words
{
public:
  explicit Words(const std::string& text)
    : Here(text.data())
    , Begin(text.data())
    , End(text.data() + text.size())
  {
  }

  // The next word of the line; empty at its end.
  std::string_view NextOfLine()
  {
    while (this->Here != this->End && IsBlank(*this->Here))
    {
      ++this->Here;
    }
    if (this->Here != this->End && *this->Here == '#')
    {
      this->Here = std::find(this->Here, this->End, '\n');
    }
    const char* first = this->Here;
    while (
      this->Here != this->End && !IsBlank(*this->Here) && *this->Here != '\n' && *this->Here != '#')
    {
      ++this->Here;
    }
    return std::string_view(first, static_cast<size_t>(this->Here - first));
  }

  // The next word, on this line or a later one.
  std::string_view Next(const char* expected)
  {
    for (;;)
    {
      const std::string_view word = this->NextOfLine();
      if (!word.empty())
      {
        return word;
      }
      if (this->Here == this->End)
      {
        throw Refusal{ vtkErrorCode::PrematureEndOfFileError,
          "the file ends on line " + std::to_string(this->Line) + " where " + expected +
            " was expected" };
      }
      ++this->Here;
      ++this->Line;
    }
  }

  template <typename Number>
  Number Parse(std::string_view word, const char* expected) const
  {
    Number value{};
    const char* last = word.data() + word.size();
    const auto result = vtkRelievoReadNumber(word.data(), last, value);
    if (result.ptr != last || result.ec != std::errc() ||
      !std::isfinite(static_cast<double>(value)))
    {
      throw this->Unexpected(word, expected);
    }
    return value;
  }

  Refusal Unexpected(std::string_view word, const std::string& expected) const
  {
    // Makes the word safe to print on a terminal.
    std::string shown(word.substr(0, 40));
    for (char& c : shown)
    {
      c = c < ' ' || c > '~' ? '?' : c;
    }
    return Refusal{ vtkErrorCode::FileFormatError,
      "line " + std::to_string(this->Line) + ": expected " + expected + ", not '" + shown + "'" };
  }

  double Real(const char* expected) { return this->Parse<double>(this->Next(expected), expected); }

  // A count or an index, in [0, limit).
  vtkIdType Whole(vtkIdType limit, const char* expected)
  {
    const std::string_view word = this->Next(expected);
    const auto value = this->Parse<long long>(word, expected);
    if (value < 0 || value >= limit)
    {
      throw this->Unexpected(
        word, std::string(expected) + " from 0 to " + std::to_string(limit - 1));
    }
    return static_cast<vtkIdType>(value);
  }

  // The number of items that the file announces.
  vtkIdType Count(vtkIdType limit, const std::string& what)
  {
    const std::string expected = "the number of " + what;
    const std::string_view word = this->Next(expected.c_str());
    const auto value = this->Parse<long long>(word, expected.c_str());
    if (value < 0 || value >= limit)
    {
      throw this->Unexpected(
        word, expected + " (a file of this size holds fewer than " + std::to_string(limit) + ")");
    }
    return static_cast<vtkIdType>(value);
  }

  // The numbers on the rest of the line.
  void Rest(std::vector<double>& numbers, const char* expected)
  {
    numbers.clear();
    for (std::string_view word = this->NextOfLine(); !word.empty(); word = this->NextOfLine())
    {
      numbers.push_back(this->Parse<double>(word, expected));
    }
  }

  double Progress() const
  {
    return static_cast<double>(this->Here - this->Begin) /
      std::max<double>(static_cast<double>(this->End - this->Begin), 1.);
  }

private:
  static bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }

  const char* Here;
  const char* const Begin;
  const char* const End;
  long long Line = 1;
};
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoOFFTokenizer.h
