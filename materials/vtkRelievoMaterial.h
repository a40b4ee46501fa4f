// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoMaterial
 * @brief Fine structure on an actor's surface, from images: normals and relief; and what it
 * mirrors.
 *
 * Attached to any number of actors; each keeps its colours, textures, shading (Phong, flat or PBR),
 * shadows and layers. For maps their meshes need texture coordinates, which place the maps; row 0
 * of an image is at v = 0. The tangent frame comes from the mesh's tangents if its point data have
 * them (vtkPointData::GetTangents; the bitangent's side is that of v), else from screen-space
 * derivatives (C. Schueler, Followup: normal mapping without precomputed tangents, 2013), right on
 * mirrored coordinates too. Faces whose texture coordinates do not spread stay as they are.
 *
 * Maps hold values, not colours: no sRGB decoding is done. Unsigned char and short count from 0
 * to 1, all other types are taken as float values. NaN and infinities count as the least value.
 * A map that is larger than OpenGL allows is reduced, with a warning.
 *
 * Relief is seen below the mesh, which lies at the greatest height: parallax (T. Kaneko et al.,
 * Detailed shape representation with parallax mapping, 2001), steep parallax (M. McGuire, M.
 * McGuire, 2005), parallax occlusion (N. Tatarchuk, 2006), relief (F. Policarpo, M. Oliveira, J.
 * Comba, Real-time relief mapping on arbitrary polygonal surfaces, 2005).
 *
 * An actor without what a material needs is drawn as without it, with an error said once.
 */
#ifndef vtkRelievoMaterial_h
#define vtkRelievoMaterial_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro

#include <memory> // for the internals

class vtkActor;
class vtkImageData;
class vtkProp;
class vtkRelievoEnvironment;
class vtkRenderer;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoMaterial : public vtkOpenGLRenderPass
{
public:
  static vtkRelievoMaterial* New();
  vtkTypeMacro(vtkRelievoMaterial, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Puts the material on an actor, and takes it off again: the actor is drawn as before. An actor
   * has one material at most: another one attached takes its place.
   */
  void Attach(vtkActor* actor);
  void Detach(vtkActor* actor);
  ///@}

  /** The material of a prop, or nullptr. */
  static vtkRelievoMaterial* Get(vtkProp* prop);

  ///@{
  /** Whether the material is seen on its actors. Default on. */
  void SetEnabled(bool enabled);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  ///@{
  /**
   * Tangent-space normals, 3 or 4 components: x along u, y along v, z out of the surface; integers
   * count 0 to 1 for -1 to 1, floats as they are. nullptr (default): none, or those of the heights.
   */
  void SetNormalMap(vtkImageData* image);
  vtkImageData* GetNormalMap();
  ///@}

  ///@{
  /** Factor of the mapped normal's x and y: 0 is flat. Default 1. */
  vtkSetMacro(NormalStrength, double);
  vtkGetMacro(NormalStrength, double);
  ///@}

  ///@{
  /** For maps whose green counts downwards, as DirectX has it. Default off: OpenGL's. */
  vtkSetMacro(FlipGreen, bool);
  vtkGetMacro(FlipGreen, bool);
  vtkBooleanMacro(FlipGreen, bool);
  ///@}

  ///@{
  /** Heights, in the first component. nullptr (default): no relief. */
  void SetHeightMap(vtkImageData* image);
  vtkImageData* GetHeightMap();
  ///@}

  ///@{
  /**
   * Values of the ground and of the mesh's level. Default (0, 0): 0 and 1 for integers, the least
   * and the greatest value for floats.
   */
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /** Depth of the ground below the mesh, in its units; scales with the actor. Default 0.1. */
  vtkSetClampMacro(HeightScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(HeightScale, double);
  ///@}

  enum Methods
  {
    METHOD_OFF = 0,
    METHOD_PARALLAX = 1,
    METHOD_STEEP = 2,
    METHOD_OCCLUSION = 3,
    METHOD_RELIEF = 4
  };

  ///@{
  /**
   * How the relief is found: METHOD_PARALLAX by one look at the height, offset limited;
   * METHOD_STEEP by equal steps along the ray; METHOD_OCCLUSION with a straight line between the
   * last two of them; METHOD_RELIEF (default) with bisections and that line. METHOD_OFF moves
   * nothing: the heights give the normals, if no normal map does.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Steps along a ray: as many per texel of the heights that it passes over, so that grazing rays
   * take more; at least and at most so many. Thinner features than a step may be missed. Defaults
   * 0.5 per texel, 8, 256.
   */
  vtkSetClampMacro(StepsPerTexel, double, 0.01, 16.0);
  vtkGetMacro(StepsPerTexel, double);
  vtkSetClampMacro(MinimumSteps, int, 1, 4096);
  vtkGetMacro(MinimumSteps, int);
  vtkSetClampMacro(MaximumSteps, int, 1, 4096);
  vtkGetMacro(MaximumSteps, int);
  ///@}

  ///@{
  /** Bisections of METHOD_RELIEF, 0 to 32. Default 6. */
  vtkSetClampMacro(Bisections, int, 0, 32);
  vtkGetMacro(Bisections, int);
  ///@}

  ///@{
  /** Whether the relief blocks light from itself. Default off: one more ray for every light. */
  void SetSelfShadow(bool on);
  vtkGetMacro(SelfShadow, bool);
  vtkBooleanMacro(SelfShadow, bool);
  ///@}

  ///@{
  /**
   * Whether depth follows the relief: intersections with other geometry and the layers depth,
   * range and position. Default off.
   */
  void SetDepthCorrection(bool on);
  vtkGetMacro(DepthCorrection, bool);
  vtkBooleanMacro(DepthCorrection, bool);
  ///@}

  ///@{
  /**
   * Whether nothing is drawn where a ray leaves the texture, [0, 1] in u and v: the silhouette of
   * a single tile. Default off.
   */
  void SetClipAtBorders(bool on);
  vtkGetMacro(ClipAtBorders, bool);
  vtkBooleanMacro(ClipAtBorders, bool);
  ///@}

  ///@{
  /** Tiles for each unit of the texture coordinates, and where they begin. Defaults 1, 0. */
  vtkSetVector2Macro(TextureScale, double);
  vtkGetVector2Macro(TextureScale, double);
  vtkSetVector2Macro(TextureOffset, double);
  vtkGetVector2Macro(TextureOffset, double);
  ///@}

  ///@{
  /** Whether maps repeat beyond [0, 1], or stay as at their rim. Default on. */
  vtkSetMacro(Repeat, bool);
  vtkGetMacro(Repeat, bool);
  vtkBooleanMacro(Repeat, bool);
  ///@}

  ///@{
  /**
   * What is all around: mirrored about the (mapped) normal, and the light of its irradiance. Needs
   * no texture coordinates; only what VTK lights has normals to mirror about, so an actor with
   * lighting off, or in a renderer without lights, shows none. nullptr (default): none.
   */
  void SetEnvironment(vtkRelievoEnvironment* environment);
  vtkRelievoEnvironment* GetEnvironment();
  ///@}

  ///@{
  /**
   * Share of the light that is mirrored where it is looked at straight from above, 0 to 1; all of
   * it at grazing angles (C. Schlick, An inexpensive BRDF model for physically-based rendering,
   * 1994), but for rough surfaces, 1 - Roughness (S. Lagarde, Adopting a physically based shading
   * model, 2011). The rest is what the surface shows otherwise; of a translucent one, also what is
   * behind. Default 0.04: of glass, plastic, paint. As far as a PBR surface is a metal (Metallic of
   * its vtkProperty) its own colour takes this share's place, and tints what is mirrored.
   */
  vtkSetClampMacro(Reflectivity, double, 0.0, 1.0);
  vtkGetMacro(Reflectivity, double);
  ///@}

  ///@{
  /**
   * Roughness of the mirror, 0 to 1, by the environment's levels; without these it is sharp. Not
   * the roughness of VTK's PBR shading, which is for its lights. Default 0.
   */
  vtkSetClampMacro(Roughness, double, 0.0, 1.0);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /** Factors of the mirrored share, 0 to 1, and of the irradiance, not negative. Default 1. */
  vtkSetClampMacro(ReflectionWeight, double, 0.0, 1.0);
  vtkGetMacro(ReflectionWeight, double);
  vtkSetClampMacro(IrradianceWeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(IrradianceWeight, double);
  ///@}

  /**
   * Gives back the texture units of the material that was drawn last, as the next one that is drawn
   * does. For applications whose windows share their OpenGL state: after each picture.
   */
  static void ReleaseTextureUnits();

  /** Bytes of the maps' textures on the GPU; the environment counts its own. */
  vtkIdType GetBytesHeld();

  /** Draws nothing: VTK's mappers call the rest. */
  void Render(const vtkRenderState* s) override;

  ///@{
  /** Called by VTK's mappers. */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoMaterial();
  ~vtkRelievoMaterial() override;

  bool Enabled = true;
  double NormalStrength = 1.0;
  bool FlipGreen = false;
  double HeightRange[2] = { 0.0, 0.0 };
  double HeightScale = 0.1;
  int Method = METHOD_RELIEF;
  double StepsPerTexel = 0.5;
  int MinimumSteps = 8;
  int MaximumSteps = 256;
  int Bisections = 6;
  bool SelfShadow = false;
  bool DepthCorrection = false;
  bool ClipAtBorders = false;
  double TextureScale[2] = { 1.0, 1.0 };
  double TextureOffset[2] = { 0.0, 0.0 };
  bool Repeat = true;
  double Reflectivity = 0.04;
  double Roughness = 0.0;
  double ReflectionWeight = 1.0;
  double IrradianceWeight = 1.0;

private:
  vtkRelievoMaterial(const vtkRelievoMaterial&) = delete;
  void operator=(const vtkRelievoMaterial&) = delete;

  void Restructure();
  vtkRenderer* FindRenderer(vtkProp* prop);
  void SetMapParameters(vtkShaderProgram* program, vtkActor* actor);
  void SetHeightParameters(vtkShaderProgram* program, vtkActor* actor);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
