// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// relievo-fuzz-exr [COUNT [FIRST]]: reads COUNT (default 100000) damaged EXR files, always the same
// ones, from number FIRST (default 0) on. Exit: 0 no fault, 1 faults, 2 wrong arguments.
// `relievo-fuzz-exr 1 4711` reads only file 4711 and leaves it in the folder that it names.
#include "ExrFuzz.h"

#include <vtkErrorCode.h>

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

// Read by sanitizers at start. Allocations are limited to 1 GiB: a header of a few bytes must not
// make us ask for more. GNU's and LLVM's runtimes both use this name.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options()
{
  return "max_allocation_size_mb=1024:allocator_may_return_null=0:detect_leaks=1";
}

namespace
{
bool ParseNumber(const char* word, uint64_t& number)
{
  char* end = nullptr;
  number = std::strtoull(word, &end, 10);
  return end != word && *end == '\0' && *word != '-';
}
}

int main(int argc, char* argv[])
{
  uint64_t count = 100000;
  uint64_t first = 0;
  if (argc > 3 || (argc > 1 && !ParseNumber(argv[1], count)) ||
    (argc > 2 && !ParseNumber(argv[2], first)))
  {
    std::cerr << "usage: relievo-fuzz-exr [COUNT [FIRST]], both whole numbers\n";
    return 2;
  }
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("relievo-fuzz-exr-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto start = std::chrono::steady_clock::now();
  const exrFuzz::Result result =
    exrFuzz::Run(first, count, folder.string(), 10.0, [&](uint64_t done) {
      if (done % 1000 == 0 || done == count)
      {
        std::cerr << "\r" << done << " of " << count << " files" << std::flush;
      }
    });
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cerr << "\n";
  std::cout << count << " damaged files in " << seconds << " s: " << result.Read << " read, "
            << result.Refused << " refused\n";
  for (const auto& code : result.RefusedByCode)
  {
    std::cout << "  " << vtkErrorCode::GetStringFromErrorCode(code.first) << ": " << code.second
              << "\n";
  }
  std::cout << "slowest: file " << result.Slowest << ", " << result.SlowestSeconds << " s\n";
  for (const std::string& fault : result.Faults)
  {
    std::cout << "FAULT: " << fault << "\n";
  }
  if (count == 1)
  {
    std::cout << "the file is " << (folder / "damaged.exr").string() << "\n";
  }
  else
  {
    std::filesystem::remove_all(folder);
  }
  return result.Faults.empty() ? 0 : 1;
}
