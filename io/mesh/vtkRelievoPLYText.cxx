// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPLYText.h"

#include "vtkErrorCode.h"
#include "vtkRelievoNumberText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>

namespace relievo::ply
{
namespace
{
struct TypeRow
{
  const char* Names[2];
  int Type;
  std::size_t Size;
};
constexpr TypeRow Types[] = {
  { { "char", "int8" }, VTK_SIGNED_CHAR, 1 },
  { { "uchar", "uint8" }, VTK_UNSIGNED_CHAR, 1 },
  { { "short", "int16" }, VTK_SHORT, 2 },
  { { "ushort", "uint16" }, VTK_UNSIGNED_SHORT, 2 },
  { { "int", "int32" }, VTK_INT, 4 },
  { { "uint", "uint32" }, VTK_UNSIGNED_INT, 4 },
  { { "float", "float32" }, VTK_FLOAT, 4 },
  { { "double", "float64" }, VTK_DOUBLE, 8 },
};

const TypeRow& GetRow(int type)
{
  return *std::find_if(
    std::begin(Types), std::end(Types), [type](const TypeRow& row) { return row.Type == type; });
}

std::string Show(std::string_view word)
{
  std::string shown(word.substr(0, 40));
  for (char& c : shown)
  {
    c = c < ' ' || c > '~' ? '?' : c; // safe to print on a terminal
  }
  return shown;
}

[[noreturn]] void Refuse(const std::string& text)
{
  throw Refusal{ vtkErrorCode::FileFormatError, text };
}

enum class Format
{
  Text,
  LittleEndian,
  BigEndian
};

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

//------------------------------------------------------------------------------
class Reader
{
public:
  explicit Reader(std::string_view text)
    : Here(text.data())
    , Begin(text.data())
    , End(text.data() + text.size())
  {
  }

  Content Read(const std::function<bool(double)>& goOn)
  {
    this->ReadHeader();
    for (Element& element : this->Out.Elements)
    {
      const bool kept = element.Name == "vertex" || element.Name == "face" ||
        element.Name == "tristrips" || element.Name == "edge";
      this->CheckCount(element);
      for (Column& column : element.Columns)
      {
        const int type = this->Of == Format::Text ? VTK_DOUBLE : column.Type;
        column.Stored = kept;
        column.Values.SetType(type, this->Of == Format::Text ? sizeof(double) : column.Size);
        if (kept)
        {
          column.Values.Reserve(static_cast<std::size_t>(element.Count));
        }
      }
      for (vtkIdType i = 0; i < (element.Columns.empty() ? 0 : element.Count); ++i)
      {
        for (Column& column : element.Columns)
        {
          this->ReadColumn(element, i, column);
        }
        if (i % 65536 == 0 &&
          !goOn(static_cast<double>(this->Here - this->Begin) /
            static_cast<double>(this->End - this->Begin)))
        {
          return std::move(this->Out);
        }
      }
    }
    return std::move(this->Out);
  }

private:
  // The words of the next line; none at the end of the file.
  std::vector<std::string> TakeLine()
  {
    const char* const end =
      std::find_if(this->Here, this->End, [](char c) { return c == '\n' || c == '\r'; });
    std::vector<std::string> words(1);
    for (; this->Here != end; ++this->Here)
    {
      if (!IsBlank(*this->Here))
      {
        words.back() += *this->Here;
      }
      else if (!words.back().empty())
      {
        words.emplace_back();
      }
    }
    if (this->Here != this->End)
    {
      this->Here += *this->Here == '\r' && this->Here + 1 != this->End && this->Here[1] == '\n';
      ++this->Here;
    }
    ++this->Line;
    if (words.back().empty())
    {
      words.pop_back();
    }
    return words;
  }

  [[noreturn]] void RefuseLine(const std::string& expected) const
  {
    Refuse("line " + std::to_string(this->Line) + ": expected " + expected);
  }

  int TakeType(const std::string& word) const
  {
    for (const TypeRow& row : Types)
    {
      if (word == row.Names[0] || word == row.Names[1])
      {
        return row.Type;
      }
    }
    this->RefuseLine("a type, such as float or uchar, not '" + Show(word) + "'");
  }

  void ReadHeader()
  {
    if (this->TakeLine() != std::vector<std::string>{ "ply" })
    {
      throw Refusal{ vtkErrorCode::UnrecognizedFileTypeError,
        "expected a PLY file, whose first line is the word ply" };
    }
    bool known = false;
    for (;;)
    {
      if (this->Here == this->End)
      {
        throw Refusal{ vtkErrorCode::PrematureEndOfFileError,
          "the file ends in its header, before end_header" };
      }
      const std::vector<std::string> words = this->TakeLine();
      const std::string word = words.empty() ? "" : words[0];
      if (word == "end_header")
      {
        break;
      }
      if (word == "format" && words.size() > 1)
      {
        known = words[1] == "ascii" || words[1] == "binary_little_endian" ||
          words[1] == "binary_big_endian";
        this->Of = words[1] == "ascii"         ? Format::Text
          : words[1] == "binary_little_endian" ? Format::LittleEndian
                                               : Format::BigEndian;
      }
      else if (word == "element")
      {
        this->AddElement(words);
      }
      else if (word == "property")
      {
        this->AddColumn(words);
      }
      else if (word == "comment" && words.size() > 2 && words[1] == "TextureFile")
      {
        std::string name = words[2];
        for (std::size_t i = 3; i < words.size(); ++i)
        {
          name += ' ' + words[i];
        }
        this->Out.Textures.push_back(name);
      }
      else if (!word.empty() && word != "comment" && word != "obj_info")
      {
        this->RefuseLine("a line of a header, not '" + Show(word) + "'");
      }
    }
    if (!known)
    {
      Refuse("expected the format ascii, binary_little_endian or binary_big_endian in its header");
    }
  }

  void AddElement(const std::vector<std::string>& words)
  {
    Element element;
    const std::string count = words.size() == 3 ? words[2] : "";
    const auto result = std::from_chars(count.data(), count.data() + count.size(), element.Count);
    if (count.empty() || result.ptr != count.data() + count.size() || result.ec != std::errc() ||
      element.Count < 0)
    {
      this->RefuseLine("the name and the number of elements");
    }
    element.Name = words[1];
    this->Out.Elements.push_back(std::move(element));
  }

  void AddColumn(const std::vector<std::string>& words)
  {
    const bool list = words.size() == 5 && words[1] == "list";
    if (this->Out.Elements.empty() || (words.size() != 3 && !list))
    {
      this->RefuseLine("the type and the name of a property, behind its element");
    }
    Column column;
    column.CountType = list ? this->TakeType(words[2]) : 0;
    column.Type = this->TakeType(words[list ? 3 : 1]);
    column.Size = GetRow(column.Type).Size;
    column.CountSize = list ? GetRow(column.CountType).Size : 0;
    column.Name = words.back();
    if (column.CountType == VTK_FLOAT || column.CountType == VTK_DOUBLE)
    {
      this->RefuseLine("a type of whole numbers for the length of a list");
    }
    this->Out.Elements.back().Columns.push_back(std::move(column));
  }

  //----------------------------------------------------------------------------
  // Checks an announced count before memory is allocated for it.
  void CheckCount(const Element& element) const
  {
    std::size_t size = 0;
    for (const Column& column : element.Columns)
    {
      const std::size_t first = column.CountType != 0 ? column.CountSize : column.Size;
      size += this->Of == Format::Text ? 2 : first;
    }
    const auto left =
      static_cast<std::size_t>(this->End - this->Here) + 1; // the last line may have no end
    if (size > 0 && static_cast<std::size_t>(element.Count) > left / size)
    {
      throw Refusal{ vtkErrorCode::PrematureEndOfFileError,
        "its header announces " + std::to_string(element.Count) + " of the element " +
          Show(element.Name) + ", and the file is too short for them: is it whole?" };
    }
  }

  void ReadColumn(const Element& element, vtkIdType i, Column& column)
  {
    vtkIdType count = 1;
    if (column.CountType != 0)
    {
      const double given = this->Of == Format::Text
        ? this->TakeWord(element, i, column.CountType)
        : this->TakeBytes(element, i, column.CountType, column.CountSize);
      count = given >= 0. ? static_cast<vtkIdType>(given) : -1;
      const std::size_t size = this->Of == Format::Text ? 2 : column.Size;
      const auto left = static_cast<std::size_t>(this->End - this->Here) + 1;
      if (count < 0)
      {
        Refuse("element " + Show(element.Name) + " " + std::to_string(i) +
          ": expected the length of a list, not " + std::to_string(given));
      }
      if (static_cast<std::size_t>(count) > left / size)
      {
        this->RefuseEnd(element, i);
      }
    }
    this->Of == Format::Text ? this->ReadWords(element, i, column, count)
                             : this->ReadBytes(element, i, column, count);
    if (column.CountType != 0 && column.Stored)
    {
      column.EndList(i, count);
    }
  }

  void ReadWords(const Element& element, vtkIdType i, Column& column, vtkIdType count)
  {
    for (vtkIdType value = 0; value < count; ++value)
    {
      const double number = this->TakeWord(element, i, column.Type);
      if (column.Stored)
      {
        *static_cast<double*>(column.Values.Add(1)) = number;
      }
    }
  }

  void ReadBytes(const Element& element, vtkIdType i, Column& column, vtkIdType count)
  {
    const std::size_t each = column.Size;
    const std::size_t size = static_cast<std::size_t>(count) * each;
    if (static_cast<std::size_t>(this->End - this->Here) < size)
    {
      this->RefuseEnd(element, i);
    }
    if (column.Stored && size > 0)
    {
      char* const to = static_cast<char*>(column.Values.Add(static_cast<std::size_t>(count)));
      std::memcpy(to, this->Here, size);
      for (std::size_t at = 0; at < size && this->IsForeign(); at += each)
      {
        std::reverse(to + at, to + at + each);
      }
    }
    this->Here += size;
  }

  [[noreturn]] void RefuseEnd(const Element& element, vtkIdType i) const
  {
    throw Refusal{ vtkErrorCode::PrematureEndOfFileError,
      "the file ends in " + Show(element.Name) + " " + std::to_string(i) + " of " +
        std::to_string(element.Count) + ": is it whole?" };
  }

  // Whether bytes are in the other order than this machine's.
  bool IsForeign() const
  {
    const std::uint16_t one = 1;
    unsigned char low = 0;
    std::memcpy(&low, &one, 1);
    return (this->Of == Format::LittleEndian) != (low == 1);
  }

  double TakeWord(const Element& element, vtkIdType i, int type)
  {
    while (this->Here != this->End && IsBlank(*this->Here))
    {
      ++this->Here;
    }
    if (this->Here == this->End)
    {
      this->RefuseEnd(element, i);
    }
    const char* const end = std::find_if(this->Here, this->End, IsBlank);
    double number = 0.;
    const auto result = vtkRelievoReadNumber(this->Here, end, number);
    const std::string_view word(this->Here, static_cast<std::size_t>(end - this->Here));
    const bool whole = type == VTK_FLOAT || type == VTK_DOUBLE || number == std::floor(number);
    if (result.ptr != end || result.ec != std::errc() || !whole)
    {
      Refuse("element " + Show(element.Name) + " " + std::to_string(i) + ": expected a number" +
        (whole ? "" : " without a fraction") + ", not '" + Show(word) + "'");
    }
    this->Here = end;
    return number;
  }

  template <typename Number>
  static double Interpret(const unsigned char* bytes)
  {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
  }

  // The length of a list.
  double TakeBytes(const Element& element, vtkIdType i, int type, std::size_t size)
  {
    if (static_cast<std::size_t>(this->End - this->Here) < size)
    {
      this->RefuseEnd(element, i);
    }
    std::array<unsigned char, 8> bytes = {};
    std::memcpy(bytes.data(), this->Here, size);
    this->Here += size;
    if (this->IsForeign())
    {
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    }
    switch (type)
    {
      case VTK_SIGNED_CHAR:
        return Interpret<std::int8_t>(bytes.data());
      case VTK_UNSIGNED_CHAR:
        return Interpret<std::uint8_t>(bytes.data());
      case VTK_SHORT:
        return Interpret<std::int16_t>(bytes.data());
      case VTK_UNSIGNED_SHORT:
        return Interpret<std::uint16_t>(bytes.data());
      case VTK_INT:
        return Interpret<std::int32_t>(bytes.data());
      default:
        return Interpret<std::uint32_t>(bytes.data());
    }
  }

  const char* Here;
  const char* const Begin;
  const char* const End;
  long long Line = 0; // of the header
  Format Of = Format::Text;
  Content Out;
};
}

//------------------------------------------------------------------------------
void Numbers::Reserve(std::size_t count)
{
  if (count <= this->Room)
  {
    return;
  }
  void* const grown = std::realloc(this->Bytes, count * this->Each); // moves pages instead of bytes
  if (!grown)
  {
    throw std::bad_alloc();
  }
  this->Bytes = static_cast<char*>(grown);
  this->Room = count;
}

//------------------------------------------------------------------------------
void* Numbers::Release()
{
  this->Size = this->Room = 0;
  return std::exchange(this->Bytes, nullptr);
}

//------------------------------------------------------------------------------
Content Read(std::string_view text, const std::function<bool(double)>& goOn)
{
  return Reader(text).Read(goOn);
}
}
