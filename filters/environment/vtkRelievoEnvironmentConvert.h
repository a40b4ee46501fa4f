// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironmentConvert
 * @brief Converts an environment image into another projection: equirectangular, cube, sphere map.
 *
 * Input: a vtkImageData whose point array (the active scalars, or SetInputArrayToProcess) is the
 * light that arrives from each direction: red, green, blue (a fourth component is ignored), or one
 * component of grey. Integers are fractions of their type's largest number. NaN is replaced by 0,
 * and infinity by 65504, the largest half. vtkHDRReader, vtkRelievoEXRReader and VTK's image
 * readers give such images, with row 0 at the bottom.
 *
 * Output: an image of floats, three components, point array "radiance" as its scalars, origin 0,
 * spacing 1: equirectangular 2n x n x 1, sphere map n x n x 1, or a cube n x n x 6, whose slices
 * are the faces +x -x +y -y +z -z as OpenGL takes them: point (i, j) of a slice is the texel at
 * s = (i + 0.5) / n, t = (j + 0.5) / n, so row 0 of the four side faces is the highest one. A
 * sphere map is 0 outside its circle.
 *
 * shaders/formulas/light/environment.glsl defines the directions for all of Relievo: axes are
 * right-handed with +y up; the middle of an equirectangular image is in direction +x, and +z is a
 * quarter of the width to its right; cubes are laid out as OpenGL's samplerCube reads them; the
 * middle of a sphere map is in direction +z.
 *
 * Each texel is the mean of the light over its solid angle. An input that is at least four times as
 * fine is first halved, for as long as that holds and its sizes are even; each texel becomes the
 * mean of four over their solid angles. Then it is read bilinearly, across seams, poles and edges,
 * by a grid of samples weighted by their solid angles: SamplesPerTexel per texel of the input, and
 * 2 x 2 to 64 x 64 per texel of the output. The light of a single strong texel is thus preserved
 * wherever it falls; only in the row next to a pole does bilinear reading itself give another sum,
 * by up to 10 %. An image that already has the output's shape is copied.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: no such array; an image that does
 * not have the shape of the input projection. An image without points gives one without points.
 */
#ifndef vtkRelievoEnvironmentConvert_h
#define vtkRelievoEnvironmentConvert_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoEnvironmentConvert : public vtkImageAlgorithm
{
public:
  static vtkRelievoEnvironmentConvert* New();
  vtkTypeMacro(vtkRelievoEnvironmentConvert, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ProjectionType
  {
    AUTOMATIC = 0,
    EQUIRECTANGULAR = 1,
    CUBE = 2,
    SPHERE_MAP = 3
  };

  ///@{
  /**
   * The projection of the input. AUTOMATIC is chosen by size: n x n x 6 is a cube, 2n x n x 1
   * equirectangular, n x n x 1 a sphere map; other sizes are an error. Default is AUTOMATIC.
   */
  vtkSetClampMacro(InputProjection, int, AUTOMATIC, SPHERE_MAP);
  vtkGetMacro(InputProjection, int);
  ///@}

  ///@{
  /** The projection of the output: EQUIRECTANGULAR, CUBE or SPHERE_MAP. Default is CUBE. */
  vtkSetClampMacro(OutputProjection, int, EQUIRECTANGULAR, SPHERE_MAP);
  vtkGetMacro(OutputProjection, int);
  void SetOutputProjectionToEquirectangular() { this->SetOutputProjection(EQUIRECTANGULAR); }
  void SetOutputProjectionToCube() { this->SetOutputProjection(CUBE); }
  void SetOutputProjectionToSphereMap() { this->SetOutputProjection(SPHERE_MAP); }
  ///@}

  ///@{
  /**
   * Size in texels, 0 to 32768: the height of an equirectangular image (which is twice as wide), or
   * the width of a cube's face or of a sphere map. 0 keeps the input's detail: a cube of n
   * corresponds to heights of 2n and sphere maps of 3n. Default is 0.
   */
  vtkSetClampMacro(OutputSize, int, 0, 32768);
  vtkGetMacro(OutputSize, int);
  ///@}

  ///@{
  /**
   * Whether the input's values are sRGB (as in most 8-bit pictures) and must be decoded to linear
   * light, in which Relievo computes. Default is off; it is never guessed.
   */
  vtkSetMacro(InputSRGB, bool);
  vtkGetMacro(InputSRGB, bool);
  vtkBooleanMacro(InputSRGB, bool);
  ///@}

  ///@{
  /**
   * Whether the input, or the output, is mirrored, with the light of (x, y, z) in the place of
   * (x, y, -z). Cubes of six pictures taken from inside are mirrored, and vtkSkybox and VTK's
   * lighting expect them so since VTK 9.2; vtkSkybox of 9.1 does not. Default is off.
   */
  vtkSetMacro(InputMirrored, bool);
  vtkGetMacro(InputMirrored, bool);
  vtkBooleanMacro(InputMirrored, bool);
  vtkSetMacro(OutputMirrored, bool);
  vtkGetMacro(OutputMirrored, bool);
  vtkBooleanMacro(OutputMirrored, bool);
  ///@}

  ///@{
  /**
   * Samples across a texel of the input, in both directions, 1 to 16. They limit how much of a
   * single strong texel's light is lost or added: 5 % with 2, and 2 % with 4 in four times the
   * time. Default is 2.
   */
  vtkSetClampMacro(SamplesPerTexel, int, 1, 16);
  vtkGetMacro(SamplesPerTexel, int);
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoEnvironmentConvert();
  ~vtkRelievoEnvironmentConvert() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  void GetOutputDimensions(const int input[3], int output[3]);

  int InputProjection = AUTOMATIC;
  int OutputProjection = CUBE;
  int OutputSize = 0;
  bool InputSRGB = false;
  bool InputMirrored = false;
  bool OutputMirrored = false;
  int SamplesPerTexel = 2;
  vtkMTimeType RefusedAt = 0; // MTime of the refused settings
  vtkRelievoParameterList Parameters;

  vtkRelievoEnvironmentConvert(const vtkRelievoEnvironmentConvert&) = delete;
  void operator=(const vtkRelievoEnvironmentConvert&) = delete;
};

#endif
