// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOBJText.h"

#include "vtkErrorCode.h"
#include "vtkRelievoNumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace relievo::obj
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

bool IsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

// Walks over the text by lines. Lines end as in Unix, Windows or old Mac OS; a backslash at the end
// joins the next line.
class Cursor
{
public:
  explicit Cursor(std::string_view text)
    : Here(text.data())
    , Begin(text.data())
    , End(text.data() + text.size())
  {
  }

  long long GetLine() const { return this->Line; }
  bool AtEnd() const { return this->Here == this->End; }

  double GetProgress() const
  {
    return static_cast<double>(this->Here - this->Begin) /
      std::max(static_cast<double>(this->End - this->Begin), 1.);
  }

  // Moves to the next word of the line; false if there is none.
  bool FindWord()
  {
    while (this->Here != this->End && (IsBlank(*this->Here) || this->AtJoint()))
    {
      this->Here += 1;
      if (this->Here[-1] == '\\')
      {
        this->TakeLineEnd();
      }
    }
    return this->Here != this->End && !IsLineEnd(*this->Here) && *this->Here != '#';
  }

  std::string_view TakeWord()
  {
    const char* const first = this->Here;
    while (!this->AtWordEnd())
    {
      ++this->Here;
    }
    return std::string_view(first, static_cast<std::size_t>(this->Here - first));
  }

  // The rest of the line, without surrounding blanks and without a comment, which begins after a
  // blank.
  std::string TakeRest()
  {
    std::string rest;
    const char* gap = this->Here;
    while (this->FindWord())
    {
      const char* const first = this->Here;
      while (this->Here != this->End && !IsLineEnd(*this->Here) && !IsBlank(*this->Here) &&
        !this->AtJoint())
      {
        ++this->Here;
      }
      const bool joined = std::find(gap, first, '\\') != first;
      rest += rest.empty() ? "" : joined ? " " : std::string(gap, first);
      rest.append(first, this->Here);
      gap = this->Here;
    }
    return rest;
  }

  void EndLine()
  {
    while (this->Here != this->End && !IsLineEnd(*this->Here))
    {
      ++this->Here;
    }
    this->TakeLineEnd();
  }

  // The next number of the line, NaN if the word is not a number; false if there is no word.
  bool TakeNumber(double& number)
  {
    if (!this->FindWord())
    {
      return false;
    }
    const char* const first = this->Here;
    const auto result = vtkRelievoReadNumber(first, this->End, number);
    this->Here = result.ptr;
    if (result.ec == std::errc() && this->AtWordEnd())
    {
      number = std::isfinite(number) ? number : NaN;
      return true;
    }
    this->Here = first;
    this->TakeWord();
    number = NaN;
    return true;
  }

  // The integer that begins here; false if there is none.
  bool TakeIndex(vtkIdType& index)
  {
    const auto result = std::from_chars(this->Here, this->End, index);
    const bool taken = result.ec == std::errc();
    this->Here = taken ? result.ptr : this->Here;
    return taken;
  }

  bool TakeSlash()
  {
    const bool slash = this->Here != this->End && *this->Here == '/';
    this->Here += slash ? 1 : 0;
    return slash;
  }

  bool AtWordEnd() const
  {
    return this->Here == this->End || IsBlank(*this->Here) || IsLineEnd(*this->Here) ||
      *this->Here == '#' || this->AtJoint();
  }

  const char* GetPlace() const { return this->Here; }
  void GoBackTo(const char* place) { this->Here = place; }

private:
  void TakeLineEnd()
  {
    if (this->Here != this->End)
    {
      this->Here += *this->Here == '\r' && this->Here + 1 != this->End && this->Here[1] == '\n';
      ++this->Here;
      ++this->Line;
    }
  }

  bool AtJoint() const
  {
    return *this->Here == '\\' && this->Here + 1 != this->End && IsLineEnd(this->Here[1]);
  }

  const char* Here;
  const char* const Begin;
  const char* const End;
  long long Line = 1;
};

// Makes a word safe to print on a terminal.
std::string Show(std::string_view word)
{
  std::string shown(word.substr(0, 40));
  for (char& c : shown)
  {
    c = c < ' ' || c > '~' ? '?' : c;
  }
  return shown;
}

// Indices into a table: counted from 1 or, if negative, from the last entry so far.
class Indices
{
public:
  explicit Indices(const char* what)
    : What(what)
  {
  }

  // The index from 0. An index beyond the entries so far is checked at the end of the file.
  vtkIdType Resolve(vtkIdType index, vtkIdType count, long long line)
  {
    const vtkIdType place = index > 0 ? index - 1 : count + index;
    if (index == 0 || place < 0)
    {
      throw this->Refuse(index, count, line);
    }
    if (place >= count && place > this->Highest)
    {
      this->Highest = place;
      this->Later.push_back({ index, line });
    }
    return place;
  }

  void CheckLater(vtkIdType count) const
  {
    for (const auto& [index, line] : this->Later)
    {
      if (index > count)
      {
        throw this->Refuse(index, count, line);
      }
    }
  }

private:
  Refusal Refuse(vtkIdType index, vtkIdType count, long long line) const
  {
    const std::string last = std::to_string(count);
    return { vtkErrorCode::FileFormatError,
      "line " + std::to_string(line) + ": expected the index of a " + this->What +
        (count > 0 ? ", from 1 to " + last + " or from -" + last + " to -1"
                   : ", and there is none") +
        ", not " + std::to_string(index) };
  }

  const char* const What;
  vtkIdType Highest = -1;
  std::vector<std::pair<vtkIdType, long long>> Later; // ascending
};

//------------------------------------------------------------------------------
class Reader
{
public:
  explicit Reader(std::string_view text)
    : In(text)
  {
  }

  Content Read(const std::function<bool(double)>& goOn)
  {
    for (long long count = 0; !this->In.AtEnd(); ++count)
    {
      if (this->In.FindWord())
      {
        this->ReadStatement();
      }
      this->In.EndLine();
      if (count % 65536 == 0 && !goOn(this->In.GetProgress()))
      {
        return std::move(this->Out);
      }
    }
    this->OfPoints.CheckLater(this->CountPoints());
    this->OfTextureCoordinates.CheckLater(this->CountTextureCoordinates());
    this->OfNormals.CheckLater(this->CountNormals());
    return std::move(this->Out);
  }

private:
  vtkIdType CountPoints() const { return static_cast<vtkIdType>(this->Out.Points.size() / 3); }
  vtkIdType CountNormals() const { return static_cast<vtkIdType>(this->Out.Normals.size() / 3); }
  vtkIdType CountTextureCoordinates() const
  {
    return static_cast<vtkIdType>(this->Out.TextureCoordinates.size() / 2);
  }

  void ReadStatement()
  {
    this->Line = this->In.GetLine();
    const std::string_view word = this->In.TakeWord();
    if (word == "v")
    {
      this->ReadPoint();
    }
    else if (word == "f" || word == "fo") // fo is an older name
    {
      this->ReadCell(3);
    }
    else if (word == "vn")
    {
      this->ReadNormal();
    }
    else if (word == "vt")
    {
      this->ReadTextureCoordinate();
    }
    else if (word == "l")
    {
      this->ReadCell(2);
    }
    else if (word == "p")
    {
      this->ReadCell(1);
    }
    else if (word == "mtllib")
    {
      const std::string names = this->In.TakeRest();
      if (!names.empty())
      {
        this->Out.Libraries.push_back(names);
      }
    }
    else if (word == "usemtl")
    {
      const std::string name = this->In.TakeRest();
      this->Change(&State::Material, name.empty() ? -1 : this->Out.Materials.Find(name));
    }
    else if (word == "g")
    {
      this->Change(&State::Group, this->Out.Groups.Find(this->In.TakeRest()));
    }
    else if (word == "o")
    {
      this->Change(&State::Object, this->Out.Objects.Find(this->In.TakeRest()));
    }
    else if (word == "s")
    {
      double group = 0.; // `off` is not a number
      const bool numbered = this->In.TakeNumber(group) && group >= 1. && group <= 1e9;
      this->Change(&State::Smoothing, numbered ? static_cast<int>(group) : 0);
    }
    else if (word == "curv" || word == "curv2" || word == "surf")
    {
      this->Out.Curves.Add(this->Line);
    }
  }

  void Change(int State::*what, int value)
  {
    State state = this->Out.States.back();
    if (state.*what != value)
    {
      state.*what = value;
      this->Out.States.push_back(state);
    }
  }

  // x y z, x y z w, or x y z r g b.
  void ReadPoint()
  {
    double numbers[6] = { NaN, NaN, NaN };
    int count = 0;
    while (count < 6 && this->In.TakeNumber(numbers[count]))
    {
      ++count;
    }
    if (std::isnan(numbers[0] + numbers[1] + numbers[2]))
    {
      this->Out.InvalidPoints.Add(this->Line);
    }
    if (count == 6 || !this->Out.Colors.empty())
    {
      this->Out.Colors.resize(this->Out.Points.size(), -1.f);
      for (int i = 3; i < 6; ++i)
      {
        this->Out.Colors.push_back(count == 6 ? static_cast<float>(numbers[i]) : -1.f);
      }
    }
    this->Out.Points.insert(this->Out.Points.end(), numbers, numbers + 3);
  }

  void ReadNormal()
  {
    double n[3] = { NaN, NaN, NaN };
    for (double& component : n)
    {
      this->In.TakeNumber(component);
    }
    const bool invalid = !(std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]) > 0.);
    if (invalid)
    {
      this->Out.InvalidNormals.Add(this->Line);
    }
    for (const double component : n)
    {
      this->Out.Normals.push_back(static_cast<float>(invalid ? NaN : component));
    }
  }

  // u, u v, or u v w.
  void ReadTextureCoordinate()
  {
    double u = NaN;
    double v = 0.;
    this->In.TakeNumber(u);
    this->In.TakeNumber(v);
    const bool invalid = std::isnan(u + v);
    if (invalid)
    {
      this->Out.InvalidTextureCoordinates.Add(this->Line);
    }
    this->Out.TextureCoordinates.push_back(static_cast<float>(invalid ? NaN : u));
    this->Out.TextureCoordinates.push_back(static_cast<float>(invalid ? NaN : v));
  }

  //----------------------------------------------------------------------------
  // A statement with fewer points than its kind needs makes a cell of the kind for so many points.
  void ReadCell(std::size_t kindOfStatement)
  {
    this->Points.clear();
    this->TextureCoordinates.clear();
    this->Normals.clear();
    while (this->In.FindWord())
    {
      this->ReadCorner();
    }
    const std::size_t count = this->Points.size();
    if (count == 0)
    {
      throw Refusal{ vtkErrorCode::FileFormatError,
        "line " + std::to_string(this->Line) + ": expected the indices of a cell's points, and " +
          "there are none" };
    }
    CellList& cells = this->Out.Cells[std::min(count, kindOfStatement) - 1];
    const auto append = [&](std::vector<vtkIdType>& to, const std::vector<vtkIdType>& from) {
      if (!from.empty() || !to.empty())
      {
        to.resize(cells.Points.size(), -1);
        to.insert(to.end(), from.begin(), from.end());
        to.resize(cells.Points.size() + count, -1);
      }
    };
    append(cells.TextureCoordinates, this->TextureCoordinates);
    append(cells.Normals, this->Normals);
    cells.Points.insert(cells.Points.end(), this->Points.begin(), this->Points.end());
    cells.Starts.push_back(static_cast<vtkIdType>(cells.Points.size()));
    cells.States.push_back(static_cast<int>(this->Out.States.size()) - 1);
  }

  // v, v/t, v//n or v/t/n.
  void ReadCorner()
  {
    const char* const begin = this->In.GetPlace();
    const std::size_t place = this->Points.size();
    vtkIdType index = 0;
    bool whole = this->In.TakeIndex(index);
    if (whole)
    {
      this->Points.push_back(this->OfPoints.Resolve(index, this->CountPoints(), this->Line));
      if (this->In.TakeSlash())
      {
        if (this->In.TakeIndex(index))
        {
          this->TextureCoordinates.resize(place, -1);
          this->TextureCoordinates.push_back(
            this->OfTextureCoordinates.Resolve(index, this->CountTextureCoordinates(), this->Line));
        }
        if (this->In.TakeSlash() && this->In.TakeIndex(index))
        {
          this->Normals.resize(place, -1);
          this->Normals.push_back(this->OfNormals.Resolve(index, this->CountNormals(), this->Line));
        }
      }
      whole = this->In.AtWordEnd();
    }
    if (!whole)
    {
      this->In.GoBackTo(begin);
      throw Refusal{ vtkErrorCode::FileFormatError,
        "line " + std::to_string(this->Line) +
          ": expected indices as 1, 1/2, 1//3 or 1/2/3, not '" + Show(this->In.TakeWord()) + "'" };
    }
  }

  Cursor In;
  Content Out;
  long long Line = 1; // the first line of the statement
  Indices OfPoints{ "point" };
  Indices OfTextureCoordinates{ "texture coordinate" };
  Indices OfNormals{ "normal" };
  std::vector<vtkIdType> Points; // of the cell, and the other vectors as in CellList
  std::vector<vtkIdType> TextureCoordinates;
  std::vector<vtkIdType> Normals;
};
}

//------------------------------------------------------------------------------
Content Read(std::string_view text, const std::function<bool(double)>& goOn)
{
  // The byte-order marks of UTF-16 and UTF-32 or, without one, the zero bytes of their letters.
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 1;
  };
  if ((byte(0) == 0xff && byte(1) == 0xfe) || (byte(0) == 0xfe && byte(1) == 0xff) ||
    byte(0) == 0 || byte(1) == 0)
  {
    throw Refusal{ vtkErrorCode::UnrecognizedFileTypeError,
      "expected UTF-8 or ASCII text, but it is UTF-16, UTF-32 or no text: save it as UTF-8" };
  }
  if (byte(0) == 0xef && byte(1) == 0xbb && byte(2) == 0xbf)
  {
    text.remove_prefix(3);
  }
  return Reader(text).Read(goOn);
}
}
