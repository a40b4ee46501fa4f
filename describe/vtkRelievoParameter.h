// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One parameter of a stage, of points that a stage draws, of a material or of an environment: what
// it is called, what values it takes, and how to get and set it.
#ifndef vtkRelievoParameter_h
#define vtkRelievoParameter_h

#include "vtkRelievoDescribeModule.h" // for the export macro

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

struct VTKRELIEVODESCRIBE_EXPORT vtkRelievoParameter
{
  enum Types
  {
    FLAG,   // 0 or 1
    WHOLE,  // a whole number from Least to Most
    NUMBER, // a finite number from Least to Most
    CHOICE, // the place of one of Choices
    COLOR,  // red, green, blue, from Least to Most each
    PAIR,   // two finite numbers
    VECTOR, // three finite numbers
    SIZE,   // whole numbers from Least to Most, with x between them
    TEXT
  };

  std::string Name;  // a lower-case word; several are joined by _
  std::string Label; // as people read it, where the name does not say it: see GetLabel
  Types Type = NUMBER;
  double Least = 0.0;
  double Most = 0.0;
  bool Open = false;   // Least and Most themselves are not taken
  std::string Unit;    // "" if it has none
  std::string Help;    // one line
  std::string Default; // of a new stage, in words as Format
  std::vector<std::string> Choices;
  std::vector<std::string> ChoiceLabels; // of each of them; empty: by their names
  bool IsDirection = false;              // of a vector: not 0 0 0
  bool IsLinear = false; // of a colour: numbers are of light, names and #rrggbb as displays show it
  double Usual = 0.0;    // up to which a slider goes; 0: to Most
  bool PerPoint = false; // the name of a point array gives each point its own value
  bool Advanced = false; // for those who know the method: ParaView shows it behind its gear, the
                         // viewer among what is folded

  // Without effect but where this holds: "falloff=vtk", another parameter's value, or several with
  // commas. "relief!=off" is any other value; "height_map", something that the object is given.
  std::string OnlyIf;

  std::function<std::vector<double>()> GetValues;
  std::function<void(const std::vector<double>&)> SetValues;
  std::function<std::string()> GetText;
  std::function<void(const std::string&)> SetText;

  // How many numbers a value consists of; 0 for a text.
  int GetNumberOfComponents() const;

  // A part of OnlyIf: what has to have the value, or another one; "" of what has to be there.
  struct Condition
  {
    std::string Name;
    std::string Value;
    bool Other;
  };
  std::vector<Condition> GetConditions() const;

  // The label for people, in ParaView and the viewer: "Map Size" for "map_size".
  std::string GetLabel() const;

  // That of a choice, by its place: "blue noise" for "blue_noise".
  std::string GetChoiceLabel(std::size_t choice) const;

  // The value in words, which Parse takes: "0.5", "on", "warped", "1,0.5,0" or "1/0.5/0", "64x64".
  std::string Format() const;

  // Sets the value that the words say. Returns what is wrong with them, in words; nothing is set
  // then.
  std::string Parse(const std::string& words) const;

  // Sets the value; what is wrong, in words, as Parse.
  std::string Set(const std::vector<double>& values) const;

  // Whether the words are meant as a value, right or wrong, and not as the name of a point array.
  bool IsValue(const std::string& words) const;

  // The values that it takes, in words: "a number from 0 to 1".
  std::string GetExpected() const;

  // Their bounds, in words: "from 0 to 1", "0 or more", "above 0"; "" if there are none.
  std::string GetBounds() const;
};

// "depth_fade" as "Depth Fade", or without the space as "DepthFade".
VTKRELIEVODESCRIBE_EXPORT std::string vtkRelievoCapitalize(const std::string& name, bool spaces);

#endif
