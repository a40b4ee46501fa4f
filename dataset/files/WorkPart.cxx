// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorkPart.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "Values.h"

#include "vtkRelievoShare.h"

#include <cstdlib>
#include <limits>
#include <vector>

namespace dataset
{
namespace
{
// A variable of a job array of Slurm.
int ReadSlurm(const std::string& option, const char* variable)
{
  const char* text = std::getenv(variable);
  if (!text)
  {
    throw UsageError(option + ": got slurm, but " + variable +
      " is not set; start this as a job of an array, by sbatch --array=1-N");
  }
  return ParseWhole(option + " slurm: " + variable, text, 0, std::numeric_limits<int>::max());
}
}

//------------------------------------------------------------------------------
WorkPart WorkPart::Parse(const std::string& option, const std::string& word)
{
  WorkPart part;
  if (word == "slurm")
  {
    const int id = ReadSlurm(option, "SLURM_ARRAY_TASK_ID");
    const int first = ReadSlurm(option, "SLURM_ARRAY_TASK_MIN");
    const int last = ReadSlurm(option, "SLURM_ARRAY_TASK_MAX");
    const int step = ReadSlurm(option, "SLURM_ARRAY_TASK_STEP");
    if (step < 1 || first > id || id > last || (id - first) % step != 0)
    {
      throw UsageError(option + ": got slurm with the task " + std::to_string(id) + " of " +
        std::to_string(first) + " to " + std::to_string(last) + " by " + std::to_string(step) +
        ", expected a task of its array");
    }
    part.Number = (id - first) / step + 1;
    part.Count = (last - first) / step + 1;
    if (ReadSlurm(option, "SLURM_ARRAY_TASK_COUNT") != part.Count)
    {
      throw UsageError(option + ": got slurm, but the array has gaps; repeat failed tasks with " +
        option + " K/N");
    }
    return part;
  }
  const std::vector<std::string> numbers = Split(word, '/');
  if (numbers.size() != 2)
  {
    RefuseValue(option, word, "K/N, part K of N from 1, such as 3/8, or slurm");
  }
  part.Count = ParseWhole(option + " " + word, numbers[1], 1, std::numeric_limits<int>::max());
  part.Number = ParseWhole(option + " " + word, numbers[0], 1, part.Count);
  return part;
}

//------------------------------------------------------------------------------
std::array<std::int64_t, 2> WorkPart::GetRange(std::int64_t all) const
{
  return vtkRelievoShare(this->Number, this->Count, all);
}

//------------------------------------------------------------------------------
std::string WorkPart::GetText() const
{
  return "part " + std::to_string(this->Number) + " of " + std::to_string(this->Count);
}

//------------------------------------------------------------------------------
std::string WorkPart::GetStem() const
{
  return "part-" + WriteDatasetNumber(static_cast<std::size_t>(this->Number));
}
}
