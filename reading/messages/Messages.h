// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Collects VTK's messages, so that each appears once, in one line, with the file's name; VTK's own
 * text names source files and addresses, which do not help a user.
 */
#ifndef Messages_h
#define Messages_h

#include "ReadingNames.h"

#include <string>
#include <vector>

namespace reading
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

  /// Throws WorkError("SUBJECT: VTK's message") if there were errors since the last call, or if
  /// `failed`; `otherwise` replaces a missing message. Warnings are stored with the subject.
  static void Check(
    const std::string& subject, bool failed = false, const std::string& otherwise = "");

  /// VTK's warnings since the last call, each one line with the subject.
  static std::vector<std::string> TakeWarningsOn(const std::string& subject);

  /// Whether this text of VTK reports a lack of memory.
  static bool TellsOfMemory(const std::string& text);

  /// Stores a note for the user, one line.
  static void Note(const std::string& text);

  /// The notes so far, each once.
  static std::vector<std::string> TakeNotes();

  /// Stores a warning, one line that names its subject.
  static void Warn(const std::string& text);

  /// The warnings so far, each one line, without VTK's preamble.
  static std::vector<std::string> TakeWarnings();
};
}

#endif
