// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXROutput.h
 * @brief Writes an image to an EXR file: assigns arrays to channels, and writes the pixels.
 *
 * The methods throw Failure, Aborted or OpenEXR's exceptions.
 */
#ifndef vtkRelievoEXROutput_h
#define vtkRelievoEXROutput_h

#include "vtkRelievoEXRConvert.h"
#include "vtkSmartPointer.h"

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace relievo::exr
{
class Output
{
public:
  /** The user's settings. */
  struct Settings
  {
    Imf::Compression Compression = Imf::ZIP_COMPRESSION;
    float DWALevel = 45;
    std::map<std::string, Imf::PixelType> PixelTypes; // by name of array or channel
    std::map<std::string, std::string> Strings;
    std::map<std::string, double> Doubles;
  };

  using Progress = std::function<bool(double)>; // takes 0 to 1, and returns false to stop

  /**
   * Plans a file of `height` lines with the arrays and the field data of the image, which may have
   * fewer; throws Failure if the image or the settings do not fit the format.
   */
  Output(vtkImageData* image, const Settings& settings, int height);

  /** Begins the file; the stream must outlive the lines. */
  void Begin(Imf::OStream& stream);

  /**
   * Writes the next lines, from the top: `count` rows of the image, of which `lowest` is the lowest
   * one. The image has the arrays of the plan.
   */
  void WriteRows(vtkImageData* image, int lowest, int count, const Progress& progress);

  /** Whether all lines are written. */
  bool IsComplete() const;

  /** Completes the file. Returns losses that the user may not expect; empty if there were none. */
  std::string End();

private:
  struct Channel
  {
    std::string Name;
    Imf::PixelType Type;
    Component Source;
    Losses Lost;
  };

  Imf::Header Header;
  std::vector<Channel> Channels;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; // of the present rows
  std::vector<std::string> Record;                   // of the arrays
  std::string Warning;
  std::unique_ptr<Imf::OutputFile> File;
  std::vector<std::unique_ptr<char[]>> Pixels; // of a block of lines, by channel
  int BlockLines = 0;
  int Next = 0; // line

  void PlanWindows(vtkImageData* image, int height);
  void PlanArrays(vtkImageData* image, const Settings& settings);
  void PlanArray(vtkDataArray* array, const Settings& settings, const double origin[3]);
  void TakeArrays(vtkImageData* image);
  void EncodeBlock(int lines, int topRow);
  void CheckLosses(const Channel& channel) const;
  void Warn();
};
}

#endif
