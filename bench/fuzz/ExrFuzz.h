// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExrFuzz.h
 * @brief Reads damaged files through vtkRelievoEXRReader and checks its guarantees.
 */
#ifndef ExrFuzz_h
#define ExrFuzz_h

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace exrFuzz
{
struct Result
{
  uint64_t Read = 0;
  uint64_t Refused = 0;
  std::map<unsigned long, uint64_t> RefusedByCode; // vtkErrorCode
  std::vector<std::string> Faults;                 // broken guarantees, with the number of the file
  double SlowestSeconds = 0;
  uint64_t Slowest = 0; // the number of the slowest file
};

/**
 * Makes the damaged files `first` to `first + count - 1` and reads each. A file that is read must
 * give no error, code 0, and arrays of one tuple per pixel; one that is refused exactly one error
 * that names the file, a code other than UnknownError, and an empty output. Every 16th picture that
 * was read is written again. A file that takes more than `limitSeconds` is a fault too.
 * \param folder    Where the files are written, one after the other; the last one stays.
 * \param progress  Called after every file with the number of files done.
 */
Result Run(uint64_t first, uint64_t count, const std::string& folder, double limitSeconds,
  const std::function<void(uint64_t)>& progress);
}

#endif
