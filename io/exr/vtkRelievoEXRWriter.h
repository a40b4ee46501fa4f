// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRelievoEXRWriter
 * @brief   writes an image's point arrays to an OpenEXR file, one layer per array
 *
 * The input is a vtkImageData of W x H x 1 points, row 0 at the bottom; the file has one part of
 * scan lines, the top line first. Every point array is written:
 *
 * | array                            | channels                              |
 * |----------------------------------|---------------------------------------|
 * | color, 3 or 4 components         | R G B [A] (linear light)              |
 * | albedo, 3 or 4 components        | albedo.R albedo.G albedo.B [albedo.A] |
 * | depth, range                     | depth.Z, range.Z                      |
 * | actor, block, cell (integers)    | actor.id, block.id, cell.id           |
 * | any other NAME, 1 component      | NAME.V                                |
 * | 2 or 3 components                | NAME.X NAME.Y [NAME.Z]                |
 * | 4 or more components             | NAME.0 NAME.1 NAME.2 NAME.3 ...       |
 *
 * Unless SetPixelType says otherwise, float and double become FLOAT, integers become UINT (-1
 * becomes 0xFFFFFFFF), and the bytes of `albedo` and `color` become HALF as v / 255 (from which
 * each byte can be recovered). float, integers of up to 32 bits and those bytes are read back bit
 * for bit, including infinities and NaNs; double is rounded to float. `position` of type double is
 * written relative to the field data's `relievo:origin`; without one, the middle of the positions
 * is used if floats cannot hold them. `origin + float` is read back bit for bit.
 *
 * Field data becomes attributes: worldToCamera, worldToNDC, near, far, relievo:origin, lights, and
 * strings and small vectors of any name; see docs/exr.md for names, types and conventions.
 *
 * The file is written under a temporary name in its folder and renamed when it is complete. If
 * anything fails, one error message names the file, GetErrorCode() is set, no partial file is left,
 * and a file that was there before is untouched. Setting AbortExecute from a progress observer
 * stops writing in the same way, without a message; the code is then vtkErrorCode::UserError.
 *
 * @sa vtkRelievoEXRReader
 */
#ifndef vtkRelievoEXRWriter_h
#define vtkRelievoEXRWriter_h

#include "vtkRelievoIOModule.h" // for the export macro

#include "vtkImageAlgorithm.h"
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for the internals

class vtkImageData;

class VTKRELIEVOIO_EXPORT vtkRelievoEXRWriter : public vtkImageAlgorithm
{
public:
  static vtkRelievoEXRWriter* New();
  vtkTypeMacro(vtkRelievoEXRWriter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Types of a channel's pixels. */
  enum PixelType
  {
    UINT = 0,
    HALF = 1,
    FLOAT = 2
  };

  /**
   * Compression of pixels. NO_COMPRESSION, RLE, ZIPS (line by line), ZIP (16 lines) and PIZ (32
   * lines) are lossless. PXR24 rounds FLOAT to 24 bits. B44 and B44A lose accuracy in HALF. DWAA
   * and DWAB lose accuracy in channels named R, G, B or Y of any layer, including normal.Y and
   * position.Y, and the writer warns about it. Except with PXR24, infinities and NaN in channels
   * that lose accuracy would be read back as numbers: Write() refuses them. DWA clamps numbers
   * beyond 65504 to that, with a warning.
   */
  enum CompressionType
  {
    NO_COMPRESSION = 0,
    RLE,
    ZIPS,
    ZIP,
    PIZ,
    PXR24,
    B44,
    B44A,
    DWAA,
    DWAB
  };

  ///@{
  /** Name of the file to write. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** One of CompressionType; other values are refused with an error. Default: ZIP. */
  virtual void SetCompression(int compression);
  vtkGetMacro(Compression, int);
  ///@}

  /**
   * The compression by its name in lower case: none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa,
   * dwab. Returns false, with an error, for other names.
   */
  virtual bool SetCompressionByName(const char* name);
  const char* GetCompressionName();

  ///@{
  /** Loss allowed for DWAA and DWAB, 0 (almost none) to 100000. Default: 45. */
  vtkSetClampMacro(DWALevel, double, 0.0, 100000.0);
  vtkGetMacro(DWALevel, double);
  ///@}

  ///@{
  /**
   * Pixel type of the channels of an array (`normal`), or of one channel (`normal.X`). Integers may
   * be HALF or FLOAT only if these hold them exactly, and float or double may not be UINT; Write()
   * refuses both. Values beyond the range of HALF become infinite, with a warning.
   */
  virtual void SetPixelType(const char* name, int type);
  virtual void RemoveAllPixelTypes();
  ///@}

  /** The pixel type set for this name, or -1. */
  virtual int GetPixelType(const char* name);

  ///@{
  /**
   * Attributes in addition to those from the field data. Names that the format or Relievo
   * uses are refused with an error; docs/exr.md lists them.
   */
  virtual void SetStringAttribute(const char* name, const char* value);
  virtual void SetDoubleAttribute(const char* name, double value);
  virtual void RemoveAllAttributes();
  ///@}

  ///@{
  /**
   * Threads that pack pixels, 0 to 64. They belong to OpenEXR and so to the whole process: from
   * then on every reader and writer has at least as many. 0 starts none. A process that is forked
   * (Python's multiprocessing on Linux) after they were started cannot use them and would wait
   * forever, so they are started only on request. Default: 0.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 64);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** The parameter `compression` by its name. */
  vtkRelievoParametersMacro();

  /** Writes the file. Returns 1, or 0 after an error or an abort. */
  virtual int Write();

  /**
   * Writes a picture in parts: `count` rows of the image, of which `lowest` is the lowest one, are
   * the next rows of a picture of `height` rows, from the top. The first call makes the file, with
   * the image's field data; the last one, which brings the rows to `height`, completes it. All
   * images have the same arrays and width; all calls have the same height and file name. Returns 1,
   * or 0 after an error or an abort, which ends the picture.
   */
  virtual int WriteRows(vtkImageData* image, int lowest, int count, int height);

  /** The errno of a failed system call in the last Write(), such as ENOSPC; otherwise 0. */
  vtkGetMacro(SystemError, int);

protected:
  vtkRelievoEXRWriter();
  ~vtkRelievoEXRWriter() override;

  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;

private:
  vtkRelievoEXRWriter(const vtkRelievoEXRWriter&) = delete;
  void operator=(const vtkRelievoEXRWriter&) = delete;

  bool AcceptAttribute(const char* name);
  void TryRows(vtkImageData* image, int lowest, int count, int height);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkRelievoParameterList Parameters;
  char* FileName = nullptr;
  int Compression = ZIP;
  double DWALevel = 45;
  int NumberOfThreads = 0;
  int SystemError = 0;
};

#endif
