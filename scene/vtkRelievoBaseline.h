// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoBaseline
 * @brief Captures a renderer's frame as a baseline for vtkRelievoFrameComparison.
 *
 * Capture() draws the renderer unchanged and fills an image: the picture (`color`), the layers that
 * identify causes, and field data with the record.
 *
 * Layers: depth, normal, albedo, actor, block, cell; shadows of lights, if the picture shows any;
 * light, fog, ambient, marker and blend, if the frame's stages made them; and the arrays that
 * colour actors.
 *
 * A portable baseline takes depth, normal, actor, block, cell and arrays from rays in double
 * (vtkRelievoRayLayers) instead of OpenGL: these layers are equal on all processors and drivers.
 *
 * Record, in addition to the camera and the lights of every capture (vtkRelievoLayerSource):
 * - baseline_version (int): the format, 2.
 * - portable (int): 1, in a portable baseline.
 * - objects (one JSON string for each of vtkRenderer::GetActors()): name, visible, translucent,
 *   matrix, points and cells (counts and check sums of the mesh), center and bounds in world
 *   coordinates, spread (the covariance of the points), color (of actors that no array colours),
 *   clipping (origin and normal of each clipping plane), normal_map (whether there is one),
 *   normal_map_sum (its check sum), settings (of the vtkProperty; ambient_color and specular_color
 *   are null if they equal the diffuse colour).
 * - volumes (JSON strings): visible, matrix, bounds, clipping, and check sums of the data with its
 *   points (data), of the transfer functions and material (functions), and of gradient_opacity.
 * - overlays (JSON strings): visible texts, bars and other 2D actors.
 * - settings (strings NAME=VALUE): background, samples per pixel, and the parameters of the stages
 *   that ran.
 * - versions (strings): Relievo, VTK and OpenGL.
 *
 * In tests of C++ programs, Test() compares a window with a baseline:
 *
 *     return vtkRelievoBaseline::Test(window, "baselines/wheel.exr") ? 0 : 1;
 *
 * Errors: as for vtkRelievoLayerSource; a portable baseline of actors that rays do not hit, such as
 * wireframes, points and lines (vtkRelievoRayScene).
 */
#ifndef vtkRelievoBaseline_h
#define vtkRelievoBaseline_h

#include "vtkObject.h"
#include "vtkRelievoSceneModule.h" // for the export macro
#include "vtkRelievoText.h"        // for names
#include "vtkSmartPointer.h"       // for the renderer

#include <map>    // for names
#include <string> // for names
#include <vector> // for layers

class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;

class VTKRELIEVOSCENE_EXPORT vtkRelievoBaseline : public vtkObject
{
public:
  static vtkRelievoBaseline* New();
  vtkTypeMacro(vtkRelievoBaseline, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The renderer, which must be in a render window. Default: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The name of an actor, by its index in vtkRenderer::GetActors(). Objects are matched by name
   * first, wherever they are; unnamed objects by their meshes. Default: none.
   */
  void SetObjectName(int actor, RELIEVO_TEXT name);
  std::string GetObjectName(int actor);
  ///@}

  ///@{
  /** Whether baselines are portable. Default: no. */
  vtkSetMacro(Portable, bool);
  vtkGetMacro(Portable, bool);
  vtkBooleanMacro(Portable, bool);
  ///@}

  /**
   * Whether an image is a portable baseline. Baselines are compared with others of the same kind
   * only.
   */
  static bool IsPortable(vtkImageData* image);

  /** Draws the frame into an image. Returns false, with an error event, on failure. */
  bool Capture(vtkImageData* image);

  /**
   * Compares a window with a baseline, in place of vtkRegressionTestImage: an .exr file of this
   * class, or a picture. Draws the window's only renderer with props, and prints the table of
   * causes. If the frames differ, the current folder gets NAME.frame.exr, which can become the
   * baseline (NAME.frame.png for a baseline that is a PNG), NAME.html, a report, and both pictures,
   * which are also printed as measurements for CDash. Returns whether the frames are alike; false,
   * too, without a baseline, and after errors.
   */
  static bool Test(vtkRenderWindow* window, const char* baseline);

protected:
  vtkRelievoBaseline();
  ~vtkRelievoBaseline() override;

private:
  vtkRelievoBaseline(const vtkRelievoBaseline&) = delete;
  void operator=(const vtkRelievoBaseline&) = delete;

  bool AddRayLayers(vtkImageData* image, const std::vector<std::string>& layers);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::map<int, std::string> Names;
  bool Portable = false;
};

#endif
