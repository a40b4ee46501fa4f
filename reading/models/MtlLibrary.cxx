// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MtlLibrary.h"

#include "ReadContext.h"

#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoFileKind.h"

#include <algorithm>
#include <filesystem>
#include <locale>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

namespace reading
{
namespace
{
const char* const Blanks = " \t";
constexpr std::size_t MostBytes = std::size_t(1) << 28; // in a library

std::string TrimLine(const std::string& line)
{
  const std::string::size_type first = line.find_first_not_of(Blanks);
  return first == std::string::npos ? ""
                                    : line.substr(first, line.find_last_not_of(Blanks) + 1 - first);
}

// A comment needs a blank before its #, because names may contain #.
std::string WithoutComment(const std::string& line)
{
  std::string::size_type sign = line.find('#');
  while (sign != std::string::npos && sign > 0 && line[sign - 1] != ' ' && line[sign - 1] != '\t')
  {
    sign = line.find('#', sign + 1);
  }
  return line.substr(0, sign);
}

//------------------------------------------------------------------------------
std::string TakeWord(std::string& rest)
{
  const std::string::size_type end = std::min(rest.find_first_of(Blanks), rest.size());
  const std::string word = rest.substr(0, end);
  rest = TrimLine(rest.substr(end));
  return word;
}

//------------------------------------------------------------------------------
std::optional<double> ToNumber(const std::string& word)
{
  std::istringstream in(word);
  in.imbue(std::locale::classic());
  double number = 0.0;
  return in >> number && in.peek() == std::char_traits<char>::eof() ? std::optional(number)
                                                                    : std::nullopt;
}

//------------------------------------------------------------------------------
// Parses an option's arguments: up to three numbers (the first required) for some options, one or
// two words for the others.
std::vector<std::string> TakeArguments(const std::string& option, std::string& rest)
{
  std::vector<std::string> words;
  if (option == "-s" || option == "-o" || option == "-t")
  {
    for (std::string before = rest; words.size() < 3; before = rest)
    {
      const std::string word = TakeWord(rest);
      if (!ToNumber(word))
      {
        rest = before;
        break;
      }
      words.push_back(word);
    }
    return words;
  }
  words.push_back(TakeWord(rest));
  if (option == "-mm")
  {
    words.push_back(TakeWord(rest));
  }
  return words;
}

//------------------------------------------------------------------------------
bool IsWithoutEffect(const std::string& option, const std::vector<std::string>& words)
{
  // VTK decides how to filter and store textures, and -bm concerns bump maps.
  const std::vector<std::string> others = { "-blendu", "-blendv", "-boost", "-texres", "-bm",
    "-type" };
  const auto isEach = [&words](double value) {
    return std::all_of(words.begin(), words.end(),
      [value](const std::string& word) { return ToNumber(word) == value; });
  };
  return std::count(others.begin(), others.end(), option) != 0 ||
    ((option == "-clamp" || option == "-cc") && words[0] == "off") ||
    (option == "-t" && isEach(0.0)) ||
    (option == "-mm" && ToNumber(words[0]) == 0.0 && ToNumber(words[1]) == 1.0);
}

//------------------------------------------------------------------------------
// Options, followed by the file.
void TakeTexture(std::string rest, const std::filesystem::path& folder,
  const vtkRelievoAllowedFolders& allowed, MtlMaterial& material)
{
  material.TextureScale = { 1.0, 1.0 };
  material.TextureOffset = { 0.0, 0.0 };
  material.TextureWithout.clear();
  while (!rest.empty() && rest[0] == '-')
  {
    const std::string option = TakeWord(rest);
    const std::vector<std::string> words = TakeArguments(option, rest);
    if (option == "-s" || option == "-o")
    {
      auto& values = option == "-s" ? material.TextureScale : material.TextureOffset;
      for (std::size_t i = 0; i < std::min<std::size_t>(words.size(), 2); ++i)
      {
        values[i] = *ToNumber(words[i]);
      }
    }
    else if (!IsWithoutEffect(option, words))
    {
      material.TextureWithout += (material.TextureWithout.empty() ? "" : " ") + option;
      for (const std::string& word : words)
      {
        material.TextureWithout += " " + word;
      }
    }
  }
  material.Texture = rest.empty() ? "" : FindNamedFile(rest, folder, allowed);
}

//------------------------------------------------------------------------------
void TakeLine(const std::string& line, const std::filesystem::path& folder,
  const vtkRelievoAllowedFolders& allowed, MtlMaterial& material)
{
  std::string rest = line;
  const std::string name = TakeWord(rest);
  std::istringstream words(rest);
  words.imbue(std::locale::classic());
  const auto take = [&words](double(&color)[3]) {
    double read[3];
    if (words >> read[0] >> read[1] >> read[2])
    {
      std::transform(read, read + 3, color, [](double n) { return std::clamp(n, 0.0, 1.0); });
    }
  };
  double number = 0.0;
  if (name == "Kd")
  {
    take(material.Diffuse);
  }
  else if (name == "Ks")
  {
    take(material.Specular);
  }
  else if (name == "Ns" && words >> number)
  {
    material.Exponent = std::clamp(number, 1.0, 1000.0);
    material.Highlights = material.Highlights && number > 0.0;
  }
  else if (name == "illum" && words >> number)
  {
    material.Highlights = material.Highlights && number >= 2.0;
  }
  else if (name == "d")
  {
    // After -halo.
    if (const std::optional<double> last = ToNumber(rest.substr(rest.find_last_of(Blanks) + 1)))
    {
      material.Opacity = std::clamp(*last, 0.0, 1.0);
      material.Dissolves = true;
    }
  }
  else if (name == "Tr" && !material.Dissolves && words >> number)
  {
    // Some programs write 1 for opaque materials, with d or alone: see ObjMaterials.
    material.Opacity = 1.0 - std::clamp(number, 0.0, 1.0);
  }
  else if (name == "map_Kd")
  {
    TakeTexture(rest, folder, allowed, material);
  }
}
}

//------------------------------------------------------------------------------
std::string FindNamedFile(
  std::string name, const std::filesystem::path& folder, const vtkRelievoAllowedFolders& allowed)
{
  if (name.size() > 2 && name.front() == '"' && name.back() == '"')
  {
    name = name.substr(1, name.size() - 2);
  }
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path named = (folder / name).lexically_normal();
  const std::filesystem::path beside = folder / named.filename();
  std::error_code trouble;
  const bool isThere =
    allowed.FindObstacle(named.string()).empty() && std::filesystem::exists(named, trouble);
  return (!isThere && std::filesystem::is_regular_file(beside, trouble) ? beside : named).string();
}

//------------------------------------------------------------------------------
std::string ReadMtlLibrary(const std::string& path, const vtkRelievoAllowedFolders& allowed,
  std::map<std::string, MtlMaterial>& materials, ReadContext& context)
{
  std::string text;
  std::string error = allowed.FindObstacle(path);
  if (error.empty())
  {
    error = vtkRelievoFileKind::ReadWhole(path, MostBytes, text);
  }
  if (!error.empty())
  {
    return error;
  }
  context.AddFile(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  MtlMaterial* material = nullptr;
  std::size_t begin = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  while (begin < text.size())
  {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const std::string line = TrimLine(WithoutComment(text.substr(begin, end - begin)));
    begin = end + 1;
    const std::string word = "newmtl";
    if (line.compare(0, word.size(), word) == 0)
    {
      material = &materials[TrimLine(line.substr(word.size()))];
      *material = {};
    }
    else if (material)
    {
      TakeLine(line, folder, allowed, *material);
    }
  }
  return "";
}
}
