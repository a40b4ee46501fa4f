// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoBaseline
 * @brief A renderer's frame with all that vtkRelievoFrameComparison explains differences by.
 *
 * Capture() draws the renderer as it is and fills an image: the picture (`color`), the layers that
 * causes need, and field data with the record.
 *
 * Layers: depth, normal, albedo, actor, block, cell; the shadows of lights, if the picture shows
 * any; light, fog, ambient, marker and blend, if the frame's stages made them; and the arrays by
 * which actors are coloured.
 *
 * Record, besides the camera and the lights that every capture has (vtkRelievoLayerSource):
 * - baseline_version (int): the format, 1.
 * - objects (one JSON string for each of vtkRenderer::GetActors()): name, visible, translucent,
 *   matrix, points and cells (numbers and check sums of the mesh), center and bounds in the world,
 *   spread (the covariance of the points), settings (of the property).
 * - overlays (JSON strings): texts, bars and other 2D actors that are shown.
 * - settings (strings NAME=VALUE): background, and the parameters of the stages that ran.
 * - versions (strings): of Relievo, VTK and OpenGL.
 *
 * Errors: those of vtkRelievoLayerSource.
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
   * The name of an actor, by its index in vtkRenderer::GetActors(). Objects are matched by their
   * names first, wherever they are; those without a name by their meshes. Default: none.
   */
  void SetObjectName(int actor, RELIEVO_TEXT name);
  std::string GetObjectName(int actor);
  ///@}

  /** Draws the frame into an image. False, with an error event, if it cannot be drawn. */
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
