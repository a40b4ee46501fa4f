// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What reading files goes by, and what it leaves beside the data.
 */
#ifndef ReadContext_h
#define ReadContext_h

#include "vtkRelievoAllowedFolders.h"

#include <functional>
#include <string>
#include <vector>

namespace scene
{
class Progress;

class ReadContext
{
public:
  /// `folders`: where files may name others in, besides their own folders and below.
  explicit ReadContext(Progress& progress, std::vector<std::string> folders = {});

  /// Messages has the notes and warnings that nobody took.
  ~ReadContext();
  ReadContext(const ReadContext&) = delete;
  void operator=(const ReadContext&) = delete;

  Progress& GetProgress() { return this->Steps; }
  const std::vector<std::string>& GetFolders() const { return this->Folders; }

  /// Where the file at the path may name others in.
  vtkRelievoAllowedFolders GetAllowed(const std::string& path) const;

  /// As of Messages.
  void Check(const std::string& subject, bool failed = false, const std::string& otherwise = "");

  ///@{
  /// Keeps what the user should know, one line, once.
  void Note(const std::string& text);
  void Warn(const std::string& text);
  std::vector<std::string> TakeNotes();
  std::vector<std::string> TakeWarnings();
  ///@}

  ///@{
  /// Files that are read: those that the words name, and those that these name in turn, such as
  /// textures, buffers and pieces. No output may take the place of one. Nothing is added for a file
  /// that is not there.
  void AddFile(const std::string& path);
  const std::vector<std::string>& GetFiles() const { return this->Files; }
  ///@}

  ///@{
  /// Work that is done once, instead of waiting, when another process reads a file. It may be done
  /// never, and throws nothing.
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
