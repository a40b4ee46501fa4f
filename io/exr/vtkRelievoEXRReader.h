// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRelievoEXRReader
 * @brief   reads an OpenEXR file into an image with one point array per layer
 *
 * It reads scan-line and tiled files (the full-size level of mip and rip maps) with one or several
 * parts and any compression. Deep data and subsampled channels are refused.
 *
 * The output has one point per pixel of the file's data window, row 0 at the bottom, an extent that
 * begins at 0, and spacing 1. Its origin is the position of the data window's lower left pixel in
 * the display window, from that window's lower left pixel: (0, 0) unless the two differ.
 * Both windows are in the field data (`dataWindow`, `displayWindow`: min x, min y, max x, max y, y
 * down).
 *
 * Files of vtkRelievoEXRWriter give back the arrays that they were made from: names, types, order,
 * and values bit for bit (except for rounding by the pixel type). `position` is again in world
 * coordinates, in double: `relievo:origin` plus the float in the file. Ids are -1 in the
 * background. In other files `R G B [A]` become the float array `color`, `LAYER.R ...` and `LAYER.X
 * ...` become `LAYER`, and every other channel becomes an array of the channel's name; HALF and
 * FLOAT become float, UINT becomes unsigned int. `color`, or else the first array, is made the
 * active scalars. Attributes become field data; docs/exr.md lists them.
 *
 * The image is not divided: if a pipeline requests several pieces (one for each process), the first
 * one is the image and the others are empty.
 *
 * If a file cannot be read, one error message names the file and says what is wrong and what to do;
 * GetErrorCode() is set, and the output is empty until the reader is changed.
 * Setting AbortExecute from a progress observer stops reading without a message; the output is
 * empty and the code is vtkErrorCode::UserError.
 *
 * @sa vtkRelievoEXRWriter
 */
#ifndef vtkRelievoEXRReader_h
#define vtkRelievoEXRReader_h

#include "vtkRelievoIOModule.h" // for the export macro

#include "vtkImageAlgorithm.h"
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

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

  /** 1 if the file begins like an OpenEXR file and has its headers, otherwise 0; no message. */
  virtual int CanReadFile(VTK_FILEPATH const char* fileName);

  /** File name extension and name of the format. */
  virtual const char* GetFileExtensions() { return ".exr"; }
  virtual const char* GetDescriptiveName() { return "OpenEXR"; }

  ///@{
  /**
   * The part to read, from 0, or -1 for all parts, which must then have the same data window. A
   * channel whose name an earlier part also has is named PART.CHANNEL. Default: -1.
   */
  vtkSetMacro(Part, int);
  vtkGetMacro(Part, int);
  ///@}

  ///@{
  /** Parts of the file, after UpdateInformation(). Names are nullptr for invalid indices. */
  int GetNumberOfParts();
  const char* GetPartName(int part);
  const char* GetPartType(int part);
  ///@}

  ///@{
  /** Channels of the selected part or parts, after UpdateInformation(). */
  int GetNumberOfChannels();
  const char* GetChannelName(int channel);
  ///@}

  /**
   * Pixel type of a channel as in vtkRelievoEXRWriter::PixelType (UINT 0, HALF 1, FLOAT 2), or -1.
   */
  int GetChannelPixelType(int channel);

  ///@{
  /** Arrays made from the selected channels, after UpdateInformation(). */
  int GetNumberOfLayers();
  const char* GetLayerName(int layer);
  ///@}

  /** The channels to read, by name; filled by UpdateInformation(). Default: all. */
  vtkDataArraySelection* GetChannelSelection();

  ///@{
  /** Threads that unpack pixels, 0 to 64; see vtkRelievoEXRWriter. Default: 0. */
  vtkSetClampMacro(NumberOfThreads, int, 0, 64);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** The parameter `part` by its name. */
  vtkRelievoParametersMacro();

  /** Includes changes of the channel selection. */
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
  std::unique_ptr<Internals> Internal;
  vtkRelievoParameterList Parameters;
  char* FileName = nullptr;
  int Part = -1;
  int NumberOfThreads = 0;
};

#endif
