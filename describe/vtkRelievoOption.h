// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The options of a command, each described once, by what takes it: the parser, the help, the manual
// page, the completion of shells and Python's keywords are made from that.
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
  std::string Form; // what its value is called in the help: "N"; "": a flag, which stands alone
  std::string Help; // paragraphs, and lines of tables, which begin with blanks

  // Takes the value, which is empty of a flag. Returns what is wrong with it, such as "got 'x',
  // expected a number"; or throws what its command throws.
  std::function<std::string(const std::string& value)> Take;

  bool Repeats = false;
  std::string Missing;    // what is said where it is not given; "": it may be left out
  bool OfOutputs = false; // says what is written, and not what there is to see
  std::string Sets; // what of stages it says, as --stage does: "shadows:map_size", "tone", "any"

  // What shells complete: words, which go on behind a colon; and files, of extensions such as
  // "png|jpg", or "/", folders.
  std::vector<std::string> Words;
  std::string Files;

  bool IsFlag() const { return this->Form.empty(); }

  // Name and form: "--seed N".
  std::string GetUse() const { return this->Name + (this->IsFlag() ? "" : " " + this->Form); }

  // One that sets a parameter: "--width W" of "tunnel_width". The help has its bounds and its value
  // now, which is the default.
  static vtkRelievoOption Of(const vtkRelievoParameter& parameter, const std::string& use);
};

// "a, b or c".
VTKRELIEVODESCRIBE_EXPORT std::string vtkRelievoEither(const std::vector<std::string>& words);

struct VTKRELIEVODESCRIBE_EXPORT vtkRelievoCommand
{
  std::string Name;
  std::string Use;       // what stands behind the name, before the options that it needs: "FILE..."
  std::string About;     // a paragraph, which begins with the name
  std::string AboutFile; // what a FILE may be; "": nothing is said of it
  std::string Files;     // extensions of the files that it reads, for completion: "vtp|stl"
  std::vector<vtkRelievoOption> Options;

  const vtkRelievoOption* Find(const std::string& option) const;

  // How to call it: "sun FILE... --place LATITUDE,LONGITUDE -o FILE.vtp [options]".
  std::string GetUse() const;

  // Its part of the help: what it is about, and each option.
  std::string GetHelp() const;

  // For completion, a line for its files (command, a dot, extensions or `none`), and one for each
  // option: command, option, what it takes (`flag`, `value`, extensions, or / for folders), words.
  std::string GetWords() const;
};

#endif
