// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scripts.h"

#include "Options.h"

#include <QString>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <vector>

namespace viewer
{
namespace
{
// Whether the word survives a clipboard and a terminal unchanged.
bool IsPrinted(const std::string& word)
{
  return QString::fromStdString(word).toStdString() == word &&
    std::none_of(word.begin(), word.end(),
      [](char letter) { return std::iscntrl(static_cast<unsigned char>(letter)); });
}

// The word as $'...', which bash, zsh and POSIX of 2024 read; bytes have three octal digits, which
// a following character cannot extend.
std::string QuoteBytes(const std::string& word)
{
  std::string quoted = "$'";
  for (const char letter : word)
  {
    const auto byte = static_cast<unsigned char>(letter);
    char number[5];
    std::snprintf(number, sizeof number, "\\%03o", byte);
    const bool plain = byte >= ' ' && byte <= '~' && letter != '\'' && letter != '\\';
    quoted += plain ? std::string(1, letter) : number;
  }
  return quoted + "'";
}

std::string Quote(const std::string& word)
{
  constexpr const char* plain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
  {
    return word;
  }
  if (!IsPrinted(word))
  {
    return QuoteBytes(word);
  }
  std::string quoted = "'";
  for (const char letter : word)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

std::string QuoteAll(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words)
  {
    line += " " + Quote(word);
  }
  return line;
}

//------------------------------------------------------------------------------
// The text as a Python string, or as bytes unless it is UTF-8.
std::string QuoteForPython(const std::string& text)
{
  const bool isText = QString::fromStdString(text).toStdString() == text;
  std::string quoted = isText ? "\"" : "b\"";
  for (const char letter : text)
  {
    const auto byte = static_cast<unsigned char>(letter);
    char number[5];
    std::snprintf(number, sizeof number, "\\x%02x", byte);
    const bool plain = (byte >= ' ' && byte < 0x7f) || (isText && byte >= 0x80);
    quoted += letter == '"' || letter == '\\' ? std::string("\\") + letter
      : plain                                 ? std::string(1, letter)
                                              : number;
  }
  return quoted + "\"";
}

// A keyword of relievo.scene.
std::string GetKeyword(std::string option)
{
  option.erase(0, option.find_first_not_of('-'));
  std::replace(option.begin(), option.end(), '-', '_');
  return option;
}

std::string WriteList(const std::vector<std::string>& values)
{
  std::string list;
  for (const std::string& value : values)
  {
    list += (list.empty() ? "" : ", ") + QuoteForPython(value);
  }
  return "[" + list + "]";
}
}

//------------------------------------------------------------------------------
std::string WriteCommand(const scene::Settings& view, const std::string& png)
{
  return "relievo render --png " + Quote(png) + QuoteAll(view.GetWords());
}

//------------------------------------------------------------------------------
std::string WriteFilmCommand(
  const scene::Settings& view, const std::vector<scene::CameraKey>& keys, const std::string& film)
{
  scene::Settings rest = view;
  rest.Remove("--camera"); // the path's
  return "(set -C; cat > camera-path.csv) <<END &&\n" + scene::WriteTable(keys) +
    "END\nrelievo render --camera-path camera-path.csv --video " + Quote(film) +
    QuoteAll(rest.GetWords());
}

//------------------------------------------------------------------------------
std::string WritePython(const scene::Settings& view, const std::string& png)
{
  std::string text = "import relievo\n\nscene = relievo.scene(\n";
  for (const std::string& file : view.Files)
  {
    text += "    " + QuoteForPython(file) + ",\n";
  }
  for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
  {
    const std::vector<std::string> values = view.GetAllWords(option.Name);
    if (!values.empty())
    {
      text += "    " + GetKeyword(option.Name) + "=" +
        (option.IsFlag()     ? "True"
            : option.Repeats ? WriteList(values)
                             : QuoteForPython(values.front())) +
        ",\n";
    }
  }
  return text + ")\nscene.render(" + QuoteForPython(png) + ")\n";
}
}
