// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// relievo-compare-images: the image comparator of the tests, for scripts.
#include "ImageCompare.h"

#include <vtkImageData.h>

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
const char* const Usage =
  "usage: relievo-compare-images ACTUAL.png EXPECTED.png [--max-share S] [--threshold T]\n"
  "         [--mean M] [--output FOLDER]\n"
  "  --max-share  share of pixels, 0 to 1, that may differ by more than T (default 0.001)\n"
  "  --threshold  levels of 255 that a channel may differ by (default 5)\n"
  "  --mean       largest mean absolute difference in levels of 255 (default 0.5)\n"
  "  --output     where NAME.actual.png, .expected.png and .difference.png go when they differ\n"
  "Exit status: 0 the same, 1 different, 2 wrong words or an unreadable file.\n";

int Refuse(const std::string& message)
{
  std::cerr << "relievo-compare-images: " << message << "\n" << Usage;
  return 2;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  relievoTest::ImageLimits limits;
  std::string folder;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "-h" || word == "--help")
    {
      std::cout << Usage;
      return 0;
    }
    if (word.empty() || word[0] != '-')
    {
      files.push_back(word);
      continue;
    }
    const bool isNumber = word == "--max-share" || word == "--threshold" || word == "--mean";
    if (!isNumber && word != "--output")
    {
      return Refuse("unknown option '" + word + "'");
    }
    if (++i == argc)
    {
      return Refuse("option '" + word + "' lacks its value");
    }
    if (!isNumber)
    {
      folder = argv[i];
      continue;
    }
    char* end = nullptr;
    const double value = std::strtod(argv[i], &end);
    const int largest = word == "--max-share" ? 1 : 255;
    if (end == argv[i] || *end != '\0' || !(value >= 0. && value <= largest))
    {
      return Refuse("option '" + word + "' takes a number from 0 to " + std::to_string(largest) +
        ", not '" + argv[i] + "'");
    }
    if (word == "--max-share")
    {
      limits.MaxShare = value;
    }
    else if (word == "--mean")
    {
      limits.MaxMean = value;
    }
    else
    {
      limits.Threshold = static_cast<int>(value);
    }
  }
  if (files.size() != 2)
  {
    return Refuse("two images are needed");
  }
  vtkSmartPointer<vtkImageData> images[2];
  for (int i = 0; i < 2; ++i)
  {
    std::string reason;
    images[i] = relievoTest::ReadImage(files[i], &reason);
    if (!images[i])
    {
      return Refuse(reason);
    }
  }
  const std::string name = vtksys::SystemTools::GetFilenameWithoutLastExtension(files[0]);
  const relievoTest::ImageDifference result = folder.empty()
    ? relievoTest::CompareImages(images[0], images[1], limits)
    : relievoTest::CompareAndReport(name, images[0], images[1], folder, limits);
  (result.Passed ? std::cout : std::cerr) << result.Summary << "\n";
  return result.Passed ? 0 : 1;
}
