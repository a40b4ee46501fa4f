// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRelievoImageReader
 * @brief   Reads an image file of any format accepted for maps, textures and environments.
 *
 * PNG, JPEG, TIFF, BMP, Radiance (hdr) and OpenEXR are detected by their first bytes, TGA by its
 * name or its end. The output has one slice, row 0 at the bottom, and the numbers of the file:
 * unsigned char for up to 8 bits, unsigned short for 16, float for others; 1 component (grey), 2
 * (grey and alpha), 3 (RGB) or 4 (RGBA). Palettes become RGB or RGBA, CMYK becomes RGB. TIFF is
 * turned by its orientation; EXIF's in JPEG is not applied. OpenEXR gives the picture of the
 * display window, 0 where there are no data, from the channels R G B [A], r g b [a], Y [A] (grey)
 * or else those of the first layer, of the first part.
 *
 * Damaged files, and images of more than 2^28 texels or 2 GiB, are refused before memory is
 * allocated for them: one error names the file and the problem, the output is empty, and
 * GetErrorCode() is vtkErrorCode::FileFormatError.
 *
 * @sa vtkRelievoEXRReader
 */
#ifndef vtkRelievoImageReader_h
#define vtkRelievoImageReader_h

#include "vtkRelievoIOModule.h" // for the export macro

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for the image

#include <string> // for extensions

class VTKRELIEVOIO_EXPORT vtkRelievoImageReader : public vtkImageAlgorithm
{
public:
  static vtkRelievoImageReader* New();
  vtkTypeMacro(vtkRelievoImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The extensions of supported files, separated by blanks. */
  static std::string GetExtensions();

  ///@{
  /** Name of the file to read. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Whether the output is colours for a vtkTexture, which maps all types but unsigned char through
   * a table of colours: 16 bits are rounded to 8, floats (linear light) clamped to 0 to 1 and
   * encoded by the sRGB curve. Default off.
   */
  vtkSetMacro(Colors, bool);
  vtkGetMacro(Colors, bool);
  vtkBooleanMacro(Colors, bool);
  ///@}

protected:
  vtkRelievoImageReader();
  ~vtkRelievoImageReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkRelievoImageReader(const vtkRelievoImageReader&) = delete;
  void operator=(const vtkRelievoImageReader&) = delete;

  vtkImageData* GetImage();

  char* FileName = nullptr;
  bool Colors = false;
  vtkSmartPointer<vtkImageData> Image; // of the file
  vtkMTimeType ImageTime = 0;          // the reader's time at reading
};

#endif
