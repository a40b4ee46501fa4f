// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironmentConvert
 * @brief Turns an environment image into another projection: equirectangular, cube, sphere map.
 *
 * Input: a vtkImageData whose point array (the active scalars, or SetInputArrayToProcess) is the
 * light that comes from each direction: red, green, blue (a fourth component is left out), or one
 * component of grey. Integers are fractions of their type's largest number. NaN counts as 0,
 * infinity as 65504, the largest half. vtkHDRReader, vtkRelievoEXRReader and VTK's readers of
 * pictures give such images, row 0 at the bottom.
 *
 * Output: an image of floats, three components, point array "radiance" as its scalars, origin 0,
 * spacing 1: equirectangular 2n x n x 1, sphere map n x n x 1, or a cube n x n x 6, whose slices
 * are the faces +x -x +y -y +z -z as they are given to OpenGL: point (i, j) of a slice is the texel
 * at s = (i + 0.5) / n, t = (j + 0.5) / n, so row 0 of the four side faces is the highest one. What
 * of a sphere map lies outside of its circle is 0.
 *
 * Which direction is where is told in shaders/formulas/environment.glsl, for all of Relievo: axes
 * right-handed, +y up; the middle of an equirectangular image looks along +x, +z is a quarter to
 * its right; cubes are looked up by OpenGL's samplerCube as they are; the middle of a sphere map
 * holds +z.
 *
 * Each texel is the mean of the light over its solid angle. An input that is four times as fine
 * is first halved, as often as that holds and its sizes are even, each texel becoming the mean of
 * four over their solid angles. Then it is read bilinearly, over seams, poles and edges, by a grid
 * of samples weighted by their solid angles: SamplesPerTexel to the input's texel, 2 x 2 to 64 x 64
 * to the output's. So the light of a single strong texel arrives wherever it falls; only in the
 * row about a pole reading bilinearly is itself another sum, by up to 10 %. An image that has the
 * output's shape already is copied.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: no such array; an image that is
 * not of the input projection's shape. An image without points gives one without points.
 */
#ifndef vtkRelievoEnvironmentConvert_h
#define vtkRelievoEnvironmentConvert_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

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
   * What the input is. AUTOMATIC goes by its size: n x n x 6 is a cube, 2n x n x 1 equirectangular,
   * n x n x 1 a sphere map, anything else an error. Default is AUTOMATIC.
   */
  vtkSetClampMacro(InputProjection, int, AUTOMATIC, SPHERE_MAP);
  vtkGetMacro(InputProjection, int);
  ///@}

  ///@{
  /** What the output is: EQUIRECTANGULAR, CUBE or SPHERE_MAP. Default is CUBE. */
  vtkSetClampMacro(OutputProjection, int, EQUIRECTANGULAR, SPHERE_MAP);
  vtkGetMacro(OutputProjection, int);
  void SetOutputProjectionToEquirectangular() { this->SetOutputProjection(EQUIRECTANGULAR); }
  void SetOutputProjectionToCube() { this->SetOutputProjection(CUBE); }
  void SetOutputProjectionToSphereMap() { this->SetOutputProjection(SPHERE_MAP); }
  ///@}

  ///@{
  /**
   * Texels: height of an equirectangular image (it is twice as wide), width of a cube's face or of
   * a sphere map. 0 keeps the input's detail: a cube of n goes with heights of 2n and sphere maps
   * of 3n. Default is 0.
   */
  vtkSetClampMacro(OutputSize, int, 0, 32768);
  vtkGetMacro(OutputSize, int);
  ///@}

  ///@{
  /**
   * Whether the input's numbers are sRGB (as those of 8-bit pictures mostly are) and are to be made
   * linear, as all that Relievo computes with is. Default is off; nothing is guessed.
   */
  vtkSetMacro(InputSRGB, bool);
  vtkGetMacro(InputSRGB, bool);
  vtkBooleanMacro(InputSRGB, bool);
  ///@}

  ///@{
  /**
   * Whether input, or output, is mirrored: the light of (x, y, z) is where that of (x, y, -z) would
   * be. So are cubes of six pictures taken from inside, which vtkSkybox and VTK's lighting expect
   * since VTK 9.2; vtkSkybox of 9.1 takes cubes as they are. Default is off.
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
   * Samples across a texel of the input, in both ways: how much of a single strong texel's light
   * may be lost or added, 5 % with 2, 2 % with 4, and four times the time. Default is 2; 1 to 16.
   */
  vtkSetClampMacro(SamplesPerTexel, int, 1, 16);
  vtkGetMacro(SamplesPerTexel, int);
  ///@}

protected:
  vtkRelievoEnvironmentConvert() = default;
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

  vtkRelievoEnvironmentConvert(const vtkRelievoEnvironmentConvert&) = delete;
  void operator=(const vtkRelievoEnvironmentConvert&) = delete;
};

#endif
