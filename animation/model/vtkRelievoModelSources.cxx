// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelSources.h"

#include "vtkRelievoReaderProcess.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace relievo
{
//------------------------------------------------------------------------------
void ModelSources::Add(const std::string& path)
{
  const auto [added, isNew] = this->States.emplace(path, Look(path));
  if (isNew)
  {
    this->Paths.push_back(path);
    vtkRelievoReaderProcess::Allow(added->second.Size);
  }
}

//------------------------------------------------------------------------------
bool ModelSources::AreSame() const
{
  return std::all_of(this->States.begin(), this->States.end(), [](const auto& each) {
    const State now = Look(each.first);
    return now.Time == each.second.Time && now.Size == each.second.Size &&
      now.IsThere == each.second.IsThere;
  });
}

//------------------------------------------------------------------------------
ModelSources::State ModelSources::Look(const std::string& path)
{
  State state;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  state.IsThere = !error;
  if (state.IsThere)
  {
    state.Time = static_cast<std::int64_t>(time.time_since_epoch().count());
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    state.Size = error ? 0 : size; // folders have no size
  }
  return state;
}
}
