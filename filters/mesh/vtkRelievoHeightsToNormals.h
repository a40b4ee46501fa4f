// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoHeightsToNormals
 * @brief Computes a tangent-space normal map with true slopes from an image of heights.
 *
 * Input: a vtkImageData with a point array of heights of any number type (the active scalars, or
 * SetInputArrayToProcess), of which Component is used. Heights times HeightScale have the unit of
 * the image's spacing: a terrain in metres with spacing in metres gives its true slopes with
 * HeightScale 1. Each slice is a separate map.
 *
 * Output: an image of the same structure with the point array "normal" as its scalars, three
 * components: x along growing columns (texture u), y along growing rows (texture v; row 0 is the
 * lowest), z out of the surface; unit vectors of float, or codes of 8 or 16 bits (Encoding). These
 * are values, not colours: never read them through an sRGB texture.
 *
 * Slopes, by Kernel, with steps h of the spacing:
 * - central: (next - previous) / 2h, off by h^2 / 6 of the third derivative;
 * - fourth order: two neighbours on each side, off by h^4 / 30 of the fifth derivative; central
 *   where one of them is missing;
 * - Sobel: central, averaged over three rows (columns) by 1 2 1: noise from texel to texel keeps
 *   3/8 of its variance, and fine relief is blurred.
 * With n texels per wave the slope of a sine is too small by (2 pi / n)^2 / 6 of itself with
 * central, and by (2 pi / n)^4 / 30 with fourth order; Sobel adds (2 pi / m)^2 / 4 for m texels per
 * wave across.
 *
 * At a border that is not wrapped the slope is one-sided, through three texels if there are that
 * many (off by h^2 / 3 of the third derivative), and not the halved slope of a clamped texture.
 * Heights that are NaN or infinite are holes: their neighbours take the slope from the known side.
 * If that is missing as well, and in a hole between unknown neighbours, the axis is flat. A map of
 * one texel is flat.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: no such array or component; a
 * spacing of 0; a HeightScale that is not finite. An image without points gives one without points.
 */
#ifndef vtkRelievoHeightsToNormals_h
#define vtkRelievoHeightsToNormals_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoHeightsToNormals : public vtkImageAlgorithm
{
public:
  static vtkRelievoHeightsToNormals* New();
  vtkTypeMacro(vtkRelievoHeightsToNormals, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KernelType
  {
    CENTRAL = 0,
    SOBEL = 1,
    FOURTH_ORDER = 2
  };

  ///@{
  /** How slopes are computed: CENTRAL, SOBEL or FOURTH_ORDER. Default is CENTRAL. */
  vtkSetClampMacro(Kernel, int, CENTRAL, FOURTH_ORDER);
  vtkGetMacro(Kernel, int);
  void SetKernelToCentral() { this->SetKernel(CENTRAL); }
  void SetKernelToSobel() { this->SetKernel(SOBEL); }
  void SetKernelToFourthOrder() { this->SetKernel(FOURTH_ORDER); }
  ///@}

  enum EncodingType
  {
    FLOAT = 0,
    UNSIGNED_CHAR = 1,
    UNSIGNED_SHORT = 2
  };

  ///@{
  /**
   * FLOAT: unit vectors. UNSIGNED_CHAR and UNSIGNED_SHORT: each component n as the nearest code of
   * (n + 1) / 2 in 0 to 255 or 65535, which OpenGL's normalised textures decode as n = 2 c - 1. No
   * code stands for 0, so a flat area reads 0.0039 (8 bits) or 0.000015 (16 bits) in x and y, which
   * is 0.32 or 0.0012 degrees off. Default is FLOAT.
   */
  vtkSetClampMacro(Encoding, int, FLOAT, UNSIGNED_SHORT);
  vtkGetMacro(Encoding, int);
  void SetEncodingToFloat() { this->SetEncoding(FLOAT); }
  void SetEncodingToUnsignedChar() { this->SetEncoding(UNSIGNED_CHAR); }
  void SetEncodingToUnsignedShort() { this->SetEncoding(UNSIGNED_SHORT); }
  ///@}

  ///@{
  /**
   * Units of the spacing per unit of height, any finite value; a negative one turns hills into
   * pits. Default is 1.
   */
  vtkSetMacro(HeightScale, double);
  vtkGetMacro(HeightScale, double);
  ///@}

  ///@{
  /** The component of the array that holds the height, from 0. Default is 0. */
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Whether the map continues at the other side, as a repeated texture does: the first column (row)
   * follows the last one. Default is off for both.
   */
  vtkSetMacro(WrapColumns, bool);
  vtkGetMacro(WrapColumns, bool);
  vtkBooleanMacro(WrapColumns, bool);
  vtkSetMacro(WrapRows, bool);
  vtkGetMacro(WrapRows, bool);
  vtkBooleanMacro(WrapRows, bool);
  ///@}

  ///@{
  /**
   * Whether y points to lower rows, as in DirectX's normal maps. Default is off: y points to higher
   * rows, as in OpenGL and glTF.
   */
  vtkSetMacro(FlipGreen, bool);
  vtkGetMacro(FlipGreen, bool);
  vtkBooleanMacro(FlipGreen, bool);
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoHeightsToNormals();
  ~vtkRelievoHeightsToNormals() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Kernel = CENTRAL;
  int Encoding = FLOAT;
  double HeightScale = 1.;
  int Component = 0;
  bool WrapColumns = false;
  bool WrapRows = false;
  bool FlipGreen = false;
  vtkMTimeType RefusedAt = 0; // MTime of the refused settings
  vtkRelievoParameterList Parameters;

  vtkRelievoHeightsToNormals(const vtkRelievoHeightsToNormals&) = delete;
  void operator=(const vtkRelievoHeightsToNormals&) = delete;
};

#endif
