// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoShadowStage
 * @brief Shadows of all of VTK's lights, in VTK's own lighting code.
 *
 * A stage of the frame. Before the delegate draws, the depth seen from each casting light is drawn
 * into a map; while it draws, each light's colour is multiplied by its visibility wherever VTK's
 * shaders read it. Phong, flat and PBR, textures, colour maps, glyphs, blocks and impostors look as
 * before, without the blocked light. Maps are cached until the light, the casters or the view
 * change.
 *
 * Lights may be directional, spots of any cone angle, or points (positional with a cone angle of 90
 * degrees or more). A light at the eye hides its own shadows and is omitted, but for a
 * directional one with a size, whose soft shadows are seen; one without a direction warns once.
 * vtkLight::ShadowAttenuation (0 to 1) is the strength of a single light.
 *
 * Maps are fitted to the part of the scene that the camera sees (L. Williams, Casting curved
 * shadows on curved surfaces, 1978, for the map; receiver-plane depth bias after J. Isidoro, Shadow
 * mapping: GPU-based tips and techniques, 2006; percentage-closer filtering after W. Reeves, D.
 * Salesin, R. Cook, Rendering antialiased shadows with depth maps, 1987).
 *
 * Translucent geometry receives shadows and does not cast, unless SetPropCasts() says so. Volumes
 * (vtkVolumeMapper, images, composite blending) dim the light behind them,
 * exp(-optical depth) by VTK's definitions of opacity and unit distance, for every method; if they
 * are shaded, they receive shadows of surfaces, of other volumes and of themselves (depths in a
 * grid along the light's rays, after T. Lokovic and E. Veach, Deep shadow maps, 2000). Props that
 * draw without a vtkActor's mapper neither cast nor receive.
 */
#ifndef vtkRelievoShadowStage_h
#define vtkRelievoShadowStage_h

#include "vtkRelievoShadowsModule.h" // for the export macro
#include "vtkRelievoStage.h"
#include "vtkRelievoText.h" // for names that are given

#include <map>    // for layers of lights
#include <memory> // for the internals
#include <string> // for reasons
#include <vector> // for layers

class vtkLight;
class vtkMultiProcessController;
class vtkProp;
class vtkRelievoShadowCertificate;
class vtkRenderer;

class VTKRELIEVOSHADOWS_EXPORT vtkRelievoShadowStage : public vtkRelievoStage
{
public:
  static vtkRelievoShadowStage* New();
  vtkTypeMacro(vtkRelievoShadowStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    METHOD_MAP = 0,
    METHOD_FORWARD = 1,
    METHOD_WARPED = 2,
    METHOD_EXACT = 3
  };

  ///@{
  /**
   * How visibility from a light is computed. METHOD_MAP (default) compares with the light's depth
   * map. METHOD_FORWARD transforms the map's samples into the camera's view, as a mesh that is cut
   * where depth jumps, and compares them there, in eye space, with the surface (H. Zhang,
   * Forward shadow mapping, 1998); its masks have the picture's pixels, so its edges are not
   * filtered. Translucent geometry, and pictures of another size than the viewport, use the map.
   * METHOD_WARPED gives more of a sun's map to surfaces near the camera: the map lies in the ground
   * plane, with rays sheared upright so that its depth is the height. Along the view direction its
   * density follows the logistic function, in up to four straight pieces that are drawn separately,
   * so that edges stay straight. Lamps use maps as with METHOD_MAP.
   * METHOD_EXACT traces a ray from each pixel's own place to the light, past the triangles of the
   * casters: no texels, no bias, no filter. Translucent geometry with CASTS_ALWAYS lets 1 - opacity
   * of the light pass; the visibility is the product over the ray's hits, a transmittance. Rays
   * trace the surfaces of vtkPolyDataMapper, of composite meshes and of vtkGlyph3DMapper; other
   * casters (points, lines, wireframes, impostors, cut-out textures, clipping planes, custom
   * shaders) are drawn into maps as with METHOD_MAP, whose settings then apply. If no OpenGL buffer
   * can hold the triangles, all casters are, with a warning. With several processes (SetController)
   * each holds all triangles, or all use maps.
   */
  vtkSetClampMacro(Method, int, METHOD_MAP, METHOD_EXACT);
  vtkGetMacro(Method, int);
  void SetMethodToMap() { this->SetMethod(METHOD_MAP); }
  void SetMethodToForward() { this->SetMethod(METHOD_FORWARD); }
  void SetMethodToWarped() { this->SetMethod(METHOD_WARPED); }
  void SetMethodToExact() { this->SetMethod(METHOD_EXACT); }
  ///@}

  ///@{
  /**
   * Width and height of each map in texels, 16 to OpenGL's limit; a larger one is drawn at the
   * limit, with a warning. Default 2048.
   */
  vtkSetClampMacro(MapSize, int, 16, VTK_INT_MAX);
  vtkGetMacro(MapSize, int);
  /**
   * Side of each of up to six maps of a lamp from data (vtkRelievoLampsStage::SetCasting). Default
   * 1024.
   */
  vtkSetClampMacro(LampMapSize, int, 16, VTK_INT_MAX);
  vtkGetMacro(LampMapSize, int);
  ///@}

  ///@{
  /**
   * The most nodes along an axis of the grid, along a light's rays, of the light that volumes let
   * pass. There are no more than voxels. With a tolerance or a time budget the number is
   * chosen.
   */
  vtkSetClampMacro(VolumeNodes, int, 16, 1024);
  vtkGetMacro(VolumeNodes, int);
  ///@}

  ///@{
  /**
   * Harmonics of a Fourier series of the extinction along each ray of light through volumes, which
   * then has 2 n + 1 terms instead of nodes (0 to 31, default 0: nodes). The grids take less memory
   * and err more, most where the extinction changes steeply. Has no effect with a tolerance or a
   * time budget. After J. Jansen and L. Bavoil, Fourier opacity mapping, 2010.
   */
  vtkSetClampMacro(VolumeHarmonics, int, 0, 31);
  vtkGetMacro(VolumeHarmonics, int);
  ///@}

  ///@{
  /**
   * Goals that choose the method and the size of the maps, in place of SetMethod and SetMapSize:
   * the acceptable share of wrong verdicts among the pixels facing a light (0.0005 is 0.05 %), and
   * the milliseconds of a frame. 0 (default): no goal. An error if a value is negative, not a
   * number, or a share above 1.
   * With a tolerance, the cheapest of map and warped with 1024 to 8192 texels and exact whose
   * expected share is below it: rays on the CPU at some pixels predict the errors of each
   * (docs/shadows.md). The choice depends on scene, lights, camera and settings. With a time alone,
   * the most accurate one that is expected to fit, by the times of earlier frames. With both, the
   * tolerance takes precedence. GetPlan() names an unmet goal.
   */
  void SetTolerance(double share);
  vtkGetMacro(Tolerance, double);
  void SetTimeBudget(double milliseconds);
  vtkGetMacro(TimeBudget, double);
  ///@}

  /**
   * The expected share of wrong pixels in the last frame's view of the scene, by rays as for
   * SetTolerance; 2.5 times EstimateWrongShare if they do not apply (several processes, casters
   * that cannot be traced triangle by triangle). For METHOD_EXACT it grows with the edges that
   * these rays find, and with the distance of casters and eye; it includes ties within a pixel's
   * rounding. -1 if no frame has made shadows of lights.
   */
  double EstimateWrongShareInView(int method, int size);

  ///@{
  /**
   * For the last frame: the choice and its reason ("" without a goal), the method and map size in
   * use, the expected milliseconds, and those of the last picture, from the shadows' first work
   * until OpenGL had finished (-1 without a goal).
   */
  std::string GetPlan();
  int GetMethodUsed();
  int GetMapSizeUsed();
  double GetExpectedMilliseconds();
  double GetMillisecondsTaken();
  ///@}

  ///@{
  /**
   * Radius of the filter over the map in texels, 0 to 16, and at most a quarter of the map. It
   * sets the softness of a shadow's edge: 1 interpolates between the verdicts of four texels, 0
   * takes that of the nearest one. Default 1.
   */
  vtkSetClampMacro(FilterRadius, int, 0, 16);
  vtkGetMacro(FilterRadius, int);
  ///@}

  ///@{
  /**
   * Distance behind the surface seen by the light within which a surface is still lit, in texel
   * widths, 0 to 100. It is added to the receiver plane, so that flat surfaces need it for rounding
   * only. Default 1.5.
   */
  vtkSetClampMacro(Bias, double, 0.0, 100.0);
  vtkGetMacro(Bias, double);
  /** Share of a blocked light that is removed, 0 to 1. Default 1. */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * With METHOD_EXACT, whether translucent surfaces cast (except CASTS_NEVER) and colour the
   * transmitted light: each multiplies red, green and blue by (1 - opacity) * its diffuse colour.
   * Surfaces coloured by an array or a texture count as white. Neither layers nor maps have
   * colours. Default off.
   */
  vtkSetMacro(ColoredShadows, bool);
  vtkGetMacro(ColoredShadows, bool);
  vtkBooleanMacro(ColoredShadows, bool);
  ///@}

  ///@{
  /**
   * Soft shadows: samples of each light's shape, 0 to 4096; 0 (default) and 1: lights are points.
   * Each frame draws the shadow from another sample, as long as nothing else changes, and shows the
   * mean of the linear colour: the share of the light that is not blocked. A layer shadow_N is that
   * share. vtkRelievoFramePass::GetSamplesLeft returns the number of missing frames. Lights are
   * shaded as before: only their shadows are soft. With several processes (SetController) lights
   * stay points.
   */
  vtkSetClampMacro(SoftSamples, int, 0, 4096);
  vtkGetMacro(SoftSamples, int);
  /** Whether each frame draws all of these samples, not one. Default off. */
  vtkSetMacro(SoftAtOnce, bool);
  vtkGetMacro(SoftAtOnce, bool);
  vtkBooleanMacro(SoftAtOnce, bool);
  /**
   * Number of maps that all samples of a sun share along their rays, 0 to 64. 0 (default) draws a
   * map for each sample.
   *
   * This is for METHOD_MAP, if a frame draws all samples of its pixels at once
   * (vtkRelievoAntialiasStage) and no lamp has a size. The maps have half of MapSize. Surfaces
   * hidden from the centres of these maps cast nothing.
   */
  vtkSetClampMacro(SoftMaps, int, 0, 64);
  vtkGetMacro(SoftMaps, int);
  ///@}

  ///@{
  /** The angular diameter of directional lights, in degrees, 0 to 90; default 0.53. */
  void SetSunAngle(double degrees);
  vtkGetMacro(SunAngle, double);
  /**
   * The radius of positional lights in world units, 0 or more; default 0. A spot is a disc across
   * its direction, a point light a ball.
   */
  void SetLampRadius(double radius);
  vtkGetMacro(LampRadius, double);
  ///@}

  ///@{
  /**
   * The size of a single light: an angle if directional, a radius if positional; -1: the pass's.
   */
  void SetLightSize(vtkLight* light, double size);
  double GetLightSize(vtkLight* light);
  /**
   * Makes a positional light a parallelogram around its position, with these edges in world
   * coordinates; two edges of zero length restore it.
   */
  void SetLightEdges(vtkLight* light, const double first[3], const double second[3]);
  ///@}

  ///@{
  /** Whether a light casts shadows. Default: every light does. */
  void SetLightCasts(vtkLight* light, bool casts);
  bool GetLightCasts(vtkLight* light);
  ///@}

  ///@{
  /**
   * A light's name in reports, warnings and layers; "" (default): "light N", N being its index.
   */
  void SetLightName(vtkLight* light, RELIEVO_TEXT name);
  std::string GetLightName(vtkRenderer* renderer, vtkLight* light);
  ///@}

  /**
   * The layer of a light's visibility: "shadow_" and its name in lower case, with underscores in
   * place of everything but letters and digits ("Key light": shadow_key_light); if several lights
   * share a name, the second gets "_2", and so on. Empty for a light of another renderer. shadow_N
   * names the same layer by the light's index N.
   */
  std::string GetLightLayer(vtkRenderer* renderer, vtkLight* light);

  /** The layers of all lights of the renderer that can cast a visible shadow. */
  std::vector<std::string> GetShadowLayers(vtkRenderer* renderer);

  enum Casting
  {
    CASTS_IF_OPAQUE = -1,
    CASTS_NEVER = 0,
    CASTS_ALWAYS = 1
  };

  ///@{
  /**
   * Whether a prop of the renderer casts shadows: CASTS_IF_OPAQUE (default) with its opaque
   * geometry and volumes only (but see ColoredShadows), CASTS_NEVER, or CASTS_ALWAYS with all of
   * it.
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
   * The processes that draw one picture together, each its own part of the scene. Every light's map
   * then has the casters of all (the smallest depth, texel by texel), and METHOD_EXACT sends their
   * triangles to all, so that casters and receivers may be on different ones. Every process must
   * draw every frame, with the same lights and method. Default nullptr: this process alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * Registers a class of actors that draw their mapper like VTK's own actor. Plain meshes of such
   * actors are drawn into maps without their shaders, which is faster. Applies to all passes of the
   * process.
   */
  static void AddPlainActorClass(RELIEVO_TEXT name);

  ///@{
  /**
   * The expected cost and error of a method, before anything is drawn; -1, with an error, for an
   * unknown method or a negative number.
   *
   * Bytes: GPU memory for maps of size x size texels (one for a sun or a narrow lamp, up to six for
   * other lamps), this number of casting lights and a picture of width x height pixels.
   * METHOD_EXACT holds 16 bytes for each pixel instead, and 56 for each triangle, which are not
   * included.
   *
   * Draw calls: at most, in a frame that redraws all maps, with props of one draw call each.
   *
   * Share of wrong pixels: of those that face the light, 0 to 1. Measured on real meshes in
   * pictures of 600 x 600 pixels (docs/charts/README.md), where each scene is within a factor of
   * 2.5; scenes that extend to the horizon, and larger pictures, have more. For METHOD_EXACT it is
   * 0.00002; EstimateWrongShareInView includes dense edges, far casters and far eyes.
   */
  vtkIdType EstimateBytes(int method, int size, int maps, int lights, int width, int height);
  int EstimateDrawCalls(int method, int maps, int props);
  double EstimateWrongShare(int method, int size);
  ///@}

  /**
   * Certifies the last picture: checks this number of verdicts at random pixels against rays in
   * double precision past the casters' own triangles (vtkRelievoShadowCertificate). The picture is
   * drawn again as layers for it; the window does not change. Equal seeds give equal pixels.
   * Returns a new object each time, held until the next call. Null, with an error, if there are no
   * shadows of lights to judge, or `rays` is not positive.
   */
  vtkRelievoShadowCertificate* Certify(int rays, int seed = 0);

  /** Seconds taken to merge the maps of all processes, in the last frame that drew any. */
  double GetMergeSeconds();

  ///@{
  /** In the last frame: casting lights, their maps, and the redrawn maps. */
  int GetNumberOfCastingLights();
  int GetNumberOfMaps();
  vtkGetMacro(NumberOfMapsDrawn, int);
  ///@}

  vtkIdType GetBytesHeld() override;

#ifndef __VTK_WRAP__
  /**
   * "soft_samples", "soft_gathered": see SetSoftSamples; 1 for point lights.
   * "expected_wrong_share": see EstimateWrongShare; null if no shadows of lights were made.
   * "volume_nodes", "volume_bytes": of the grids of light through volumes, the most along an axis,
   * and all; "volume_wrong_share": the expected share of wrong places, null without a tolerance.
   * "shadow_plan", "expected_frame_ms", "frame_ms": see SetTolerance; null without a goal.
   * "lamp_maps", "lamp_maps_drawn", "lamp_maps_bytes": for lamps from data; the second were
   * redrawn.
   */
  std::map<std::string, vtkVariant> GetFacts() override;
#endif

  /** Called by VTK's mappers. */
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoShadowStage();
  ~vtkRelievoShadowStage() override;

#ifndef __VTK_WRAP__
  bool IsSplicing() const override;
  void MarkShaders(const vtkRelievoShaderTexts& shaders) override;
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;
#endif
  void Describe(vtkRelievoStageDescription& description) override;
  void Declare(
    const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;
  void Finish(vtkRelievoFrameContext& context) override;
  std::map<std::string, int> FindLights(
    const std::vector<std::string>& layers, vtkRenderer* renderer) const override;

  int Method = METHOD_MAP;
  int MapSize = 2048;
  double Tolerance = 0.0;
  double TimeBudget = 0.0;
  int LampMapSize = 1024;
  int VolumeNodes = 256;
  int VolumeHarmonics = 0;
  int FilterRadius = 1;
  double Bias = 1.5;
  double Strength = 1.0;
  bool ColoredShadows = false;
  int SoftSamples = 0;
  bool SoftAtOnce = false;
  int SoftMaps = 0;
  double SunAngle = 0.53;
  double LampRadius = 0.0;
  int NumberOfMapsDrawn = 0;

private:
  vtkRelievoShadowStage(const vtkRelievoShadowStage&) = delete;
  void operator=(const vtkRelievoShadowStage&) = delete;

  void DescribeSoft(vtkRelievoStageDescription& description);
  void CollectLights(vtkRelievoFrameContext& context);
  std::string DrawLights(vtkRelievoFrameContext& context);
  std::string DrawLamps(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
