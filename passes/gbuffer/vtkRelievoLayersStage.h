// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLayersStage
 * @brief The stage that makes the layers: depth, normals, albedo and ids per pixel, single sample.
 *
 * The layers are written while the delegate draws its opaque geometry, into additional attachments
 * of its framebuffer; if that is impossible (a multisampled framebuffer, a delegate that uses the
 * attachments itself, far/near beyond 1e4, props that write no layers), in a separate geometry pass
 * without lighting. The frame report tells which.
 *
 * Every value is that of the pixel's centre. Surfaces, lines and points of vtkPolyDataMapper,
 * composite mappers and vtkGlyph3DMapper, and sphere and stick impostors are written; translucent
 * geometry, volumes, images, skyboxes, text and 2D actors are not.
 *
 * GPU memory: one or more unsigned integer textures, described in vtkRelievoGBufferLayout.
 */
#ifndef vtkRelievoLayersStage_h
#define vtkRelievoLayersStage_h

#include "vtkRelievoGBufferModule.h" // for the export macro
#include "vtkRelievoStage.h"

#include <functional> // for views
#include <memory>     // for the internals

class vtkCamera;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;
struct vtkRelievoFrameScene;

class VTKRELIEVOGBUFFER_EXPORT vtkRelievoLayersStage : public vtkRelievoStage
{
public:
  static vtkRelievoLayersStage* New();
  vtkTypeMacro(vtkRelievoLayersStage, vtkRelievoStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Formats of a normal. AUTO selects FLOAT32 if it costs no further attachment, otherwise OCT16.
   * Bits and largest errors: 96 and 1e-5 degrees; 48 and 0.023; 32 and 0.0037; 32 and 0.0025; 16
   * and 0.95; 16 and 0.64; 30 and 0.097; 24 and 0.39 (docs/choosing-formats.md). Octahedral:
   * Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, JCGT 3(2),
   * 2014.
   */
  enum NormalFormats
  {
    NORMAL_AUTO = 0,
    NORMAL_FLOAT32 = 1,
    NORMAL_FLOAT16 = 2,
    NORMAL_OCT16 = 3,
    NORMAL_OCT16_PRECISE = 4,
    NORMAL_OCT8 = 5,
    NORMAL_OCT8_PRECISE = 6,
    NORMAL_RGB10A2 = 7,
    NORMAL_RGB8 = 8
  };

  /** Formats of the depth. */
  enum DepthFormats
  {
    DEPTH_32F = 0,
    DEPTH_16F = 1,
    DEPTH_WINDOW_Z24 = 2,
    DEPTH_REVERSED_32F = 3
  };

  /**
   * Normal and depth together in one texel, if both are requested: RGBA8 (0.5 n + 0.5, and (-z -
   * near) / (far - near) in alpha), RGBA16F or RGBA32F (n, -z). Default SEPARATE.
   */
  enum NormalDepthFormats
  {
    NORMAL_DEPTH_SEPARATE = 0,
    NORMAL_DEPTH_RGBA8 = 1,
    NORMAL_DEPTH_RGBA16F = 2,
    NORMAL_DEPTH_RGBA32F = 3
  };

  enum NormalSpaces
  {
    WORLD = 0,
    VIEW = 1
  };

  ///@{
  /** Format of the layers normal and geometric_normal. Default NORMAL_AUTO. */
  vtkSetClampMacro(NormalFormat, int, NORMAL_AUTO, NORMAL_RGB8);
  vtkGetMacro(NormalFormat, int);
  ///@}

  ///@{
  /**
   * Format of the layer depth, and of range and position, which depend on it. Default DEPTH_32F.
   */
  vtkSetClampMacro(DepthFormat, int, DEPTH_32F, DEPTH_REVERSED_32F);
  vtkGetMacro(DepthFormat, int);
  ///@}

  ///@{
  /**
   * The largest allowed error, in place of SetNormalFormat and SetDepthFormat: the stage selects
   * the smallest format within the tolerance, among those that do not depend on the near and far
   * planes (docs/choosing-formats.md). Normals in degrees, 1e-5 to 180; depth as a share of the
   * depth, 6e-8 to 1. 0 (default): the format that is set. Other values are an error, and nothing
   * is set. With a tolerance, normal and depth do not share a texel, whatever SetNormalDepthFormat
   * says.
   */
  void SetNormalTolerance(double degrees);
  vtkGetMacro(NormalTolerance, double);
  int GetNormalFormatUsed();
  void SetDepthTolerance(double share);
  vtkGetMacro(DepthTolerance, double);
  int GetDepthFormatUsed();
  ///@}

  ///@{
  /** Whether normal and depth share a texel. Default NORMAL_DEPTH_SEPARATE. */
  vtkSetClampMacro(NormalDepthFormat, int, NORMAL_DEPTH_SEPARATE, NORMAL_DEPTH_RGBA32F);
  vtkGetMacro(NormalDepthFormat, int);
  ///@}

  ///@{
  /** Space of the normals that are read: WORLD (default) or VIEW (eye space). */
  vtkSetClampMacro(NormalSpace, int, WORLD, VIEW);
  vtkGetMacro(NormalSpace, int);
  ///@}

  ///@{
  /**
   * Whether the layers may be written in the delegate's own geometry pass. Default on; off always
   * draws a separate pass.
   */
  vtkSetMacro(ShareGeometryPass, bool);
  vtkGetMacro(ShareGeometryPass, bool);
  vtkBooleanMacro(ShareGeometryPass, bool);
  ///@}

  ///@{
  /**
   * Whether depth, range and position are refined when they are read: for a triangle of a mesh, the
   * depth is computed from its corners in double, without the rasteriser's rounding. Costs the id
   * word. Default on; only for separate DEPTH_32F, and not for actors with their own shader code.
   */
  vtkSetMacro(RefineDepth, bool);
  vtkGetMacro(RefineDepth, bool);
  vtkBooleanMacro(RefineDepth, bool);
  ///@}

  vtkIdType GetBytesHeld() override;

  /** Width and height of the layers of the last frame, in pixels. */
  void GetSize(int size[2]);

  /** Whether the last frame wrote the layers in the delegate's geometry pass. */
  vtkGetMacro(Shared, bool);

  /** Whether the layers of the last frame are available for reading. */
  bool GetHoldsLayers();

#ifndef __VTK_WRAP__
  /** Reads layers of the last frame: see vtkRelievoStage::ReadLayers. */
  std::string ReadLayers(const std::vector<std::string>& names, vtkImageData* image) override;

  /**
   * Draws the layers of the last frame again, for other cameras of the same renderer, without a
   * frame for each, and calls `take` with the number of each camera and its layers, which equal
   * those of a frame bit for bit. False if each camera needs a frame of its own: the last one drew
   * a picture, or layers that depend on more than the surfaces and the camera.
   */
  bool DrawViews(vtkRenderer* renderer, const std::vector<vtkCamera*>& cameras,
    const std::vector<std::string>& names,
    const std::function<void(std::size_t, vtkImageData*)>& take);
#endif

  /**
   * Source of a pixel's primitive number in the last frame, which cell ids and refined depths need:
   * "as written" (by the fragment shader alone), "through a geometry shader", or "unreliable: ..."
   * if this OpenGL gives wrong ones; empty if no layer needed it.
   */
  std::string GetPrimitiveIds();

  /**
   * Tests a window's OpenGL for the source of primitive numbers, returned in GetPrimitiveIds'
   * words, by drawing a few triangles in the first call. The window must be initialized, and
   * becomes current.
   */
  static std::string ProbePrimitiveIds(vtkOpenGLRenderWindow* window);

  std::map<std::string, vtkVariant> GetFacts() override;

  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRelievoLayersStage();
  ~vtkRelievoLayersStage() override;

#ifndef __VTK_WRAP__
  bool IsSplicing() const override;
  void MarkShaders(const vtkRelievoShaderTexts& shaders) override;
  void SpliceShaders(const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper,
    vtkActor* actor) override;
#endif
  void Describe(vtkRelievoStageDescription& description) override;
  std::vector<vtkRelievoResourceName> GetReadsFor(
    const vtkRelievoFrameContext& context, const std::vector<std::string>& asked) const override;
  bool Prepare(vtkRelievoFrameContext& context) override;
  void BeginOpaque(vtkRelievoFrameContext& context) override;
  void EndOpaque(vtkRelievoFrameContext& context) override;
  void Execute(vtkRelievoFrameContext& context) override;

  int NormalFormat = NORMAL_AUTO;
  int DepthFormat = DEPTH_32F;
  double NormalTolerance = 0.0;
  double DepthTolerance = 0.0;
  int NormalDepthFormat = NORMAL_DEPTH_SEPARATE;
  int NormalSpace = WORLD;
  bool ShareGeometryPass = true;
  bool RefineDepth = true;
  bool Shared = false;

private:
  vtkRelievoLayersStage(const vtkRelievoLayersStage&) = delete;
  void operator=(const vtkRelievoLayersStage&) = delete;

  bool CanRepeat(const vtkRelievoFrameScene& scene, vtkRenderer* renderer) const;
  void DrawOwnPass(vtkRelievoFrameContext& context);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
