// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Describes one parameter of a stage, of a stage's points, of a material or of an environment: its
// name, its valid values, and functions to get and set it.
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
    CHOICE, // the index of one of Choices
    COLOR,  // red, green, blue, from Least to Most each
    PAIR,   // two finite numbers
    VECTOR, // three finite numbers
    SIZE,   // whole numbers from Least to Most, with x between them
    DATE,   // year from Least to Most, month and day
    BOX,    // six finite numbers: from and to along x, y and z
    TEXT
  };

  std::string Name;  // lower-case words joined by _
  std::string Label; // display name if it differs from the name: see GetLabel
  Types Type = NUMBER;
  double Least = 0.0;
  double Most = 0.0;
  bool Open = false;   // Least and Most are excluded
  std::string Unit;    // "" if it has none
  std::string Help;    // one line
  std::string Default; // of a new stage, formatted by Format
  std::vector<std::string> Choices;
  std::vector<std::string> ChoiceLabels; // of each choice; empty: their names
  int FirstChoice = 0;                   // the number of Choices[0] in the owner's methods
  bool IsDirection = false;              // for a vector: not 0 0 0
  bool IsLinear = false; // for a colour: numbers are linear light, names and #rrggbb sRGB
  double Usual = 0.0;    // upper end of a slider; 0: Most
  bool PerPoint = false; // the name of a point array gives each point its own value
  bool Advanced = false; // behind ParaView's gear, and in the viewer's section Advanced

  // Condition without which it has no effect: "falloff=vtk", another parameter's value, or several
  // with commas. "relief!=off" means any other value; "height_map", that the object has this input.
  std::string OnlyIf;

  std::function<std::vector<double>()> GetValues;
  std::function<void(const std::vector<double>&)> SetValues;
  std::function<std::string()> GetText;
  std::function<void(const std::string&)> SetText;

  // Number of numbers in a value; 0 for a text.
  int GetNumberOfComponents() const;

  // A part of OnlyIf: the parameter, and the required or excluded value; "" for a required input.
  struct Condition
  {
    std::string Name;
    std::string Value;
    bool Other;
  };
  std::vector<Condition> GetConditions() const;

  // The label for people, in ParaView and the viewer: "Map Size" for "map_size".
  std::string GetLabel() const;

  // A choice's label, by its index: "blue noise" for "blue_noise".
  std::string GetChoiceLabel(std::size_t choice) const;

  // The value in words, for Parse: "0.5", "on", "warped", "1,0.5,0" or "1/0.5/0", "64x64".
  std::string Format() const;

  // Sets the value from words. Returns an error and sets nothing if they are invalid; otherwise "".
  std::string Parse(const std::string& words) const;

  // Sets the value; returns an error like Parse.
  std::string Set(const std::vector<double>& values) const;

  // Whether the words are meant as a value, valid or not, rather than as the name of a point array.
  bool IsValue(const std::string& words) const;

  // The valid values, in words: "a number from 0 to 1".
  std::string GetExpected() const;

  // The bounds, in words: "from 0 to 1", "0 or more", "above 0"; "" if there are none.
  std::string GetBounds() const;
};

// Turns "depth_fade" into "Depth Fade", or without the space into "DepthFade".
VTKRELIEVODESCRIBE_EXPORT std::string vtkRelievoCapitalize(const std::string& name, bool spaces);

#endif
