// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironment
 * @brief The light that comes from all around, for materials to mirror and skyboxes to show.
 *
 * It holds images of linear light and turns them; vtkRelievoMaterial::SetEnvironment and
 * vtkRelievoSkybox::SetEnvironment take it, any number of them the same one, in any windows.
 *
 * Which direction is where in an image is told in shaders/formulas/environment.glsl, for all of
 * Relievo: axes right-handed, +y up; the middle of an equirectangular image looks along +x, +z is a
 * quarter to its right; cubes are looked up by OpenGL's samplerCube as they are; the middle of a
 * sphere map holds +z. vtkRelievoEnvironmentConvert turns other images into these.
 *
 * Cubes are read over their edges without a seam. One component is grey; of four the fourth is left
 * out. NaN counts as 0, infinity as 65504. Textures are halves if no value is above 65504, else
 * floats. An image that is larger than OpenGL allows is reduced, with a warning; one that is of
 * another shape than expected gives an error, once, and what uses it is drawn as without it.
 */
#ifndef vtkRelievoEnvironment_h
#define vtkRelievoEnvironment_h

#include "vtkObject.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro

#include <memory> // for the textures

class vtkDataArray;
class vtkImageData;
class vtkMatrix3x3;
class vtkMultiBlockDataSet;
class vtkRelievoEnvironmentTextures;
class vtkWindow;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoEnvironment : public vtkObject
{
public:
  static vtkRelievoEnvironment* New();
  vtkTypeMacro(vtkRelievoEnvironment, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ProjectionType
  {
    AUTOMATIC = 0,
    EQUIRECTANGULAR = 1,
    CUBE = 2,
    SPHERE_MAP = 3
  };

  ///@{
  /** The light by direction, the scalars of the image. nullptr (default): level 0 of the levels. */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * What the image is. AUTOMATIC (default) goes by its size: n x n x 6 is a cube, 2n x n x 1
   * equirectangular, n x n x 1 a sphere map, anything else an error.
   */
  void SetProjection(int projection);
  int GetProjection();
  ///@}

  ///@{
  /**
   * Whether the image's numbers are sRGB, as those of 8-bit pictures mostly are, and are to be made
   * linear. The levels' never are. Default off; nothing is guessed.
   */
  void SetSRGB(bool on);
  bool GetSRGB();
  vtkBooleanMacro(SRGB, bool);
  ///@}

  ///@{
  /**
   * Cubes for rough mirrors, as vtkRelievoEnvironmentPrefilter makes them: block k for roughness
   * k / (blocks - 1), each half as wide as the one before. nullptr (default): mirrors are sharp.
   */
  void SetLevels(vtkMultiBlockDataSet* levels);
  vtkMultiBlockDataSet* GetLevels();
  ///@}

  ///@{
  /**
   * The nine coefficients that tell how the environment lights a matt surface: nine tuples of
   * three, as column "radiance" of vtkRelievoEnvironmentIrradiance's table has them. nullptr
   * (default): the environment lights nothing.
   */
  void SetIrradiance(vtkDataArray* coefficients);
  vtkDataArray* GetIrradiance();
  ///@}

  ///@{
  /** Degrees by which the environment is turned about its up axis, counter-clockwise seen from
   * above: with y up and 90, what was seen along +z is seen along +x. Default 0. */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * The axis of the world that is up: 0, 1 or 2 for x, y, z; the environment's y is there. With z
   * up its x stays and its z is the world's -y; with x up its z stays and its x is the world's -y.
   * The renderer's environment axes (vtkRenderer::SetEnvironmentUp, SetEnvironmentRight) turn it as
   * they turn VTK's. Default 1: y.
   */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** Factor of all light, not negative. Default 1. */
  vtkSetClampMacro(Intensity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Intensity, double);
  ///@}

  ///@{
  /**
   * Whether colours in the picture stand for light by a power of 1 / 2.2, as those of VTK's PBR
   * shading always do: what skyboxes show and what is mirrored is so encoded, and added to other
   * colours as light. Off, light is shown as it is on all but PBR surfaces. Default off.
   */
  vtkSetMacro(GammaCorrect, bool);
  vtkGetMacro(GammaCorrect, bool);
  vtkBooleanMacro(GammaCorrect, bool);
  ///@}

  /** The rotation from the world's axes to the environment's. */
  void GetWorldToEnvironment(vtkMatrix3x3* rotation);

  /** Bytes of the textures on the GPU, of all windows. */
  vtkIdType GetBytesHeld();

  /** Frees the textures of a window; nullptr: of all. They come back when they are drawn with. */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkRelievoEnvironment();
  ~vtkRelievoEnvironment() override;

private:
  vtkRelievoEnvironment(const vtkRelievoEnvironment&) = delete;
  void operator=(const vtkRelievoEnvironment&) = delete;

  friend class vtkRelievoEnvironmentTextures;

  double Rotation = 0.0;
  int UpAxis = 1;
  double Intensity = 1.0;
  bool GammaCorrect = false;
  std::unique_ptr<vtkRelievoEnvironmentTextures> Textures;
};

#endif
