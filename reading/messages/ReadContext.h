// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The settings for reading files, and the messages and file names that reading collects.
 */
#ifndef ReadContext_h
#define ReadContext_h

#include "ReadingNames.h"
#include "vtkRelievoAllowedFolders.h"

#include <functional>
#include <string>
#include <vector>

namespace reading
{
class Progress;

class ReadContext
{
public:
  /// `folders`: allowed folders of files that files name, besides their own folders and below.
  explicit ReadContext(Progress& progress, std::vector<std::string> folders = {});

  /// Passes notes and warnings that were not taken to Messages.
  ~ReadContext();
  ReadContext(const ReadContext&) = delete;
  void operator=(const ReadContext&) = delete;

  Progress& GetProgress() { return this->Steps; }
  const std::vector<std::string>& GetFolders() const { return this->Folders; }

  /// The folders of files that the file at the path may name.
  vtkRelievoAllowedFolders GetAllowed(const std::string& path) const;

  /// Like Messages::Check.
  void Check(const std::string& subject, bool failed = false, const std::string& otherwise = "");

  ///@{
  /// Stores a note or a warning for the user, one line, once.
  void Note(const std::string& text);
  void Warn(const std::string& text);
  std::vector<std::string> TakeNotes();
  std::vector<std::string> TakeWarnings();
  ///@}

  ///@{
  /// The files opened while reading: those named by the words, and those that these name in turn,
  /// such as textures, buffers and pieces. No output may replace one. Adding a missing file does
  /// nothing.
  void AddFile(const std::string& path);
  const std::vector<std::string>& GetFiles() const { return this->Files; }
  ///@}

  ///@{
  /// Work for this thread while another process reads a file for it, instead of waiting; done once.
  /// The work may never run, and must not throw.
  void SetMeanwhile(std::function<void()> work) { this->Meanwhile = std::move(work); }
  void DoMeanwhile();
  ///@}

private:
  Progress& Steps;
  std::vector<std::string> Folders, Notes, Warnings, Files;
  std::function<void()> Meanwhile;
};
}

#endif
