// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoMaterial
 * @brief Fine structure of an actor's surface from images (normals, relief, cut-outs), and its
 * reflection of an environment.
 *
 * A material can be attached to any number of actors, which keep their colours, textures, shading
 * (Phong, flat or PBR), shadows and layers. Maps are placed by the mesh's texture coordinates; row
 * 0 of an image is at v = 0. The tangent frame comes from the mesh's tangents if its point data
 * have them (vtkPointData::GetTangents; the bitangent points along growing v), otherwise from
 * screen-space derivatives (C. Schueler, Followup: normal mapping without precomputed tangents,
 * 2013), which also support mirrored coordinates. Faces with degenerate texture coordinates are
 * unchanged.
 *
 * Maps store values, not colours, and are not decoded as sRGB. Unsigned char and short are scaled
 * to 0 to 1, all other types are used as float values. NaN and infinities are replaced by the least
 * value. A map larger than OpenGL allows is reduced, with a warning.
 *
 * Relief lies below the mesh, which is at the greatest height: parallax (T. Kaneko et al., Detailed
 * shape representation with parallax mapping, 2001), steep parallax (M. McGuire, M. McGuire, 2005),
 * parallax occlusion (N. Tatarchuk, 2006), relief (F. Policarpo, M. Oliveira, J. Comba, Real-time
 * relief mapping on arbitrary polygonal surfaces, 2005).
 *
 * Surfaces can be cut out below a cutoff in opacity (glTF 2.0, alphaMode MASK).
 *
 * An actor that lacks a requirement of the material is drawn without it, with one error.
 */
#ifndef vtkRelievoMaterial_h
#define vtkRelievoMaterial_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRelievoMaterialsModule.h" // for the export macro
#include "vtkRelievoParameterList.h"   // for the description
#include "vtkRelievoText.h"            // for names that are given

#include <memory> // for the internals
#include <string> // for names

class vtkActor;
class vtkImageData;
class vtkProp;
class vtkRelievoEnvironment;
class vtkRelievoMaterialMap;
class vtkRenderer;

class VTKRELIEVOMATERIALS_EXPORT vtkRelievoMaterial : public vtkOpenGLRenderPass
{
public:
  static vtkRelievoMaterial* New();
  vtkTypeMacro(vtkRelievoMaterial, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Attaches the material to an actor; Detach() restores the actor. An actor has at most one
   * material: attaching another one replaces it.
   */
  void Attach(vtkActor* actor);
  void Detach(vtkActor* actor);
  ///@}

  /** The material of a prop, or nullptr. */
  static vtkRelievoMaterial* Get(vtkProp* prop);

  ///@{
  /** Whether the material has an effect on its actors. Default on. */
  void SetEnabled(bool enabled);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  ///@{
  /**
   * Tangent-space normals, 3 or 4 components: x along u, y along v, z out of the surface. Integers
   * are scaled from 0 to 1 to -1 to 1; floats are used directly. The map replaces the actor's own
   * normal texture (vtkProperty::SetNormalTexture). nullptr (default): no normals, or those of the
   * heights.
   */
  void SetNormalMap(vtkImageData* image);
  vtkImageData* GetNormalMap();
  ///@}

  ///@{
  /** Factor of the mapped normal's x and y; 0 is flat. Any value. Default 1. */
  vtkSetMacro(NormalStrength, double);
  vtkGetMacro(NormalStrength, double);
  ///@}

  ///@{
  /** For maps whose green component points down, as in DirectX. Default off, as in OpenGL. */
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
   * Values at the ground and at the level of the mesh. Default (0, 0), which selects 0 and 1 for
   * integers, and the least and the greatest value for floats.
   */
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /** Depth of the ground below the mesh, in units of the mesh, 0 or more. Default 0.1. */
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
   * Method of tracing the relief. METHOD_PARALLAX samples the height once, with a limited offset;
   * METHOD_STEEP takes equal steps along the ray; METHOD_OCCLUSION adds linear interpolation
   * between the last two of them; METHOD_RELIEF (default) adds bisections before the interpolation.
   * METHOD_OFF displaces nothing: the heights only give the normals, if there is no normal map.
   */
  void SetReliefMethod(int method);
  vtkGetMacro(ReliefMethod, int);
  ///@}

  ///@{
  /**
   * Steps along a ray: their number per texel of the heights below the ray (0.01 to 16), so that
   * grazing rays take more, and the minimum and maximum number (1 to 4096). Features thinner than a
   * step may be missed. Defaults 0.5, 8 and 256.
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
  /** Whether the relief casts shadows on itself, by a ray for every light. Default off. */
  void SetSelfShadow(bool on);
  vtkGetMacro(SelfShadow, bool);
  vtkBooleanMacro(SelfShadow, bool);
  ///@}

  ///@{
  /**
   * Whether depth follows the relief, in intersections with other geometry and in the layers depth,
   * range and position. Default off.
   */
  void SetDepthCorrection(bool on);
  vtkGetMacro(DepthCorrection, bool);
  vtkBooleanMacro(DepthCorrection, bool);
  ///@}

  ///@{
  /**
   * Whether pixels are discarded where a ray leaves the texture, [0, 1] in u and v, which gives a
   * single tile its silhouette. Default off.
   */
  void SetClipAtBorders(bool on);
  vtkGetMacro(ClipAtBorders, bool);
  vtkBooleanMacro(ClipAtBorders, bool);
  ///@}

  ///@{
  /** Tiles per unit of the texture coordinates, and their offset. Defaults (1, 1) and (0, 0). */
  vtkSetVector2Macro(TextureScale, double);
  vtkGetVector2Macro(TextureScale, double);
  vtkSetVector2Macro(TextureOffset, double);
  vtkGetVector2Macro(TextureOffset, double);
  ///@}

  ///@{
  /** Whether maps repeat beyond [0, 1]; if not, their edges extend. Default on. */
  vtkSetMacro(Repeat, bool);
  vtkGetMacro(Repeat, bool);
  vtkBooleanMacro(Repeat, bool);
  ///@}

  ///@{
  /**
   * Opacity, 0 to 1, below which pixels are discarded; all others are opaque, in the picture, in
   * all layers and as a caster of shadows. The opacity is the product of those of the property, the
   * colours and the textures (vtkActor::SetTexture, albedoTex). A cutoff forces the actor to be
   * opaque (vtkActor::ForceOpaque). Needs no texture coordinates. 0 (default): off.
   */
  void SetAlphaCutoff(double cutoff);
  vtkGetMacro(AlphaCutoff, double);
  ///@}

  ///@{
  /**
   * The environment, which is reflected about the (mapped) normal and lights by its irradiance. It
   * needs no texture coordinates, but normals, which VTK's shaders have only with lighting: an
   * actor with lighting off, or in a renderer without lights, shows none. nullptr (default): none.
   */
  void SetEnvironment(vtkRelievoEnvironment* environment);
  vtkRelievoEnvironment* GetEnvironment();
  ///@}

  ///@{
  /**
   * Share of the light reflected at normal incidence, 0 to 1. At grazing angles it rises to 1 (C.
   * Schlick, An inexpensive BRDF model for physically-based rendering, 1994), or for rough surfaces
   * to 1 - Roughness (S. Lagarde, Adopting a physically based shading model, 2011). The rest is the
   * surface's own shading, and for a translucent surface also the background behind it. Default
   * 0.04, for glass, plastic and paint. To the extent that a PBR surface is a metal (Metallic of
   * its vtkProperty), its own colour replaces this share and tints the reflection.
   */
  vtkSetClampMacro(Reflectivity, double, 0.0, 1.0);
  vtkGetMacro(Reflectivity, double);
  ///@}

  ///@{
  /**
   * Roughness of the mirror, 0 to 1, by the environment's levels; without levels it is sharp.
   * Independent of the roughness of VTK's PBR shading, which applies to lights. Default 0.
   */
  vtkSetClampMacro(Roughness, double, 0.0, 1.0);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /** Factors of the reflected share, 0 to 1, and of the irradiance, 0 or more. Default 1. */
  vtkSetClampMacro(ReflectionWeight, double, 0.0, 1.0);
  vtkGetMacro(ReflectionWeight, double);
  vtkSetClampMacro(IrradianceWeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(IrradianceWeight, double);
  ///@}

  ///@{
  /**
   * The numbers, choices and switches above by name, such as "relief_method", for the command line
   * and ParaView. Values are words: "0.5", "on", "steep", "0,1". Set returns false, with an error,
   * and changes nothing if there is no such parameter or the words are invalid; TrySet returns the
   * error message instead, "" on success. The condition lists the other parameters that an effect
   * requires, present or with a value: "height_map,relief_method!=off".
   */
  int GetNumberOfParameters() { return this->GetDescription().GetNumber(); }
  std::string GetParameterName(int i) { return this->GetDescription().GetName(i); }
  std::string GetParameterHelp(RELIEVO_TEXT name) { return this->GetDescription().GetHelp(name); }
  std::string GetParameterDefault(RELIEVO_TEXT name)
  {
    return this->GetDescription().GetDefault(name);
  }
  std::string GetParameterCondition(RELIEVO_TEXT name)
  {
    return this->GetDescription().GetCondition(name);
  }
  std::string GetParameter(RELIEVO_TEXT name) { return this->GetDescription().GetValue(name); }
  std::string TrySetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
  {
    return this->GetDescription().TrySet(name, words);
  }
  bool SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words);
  ///@}

#ifndef __VTK_WRAP__
  /** The description of the parameters. */
  const vtkRelievoParameterList& GetDescription() const;
#endif

  /**
   * Releases the texture units of the material that was drawn last, as drawing the next one does.
   * Applications whose windows share OpenGL state have to call this after each picture.
   */
  static void ReleaseTextureUnits();

  /** Bytes of the maps' GPU textures, without those of the environment. */
  vtkIdType GetBytesHeld();

  /** Draws nothing; VTK's mappers call the functions below. */
  void Render(const vtkRenderState* s) override;

#ifndef __VTK_WRAP__
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
#endif

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoMaterial();
  ~vtkRelievoMaterial() override;

  bool Enabled = true;
  double NormalStrength = 1.0;
  bool FlipGreen = false;
  double HeightRange[2] = { 0.0, 0.0 };
  double HeightScale = 0.1;
  int ReliefMethod = METHOD_RELIEF;
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
  double AlphaCutoff = 0.0;
  double Reflectivity = 0.04;
  double Roughness = 0.0;
  double ReflectionWeight = 1.0;
  double IrradianceWeight = 1.0;

private:
  vtkRelievoMaterial(const vtkRelievoMaterial&) = delete;
  void operator=(const vtkRelievoMaterial&) = delete;

  void Describe();
  void UpdateStructure();
  void Restructure();
  void TellCutoff();
  void TellFaults();
  vtkRenderer* FindRenderer(vtkProp* prop);
  void SetMapParameters(vtkShaderProgram* program, vtkActor* actor);
  bool ActivateMap(vtkShaderProgram* program, vtkRelievoMaterialMap& map, const char* sampler);
  void SetHeightParameters(vtkShaderProgram* program, vtkActor* actor, bool there);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
