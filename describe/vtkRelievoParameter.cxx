// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParameter.h"

#include "vtkRelievoColorWords.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

namespace
{
constexpr double LargestWhole = 9007199254740992.0; // 2^53: doubles beyond skip whole numbers

// The shortest digits that parse back to the number: 0.1, 100, 1e-07.
std::string Write(double value)
{
  constexpr int most = 17;
  char text[32];
  for (int digits = 6;; ++digits)
  {
    char* const end =
      std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr;
    double back = 0.0;
    std::from_chars(text, end, back);
    if (back == value || digits == most)
    {
      return std::string(text, end);
    }
  }
}

bool ReadNumber(const std::string& word, double& value)
{
  std::istringstream in(word);
  in.imbue(std::locale::classic());
  return (in >> value) && in.peek() == std::istringstream::traits_type::eof();
}

std::vector<std::string> Split(const std::string& words, const std::string& separators)
{
  std::vector<std::string> parts(1);
  for (char c : words)
  {
    if (separators.find(c) != std::string::npos)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoCapitalize(const std::string& name, bool spaces)
{
  std::string label;
  bool first = true;
  for (char c : name)
  {
    if (c == '_' || c == '-')
    {
      label += spaces ? " " : "";
      first = true;
      continue;
    }
    label += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    first = false;
  }
  const std::size_t acronym = label.find("Srgb");
  return acronym == std::string::npos ? label : label.replace(acronym, 4, "SRGB");
}

//------------------------------------------------------------------------------
int vtkRelievoParameter::GetNumberOfComponents() const
{
  switch (this->Type)
  {
    case TEXT:
      return 0;
    case SIZE:
      return static_cast<int>(this->GetValues().size());
    case COLOR:
    case VECTOR:
    case DATE:
      return 3;
    case PAIR:
      return 2;
    case BOX:
      return 6;
    default:
      return 1;
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoParameter::Condition> vtkRelievoParameter::GetConditions() const
{
  std::vector<Condition> conditions;
  for (const std::string& part : Split(this->OnlyIf, ","))
  {
    const std::size_t equals = part.find('=');
    const bool other = equals != std::string::npos && part[equals - 1] == '!';
    if (!part.empty())
    {
      conditions.push_back({ part.substr(0, other ? equals - 1 : equals),
        equals == std::string::npos ? std::string() : part.substr(equals + 1), other });
    }
  }
  return conditions;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::GetLabel() const
{
  return this->Label.empty() ? vtkRelievoCapitalize(this->Name, true) : this->Label;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::GetChoiceLabel(std::size_t choice) const
{
  if (choice < this->ChoiceLabels.size())
  {
    return this->ChoiceLabels[choice];
  }
  std::string label = this->Choices[choice];
  std::replace_if(
    label.begin(), label.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
  return label;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::Format() const
{
  if (this->Type == TEXT)
  {
    return this->GetText();
  }
  const std::vector<double> values = this->GetValues();
  if (this->Type == FLAG)
  {
    return values[0] != 0.0 ? "on" : "off";
  }
  if (this->Type == CHOICE)
  {
    return this->Choices[static_cast<std::size_t>(values[0])];
  }
  const std::string between = this->Type == SIZE ? "x" : this->Type == DATE ? "-" : ",";
  std::string words;
  for (double value : values)
  {
    // 2026-06-21
    const bool isPadded = this->Type == DATE && value < 10.0;
    words += (words.empty() ? "" : between) + (isPadded ? "0" : "") + Write(value);
  }
  return words;
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::GetBounds() const
{
  const std::string least = Write(this->Least), most = Write(this->Most);
  const bool begins = std::isfinite(this->Least), ends = std::isfinite(this->Most);
  if (begins && ends)
  {
    return this->Open ? "between " + least + " and " + most : "from " + least + " to " + most;
  }
  return !begins ? "" : this->Open ? "above " + least : least + " or more";
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::GetExpected() const
{
  const std::string unit = this->Unit.empty() ? "" : " (" + this->Unit + ")";
  const std::string bounds = this->GetBounds();
  const bool orMore = !this->Open && !std::isfinite(this->Most);
  const std::string range = bounds.empty() ? "" : (orMore ? ", " : " ") + bounds;
  const std::string orArray = this->PerPoint ? ", or the name of a point array" : "";
  switch (this->Type)
  {
    case FLAG:
      return "on or off";
    case WHOLE:
      return "a whole number" + range + unit + orArray;
    case NUMBER:
      return "a number" + range + unit + orArray;
    case COLOR:
      return "red,green,blue, each " + bounds + ", #rrggbb, or a colour's name" + orArray;
    case PAIR:
      return "two numbers" + unit;
    case SIZE:
      return std::to_string(this->GetNumberOfComponents()) +
        " whole numbers with x between them, each " + bounds;
    case DATE:
      return "a date, YEAR-MONTH-DAY, with a year " + bounds;
    case BOX:
      return "six numbers, from and to along x, y and z";
    case VECTOR:
      return (this->IsDirection ? "a direction, three numbers" : "three numbers") + unit;
    case CHOICE:
    {
      std::string names;
      for (const std::string& choice : this->Choices)
      {
        names += (names.empty() ? "" : ", ") + choice;
      }
      return "one of " + names + orArray;
    }
    default:
      return "a text";
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoParameter::IsValue(const std::string& words) const
{
  if (!this->PerPoint || words.empty())
  {
    return true;
  }
  if (this->Type == CHOICE)
  {
    return std::find(this->Choices.begin(), this->Choices.end(), words) != this->Choices.end();
  }
  double number = 0.0;
  double color[3];
  if (this->Type == COLOR && relievo::ReadColor(words, color))
  {
    return true;
  }
  const bool several = this->GetNumberOfComponents() > 1 && Split(words, ",/").size() > 1;
  return several || ReadNumber(words, number);
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::Set(const std::vector<double>& values) const
{
  bool good = static_cast<int>(values.size()) == this->GetNumberOfComponents();
  const bool isWhole = this->Type == WHOLE || this->Type == CHOICE || this->Type == FLAG ||
    this->Type == SIZE || this->Type == DATE;
  std::string given;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const bool isDayOrMonth = this->Type == DATE && i > 0;
    const double least = isDayOrMonth ? 1.0 : this->Least;
    const double most = !isDayOrMonth ? this->Most : i == 1 ? 12.0 : 31.0;
    const double value = values[i];
    good = good && std::isfinite(value) && value >= least && value <= most;
    good = good && !(this->Open && (value == least || value == most));
    good = good && (!isWhole || (value == std::floor(value) && std::abs(value) <= LargestWhole));
    given += (given.empty() ? "" : ",") + Write(value);
  }
  good = good && (!this->IsDirection || std::any_of(values.begin(), values.end(), [](double v) {
    return v != 0.0;
  }));
  if (!good)
  {
    return "'" + given + "' was given, expected " + this->GetExpected();
  }
  this->SetValues(values);
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoParameter::Parse(const std::string& words) const
{
  const std::string error = "'" + words + "' was given, expected " + this->GetExpected();
  if (this->Type == TEXT)
  {
    this->SetText(words);
    return std::string();
  }
  if (this->Type == FLAG)
  {
    static const char* const on[] = { "on", "true", "yes", "1" };
    static const char* const off[] = { "off", "false", "no", "0" };
    const bool isOn = std::find(std::begin(on), std::end(on), words) != std::end(on);
    const bool isOff = std::find(std::begin(off), std::end(off), words) != std::end(off);
    return isOn || isOff ? this->Set({ isOn ? 1.0 : 0.0 }) : error;
  }
  if (this->Type == CHOICE)
  {
    const auto found = std::find(this->Choices.begin(), this->Choices.end(), words);
    return found == this->Choices.end()
      ? error
      : this->Set({ static_cast<double>(found - this->Choices.begin()) });
  }
  double color[3];
  if (this->Type == COLOR && relievo::ReadColor(words, color))
  {
    if (this->IsLinear)
    {
      std::transform(color, color + 3, color, relievo::f64::relievoLinearFromSrgb);
    }
    return this->Set({ color[0], color[1], color[2] });
  }
  std::vector<double> values;
  const std::string between = this->Type == SIZE ? "x" : this->Type == DATE ? "-" : ",/";
  for (const std::string& part : Split(words, between))
  {
    double value = 0.0;
    if (!ReadNumber(part, value))
    {
      return error;
    }
    values.push_back(value);
  }
  return this->Set(values).empty() ? std::string() : error;
}
