// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironment
 * @brief Light that arrives from all directions, reflected by materials and shown by skyboxes.
 *
 * An environment stores images of linear light and their orientation. Any number of materials and
 * skyboxes, in any number of windows, can share one (vtkRelievoMaterial::SetEnvironment,
 * vtkRelievoSkybox::SetEnvironment).
 *
 * shaders/formulas/light/environment.glsl defines the directions for all of Relievo: axes are
 * right-handed with +y up; the centre of an equirectangular image is in direction +x, and +z is a
 * quarter of the width to its right; cubes have the layout of OpenGL's samplerCube; the centre of a
 * sphere map is in direction +z. vtkRelievoEnvironmentConvert converts other images.
 *
 * Cubes are filtered across their edges without a seam. One component is grey; a fourth component
 * is ignored. NaN is replaced by 0 and infinity by 65504. Textures are half floats if no value
 * exceeds 65504, otherwise floats. An image larger than OpenGL allows is reduced, with a warning;
 * an image of an unexpected shape causes one error and is not used.
 */
#ifndef vtkRelievoEnvironment_h
#define vtkRelievoEnvironment_h

#include "vtkObject.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro
#include "vtkRelievoParameterList.h"   // for the description
#include "vtkRelievoText.h"            // for names that are given

#include <memory> // for the textures
#include <string> // for names

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
  /** The light by direction: the scalars of the image. nullptr (default) uses level 0 of Levels. */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /**
   * The image's projection. AUTOMATIC (default) depends on its size: n x n x 6 is a cube, 2n x n x
   * 1 equirectangular, n x n x 1 a sphere map, and any other size an error.
   */
  void SetProjection(int projection);
  int GetProjection();
  ///@}

  ///@{
  /**
   * Whether the image's values are sRGB, as in most 8-bit pictures, and need decoding to linear
   * light. The values of levels are always linear. Default off; nothing is guessed.
   */
  void SetSRGB(bool on);
  bool GetSRGB();
  vtkBooleanMacro(SRGB, bool);
  ///@}

  ///@{
  /**
   * Cubes for rough mirrors, made by vtkRelievoEnvironmentPrefilter: block k for roughness k /
   * (blocks - 1), each half as wide as the one before. nullptr (default): mirrors are sharp.
   */
  void SetLevels(vtkMultiBlockDataSet* levels);
  vtkMultiBlockDataSet* GetLevels();
  ///@}

  ///@{
  /**
   * The nine coefficients by which the environment lights diffuse surfaces: nine tuples of three,
   * the column "radiance" of vtkRelievoEnvironmentIrradiance's table. nullptr (default): the
   * environment lights nothing.
   */
  void SetIrradiance(vtkDataArray* coefficients);
  vtkDataArray* GetIrradiance();
  ///@}

  ///@{
  /** Rotation of the environment about its up axis in degrees, counter-clockwise seen from above:
   * with y up, a rotation by 90 turns direction +z to +x. Default 0. */
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * The world axis that is up, to which the environment's y is mapped: 0, 1 or 2 for x, y, z. With
   * z up its x is unchanged and its z is the world's -y; with x up its z is unchanged and its x is
   * the world's -y. The renderer's environment axes (vtkRenderer::SetEnvironmentUp,
   * SetEnvironmentRight) rotate it in addition, like VTK's environments. Default 1, y.
   */
  vtkSetClampMacro(UpAxis, int, 0, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /** Factor of the environment's light, 0 or more. Default 1. */
  vtkSetClampMacro(Intensity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Intensity, double);
  ///@}

  ///@{
  /**
   * Whether colours in the picture encode light by a power of 1 / 2.2, which VTK's PBR shading
   * always does. If on, skyboxes and reflected light are encoded, and added to other colours as
   * light. If off, light is shown unchanged except on PBR surfaces. Default off.
   */
  vtkSetMacro(GammaCorrect, bool);
  vtkGetMacro(GammaCorrect, bool);
  vtkBooleanMacro(GammaCorrect, bool);
  ///@}

  ///@{
  /**
   * Rotation, up axis, intensity and gamma by name, with the functions of vtkRelievoMaterial.
   * Projection and SRGB describe the images, and are not among them.
   */
  int GetNumberOfParameters() { return this->Description.GetNumber(); }
  std::string GetParameterName(int i) { return this->Description.GetName(i); }
  std::string GetParameterHelp(RELIEVO_TEXT name) { return this->Description.GetHelp(name); }
  std::string GetParameterDefault(RELIEVO_TEXT name) { return this->Description.GetDefault(name); }
  std::string GetParameter(RELIEVO_TEXT name) { return this->Description.GetValue(name); }
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
  {
    return this->Description.TrySet(name, words);
  }
  bool SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);
  ///@}

#ifndef __VTK_WRAP__
  /** The description of the parameters. */
  const vtkRelievoParameterList& GetDescription() const
  {
    return this->Description;
  }
#endif

  /** The rotation from the world's axes to the environment's. */
  void GetWorldToEnvironment(vtkMatrix3x3* rotation);

  /** Bytes of the GPU textures, in all windows. */
  vtkIdType GetBytesHeld();

  /** Frees the textures of a window, or of all with nullptr. They are made again when needed. */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkRelievoEnvironment();
  ~vtkRelievoEnvironment() override;

private:
  vtkRelievoEnvironment(const vtkRelievoEnvironment&) = delete;
  void operator=(const vtkRelievoEnvironment&) = delete;

  friend class vtkRelievoEnvironmentTextures;

  vtkRelievoParameterList Description;
  double Rotation = 0.0;
  int UpAxis = 1;
  double Intensity = 1.0;
  bool GammaCorrect = false;
  std::unique_ptr<vtkRelievoEnvironmentTextures> Textures;
};

#endif
