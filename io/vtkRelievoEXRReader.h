// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRelievoEXRReader
 * @brief   reads an OpenEXR file into an image with one point array per layer
 *
 * Reads scan-line and tiled files (of mip and rip maps the full-size level) with one or several
 * parts, any compression. Deep data and subsampled channels are refused.
 *
 * The output has one point per pixel of the file's data window, row 0 at the bottom, its extent
 * beginning at 0, spacing 1. Its origin is where the lower left pixel of the data window lies in
 * the display window, counted from that window's lower left pixel: (0, 0) unless the two differ.
 * Both windows are in the field data (`dataWindow`, `displayWindow`: min x, min y, max x, max y, y
 * down).
 *
 * Files of vtkRelievoEXRWriter give back the arrays they were made from: names, types, order, and
 * values bit for bit (what the pixel type had to round stays rounded). `position` is in world
 * coordinates again, in double: `relievo:origin` plus the float of the file. Ids are -1 where
 * nothing is. In other files `R G B [A]` become the float array `color`, `LAYER.R ...` and `LAYER.X
 * ...` become `LAYER`, and every other channel becomes an array of the channel's name; HALF and
 * FLOAT become float, UINT becomes unsigned int. `color`, or else the first array, is made the
 * active scalars. Attributes become field data; which ones is told in docs/exr.md.
 *
 * The image is whole: of several pieces that a pipeline asks for (one for each process), the first
 * is the image and the others are empty.
 *
 * When a file cannot be read there is one error message, which names the file, says what is wrong
 * and what to do; GetErrorCode() is set, and the output is empty until the reader is changed.
 * Setting AbortExecute from a progress observer stops reading without a message; the output is
 * empty and the code is vtkErrorCode::UserError.
 *
 * @sa vtkRelievoEXRWriter
 */
#ifndef vtkRelievoEXRReader_h
#define vtkRelievoEXRReader_h

#include "vtkRelievoIOModule.h" // for the export macro

#include "vtkImageAlgorithm.h"

#include <memory> // for the internals
#include <string> // for messages

class vtkDataArraySelection;

class VTKRELIEVOIO_EXPORT vtkRelievoEXRReader : public vtkImageAlgorithm
{
public:
  static vtkRelievoEXRReader* New();
  vtkTypeMacro(vtkRelievoEXRReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the file to read. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** 1 when the file's first bytes and headers are those of an OpenEXR file, else 0; no message. */
  virtual int CanReadFile(VTK_FILEPATH const char* fileName);

  /** Endings of the names of such files, and what such files are called. */
  virtual const char* GetFileExtensions() { return ".exr"; }
  virtual const char* GetDescriptiveName() { return "OpenEXR"; }

  ///@{
  /**
   * The part to read, from 0, or -1 for all parts; these must then have the same data window.
   * A channel whose name an earlier part has as well is called PART.CHANNEL. Default: -1.
   */
  vtkSetMacro(Part, int);
  vtkGetMacro(Part, int);
  ///@}

  ///@{
  /** What the file holds; after UpdateInformation(). Names are nullptr for indices out of range. */
  int GetNumberOfParts();
  const char* GetPartName(int part);
  const char* GetPartType(int part);
  ///@}

  ///@{
  /** Channels of the chosen part or parts; after UpdateInformation(). */
  int GetNumberOfChannels();
  const char* GetChannelName(int channel);
  ///@}

  /**
   * Pixel type of a channel as in vtkRelievoEXRWriter::PixelType (UINT 0, HALF 1, FLOAT 2), or -1.
   */
  int GetChannelPixelType(int channel);

  ///@{
  /** Arrays that the selected channels make up; after UpdateInformation(). */
  int GetNumberOfLayers();
  const char* GetLayerName(int layer);
  ///@}

  /** Which channels to read, by name; filled by UpdateInformation(). Default: all. */
  vtkDataArraySelection* GetChannelSelection();

  ///@{
  /** Threads that unpack the pixels, as vtkRelievoEXRWriter::NumberOfThreads. Default: 0. */
  vtkSetClampMacro(NumberOfThreads, int, 0, 64);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** Changes of the selection count as changes of the reader. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoEXRReader();
  ~vtkRelievoEXRReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkRelievoEXRReader(const vtkRelievoEXRReader&) = delete;
  void operator=(const vtkRelievoEXRReader&) = delete;

  void Report(unsigned long code, const std::string& message);

  struct Internals;
  std::unique_ptr<Internals> Self;
  char* FileName = nullptr;
  int Part = -1;
  int NumberOfThreads = 0;
};

#endif
