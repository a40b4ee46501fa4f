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
  /// A file as it is now, be it that it is not there. What was added first stays.
  void Add(const std::string& path);

  /// Whether all of them are as they were. A file that is written again within the resolution of
  /// the file system's times, and has the same size, looks the same.
  bool AreSame() const;

  /// All that were added, in this order.
  const std::vector<std::string>& GetPaths() const { return this->Paths; }

private:
  template <typename Visit>
  friend void VisitFields(ModelSources& sources, Visit&& visit)
  {
    visit(sources.States, sources.Paths);
  }

  struct State
  {
    std::int64_t Time = 0; // in the file system's own steps, which are finer than seconds
    std::uintmax_t Size = 0;
    bool IsThere = false;
  };

  static State Look(const std::string& path);

  std::map<std::string, State> States;
  std::vector<std::string> Paths;
};
}

#endif
