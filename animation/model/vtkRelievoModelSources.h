// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files that a model was read from: its own, and those that it names.
 */
#ifndef vtkRelievoModelSources_h
#define vtkRelievoModelSources_h

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace relievo
{
class ModelSources
{
public:
  /// Adds the current state of a file, which may be missing. The first state added is kept.
  void Add(const std::string& path);

  /// Whether all files are unchanged. A file written again within the resolution of the file
  /// system's times, with the same size, counts as unchanged.
  bool AreSame() const;

  /// All added paths, in order.
  const std::vector<std::string>& GetPaths() const { return this->Paths; }

private:
  template <typename Visit>
  friend void VisitFields(ModelSources& sources, Visit&& visit)
  {
    visit(sources.States, sources.Paths);
  }

  struct State
  {
    std::int64_t Time = 0; // in the file system's own units, which are finer than seconds
    std::uintmax_t Size = 0;
    bool IsThere = false;
  };

  static State Look(const std::string& path);

  std::map<std::string, State> States;
  std::vector<std::string> Paths;
};
}

#endif
