// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageCompare.h
 * @brief Compares two 8-bit images, and an image with its baseline on disk.
 *
 * Two limits hold at once: the share of pixels that differ by more than a threshold in any channel,
 * and the mean absolute difference. (VTK 9.1's and 9.2's vtkImageDifference forgives 105/255 and a
 * shift of two pixels, so it misses shading errors.)
 *
 * Baselines are NAME.png in the folder RELIEVO_BASELINES (tests/baselines). To make or renew one:
 * run the test, look at NAME.actual.png in the test's output folder, then build the target
 * `update-baselines`, which copies every *.actual.png of failed comparisons there.
 */
#ifndef relievoTestImageCompare_h
#define relievoTestImageCompare_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;

namespace relievoTest
{
/** Differences up to which two images count as equal. */
struct ImageLimits
{
  /** Share of pixels, in [0, 1], that may differ by more than Threshold in any channel. */
  double MaxShare = 0.001;
  /** Difference of a channel, in levels of 255, up to which a pixel does not count. */
  int Threshold = 5;
  /** Mean absolute difference over all pixels and channels, in levels of 255. */
  double MaxMean = 0.5;
};

/** The difference of two images. */
struct ImageDifference
{
  /** False if the images cannot be compared; Summary gives the reason. */
  bool Comparable = false;
  /** Whether both limits hold. */
  bool Passed = false;
  /** Number and share of pixels above the threshold. */
  long long Pixels = 0;
  double Share = 1.;
  /** Mean and largest absolute difference of a channel, in levels of 255. */
  double Mean = 255.;
  int Largest = 255;
  /** One line for the log. */
  std::string Summary;
};

/**
 * Compares two images of unsigned char with 3 or 4 components and one slice; a missing alpha
 * counts as 255. Null, empty, other types and sizes that differ are not comparable: failed.
 */
ImageDifference CompareImages(
  vtkImageData* actual, vtkImageData* expected, const ImageLimits& limits = ImageLimits());

/**
 * The absolute difference times 10, clamped to 255, as RGB: a difference of 26 levels is white.
 * Null if the sizes or types cannot be compared.
 */
vtkSmartPointer<vtkImageData> TenfoldDifference(vtkImageData* actual, vtkImageData* expected);

/**
 * Reads a PNG of 8 bits per channel with 3 or 4 channels. Null if the file is missing or of another
 * kind; `reason`, if given, gets the reason.
 */
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, std::string* reason = nullptr);

/** Whether two pictures have the same bytes. */
bool IsSame(vtkImageData* a, vtkImageData* b);

/** Writes a PNG; false on failure. */
bool WriteImage(const std::string& path, vtkImageData* image);

/**
 * Compares `actual` with `expected`. If they differ, writes NAME.actual.png, NAME.expected.png and
 * NAME.difference.png into `folder`; otherwise removes those of an earlier run.
 */
ImageDifference CompareAndReport(const std::string& name, vtkImageData* actual,
  vtkImageData* expected, const std::string& folder, const ImageLimits& limits = ImageLimits());

/**
 * Compares `actual` with the baseline NAME.png and prints one line. A failure, including a missing
 * baseline, counts as a failed check of the test and leaves its pictures in OutputFolder().
 */
bool CheckBaseline(
  const std::string& name, vtkImageData* actual, const ImageLimits& limits = ImageLimits());
}

#endif
