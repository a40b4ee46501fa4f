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

  /** Plans the file; throws Failure if the image or the settings do not fit the format. */
  Output(vtkImageData* image, const Settings& settings);

  /** Writes the file. `progress` takes 0 to 1 and returns false to stop. */
  void Write(Imf::OStream& stream, const std::function<bool(double)>& progress);

  /** After Write(): losses that the user may not expect; empty if there were none. */
  const std::string& GetWarning() const { return this->Warning; }

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
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::string Warning;

  void PlanWindows(vtkImageData* image);
  void PlanArrays(vtkImageData* image, const Settings& settings);
  void PlanArray(vtkDataArray* array, const Settings& settings, const double origin[3]);
  void EncodeBlock(const std::vector<std::unique_ptr<char[]>>& pixels, int firstLine, int lastLine);
  void CheckLosses(const Channel& channel) const;
  void Warn();
};
}

#endif
