// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRInput.h
 * @brief Reads an EXR file into arrays. Methods throw Failure, Aborted or OpenEXR's exceptions.
 */
#ifndef vtkRelievoEXRInput_h
#define vtkRelievoEXRInput_h

#include "vtkRelievoEXRChannels.h"
#include "vtkRelievoEXRStream.h"
#include "vtkSmartPointer.h"

#include <Imath/ImathBox.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPixelType.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkFieldData;
class vtkPointData;

namespace relievo::exr
{
class Input
{
public:
  /**
   * A part, as described by its header. Type: scanlineimage, tiledimage, deepscanline, deeptile.
   */
  struct Part
  {
    std::string Name;
    std::string Type;
  };

  /** A channel of the chosen parts. Name: as in the file, or PART.NAME if two parts have it. */
  struct Channel
  {
    std::string Name;
    std::string NameInPart;
    int Part;
    Imf::PixelType Type;
    bool Subsampled;
  };

  /** Opens the file and reads its headers; no pixels, and no memory beyond the headers' size. */
  explicit Input(const std::string& fileName);

  const std::vector<Part>& GetParts() const { return this->Parts; }

  /** Chooses one part, or with -1 all of them, which must have the same data window. */
  void ChoosePart(int part);
  const std::vector<Channel>& GetChannels() const { return this->Channels; }

  /** Chooses channels by their indices, and groups them into arrays. */
  void ChooseChannels(const std::vector<int>& channels);
  const std::vector<ArrayLayout>& GetArrays() const { return this->Arrays; }

  /** Windows of the chosen parts, in pixels of the file: y down. */
  Imath::Box2i GetDataWindow() const { return this->GetHeader().dataWindow(); }
  Imath::Box2i GetDisplayWindow() const { return this->GetHeader().displayWindow(); }

  /** Reads the chosen channels. `progress` takes 0 to 1 and returns false to stop. */
  void Read(vtkPointData* points, const std::function<bool(double)>& progress);

  /** Header of the first of the chosen parts. */
  const Imf::Header& GetHeader() const { return this->File->header(this->ChosenParts.front()); }

private:
  InputStream Stream;
  std::unique_ptr<Imf::MultiPartInputFile> File;
  std::vector<Part> Parts;
  std::vector<int> ChosenParts;
  std::vector<Channel> Channels;
  std::vector<int> ChosenChannels; // ArrayLayout::Channels are indices into these
  std::vector<ArrayLayout> Arrays;

  int GetBlockLines(uint64_t width) const;
  void DecodeBlock(const std::vector<vtkSmartPointer<vtkDataArray>>& arrays,
    const std::vector<std::unique_ptr<char[]>>& pixels, int firstLine, int lastLine) const;
};
}

#endif
