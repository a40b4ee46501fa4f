// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoShadowPass
 * @brief Shadows of every light that VTK has, in VTK's own light code.
 *
 * A stage of the frame: before the delegate draws, the depth seen from each casting light is drawn
 * into a map; while it draws, each light's colour is taken down by its visibility wherever VTK's
 * shaders read it. Phong, flat and PBR, textures, colour maps, glyphs, blocks and impostors keep
 * their look and lose only the light that is blocked. Maps are kept until the light, what casts, or
 * what is seen changes.
 *
 * Lights: directional, spot of any cone angle, point (positional with a cone angle of 90 degrees
 * and more). A light at the eye hides its own shadows and is left out; one without a direction
 * warns once. vtkLight::ShadowAttenuation (0 to 1) is each light's own strength.
 *
 * Maps are fitted to the part of the scene that the camera sees (L. Williams, Casting curved
 * shadows on curved surfaces, 1978, for the map; receiver-plane depth bias after J. Isidoro, Shadow
 * mapping: GPU-based tips and techniques, 2006; percentage-closer filtering after W. Reeves, D.
 * Salesin, R. Cook, Rendering antialiased shadows with depth maps, 1987).
 *
 * Translucent geometry receives shadows and casts none, unless asked to. Volumes, and props that
 * draw without a vtkActor's mapper, neither cast nor receive.
 */
#ifndef vtkRelievoShadowPass_h
#define vtkRelievoShadowPass_h

#include "vtkRelievoPassesModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <map>    // for layers of lights
#include <memory> // for the internals
#include <string> // for reasons
#include <vector> // for layers

class vtkLight;
class vtkMultiProcessController;
class vtkProp;
class vtkRenderer;

class VTKRELIEVOPASSES_EXPORT vtkRelievoShadowPass : public vtkRelievoStage
{
public:
  static vtkRelievoShadowPass* New();
  vtkTypeMacro(vtkRelievoShadowPass, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whether shadows are seen in the picture. Default off; layers of lights are made anyway. */
  vtkSetMacro(Visible, bool);
  vtkGetMacro(Visible, bool);
  vtkBooleanMacro(Visible, bool);
  ///@}

  enum Methods
  {
    METHOD_MAP = 0,
    METHOD_FORWARD = 1,
    METHOD_WARPED = 2
  };

  ///@{
  /**
   * How a place's light is found. METHOD_MAP (default) looks it up in the light's map.
   * METHOD_FORWARD carries the map's samples into the camera's view, as a mesh that is cut where
   * depth jumps, and compares them there, in eye space, with what is seen (H. Zhang, Forward shadow
   * mapping, 1998); its masks have the pictures' pixels, so its edges are not filtered. Translucent
   * geometry, and pictures drawn at another size than the viewport's, are looked up in the map.
   * METHOD_WARPED spends more of a sun's map where the camera is near: the map lies in the ground,
   * with rays sheared upright so that its depth is the height, and along the gaze its density has
   * the shape of the logistic function's, in up to four straight pieces, each drawn by itself, so
   * that edges stay straight. Lamps' maps are as for METHOD_MAP.
   */
  vtkSetClampMacro(Method, int, METHOD_MAP, METHOD_WARPED);
  vtkGetMacro(Method, int);
  void SetMethodToMap() { this->SetMethod(METHOD_MAP); }
  void SetMethodToForward() { this->SetMethod(METHOD_FORWARD); }
  void SetMethodToWarped() { this->SetMethod(METHOD_WARPED); }
  ///@}

  ///@{
  /**
   * Width and height of each map in texels, 16 to the OpenGL's limit; a larger one is drawn at the
   * limit, with a warning. Default 2048.
   */
  vtkSetClampMacro(MapSize, int, 16, VTK_INT_MAX);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Radius of the filter over the map in texels, 0 to 16, a quarter of the map at most: the
   * shadow's edge is that soft. 1 interpolates between the verdicts of four texels; 0 takes the
   * nearest one. Default 1.
   */
  vtkSetClampMacro(FilterRadius, int, 0, 16);
  vtkGetMacro(FilterRadius, int);
  ///@}

  ///@{
  /**
   * How far behind what the light sees a surface may lie and still be lit, in texels' widths, 0 to
   * 100. On top of the receiver's own plane, so that flat surfaces need none but for rounding.
   * Default 1.5.
   */
  vtkSetClampMacro(Bias, double, 0.0, 100.0);
  vtkGetMacro(Bias, double);
  ///@}

  ///@{
  /** Part of a blocked light that is taken away, 0 to 1. Default 1. */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /** Whether a light casts shadows. Default: every light does. */
  void SetLightCasts(vtkLight* light, bool casts);
  bool GetLightCasts(vtkLight* light);
  ///@}

  ///@{
  /**
   * What reports, warnings and layers call a light. Default, and with an empty name: "light N", N
   * its place in vtkRenderer::GetLights().
   */
  void SetLightName(vtkLight* light, const std::string& name);
  std::string GetLightName(vtkRenderer* renderer, vtkLight* light);
  ///@}

  /**
   * The layer that has a light's visibility: "shadow_" and its name in lower case, with an
   * underscore for all but letters and digits ("Key light": shadow_key_light); of several lights of
   * one name the second has "_2" behind it, and so on. Empty for a light that is not the
   * renderer's.
   * The layer shadow_N is the same of the light in place N.
   */
  std::string GetLightLayer(vtkRenderer* renderer, vtkLight* light);

  /** The layers of all lights of the renderer that can cast a shadow that is seen. */
  std::vector<std::string> GetShadowLayers(vtkRenderer* renderer);

  enum Casting
  {
    CASTS_IF_OPAQUE = -1,
    CASTS_NEVER = 0,
    CASTS_ALWAYS = 1
  };

  ///@{
  /**
   * Whether a prop of the renderer casts: its opaque geometry only (default), never, or also its
   * translucent geometry.
   */
  void SetPropCasts(vtkProp* prop, int casts);
  int GetPropCasts(vtkProp* prop);
  ///@}

  ///@{
  /** Whether a prop of the renderer receives shadows. Default true. */
  void SetPropReceives(vtkProp* prop, bool receives);
  bool GetPropReceives(vtkProp* prop);
  ///@}

  ///@{
  /**
   * The processes that draw one picture together, each its own part of the scene: every light's map
   * then holds what casts on any of them (the least depth over all, texel by texel), so that
   * casters and receivers may be anywhere. Every process must draw every frame, with the same
   * lights. Default nullptr: this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * Names a class of actors that draw their mapper as VTK's own actor does, whatever else they do:
   * plain meshes of such actors are drawn into maps without their shaders, which is faster. In
   * effect for all passes of the process.
   */
  static void AddPlainActorClass(const std::string& name);

  /** Seconds that bringing the maps together took in the last frame in which any was drawn. */
  double GetMergeSeconds();

  ///@{
  /** Of the last frame: lights that cast, maps they have, and maps that were drawn anew. */
  int GetNumberOfCastingLights();
  int GetNumberOfMaps();
  vtkGetMacro(NumberOfMapsDrawn, int);
  ///@}

  std::string GetStageName() override { return "shadows"; }
  vtkIdType GetBytesHeld() override;

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
  vtkRelievoShadowPass();
  ~vtkRelievoShadowPass() override;

  friend class vtkRelievoPass;

  bool IsNeeded(const vtkRenderState* s, std::string& reason) override;
  void RenderBefore(vtkRelievoPass* frame, const vtkRenderState* s) override;
  void RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s) override;

  /** Those of the layers that are a light's visibility, with its place among the lights. */
  std::map<std::string, int> FindLights(
    const std::vector<std::string>& layers, vtkRenderer* renderer);

  /** Whether a light's visibility is asked for as a layer in this frame. */
  void SetLayersAsked(bool asked) { this->LayersAsked = asked; }

  bool Visible = false;
  int Method = METHOD_MAP;
  int MapSize = 2048;
  int FilterRadius = 1;
  double Bias = 1.5;
  double Strength = 1.0;
  int NumberOfMapsDrawn = 0;
  bool LayersAsked = false;

private:
  vtkRelievoShadowPass(const vtkRelievoShadowPass&) = delete;
  void operator=(const vtkRelievoShadowPass&) = delete;

  void SetFrameParameters(vtkShaderProgram* program);
  void SetWarpParameters(vtkShaderProgram* program);
  void FitMaps(const vtkRenderState* s);
  void DrawMaps(const vtkRenderState* s);
  void DrawMasks(const vtkRenderState* s);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
