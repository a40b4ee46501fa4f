// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The options of a command, each described once, by their owner; the parser, the help, the manual
// page, shell completion and Python's keywords are generated from these descriptions.
#ifndef vtkRelievoOption_h
#define vtkRelievoOption_h

#include "vtkRelievoDescribeModule.h" // for the export macro

#include <functional>
#include <string>
#include <vector>

struct vtkRelievoParameter;

struct VTKRELIEVODESCRIBE_EXPORT vtkRelievoOption
{
  std::string Name; // "--seed"
  std::string Form; // placeholder of the value in the help: "N"; "": a flag, without value
  std::string Help; // paragraphs, and lines of tables, which begin with blanks

  // Sets the value, which is empty for a flag. Returns an error such as "got 'x', expected a
  // number", or ""; or throws its command's exceptions.
  std::function<std::string(const std::string& value)> Take;

  // Consequences of an option besides its value.
  enum Trait : unsigned
  {
    READS_FILES = 1,    // a change reads the files again
    SHAPES_SURFACE = 2, // a change makes the maps of surfaces, volumes and the environment again
    KEEPS_STYLE = 4,    // a change leaves colours, lights and props as they are
    OF_FILES = 8,       // describes the files shown: a window drops it with them
    OF_ONE_VIEW = 16,   // data sets, which have many views, have options of their own for it
    OF_ALL_VIEWS = 32   // of outputs, and data sets take it too
  };

  bool Repeats = false;
  std::string Missing;    // the message if it is missing; "": optional
  bool OfOutputs = false; // concerns outputs, not the scene
  std::string Sets;       // stage parameters that it sets: "shadows:map_size", "tone", "any"

  // Whether it also switches the stage: its words are `off` and the choices of the parameter in
  // Sets.
  bool IsSwitch = false;

  unsigned Traits = 0;
  std::string Dropped;     // its value in the message of a window that drops it; "": not mentioned
  std::string NotWithLens; // why a lens cannot take it; "": it can

  // The panel of a window and its label there; "": none. A panel that has no control of its own for
  // the option adds one.
  std::string Panel, Label;
  bool HasOwnControl = false;

  bool Has(Trait trait) const { return (this->Traits & trait) != 0; }

  ///@{
  // For a row: each returns the option.
  vtkRelievoOption& Is(unsigned traits);
  vtkRelievoOption& DropAs(const std::string& value);
  vtkRelievoOption& RefuseLens(const std::string& reason);
  vtkRelievoOption& ShowIn(const std::string& panel, const std::string& label);  // adds a control
  vtkRelievoOption& NamedIn(const std::string& panel, const std::string& label); // has a control
  ///@}

  // The option and the value that it implies: "--shadows", "map"; empty: none.
  std::vector<std::string> Implies;

  // The stage and the parameter in Sets.
  std::string GetStage() const { return this->Sets.substr(0, this->Sets.find(':')); }
  std::string GetParameter() const
  {
    const std::size_t colon = this->Sets.find(':');
    return colon == std::string::npos ? "" : this->Sets.substr(colon + 1);
  }

  struct Bounds
  {
    double Least = 0.0;
    double Most = 0.0;
    bool Open = false; // Least and Most are excluded
  };
  Bounds Range; // of a number; Least and Most equal: not described

  // Candidates for completion in shells: words, which may continue after a colon; and files, by
  // extensions such as "png|jpg", or "/" for folders.
  std::vector<std::string> Words;
  std::string Files;

  bool IsFlag() const { return this->Form.empty(); }

  // Name and form: "--seed N".
  std::string GetUse() const { return this->Name + (this->IsFlag() ? "" : " " + this->Form); }

  // An option that sets a parameter: "--width W" for "tunnel_width". The help contains its bounds
  // and its present value, the default.
  static vtkRelievoOption Of(const vtkRelievoParameter& parameter, const std::string& use);
};

// "a, b or c".
VTKRELIEVODESCRIBE_EXPORT std::string vtkRelievoEither(const std::vector<std::string>& words);

struct VTKRELIEVODESCRIBE_EXPORT vtkRelievoCommand
{
  std::string Name;
  std::string Use;       // the arguments after the name and before required options: "FILE..."
  std::string About;     // a paragraph, which begins with the name
  std::string AboutFile; // kinds of FILE; "": not mentioned
  std::string Files;     // extensions of the input files, for completion: "vtp|stl"
  std::vector<vtkRelievoOption> Options;

  const vtkRelievoOption* Find(const std::string& option) const;

  // The usage line: "sun FILE... --place LATITUDE,LONGITUDE -o FILE.vtp [options]".
  std::string GetUse() const;

  // The command's part of the help: its description, and each option.
  std::string GetHelp() const;

  // For completion, a line for its files (command, a dot, extensions or `none`), and one for each
  // option: command, option, kind of value (`flag`, `value`, extensions, or / for folders), words.
  std::string GetWords() const;
};

#endif
