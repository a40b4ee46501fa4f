// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Collects what VTK would print, so that each thing is said once, in one line, with the file's
 * name; VTK's own text names source files and addresses, which tell a user nothing.
 */
#ifndef Messages_h
#define Messages_h

#include <string>
#include <vector>

namespace scene
{
class Messages
{
public:
  /// While one lives, VTK's errors and warnings are collected.
  class Scope
  {
  public:
    Scope();
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;
  };

  /// Throws WorkError("SUBJECT: what VTK said") if there were errors since the last call, or if
  /// `failed`; `otherwise` is said where VTK has no words. Warnings are kept, with the subject.
  static void Check(
    const std::string& subject, bool failed = false, const std::string& otherwise = "");

  /// VTK's warnings since the last call, each one line with the subject.
  static std::vector<std::string> TakeWarningsOn(const std::string& subject);

  /// Whether VTK says in this text that it did not get memory.
  static bool TellsOfMemory(const std::string& text);

  /// Keeps what the user should know of what was done, one line.
  static void Note(const std::string& text);

  /// The notes so far, each once.
  static std::vector<std::string> TakeNotes();

  /// Keeps a warning, one line that names what it is about.
  static void Warn(const std::string& text);

  /// The warnings so far, each one line, without VTK's preamble.
  static std::vector<std::string> TakeWarnings();
};
}

#endif
