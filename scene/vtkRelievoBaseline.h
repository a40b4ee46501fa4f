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
 * Record, in addition to the camera and the lights of every capture (vtkRelievoLayerSource):
 * - baseline_version (int): the format, 2.
 * - objects (one JSON string for each of vtkRenderer::GetActors()): name, visible, translucent,
 *   matrix, points and cells (counts and check sums of the mesh), center and bounds in world
 *   coordinates, spread (the covariance of the points), color (of actors that no array colours),
 *   clipping (origin and normal of each clipping plane), normal_map (whether there is one),
 *   settings (of the vtkProperty).
 * - volumes (JSON strings): visible, matrix, bounds, and check sums of the data (data) and of the
 *   transfer functions and material (functions).
 * - overlays (JSON strings): visible texts, bars and other 2D actors.
 * - settings (strings NAME=VALUE): background, samples per pixel, and the parameters of the stages
 *   that ran.
 * - versions (strings): Relievo, VTK and OpenGL.
 *
 * Errors: as for vtkRelievoLayerSource.
 */
#ifndef vtkRelievoBaseline_h
#define vtkRelievoBaseline_h

#include "vtkObject.h"
#include "vtkRelievoSceneModule.h" // for the export macro
#include "vtkRelievoText.h"        // for names
#include "vtkSmartPointer.h"       // for the renderer

#include <map>    // for names
#include <string> // for names

class vtkImageData;
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

  /** Draws the frame into an image. Returns false, with an error event, on failure. */
  bool Capture(vtkImageData* image);

protected:
  vtkRelievoBaseline();
  ~vtkRelievoBaseline() override;

private:
  vtkRelievoBaseline(const vtkRelievoBaseline&) = delete;
  void operator=(const vtkRelievoBaseline&) = delete;

  void AddRecord(vtkImageData* image);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::map<int, std::string> Names;
};

#endif
